//! The whole text of each fault of a parameter.

use super::{SLIDER, run, sweep};

fn fault(vary: &str) -> String {
    sweep(SLIDER, &[vary]).unwrap_err().to_string()
}

#[test]
fn a_key_that_names_nothing_is_told_with_what_there_is() {
    let default = "a default must be written in the scene before it can be varied";
    for (key, problem) in [
        ("lnk.crank.mass", "the scene has no `lnk`; did you mean `link`?; it has: ground, link, slide, input, force, assembly".to_owned()),
        ("link.cranck.mass", "`link` has no `cranck`; did you mean `link.crank`?; it has: crank, rod, piston".to_owned()),
        ("link.crank.mass", format!("`link.crank` has no `mass`; {default}; it has: points")),
        ("crank.A", "the scene has no `crank`; did you mean `link.crank.points.A`?; it has: ground, link, slide, input, force, assembly".to_owned()),
        ("force.gass.value", "`force` has no `gass`; did you mean `force.gas`?; it has: gas, or name an element by its number, such as `force[0]`".to_owned()),
        ("force[2].value", "`force` has 2 elements, from [0] to [1]".to_owned()),
        ("link[0].mass", "`link` is not a list; it has: crank, rod, piston".to_owned()),
        ("link.crank", "`link.crank` is a table; it has: points".to_owned()),
        ("ground.points.O", "`ground.points.O` is a list; it has: ground.points.O[0], ground.points.O[1]".to_owned()),
        ("link.piston.mass.x", "`link.piston.mass` is a single value without parts".to_owned()),
    ] {
        assert_eq!(fault(&format!("{key}=1..2:3")), format!("`{key}`: {problem}"));
    }
}

#[test]
fn a_value_of_another_kind_is_told() {
    for (vary, problem) in [
        (
            "link.piston.mass=1 m..2 m:3",
            "`link.piston.mass`: wants a mass (kg, g, t, lb, slug), got `m`, a length",
        ),
        (
            "link.piston.mass=1 kg..2 m:3",
            "`link.piston.mass`: wants a mass (kg, g, t, lb, slug), got `m`, a length",
        ),
        (
            "link.piston.mass=1 kgs..2:3",
            "`link.piston.mass`: wants a mass (kg, g, t, lb, slug), got the unknown unit `kgs`",
        ),
        ("link.piston.mass=few..2:3", "`link.piston.mass`: `few` does not begin with a finite number"),
        ("link.piston.mass=nan..2:3", "`link.piston.mass`: `nan` does not begin with a finite number"),
        ("input.positions=6 mm..12 mm:3", "`input.positions`: `input.positions` is a count, it has no unit"),
        (
            "force.gas.name=1..2:3",
            "`force.gas.name`: `force.gas.name` is a text, not a number: list texts, KEY=A,B",
        ),
    ] {
        assert_eq!(fault(vary), problem);
    }
}

#[test]
fn a_parameter_that_is_written_otherwise_is_told() {
    let form = "write it as KEY=FROM..TO:N, such as \"link.crank.mass=1 kg..5 kg:9\"";
    for (vary, problem) in [
        ("", form),
        ("link.crank.mass", form),
        ("link.crank.mass=1..2", form),
        ("link.crank.mass=1:2", form),
        ("link.crank.mass=..2:2", form),
        ("link.crank.mass=1..2:0", "N is `0`: write a whole number from 1"),
        ("link.crank.mass=1..2:-1", "N is `-1`: write a whole number from 1"),
        ("link..mass=1..2:3", "a key consists of names joined by dots, such as `link.crank.mass`"),
        (
            "link[x].mass=1..2:3",
            "`[x]` is not an element: write a whole number from 0, a range such as `[1..2]`, or `[*]` for all",
        ),
        ("link[0.mass=1..2:3", "a `[` is not closed"),
        ("link[0]mass=1..2:3", "a key continues with `.` or `[`, not `mass`"),
        ("link.'crank=1..2:3", "a quote is not closed"),
    ] {
        assert_eq!(fault(vary), format!("`{vary}`: {problem}"));
    }
}

#[test]
fn one_value_is_varied_once() {
    let error = sweep(SLIDER, &["force.gas.value=1..2:3", "force[0].value=1..2:3"]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "`force.gas.value` and `force[0].value` are the same value of the scene: vary it once"
    );
    let nothing = "nothing is varied: name a parameter, such as \"link.crank.mass=1 kg..5 kg:9\"";
    assert_eq!(sweep(SLIDER, &[]).unwrap_err().to_string(), nothing);
}

#[test]
fn quotes_hold_names_that_are_no_bare_keys() {
    let scene = SLIDER.replace("gas", "gas [left]");
    let table = run(&scene, &["force.'gas [left]'.value=1..2:2"], 1);
    assert_eq!(table.columns.names[1], "force.'gas [left]'.value_N");
}

#[test]
fn a_byte_order_mark_and_wide_characters_shift_nothing() {
    let scene = format!("\u{feff}title = \"Шатун × 2 🙂\"\n{SLIDER}");
    let plain = run(SLIDER, &["link.rod.points.B=0.3..0.5:3"], 1);
    assert_eq!(run(&scene, &["link.rod.points.B=0.3..0.5:3"], 1), plain);
}
