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

/// A mechanism by hand at eight coordinates, written to where it is kept.
struct ByHand<'a, const N: usize, F>(Lanes, F, &'a mut [Lanes; N]);

impl<const N: usize, F: Fn([Lanes; 2]) -> [Lanes; N]> Formula for ByHand<'_, N, F> {
    type Value = ();

    #[inline(always)]
    fn evaluate(self) {
        let (s, c) = self.0.sin_cos();
        *self.2 = self.1([s, c]);
    }
}

/// A contestant: its name, a call that solves all coordinates, and its least time for one, s.
struct Contestant<'a> {
    name: &'static str,
    call: Box<dyn FnMut() + 'a>,
    least: f64,
}

impl<'a> Contestant<'a> {
    fn new(name: &'static str, call: impl FnMut() + 'a) -> Self {
        Self { name, call: Box::new(call), least: f64::INFINITY }
    }
}

/// Coordinates spread over one turn in an order that can't be guessed.
fn coordinates() -> Vec<f64> {
    let golden = |index: usize| (index as f64 * 0.618_033_988_749_894_9).fract() * std::f64::consts::TAU;
    (0..COUNT).map(golden).collect()
}

/// Eight of them at a time.
fn blocks() -> Vec<Lanes> {
    coordinates().chunks_exact(Lanes::WIDTH).map(|eight| Lanes::of(|lane| eight[lane])).collect()
}

fn scalar<'a, const N: usize>(
    name: &'static str,
    by_hand: impl Fn([f64; 2]) -> [f64; N] + 'a,
) -> Contestant<'a> {
    let coordinates = coordinates();
    Contestant::new(name, move || {
        for coordinate in &coordinates {
            let (s, c) = f64::sin_cos(*coordinate);
            black_box(by_hand([s, c]));
        }
    })
}

fn lanes<'a, const N: usize>(
    name: &'static str,
    by_hand: impl Fn([Lanes; 2]) -> [Lanes; N] + Copy + 'a,
) -> Contestant<'a> {
    let (blocks, mut found) = (blocks(), [Lanes::ZERO; N]);
    Contestant::new(name, move || {
        for coordinates in &blocks {
            Lanes::evaluate(ByHand(*coordinates, by_hand, &mut found));
            black_box(&mut found);
        }
    })
}

fn one_by_one<'a>(name: &'static str, linkage: &'a Linkage, order: Order) -> Contestant<'a> {
    let (coordinates, mut position) = (coordinates(), linkage.position());
    Contestant::new(name, move || {
        for coordinate in &coordinates {
            assert!(linkage.solve(*coordinate, order, &mut position).is_ok());
            black_box(&mut position);
        }
    })
}

fn eight_by_eight<'a>(name: &'static str, linkage: &'a Linkage, order: Order) -> Contestant<'a> {
    let (blocks, mut position) = (blocks(), linkage.lane_position());
    Contestant::new(name, move || {
        for coordinates in &blocks {
            assert!(linkage.solve_lanes(*coordinates, order, &mut position).is_ok());
            black_box(&mut position);
        }
    })
}

/// Positions of one contestant in one round, and rounds.
const COUNT: usize = 1024;
const ROUNDS: usize = 4000;

fn main() {
    let linkage = |text| {
        let mechanism = assur_scene::read("yardstick", text).expect("a good scene");
        Linkage::compile(mechanism).expect("a good mechanism")
    };
    let (one, two) = (linkage(SLIDER_CRANK), linkage(SIX_BAR));
    let mut all = [
        scalar("slider-crank by hand: y", slider_crank),
        one_by_one("slider-crank, PF0", &one, Order::Place),
        one_by_one("slider-crank, PF0-PF1", &one, Order::First),
        one_by_one("slider-crank, PF0-PF2", &one, Order::Second),
        lanes("slider-crank by hand, lanes", slider_crank),
        eight_by_eight("slider-crank, PF0-PF2, lanes", &one, Order::Second),
        scalar("six-bar by hand", six_bar),
        one_by_one("six-bar, PF0-PF2", &two, Order::Second),
        lanes("six-bar by hand, lanes", six_bar),
        eight_by_eight("six-bar, PF0-PF2, lanes", &two, Order::Second),
    ];
    for _ in 0..ROUNDS {
        for one in &mut all {
            let start = Instant::now();
            (one.call)();
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
