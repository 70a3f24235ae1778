//! Places and coefficients along the path, in both directions and from any start.

use assur_integrator::{Dependence, EquationOfMotion, MotionError, Piece, Reduced, State};

use super::{CyclePath, Path};
use crate::DynamicsError;

/// Formulas that hold for coordinates from 1 to 3 and speeds from -2 to 5; the moment has a part that is not linear in the
/// speed.
struct Known {
    square: f64,
}

impl EquationOfMotion for Known {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_coordinate: true, moment_on_speed: true, ..Dependence::default() }
    }

    fn enter(&mut self, _: &State) -> Result<Piece, MotionError> {
        Ok(Piece { coordinate: [1.0, 3.0], speed: [-2.0, 5.0], ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, at: &State) -> Result<Reduced, MotionError> {
        let moment = 7.0 + at.coordinate - 3.0 * at.speed + self.square * at.speed * at.speed;
        Ok(Reduced { inertia: 2.0 + 0.5 * at.coordinate, inertia_derivative: 0.5, moment })
    }
}

fn near(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() < 1e-12
}

#[test]
fn a_coordinate_lies_as_far_along_the_path_as_it_is_from_the_start() {
    for (sense, start) in [(1.0, 0.0), (-1.0, 0.0), (1.0, 0.5), (-1.0, -2.5)] {
        let cycle = CyclePath { start, sense, length: 6.0 };
        for (way, x) in [(0.0, 0.0), (1.25, 1.25), (5.5, 5.5), (6.0, 0.0), (7.5, 1.5), (-1.0, 5.0)] {
            let found = cycle.path_coordinate(start + sense * way);
            assert!(near(found, x), "{sense} from {start}: {way} is {found}");
        }
        assert!(near(cycle.coordinate(1.25), start + sense * 1.25));
    }
}

#[test]
fn bounds_of_the_formulas_are_counted_from_the_start() {
    let motion = &mut Known { square: 0.0 };
    let forward = CyclePath { start: 0.5, sense: 1.0, length: 6.0 };
    assert_eq!(Path::new(motion, forward).enter(1.0, 1.0).unwrap(), [[0.5, 2.5], [-2.0, 5.0]]);
    let back = CyclePath { start: 4.0, sense: -1.0, length: 6.0 };
    assert_eq!(Path::new(motion, back).enter(2.0, 1.0).unwrap(), [[1.0, 3.0], [-5.0, 2.0]]);
}

#[test]
fn a_moment_is_taken_apart_into_its_parts() {
    for sense in [1.0, -1.0] {
        let motion = &mut Known { square: 0.0 };
        let mut path = Path::new(motion, CyclePath { start: 2.0, sense, length: 6.0 });
        let found = path.coefficients(0.25, 0.5, 1.5).unwrap();
        let (first, q) = (found.nodes[0], 2.0 + sense * 0.25);
        assert!(near(first.inertia, 2.0 + 0.5 * q) && near(first.slope, sense * 0.5), "{first:?}");
        // Along the path the speed is positive: -3 w is -3 v in both directions.
        assert!(near(first.moment, sense * (7.0 + q)) && near(first.by_speed, -3.0), "{first:?}");
        assert!(near(first.moment_at(2.0), sense * (7.0 + q) - 6.0));
    }
}

#[test]
fn a_moment_that_is_not_linear_in_the_speed_is_refused() {
    for (square, refused) in [(0.0, false), (1e-11, false), (1e-6, true), (1.0, true)] {
        let motion = &mut Known { square };
        let mut path = Path::new(motion, CyclePath { start: 2.0, sense: 1.0, length: 6.0 });
        let found = path.coefficients(0.25, 0.5, 1.5);
        assert_eq!(matches!(found, Err(DynamicsError::NotLinear(_))), refused, "{square}: {found:?}");
    }
}

/// Formulas that change at 1 and at 3, where the earlier ones still hold.
struct Edges;

impl EquationOfMotion for Edges {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_coordinate: true, ..Dependence::default() }
    }

    fn enter(&mut self, at: &State) -> Result<Piece, MotionError> {
        let bounds = [[f64::NEG_INFINITY, 1.0], [1.0, 3.0], [3.0, f64::INFINITY]];
        let coordinate = *bounds.iter().find(|[_, end]| at.coordinate <= *end).unwrap_or(&bounds[2]);
        Ok(Piece { coordinate, ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, _: &State) -> Result<Reduced, MotionError> {
        Ok(Reduced { inertia: 1.0, ..Reduced::default() })
    }
}

#[test]
fn the_path_has_a_corner_wherever_its_formulas_change() {
    let motion = &mut Edges;
    let mut path = Path::new(motion, CyclePath { start: 0.0, sense: 1.0, length: 6.0 });
    assert_eq!(path.corners(1.0).unwrap(), [0.0, 1.0, 3.0, 6.0]);
    // From one edge through the other: the cycle begins and ends on corners anyway.
    let mut path = Path::new(motion, CyclePath { start: 1.0, sense: 1.0, length: 6.0 });
    assert_eq!(path.corners(1.0).unwrap(), [0.0, 2.0, 6.0]);
}
