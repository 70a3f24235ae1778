//! A slider-crank with friction in all pairs, against Newton's and Euler's equations of its three links with all unknowns, whose
//! magnitudes are iterated, integrated along the crank's angle from one dead center or extreme of the rod to the next.

use std::f64::consts::{FRAC_PI_2, TAU};

use approx::assert_relative_eq;
use assur_integrator::{EquationOfMotion as _, EventKind, State};
use nalgebra::{SMatrix, SVector};

use super::super::compiled;
use super::{G, moved};
use crate::{Machine, steady};

const R: f64 = 0.1;
const L: f64 = 0.35;
/// From the crank's end to the rod's center of mass.
const C: f64 = 0.14;
const CRANK: f64 = 0.08;
const ROD_MASS: f64 = 1.2;
const ROD: f64 = 0.012;
const PISTON: f64 = 2.0;
/// Coefficient times radius of the pins O, A and B; coefficient and length of the guide.
const LEVERS: [f64; 3] = [0.1 * 0.02, 0.08 * 0.018, 0.08 * 0.012];
const GUIDE: f64 = 0.12;
const CONTACT: f64 = 0.08;

const SCENE: &str = "gravity = \"9.81 m/s^2\"\n[ground]\npoints = { O = [0, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 0.1 }\nmass = 3\ncenter = \"O\"\ninertia = 0.08\n\
    [link.rod]\npoints = { A = 0, B = 0.35 }\nmass = 1.2\ncenter = [0.14, 0]\ninertia = 0.012\n\
    [link.piston]\npoints = { B = [0, 0] }\nmass = 2\n\
    [[slide]]\nlink = \"piston\"\non = \"ground\"\nthrough = \"O\"\npoint = \"B\"\nname = \"cylinder\"\n\
    [input]\nlink = \"crank\"\nfrom = 0\npositions = 12\n[assembly]\nB = [0.4, 0]\n\
    [[friction]]\npair = \"O\"\ncoefficient = 0.1\nradius = 0.02\n\
    [[friction]]\npair = \"A\"\ncoefficient = 0.08\nradius = 0.018\n\
    [[friction]]\npair = \"B\"\ncoefficient = 0.08\nradius = 0.012\n\
    [[friction]]\npair = \"cylinder\"\ncoefficient = 0.12\nlength = 0.08\n";

/// What acts besides friction: a moment and an inertia on the crank, a force on the piston against its motion, N.
#[derive(Clone, Copy)]
struct Acting {
    moment: f64,
    inertia: f64,
    force: f64,
}

