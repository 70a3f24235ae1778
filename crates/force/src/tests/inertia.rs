//! A moment of inertia that varies with the coordinate (D fig. 3.17).

use assur_group::Wrench;

use super::{bodies, compiled, near};
use crate::{LoadState, power};

/// A four-bar whose crank and rocker have moments of inertia by formulas.
const FOUR_BAR: &str = r#"
[ground]
points = { O = 0, C = [0.4, 0.05] }
[link.crank]
points = { O = 0, A = 0.1 }
mass = 2
center = [0.03, 0.01]
inertia = { formula = "0.02 + 0.01*cos(q)", unit = "kg*m^2" }
[link.coupler]
points = { A = 0, B = 0.35 }
mass = 1.5
center = 0.2
inertia = 0.015
[link.rocker]
points = { B = 0, C = 0.3 }
mass = 3
center = 0.1
inertia = { formula = "30*(1 + 0.5*sin(2*q))", unit = "kg*mm^2" }
[input]
link = "crank"
[motion]
speed = 3
[assembly]
B = [0.35, 0.3]
"#;

fn state(coordinate: f64) -> LoadState {
    LoadState { coordinate, speed: 3.0, acceleration: -7.0, ..LoadState::default() }
}

/// By hand: the moment -I (phi' e + phi'' w²) - I' phi' w² / 2, phi' = 1 and phi'' = 0 of the input link.
#[test]
fn the_load_of_an_input_link_is_that_of_its_formula() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.disc]\npoints = { O = 0 }\n\
        inertia = { formula = \"0.02 + 0.01*cos(q)\" }\n[input]\nlink = \"disc\"\n[motion]\nspeed = 3\n";
    let (linkage, loads) = compiled(scene);
    for q in [0.0, 0.4, 2.0, -1.0, 11.0_f64] {
        let bodies = bodies(&linkage, q);
        let [inertia, slope] = [0.02 + 0.01 * q.cos(), -0.01 * q.sin()];
        let mut wrenches = vec![Wrench::ZERO; 2];
        loads.inertia(&state(q), &bodies, &mut wrenches);
        near(wrenches[1].m, inertia * 7.0 - slope * 4.5, 1.0);
        let reduced = loads.reduced(&state(q), &bodies);
        near(reduced.inertia, inertia, 1.0);
        near(reduced.inertia_derivative, slope, 1.0);
    }
}

/// T = J w² / 2: its difference over the coordinate, at a speed that follows e, is the power of the inertia loads.
#[test]
fn inertia_loads_take_what_the_kinetic_energy_gains() {
    let (linkage, loads) = compiled(FOUR_BAR);
    let (step, turning) = (1e-4, 0.5_f64);
    for i in 0..48 {
        let q = 0.13 * f64::from(i) - 1.0;
        // w² = w0² + 2 e (q - q0).
        let kinetic = |off: f64| {
            let reduced = loads.reduced(&state(q + off), &bodies(&linkage, q + off));
            turning * reduced.inertia * (9.0 - 14.0 * off)
        };
        let gained = (8.0 * (kinetic(step) - kinetic(-step)) - (kinetic(2.0 * step) - kinetic(-2.0 * step)))
            / (12.0 * step);
        let bodies = bodies(&linkage, q);
        let mut wrenches = vec![Wrench::ZERO; 4];
        loads.inertia(&state(q), &bodies, &mut wrenches);
        let taken: f64 = wrenches.iter().zip(&bodies).map(|(wrench, body)| power(wrench, body)).sum();
        assert!((gained + taken).abs() < 1e-9 * (1.0 + taken.abs()), "{q}: {gained} {taken}");
        let found = loads.reduced(&state(q), &bodies);
        let of_motion = found.inertia * -7.0 + 0.5 * found.inertia_derivative * 9.0;
        assert!((of_motion + taken).abs() < 1e-12 * (1.0 + taken.abs()), "{q}: {of_motion} {taken}");
    }
}
