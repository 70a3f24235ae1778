//! Families of equations of motion, with data drawn from a seed.

use assur_integrator::{Dependence, EquationOfMotion, MotionError, Piece, Reduced, State, Until};
use assur_problems::{CONSTANT, Example};
use assur_testkit::Rng;

/// A motion to be found.
pub(crate) struct Case {
    pub(crate) family: &'static str,
    pub(crate) motion: Box<dyn Fn() -> Box<dyn EquationOfMotion>>,
    pub(crate) initial: State,
    pub(crate) until: Until,
    /// The end, where a formula gives it.
    pub(crate) exact: Option<State>,
}

/// The families; a case of each is drawn from a generator.
pub(crate) const FAMILIES: [fn(&mut Rng) -> Case; 10] = [
    driven_oscillator,
    relaxation,
    pendulum,
    harmonics,
    kloss_run_up,
    kloss_with_variable_inertia,
    steep_line,
    stroke_damper,
    jumps_and_friction,
    table_over_time,
];

fn case(
    family: &'static str,
    motion: impl Fn() -> Box<dyn EquationOfMotion> + 'static,
    (coordinate, speed): (f64, f64),
    end: f64,
) -> Case {
    let initial = State { time: 0.0, coordinate, speed };
    Case { family, motion: Box::new(motion), initial, until: Until::Time(end), exact: None }
}

fn reduced(inertia: f64, moment: f64) -> Reduced {
    Reduced { inertia, inertia_derivative: 0.0, moment }
}

/// J constant and M(q, w, t).
const OSCILLATOR: Dependence =
    Dependence { moment_on_coordinate: true, moment_on_speed: true, moment_on_time: true, ..CONSTANT };

/// J(q) and M(q, w).
const MACHINE: Dependence = Dependence { inertia_constant: false, moment_on_time: false, ..OSCILLATOR };

/// w' + 2 d w + k q = f cos(p t): the steady part by complex numbers written out, the rest decays.
fn driven_oscillator(rng: &mut Rng) -> Case {
    let (k, f, p) = (rng.range(0.5, 20.0), rng.range(0.0, 5.0), rng.range(0.3, 6.0));
    let d = rng.range(0.0, 0.9) * k.sqrt();
    let (q0, w0, t) = (rng.signed(0.0, 2.0), rng.signed(0.0, 3.0), rng.range(0.5, 12.0));
    let divisor = (k - p * p).powi(2) + (2.0 * d * p).powi(2);
    let (a, b) = (f * (k - p * p) / divisor, f * 2.0 * d * p / divisor);
    let n = (k - d * d).sqrt();
    let (c, s) = (q0 - a, (w0 - b * p + d * (q0 - a)) / n);
    let (sin, cos) = (n * t).sin_cos();
    let decay = (-d * t).exp();
    let free = decay * (c * cos + s * sin);
    let free_speed = decay * n * (s * cos - c * sin) - d * free;
    let exact = State {
        time: t,
        coordinate: a * (p * t).cos() + b * (p * t).sin() + free,
        speed: p * (b * (p * t).cos() - a * (p * t).sin()) + free_speed,
    };
    let motion = move || -> Box<dyn EquationOfMotion> {
        Box::new(Example::new(OSCILLATOR, move |_, at| {
            reduced(2.0, 2.0 * (f * (p * at.time).cos() - 2.0 * d * at.speed - k * at.coordinate))
        }))
    };
    Case { exact: Some(exact), ..case("driven oscillator", motion, (q0, w0), t) }
}

/// w' + (a + b) w + a b q = 0 with a far above b: stiff, q = C1 exp(-a t) + C2 exp(-b t).
fn relaxation(rng: &mut Rng) -> Case {
    let (a, b) = (10.0_f64.powf(rng.range(1.0, 3.5)), rng.range(0.1, 3.0));
    let (q0, w0, t) = (rng.signed(0.5, 2.0), rng.signed(0.0, 4.0), rng.range(0.5, 3.0));
    let c1 = -(w0 + b * q0) / (a - b);
    let c2 = q0 - c1;
    let (fast, slow) = (c1 * (-a * t).exp(), c2 * (-b * t).exp());
    let exact = State { time: t, coordinate: fast + slow, speed: -a * fast - b * slow };
    let motion = move || -> Box<dyn EquationOfMotion> {
        let dependence = Dependence { moment_on_time: false, ..OSCILLATOR };
        Box::new(Example::new(dependence, move |_, at| {
            reduced(0.5, -0.5 * ((a + b) * at.speed + a * b * at.coordinate))
        }))
    };
    Case { exact: Some(exact), ..case("relaxation", motion, (q0, w0), t) }
}

