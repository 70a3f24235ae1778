//! What a position costs beside formulas that are written by hand for one mechanism with constant lengths:
//! `cargo bench -p assur-kinematics`.
//!
//! The first one, the unit y, is the hand-written scalar slider-crank with the sine and cosine of the standard library. The
//! hand-written lanes are compiled for the same sets of instructions as those of the program. Figures:
//! `docs/measured/performance.md`.

use std::hint::black_box;

use assur_all as _;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_testkit::yardstick::{Contestant, race, six_bar, slider_crank};

const SLIDER_CRANK: &str = r#"
[ground]
points = { O = [0, 0] }
[link.crank]
points = { O = 0, A = 0.1 }
[link.rod]
points = { A = 0, B = 0.35 }
[link.piston]
points = { B = 0 }
[[slide]]
link = "piston"
on = "ground"
[input]
link = "crank"
positions = 12
[assembly]
B = [0.45, 0]
"#;

const SIX_BAR: &str = r#"
[ground]
points = { O = [0, 0], C = [0, -0.4] }
[link.crank]
points = { O = 0, A = 0.1 }
[link.stone]
points = { A = 0 }
[link.rocker]
points = { C = 0 }
[link.stone2]
points = { B = 0 }
[link.ram]
points = { B = 0 }
[[slide]]
link = "stone"
on = "rocker"
through = "C"
[[slide]]
link = "stone2"
on = "rocker"
through = "C"
[[slide]]
link = "ram"
on = "ground"
through = [0, 0.28]
[input]
link = "crank"
positions = 12
[assembly]
B = [0.17, 0.28]
"#;

fn by_hand<'a, V: 'a>(name: &'static str, formula: impl Fn([f64; 2]) -> V + 'a) -> Contestant<'a> {
    Contestant::one_by_one(name, move |coordinate| {
        let (s, c) = f64::sin_cos(coordinate);
        black_box(formula([s, c]));
    })
}

fn one_by_one<'a>(name: &'static str, linkage: &'a Linkage, order: Order) -> Contestant<'a> {
    let mut position = linkage.position();
    Contestant::one_by_one(name, move |coordinate| {
        assert!(linkage.solve(coordinate, order, &mut position).is_ok());
        black_box(&mut position);
    })
}

fn eight_by_eight<'a>(name: &'static str, linkage: &'a Linkage) -> Contestant<'a> {
    let mut position = linkage.lane_position();
    Contestant::eight_by_eight(name, move |coordinates| {
        assert!(linkage.solve_lanes(coordinates, Order::Second, &mut position).is_ok());
        black_box(&mut position);
    })
}

const ROUNDS: usize = 4000;

fn main() {
    let linkage = |text| {
        let mechanism = assur_scene::read("yardstick", text).expect("a good scene");
        Linkage::compile(mechanism).expect("a good mechanism")
    };
    let (one, two) = (linkage(SLIDER_CRANK), linkage(SIX_BAR));
    let all = vec![
        by_hand("slider-crank by hand (y)", slider_crank),
        one_by_one("slider-crank, PF0", &one, Order::Place),
        one_by_one("slider-crank, PF0-PF1", &one, Order::First),
        one_by_one("slider-crank, PF0-PF2", &one, Order::Second),
        Contestant::by_hand_in_lanes("slider-crank by hand, lanes", slider_crank),
        eight_by_eight("slider-crank, PF0-PF2, lanes", &one),
        by_hand("six-bar by hand", six_bar),
        one_by_one("six-bar, PF0-PF2", &two, Order::Second),
        Contestant::by_hand_in_lanes("six-bar by hand, lanes", six_bar),
        eight_by_eight("six-bar, PF0-PF2, lanes", &two),
    ];
    race(all, ROUNDS);
}