/// Acceleration of the crank, with the senses of an angle inside the stretch. Unknowns: e, the forces on the rod at A and B, the
/// normal force and the moment of the guide on the piston, the force of the ground on the crank.
fn acceleration(q: f64, w: f64, inside: f64, acting: Acting) -> f64 {
    let (s, c) = q.sin_cos();
    let (t, u) = (-R * s / L, (1.0 - (R * s / L).powi(2)).sqrt());
    // The rod's angle b: sin b = t; b' and b'' by q.
    let b1 = -R * c / (L * u);
    let b2 = (R * s / L + t * b1 * b1) / u;
    // Second derivatives with respect to q times w^2 plus first derivatives times e, of the rod's center and of the piston.
    let first = [-R * s - C * t * b1, R * c + C * u * b1];
    let second = [-R * c - C * (u * b1 * b1 + t * b2), -R * s + C * (u * b2 - t * b1 * b1)];
    let piston = [-R * s - L * t * b1, -R * c - L * (u * b1 * b1 + t * b2)];
    let (s_in, c_in) = inside.sin_cos();
    let b_in = -R * c_in / (L * (1.0 - (R * s_in / L).powi(2)).sqrt());
    let slides = (-R * s_in - L * (-R * s_in / L) * b_in).signum();
    // Turning of the crank on the ground, of the rod on the crank, of the piston on the rod.
    let senses = [1.0, (b_in - 1.0).signum(), -b_in.signum()];
    let mut matrix = SMatrix::<f64, 9, 9>::zeros();
    let mut right = SMatrix::<f64, 9, 6>::zeros();
    let mut row = |index: usize, entries: &[(usize, f64)], base: f64| {
        for (column, value) in entries {
            matrix[(index, *column)] += value;
        }
        right[(index, 0)] = base;
    };
    let ww = w * w;
    let inertia = CRANK + acting.inertia;
    row(0, &[(7, 1.0), (1, -1.0)], 0.0);
    row(1, &[(8, 1.0), (2, -1.0)], 3.0 * G);
    row(2, &[(0, inertia), (2, R * c), (1, -R * s)], acting.moment);
    row(3, &[(0, ROD_MASS * first[0]), (1, -1.0), (3, -1.0)], -ROD_MASS * second[0] * ww);
    row(4, &[(0, ROD_MASS * first[1]), (2, -1.0), (4, -1.0)], -ROD_MASS * (second[1] * ww + G));
    // About the center of mass: A lies C behind it, B the rest of the rod before it.
    let ahead = L - C;
    let arms = [(1, -C * t), (2, C * u), (3, ahead * t), (4, -ahead * u)];
    row(5, &[&[(0, ROD * b1)][..], &arms[..]].concat(), -ROD * b2 * ww);
    row(6, &[(0, PISTON * piston[0]), (3, 1.0)], -PISTON * piston[1] * ww - slides * acting.force);
    row(7, &[(4, 1.0), (5, -1.0)], -PISTON * G);
    row(8, &[(6, 1.0)], 0.0);
    // Friction of each magnitude of 1: the moment on the link that turns, the opposite on the other.
    right[(2, 1)] -= senses[0] * LEVERS[0];
    right[(5, 2)] -= senses[1] * LEVERS[1];
    right[(2, 2)] += senses[1] * LEVERS[1];
    right[(5, 3)] += senses[2] * LEVERS[2];
    // The guide takes the moment that the rod's journal gives the piston.
    right[(8, 3)] += senses[2] * LEVERS[2];
    (4..6).for_each(|end| right[(6, end)] -= slides * GUIDE);
    let answers = matrix.lu().solve(&right).unwrap();
    let mut z = SVector::<f64, 6>::zeros();
    z[0] = 1.0;
    for _ in 0..200 {
        let x = answers * z;
        let next = [
            1.0,
            x[7].hypot(x[8]),
            x[1].hypot(x[2]),
            x[3].hypot(x[4]),
            (0.5 * x[5] + x[6] / CONTACT).abs(),
            (0.5 * x[5] - x[6] / CONTACT).abs(),
        ];
        let next = SVector::<f64, 6>::from(next);
        let change = (next - z).amax();
        z = next;
        if change <= 1e-15 * z.amax() {
            break;
        }
    }
    (answers * z)[0]
}

/// From w^2/2 and the time at an angle to those at the next quarter of a turn, by the classical method of order 4.
fn quarter(from: f64, [mut half, mut time]: [f64; 2], steps: u32, acting: Acting) -> [f64; 2] {
    let h = FRAC_PI_2 / f64::from(steps);
    let inside = from + 0.5 * FRAC_PI_2;
    for i in 0..steps {
        let q = from + h * f64::from(i);
        let rate = |q: f64, half: f64| {
            let w = (2.0 * half).sqrt();
            [acceleration(q, w, inside, acting), 1.0 / w]
        };
        let k1 = rate(q, half);
        let k2 = rate(q + 0.5 * h, half + 0.5 * h * k1[0]);
        let k3 = rate(q + 0.5 * h, half + 0.5 * h * k2[0]);
        let k4 = rate(q + h, half + h * k3[0]);
        half += h / 6.0 * (k1[0] + 2.0 * k2[0] + 2.0 * k3[0] + k4[0]);
        time += h / 6.0 * (k1[1] + 2.0 * k2[1] + 2.0 * k3[1] + k4[1]);
    }
    [half, time]
}

const IDLE: Acting = Acting { moment: 0.0, inertia: 0.0, force: 0.0 };