fn pendulum(rng: &mut Rng) -> Case {
    let start = (rng.angle(), rng.signed(0.0, 3.0));
    case("pendulum", || Box::new(assur_problems::pendulum()), start, rng.range(0.5, 15.0))
}

/// J and M with harmonics of the coordinate, and a fan.
fn harmonics(rng: &mut Rng) -> Case {
    let h: Vec<f64> = (0..9).map(|_| rng.signed(0.0, 1.0)).collect();
    let fan = rng.range(0.0, 0.5);
    let motion = move || -> Box<dyn EquationOfMotion> {
        let h = h.clone();
        Box::new(Example::new(MACHINE, move |_, at| {
            let (q, w) = (at.coordinate, at.speed);
            Reduced {
                inertia: 2.5 + h[0] * q.cos() + h[1] * (2.0 * q + h[2]).sin(),
                inertia_derivative: -h[0] * q.sin() + 2.0 * h[1] * (2.0 * q + h[2]).cos(),
                moment: 3.0 * h[3] + 4.0 * h[4] * (q + h[5]).sin() + 2.0 * h[6] * (3.0 * q + h[7]).cos()
                    - fan * w * w.abs(),
            }
        }))
    };
    case("harmonics", motion, (rng.angle(), rng.signed(0.5, 6.0)), rng.range(0.5, 6.0))
}

/// Kloss's formula, positive towards positive speed.
fn kloss(breakdown: f64, critical: f64, synchronous: f64, speed: f64) -> f64 {
    let slip = 1.0 - speed / synchronous;
    2.0 * breakdown * critical * slip / (slip * slip + critical * critical)
}

/// A motor runs up against a constant load and a fan: M(w).
fn kloss_run_up(rng: &mut Rng) -> Case {
    let (top, critical, speed) = (rng.range(20.0, 80.0), rng.range(0.05, 0.4), rng.range(20.0, 160.0));
    let (inertia, load) = (rng.range(0.05, 2.0), rng.range(0.0, 0.5) * top * critical);
    let fan = rng.range(0.0, 0.3) * top / (speed * speed);
    let motion = move || -> Box<dyn EquationOfMotion> {
        let dependence = Dependence { moment_on_speed: true, ..CONSTANT };
        Box::new(Example::new(dependence, move |_, at| {
            let w = at.speed;
            reduced(inertia, kloss(top, critical, speed, w) - load - fan * w * w.abs())
        }))
    };
    let scale = inertia * speed / (top * critical);
    let start = (0.0, rng.range(0.0, 0.9) * speed);
    case("Kloss run-up", motion, start, rng.range(0.2, 3.0) * scale)
}

/// A motor on a crank with variable inertia and a load over the coordinate.
fn kloss_with_variable_inertia(rng: &mut Rng) -> Case {
    let (top, critical, speed) = (rng.range(20.0, 200.0), rng.range(0.05, 0.3), rng.range(5.0, 40.0));
    let (inertia, swing) = (rng.range(0.3, 3.0), rng.range(0.1, 0.8));
    let (load, wave) = (rng.range(0.0, 0.4) * top * critical, rng.range(0.0, 0.5) * top * critical);
    let motion = move || -> Box<dyn EquationOfMotion> {
        Box::new(Example::new(MACHINE, move |_, at| {
            let (q, w) = (at.coordinate, at.speed);
            Reduced {
                inertia: inertia * (1.0 + swing * (2.0 * q).cos()),
                inertia_derivative: -2.0 * inertia * swing * (2.0 * q).sin(),
                moment: kloss(top, critical, speed, w) - load - wave * q.sin(),
            }
        }))
    };
    case("Kloss, J(q)", motion, (0.0, rng.range(0.0, 1.0) * speed), rng.range(0.3, 4.0))
}

