//! What a point of a sweep costs beside a formula that is written by hand: `cargo bench -p assur-sweep`.
//!
//! The unit y is a scalar slider-crank with constant lengths, positions with both derivatives, and the sine and cosine of
//! the standard library. It takes turns with the sweeps; the least time of each counts, since a shared machine only adds.

#![expect(clippy::unwrap_used, reason = "a bench stops where something is missing")]

use std::hint::black_box;
use std::num::NonZeroUsize;
use std::time::Instant;

use assur_all as _;
use assur_sweep::{Measure, Points, Rows, Sweep, SweepError, SweepRequest, Vary};
use assur_testkit::yardstick::slider_crank;

/// A slider-crank with masses and a force.
const SCENE: &str = r#"
gravity = 9.81
[ground]
points = { O = 0 }
[link.crank]
points = { O = 0, A = 0.1 }
mass = 1
center = [0.05, 0]
inertia = 0.01
[link.rod]
points = { A = 0, B = 0.35 }
mass = 2
center = [0.15, 0]
inertia = 0.03
[link.piston]
points = { B = 0 }
mass = 2
[[slide]]
link = "piston"
on = "ground"
[input]
link = "crank"
positions = 48
[motion]
speed = "60 rpm"
[[force]]
link = "piston"
at = "B"
angle = "180 deg"
value = "1 kN"
[assembly]
B = [0.4, 0]
"#;

/// Many short rounds: in one of them nothing else runs.
const ROUNDS: usize = 100;
const POINTS: usize = 128;

fn main() {
    let one = |positions: &str, measures: Vec<Measure>| sweep(positions, measures);
    let (default, all) = (Measure::defaults(), Measure::named(&["all"]).unwrap());
    let contestants = [
        ("48 positions, default measures, CSV", one("48", default.clone()), 48, 1, true),
        ("48 positions, default measures, CSV, two threads", one("48", default.clone()), 48, 2, true),
        ("48 positions, default measures", one("48", default.clone()), 48, 1, false),
        ("48 positions, all measures", one("48", all), 48, 1, false),
        ("48 positions, no measures", one("48", Vec::new()), 48, 1, false),
        ("1 position, no measures: compiling and following", one("1", Vec::new()), 1, 1, false),
        ("480 positions, default measures", one("480", default.clone()), 480, 1, false),
        ("48 positions, default measures, a force over the stroke", over_stroke(default), 48, 1, false),
        ("48 positions, no measures, a force over the stroke", over_stroke(Vec::new()), 48, 1, false),
    ];
    let mut yardstick = f64::INFINITY;
    let mut least = [f64::INFINITY; 9];
    for _ in 0..ROUNDS {
        yardstick = yardstick.min(by_hand());
        for (least, (_, sweep, positions, threads, csv)) in least.iter_mut().zip(&contestants) {
            let points = if *positions > 48 { POINTS / 8 } else { POINTS };
            *least = least.min(seconds(|| run(sweep, points, *threads, *csv)) / points as f64);
        }
    }
    println!("y = {:.1} ns", 1e9 * yardstick);
    for (seconds, (name, _, positions, ..)) in least.into_iter().zip(&contestants) {
        let each = seconds / yardstick / f64::from(*positions);
        println!("{name:56} {:8.2} us a point {each:8.1} y a position", 1e6 * seconds);
    }
}

fn sweep(positions: &str, measures: Vec<Measure>) -> Sweep {
    of(&SCENE.replace("positions = 48", &format!("positions = {positions}")), measures)
}

/// The force is that of a gas: its ends are where the piston reverses, and its rows where it passes them.
fn over_stroke(measures: Vec<Measure>) -> Sweep {
    let gas = "{ over = \"stroke\", axis = 0, forward = [[0, 0], [0.5, 700], [0.8, 3000], [1, 3000]], \
        back = [[0, 0], [0.8, 0], [1, 3000]] }";
    of(&SCENE.replace("\"1 kN\"", gas), measures)
}

fn of(scene: &str, measures: Vec<Measure>) -> Sweep {
    let points = Points::Sample { count: 1_000_000, seed: 1 };
    let ranges = ["link.crank.points.A=80 mm..120 mm", "link.piston.mass=1..3"];
    let vary: Vec<_> = ranges.iter().map(|range| Vary::parse(range, points).unwrap()).collect();
    Sweep::of("bench", scene, &vary, SweepRequest { points, measures, ..SweepRequest::default() }).unwrap()
}

fn run(sweep: &Sweep, points: usize, threads: usize, csv: bool) {
    let encode = |rows: Rows| if csv { rows.to_csv(false).unwrap().len() } else { rows.len() };
    let threads = NonZeroUsize::new(threads).unwrap();
    let accept = |length: usize| {
        black_box(length);
        Ok::<_, SweepError>(())
    };
    sweep.run(&(0..points), threads, encode, accept).unwrap();
}

fn seconds(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64()
}

/// Time of a position of the hand-written formula.
fn by_hand() -> f64 {
    const POSITIONS: u32 = 50_000;
    let whole = seconds(|| {
        for index in 0..POSITIONS {
            let (s, c) = black_box(f64::from(index) * 1e-4).sin_cos();
            black_box(slider_crank([s, c]));
        }
    });
    whole / f64::from(POSITIONS)
}