#[test]
fn a_slider_crank_runs_down() {
    let motion = "[motion]\nkind = \"transient\"\nspeed = 40\nuntil = \"1 rev\"\nsamples = 8\n";
    let found = moved(&format!("{SCENE}{motion}"));
    let run = |steps: u32| {
        (0_u8..4).fold([800.0, 0.0], |at, number| quarter(f64::from(number) * FRAC_PI_2, at, steps, IDLE))
    };
    let [coarse, fine] = [run(300), run(600)];
    let end = found.trajectory.end;
    // Where another face is pressed the equation bends inside a step: the two runs tell how much that is.
    let off = (fine[0] - coarse[0]).abs() / fine[0];
    assert!(off < 1e-7, "{off}");
    assert_relative_eq!(0.5 * end.speed * end.speed, fine[0], max_relative = 1e-8 + off);
    assert_relative_eq!(end.time, fine[1], max_relative = 1e-8 + off);
    // Without friction it comes back with its speed.
    assert!(end.speed < 39.9, "{end:?}");
    let faces = found.trajectory.events.iter().filter(|event| event.kind == EventKind::Face);
    assert!(faces.count() > 1, "{:?}", found.trajectory.events);
}

#[test]
fn the_acceleration_of_a_driven_slider_crank_in_all_places() {
    let motion =
        "[motion]\nkind = \"transient\"\nspeed = 5\nuntil = \"1 s\"\n[drive]\ntorque = 9\nflywheel = 0.5\n";
    let (linkage, loads) = compiled(&format!("{SCENE}{motion}"));
    let mut machine = crate::equation(&linkage, &loads).unwrap();
    let acting = Acting { moment: 9.0, inertia: 0.5, force: 0.0 };
    for i in 0_u8..100 {
        let (q, w) = (0.05 + TAU * f64::from(i) / 100.0, 1.0 + f64::from(i));
        let state = State { time: 0.0, coordinate: q, speed: w };
        machine.enter(&state).unwrap();
        let found = machine.acceleration(&state).unwrap();
        assert_relative_eq!(found, acceleration(q, w, q, acting), max_relative = 1e-9);
    }
}

#[test]
fn a_regime_with_friction_comes_back_to_its_speed() {
    let more = "[motion]\nkind = \"steady\"\nmean_speed = 12\nunevenness = 0.1\n[drive]\ntorque = \"balance\"\nflywheel = \"solve\"\n\
                [[force]]\nlink = \"piston\"\nat = \"B\"\nagainst_motion = true\nvalue = 300\n";
    let (linkage, loads) = compiled(&format!("{SCENE}{more}"));
    let found = steady(&linkage, &loads, None).unwrap();
    let (regime, figures) = (&found.regime, &found.regime.figures);
    assert_relative_eq!(figures.mean_speed, 12.0, max_relative = 1e-9);
    assert_relative_eq!(figures.unevenness, 0.1, max_relative = 1e-8);
    let torque = figures.torque.unwrap();
    let acting = Acting { moment: torque, inertia: regime.flywheel, force: 300.0 };
    let start = regime.state(0.0).speed;
    let end = (0_u8..4).fold([0.5 * start * start, 0.0], |at, number| {
        quarter(f64::from(number) * FRAC_PI_2, at, 300, acting)
    });
    assert_relative_eq!(end[0], 0.5 * start * start, max_relative = 1e-8);
    assert_relative_eq!(end[1], regime.cycle_time, max_relative = 1e-8);
    // The work of the drive is that of the force over four strokes, and what is lost.
    let lost = torque * TAU - 4.0 * R * 300.0;
    assert!(lost > 2.0, "{lost}");
    assert_relative_eq!(found.regime.resistance_work, torque * TAU, max_relative = 1e-9);
    let mut driven = Machine::new(&linkage, &loads).with_drive(regime.drive());
    let q = 1.0;
    let state = State { time: 0.0, coordinate: q, speed: regime.state(q).speed };
    driven.enter(&state).unwrap();
    let expected = acceleration(q, state.speed, q, acting);
    assert_relative_eq!(regime.state(q).acceleration, expected, max_relative = 1e-6);
    assert_relative_eq!(driven.acceleration(&state).unwrap(), expected, max_relative = 1e-9);
}
