//! Setting numbers in the mechanism does the same as reading the edited text.

use assur_analysis::plan::Plan;
use assur_fixtures::SCENES;
use assur_mechanism::Mechanism;
use assur_scene::Reading;
use assur_scene::edit::ParsedText;
use assur_structure::Structure;

use super::{SLIDER, run, sweep};
use crate::Sweep;

/// A sweep of one number of a scene, from a little less to a little more than it is.
fn around(scene: &str, key: &str, written: &str) -> Option<Sweep> {
    let (number, unit) = assur_scene::edit::split(&assur_scene::edit::bare(written).replace('_', ""))?;
    let [from, to] = [0.9, 1.1].map(|part| format!("{} {unit}", part * number));
    sweep(scene, &[&format!("{key}={from}..{to}:4")]).ok()
}

#[test]
fn every_number_of_every_scene_is_set_as_it_is_read() {
    let (mut set, mut read) = (0, Vec::new());
    for (name, scene) in SCENES.iter().filter(|(name, _)| *name != "n-four-bar-40") {
        for value in ParsedText::of(scene).values() {
            let Some(sweep) = around(scene, &value.key.to_string(), &value.written) else { continue };
            let axes = &sweep.axes;
            if !sweep.variants.sets_numbers() {
                read.push(format!("{name}: {}", value.key));
                continue;
            }
            let mut scratch = None;
            for number in [0.7, 0.2, 1.0].map(|part| axes[0].from + part * (axes[0].to - axes[0].from)) {
                let si = axes[0].si(number);
                let found = sweep.variants.mechanism(axes, &[number], &[si], scratch.take()).unwrap();
                let known = sweep.variants.read(axes, &[number]).unwrap();
                let known = Mechanism { warnings: found.warnings.clone(), ..known };
                assert_eq!(found, known, "{name}: {} = {number}", value.key);
                assert_eq!(format!("{found:?}"), format!("{known:?}"), "signs of zeros too");
                scratch = Some(found);
                set += 1;
            }
        }
    }
    assert!(set > 1000, "{set}");
    // Read as text: counts, tables and numbers that a scale is multiplied into, ends of ranges and of intervals, pairs of
    // speeds, steps; what is in the note alone; and the efficiency, because more than 1 is refused.
    let allowed = [
        ".table[",
        ".forward",
        ".back",
        "input.positions",
        "input.to",
        "input.cycle",
        "input.from",
        ".during[",
        "motion.until",
        "motion.samples",
        "motion.step",
        "motion.max_steps",
        "note.positions[",
        "note.digits",
        "sheet.",
        "_speed",
        "drive.efficiency",
    ];
    let others: Vec<_> = read.iter().filter(|key| !allowed.iter().any(|part| key.contains(part))).collect();
    assert!(others.is_empty(), "{others:#?}");
}

/// That the points of a sweep by setting numbers are those that reading the text gives, whatever was set before.
fn set_as_read(scene: &str, ranges: &[&str], sets: bool) {
    let sweep = sweep(scene, ranges).unwrap();
    assert_eq!(sweep.variants.sets_numbers(), sets, "{ranges:?}");
    let mut scratch = None;
    for index in 0..sweep.points() {
        let mut numbers = vec![0.0; ranges.len()];
        sweep.points.numbers(&sweep.axes, index, &mut numbers);
        let si: Vec<f64> = sweep.axes.iter().zip(&numbers).map(|(axis, number)| axis.si(*number)).collect();
        let found = sweep.variants.mechanism(&sweep.axes, &numbers, &si, scratch.take()).unwrap();
        let known = sweep.variants.read(&sweep.axes, &numbers).unwrap();
        assert_eq!(found, Mechanism { warnings: found.warnings.clone(), ..known }, "{ranges:?}: {numbers:?}");
        scratch = Some(found);
    }
}

#[test]
fn a_number_takes_the_place_of_a_word_or_of_the_name_of_a_point() {
    set_as_read(assur_fixtures::scene("flywheel"), &["drive.flywheel=1 kg*m^2..3 kg*m^2:3"], true);
    // The point moves alone where its name no longer stands.
    let lengths = "link.crank.points.A=80 mm..120 mm:3";
    set_as_read(SLIDER, &[lengths, "force[1].at=50 mm..70 mm:2"], true);
    set_as_read(SLIDER, &["force[1].at=50 mm..70 mm:2", "link.rod.points.A=0 mm..20 mm:3"], true);
    set_as_read(SLIDER, &["link.rod.points.A=0 mm..20 mm:3"], true);
}

