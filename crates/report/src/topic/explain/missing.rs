//! What the model of a scene leaves out.

use assur_mechanism::{GROUND, LinkId, Load, Mechanism, Motion, MotorChoice, Torque};
use assur_words::{list, text};

use super::model::{has_rotor, heavy, used_drive};
use crate::topic::explain::{Remark, links, remark};

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
        let of = links(mechanism, &massless);
        list.push(remark(text!("missing-mass", links = of), text!("missing-mass-how")));
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

fn weights(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    let massless = heavy(mechanism).is_empty();
    let how = match (mechanism.gravity, massless) {
        (Some(_), false) => return,
        (Some(_), true) => text!("missing-weights-mass"),
        (None, false) => text!("missing-weights-gravity"),
        (None, true) => text!("missing-weights-both"),
    };
    list.push(remark(text!("missing-weights"), how));
}

fn motion(mechanism: &Mechanism, list: &mut Vec<Remark>) {
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

fn loads(mechanism: &Mechanism, list: &mut Vec<Remark>) {
    if mechanism.loads.is_empty() {
        list.push(remark(text!("missing-loads"), text!("missing-loads-how")));
    }
    let damped = |load: &Load| load.kind.spring().is_some_and(|spring| spring.damping != 0.0);
    if !mechanism.loads.iter().any(damped) {
        list.push(remark(text!("missing-damping"), text!("missing-damping-how")));
    }
}

fn drive(mechanism: &Mechanism, list: &mut Vec<Remark>) {
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

fn friction(mechanism: &Mechanism, remarks: &mut Vec<Remark>) {
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
    let opposed = list(opposed.map(|load| (&load.name).into()));
    let how = if opposed.is_empty() {
        text!("missing-friction-how")
    } else {
        text!("missing-friction-given", forces = opposed)
    };
    remarks.push(remark(text!("missing-friction"), how));
}

/// What no scene can include as such.
fn always(list: &mut Vec<Remark>) {
    list.extend([
        remark(text!("missing-elasticity"), text!("missing-elasticity-how")),
        remark(text!("missing-clearance"), text!("missing-clearance-how")),
        remark(text!("missing-spatial"), text!("missing-spatial-how")),
    ]);
}
