//! What the model of a scene contains, and what it leaves out.

use assur_mechanism::{Direction, Drive, Mechanism, Torque};

/// One thing that is or is not modelled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Remark {
    /// The thing.
    pub what: String,
    /// How it is modelled; or why it is not, and how it could be included.
    pub how: String,
}

fn remark(what: impl Into<String>, how: impl Into<String>) -> Remark {
    Remark { what: what.into(), how: how.into() }
}

fn listed(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// What the scene makes part of the model.
pub fn modelled(mechanism: &Mechanism) -> Vec<Remark> {
    let pins = mechanism.points.iter().filter(|point| point.is_pin()).count();
    let mut list = vec![
        remark("links", format!("{} moving links, rigid, in one plane", mechanism.links.len() - 1)),
        remark(
            "pairs",
            format!("{pins} pins and {} slides, ideal: no play, no friction", mechanism.slides.len()),
        ),
    ];
    let heavy: Vec<_> = mechanism.links.iter().skip(1).filter(|link| link.mass > 0.0).collect();
    if !heavy.is_empty() {
        list.push(remark("masses", format!("of {} links, at their centers of mass", heavy.len())));
    }
    if let Some([x, y]) = mechanism.gravity.filter(|_| !heavy.is_empty()) {
        list.push(remark("weights", format!("gravity ({x}, {y}) m/s^2")));
    }
    loads(mechanism, &mut list);
    if let Some(drive) = &mechanism.drive {
        list.push(remark("drive", "torque of the drive at the input shaft, efficiency of the reducer"));
        if drive.flywheel.is_some() {
            list.push(remark("flywheel", "a constant moment of inertia on its shaft"));
        }
    }
    list
}

fn loads(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let forces: Vec<_> = mechanism.forces.iter().map(|force| force.name.as_str()).collect();
    let moments: Vec<_> = mechanism.moments.iter().map(|moment| moment.name.as_str()).collect();
    let springs: Vec<_> = mechanism.springs.iter().map(|spring| spring.name.as_str()).collect();
    let contacts: Vec<_> = mechanism.contacts.iter().map(|contact| contact.name.as_str()).collect();
    let kinds = [
        ("forces", forces, "at points of links"),
        ("moments", moments, "on links"),
        ("springs and dampers", springs, "massless, along the line between their ends"),
        (
            "contacts",
            contacts,
            "an arc on a straight line of the ground, with the force and friction that are given",
        ),
    ];
    for (what, names, how) in kinds {
        if !names.is_empty() {
            list.push(remark(what, format!("{}: {how}", listed(&names))));
        }
    }
}

/// What is left out, why, and how it can be included.
pub fn not_modelled(mechanism: &Mechanism) -> Vec<Remark> {
    let mut list = Vec::new();
    let moving = || mechanism.links.iter().skip(1);
    let massless: Vec<_> = moving().filter(|link| link.mass == 0.0).map(|link| link.name.as_str()).collect();
    if !massless.is_empty() {
        list.push(remark(
            format!("mass of {}", listed(&massless)),
            "the scene gives none; add `mass`, `center` and `inertia` to the link",
        ));
    }
    let slender: Vec<_> = moving()
        .filter(|link| link.mass > 0.0 && link.inertia == 0.0)
        .map(|link| link.name.as_str())
        .collect();
    if !slender.is_empty() {
        list.push(remark(
            format!("moment of inertia of {}", listed(&slender)),
            "the scene gives none; add `inertia` (about the center of mass) to the link",
        ));
    }
    if mechanism.gravity.is_none() {
        list.push(remark("weights", "the scene gives no gravity; add `gravity = \"9.81 m/s^2\"`"));
    }
    if mechanism.motion.is_none() {
        list.push(remark(
            "velocities and inertia loads",
            "the scene gives no motion; add `[motion]` with a speed",
        ));
    }
    drive(mechanism.drive.as_ref(), &mut list);
    always(mechanism, &mut list);
    list
}

fn drive(drive: Option<&Drive>, list: &mut Vec<Remark>) {
    let Some(drive) = drive else {
        list.push(remark(
            "motor, reducer, rotor inertia and flywheel",
            "the scene gives no drive; add `[drive]` with `motor` and `flywheel`",
        ));
        return;
    };
    if !matches!(drive.torque, Torque::Motor { .. }) {
        list.push(remark("rotor inertia", "the drive has no motor; name one with `motor` in `[drive]`"));
    }
    if drive.flywheel.is_none() {
        list.push(remark("flywheel", "the drive has none; add `flywheel` to `[drive]`"));
    }
}

/// What no scene can include as such.
fn always(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let opposed = mechanism.forces.iter().any(|force| force.direction == Direction::AgainstMotion);
    let hint = if opposed {
        "as the loads with `against_motion` do where they stand for friction"
    } else {
        "a known friction force is a `[[force]]` with `against_motion = true`"
    };
    list.push(remark(
        "friction in pairs",
        format!("the pairs are ideal, so their reactions do no work; {hint}"),
    ));
    list.push(remark(
        "elasticity of links",
        "the links are rigid; an elastic part can be two links with a `[[spring]]` between them only where the \
         mobility stays 1",
    ));
    list.push(remark("clearance in pairs", "pins and guides fit exactly; it can't be included"));
    list.push(remark(
        "forces across the plane",
        "the mechanism and all loads lie in one plane; it can't be included",
    ));
}
