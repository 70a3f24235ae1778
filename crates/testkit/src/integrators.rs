//! The conformance suite of integrators: equations with known answers, the declared order, samples, events.

use std::f64::consts::{PI, SQRT_2};

use assur_integrator::{
    EquationOfMotion, FixedStep, IntegrationError, IntegratorPlugin, Knob, Request, State, Trajectory, Until,
};
use assur_problems as problems;

use crate::Fault;

/// The error that a method with control of its error may leave, in tolerances: errors of steps add up over a motion.
const TOLERANCES: f64 = 1e4;
/// The error that a method at its usual fixed step, a thousandth of the motion, may leave: so many times that step to its order.
const AT_FIXED_STEP: f64 = 10.0;
/// What a declared order may differ from that of the errors at two steps.
const ORDER: f64 = 0.3;

/// A motion whose end is known.
struct Problem {
    name: &'static str,
    motion: fn() -> Box<dyn EquationOfMotion>,
    initial: State,
    until: Until,
    /// What of the end is known, and the wanted value.
    known: fn(&State) -> Vec<[f64; 2]>,
}

const PROBLEMS: [Problem; 5] = [
    Problem {
        name: "a brake stops a disc",
        motion: || Box::new(problems::d1()),
        initial: State { time: 0.0, coordinate: 0.0, speed: 100.0 },
        until: Until::Turn,
        known: |end| vec![[end.time, 50.0], [end.coordinate, 2500.0]],
    },
    Problem {
        name: "run-up over five turns",
        motion: || Box::new(problems::e1()),
        initial: State { time: 0.0, coordinate: 0.0, speed: 0.0 },
        until: Until::Coordinate(10.0 * PI),
        known: |end| vec![[end.speed, (1000.0 * PI).sqrt()]],
    },
    Problem {
        name: "jumps of the moment",
        motion: || Box::new(problems::jumps()),
        initial: State { time: 0.0, coordinate: 0.0, speed: 0.0 },
        until: Until::Coordinate(3.0),
        known: |end| {
            vec![[end.time, 3.0 - SQRT_2 + (10.0_f64.sqrt() - SQRT_2) / 4.0], [end.speed, 10.0_f64.sqrt()]]
        },
    },
    Problem {
        name: "dry friction to rest",
        motion: || Box::new(problems::d1_friction()),
        initial: State { time: 0.0, coordinate: 0.0, speed: 100.0 },
        until: Until::Rest,
        known: |end| vec![[end.time, 50.0], [end.coordinate, 2500.0]],
    },
    Problem {
        name: "coasting with variable inertia",
        motion: || Box::new(problems::coasting()),
        initial: State { time: 0.0, coordinate: 0.0, speed: 2.0 },
        until: Until::Coordinate(PI),
        // J w^2 is kept: 3 * 4 = 1 * w^2.
        known: |end| vec![[end.speed, 12.0_f64.sqrt()]],
    },
];

/// Tests a registered integrator with the whole suite, and returns a failure as a value.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_integrator(name: &str) -> Result<(), Fault> {
    let plugin = assur_integrator::find(name).map_err(|error| Fault::of_entry("registry", error))?;
    judge_method(plugin)
}

/// Tests the entry of an integrator with the whole suite.
///
/// # Errors
///
/// The first [`Fault`] found.
pub fn judge_method(plugin: &IntegratorPlugin) -> Result<(), Fault> {
    let mut tried = 0;
    for problem in &PROBLEMS {
        let mut motion = (problem.motion)();
        if plugin.supports(&motion.dependence()).is_err() {
            continue;
        }
        let request = Request { samples: 7, ..Request::new(problem.initial, problem.until) };
        let found = match plugin.solve(&mut *motion, &request) {
            Ok(found) => found,
            // Some methods find out only during the motion that they don't support an equation.
            Err(IntegrationError::Unsupported { .. }) => continue,
            Err(error) => return Err(Fault::of_entry("solve", format!("{}: {error}", problem.name))),
        };
        tried += 1;
        answers(plugin, problem, &found)?;
        samples(problem, &request, &found)?;
        let again = plugin.solve(&mut *(problem.motion)(), &request);
        if again.map(|again| again.end).ok() != Some(found.end) {
            return Err(Fault::of_entry(
                "repeated",
                format!("{}: a second run has another end", problem.name),
            ));
        }
    }
    if tried == 0 {
        return Err(Fault::of_entry("problems", "the method supports no equation of the suite"));
    }
    order(plugin)?;
    refusals(plugin)
}

