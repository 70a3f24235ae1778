#![expect(clippy::float_cmp, reason = "bounds are rows of tables, handed on untouched")]

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;

use super::{at, bodies, compiled, fixture, near};
use crate::{Dependence, LoadState};

fn transient(name: &str) -> String {
    let text = fixture(name);
    let start = text.find("[motion]").unwrap();
    let end = start + 8 + text[start + 8..].find('[').unwrap();
    let motion = "[motion]\nkind = \"transient\"\nspeed = 5\nuntil = \"1 s\"\n\n";
    format!("{}{motion}{}", &text[..start], &text[end..])
}

proptest! {
    #[test]
    fn within_its_bounds_a_phase_is_the_live_formula(q in -9.0..9.0f64, part in 0.001..0.999f64, w in -9.0..9.0f64) {
        for name in ["shaper", "slider-crank", "conveyor"] {
            let (linkage, loads) = compiled(&transient(name));
            let mut phase = loads.phase();
            let [low, high] = loads.enter(&at(q, w), &mut phase).coordinate;
            prop_assert!(low <= q + 1e-9 && high >= q - 1e-9 && high - low < TAU);
            let inside = at(low + part * (high - low), w);
            let bodies = bodies(&linkage, inside.coordinate);
            let live = loads.reduced(&inside, &bodies);
            let frozen = loads.reduced_in_phase(&phase, &inside, &bodies);
            prop_assert!((live.moment - frozen.moment).abs() < 1e-9, "{name}: {live:?} {frozen:?}");
        }
    }
}

#[test]
fn pieces_tile_the_cycle_both_ways() {
    // Shaper: rows at 0.05 and 0.95 on the way forward, two extremes; conveyor: two rests of the trough.
    for (name, pieces) in [("shaper", 4), ("conveyor", 2)] {
        let (_, loads) = compiled(&transient(name));
        let mut phase = loads.phase();
        for speed in [1.0, -1.0] {
            let ahead = usize::from(speed > 0.0);
            let start = loads.enter(&at(0.3, speed), &mut phase).coordinate[ahead];
            let mut q = start;
            for _ in 0..pieces {
                let ends = loads.enter(&at(q, speed), &mut phase).coordinate;
                near(ends[1 - ahead], q, 1.0);
                assert!((ends[ahead] - q) * speed > 1e-3, "{name}: {ends:?}");
                q = ends[ahead];
            }
            near((q - start) * speed, TAU, TAU);
        }
    }
}

#[test]
fn a_force_against_the_motion_keeps_its_formula_beyond_a_rest() {
    let text = transient("conveyor").replace("gravity = \"9.81 m/s^2\"", "");
    let (linkage, loads) = compiled(&text);
    let trough = linkage.mechanism.link("trough").unwrap();
    let mut phase = loads.phase();
    let bounds = loads.enter(&at(0.3, 2.0), &mut phase);
    let rest = bounds.coordinate[1];
    assert!(bodies(&linkage, rest)[trough].x1.abs() < 1e-12);
    for step in [-0.01, 0.01] {
        let bodies = bodies(&linkage, rest + step);
        let found = loads.reduced_in_phase(&phase, &at(rest + step, 2.0), &bodies).moment;
        // -F |x'| before the rest; the same expression with the sign of before, after it.
        near(found, 900.0 * bodies[trough].x1.abs() * step.signum(), 900.0);
    }
    assert_eq!(bounds.speed, [0.0, f64::INFINITY]);
    assert_eq!(loads.enter(&at(0.3, -1e-300), &mut phase).speed, [f64::NEG_INFINITY, 0.0]);
}

const DISC: &str = r#"
[ground]
points = { O = 0 }
[link.disc]
points = { O = 0 }
inertia = 0.1
[input]
link = "disc"
[motion]
kind = "transient"
speed = 5
until = "1 s"
"#;

fn disc(over: &str, table: &str) -> String {
    format!("{DISC}[[moment]]\nlink = \"disc\"\nvalue = {{ over = \"{over}\", table = {table} }}\n")
}

