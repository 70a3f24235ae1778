//! `[motion]`: how the input moves.

use assur_mechanism::{
    MOST_PARTS_SAMPLED, MOST_SAMPLES, MOST_STEPS_KEPT, Mechanism, Motion, Solve, StepLength, Until,
};

use assur_words::{Text, name as words, number, text};

use crate::reference::{Bound, table};
use crate::text::{brief, did_you_mean, shown, such_as};
use crate::units::{Dimension, UnitFault, is_bare, measures, quantity};
use crate::walk::{Entry, Section};
use crate::{context::Context, error::Fault};

/// Steps of a motion that a scene may allow: hours of work.
const MOST_STEPS: usize = 1_000_000_000;

/// Reads a motion of one kind.
type Read = fn(&Section<'_>, &Context<'_>) -> Option<Motion>;
const KINDS: [(&str, Read); 3] = [("prescribed", prescribed), ("transient", transient), ("steady", steady)];

pub(crate) fn read(root: &Section<'_>, context: &Context<'_>) -> Option<Motion> {
    if context.timing.is_time() {
        return root.get("motion").map(|_| Motion::Prescribed { speed: 1.0, acceleration: 0.0 });
    }
    let section = root.inner("motion")?;
    let (kind, read) = match section.get("kind") {
        Some(entry) => entry.choice(&KINDS.map(|kind| (kind.0, kind)))?,
        None => KINDS[0],
    };
    refuse_other_kinds(&section, kind);
    section.sets(context.sign(), speed);
    section.sets(1.0, |scene, key| match (scene.motion.as_mut()?, key) {
        (Motion::Transient { tolerance, .. }, "tolerance") => Some(tolerance),
        (Motion::Steady { unevenness, .. }, "unevenness") => unevenness.as_mut()?.given(),
        _ => None,
    });
    read(&section, context)
}

/// A speed or an acceleration in a mechanism.
fn speed<'m>(scene: &'m mut Mechanism, key: &str) -> Option<&'m mut f64> {
    match (scene.motion.as_mut()?, key) {
        (Motion::Prescribed { speed: number, .. } | Motion::Transient { speed: number, .. }, "speed")
        | (Motion::Prescribed { acceleration: number, .. }, "acceleration")
        | (Motion::Steady { mean_speed: number, .. }, "mean_speed") => Some(number),
        _ => None,
    }
}

/// Notes a key that belongs to another kind of motion and would have no effect.
fn refuse_other_kinds(section: &Section<'_>, kind: &'static str) {
    let table = table("[motion]");
    for entry in section.entries() {
        let Some(sorts) = table.sorts(&entry.name) else { continue };
        if sorts.split(", ").any(|sort| sort == kind) {
            continue;
        }
        let owner = words(sorts.split(", ").next().unwrap_or(sorts));
        let message = text!("scene-other-motion", key = shown(&entry.name), owner, kind = words(kind));
        let keys = words(table.names(Some(kind)).collect::<Vec<_>>().join(", "));
        let help = text!("scene-motion-knows", kind = words(kind), keys);
        section.faults.push(Fault::new(entry.key, message).help(help));
    }
}

fn prescribed(section: &Section<'_>, context: &Context<'_>) -> Option<Motion> {
    let acceleration = section.by_input("acceleration", context.coordinate());
    section.need("speed");
    let speed = section.by_input("speed", context.coordinate());
    let [speed, acceleration] = [speed?, acceleration?].map(|along| context.sign() * along);
    Some(Motion::Prescribed { speed, acceleration })
}

fn transient(section: &Section<'_>, context: &Context<'_>) -> Option<Motion> {
    let speed = section.by_input("speed", context.coordinate()).unwrap_or_default();
    let samples = samples(section, context).unwrap_or(100);
    let integrator =
        section.get("integrator").and_then(|entry| entry.text(text!("scene-name-of-integrator")));
    let tolerance = section.number("tolerance").unwrap_or_default();
    if let Some(entry) = section.get("tolerance").filter(|entry| !entry.is_within(tolerance, ..1.0)) {
        entry.fault(text!("scene-large-tolerance", got = brief(tolerance)), such_as("1e-9"));
    }
    for entry in ["until", "step"].iter().filter_map(|key| section.get(key)) {
        entry.may_be(Some(Dimension::Time), Bound::Positive);
        entry.may_be(context.coordinate(), Bound::Positive);
    }
    let until = section.need("until").and_then(|entry| until(&entry, context))?;
    let integrator = integrator.unwrap_or("auto").to_owned();
    let step = section.get("step").and_then(|entry| time_or_way(&entry, context, "scene-time-or-travel"));
    let step = step.map(|found| found.map_or_else(StepLength::Time, StepLength::Way));
    // Steps that no sample needs are dropped where the instants of the samples are known.
    let most_steps = if matches!(until, Until::Time(_)) { MOST_STEPS } else { MOST_STEPS_KEPT };
    let max_steps = section.get("max_steps").and_then(|entry| entry.count(1, most_steps));
    let speed = context.sign() * speed;
    Some(Motion::Transient { speed, until, samples, integrator, tolerance, step, max_steps })
}

