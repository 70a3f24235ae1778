//! What motions are judged by: a closed form, or two tight runs of different methods that judge each other.

use std::rc::Rc;

use assur_integrator::{
    IntegratorPlugin, Motion, Piece, Request, Sample, State, Trajectory, Until, integrators,
};

use super::Task;
use crate::chart::ruler::greater;
use crate::chart::{ChartError, Reference};

/// Tolerances of a tight run, the first that succeeds.
const TIGHT: [f64; 4] = [1e-14, 1e-13, 1e-12, 1e-11];

/// Most steps of a tight run.
const MOST_STEPS: usize = 30_000;

/// The judges of a motion.
pub(in crate::chart) struct References {
    /// With the method's name; a closed form of this module has none.
    judges: Vec<(&'static str, Rc<Trajectory>)>,
    how: String,
    /// Their difference.
    error: f64,
    /// Greatest way and speed.
    pub(super) sizes: [f64; 2],
    /// How long the motion lasts, s.
    pub(super) duration: f64,
}

impl References {
    pub(in crate::chart) fn find(task: &Task<'_>) -> Result<Self, ChartError> {
        let mut runs = Vec::new();
        let exact = uniform(task);
        for plugin in candidates(task)? {
            if runs.len() == 2 {
                break;
            }
            runs.extend(tight(plugin, task));
        }
        let first = exact.as_ref().or(runs.first().map(|run| &run.2)).ok_or(ChartError::NoMotion)?;
        let (sizes, duration) = (sizes(first), first.end.time - task.request.initial.time);
        if let Some(exact) = exact {
            let how = "closed form of uniformly accelerated motion (D 3.12, 3.13)".to_owned();
            // A few roundings of f64.
            return Ok(Self { judges: vec![("", Rc::new(exact))], how, error: 1e-15, sizes, duration });
        }
        let error = match &runs[..] {
            [one, two] => deviation(&one.2, &two.2, sizes),
            _ => f64::NAN,
        };
        let names: Vec<String> =
            runs.iter().map(|run| format!("{} at tolerance {:.0e}", run.0, run.1)).collect();
        let how = format!(
            "{}; each judges all methods but itself; own error by their difference",
            names.join(" and ")
        );
        let judges = runs.into_iter().map(|(name, _, found)| (name, Rc::new(found))).collect();
        Ok(Self { judges, how, error: if error.is_nan() { 0.0 } else { error }, sizes, duration })
    }

    /// The first judge that is another method.
    pub(in crate::chart) fn judge_of(&self, method: &str) -> Option<Rc<Trajectory>> {
        self.judges.iter().find(|(name, _)| *name != method).map(|(_, found)| Rc::clone(found))
    }

    pub(super) fn described(&self) -> Reference {
        Reference { how: self.how.clone(), error: self.error }
    }
}

/// Methods for tight runs: the quadrature of the energy where it is one, then the highest orders.
fn candidates(task: &Task<'_>) -> Result<Vec<&'static IntegratorPlugin>, ChartError> {
    let dependence = task.motion.dependence();
    let mut all = integrators()?;
    all.retain(|plugin| plugin.supports(&dependence).is_ok());
    // Order 0 stands for "no error of steps in time".
    all.sort_by_key(|plugin| if plugin.order == 0 { 0 } else { u8::MAX - plugin.order });
    Ok(all)
}

fn tight(plugin: &'static IntegratorPlugin, task: &Task<'_>) -> Option<(&'static str, f64, Trajectory)> {
    TIGHT.into_iter().find_map(|tolerance| {
        let request = Request { tolerance, max_steps: MOST_STEPS, ..task.request };
        let found = plugin.solve(&mut task.motion.clone(), &request).ok()?;
        Some((plugin.name, tolerance, found))
    })
}

/// J and M constant over one piece: q = q0 + w0 t + e t²/2, w = w0 + e t.
fn uniform(task: &Task<'_>) -> Option<Trajectory> {
    let mut motion = task.motion.clone();
    let start = task.request.initial;
    if motion.dependence().case() != 1 || start.speed == 0.0 {
        return None;
    }
    let Piece { coordinate, time, .. } = motion.enter(&start).ok()?;
    let endless = |bounds: [f64; 2]| bounds[0].is_infinite() && bounds[1].is_infinite();
    let e = motion.acceleration(&start).ok().filter(|_| endless(coordinate) && endless(time))?;
    let w = start.speed;
    let duration = match task.request.until {
        Until::Time(end) => end - start.time,
        Until::Rest => -w / e,
        Until::Coordinate(end) => {
            // The root without cancellation.
            let way = end - start.coordinate;
            2.0 * way / (w + w.signum() * (w * w + 2.0 * e * way).sqrt())
        }
    };
    // Friction would hold it after a rest.
    let passes_rest = w * (w + e * duration) < -1e-9 * w * w;
    if duration.is_nan() || duration <= 0.0 || passes_rest {
        return None;
    }
    let samples = (0..=task.request.samples).map(|i| {
        let t = duration * i as f64 / task.request.samples as f64;
        Sample {
            time: start.time + t,
            coordinate: start.coordinate + t * (w + 0.5 * e * t),
            speed: w + e * t,
            acceleration: e,
        }
    });
    let samples: Vec<Sample> = samples.collect();
    let last = *samples.last()?;
    let end = State { time: last.time, coordinate: last.coordinate, speed: last.speed };
    Some(Trajectory { samples, end, ..Trajectory::default() })
}

/// Greatest way from the start, and greatest speed.
fn sizes(found: &Trajectory) -> [f64; 2] {
    let start = found.samples.first().map_or(0.0, |sample| sample.coordinate);
    let most = |of: &dyn Fn(&Sample) -> f64| found.samples.iter().map(of).fold(0.0, f64::max);
    let positive = |size: f64| if size > 0.0 { size } else { 1.0 };
    [positive(most(&|s| (s.coordinate - start).abs())), positive(most(&|s| s.speed.abs()))]
}

/// Largest deviation of coordinate and speed over the samples, relative to the sizes.
pub(super) fn deviation(found: &Trajectory, truth: &Trajectory, sizes: [f64; 2]) -> f64 {
    if found.samples.len() != truth.samples.len() {
        return f64::NAN;
    }
    let pairs = found.samples.iter().zip(&truth.samples);
    pairs.fold(0.0, |worst, (a, b)| {
        let way = (a.coordinate - b.coordinate).abs() / sizes[0];
        greater(worst, greater(way, (a.speed - b.speed).abs() / sizes[1]))
    })
}
