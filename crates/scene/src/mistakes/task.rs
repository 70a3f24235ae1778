//! What of loads, motion and results is probably not meant, by sizes alone.

use std::f64::consts::TAU;

use assur_formula::{Used, Variables};
use assur_mechanism::{
    InputPair, Key, Load, LoadKind, Mechanism, Motion, MotorChoice, Output, Over, Range, Solve, Surfaces,
    Torque, Value, Warning,
};
use assur_words::{Text, quantity, text};

use crate::text::{rounded, shown};

/// Gravity between these, m/s^2, is that of a planet: 9810 was meant in mm, 0.00981 written in mm.
const GRAVITY: [f64; 2] = [0.5, 30.0];
/// No link holds together at a greater circumferential speed, m/s.
const FASTEST: f64 = 1000.0;
/// A force of so much on a square as wide as the mechanism, Pa, is beyond the strength of any steel.
const STRONGEST: f64 = 2e9;
/// Coefficients of friction above this are those of no pair of solids.
const ROUGHEST: f64 = 2.0;
/// Directions that differ by less are the same to the digits in which coordinates are written, rad.
const SAME_DIRECTION: f64 = 2e-3;
/// A ratio so many times as great, or as small, as motor and mean speed need is meant the other way round.
const MOST_TIMES_THE_RATIO: f64 = 2.0;
/// Asynchronous motors have a breakdown torque of 1.5 to 4 rated ones; above this it was given in per cent.
const GREATEST_TORQUE_RATIO: f64 = 20.0;
/// A table over time that is so many times as long as the motion was meant in another unit.
const MOST_TIMES_THE_MOTION: f64 = 100.0;
/// A spring so many times as long as the mechanism was meant in another unit.
const LONGEST_SPRING: f64 = 10.0;

/// All of it; `size`: of the mechanism, m.
pub(super) fn of(mechanism: &Mechanism, size: f64) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let mut doubt = |is: bool, key: &Key, text: &dyn Fn() -> Text| {
        if is {
            warnings.push(Warning::mistake(key.clone(), text()));
        }
    };
    if let Some([x, y]) = mechanism.gravity {
        let size = x.hypot(y);
        let is_odd = size > 0.0 && !(GRAVITY[0]..=GRAVITY[1]).contains(&size);
        doubt(!is_odd && y > 0.0 && x.abs() < y, &Key::of("gravity"), &|| text!("scene-gravity-up"));
        doubt(is_odd, &Key::of("gravity"), &|| {
            text!("scene-odd-gravity", size = quantity(rounded(size), "m/s^2"))
        });
    }
    let speed = match mechanism.motion.as_ref().filter(|_| !mechanism.input.kind().is_time()) {
        Some(Motion::Prescribed { speed, .. } | Motion::Transient { speed, .. }) => {
            (Key::of("motion").at("speed"), speed.abs())
        }
        Some(Motion::Steady { mean_speed, .. }) => (Key::of("motion").at("mean_speed"), mean_speed.abs()),
        None => (Key::of("motion"), 0.0),
    };
    let fastest = if mechanism.input.is_angle() { speed.1 * size } else { speed.1 };
    doubt(fastest > FASTEST, &speed.0, &|| {
        text!("scene-fast", speed = quantity(rounded(fastest.round()), "m/s"))
    });
    for (number, friction) in mechanism.frictions.iter().enumerate() {
        let key = |name: &str| Key::of("friction").at(number).at(name);
        let coefficient = friction.coefficient;
        doubt(coefficient > ROUGHEST, &key("coefficient"), &|| {
            text!("scene-rough", found = rounded(coefficient))
        });
        let radius = if let Surfaces::Journal { radius, .. } = friction.surfaces { radius } else { 0.0 };
        doubt(radius > size, &key("radius"), &|| {
            let [radius, size] = [radius, size].map(|length| quantity(rounded(length), "m"));
            text!("scene-great-journal", radius, size)
        });
    }
    let nothing = mechanism.output == Some(Output::default());
    doubt(nothing, &Key::of("output"), &|| text!("scene-empty-output"));
    for (id, load) in mechanism.loads.iter().enumerate() {
        if let Some((key, text)) = of_load(mechanism, load, mechanism.key_of_load(id), size) {
            doubt(true, &key, &|| text.clone());
        }
    }
    warnings.extend(of_input_and_drive(mechanism, &speed));
    warnings
}

/// What contradicts itself in the input, the motion and the drive; `speed`: its key and size.
fn of_input_and_drive(mechanism: &Mechanism, speed: &(Key, f64)) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let mut doubt = |is: bool, key: &Key, text: Text| {
        if is {
            warnings.push(Warning::mistake(key.clone(), text));
        }
    };
    let turned_twice = mechanism.input.sign() < 0.0
        && matches!(mechanism.motion, Some(Motion::Prescribed { speed, .. }) if speed > 0.0);
    doubt(turned_twice, &speed.0, text!("scene-turned-twice"));
    let finds_flywheel =
        mechanism.drive.as_ref().is_some_and(|drive| matches!(drive.flywheel, Some(Solve::Wanted)));
    let is_wanted = matches!(mechanism.motion, Some(Motion::Steady { unevenness: Some(_), .. }));
    doubt(
        is_wanted && !finds_flywheel,
        &Key::of("motion").at("unevenness"),
        text!("scene-unevenness-unused"),
    );
    if let Some((key, angle)) = turned_by_frame_and_from(mechanism) {
        let [angle, twice] = [angle, 2.0 * angle].map(|angle| quantity(rounded(angle.to_degrees()), "deg"));
        doubt(
            true,
            &Key::of("input").at("from"),
            text!("scene-counted-twice", point = shown(key), angle, twice),
        );
    }
    if let Some(Torque::Motor { motor: MotorChoice::Rated(motor), .. }) =
        mechanism.drive.as_ref().map(|drive| &drive.torque)
        && let Some(ratio) = motor.max_torque_ratio.filter(|ratio| *ratio > GREATEST_TORQUE_RATIO)
    {
        let text = text!("scene-great-torque-ratio", found = rounded(ratio), part = rounded(ratio / 100.0));
        doubt(true, &Key::of("drive").at("motor").at("max_torque_ratio"), text);
    }
    if let Some((ratio, needed)) = odd_ratio(mechanism, speed.1) {
        let [ratio, needed] = [ratio, needed].map(rounded);
        doubt(true, &Key::of("drive").at("ratio"), text!("scene-odd-ratio", ratio, needed));
    }
    warnings
}

