//! The flywheel for a wanted unevenness: the methods of the textbooks, and the exact one.

use std::hint::black_box;

use assur_dynamics::{RegimeSolver, steady};
use assur_integrator::{EquationOfMotion, Request};
use assur_mechanism::{FlywheelPlace, Motion, Solve};
use assur_words::{name, number, text};

use super::{Cycle, settling::stepping};
use crate::chart::race::{Entry, Field, Verdict};
use crate::chart::{Measurement, Reference, Setting, Stage};

/// Samples over the cycle from which the extremes of the speed are read.
const SAMPLES: usize = 4000;

const TIGHT: f64 = 1e-13;

/// All methods; `None` if no flywheel is to be found.
pub(crate) fn field<'a>(cycle: &'a Cycle<'a>) -> Option<Field<'a>> {
    let drive = cycle.linkage.mechanism.drive.as_ref()?;
    let Some(Motion::Steady { unevenness: Some(Solve::Given(wanted)), .. }) = cycle.linkage.mechanism.motion
    else {
        return None;
    };
    if drive.flywheel != Some(Solve::Wanted) || cycle.regime.flywheel <= 0.0 {
        return None;
    }
    let (truth, reference) = truth(cycle, wanted, drive.flywheel_on == FlywheelPlace::Motor)?;
    let entries = cycle.regime.flywheel_by_method.iter().map(|found| {
        // The results of the methods are known already; a run repeats them for their cost.
        let (exact, flywheel) = (found.method == "exact", found.flywheel);
        let run = move |_| Verdict {
            evaluations: effort(cycle, exact).map(|count| count as u64),
            error: Some(((flywheel - truth) / truth).abs()),
            failure: None,
        };
        Entry::run(Measurement::new(Stage::Flywheel, found.method, Setting::default()), run)
    });
    Some(Field { reference, entries: entries.collect() })
}

/// The flywheel corrected by the unevenness that dop853 finds in time: unevenness goes with the inverse of the inertia.
fn truth(cycle: &Cycle<'_>, wanted: f64, on_motor: bool) -> Option<(f64, Reference)> {
    let ratio = cycle.regime.figures.ratio.filter(|_| on_motor).unwrap_or(1.0);
    let fine = unevenness(cycle, SAMPLES)?;
    let coarse = unevenness(cycle, SAMPLES / 2)?;
    let task = cycle.task(1);
    let inertia = task.motion.clone().reduced(&task.request.initial).ok()?.inertia;
    let flywheel = cycle.regime.flywheel;
    let corrected = |found: f64| flywheel + inertia / (ratio * ratio) * (found / wanted - 1.0);
    let truth = corrected(fine);
    let error =
        ((corrected(coarse) - truth) / truth).abs().max(((truth - flywheel) / truth).abs() * 0.1).max(1e-13);
    let how = text!(
        "chart-reference-flywheel",
        method = name(stepping(&task)?.name),
        tolerance = number(format_args!("{TIGHT:e}")),
        samples = number(SAMPLES)
    );
    Some((truth, Reference { how, error }))
}

/// (greatest - least)/mean of the speed over the cycle in time; extremes by parabolas through three samples.
fn unevenness(cycle: &Cycle<'_>, samples: usize) -> Option<f64> {
    let task = cycle.task(samples);
    let request = Request { tolerance: TIGHT, ..task.request };
    let found = stepping(&task)?.solve(&mut task.motion.clone(), &request).ok()?;
    let speeds: Vec<f64> = found.samples.iter().map(|sample| sample.speed.abs()).collect();
    let high = extreme(&speeds, 1.0)?;
    let low = -extreme(&speeds, -1.0)?;
    Some(2.0 * (high - low) / (high + low))
}

/// The greatest of `sign` times the values, the last of which repeats the first.
fn extreme(values: &[f64], sign: f64) -> Option<f64> {
    let around = values.len().checked_sub(1).filter(|count| *count > 2)?;
    let at = |i: usize| sign * values[i % around];
    let top = (0..around).max_by(|a, b| at(*a).total_cmp(&at(*b)))?;
    let (before, here, after) = (at(top + around - 1), at(top), at(top + 1));
    let bend = before - 2.0 * here + after;
    let slope = 0.5 * (after - before);
    Some(if bend < 0.0 { here - 0.5 * slope * slope / bend } else { here })
}

/// Evaluations of the equation of motion that a flywheel costs: the exact one, or one survey of the cycle.
fn effort(cycle: &Cycle<'_>, exact: bool) -> Option<usize> {
    if exact {
        return Some(steady(cycle.linkage, cycle.loads, None).ok()?.regime.effort.evaluations);
    }
    let mut machine = cycle.machine();
    let solver = RegimeSolver::new(&mut machine, cycle.request).ok()?;
    black_box(solver.mean_resistance());
    Some(solver.evaluations())
}

#[cfg(test)]
mod tests;
