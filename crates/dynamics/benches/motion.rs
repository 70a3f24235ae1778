//! One right-hand side, a whole transient motion, and a steady regime with flywheel and ratio.

use assur_all as _;
use assur_dynamics::{equation, request, steady};
use assur_force::Loads;
use assur_integrator::{EquationOfMotion, Request, State, find};
use assur_kinematics::Linkage;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

fn compiled(name: &str) -> (Linkage, Loads) {
    let linkage = Linkage::compile(assur_scene::read(name, assur_fixtures::scene(name)).expect("scene"))
        .expect("linkage");
    let loads = Loads::compile(&linkage).expect("loads");
    (linkage, loads)
}

#[divan::bench]
fn right_hand_side_of_andrews(bencher: Bencher) {
    let (linkage, loads) = compiled("andrews");
    let mut motion = equation(&linkage, &loads).expect("equation");
    let mut state = State { time: 0.0, coordinate: -0.06, speed: 300.0 };
    motion.enter(&state).expect("piece");
    // A thousand at a time: the timer is not much finer than one.
    bencher.counter(divan::counter::ItemsCount::new(1000_u32)).bench_local(|| {
        for _ in 0..1000 {
            state.coordinate += 1e-3;
            black_box(motion.acceleration(black_box(&state)).is_ok());
        }
    });
}

/// Method and tolerance; the error that it has stands beside it in the tests.
#[divan::bench(args = [("energy", 1e-5), ("energy", 1e-6), ("energy", 1e-9), ("dop853", 1e-5), ("dop853", 1e-8), ("dopri5", 1e-6)])]
fn andrews(bencher: Bencher, (name, tolerance): (&str, f64)) {
    let (linkage, loads) = compiled("andrews");
    let integrator = find(name).expect("registered");
    let mut motion = equation(&linkage, &loads).expect("equation");
    let asked = request(&linkage.mechanism, &mut motion).expect("request");
    let asked = Request { tolerance, ..asked };
    let error = integrator
        .solve(&mut motion, &asked)
        .map_or(f64::NAN, |found| found.end.coordinate / 15.810_771_195_153_71 - 1.0);
    eprintln!("{name} {tolerance:e}: error {error:e}");
    bencher.bench_local(|| integrator.solve(&mut motion, black_box(&asked)).is_ok());
}

#[divan::bench]
fn steady_regime_of_the_shaper(bencher: Bencher) {
    let (linkage, loads) = compiled("shaper-drive");
    bencher.bench_local(|| steady(black_box(&linkage), black_box(&loads), None).is_ok());
}

#[divan::bench]
fn loads_of_the_shaper(bencher: Bencher) {
    let (linkage, _) = compiled("shaper-drive");
    bencher.bench_local(|| Loads::compile(black_box(&linkage)).is_ok());
}