/// A pin of the crank that stands at the angle `from` in the crank's own frame too: places in the ground's frame were given.
fn turned_by_frame_and_from(mechanism: &Mechanism) -> Option<(&str, f64)> {
    let input = &mechanism.input;
    let (link, InputPair::Pin(pivot)) = (input.crank()?, input.sole()?.pair) else { return None };
    let origin = mechanism.points[pivot].on(link)?;
    let others = mechanism.points.iter().enumerate().filter(|(id, point)| *id != pivot && point.is_pin());
    others.map(|(_, point)| point).find_map(|point| {
        let at = point.on(link)?;
        let angle = (at[1] - origin[1]).atan2(at[0] - origin[0]);
        let apart = (input.from - angle).rem_euclid(TAU);
        let is_same = apart.min(TAU - apart) < SAME_DIRECTION && angle.abs() > SAME_DIRECTION;
        is_same.then_some((point.name.as_str(), angle))
    })
}

/// A given ratio that takes a motor of given data far from its speed, and the one that would not.
fn odd_ratio(mechanism: &Mechanism, speed: f64) -> Option<(f64, f64)> {
    let drive = mechanism.drive.as_ref()?;
    let (Solve::Given(ratio), Torque::Motor { motor: MotorChoice::Rated(motor), .. }) =
        (drive.ratio, &drive.torque)
    else {
        return None;
    };
    let needed = motor.rated_speed / speed;
    let steady = matches!(mechanism.motion, Some(Motion::Steady { .. }));
    (steady && (ratio / needed).ln().abs() > MOST_TIMES_THE_RATIO.ln()).then_some((ratio, needed))
}

/// What is odd in a load of this key, and where.
fn of_load(mechanism: &Mechanism, load: &Load, key: Key, size: f64) -> Option<(Key, Text)> {
    let value = match &load.kind {
        LoadKind::Spring(spring) => {
            let [length, whole] = [spring.length, size].map(|length| quantity(rounded(length), "m"));
            let is_long = spring.length > LONGEST_SPRING * size;
            if spring.stiffness == 0.0 && spring.damping == 0.0 {
                return Some((key.at("stiffness"), text!("scene-spring-without-stiffness")));
            }
            return is_long.then(|| (key.at("length"), text!("scene-long-spring", length, size = whole)));
        }
        LoadKind::Force(force) => &force.value,
        LoadKind::Moment(moment) => &moment.value,
        _ => return None,
    };
    let unit = if matches!(load.kind, LoadKind::Force(_)) { 1.0 } else { size };
    let most = value.sizes().fold(0.0, |most: f64, size| most.max(size.abs())) / unit;
    if most > STRONGEST * size * size {
        let text =
            text!("scene-strong", force = quantity(rounded(most), "N"), size = quantity(rounded(size), "m"));
        return Some((key.at("value"), text));
    }
    if drives_clockwise(mechanism, load) {
        return Some((key.at("value").at("formula"), text!("scene-drives-clockwise")));
    }
    let Value::Table { over: Over::Time, table, .. } = value else { return None };
    let (last, Some(Motion::Prescribed { speed, .. })) = (table.rows.last()?[0], &mechanism.motion) else {
        return None;
    };
    let way = match mechanism.input.range {
        Range::Cycle(cycle) => cycle,
        Range::To(to) => (to - mechanism.input.from).abs(),
    };
    let [last_shown, lasts] = [last, way / speed.abs()].map(|time| quantity(rounded(time), "s"));
    let is_long = last > MOST_TIMES_THE_MOTION * way / speed.abs();
    is_long.then(|| (key.at("value").at("table"), text!("scene-long-time", last = last_shown, lasts)))
}

/// Whether a moment on an input link that turns clockwise is a resistance with the wrong sign: by formula of the speed alone, none at
/// rest, and of positive power at any speed.
fn drives_clockwise(mechanism: &Mechanism, load: &Load) -> bool {
    /// Speeds, rad/s, of either sign: a characteristic that crosses zero between them is that of a motor.
    const SPEEDS: [f64; 6] = [-1000.0, -30.0, -1.0, 1.0, 30.0, 1000.0];
    let (LoadKind::Moment(moment), input) = (&load.kind, &mechanism.input) else { return false };
    let Value::Formula { formula, .. } = &moment.value else { return false };
    if moment.against_motion {
        return false;
    }
    let by_speed = formula.used() == Used { speed: true, ..Used::default() };
    let at = |speed: f64| formula.value(&Variables { speed, ..Variables::default() });
    let turns = Some(moment.link) == input.crank() && input.is_angle() && input.sign() < 0.0;
    turns && by_speed && at(0.0) == 0.0 && SPEEDS.into_iter().all(|speed| at(speed) * speed > 0.0)
}