#[test]
fn a_number_that_is_tied_to_others_is_read() {
    let scaled =
        |scale: &str| SLIDER.replace("value = \"1 kN\"", &format!("value = \"1 kN\"\nscale = {scale}"));
    set_as_read(&scaled("0.5"), &["force.gas.value=1 kN..2 kN:3"], false);
    set_as_read(&scaled("1"), &["force.gas.value=1 kN..2 kN:3"], true);
    let scale = "force.gas.scale=-1..2:4";
    for written in ["1", "0.5", "0"] {
        set_as_read(&scaled(written), &[scale], true);
        set_as_read(&scaled(written), &[scale, "force.gas.angle=0 deg..90 deg:2"], true);
        set_as_read(&scaled(written), &[scale, "force.gas.value=1 kN..2 kN:2"], false);
    }
    for law in [
        "{ over = \"angle\", table = [[0, 5], [1, 7]] }",
        "{ formula = \"3*sin(q)\" }",
        "{ over = \"stroke\", axis = 0.1, forward = [[0, 2], [1, 3]], back = 4 }",
    ] {
        set_as_read(&scaled("2").replace("\"1 kN\"", law), &[scale], true);
    }
    // Beyond the greatest force.
    assert!(!sweep(&scaled("1"), &["force.gas.scale=1..1e15:2"]).unwrap().variants.sets_numbers());
    set_as_read(SLIDER, &["input.positions=6..12:2"], false);
    // A rod with a mass needs a center; the piston has one point.
    let rod = SLIDER.replace("B = 0.3 }", "B = 0.3 }\nmass = 0");
    set_as_read(&rod, &["link.rod.mass=0..0:1"], false);
    set_as_read(SLIDER, &["link.piston.mass=0..3 kg:4"], true);
}

#[test]
fn a_number_of_which_a_place_is_made_is_read() {
    let crank = |points: &str| {
        let scene = SLIDER.replacen("A = \"100 mm\"", points, 1);
        assert_ne!(scene, SLIDER);
        scene
    };
    let polar = crank("A = { r = 0.1, angle = 0 }");
    set_as_read(&polar, &["link.crank.points.A.r=80 mm..120 mm:3"], false);
    set_as_read(
        &polar,
        &["link.crank.points.A.angle=-30 deg..30 deg:3", "link.piston.mass=1 kg..2 kg:2"],
        false,
    );
    let plate = crank("A = 0.1, P = { from = [\"O\", \"A\"], lengths = [0.1, 0.1] }");
    set_as_read(&plate, &["link.crank.points.P.lengths[0]=80 mm..120 mm:3"], false);
    // With the pin moves what is given by it.
    set_as_read(&plate, &["link.crank.points.A=80 mm..120 mm:3"], false);
    // A triangle that can't be closed has no row, and its gap is told.
    let open = run(&plate, &["link.crank.points.P.lengths[1]=0.1..0.3:3"], 1);
    let message = open.status(2).unwrap().1;
    assert!(message.contains("the triangle of `P` has a gap of 100 mm"), "{message}");
}

#[test]
fn structure_and_plan_fit_as_if_made_anew() {
    for (name, scene) in SCENES {
        let Reading { mut mechanism, numbers, .. } = assur_scene::reading(name, scene).unwrap();
        let mut structure = Structure::of(&mechanism).unwrap();
        let mut plan = Plan::of(&mechanism, &structure, mechanism.output.as_ref(), true);
        let same = |found: &(&Structure, &Plan), known: &(Structure, Plan)| {
            assert_eq!(format!("{found:?}"), format!("{known:?}"), "{name}");
        };
        // Every second, third, ... number becomes zero or changes; a mass or a load that is zero changes the plan.
        for step in 2_i32..9 {
            for (index, number) in numbers.iter().enumerate() {
                let value = [1.25, 0.75, 0.5][index % 3] * 1.25_f64.powi(step);
                number.set(
                    &mut mechanism,
                    if (index + 1).is_multiple_of(step.unsigned_abs() as usize) { 0.0 } else { value },
                );
            }
            structure.set_geometry(&mechanism);
            plan.fit(&mechanism, &structure);
            let known = Structure::of(&mechanism).unwrap();
            let known_plan = Plan::of(&mechanism, &known, mechanism.output.as_ref(), true);
            same(&(&structure, &plan), &(known, known_plan));
        }
    }
}

#[test]
fn what_the_reader_refuses_between_accepted_ends_is_refused() {
    // Both pins of the rod at one place, in the middle of the range.
    let table = run(SLIDER, &["link.rod.points.B=-0.3..0.3:3"], 1);
    let (_, message) = table.status(1).unwrap();
    assert!(message.starts_with("link `rod` has its pins A, B at one place"), "{message}");
    // So small a number can't be measured.
    let tiny = sweep(SLIDER, &["link.piston.mass=1e-40..1:1"]).unwrap();
    assert!(tiny.row(0).status(0).unwrap().1.contains("too small"));
}

#[test]
fn a_row_does_not_depend_on_the_rows_before_it() {
    // Positions and loads are kept where a mass alone changes: with failures among the positions, with a load over the stroke,
    // and where the geometry changes in between.
    let scene = assur_fixtures::scene;
    let cases = [
        (SLIDER, ["link.crank.points.A=50 mm..400 mm:9", "link.piston.mass=0..2 kg:3"]),
        (scene("slider-crank"), ["link.crank.points.A=50 mm..60 mm:2", "link.rod.mass=1 kg..2 kg:3"]),
        (scene("slider-crank"), ["motion.speed=600 rpm..900 rpm:2", "gravity=0..10:2"]),
        (scene("shaper"), ["link.ram.mass=20 kg..30 kg:2", "link.crank.points.A=90 mm..100 mm:2"]),
    ];
    for (scene, ranges) in cases {
        let grid = sweep(scene, &ranges).unwrap();
        let all = super::rows(&grid, 1).to_csv(false).unwrap();
        for (index, line) in all.lines().enumerate() {
            assert_eq!(grid.row(index).to_csv(false).unwrap().trim_end(), line, "{ranges:?}");
        }
    }
}
