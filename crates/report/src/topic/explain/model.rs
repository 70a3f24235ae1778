//! What the model of a scene contains, and what it leaves out.

use assur_book::{Unit, link_name};
use assur_mechanism::{
    Contact, Direction, Drive, Friction, GROUND, LinkId, Load, LoadKind, Mechanism, Middle, Motion,
    MotorChoice, Over, Surfaces, Torque, Value,
};
use assur_motor::find_motor;
use assur_words::{Text, list as listed, number, quantity, text};

use super::{links, remark};

/// A remark without values.
fn say(what: &'static str, how: &'static str) -> Text {
    remark(text!(what), text!(how))
}

/// The parts of the model that the scene defines.
pub(super) fn modelled(mechanism: &Mechanism) -> Vec<Text> {
    let pins = mechanism.points.iter().filter(|point| point.is_pin()).count();
    let pairs = if mechanism.frictions.is_empty() { "model-pairs-how" } else { "model-pairs-friction" };
    let mut list = vec![
        remark(text!("model-links"), text!("model-links-how", count = mechanism.links.len() - 1)),
        remark(text!("model-pairs"), text!(pairs, pins, slides = mechanism.slides.len())),
    ];
    list.extend(mechanism.frictions.iter().map(|friction| friction_of_pair(mechanism, friction)));
    list.extend(masses(mechanism));
    list.extend(motion(mechanism));
    let loads = mechanism.loads.iter();
    list.extend(loads.map(|load| remark((&load.name).into(), acts(mechanism, &load.kind))));
    list.extend(used_drive(mechanism).into_iter().flat_map(drive_remarks));
    list
}

/// Moving links with a mass.
fn heavy(mechanism: &Mechanism) -> Vec<LinkId> {
    (1..mechanism.links.len()).filter(|id| mechanism.links[*id].mass > 0.0).collect()
}

/// The drive, if the motion uses it.
fn used_drive(mechanism: &Mechanism) -> Option<&Drive> {
    let found = mechanism.has_equation_of_motion();
    mechanism.drive.as_ref().filter(|_| found)
}

/// Whether the inertia of the rotor of a motor is known; rated data and catalogues may give none. `None` for a motor that is yet to be
/// chosen.
fn has_rotor(motor: &MotorChoice, catalogue: Option<&str>) -> Option<bool> {
    match motor {
        MotorChoice::Rated(rated) => Some(rated.inertia.is_some_and(|inertia| inertia > 0.0)),
        MotorChoice::Designation(designation) => {
            Some(find_motor(catalogue, designation).is_ok_and(|motor| motor.rotor_inertia.is_some()))
        }
        MotorChoice::Auto => None,
    }
}

fn masses(mechanism: &Mechanism) -> Vec<Text> {
    let heavy = heavy(mechanism);
    if heavy.is_empty() {
        return Vec::new();
    }
    let sum: f64 = heavy.iter().map(|id| mechanism.links[*id].mass).sum();
    let how = text!("model-masses-how", count = heavy.len(), sum = Unit::KILOGRAM.show(sum));
    let gravity = mechanism.gravity.map(|gravity| Unit::MOVING[1].show_all(&gravity));
    let weights =
        gravity.map(|gravity| remark(text!("missing-weights"), text!("model-weights-how", gravity)));
    std::iter::once(remark(text!("model-masses"), how)).chain(weights).collect()
}

fn motion(mechanism: &Mechanism) -> Option<Text> {
    let how = match mechanism.motion.as_ref()? {
        _ if mechanism.input.kind().is_time() => "model-laws-over-time",
        Motion::Prescribed { .. } if heavy(mechanism).is_empty() => "model-prescribed",
        Motion::Prescribed { .. } => "model-prescribed-with-inertia",
        Motion::Transient { .. } => "model-transient",
        Motion::Steady { .. } => "model-steady",
    };
    Some(say("model-motion", how))
}

/// Where and how a load acts, in words.
fn acts(mechanism: &Mechanism, load: &LoadKind) -> Text {
    let link = |id: LinkId| link_name(mechanism, id);
    match load {
        LoadKind::Force(force) => {
            let direction = match force.direction {
                Direction::AgainstMotion => text!("model-against-motion"),
                Direction::Link(_) => text!("model-turns-with-link"),
                Direction::Ground(_) => text!("model-fixed-direction"),
            };
            listed([text!("model-at-point", link = link(force.at.link)), law(&force.value), direction])
        }
        LoadKind::Moment(moment) => {
            let told = text!("model-moment", link = link(moment.link), law = law(&moment.value));
            if moment.against_motion { listed([told, text!("model-against-rotation")]) } else { told }
        }
        LoadKind::Brake(brake) => text!("model-brake", link = link(brake.link), law = law(&brake.force)),
        LoadKind::Spring(spring) => {
            let [one, other] = spring.ends.map(|end| link(end.link));
            let damped = if spring.damping == 0.0 { text!("model-undamped") } else { text!("model-damped") };
            text!("model-spring", one, other, damped)
        }
        LoadKind::Contact(contact) => contact_words(contact),
    }
}