/// Reads the number of samples, which are kept in memory: the more a mechanism has, the fewer.
fn samples(section: &Section<'_>, context: &Context<'_>) -> Option<usize> {
    let linkage = context.linkage;
    let parts = linkage.links.len() + linkage.points.len() + linkage.slides.len() + context.loads;
    let entry = section.get("samples")?;
    let samples = entry.count(1, MOST_SAMPLES)?;
    let most = (MOST_PARTS_SAMPLED / parts.max(1)).max(1);
    if samples > most {
        let message = text!("scene-many-samples", most = number(most), parts);
        entry.fault(message, text!("scene-kept-in-memory"));
    }
    Some(samples)
}

/// Reads "rest", "turn", a time, or a displacement of the input.
fn until(entry: &Entry<'_>, context: &Context<'_>) -> Option<Until> {
    match entry.value.as_str() {
        Some("rest") => Some(Until::Rest),
        Some("turn") => Some(Until::Turn),
        _ => time_or_way(entry, context, "scene-end-of-motion")
            .map(|found| found.map_or_else(Until::Time, Until::Way)),
    }
}

/// Reads a time (`Err`) or a displacement of the input (`Ok`), told apart by their units; a bare number is a time. `wanted`:
/// the identity of what the key allows, for messages.
fn time_or_way(entry: &Entry<'_>, context: &Context<'_>, wanted: &'static str) -> Option<Result<f64, f64>> {
    let Some(text) = entry.value.as_str() else {
        return entry.bounded(Dimension::Time, Bound::Positive).map(Err);
    };
    let way = context.coordinate().unwrap_or(Dimension::Angle);
    // A displacement out of range is still a displacement.
    let fault = quantity(text, way).err().map(|error| error.fault);
    if matches!(fault, None | Some(UnitFault::TooLarge | UnitFault::TooSmall)) && !is_bare(text, way) {
        return entry.bounded(way, Bound::Positive).map(Ok);
    }
    let wanted = text!(wanted, time = Dimension::Time.with_units(), travel = way.with_units());
    let fault = quantity(text, Dimension::Time).err();
    let (got, label) = match fault.as_ref().map(|error| (&error.fault, &error.text)) {
        Some((UnitFault::WrongDimension(found), unit)) => (measures(unit, *found), Text::default()),
        Some((UnitFault::UnknownUnit(near), unit)) => {
            (text!("scene-got-unknown-unit", unit = shown(unit)), did_you_mean(unit, near.as_deref()))
        }
        Some((UnitFault::NotANumber, _)) => (entry.written(), Text::default()),
        _ => return entry.bounded(Dimension::Time, Bound::Positive).map(Err),
    };
    entry.wants(wanted, got, label);
    None
}

fn steady(section: &Section<'_>, context: &Context<'_>) -> Option<Motion> {
    if context.has_no_cycle() {
        let message = text!("scene-steady-without-cycle");
        section.faults.add(section.span.clone(), message, text!("scene-give-a-cycle"));
    }
    // A wrong one is given, too: it is not missing then.
    let wrong = section.get("unevenness").map(|_| Solve::Given(0.0));
    let unevenness = section.solved("unevenness", None).or(wrong);
    if let (Some(Solve::Given(value)), Some(entry)) = (unevenness, section.get("unevenness"))
        && !entry.is_within(value, ..2.0)
    {
        entry.fault(text!("scene-large-unevenness", got = brief(value)), such_as("0.05"));
    }
    let mean = section.by_input("mean_speed", context.coordinate())?;
    Some(Motion::Steady { mean_speed: context.sign() * mean, unevenness })
}
