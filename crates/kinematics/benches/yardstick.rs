//! What a position costs beside formulas that are written by hand for one mechanism with constant lengths:
//! `cargo bench -p assur-kinematics`.
//!
//! The unit y is the hand-written scalar slider-crank with the sine and cosine of the standard library. All contestants
//! take turns in short rounds; the least time of each counts, since a shared machine only adds. The hand-written lanes are
//! compiled for the same sets of instructions as those of the program. Figures: `docs/performance.md`.

use std::hint::black_box;
use std::time::Instant;

use assur_all as _;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_number::{Formula, Lanes, Real};

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

/// The slider-crank by hand: angle of the rod as a direction, place of the piston, with both derivatives.
#[inline(always)]
fn slider_crank<T: Real>([s, c]: [T; 2]) -> [T; 8] {
    let (crank, rod) = (T::from_f64(0.1), T::from_f64(0.35));
    let inverse = T::from_f64(1.0 / 0.35);
    let (x, y) = (crank * c, crank * s);
    let along = (rod * rod - y * y).sqrt();
    let per_along = T::ONE / along;
    let w = -(x * per_along);
    let e = y * (T::ONE + w * w) * per_along;
    let [first, second] = [w * y - y, e * y - w * w * along - x];
    [x + along, first, second, along * inverse, -(y * inverse), w, e, along]
}

/// The six-bar by hand: directions of the rocker, places of both stones along it and of the ram, with derivatives.
#[inline(always)]
fn six_bar<T: Real>([s, c]: [T; 2]) -> [T; 10] {
    let (x, y) = (T::from_f64(0.1) * c, T::from_f64(0.1) * s);
    let up = y + T::from_f64(0.4);
    let height = T::from_f64(0.68);
    let square = x * x + up * up;
    let along = square.sqrt();
    let per_square = T::ONE / square;
    let per_along = along * per_square;
    let t = [x * per_along, up * per_along];
    // A' = (-y, x), A'' = (-x, -y); along and across the rocker.
    let [along1, across1] = [x * t[1] - y * t[0], x * t[0] + y * t[1]];
    let [along2, across2] = [-(x * t[0] + y * t[1]), x * t[1] - y * t[0]];
    let w = across1 * per_along;
    let e = (across2 - (along1 * w).twice()) * per_along;
    let per_sine = T::ONE / t[1];
    let ram = height * t[0] * per_sine;
    let slope = height * per_sine * per_sine;
    let ram1 = -(slope * w);
    let ram2 = -(slope * (e - (w * w * t[0] * per_sine).twice()));
    [t[0], t[1], w, e, along, along1, along2 + w * w * along, ram, ram1, ram2]
}

/// The slider-crank by hand at eight coordinates.
struct SliderCrankByHand(Lanes);

impl Formula for SliderCrankByHand {
    type Value = [Lanes; 8];

    #[inline(always)]
    fn evaluate(self) -> [Lanes; 8] {
        let (s, c) = self.0.sin_cos();
        slider_crank([s, c])
    }
}

/// The six-bar by hand at eight coordinates.
struct SixBarByHand(Lanes);

impl Formula for SixBarByHand {
    type Value = [Lanes; 10];

    #[inline(always)]
    fn evaluate(self) -> [Lanes; 10] {
        let (s, c) = self.0.sin_cos();
        six_bar([s, c])
    }
}

/// A contestant: its name, a call that solves a number of positions, and its least time for one, s.
struct Contestant<'a> {
    name: &'static str,
    call: Box<dyn FnMut(usize) + 'a>,
    least: f64,
}

impl<'a> Contestant<'a> {
    fn new(name: &'static str, call: impl FnMut(usize) + 'a) -> Self {
        Self { name, call: Box::new(call), least: f64::INFINITY }
    }
}

/// The coordinate of a position: spread over one turn without an order that could be guessed.
fn coordinate(index: usize) -> f64 {
    (index as f64 * 0.618_033_988_749_894_9).fract() * std::f64::consts::TAU
}

fn scalar<'a, const N: usize>(name: &'static str, by_hand: fn([f64; 2]) -> [f64; N]) -> Contestant<'a> {
    Contestant::new(name, move |count| {
        for index in 0..count {
            let (s, c) = black_box(coordinate(index)).sin_cos();
            black_box(by_hand([s, c]));
        }
    })
}

fn lanes<'a, F: Formula + 'a>(name: &'static str, by_hand: fn(Lanes) -> F) -> Contestant<'a> {
    Contestant::new(name, move |count| {
        for index in 0..count / Lanes::WIDTH {
            let coordinates = Lanes::of(|lane| coordinate(index * Lanes::WIDTH + lane));
            black_box(Lanes::evaluate(by_hand(black_box(coordinates))));
        }
    })
}

fn one_by_one<'a>(name: &'static str, linkage: &'a Linkage, order: Order) -> Contestant<'a> {
    let mut position = linkage.position();
    Contestant::new(name, move |count| {
        for index in 0..count {
            let solved = linkage.solve(black_box(coordinate(index)), order, &mut position);
            assert!(black_box(solved).is_ok());
        }
    })
}

fn eight_by_eight<'a>(name: &'static str, linkage: &'a Linkage, order: Order) -> Contestant<'a> {
    let mut position = linkage.lane_position();
    Contestant::new(name, move |count| {
        for index in 0..count / Lanes::WIDTH {
            let coordinates = Lanes::of(|lane| coordinate(index * Lanes::WIDTH + lane));
            let solved = linkage.solve_lanes(black_box(coordinates), order, &mut position);
            assert!(black_box(solved).is_ok());
        }
    })
}

/// Positions of one contestant in one round, and rounds.
const COUNT: usize = 4096;
const ROUNDS: usize = 1500;

fn main() {
    let linkage = |text| {
        let mechanism = assur_scene::read("yardstick", text).expect("a good scene");
        Linkage::compile(mechanism).expect("a good mechanism")
    };
    let (one, two) = (linkage(SLIDER_CRANK), linkage(SIX_BAR));
    let mut all = [
        scalar("slider-crank by hand: y", slider_crank::<f64>),
        one_by_one("slider-crank, PF0", &one, Order::Place),
        one_by_one("slider-crank, PF0-PF1", &one, Order::First),
        one_by_one("slider-crank, PF0-PF2", &one, Order::Second),
        lanes("slider-crank by hand, lanes", SliderCrankByHand),
        eight_by_eight("slider-crank, PF0-PF2, lanes", &one, Order::Second),
        scalar("six-bar by hand", six_bar::<f64>),
        one_by_one("six-bar, PF0-PF2", &two, Order::Second),
        lanes("six-bar by hand, lanes", SixBarByHand),
        eight_by_eight("six-bar, PF0-PF2, lanes", &two, Order::Second),
    ];
    for _ in 0..ROUNDS {
        for one in &mut all {
            let start = Instant::now();
            (one.call)(COUNT);
            one.least = one.least.min(start.elapsed().as_secs_f64() / COUNT as f64);
        }
    }
    let y = all[0].least;
    println!("{:32} {:>8} {:>7} {:>12}", "", "ns", "y", "of by hand");
    let mut by_hand = y;
    for one in &all {
        if one.name.contains("by hand") {
            by_hand = one.least;
        }
        println!(
            "{:32} {:8.2} {:7.3} {:12.2}",
            one.name,
            one.least * 1e9,
            one.least / y,
            one.least / by_hand
        );
    }
}
