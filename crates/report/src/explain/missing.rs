//! What the model of a scene leaves out.

use assur_mechanism::{Direction, GROUND, LinkId, Mechanism, Motion, Torque};

use super::model::{Remark, has_rotor, heavy, remark, used_drive};
use super::words::{links, listed};

/// What is left out, why, and how it can be included.
pub(super) fn not_modelled(mechanism: &Mechanism) -> Vec<Remark> {
    let mut list = Vec::new();
    masses(mechanism, &mut list);
    weights(mechanism, &mut list);
    motion(mechanism, &mut list);
    loads(mechanism, &mut list);
    drive(mechanism, &mut list);
    friction(mechanism, &mut list);
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

fn masses(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let moving = || 1..mechanism.links.len();
    let massless: Vec<_> = moving().filter(|id| mechanism.links[*id].mass == 0.0).collect();
    if !massless.is_empty() {
        list.push(remark(
            format!("mass of {}", links(mechanism, &massless)),
            "the scene gives none, so they have neither weight nor inertia loads; add `mass`, `center` and `inertia` to the link",
        ));
    }
    let slender =
        moving().filter(|id| mechanism.links[*id].mass > 0.0 && mechanism.links[*id].inertia == 0.0);
    let (straight, turning): (Vec<_>, Vec<_>) = slender.partition(|id| only_slides(mechanism, *id));
    if !turning.is_empty() {
        list.push(remark(
            format!("moment of inertia of {}", links(mechanism, &turning)),
            "the scene gives none; add `inertia` (about the center of mass) to the link",
        ));
    }
    if !straight.is_empty() {
        list.push(remark(
            format!("moment of inertia of {}", links(mechanism, &straight)),
            "the scene gives none, and none is missed: sliding on the ground, it never turns",
        ));
    }
}

fn weights(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let massless = heavy(mechanism).is_empty();
    let how = match (mechanism.gravity, massless) {
        (Some(_), false) => return,
        (Some(_), true) => "there is gravity, but no link has a mass; add `mass` to the links",
        (None, false) => {
            "the scene gives no gravity (a horizontal mechanism needs none); add `gravity = \"9.81 m/s^2\"`"
        }
        (None, true) => {
            "the scene gives neither gravity nor masses; add `gravity = \"9.81 m/s^2\"` and `mass` to the links"
        }
    };
    list.push(remark("weights", how));
}

fn motion(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    match &mechanism.motion {
        None => list.push(remark(
            "velocities and inertia loads",
            "the scene gives no motion; add `[motion]` with a speed",
        )),
        Some(Motion::Prescribed { .. }) => list.push(remark(
            "fluctuation of the input speed",
            "the motion is prescribed, whatever moment it takes; `kind = \"steady\"` or \"transient\" in `[motion]` finds the speed \
             from masses and loads",
        )),
        Some(Motion::Steady { .. }) => list.push(remark(
            "run-up and standstill",
            "the periodic regime alone is looked at; `kind = \"transient\"` in `[motion]` follows the motion from an initial state",
        )),
        Some(Motion::Transient { .. }) => {}
    }
}

fn loads(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let working = !(mechanism.forces.is_empty()
        && mechanism.moments.is_empty()
        && mechanism.contacts.is_empty()
        && mechanism.springs.is_empty());
    if !working {
        list.push(remark(
            "working loads",
            "the scene gives none; add `[[force]]`, `[[moment]]`, `[[spring]]` or `[[contact]]`",
        ));
    }
    if mechanism.springs.iter().all(|spring| spring.damping == 0.0) {
        list.push(remark(
            "damping, resistance of air and oil",
            "the scene gives none; add a `[[spring]]` with `damping`, or a load over the speed",
        ));
    }
}

fn drive(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let Some(drive) = used_drive(mechanism) else {
        let how = match (&mechanism.drive, &mechanism.motion) {
            (Some(_), _) => {
                "`[drive]` has no use with a motion that is prescribed or absent; take `kind = \"steady\"` or \"transient\""
            }
            (None, Some(Motion::Transient { .. } | Motion::Steady { .. })) => {
                "the scene gives no drive; add `[drive]` with `motor` and `flywheel`"
            }
            (None, _) => {
                "the input is moved as it is prescribed, by the balancing load; add `[drive]` with `motor` and `flywheel`, and \
                 `kind = \"steady\"` or \"transient\" to `[motion]`"
            }
        };
        list.push(remark("motor, reducer, rotor inertia, drive losses and flywheel", how));
        return;
    };
    if let Torque::Motor { motor, .. } = &drive.torque {
        if !has_rotor(motor) {
            list.push(remark("rotor inertia", "the rated data give none; add `inertia` to `motor`"));
        }
        list.push(remark(
            "electrical transients of the motor",
            "its torque follows the speed at once, by the steady characteristic; they can't be included",
        ));
        list.push(remark(
            "inertia and elasticity of the reducer",
            "the ratio is rigid and massless; add its inertia to `flywheel`, reduced to that shaft",
        ));
    } else {
        list.push(remark("rotor inertia", "the drive has no motor; name one with `motor` in `[drive]`"));
    }
    if drive.efficiency >= 1.0 {
        list.push(remark(
            "drive losses",
            "the reducer has no losses; add `efficiency` to `[drive]` (it counts with a motor)",
        ));
    }
    if drive.flywheel.is_none() {
        list.push(remark("flywheel", "the drive has none; add `flywheel` to `[drive]`"));
    }
}

fn friction(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let opposed: Vec<_> = mechanism
        .forces
        .iter()
        .filter(|force| force.direction == Direction::AgainstMotion)
        .map(|force| force.name.as_str())
        .collect();
    let hint = if opposed.is_empty() {
        "a known friction force is a `[[force]]` with `against_motion = true`".to_owned()
    } else {
        let names = listed(opposed);
        format!("{names}, against the motion, may stand for some of it, with the size that the scene gives")
    };
    list.push(remark(
        "friction in pairs",
        format!(
            "the pairs are ideal, so their reactions do no work, and the reactions themselves make no friction; {hint}"
        ),
    ));
}

/// What no scene can include as such.
fn always(list: &mut Vec<Remark>) {
    let each = [
        (
            "elasticity of links",
            "the links are rigid; an elastic part can be two links with a `[[spring]]` between them only where the mobility \
             stays 1",
        ),
        (
            "clearance in pairs, impacts",
            "pins and guides fit exactly; it can't be included (where a force in a guide changes its sign, the results report it)",
        ),
        ("forces across the plane", "the mechanism and all loads lie in one plane; it can't be included"),
    ];
    list.extend(each.map(|(what, how)| remark(what, how)));
}
