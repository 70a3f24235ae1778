//! What the model of a scene contains.

use assur_mechanism::{Contact, Direction, Drive, LinkId, Mechanism, Motion, Motor, Over, Torque, Value};

use super::words::count;

/// One thing that is or is not modelled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Remark {
    /// The thing.
    pub(super) what: String,
    /// How it is modelled; or why it is not, and how it could be included.
    pub(super) how: String,
}

pub(super) fn remark(what: impl Into<String>, how: impl Into<String>) -> Remark {
    Remark { what: what.into(), how: how.into() }
}

/// The parts of the model that the scene defines.
pub(super) fn modelled(mechanism: &Mechanism) -> Vec<Remark> {
    let pins = mechanism.points.iter().filter(|point| point.is_pin()).count();
    let mut list = vec![
        remark("links", format!("{}, rigid, in one plane", count(mechanism.links.len() - 1, "moving link"))),
        remark(
            "pairs",
            format!(
                "{} and {}, ideal: no play, no friction",
                count(pins, "pin"),
                count(mechanism.slides.len(), "slide")
            ),
        ),
    ];
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
    let found = matches!(mechanism.motion, Some(Motion::Transient { .. } | Motion::Steady { .. }));
    mechanism.drive.as_ref().filter(|_| found)
}

/// Whether a motor has a rotor with inertia; rated data may give none.
pub(super) fn has_rotor(motor: &Motor) -> bool {
    match motor {
        Motor::Rated(rated) => rated.inertia.is_some_and(|inertia| inertia > 0.0),
        Motor::Auto | Motor::Designation(_) => true,
    }
}

fn masses(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let heavy = heavy(mechanism);
    if heavy.is_empty() {
        return;
    }
    let sum: f64 = heavy.iter().map(|id| mechanism.links[*id].mass).sum();
    list.push(remark(
        "masses",
        format!("of {}, {sum} kg in all, at their centers of mass", count(heavy.len(), "link")),
    ));
    if let Some([x, y]) = mechanism.gravity {
        list.push(remark("weights", format!("gravity ({x}, {y}) m/s^2")));
    }
}

fn motion(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let how = match mechanism.motion {
        None => return,
        Some(Motion::Prescribed { .. }) => {
            if heavy(mechanism).is_empty() {
                "speed and acceleration of the input are prescribed, the same in every position; time counts from the first \
                 position and follows from both"
            } else {
                "speed and acceleration of the input are prescribed, the same in every position; time counts from the first \
                 position and follows from both; inertia loads follow from them"
            }
        }
        Some(Motion::Transient { .. }) => "found from the initial state: masses and loads against each other",
        Some(Motion::Steady { .. }) => {
            "the periodic regime: the speed comes back after every cycle, run-up is not looked at"
        }
    };
    list.push(remark("motion", how));
}

fn loads(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let link = |id: LinkId| mechanism.links[id].name.as_str();
    for force in &mechanism.forces {
        let direction = match force.direction {
            Direction::AgainstMotion => ", always against the motion of its point",
            Direction::Link(_) => ", in a direction that turns with the link",
            Direction::Ground(_) => ", in a fixed direction",
        };
        let on = link(force.at.link);
        let how = format!("at a point of `{on}`, {}{direction}", law(&force.value));
        list.push(remark(format!("force `{}`", force.name), how));
    }
    for moment in &mechanism.moments {
        let (on, law) = (link(moment.link), law(&moment.value));
        list.push(if moment.brake.is_some() {
            let how = format!("a shoe on the disc of `{on}`, its moment always against the rotation, the pressing force {law}");
            remark(format!("brake `{}`", moment.name), how)
        } else {
            remark(format!("moment `{}`", moment.name), format!("on `{on}`, {law}"))
        });
    }
    for spring in &mechanism.springs {
        let [one, two] = spring.ends.map(|end| link(end.link));
        let damped = if spring.damping == 0.0 { "without damping" } else { "with damping" };
        let how = format!(
            "between `{one}` and `{two}`, massless, along the line between its ends, linear, {damped}"
        );
        list.push(remark(format!("spring `{}`", spring.name), how));
    }
    for contact in &mechanism.contacts {
        list.push(remark(format!("contact `{}`", contact.name), contact_words(contact)));
    }
}

/// How the size of a load is given.
fn law(value: &Value) -> &'static str {
    match value {
        Value::Constant(_) => "constant",
        Value::Table { over: Over::Coordinate, .. } => "by a table over the input coordinate",
        Value::Table { over: Over::Speed, .. } => {
            "by a table over the input speed, which is counted along the direction of the input"
        }
        Value::Table { over: Over::Time, .. } => "by a table over time",
        Value::Formula { formula, .. } if formula.used().speed => {
            "by a formula, whose `w` is the input speed along the direction of the input"
        }
        Value::Formula { .. } => "by a formula",
        Value::Stroke { .. } => "by tables over the stroke of the point, forward and back",
    }
}

fn contact_words(contact: &Contact) -> String {
    let rubs = if contact.friction == 0.0 {
        "without friction (add `friction` to the `[[contact]]`)"
    } else if contact.against_sliding {
        "its friction is a given part of the force, against the sliding of the arc"
    } else {
        "its friction is a given part of the force, in a given sense"
    };
    let touches = if contact.during.is_some() { "in its interval" } else { "in every position" };
    format!("an arc on a straight line of the ground, {touches}, with the force that is given; {rubs}")
}

fn drive_remarks(drive: &Drive, list: &mut Vec<Remark>) {
    let torque = match &drive.torque {
        Torque::Motor { .. } => {
            "the motor's torque by its steady characteristic over speed, through the gear ratio, at the input shaft"
        }
        Torque::Balance => "a constant torque at the input shaft, which makes the work of a cycle zero",
        Torque::Constant(_) => "a constant torque at the input shaft, along the direction of the input",
        Torque::None => "no torque: the drive has neither `motor` nor `torque`",
    };
    list.push(remark("drive", torque));
    if matches!(&drive.torque, Torque::Motor { motor, .. } if has_rotor(motor)) {
        list.push(remark(
            "rotor inertia",
            "of the motor, at the input shaft with the square of the gear ratio",
        ));
    }
    if drive.efficiency < 1.0 {
        let how =
            format!("a constant efficiency of the reducer, {}, whatever speed and load", drive.efficiency);
        list.push(remark("drive losses", how));
    }
    if drive.flywheel.is_some() {
        list.push(remark("flywheel", "a constant moment of inertia on its shaft"));
    }
}
