//! What the model of a scene contains, and what it leaves out.

use assur_book::{Unit, link_name};
use assur_mechanism::{
    Contact, Direction, Drive, Friction, GROUND, LinkId, Load, LoadKind, Mechanism, Middle, Motion,
    MotorChoice, Over, Surfaces, Torque, Value,
};
use assur_motor::find_motor;
use assur_structure::name_of;
use assur_words::{Text, list as listed, number, quantity, text};

use super::{links, remark};

/// The parts of the model that the scene defines.
pub(super) fn modelled(mechanism: &Mechanism) -> Vec<Text> {
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

fn masses(mechanism: &Mechanism, list: &mut Vec<Text>) {
    let heavy = heavy(mechanism);
    if heavy.is_empty() {
        return;
    }
    let sum: f64 = heavy.iter().map(|id| mechanism.links[*id].mass).sum();
    let how = text!("model-masses-how", count = heavy.len(), sum = Unit::KILOGRAM.show(sum));
    list.push(remark(text!("model-masses"), how));
    if let Some(gravity) = mechanism.gravity {
        let gravity = Unit::MOVING[1].show_all(&gravity);
        list.push(remark(text!("missing-weights"), text!("model-weights-how", gravity)));
    }
}

fn motion(mechanism: &Mechanism, list: &mut Vec<Text>) {
    let how = match mechanism.motion {
        None => return,
        Some(Motion::Prescribed { .. }) if heavy(mechanism).is_empty() => text!("model-prescribed"),
        Some(Motion::Prescribed { .. }) => text!("model-prescribed-with-inertia"),
        Some(Motion::Transient { .. }) => text!("model-transient"),
        Some(Motion::Steady { .. }) => text!("model-steady"),
    };
    list.push(remark(text!("model-motion"), how));
}

fn loads(mechanism: &Mechanism, list: &mut Vec<Text>) {
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

fn drive_remarks(drive: &Drive, list: &mut Vec<Text>) {
    let torque = match &drive.torque {
        Torque::Motor { .. } => text!("model-drive-motor"),
        Torque::Balance => text!("model-drive-balance"),
        Torque::Constant(_) => text!("model-drive-constant"),
        Torque::None => text!("model-drive-none"),
    };
    list.push(remark(text!("model-drive"), torque));
    if let Torque::Motor { motor, catalogue, .. } = &drive.torque {
        match has_rotor(motor, catalogue.as_deref()) {
            Some(true) => list.push(remark(text!("missing-rotor"), text!("model-rotor"))),
            None => list.push(remark(text!("missing-rotor"), text!("model-rotor-of-chosen"))),
            Some(false) => {}
        }
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
fn friction_of_pair(mechanism: &Mechanism, friction: &Friction) -> Text {
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

/// What is left out, why, and how it can be included.
pub(super) fn not_modelled(mechanism: &Mechanism) -> Vec<Text> {
    let mut list = Vec::new();
    missing_masses(mechanism, &mut list);
    missing_weights(mechanism, &mut list);
    missing_motion(mechanism, &mut list);
    missing_loads(mechanism, &mut list);
    missing_drive(mechanism, &mut list);
    missing_friction(mechanism, &mut list);
    always(&mut list);
    list
}

/// Whether a link slides on the ground, so that it never turns.
fn only_slides(mechanism: &Mechanism, link: LinkId) -> bool {
    mechanism.slides.iter().any(|slide| {
        let pair = [slide.link, slide.on];
        pair.contains(&GROUND) && pair.contains(&link)
    })
}

fn missing_masses(mechanism: &Mechanism, list: &mut Vec<Text>) {
    let moving = || 1..mechanism.links.len();
    let massless = moving().filter(|id| mechanism.links[*id].mass == 0.0);
    let (nothing, rotors): (Vec<_>, Vec<_>) = massless.partition(|id| mechanism.links[*id].inertia.is_none());
    for (of, how) in [(nothing, text!("missing-mass-how")), (rotors, text!("missing-mass-of-rotor"))] {
        if !of.is_empty() {
            list.push(remark(text!("missing-mass", links = links(mechanism, &of)), how));
        }
    }
    let slender =
        moving().filter(|id| mechanism.links[*id].mass > 0.0 && mechanism.links[*id].inertia.is_none());
    let (straight, turning): (Vec<_>, Vec<_>) = slender.partition(|id| only_slides(mechanism, *id));
    for (of, how) in [(turning, text!("missing-inertia-how")), (straight, text!("missing-inertia-needless"))]
    {
        if !of.is_empty() {
            list.push(remark(text!("missing-inertia", links = links(mechanism, &of)), how));
        }
    }
}

fn missing_weights(mechanism: &Mechanism, list: &mut Vec<Text>) {
    let massless = heavy(mechanism).is_empty();
    let how = match (mechanism.gravity, massless) {
        (Some(_), false) => return,
        (Some(_), true) => text!("missing-weights-mass"),
        (None, false) => text!("missing-weights-gravity"),
        (None, true) => text!("missing-weights-both"),
    };
    list.push(remark(text!("missing-weights"), how));
}

fn missing_motion(mechanism: &Mechanism, list: &mut Vec<Text>) {
    match &mechanism.motion {
        None => list.push(remark(text!("missing-velocities"), text!("missing-velocities-how"))),
        Some(Motion::Prescribed { .. }) => {
            list.push(remark(text!("missing-fluctuation"), text!("missing-fluctuation-how")));
        }
        Some(Motion::Steady { .. }) => {
            list.push(remark(text!("missing-run-up"), text!("missing-run-up-how")));
        }
        Some(Motion::Transient { .. }) => {}
    }
}

fn missing_loads(mechanism: &Mechanism, list: &mut Vec<Text>) {
    if mechanism.loads.is_empty() {
        list.push(remark(text!("missing-loads"), text!("missing-loads-how")));
    }
    let damped = |load: &Load| load.kind.spring().is_some_and(|spring| spring.damping != 0.0);
    if !mechanism.loads.iter().any(damped) {
        list.push(remark(text!("missing-damping"), text!("missing-damping-how")));
    }
}

fn missing_drive(mechanism: &Mechanism, list: &mut Vec<Text>) {
    let Some(drive) = used_drive(mechanism) else {
        let how = match (&mechanism.drive, &mechanism.motion) {
            (Some(_), _) => text!("missing-drive-useless"),
            (None, Some(Motion::Transient { .. } | Motion::Steady { .. })) => text!("missing-drive-how"),
            (None, _) => text!("missing-drive-prescribed"),
        };
        list.push(remark(text!("missing-drive"), how));
        return;
    };
    if let Torque::Motor { motor, catalogue, .. } = &drive.torque {
        if has_rotor(motor, catalogue.as_deref()) == Some(false) {
            let how = match motor {
                MotorChoice::Rated(_) => text!("missing-rotor-how"),
                _ => text!("missing-rotor-of-catalogue"),
            };
            list.push(remark(text!("missing-rotor"), how));
        }
        list.push(remark(text!("missing-electrical"), text!("missing-electrical-how")));
        list.push(remark(text!("missing-reducer"), text!("missing-reducer-how")));
    } else {
        list.push(remark(text!("missing-rotor"), text!("missing-rotor-no-motor")));
    }
    if drive.efficiency >= 1.0 {
        list.push(remark(text!("missing-losses"), text!("missing-losses-how")));
    }
    if drive.flywheel.is_none() {
        list.push(remark(text!("missing-flywheel"), text!("missing-flywheel-how")));
    }
}

fn missing_friction(mechanism: &Mechanism, remarks: &mut Vec<Text>) {
    if !mechanism.frictions.is_empty() {
        let pins = mechanism.points.iter().filter(|point| point.is_pin()).count();
        if mechanism.frictions.len() < pins + mechanism.slides.len() {
            remarks
                .push(remark(text!("missing-friction-elsewhere"), text!("missing-friction-elsewhere-how")));
        }
        return;
    }
    let forces = |load: &&Load| load.kind.force().is_some() && load.kind.is_against_motion();
    let opposed = mechanism.loads.iter().filter(forces);
    let opposed = listed(opposed.map(|load| (&load.name).into()));
    let how = if opposed.is_empty() {
        text!("missing-friction-how")
    } else {
        text!("missing-friction-given", forces = opposed)
    };
    remarks.push(remark(text!("missing-friction"), how));
}

/// What no scene can include as such.
fn always(list: &mut Vec<Text>) {
    list.extend([
        remark(text!("missing-elasticity"), text!("missing-elasticity-how")),
        remark(text!("missing-clearance"), text!("missing-clearance-how")),
        remark(text!("missing-spatial"), text!("missing-spatial-how")),
    ]);
}
