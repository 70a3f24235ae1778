//! `[drive]`: motor, reducer and flywheel.

use std::ops::Bound as End;

use assur_mechanism::{
    CharacteristicKind, Drive, FlywheelPlace, Mechanism, Motion, MotorChoice, RatedMotor, Solve, Torque,
};

use assur_words::{Text, name, text};

use crate::text::{brief, exclude, shown, such_as};
use crate::walk::{Entry, Section};
use crate::{context::Context, units::Dimension};

/// Keys that have a meaning only with a motor.
const OF_THE_MOTOR: [&str; 5] = ["catalogue", "max_motor_speed", "characteristic", "ratio", "efficiency"];
const CHARACTERISTICS: &[(&str, CharacteristicKind)] =
    &[("kloss", CharacteristicKind::Kloss), ("linear", CharacteristicKind::Linear)];
const PLACES: &[(&str, FlywheelPlace)] = &[("crank", FlywheelPlace::Crank), ("motor", FlywheelPlace::Motor)];

/// Reads the drive; `motion` is the motion of the scene, if it could be read.
pub(crate) fn read(root: &Section<'_>, motion: Option<&Motion>, context: &Context<'_>) -> Option<Drive> {
    let section = root.inner("drive");
    check_unevenness(root, section.as_ref(), motion);
    let section = section?;
    if context.timing.refuse_mover(section.faults, &section.span, "[drive]") {
        return None;
    }
    check_motion(&section, motion, context);
    check_motor_keys(&section, context);
    let torque = torque(&section, context);
    section.sets(1.0, number);
    let ratio = section.solved("ratio", None);
    let flywheel = section.solved("flywheel", None);
    let efficiency = section.number("efficiency").unwrap_or_default();
    if let Some(entry) = section.get("efficiency").filter(|entry| !entry.is_within(efficiency, ..=1.0)) {
        entry.fault(text!("scene-large-efficiency", got = brief(efficiency)), such_as("0.95"));
    }
    check_solved(&section, motion);
    let place = section.get("flywheel_on").and_then(|entry| entry.choice(PLACES));
    Some(Drive {
        torque: torque?,
        ratio: ratio?,
        efficiency,
        flywheel,
        flywheel_on: place.unwrap_or(FlywheelPlace::Crank),
    })
}

/// A number of the drive in a mechanism. The rated speed of a motor must stay below the synchronous one.
fn number<'m>(scene: &'m mut Mechanism, key: &str) -> Option<&'m mut f64> {
    let Drive { torque, ratio, efficiency, flywheel, flywheel_on: _ } = scene.drive.as_mut()?;
    match (key, torque) {
        ("ratio", _) => ratio.given(),
        ("efficiency", _) => Some(efficiency),
        ("flywheel", _) => flywheel.as_mut()?.given(),
        ("torque", torque @ Torque::Balance) => {
            *torque = Torque::Constant(0.0);
            if let Torque::Constant(moment) = torque { Some(moment) } else { None }
        }
        ("torque", Torque::Constant(moment)) => Some(moment),
        ("max_motor_speed", Torque::Motor { max_speed, .. }) => max_speed.as_mut(),
        (key, Torque::Motor { motor: MotorChoice::Rated(motor), .. }) => match key {
            "motor.power" => Some(&mut motor.power),
            "motor.max_torque_ratio" => motor.max_torque_ratio.as_mut(),
            "motor.inertia" => motor.inertia.as_mut(),
            _ => None,
        },
        _ => None,
    }
}

fn check_motion(section: &Section<'_>, motion: Option<&Motion>, context: &Context<'_>) {
    let absent = motion.is_none() && !context.moves;
    if absent || matches!(motion, Some(Motion::Prescribed { .. })) {
        let message =
            if absent { text!("scene-drive-without-motion") } else { text!("scene-drive-of-prescribed") };
        section.faults.add(section.span.clone(), message, text!("scene-kept-by-balance"));
    }
}

/// Notes keys that would have no effect.
fn check_motor_keys(section: &Section<'_>, context: &Context<'_>) {
    let motor = section.get("motor");
    if motor.is_none() {
        section.refuse(&OF_THE_MOTOR, "scene-key-of-motor", &text!("scene-add-motor"));
        let on_motor = section.get("flywheel_on").filter(|entry| entry.value.as_str() == Some("motor"));
        if let Some(entry) = on_motor {
            entry.fault(text!("scene-flywheel-on-no-motor"), name("flywheel_on = \"crank\""));
        }
    }
    if let (None, Some(entry)) = (section.get("flywheel"), section.get("flywheel_on")) {
        section.faults.add(entry.key, text!("scene-no-flywheel"), text!("scene-add-flywheel"));
    }
    if context.input.is_some_and(|input| input.first().is_relative()) {
        let keys = ["motor", "ratio", "flywheel"];
        section.refuse(&keys, "scene-no-motor-between", &text!("scene-torque-between"));
    } else if context.coordinate() == Some(Dimension::Length) {
        section.refuse(&["motor", "flywheel"], "scene-input-slides", &Text::default());
    }
}

