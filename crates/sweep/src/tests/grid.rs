//! Order, ends, units, spacing.

use super::{SLIDER, failures, numbers, run, sweep};

#[test]
fn the_last_parameter_changes_fastest() {
    let table = run(SLIDER, &["link.crank.points.A=100 mm..120 mm:2", "link.piston.mass=1 kg..3 kg:3"], 2);
    assert_eq!(table.columns.names[..3], ["row", "link.crank.points.A_m", "link.piston.mass_kg"]);
    assert_eq!(numbers(&table, "row"), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(numbers(&table, "link.crank.points.A_m"), [0.1, 0.1, 0.1, 0.12, 0.12, 0.12]);
    assert_eq!(numbers(&table, "link.piston.mass_kg"), [1.0, 2.0, 3.0, 1.0, 2.0, 3.0]);
}

#[test]
fn both_ends_are_values_and_decimal_steps_stay_decimal() {
    let lengths = |range: &str| {
        let table = run(SLIDER, &[&format!("link.crank.points.A={range}")], 1);
        numbers(&table, "link.crank.points.A_m")
    };
    assert_eq!(lengths("100 mm..140 mm:5"), [0.1, 0.11, 0.12, 0.13, 0.14]);
    assert_eq!(lengths("100..140 mm:5"), [0.1, 0.11, 0.12, 0.13, 0.14], "unit on the right only");
    assert_eq!(lengths("100 mm..140:3"), [0.1, 0.12, 0.14], "unit on the left only");
    assert_eq!(lengths("0.1..0.14:3"), [0.1, 0.12, 0.14], "SI");
    assert_eq!(lengths("10 cm .. 140 mm : 3"), [0.1, 0.12, 0.14], "two units");
    assert_eq!(lengths("140 mm..100 mm:2"), [0.14, 0.1], "downwards");
    assert_eq!(lengths("100 mm..140 mm:1"), [0.1], "one value: FROM");
}

#[test]
fn listed_values_are_taken_in_their_order() {
    let lengths = |list: &str| {
        let table = run(SLIDER, &[&format!("link.crank.points.A={list}")], 1);
        numbers(&table, "link.crank.points.A_m")
    };
    assert_eq!(lengths("125 mm,100 mm,140 mm"), [0.125, 0.1, 0.14]);
    assert_eq!(lengths("125, 100, 140 mm"), [0.125, 0.1, 0.14], "one unit is that of all");
    assert_eq!(lengths("10 cm,140 mm"), [0.1, 0.14], "two units");
    assert_eq!(lengths("0.1,0.14"), [0.1, 0.14], "SI");
    let both = run(SLIDER, &["link.crank.points.A=0.1,0.12", "link.piston.mass=1 kg..3 kg:3"], 2);
    assert_eq!(numbers(&both, "link.piston.mass_kg"), [1.0, 2.0, 3.0, 1.0, 2.0, 3.0]);
    let listed = sweep(SLIDER, &["link.crank.points.A=125 mm,100 mm"]).unwrap();
    assert_eq!(listed.ranges().collect::<Vec<_>>(), ["link.crank.points.A=125 mm,100 mm"]);
    let error = sweep(SLIDER, &["link.crank.points.A=100 mm,2 kg"]).unwrap_err().to_string();
    assert!(error.contains("kg"), "{error}");
}

#[test]
fn columns_are_named_by_what_the_scene_takes_there() {
    for (vary, name, first) in [
        ("slide[0].angle=5..10 deg:2", "slide[0].angle_rad", 5.0_f64.to_radians()),
        ("slide.piston/ground.angle=0..0.1:2", "slide.piston/ground.angle_rad", 0.0),
        ("force.gas.value=1..2 kN:2", "force.gas.value_N", 1000.0),
        ("force[1].value=-3..2:2", "force[1].value_N", -3.0),
        ("ground.points.O[1]=-1 mm..1 mm:2", "ground.points.O[1]_m", -0.001),
        ("input.positions=6..12:2", "input.positions", 6.0),
    ] {
        let table = run(SLIDER, &[vary], 1);
        assert_eq!(table.columns.names[1], name);
        approx_eq(numbers(&table, name)[0], first);
        assert_eq!(failures(&table).len(), 0, "{vary}: {:?}", table.status(0));
    }
}

fn approx_eq(found: f64, known: f64) {
    assert!((found - known).abs() <= 1e-15 * known.abs(), "{found} is not {known}");
}

#[test]
fn a_word_of_the_scene_gives_way_to_a_number() {
    let steady = "[motion]\nkind = \"steady\"\nmean_speed = 3\nunevenness = 0.05\n";
    let scene = format!("{SLIDER}{steady}[drive]\ntorque = \"balance\"\nflywheel = \"solve\"\n");
    let grid = sweep(&scene, &["drive.torque=2 kN*mm..4 N*m:3"]).unwrap();
    assert_eq!(
        [grid.describe(0).to_string(), grid.describe(2).to_string()],
        ["drive.torque = 2 N*m", "drive.torque = 4 N*m"]
    );
}

#[test]
fn the_number_of_points_has_a_limit() {
    let one = |n: &str| format!("link.piston.mass=1..2:{n}");
    let two = |n: &str| format!("force.gas.value=1..2:{n}");
    assert_eq!(sweep(SLIDER, &[&one("1000000"), &two("1000000")]).unwrap().points(), 1_000_000_000_000);
    for (first, second, points) in
        [("1000000", "1000001", "1000001000000"), ("9999999999999", "9999999999999", "too many")]
    {
        assert_eq!(
            sweep(SLIDER, &[&one(first), &two(second)]).unwrap_err().to_string(),
            format!(
                "the sweep has {points} points, at most 1000000000000 are calculated: use fewer values of each parameter"
            )
        );
    }
}
