//! What the model of a scene contains.

use assur_book::{Unit, link_name};
use assur_mechanism::{
    Contact, Direction, Drive, Friction, LinkId, LoadKind, Mechanism, Middle, Motion, MotorChoice, Over,
    Surfaces, Torque, Value,
};
use assur_structure::name_of;
use assur_words::{Text, list as listed, number, quantity, text};

use crate::topic::explain::{Remark, remark};

/// The parts of the model that the scene defines.
pub(super) fn modelled(mechanism: &Mechanism) -> Vec<Remark> {
    let pins = mechanism.points.iter().filter(|point| point.is_pin()).count();
    let pairs = if mechanism.frictions.is_empty() { "model-pairs-how" } else { "model-pairs-friction" };
    let mut list = vec![
        remark(text!("model-links"), text!("model-links-how", count = mechanism.links.len() - 1)),
        remark(text!("model-pairs"), text!(pairs, pins = pins, slides = mechanism.slides.len())),
    ];
    list.extend(mechanism.frictions.iter().map(|friction| friction_of_pair(mechanism, friction)));
    masses(mechanism, &mut list);
    motion(mechanism, &mut list);
    loads(mechanism, &mut list);
    if let Some(drive) = used_drive(mechanism) {
        drive_remarks(drive, &mut list);
    }
    list
}

/// Moving links with a mass.
pub(super) fn heavy(mechanism: &Mechanism) -> Vec<LinkId> {
    (1..mechanism.links.len()).filter(|id| mechanism.links[*id].mass > 0.0).collect()
}

/// The drive, if the motion uses it.
pub(super) fn used_drive(mechanism: &Mechanism) -> Option<&Drive> {
    let found = mechanism.has_equation_of_motion();
    mechanism.drive.as_ref().filter(|_| found)
}

/// Whether a motor has a rotor with inertia; rated data may give none.
pub(super) fn has_rotor(motor: &MotorChoice) -> bool {
    match motor {
        MotorChoice::Rated(rated) => rated.inertia.is_some_and(|inertia| inertia > 0.0),
        MotorChoice::Auto | MotorChoice::Designation(_) => true,
    }
}

fn masses(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let heavy = heavy(mechanism);
    if heavy.is_empty() {
        return;
    }
    let sum: f64 = heavy.iter().map(|id| mechanism.links[*id].mass).sum();
    let how = text!("model-masses-how", count = heavy.len(), sum = Unit::of("kg", 1.0).show(sum));
    list.push(remark(text!("model-masses"), how));
    if let Some(gravity) = mechanism.gravity {
        let gravity = Unit::of("m/s²", 1.0).show_all(&gravity);
        list.push(remark(text!("missing-weights"), text!("model-weights-how", gravity)));
    }
}

fn motion(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let how = match mechanism.motion {
        None => return,
        Some(Motion::Prescribed { .. }) if heavy(mechanism).is_empty() => text!("model-prescribed"),
        Some(Motion::Prescribed { .. }) => text!("model-prescribed-with-inertia"),
        Some(Motion::Transient { .. }) => text!("model-transient"),
        Some(Motion::Steady { .. }) => text!("model-steady"),
    };
    list.push(remark(text!("model-motion"), how));
}

fn loads(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    list.extend(mechanism.loads.iter().map(|load| remark((&load.name).into(), acts(mechanism, &load.kind))));
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
            text!("model-moment", link = link(moment.link), law = law(&moment.value))
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
    let touches = if contact.during.is_some() {
        text!("model-contact-interval")
    } else {
        text!("model-contact-always")
    };
    text!("model-contact", touches, friction)
}

fn drive_remarks(drive: &Drive, list: &mut Vec<Remark>) {
    let torque = match &drive.torque {
        Torque::Motor { .. } => text!("model-drive-motor"),
        Torque::Balance => text!("model-drive-balance"),
        Torque::Constant(_) => text!("model-drive-constant"),
        Torque::None => text!("model-drive-none"),
    };
    list.push(remark(text!("model-drive"), torque));
    if matches!(&drive.torque, Torque::Motor { motor, .. } if has_rotor(motor)) {
        list.push(remark(text!("missing-rotor"), text!("model-rotor")));
    }
    if drive.efficiency < 1.0 {
        let how = text!("model-losses", efficiency = number(drive.efficiency));
        list.push(remark(text!("missing-losses"), how));
    }
    if drive.flywheel.is_some() {
        list.push(remark(text!("missing-flywheel"), text!("model-flywheel")));
    }
}

/// The dry friction of a pair.
fn friction_of_pair(mechanism: &Mechanism, friction: &Friction) -> Remark {
    let length = |length: f64| quantity((1e9 * length).round() / 1e6, "mm");
    let pair = Text::from(name_of(mechanism, friction.pair));
    let coefficient = number(friction.coefficient);
    let how = match friction.surfaces {
        Surfaces::Journal { radius, owner } => {
            let owner = Text::from(&mechanism.links[owner].name);
            text!("model-journal", coefficient = coefficient, radius = length(radius), owner = owner)
        }
        Surfaces::Place => text!("model-pressed-place", coefficient = coefficient),
        Surfaces::Faces { length: contact, middle, offset } => {
            let id = match middle {
                Middle::Point => "model-pressed-ends",
                Middle::Through => "model-pressed-bushing",
            };
            text!(id, coefficient = coefficient, length = length(contact), offset = length(offset))
        }
    };
    remark(text!("model-friction", pair = pair), how)
}