fn answers(plugin: &IntegratorPlugin, problem: &Problem, found: &Trajectory) -> Result<(), Fault> {
    let most = match plugin.knob {
        Knob::None => 1e-12,
        Knob::Tolerance => 1e-9 * TOLERANCES,
        Knob::Step => (AT_FIXED_STEP * 1e-3_f64.powi(i32::from(plugin.order))).max(1e-9),
    };
    for [value, wanted] in (problem.known)(&found.end) {
        let error = (value / wanted - 1.0).abs();
        if error.is_nan() || error > most {
            let what =
                format!("{}: {value} is not {wanted}, off by {error:.1e}, allowed {most:.1e}", problem.name);
            return Err(Fault::of_entry("answers", what));
        }
    }
    Ok(())
}

/// Samples are equally spaced from the start to the end, and each is on the way between.
fn samples(problem: &Problem, request: &Request, found: &Trajectory) -> Result<(), Fault> {
    let wrong = |what: String| Err(Fault::of_entry("samples", format!("{}: {what}", problem.name)));
    if found.samples.len() != request.samples + 1 {
        return wrong(format!("{} instants, wanted {}", found.samples.len(), request.samples + 1));
    }
    let times: Vec<f64> = found.samples.iter().map(|sample| sample.time).collect();
    let step = (found.end.time - request.initial.time) / request.samples as f64;
    for (index, time) in times.iter().enumerate() {
        let wanted = request.initial.time + step * index as f64;
        if (time - wanted).abs() > 1e-9 * found.end.time {
            return wrong(format!("instant {index} is at {time} s, wanted {wanted} s"));
        }
    }
    let between = found.samples.windows(2).all(|two| two[1].coordinate >= two[0].coordinate);
    if between { Ok(()) } else { wrong("the coordinate goes back between two instants".to_owned()) }
}

/// The error at half the step, or at a smaller tolerance, is smaller as declared.
fn order(plugin: &IntegratorPlugin) -> Result<(), Fault> {
    if plugin.knob == Knob::None || plugin.supports(&problems::pendulum().dependence()).is_err() {
        return Ok(());
    }
    let period = problems::pendulum_period(1.0);
    // A quarter of the period: at its end the pendulum passes the lowest point, with a speed known by the energy.
    let (end, wanted) = (period / 4.0, (2.0 * (1.0 - 1.0_f64.cos())).sqrt());
    let initial = State { time: 0.0, coordinate: 1.0, speed: 0.0 };
    let error = |tolerance: f64, parts: f64| {
        let fixed_step = (plugin.knob == Knob::Step).then_some(FixedStep::Time(end / parts));
        let request = Request { tolerance, fixed_step, ..Request::new(initial, Until::Time(end)) };
        let found = plugin.solve(&mut problems::pendulum(), &request);
        let found = found.map_err(|error| Fault::of_entry("order", error))?;
        Ok::<f64, Fault>((found.end.coordinate / wanted).abs().max((found.end.speed / wanted + 1.0).abs()))
    };
    if plugin.knob == Knob::Step {
        let found = (error(1e-9, 40.0)? / error(1e-9, 80.0)?).log2();
        let declared = f64::from(plugin.order);
        if found.is_nan() || found < declared - ORDER {
            return Err(Fault::of_entry(
                "order",
                format!("the errors at two steps have order {found:.2}, declared {declared}"),
            ));
        }
        return Ok(());
    }
    for tolerance in [1e-4, 1e-7, 1e-10] {
        let found = error(tolerance, 1.0)?;
        if found.is_nan() || found > TOLERANCES * tolerance {
            return Err(Fault::of_entry("order", format!("error {found:.1e} at tolerance {tolerance:.0e}")));
        }
    }
    Ok(())
}

/// An equation without a value is an error, and so is a motion that never comes to its end.
fn refusals(plugin: &IntegratorPlugin) -> Result<(), Fault> {
    let nothing = || {
        problems::Example::new(problems::CONSTANT, |_, _| assur_integrator::Reduced {
            inertia: 1.0,
            inertia_derivative: 0.0,
            moment: f64::NAN,
        })
    };
    if plugin.supports(&problems::CONSTANT).is_err() {
        return Ok(());
    }
    let request = Request::new(State { time: 0.0, coordinate: 0.0, speed: 1.0 }, Until::Coordinate(1.0));
    if let Ok(found) = plugin.solve(&mut nothing(), &request) {
        return Err(Fault::of_entry("refusals", format!("a moment that is no number gives {:?}", found.end)));
    }
    let never = Request {
        time_limit: 200.0,
        ..Request::new(State { time: 0.0, coordinate: 0.0, speed: 100.0 }, Until::Coordinate(2501.0))
    };
    match plugin.solve(&mut problems::d1_friction(), &never) {
        Ok(found) => {
            Err(Fault::of_entry("refusals", format!("an end that is never reached gives {:?}", found.end)))
        }
        Err(_) => Ok(()),
    }
}
