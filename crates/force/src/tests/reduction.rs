use assur_group::Wrench;
use serde_json::Value;

use super::{bodies, compiled, fixture};
use crate::{LoadState, power};

#[test]
fn reduced_values_agree_with_the_independent_results() {
    for name in ["shaper", "guide-shaper", "slider-crank", "conveyor", "stephenson3", "press"] {
        let (linkage, loads) = compiled(&fixture(name));
        let path = format!("{}/../../fixtures/{name}.json", env!("CARGO_MANIFEST_DIR"));
        let wanted: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        let mut worst = [[0.0_f64; 2]; 3];
        for (i, wanted) in wanted["positions"].as_array().unwrap().iter().enumerate() {
            let q = linkage.mechanism.input.coordinate(i);
            let found = loads.reduced(&LoadState::prescribed(&linkage.mechanism, q), &bodies(&linkage, q));
            let found = [found.inertia, found.inertia_derivative, found.moment];
            let keys = ["inertia", "inertia_derivative", "moment"];
            for (k, (found, key)) in found.into_iter().zip(keys).enumerate() {
                let wanted = wanted["reduced"][key].as_f64().unwrap();
                worst[k] = [worst[k][0].max((found - wanted).abs()), worst[k][1].max(wanted.abs())];
            }
        }
        for [error, size] in worst {
            assert!(error <= 1e-10 * size, "{name}: {error:e} of {size:e}");
        }
    }
}

/// Weights and a spring on a six-bar.
fn heavy() -> String {
    fixture("stephenson3").replace("damping = 25", "")
}

#[test]
fn derivative_of_the_inertia_matches_differences() {
    let (linkage, loads) = compiled(&heavy());
    let inertia = |q: f64| loads.reduced(&super::at(q, 1.0), &bodies(&linkage, q));
    let h = 1e-5;
    for i in 0..24 {
        let q = f64::from(i) * 0.26;
        let difference = (inertia(q + h).inertia - inertia(q - h).inertia) / (2.0 * h);
        assert!((inertia(q).inertia_derivative - difference).abs() < 1e-7, "{q}");
    }
}

#[test]
fn weights_and_springs_take_their_moment_from_the_potential() {
    let (linkage, loads) = compiled(&heavy().replace("value = 300", "value = 0"));
    let potential = |q: f64| loads.potential_energy(&bodies(&linkage, q));
    let h = 1e-5;
    for i in 0..24 {
        let q = f64::from(i) * 0.26;
        let difference = (potential(q + h) - potential(q - h)) / (2.0 * h);
        let moment = loads.reduced(&super::at(q, 1.0), &bodies(&linkage, q)).moment;
        assert!((moment + difference).abs() < 1e-6, "{q}: {moment} and {difference}");
    }
}

#[test]
fn power_of_all_loads_is_the_equation_of_motion() {
    // Lagrange-d'Alembert: the virtual power of loads and inertia loads is Q - J e - J' w²/2.
    for name in ["shaper", "conveyor", "stephenson3", "andrews"] {
        let (linkage, loads) = compiled(&fixture(name));
        for i in 0..12 {
            let q = linkage.mechanism.input.coordinate(i);
            let state = LoadState { coordinate: q, speed: 7.0, acceleration: -11.0, ..LoadState::default() };
            let bodies = bodies(&linkage, q);
            let mut all = vec![Wrench::ZERO; bodies.len()];
            loads.evaluate(&state, &bodies, &mut all);
            let each: Vec<f64> = all.iter().zip(&bodies).map(|(w, body)| power(w, body)).collect();
            let r = loads.reduced(&state, &bodies);
            let wanted = r.moment + 11.0 * r.inertia - 24.5 * r.inertia_derivative;
            let size: f64 = each.iter().map(|p| p.abs()).sum();
            assert!((each.iter().sum::<f64>() - wanted).abs() <= 1e-13 * size, "{name} {q}");
        }
    }
}

#[test]
fn nothing_is_allocated() {
    for name in ["shaper", "conveyor", "stephenson3", "press"] {
        let (linkage, loads) = compiled(&fixture(name));
        let q = linkage.mechanism.input.coordinate(3);
        let (state, bodies) = (LoadState::prescribed(&linkage.mechanism, q), bodies(&linkage, q));
        let mut all = vec![Wrench::ZERO; bodies.len()];
        let mut phase = loads.phase();
        let counted = allocation_counter::measure(|| {
            loads.evaluate(&state, &bodies, &mut all);
            loads.enter(&state, &mut phase);
            std::hint::black_box(loads.reduced(&state, &bodies));
            std::hint::black_box(loads.reduced_in_phase(&phase, &state, &bodies));
        });
        assert_eq!(counted.count_total, 0, "{name}");
    }
}