/// How the size of a load is given.
fn law(value: &Value) -> Text {
    match value {
        Value::Constant(_) => text!("model-constant"),
        Value::Table { over: Over::Coordinate, .. } => text!("model-over-coordinate"),
        Value::Table { over: Over::Speed, .. } => text!("model-over-speed"),
        Value::Table { over: Over::Time, .. } => text!("model-over-time"),
        Value::Formula { formula, .. } if formula.used().speed => text!("model-formula-speed"),
        Value::Formula { .. } => text!("model-formula"),
        Value::Stroke { .. } => text!("model-stroke"),
    }
}

fn contact_words(contact: &Contact) -> Text {
    let friction = if contact.friction == 0.0 {
        text!("model-contact-smooth")
    } else if contact.against_sliding {
        text!("model-contact-against-sliding")
    } else {
        text!("model-contact-rough")
    };
    let during = contact.during.is_some();
    let touches = if during { text!("model-contact-interval") } else { text!("model-contact-always") };
    text!("model-contact", touches, friction)
}

fn drive_remarks(drive: &Drive) -> Vec<Text> {
    let (torque, rotor) = match &drive.torque {
        Torque::Motor { motor, catalogue, .. } => {
            ("model-drive-motor", has_rotor(motor, catalogue.as_deref()))
        }
        Torque::Balance => ("model-drive-balance", Some(false)),
        Torque::Constant(_) => ("model-drive-constant", Some(false)),
        Torque::None => ("model-drive-none", Some(false)),
    };
    let mut list = vec![say("model-drive", torque)];
    if rotor != Some(false) {
        let how = if rotor.is_some() { "model-rotor" } else { "model-rotor-of-chosen" };
        list.push(say("missing-rotor", how));
    }
    if drive.efficiency < 1.0 {
        let how = text!("model-losses", efficiency = number(drive.efficiency));
        list.push(remark(text!("missing-losses"), how));
    }
    list.extend(drive.flywheel.map(|_| say("missing-flywheel", "model-flywheel")));
    list
}

fn friction_of_pair(mechanism: &Mechanism, friction: &Friction) -> Text {
    let length = |length: f64| quantity((1e9 * length).round() / 1e6, "mm");
    let pair = Text::from(mechanism.pair_name(friction.pair));
    let coefficient = number(friction.coefficient);
    let how = match friction.surfaces {
        Surfaces::Journal { radius, owner } => {
            let owner = Text::from(&mechanism.links[owner].name);
            text!("model-journal", coefficient, radius = length(radius), owner)
        }
        Surfaces::Place => text!("model-pressed-place", coefficient),
        Surfaces::Faces { length: contact, middle, offset } => {
            let id = match middle {
                Middle::Point => "model-pressed-ends",
                Middle::Through => "model-pressed-bushing",
            };
            text!(id, coefficient, length = length(contact), offset = length(offset))
        }
    };
    remark(text!("model-friction", pair), how)
}

/// What is left out, why, and how it can be included.
pub(super) fn not_modelled(mechanism: &Mechanism) -> Vec<Text> {
    let mut list = missing_masses(mechanism);
    list.extend(missing_weights(mechanism));
    list.extend(missing_motion(mechanism));
    list.extend(missing_loads(mechanism));
    list.extend(missing_drive(mechanism));
    list.extend(missing_friction(mechanism));
    // What no scene can include as such.
    list.extend([
        say("missing-elasticity", "missing-elasticity-how"),
        say("missing-clearance", "missing-clearance-how"),
        say("missing-spatial", "missing-spatial-how"),
    ]);
    list
}

/// Whether a link slides on the ground, so that it never turns.
fn only_slides(mechanism: &Mechanism, link: LinkId) -> bool {
    mechanism.slides.iter().any(|slide| {
        let pair = [slide.link, slide.on];
        pair.contains(&GROUND) && pair.contains(&link)
    })
}

