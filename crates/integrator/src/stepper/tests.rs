#![expect(clippy::float_cmp, reason = "sums and quotients of small integers are exact")]

use super::*;
use crate::{Dependence, Reduced};

/// J = 2 + q, Q = 10 - 8 q - 6 w.
struct Known;

impl EquationOfMotion for Known {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_coordinate: true, moment_on_speed: true, ..Dependence::default() }
    }

    fn enter(&mut self, _: &State) -> Result<Piece, MotionError> {
        Ok(Piece::UNBOUNDED)
    }

    fn reduced(&mut self, at: &State) -> Result<Reduced, MotionError> {
        let moment = 10.0 - 8.0 * at.coordinate - 6.0 * at.speed;
        Ok(Reduced { inertia: 2.0 + at.coordinate, inertia_derivative: 1.0, moment })
    }
}

fn at(coordinate: f64, speed: f64) -> State {
    State { time: 0.0, coordinate, speed }
}

#[test]
fn acceleration_follows_from_moment_and_change_of_inertia() {
    let motion = &mut Known;
    let mut equation = CountedEquation::new(motion);
    // (10 - 16 - 12 - 1 4/2)/4
    assert_eq!(equation.acceleration(&at(2.0, 2.0)).unwrap(), -5.0);
    assert_eq!(equation.work(&at(2.0, 2.0)).unwrap(), (4.0, -18.0));
    equation.enter(&at(0.0, 1.0)).unwrap();
    let counted = equation.cost;
    assert_eq!((counted.evaluations, counted.pieces, counted.jacobians), (2, 1, 0));
    assert!(matches!(equation.acceleration(&at(-2.0, 0.0)), Err(MotionError::Inertia(_))));
    assert!(matches!(equation.work(&at(-3.0, 0.0)), Err(MotionError::Inertia(_))));
    let reduced = Reduced { inertia: 1.0, inertia_derivative: 0.0, moment: f64::INFINITY };
    assert!(matches!(reduced.acceleration(1.0), Err(MotionError::NotFinite { .. })));
}

#[test]
fn partial_derivatives_are_differences_and_give_the_eigenvalue() {
    let motion = &mut Known;
    let mut equation = CountedEquation::new(motion);
    let here = at(2.0, 2.0);
    let acceleration = equation.acceleration(&here).unwrap();
    let found = equation.partials(&here, acceleration).unwrap();
    // e = (10 - 8 q - 6 w - w²/2)/(2 + q): de/dq = (-8 - e)/4 and de/dw = (-6 - w)/4.
    assert!((found.by_coordinate + 0.75).abs() < 1e-7 && (found.by_speed + 2.0).abs() < 1e-7, "{found:?}");
    // x² + 2 x + 0.75 has the roots -0.5 and -1.5.
    assert!((equation.eigenvalue(&here).unwrap() - 1.5).abs() < 1e-6);
    // At q = -1, w = 1: e = 11.5, by coordinate -19.5, by speed -7: complex roots of modulus sqrt(19.5).
    assert!((equation.eigenvalue(&at(-1.0, 1.0)).unwrap() - 19.5_f64.sqrt()).abs() < 1e-6);
    assert_eq!(equation.cost.jacobians, 3);
}

#[test]
fn an_increment_has_half_of_the_digits_and_is_exact() {
    for value in [0.0, 1e-9, 1.0, -300.0] {
        let (found, wanted) = (increment(value), f64::EPSILON.sqrt() * value.abs().max(1e-4));
        assert!((found / wanted - 1.0).abs() < 1e-6, "{value}: {found:e}");
        assert_eq!((value + found) - value, found);
    }
}