/// A motor with a steep working line: stiff.
fn steep_line(rng: &mut Rng) -> Case {
    let steepness = 10.0_f64.powf(rng.range(0.5, 3.5));
    let start = (rng.angle(), rng.range(0.0, 12.0));
    case("steep line", move || Box::new(assur_problems::motor(steepness)), start, rng.range(0.2, 2.0))
}

/// A damper and a spring on a slide that the crank moves: both are felt by the square of the transfer function, which
/// vanishes at the dead centers.
fn stroke_damper(rng: &mut Rng) -> Case {
    let damping = 10.0_f64.powf(rng.range(0.0, 3.3));
    let (stiffness, arm) = (rng.range(0.0, 100.0), rng.range(0.1, 0.9));
    let weight = rng.signed(0.0, 10.0);
    let motion = move || -> Box<dyn EquationOfMotion> {
        Box::new(Example::new(MACHINE, move |_, at| {
            let (sin, cos) = at.coordinate.sin_cos();
            // x = cos q + arm sin² q.
            let slope = -sin + 2.0 * arm * sin * cos;
            let bend = -cos + 2.0 * arm * (cos * cos - sin * sin);
            let shift = cos + arm * sin * sin - 1.2;
            Reduced {
                inertia: 0.5 + slope * slope,
                inertia_derivative: 2.0 * slope * bend,
                moment: -(damping * slope * at.speed + stiffness * shift) * slope - weight * cos,
            }
        }))
    };
    case("damper on a stroke", motion, (rng.angle(), rng.signed(0.0, 6.0)), rng.range(0.5, 4.0))
}

/// Moments that jump along the coordinate, with dry friction and a spring.
fn jumps_and_friction(rng: &mut Rng) -> Case {
    let moments: Vec<f64> = (0..6).map(|_| rng.signed(0.0, 2.0)).collect();
    let (friction, damping) = (rng.range(0.05, 0.5), rng.range(0.0, 0.2));
    let motion = move || -> Box<dyn EquationOfMotion> {
        let moments = moments.clone();
        let example = Example::new(MACHINE, move |place, at| Reduced {
            inertia: 1.5 + at.coordinate.cos(),
            inertia_derivative: -at.coordinate.sin(),
            moment: moments[place.segment]
                - friction * place.direction
                - damping * at.speed
                - 0.5 * at.coordinate,
        });
        Box::new(example.with_breaks(vec![-1.3, -0.4, 0.2, 1.1, 2.5]).directed())
    };
    case("jumps and friction", motion, (0.5, rng.signed(0.5, 5.0)), rng.range(0.5, 8.0))
}

/// A moment by rows over time that jumps between them, with a fan.
struct Table {
    rows: Vec<[f64; 2]>,
    fan: f64,
    row: usize,
}

impl EquationOfMotion for Table {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_coordinate: false, ..OSCILLATOR }
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.row = self.rows.partition_point(|row| row[0] <= state.time) - 1;
        let end = self.rows.get(self.row + 1).map_or(f64::INFINITY, |row| row[0]);
        Ok(Piece { time: [self.rows[self.row][0], end], ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let [start, moment] = self.rows[self.row];
        let w = state.speed;
        Ok(reduced(1.0, moment * (1.0 + state.time - start) - self.fan * w * w.abs()))
    }
}

fn table_over_time(rng: &mut Rng) -> Case {
    let rows: Vec<[f64; 2]> =
        (0..5).map(|k| [f64::from(k) * rng.range(0.5, 0.9), rng.signed(0.5, 4.0)]).collect();
    let mut rows = rows;
    rows.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let fan = rng.range(0.0, 0.4);
    let motion = move || -> Box<dyn EquationOfMotion> { Box::new(Table { rows: rows.clone(), fan, row: 0 }) };
    case("table over time", motion, (0.0, rng.signed(0.0, 3.0)), rng.range(0.5, 4.0))
}
