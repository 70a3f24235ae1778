//! Andrews' squeezing mechanism, reduced to its crank. Data: Test Set for IVP Solvers, problem "andrews"; Hairer,
//! Wanner II, VII.7.

use assur_integrator::{Dependence, EquationOfMotion, MotionError, Piece, Reduced, State};

type Vector = [f64; 2];

/// A point with its first two derivatives with respect to the coordinate.
type Point = [Vector; 3];

const B: Vector = [-0.03635, 0.03273];
const A: Vector = [-0.06934, -0.00227];
const C: Vector = [0.014, 0.072];

/// Time at which the published solution is given, s.
const END: f64 = 0.03;

/// The mechanism: a crank, driven by 0.033 N m, and three groups of two links.
#[derive(Debug, Clone, Copy, Default)]
pub struct Andrews;

impl Andrews {
    /// Rest at beta = -0.0617138900142764496.
    pub const START: State = State { time: 0.0, coordinate: -0.061_713_890_014_276_45, speed: 0.0 };
    /// Published solution at t = 0.03 s: beta = 15.81077119629904 rad.
    pub const END: State =
        State { time: END, coordinate: 15.810_771_196_299_04, speed: 1_139.920_302_151_208 };
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn fixed(at: Vector) -> Point {
    [at, [0.0; 2], [0.0; 2]]
}

/// Pin at distance `r1` from `p` and `r2` from `s`, left of the way from `p` to `s` for a positive `side`: the two
/// conditions (X-P)² = r1², (X-S)² = r2² and their derivatives.
fn pin(p: &Point, s: &Point, r1: f64, r2: f64, side: f64) -> Point {
    let d = minus(s[0], p[0]);
    let square = dot(d, d);
    let along = 0.5 * (square + r1 * r1 - r2 * r2) / square;
    let across = side * (r1 * r1 / square - along * along).sqrt();
    let x = [p[0][0] + along * d[0] - across * d[1], p[0][1] + along * d[1] + across * d[0]];
    let (u, v) = (minus(x, p[0]), minus(x, s[0]));
    let solve = |b1: f64, b2: f64| {
        let determinant = u[0] * v[1] - u[1] * v[0];
        [(b1 * v[1] - b2 * u[1]) / determinant, (u[0] * b2 - v[0] * b1) / determinant]
    };
    let first = solve(dot(u, p[1]), dot(v, s[1]));
    let bend = |a: Vector, k: &Point| {
        let relative = minus(first, k[1]);
        dot(a, k[2]) - dot(relative, relative)
    };
    [x, first, solve(bend(u, p), bend(v, s))]
}

/// Point of the body that carries `from` to `to` over `length`, at (x, y) of its frame; and its angular derivatives.
fn carried(from: &Point, to: &Point, length: f64, at: Vector) -> (Point, Vector) {
    let unit = |k: usize| {
        let d = minus(to[k], from[k]);
        [d[0] / length, d[1] / length]
    };
    let (e, e1, e2) = (unit(0), unit(1), unit(2));
    let normal = [-e[1], e[0]];
    let angular = [dot(normal, e1), dot(normal, e2)];
    let point = [(from[0], e), (from[1], e1), (from[2], e2)]
        .map(|(o, e)| [o[0] + at[0] * e[0] - at[1] * e[1], o[1] + at[0] * e[1] + at[1] * e[0]]);
    (point, angular)
}

/// Adds a body to J and J'.
fn add(sum: &mut Reduced, mass: f64, inertia: f64, (center, angular): (Point, Vector)) {
    sum.inertia += mass * dot(center[1], center[1]) + inertia * angular[0] * angular[0];
    sum.inertia_derivative += 2.0 * (mass * dot(center[1], center[2]) + inertia * angular[0] * angular[1]);
}

impl EquationOfMotion for Andrews {
    fn dependence(&self) -> Dependence {
        crate::VARIABLE
    }

    fn enter(&mut self, _: &State) -> Result<Piece, MotionError> {
        Ok(Piece::UNBOUNDED)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let (sin, cos) = state.coordinate.sin_cos();
        let f = [[cos, sin], [-sin, cos], [-cos, -sin]].map(|[x, y]| [0.007 * x, 0.007 * y]);
        let (a, b) = (fixed(A), fixed(B));
        let e = pin(&f, &b, 0.028, 0.035, 1.0);
        let g = pin(&e, &a, 0.02, 0.04, -1.0);
        let h = pin(&e, &a, 0.02, 0.04, 1.0);
        let mut sum = Reduced { inertia: 0.0, inertia_derivative: 0.0, moment: 0.033 };
        let origin = fixed([0.0; 2]);
        add(&mut sum, 0.043_25, 2.194e-6, carried(&origin, &f, 0.007, [0.000_92, 0.0]));
        // From here on the x axis of `carried` runs from the first pin to the second.
        add(&mut sum, 0.003_65, 4.410e-7, carried(&f, &e, 0.028, [0.0115, 0.0]));
        // Frame of K3: E lies on its -y axis, so that its x axis is the way from B to E turned by +90 degrees.
        add(&mut sum, 0.023_73, 5.255e-6, carried(&b, &e, 0.035, [0.018_74, 0.010_43]));
        add(&mut sum, 0.007_06, 5.667e-7, carried(&g, &e, 0.02, [0.005_79, 0.0]));
        add(&mut sum, 0.070_50, 1.169e-5, carried(&a, &g, 0.04, [0.023_08, 0.009_16]));
        add(&mut sum, 0.007_06, 5.667e-7, carried(&h, &e, 0.02, [0.005_79, 0.0]));
        add(&mut sum, 0.054_98, 1.912e-5, carried(&a, &h, 0.04, [0.012_28, 0.004_49]));
        let (d, _) = carried(&b, &e, 0.035, [0.018, 0.02]);
        let spring = minus(C, d[0]);
        let length = dot(spring, spring).sqrt();
        sum.moment += 4530.0 * (length - 0.077_85) / length * dot(spring, d[1]);
        Ok(sum)
    }
}
