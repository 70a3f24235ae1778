//! Motion: every registered integrator on the scene's equation of motion.

pub(in crate::chart) mod reference;

use std::hint::black_box;

use assur_dynamics::Machine;
use assur_integrator::{EquationOfMotion, FixedStep, IntegratorPlugin, Knob, Request, integrators};
use assur_words::{Describe, text};

use super::data::{STEP, TOLERANCE};
use super::race::{Entry, Field, Verdict};
use super::{ChartError, ChartOptions, Measurement, Setting, Stage};

use reference::References;

#[derive(Debug, Clone)]
pub(crate) struct Task<'a> {
    pub(crate) motion: Machine<'a>,
    pub(crate) request: Request,
}

pub(crate) fn field<'a>(task: &Task<'a>, options: ChartOptions) -> Result<Field<'a>, ChartError> {
    let references = References::find(task)?;
    let mut entries = Vec::new();
    for plugin in integrators()? {
        if let Err(why) = (plugin.suitability)(&task.motion.dependence(), task.request.tolerance) {
            entries.push(Entry::refused(row(plugin.name, Setting::default()), why));
            continue;
        }
        for (setting, request) in settings(plugin, task, references.duration, options) {
            let row = row(plugin.name, setting);
            entries.push(match references.judge_of(plugin.name) {
                Some(truth) => {
                    let (mut motion, sizes) = (task.motion.clone(), references.sizes);
                    Entry::run(row, move |judged| match black_box(plugin.solve(&mut motion, &request)) {
                        Ok(found) if judged => Verdict {
                            evaluations: Some(found.statistics.evaluations as u64),
                            error: Some(reference::deviation(&found, &truth, sizes)),
                            failure: None,
                        },
                        Ok(_) => Verdict::default(),
                        Err(why) => Verdict { failure: Some(why.describe()), ..Verdict::default() },
                    })
                }
                None => Entry::refused(row, text!("chart-not-judged")),
            });
        }
    }
    Ok(Field { reference: references.reference, entries })
}

fn row(method: &str, setting: Setting) -> Measurement {
    Measurement::new(Stage::Motion, method, setting)
}

/// The settings of a method: tolerances, or steps as parts of the whole motion, or none.
fn settings(
    plugin: &IntegratorPlugin,
    task: &Task<'_>,
    duration: f64,
    options: ChartOptions,
) -> Vec<(Setting, Request)> {
    let base = Request { max_steps: options.max_steps, ..task.request };
    match plugin.knob {
        Knob::Tolerance => options
            .decades(-3, -13)
            .map(|tolerance| (Setting::number(TOLERANCE, tolerance), Request { tolerance, ..base }))
            .collect(),
        // Steps of a third or of half a decade serve equally well; nine steps over four decades.
        Knob::Step => (0..9)
            .step_by(if options.quick { 2 } else { 1 })
            .map(|half| duration / 30.0 / 10.0_f64.powf(0.5 * f64::from(half)))
            .map(|step| {
                (Setting::number(STEP, step), Request { fixed_step: Some(FixedStep::Time(step)), ..base })
            })
            .collect(),
        Knob::None => vec![(Setting::default(), base)],
    }
}
