//! A crank with a motor of a straight characteristic against dry friction, from the scene to the motion: start, stall, regime.

use assur_check::Finding;
use assur_dynamics::{DynamicsError, Method, steady, transient};
use assur_force::Loads;
use assur_integrator::{IntegrationError, IntegratorPlugin, integrators};
use assur_kinematics::Linkage;
use assur_words::{Describe, Text, name};

use super::places::compiled;
use crate::stability::row::{Comparison, DISTANCES};
use crate::stability::tests::Law;

pub(super) static LAW: Law = Law {
    section: "Machines with a motor",
    along: "by how much the friction is greater than the moment of the motor at rest, in parts of it; -0.8 where it is less",
    expected: "start in closed form: steps * tolerance (1e-10), for a fixed step its thousandth \
               of the motion to the order of the method; stall (its steps are not known: 1000 of them) and regime: 1000 * tolerance; a stalled motor is refused with the place where it \
               stops, known as exactly, over the excess where that is a difference of moments",
};

/// Moment of the motor at rest, N m; it falls by 1 N m for each rad/s, on an inertia of 1 kg m².
const START: f64 = 100.0;

const TOLERANCE: f64 = 1e-10;

/// All rows.
pub(crate) fn rows() -> Vec<Comparison> {
    let Ok(plugins) = integrators() else { return Vec::new() };
    let mut rows = vec![regime(-0.8)];
    rows.extend(plugins.iter().filter_map(|plugin| start(plugin, -0.8)));
    for excess in DISTANCES.into_iter().filter(|excess| *excess > 1e-12) {
        rows.push(regime(excess));
        rows.extend(plugins.iter().filter_map(|plugin| stall(plugin, excess)));
    }
    rows
}

fn scene(friction: f64, motion: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 1 }}\nmass = 1\ncenter = \"O\"\ninertia = 1\n\
         [[force]]\nlink = \"crank\"\nat = \"A\"\nagainst_motion = true\nvalue = {friction:?}\n\
         [drive]\nmotor = {{ power = 900, synchronous_speed = 100, rated_speed = 90 }}\ncharacteristic = \"linear\"\n\
         ratio = 1\nflywheel = 0\nefficiency = 1\n[input]\nlink = \"crank\"\n[motion]\n{motion}\n"
    )
}

/// The friction, and by how much it is greater than the moment at rest.
fn friction(excess: f64) -> [f64; 2] {
    let friction = START * (1.0 + excess);
    [friction, friction - START]
}

/// Compiled with its loads; the scenes are the program's own, and a test holds that each has rows.
fn machine(text: &str) -> Option<(Linkage, Loads)> {
    let linkage = compiled(text)?;
    let loads = Loads::compile(&linkage).ok()?;
    Some((linkage, loads))
}

fn row(
    place: &str,
    (method, quantity): (&str, &'static str),
    distance: f64,
    bound: f64,
) -> impl Fn(Result<f64, Text>, bool) -> Comparison {
    let (place, method) = (place.to_owned(), method.to_owned());
    move |outcome, may_refuse| {
        let subject = Comparison {
            method: name(method.clone()),
            quantity,
            distance,
            health: distance.abs().min(1.0),
            finding: Finding::within(name(place.clone()), bound),
        };
        subject.judged_or(outcome, may_refuse)
    }
}

/// Steps of a motion that ends in a refusal, which does not tell them.
const STEPS: usize = 1000;

/// What a method of the fixed step of a thousandth of `duration` loses; of the others the tolerance once for each step.
fn bound(plugin: &IntegratorPlugin, duration: f64, steps: usize) -> f64 {
    let step = duration / 1000.0;
    match plugin.order {
        1 => step * duration,
        4 => step.powi(4) * duration,
        _ => steps.max(1) as f64 * TOLERANCE,
    }
}

fn method(integrator: &str) -> Method<'_> {
    Method { integrator: Some(integrator), tolerance: Some(TOLERANCE) }
}

/// From rest: w = W (1 - exp(-t)), q = W (t - 1 + exp(-t)), with W what the motor has left.
fn start(plugin: &IntegratorPlugin, excess: f64) -> Option<Comparison> {
    let ([friction, over], end) = (friction(excess), 2.0_f64);
    let text = scene(friction, "kind = \"transient\"\nspeed = 0\nuntil = 2");
    let (linkage, loads) = machine(&text)?;
    let lost = -(-end).exp_m1();
    let found = transient(&linkage, &loads, &method(plugin.name), None);
    let count = |steps: &assur_integrator::SolutionCost| steps.steps + steps.rejected;
    let steps = found.as_ref().map_or(STEPS, |found| count(&found.trajectory.statistics));
    let row = row("motor from rest", (plugin.name, "end"), excess, bound(plugin, end, steps));
    Some(match found {
        Ok(found) => {
            let state = found.trajectory.end;
            let speed = (state.speed / (-over * lost) - 1.0).abs();
            row(Ok(speed.max((state.coordinate / (-over * (end - lost)) - 1.0).abs())), false)
        }
        Err(why) => row(Err(why.describe()), is_unsupported(&why)),
    })
}

/// From 50 rad/s: w = (50 + a) exp(-t) - a stops after t = ln(1 + 50/a) at q = 50 - a t, before the 50 turns wanted.
fn stall(plugin: &IntegratorPlugin, excess: f64) -> Option<Comparison> {
    let [friction, over] = friction(excess);
    let text = scene(friction, "kind = \"transient\"\nspeed = 50\nuntil = \"50 rev\"");
    let (linkage, loads) = machine(&text)?;
    let duration = (50.0 / over).ln_1p();
    let stop = 50.0 - over * duration;
    // A step of a fixed length is a thousandth of the time that 50 turns at the speed of the start would take.
    let bound = bound(plugin, duration.max(6.3), STEPS) + 1e3 * f64::EPSILON / excess;
    let row = row("motor stalled by friction", (plugin.name, "place of the refusal"), excess, bound);
    Some(match transient(&linkage, &loads, &method(plugin.name), None) {
        Err(DynamicsError::Integration(IntegrationError::NotReached { at, .. })) => {
            row(Ok((at.coordinate / stop - 1.0).abs().max(at.speed.abs())), false)
        }
        Err(why) => row(Err(why.describe()), is_unsupported(&why)),
        Ok(_) => row(Ok(f64::INFINITY), false),
    })
}

fn is_unsupported(why: &DynamicsError) -> bool {
    matches!(why, DynamicsError::Integration(IntegrationError::Unsupported { .. }))
}

/// The regime turns with what the motor has left, without unevenness; a stalled motor has none.
fn regime(excess: f64) -> Comparison {
    let [friction, over] = friction(excess);
    let text = scene(friction, "kind = \"steady\"\nmean_speed = 80");
    let row = row("regime of the motor", ("shooting", "regime"), excess, 1e3 * TOLERANCE);
    let found = match machine(&text) {
        Some((linkage, loads)) => steady(&linkage, &loads, None).map_err(|error| error.describe()),
        None => return row(Err(name("the scene does not compile")), false),
    };
    match found {
        Ok(found) if over < 0.0 => row(Ok((found.regime.figures.mean_speed / -over - 1.0).abs()), false),
        Ok(_) => row(Ok(f64::INFINITY), false),
        Err(why) => row(Err(why), over > 0.0),
    }
}
