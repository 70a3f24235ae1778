//! The equation of motion as an integrator sees it: J(q) w' + J'(q) w²/2 = Q(q, w, t), q' = w (D 3.11).

use assur_words::{Describe, Text, list, name, number, text};

/// What the reduced inertia J and the reduced moment Q depend on: D's classification (D 3.21).
///
/// A dependence on the *sign* of the speed alone (dry friction, loads against the motion) does not count as a
/// dependence on the speed: inside a [`Piece`] bounded by w = 0 it is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[expect(clippy::struct_excessive_bools, reason = "independent questions about the equation")]
pub struct Dependence {
    /// J does not depend on the coordinate.
    pub inertia_constant: bool,
    /// Q depends on the coordinate.
    pub moment_on_coordinate: bool,
    /// Q depends on the size of the speed.
    pub moment_on_speed: bool,
    /// Q depends on time.
    pub moment_on_time: bool,
    /// Q depends on the acceleration, through the inertia loads on which dry friction depends; with it on coordinate and speed.
    pub moment_on_acceleration: bool,
    /// Q changes where several variables together make it, so that [`EquationOfMotion::holds`] is asked for the end of a piece.
    pub moment_switches: bool,
}

impl Dependence {
    /// D's case, 1 to 5 (D 3.21): 1 J and M constant; 2 J constant, M of one variable; 3 J(q), M(q) or constant;
    /// 4 J constant, M of several variables; 5 everything else.
    pub fn case(&self) -> u8 {
        let variables = usize::from(self.moment_on_coordinate)
            + usize::from(self.moment_on_speed)
            + usize::from(self.moment_on_time);
        match (self.inertia_constant, variables) {
            (true, 0) => 1,
            (true, 1) => 2,
            (true, _) => 4,
            (false, _) if self.moment_on_speed || self.moment_on_time => 5,
            (false, _) => 3,
        }
    }
}

/// As `J(q), M(q, w)`.
impl Describe for Dependence {
    fn describe(&self) -> Text {
        let variables = [
            (self.moment_on_coordinate, "q"),
            (self.moment_on_speed, "w"),
            (self.moment_on_time, "t"),
            (self.moment_on_acceleration, "e"),
        ];
        let variables: Vec<&str> =
            variables.iter().filter_map(|(depends, name)| depends.then_some(*name)).collect();
        let inertia = if self.inertia_constant { text!("integrator-inertia-constant") } else { name("J(q)") };
        let moment = match variables.as_slice() {
            [] => text!("integrator-moment-constant"),
            variables => name(format!("M({})", variables.join(", "))),
        };
        list([inertia, moment])
    }
}

/// A state of the motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct State {
    /// Time t, s.
    pub time: f64,
    /// Input coordinate q, rad (m for a sliding input).
    pub coordinate: f64,
    /// Input speed w = dq/dt, rad/s (m/s).
    pub speed: f64,
}

impl State {
    /// The state at a later time if the speed stays.
    #[must_use]
    pub fn coasting_until(&self, time: f64) -> Self {
        Self { time, coordinate: self.coordinate + self.speed * (time - self.time), ..*self }
    }
}

impl Describe for State {
    fn describe(&self) -> Text {
        // Nine decimals of a greater number are not known.
        let shown = |value: f64| {
            if value.abs() < 1e7 { number(format_args!("{value:.9}")) } else { scientific(value) }
        };
        text!(
            "integrator-state",
            time = shown(self.time),
            coordinate = shown(self.coordinate),
            speed = shown(self.speed)
        )
    }
}

/// A quantity of an error in scientific notation, unless it has outgrown all numbers or followed from one that has.
fn scientific(value: f64) -> Text {
    if value.is_finite() { number(format_args!("{value:e}")) } else { text!("integrator-out-of-range") }
}

/// The coefficients of the equation at one state.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Reduced<T = f64> {
    /// J, kg m² (kg). Positive.
    pub inertia: T,
    /// dJ/dq, kg m²/rad (kg/m).
    pub inertia_derivative: T,
    /// Q, N m (N), positive along the coordinate.
    pub moment: T,
}

impl Reduced {
    /// Acceleration e = (Q - J' w²/2)/J (D 3.11), rad/s².
    ///
    /// # Errors
    ///
    /// [`MotionError::Inertia`] if J is not positive; [`MotionError::NotFinite`] if the result is not a number.
    #[inline]
    pub fn acceleration(&self, speed: f64) -> Result<f64, MotionError> {
        if self.inertia <= 0.0 {
            return Err(MotionError::Inertia(self.inertia));
        }
        let acceleration = (self.moment - 0.5 * self.inertia_derivative * speed * speed) / self.inertia;
        if acceleration.is_finite() {
            return Ok(acceleration);
        }
        Err(MotionError::NotFinite { inertia: self.inertia, moment: self.moment })
    }
}

/// Partial derivatives of the acceleration, for implicit methods.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Partials {
    /// de/dq, 1/s².
    pub by_coordinate: f64,
    /// de/dw, 1/s.
    pub by_speed: f64,
}