#[test]
fn rows_of_each_variable_bound_the_box() {
    let bounds = |over: &str, state: LoadState| {
        let (_, loads) = compiled(&disc(over, "[[1, 0], [2, 10], [2, 30], [4, 50]]"));
        let mut phase = loads.phase();
        loads.enter(&state, &mut phase)
    };
    assert_eq!(bounds("angle", at(1.5, 1.0)).coordinate, [1.0, 2.0]);
    assert_eq!(bounds("angle", at(2.0, 1.0)).coordinate, [2.0, 4.0]);
    assert_eq!(bounds("angle", at(2.0, -1.0)).coordinate, [1.0, 2.0]);
    let wrapped = bounds("angle", at(0.5 + TAU, 1.0)).coordinate;
    near(wrapped[0], 4.0, 10.0);
    near(wrapped[1], 1.0 + TAU, 10.0);
    assert_eq!(bounds("speed", at(0.0, 3.0)).speed, [2.0, 4.0]);
    assert_eq!(bounds("speed", at(0.0, 2.0_f64.next_down())).speed, [1.0, 2.0]);
    assert_eq!(bounds("speed", at(0.0, 0.0)).speed, [f64::NEG_INFINITY, 1.0]);
    assert_eq!(bounds("time", LoadState { time: 2.0, ..at(0.0, 1.0) }).time, [2.0, 4.0]);
    assert_eq!(bounds("time", LoadState { time: 2.0, ..at(0.0, 1.0) }).coordinate[0], f64::NEG_INFINITY);
}

#[test]
fn a_frozen_segment_is_continued_beyond_its_rows() {
    let (linkage, loads) = compiled(&disc("angle", "[[0, 0], [2, 10], [2, 30], [4, 50]]"));
    let mut phase = loads.phase();
    loads.enter(&at(1.0 + TAU, 1.0), &mut phase);
    let moment = |q: f64| loads.reduced_in_phase(&phase, &at(q, 1.0), &bodies(&linkage, q)).moment;
    near(moment(2.0 + TAU), 10.0, 10.0);
    near(moment(3.0 + TAU), 15.0, 10.0);
    near(moment(-1.0 + TAU), -5.0, 10.0);
}

#[test]
fn a_contact_begins_and_ends_with_a_piece() {
    let (_, loads) = compiled(&format!(
        "{DISC}[[contact]]\nlink = \"disc\"\ncenter = [0.1, 0]\nradius = 0.2\nforce = 5\nduring = [\"-30 deg\", \"30 deg\"]\n"
    ));
    let mut phase = loads.phase();
    let within = loads.enter(&at(TAU, 1.0), &mut phase).coordinate;
    near(within[0], TAU - PI / 6.0, 10.0);
    near(within[1], TAU + PI / 6.0, 10.0);
    assert!(phase.loads[0].touches);
    loads.enter(&at(within[1], 1.0), &mut phase);
    assert!(!phase.loads[0].touches);
}

#[test]
fn dependence_by_structure() {
    let of = |text: &str| compiled(text).1.dependence();
    let constant = Dependence { inertia_constant: true, ..Dependence::default() };
    assert_eq!(of(&fixture("brake")), constant);
    assert_eq!(of(&disc("angle", "[[0, 1], [1, 2]]")), Dependence { moment_on_coordinate: true, ..constant });
    assert_eq!(of(&disc("speed", "[[0, 1], [1, 2]]")), Dependence { moment_on_speed: true, ..constant });
    assert_eq!(of(&disc("time", "[[0, 1], [1, 2]]")), Dependence { moment_on_time: true, ..constant });
    assert_eq!(of(&disc("time", "[[0, 1], [1, 1]]")), constant);
    let andrews = Dependence { moment_on_coordinate: true, ..Dependence::default() };
    assert_eq!(of(&fixture("andrews")), andrews);
}

#[test]
fn moments_on_other_links_and_contacts_depend_on_the_coordinate() {
    let rod = "gravity = 0\n[ground]\npoints = { O = [0, 0], C = [3, 0] }\n[link.crank]\npoints = { O = 0, A = 1 }\n\
               [link.coupler]\npoints = { A = 0, B = 3 }\n[link.rocker]\npoints = { C = 0, B = 2 }\n\
               [input]\nlink = \"crank\"\n[motion]\nspeed = 1\n";
    let of = |load: &str| compiled(&format!("{rod}{load}")).1.dependence().moment_on_coordinate;
    assert!(!of("[[moment]]\nlink = \"crank\"\nvalue = 2\n"));
    assert!(of("[[moment]]\nlink = \"rocker\"\nvalue = 2\n"));
    assert!(of("[[contact]]\nlink = \"crank\"\ncenter = \"A\"\nradius = 0.1\nangle = 1\nforce = 2\n"));
    // A force that turns with the crank has the same arm everywhere.
    let force =
        |frame: &str| of(&format!("[[force]]\nlink = \"crank\"\nat = \"A\"\nangle = 1\nvalue = 2\n{frame}"));
    assert!(!force("frame = \"link\"\n") && force(""));
}
