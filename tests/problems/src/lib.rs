//! Equations with known answers, on which every method is tried: E1, D1, a pendulum, jumps, friction, Andrews' mechanism.

use std::f64::consts::PI;

use assur_integrator::{Dependence, EquationOfMotion, MotionError, Piece, Reduced, State};

mod andrews;
mod elliptic;

pub use andrews::Andrews;
pub use elliptic::{complete_elliptic, pendulum_period};

/// Which piece an [`Example`] is in.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Place {
    /// Number of breaks below the coordinate.
    pub segment: usize,
    /// Direction of motion, 1 or -1; 1 where [`Example::directed`] is not set.
    pub direction: f64,
}

/// An equation given by a formula.
#[derive(Debug, Clone)]
pub struct Example<F> {
    /// What the formula depends on.
    pub dependence: Dependence,
    /// Coordinates at which the formula jumps or has a kink, ascending.
    pub breaks: Vec<f64>,
    /// The formula depends on the sign of the speed.
    pub directed: bool,
    formula: F,
    place: Place,
}

impl<F: Fn(Place, &State) -> Reduced> Example<F> {
    /// An equation of one smooth formula.
    pub fn new(dependence: Dependence, formula: F) -> Self {
        let place = Place { segment: 0, direction: 1.0 };
        Self { dependence, breaks: Vec::new(), directed: false, formula, place }
    }

    /// Adds breaks along the coordinate, at which the formula may jump.
    #[must_use]
    pub fn with_breaks(mut self, breaks: Vec<f64>) -> Self {
        self.breaks = breaks;
        self
    }

    /// Lets the formula depend on the direction of motion.
    #[must_use]
    pub fn directed(mut self) -> Self {
        self.directed = true;
        self
    }
}

impl<F: Fn(Place, &State) -> Reduced> EquationOfMotion for Example<F> {
    fn dependence(&self) -> Dependence {
        self.dependence
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        let forward = state.speed > 0.0;
        let q = state.coordinate;
        let below = |limit: &f64| if forward { *limit <= q } else { *limit < q };
        let segment = self.breaks.partition_point(below);
        let mut piece = Piece::UNBOUNDED;
        if segment > 0 {
            piece.coordinate[0] = self.breaks[segment - 1];
        }
        if let Some(limit) = self.breaks.get(segment) {
            piece.coordinate[1] = *limit;
        }
        self.place = Place { segment, direction: 1.0 };
        if self.directed {
            self.place.direction = if forward { 1.0 } else { -1.0 };
            piece.speed[usize::from(!forward)] = 0.0;
        }
        Ok(piece)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        Ok((self.formula)(self.place, state))
    }
}

/// Constant inertia.
fn constant(inertia: f64, moment: f64) -> Reduced {
    Reduced { inertia, inertia_derivative: 0.0, moment }
}

/// J constant and M constant (D's case 1).
pub const CONSTANT: Dependence = Dependence {
    inertia_constant: true,
    moment_on_coordinate: false,
    moment_on_speed: false,
    moment_on_time: false,
    moment_on_acceleration: false,
    moment_switches: false,
};

/// J constant and M(q).
pub const BY_COORDINATE: Dependence = Dependence { moment_on_coordinate: true, ..CONSTANT };

/// J(q) and M(q) (D's case 3).
pub const VARIABLE: Dependence = Dependence { inertia_constant: false, ..BY_COORDINATE };

/// E1: J = 0.1 kg m², a driving moment of 30 N m that falls linearly to 0 over five turns, less 10 N m.
/// From rest, w = sqrt(1000 pi) rad/s after five turns.
pub fn e1() -> impl EquationOfMotion {
    let five_turns = 10.0 * PI;
    Example::new(BY_COORDINATE, move |_, at| constant(0.1, 30.0 * (1.0 - at.coordinate / five_turns) - 10.0))
}

/// D1: a brake, J = 0.4 kg m², M = -0.8 N m. From 100 rad/s it stops in 50 s after 2500 rad.
pub fn d1() -> impl EquationOfMotion {
    Example::new(CONSTANT, |_, _| constant(0.4, -0.8))
}

/// The brake as dry friction: against the motion, so that it rests for good.
pub fn d1_friction() -> impl EquationOfMotion {
    Example::new(CONSTANT, |place, _| constant(0.4, -0.8 * place.direction)).directed()
}

/// A pendulum: w' = -sin q.
pub fn pendulum() -> impl EquationOfMotion {
    Example::new(BY_COORDINATE, |_, at| constant(2.0, -2.0 * at.coordinate.sin()))
}

/// A mass of 1 whose moment jumps from 2 to -1 at q = 1 and to 4 at q = 2. From rest at q = 0 it passes q = 1 with
/// w² = 4 at t = 1, q = 2 with w² = 2 at t = 3 - sqrt 2, and q = 3 with w² = 10 after (sqrt 10 - sqrt 2)/4 more.
pub fn jumps() -> impl EquationOfMotion {
    const MOMENTS: [f64; 3] = [2.0, -1.0, 4.0];
    Example::new(BY_COORDINATE, |place, _| constant(1.0, MOMENTS[place.segment])).with_breaks(vec![1.0, 2.0])
}

/// A spring of stiffness 1 on a mass of 1 with dry friction 0.3: from rest at q = 1 it swings to -0.4 in pi seconds, and
/// from there to -0.2, where the friction holds it: 2 pi seconds in all.
pub fn friction_oscillator() -> impl EquationOfMotion {
    Example::new(BY_COORDINATE, |place, at| constant(1.0, -at.coordinate - 0.3 * place.direction)).directed()
}

/// Inertia that varies three times, no moment: the kinetic energy is kept. J = 2 + cos q.
pub fn coasting() -> impl EquationOfMotion {
    Example::new(VARIABLE, |_, at| Reduced {
        inertia: 2.0 + at.coordinate.cos(),
        inertia_derivative: -at.coordinate.sin(),
        moment: 0.0,
    })
}

/// A motor of slope `steepness` (N m s) at synchronous speed 10 rad/s on J = 1 + 0.3 cos q against a load
/// 2 + sin q: stiff for a great steepness.
pub fn motor(steepness: f64) -> impl EquationOfMotion {
    let dependence = Dependence { moment_on_speed: true, ..VARIABLE };
    Example::new(dependence, move |_, at| Reduced {
        inertia: 1.0 + 0.3 * at.coordinate.cos(),
        inertia_derivative: -0.3 * at.coordinate.sin(),
        moment: steepness * (10.0 - at.speed) - 2.0 - at.coordinate.sin(),
    })
}
