//! The reference of motions: two solutions at tight tolerances by different methods, each the reference of the other.

use std::rc::Rc;

use assur_integrator::{EquationOfMotion, IntegratorPlugin, Request, Sample, Trajectory, integrators};
use assur_number::greater;
use assur_words::{name, number, text};

use super::Task;
use crate::chart::{ChartError, Reference};

/// Tolerances of a tight run, the first that succeeds.
const TIGHT: [f64; 4] = [1e-14, 1e-13, 1e-12, 1e-11];

const MOST_STEPS: usize = 30_000;

pub(in crate::chart) struct References {
    judges: Vec<(&'static str, Rc<Trajectory>)>,
    pub(super) reference: Reference,
    /// Greatest distance from the start and greatest speed.
    pub(super) sizes: [f64; 2],
    /// How long the motion lasts, s.
    pub(super) duration: f64,
}

impl References {
    pub(in crate::chart) fn find(task: &Task<'_>) -> Result<Self, ChartError> {
        let mut runs = Vec::new();
        for plugin in candidates(task)? {
            if runs.len() == 2 {
                break;
            }
            runs.extend(tight(plugin, task));
        }
        let first = &runs.first().ok_or(ChartError::NoMotion)?.2;
        let (sizes, duration) = (sizes(first), first.end.time - task.request.initial.time);
        let error = match &runs[..] {
            [one, two] => deviation(&one.2, &two.2, sizes),
            _ => f64::NAN,
        };
        let by = |run: &(&'static str, f64, Trajectory)| {
            let tolerance = number(format_args!("{:.0e}", run.1));
            text!("chart-reference-method", method = name(run.0), tolerance)
        };
        let methods = match &runs[..] {
            [one, other] => text!("chart-reference-methods", one = by(one), other = by(other)),
            _ => by(&runs[0]),
        };
        let how = text!("chart-reference-motion", methods);
        let reference = Reference { how, error: if error.is_nan() { 0.0 } else { error } };
        let judges = runs.into_iter().map(|(name, _, found)| (name, Rc::new(found))).collect();
        Ok(Self { judges, reference, sizes, duration })
    }

    /// The first reference by another method.
    pub(in crate::chart) fn judge_of(&self, method: &str) -> Option<Rc<Trajectory>> {
        self.judges.iter().find(|(name, _)| *name != method).map(|(_, found)| Rc::clone(found))
    }
}

/// Methods for tight tolerances: the quadrature of the energy if it applies, then the highest orders.
fn candidates(task: &Task<'_>) -> Result<Vec<&'static IntegratorPlugin>, ChartError> {
    let dependence = task.motion.dependence();
    let mut all = integrators()?;
    all.retain(|plugin| plugin.supports(&dependence).is_ok());
    // Order 0 means: no discretization error in time.
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

/// Greatest distance from the start, and greatest speed.
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
        let distance = (a.coordinate - b.coordinate).abs() / sizes[0];
        greater(worst, greater(distance, (a.speed - b.speed).abs() / sizes[1]))
    })
}