/// The bounds of the states in which the equation is one smooth formula: between the rows of tables, while the stroke
/// keeps its direction, inside or outside a contact. Infinite where unbounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Bounds of the coordinate, rad (m).
    pub coordinate: [f64; 2],
    /// Bounds of the speed, rad/s (m/s).
    pub speed: [f64; 2],
    /// Bounds of the time, s.
    pub time: [f64; 2],
}

impl Piece {
    /// No bounds: one formula everywhere.
    pub const UNBOUNDED: Self = Self {
        coordinate: [f64::NEG_INFINITY, f64::INFINITY],
        speed: [f64::NEG_INFINITY, f64::INFINITY],
        time: [f64::NEG_INFINITY, f64::INFINITY],
    };
}

/// A stretch of a motion, in bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Bounds of the states in it.
    pub states: Piece,
    /// Bounds of the acceleration, rad/s² (m/s²).
    pub acceleration: [f64; 2],
    /// The state at its end.
    pub end: State,
}

impl Stretch {
    /// A single state.
    pub fn at(end: State) -> Self {
        let [time, coordinate, speed] = [end.time, end.coordinate, end.speed].map(|value| [value; 2]);
        Self { states: Piece { coordinate, speed, time }, acceleration: [0.0; 2], end }
    }
}

/// The equation of motion of a mechanism with one degree of freedom.
///
/// Required: what it depends on, its pieces, its coefficients.
pub trait EquationOfMotion {
    /// What J and Q depend on, over all pieces.
    fn dependence(&self) -> Dependence;

    /// Chooses the smooth piece that holds the states just after `state` in the direction of motion, and returns
    /// its bounds. Later calls of [`reduced`](Self::reduced) use the formulas of that piece, continued
    /// smoothly beyond its bounds (a step tries states outside), until the next `enter`.
    ///
    /// The direction along the coordinate is the sign of the speed. The driver never enters a piece at rest, but tries
    /// both sides, with the least positive and the least negative speed, and takes the side whose acceleration points
    /// to that side; if neither does, the mechanism stays at rest (dry friction). A bound of the speed is treated
    /// alike. A bound at which the formula jumps must be given as a bound of the piece; a mere kink should be.
    fn enter(&mut self, state: &State) -> Result<Piece, MotionError>;

    /// Whether the formulas entered last hold throughout a stretch of a motion, at the beginning of which they do, apart from
    /// the bounds of the piece: `Some(false)` where they end at one place in it, `None` where the stretch is too long to tell.
    fn holds(&self, stretch: &Stretch) -> Option<bool> {
        let _ = stretch;
        Some(true)
    }

    /// J, dJ/dq and Q at `state`.
    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError>;

    /// Acceleration e at `state`, rad/s² (m/s²), computed from [`reduced`](Self::reduced).
    #[inline]
    fn acceleration(&mut self, state: &State) -> Result<f64, MotionError> {
        self.reduced(state)?.acceleration(state.speed)
    }

    /// Numbers whose change of sign gives the equation a kink inside a piece, so that a step should end there: of an equation whose
    /// moment depends on the acceleration, the forces whose magnitude gives friction. None by default.
    fn bends(&mut self, state: &State) -> Result<Vec<f64>, MotionError> {
        let _ = state;
        Ok(Vec::new())
    }

    /// Partial derivatives of the acceleration, where the equation knows them; with `None` (the default) an implicit
    /// method uses finite differences.
    fn partials(&mut self, state: &State) -> Result<Option<Partials>, MotionError> {
        let _ = state;
        Ok(None)
    }
}

/// Why the equation has no value at a state.
#[derive(Clone)]
pub enum MotionError {
    /// The reduced inertia is zero or negative, kg m² (kg).
    Inertia(f64),
    /// The acceleration is not a number.
    NotFinite {
        /// Reduced inertia, kg m² (kg).
        inertia: f64,
        /// Reduced moment, N m (N).
        moment: f64,
    },
    /// The coordinate has outgrown all numbers, or followed from one that has.
    OutOfRange,
    /// The mechanism of the equation failed: no assembly, singular position.
    Mechanism(Text),
    /// Dry friction leaves no acceleration possible, or several.
    Undetermined(Text),
}

assur_words::errors!(MotionError);

impl Describe for MotionError {
    fn describe(&self) -> Text {
        match self {
            Self::Inertia(inertia) => {
                text!("integrator-inertia-not-positive", inertia = scientific(*inertia))
            }
            Self::NotFinite { inertia, moment } => text!(
                "integrator-acceleration-not-finite",
                inertia = scientific(*inertia),
                moment = scientific(*moment)
            ),
            Self::OutOfRange => text!("integrator-coordinate-out-of-range"),
            Self::Mechanism(error) | Self::Undetermined(error) => error.clone(),
        }
    }
}

impl MotionError {
    /// Wraps an error of the layer that holds the mechanism.
    pub fn mechanism(error: &impl Describe) -> Self {
        Self::Mechanism(error.describe())
    }
}