/// Checks what a value "solve" requires of the motion.
fn check_solved(section: &Section<'_>, motion: Option<&Motion>) {
    let wanted = |key: &str| section.get(key).filter(|entry| entry.value.as_str() == Some("solve"));
    if matches!(motion, Some(Motion::Transient { .. })) {
        for entry in ["ratio", "flywheel"].into_iter().filter_map(wanted) {
            let message = text!("scene-solve-needs-steady", key = shown(&entry.name));
            entry.fault(message, text!("scene-number-for-transient"));
        }
    }
    if let (Some(Motion::Steady { unevenness: None, .. }), Some(entry)) = (motion, wanted("flywheel")) {
        entry.fault(text!("scene-flywheel-needs-unevenness"), such_as("unevenness = 0.05"));
    }
}

/// Checks what `unevenness = "motor"` requires of the drive.
fn check_unevenness(root: &Section<'_>, drive: Option<&Section<'_>>, motion: Option<&Motion>) {
    if !matches!(motion, Some(Motion::Steady { unevenness: Some(Solve::Wanted), .. })) {
        return;
    }
    let finds_flywheel = |drive: &&Section<'_>| {
        drive.get("flywheel").is_some_and(|entry| entry.value.as_str() == Some("solve"))
    };
    if drive.filter(finds_flywheel).is_none_or(|drive| drive.get("motor").is_none())
        && let Some(entry) = root.get("motion")
    {
        root.faults.add(entry.key, text!("scene-unevenness-needs-motor"), Text::default());
    }
}

fn torque(section: &Section<'_>, context: &Context<'_>) -> Option<Torque> {
    match (section.get("motor"), section.get("torque")) {
        (Some(_), Some(torque)) => {
            torque.fault(exclude(["torque", "motor"].map(name)), text!("scene-leave-one-out"));
            None
        }
        (Some(motor), None) => with_motor(section, &motor),
        (None, Some(_)) => match section.solved("torque", context.coordinate())? {
            Solve::Wanted => Some(Torque::Balance),
            Solve::Given(torque) => Some(Torque::Constant(torque)),
        },
        (None, None) => {
            if section.get("flywheel").is_none() {
                section.missing("motor", text!("scene-empty-drive"));
            }
            Some(Torque::None)
        }
    }
}

fn with_motor(section: &Section<'_>, entry: &Entry<'_>) -> Option<Torque> {
    let motor = motor(section, entry);
    let catalogue = section.get("catalogue").and_then(|entry| entry.text(text!("scene-name-of-catalogue")));
    let max_speed = section.number("max_motor_speed");
    let given = section.get("characteristic").and_then(|entry| entry.choice(CHARACTERISTICS));
    let mut characteristic = given.unwrap_or(CharacteristicKind::Kloss);
    if let Some(MotorChoice::Rated(rated)) = motor {
        let of_catalogue = ["catalogue", "max_motor_speed"];
        section.refuse(&of_catalogue, "scene-key-of-catalogue", &text!("scene-leave-it-out"));
        if rated.max_torque_ratio.is_none() {
            if given == Some(CharacteristicKind::Kloss) {
                entry.fault(text!("scene-kloss-needs-ratio"), text!("scene-or-linear"));
            }
            characteristic = CharacteristicKind::Linear;
        }
    }
    let catalogue = catalogue.map(str::to_owned);
    Some(Torque::Motor { motor: motor?, catalogue, max_speed, characteristic })
}

fn motor(drive: &Section<'_>, entry: &Entry<'_>) -> Option<MotorChoice> {
    if entry.value.is_table() {
        return rated(&drive.inner("motor")?).map(MotorChoice::Rated);
    }
    match entry.text(text!("scene-designation"))? {
        "auto" => Some(MotorChoice::Auto),
        designation => Some(MotorChoice::Designation(designation.to_owned())),
    }
}

fn rated(section: &Section<'_>) -> Option<RatedMotor> {
    let power = section.number("power");
    let synchronous = section.number("synchronous_speed");
    let rated = section.number("rated_speed");
    if let (Some(synchronous), Some(rated), Some(entry)) = (synchronous, rated, section.get("rated_speed"))
        && rated >= synchronous
    {
        entry.fault(text!("scene-no-slip"), text!("scene-motor-slips"));
    }
    let max_torque_ratio = section.number("max_torque_ratio");
    if let Some((ratio, entry)) = max_torque_ratio.zip(section.get("max_torque_ratio"))
        && !entry.is_within(ratio, (End::Excluded(1.0), End::Unbounded))
    {
        let message = text!("scene-small-torque-ratio", got = brief(ratio));
        entry.fault(message, text!("scene-breakdown-by-rated"));
    }
    let inertia = section.number("inertia");
    Some(RatedMotor {
        power: power?,
        synchronous_speed: synchronous?,
        rated_speed: rated?,
        max_torque_ratio,
        inertia,
    })
}