fn missing_masses(mechanism: &Mechanism) -> Vec<Text> {
    let (of, moving) = (|id: &LinkId| &mechanism.links[*id], || 1..mechanism.links.len());
    let massless = moving().filter(|id| of(id).mass == 0.0);
    let (nothing, rotors): (Vec<_>, Vec<_>) = massless.partition(|id| of(id).inertia.is_none());
    let slender = moving().filter(|id| of(id).mass > 0.0 && of(id).inertia.is_none());
    let (straight, turning): (Vec<_>, Vec<_>) = slender.partition(|id| only_slides(mechanism, *id));
    let all = [
        ("missing-mass", nothing, "missing-mass-how"),
        ("missing-mass", rotors, "missing-mass-of-rotor"),
        ("missing-inertia", turning, "missing-inertia-how"),
        ("missing-inertia", straight, "missing-inertia-needless"),
    ];
    let some = all.into_iter().filter(|(_, of, _)| !of.is_empty());
    some.map(|(what, of, how)| remark(text!(what, links = links(mechanism, &of)), text!(how))).collect()
}

fn missing_weights(mechanism: &Mechanism) -> Option<Text> {
    let how = match (mechanism.gravity, heavy(mechanism).is_empty()) {
        (Some(_), false) => return None,
        (Some(_), true) => "missing-weights-mass",
        (None, false) => "missing-weights-gravity",
        (None, true) => "missing-weights-both",
    };
    Some(say("missing-weights", how))
}

fn missing_motion(mechanism: &Mechanism) -> Option<Text> {
    match &mechanism.motion {
        None => Some(say("missing-velocities", "missing-velocities-how")),
        Some(_) if mechanism.input.kind().is_time() => {
            Some(say("missing-fluctuation", "missing-fluctuation-over-time"))
        }
        Some(Motion::Prescribed { .. }) => Some(say("missing-fluctuation", "missing-fluctuation-how")),
        Some(Motion::Steady { .. }) => Some(say("missing-run-up", "missing-run-up-how")),
        Some(Motion::Transient { .. }) => None,
    }
}

fn missing_loads(mechanism: &Mechanism) -> impl Iterator<Item = Text> {
    let damped = |load: &Load| load.kind.spring().is_some_and(|spring| spring.damping != 0.0);
    let none = mechanism.loads.is_empty().then(|| say("missing-loads", "missing-loads-how"));
    let undamped = !mechanism.loads.iter().any(damped);
    let is_timed = mechanism.input.kind().is_time();
    let how = if is_timed { "missing-damping-over-time" } else { "missing-damping-how" };
    none.into_iter().chain(undamped.then(|| say("missing-damping", how)))
}

fn missing_drive(mechanism: &Mechanism) -> Vec<Text> {
    let Some(drive) = used_drive(mechanism) else {
        let how = match (&mechanism.drive, &mechanism.motion) {
            _ if mechanism.input.kind().is_time() => "missing-drive-over-time",
            (Some(_), _) => "missing-drive-useless",
            (None, Some(Motion::Transient { .. } | Motion::Steady { .. })) => "missing-drive-how",
            (None, _) => "missing-drive-prescribed",
        };
        return vec![say("missing-drive", how)];
    };
    let mut list = Vec::new();
    if let Torque::Motor { motor, catalogue, .. } = &drive.torque {
        if has_rotor(motor, catalogue.as_deref()) == Some(false) {
            let is_rated = matches!(motor, MotorChoice::Rated(_));
            let how = if is_rated { "missing-rotor-how" } else { "missing-rotor-of-catalogue" };
            list.push(say("missing-rotor", how));
        }
        list.push(say("missing-electrical", "missing-electrical-how"));
        list.push(say("missing-reducer", "missing-reducer-how"));
    } else {
        list.push(say("missing-rotor", "missing-rotor-no-motor"));
    }
    list.extend((drive.efficiency >= 1.0).then(|| say("missing-losses", "missing-losses-how")));
    list.extend(drive.flywheel.is_none().then(|| say("missing-flywheel", "missing-flywheel-how")));
    list
}

fn missing_friction(mechanism: &Mechanism) -> Option<Text> {
    if !mechanism.frictions.is_empty() {
        let pins = mechanism.points.iter().filter(|point| point.is_pin()).count();
        let everywhere = mechanism.frictions.len() >= pins + mechanism.slides.len();
        let elsewhere = || say("missing-friction-elsewhere", "missing-friction-elsewhere-how");
        return (!everywhere).then(elsewhere);
    }
    let forces = |load: &&Load| load.kind.brake().is_none() && load.kind.is_against_motion();
    let opposed = listed(mechanism.loads.iter().filter(forces).map(|load| (&load.name).into()));
    let how = if opposed.is_empty() {
        text!("missing-friction-how")
    } else {
        text!("missing-friction-given", forces = opposed)
    };
    Some(remark(text!("missing-friction"), how))
}
