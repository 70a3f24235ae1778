//! Equilibrium of every link under the named reactions, of every joint, and of slides along their guides.

use assur_force::{JointReaction, Reactions, UnitBalance};
use assur_group::Wrench;
use assur_kinematics::Linkage;
use assur_mechanism::{Driver, GROUND, InputPair, LinkId, PairId};
use assur_words::{Text, text};

use crate::case::{Case, largest};
use crate::check::{Collector, greatest};
use crate::kinetics::{ROUNDINGS, rounding_of_sum};
use crate::subject::Solved;

/// Compares the links, the joints and the guides at one state; returns the largest residual of the links of each group, in solving order.
pub(crate) fn compare(case: &Case<'_>, [links, joints, guides]: [&mut Collector; 3]) -> Vec<f64> {
    let (linkage, one) = (case.subject.linkage, case.one);
    let scale = linkage.structure.scale;
    let mut sums = Sums { linkage, one, all: vec![Sum::ZERO; linkage.structure.links] };
    for ((_, link), item) in case.items {
        let sum = &mut sums.all[*link];
        sum.wrench.add_at([0.0; 2], item.wrench.force(), item.wrench.m);
        sum.size += item.size;
        sum.added += sum.wrench.fx.hypot(sum.wrench.fy) + sum.wrench.m.abs() / scale;
    }
    sums.add_balancing(case.reactions);
    for joint in &case.joints {
        sums.add_joint(joint);
    }
    let largest = largest(&case.reactions.pairs, scale);
    let total = largest + sums.all.iter().map(|sum| sum.size).fold(0.0, f64::max);
    let total = total.max(f64::MIN_POSITIVE);
    // Rounding of the largest load reaches every reaction.
    let rounding = ROUNDINGS * f64::EPSILON;
    let added = sums.all.iter().map(|sum| sum.added).fold(0.0, f64::max);
    let limit = rounding_of_sum(added, total) * case.condition();
    let off = |sum: &Sum| (sum.wrench.fx.hypot(sum.wrench.fy) + sum.wrench.m.abs() / scale) / total;
    for (link, sum) in sums.all.iter().enumerate().skip(1) {
        let place = || text!("check-link", link = &linkage.mechanism.links[link].name);
        links.offer(one.index, off(sum), limit, place);
    }
    for joint in &case.joints {
        let place = || joint_name(linkage, joint.joint);
        let sum = joint.forces.iter().fold([0.0; 2], |sum, (_, f)| [sum[0] + f[0], sum[1] + f[1]]);
        joints.offer(one.index, sum[0].hypot(sum[1]) / total, rounding, place);
        if let PairId::Slide(id) = joint.joint {
            let slide = &linkage.mechanism.slides[id];
            let (s, c) = slide.angle.sin_cos();
            let along = one.position.bodies[slide.on].turned([c, s]);
            let force = joint.forces.first().map_or([f64::NAN; 2], |(_, force)| *force);
            let along_guide = crate::friction::along(case.reactions, joint.joint);
            let off = (force[0] * along[0] + force[1] * along[1] - along_guide).abs();
            guides.offer(one.index, off / total, limit, place);
        }
    }
    let groups = linkage.structure.groups.iter();
    groups.map(|group| greatest(group.frame.links.iter().map(|link| off(&sums.all[*link])))).collect()
}

/// The sum of forces and moments on a link, with the size of its terms, N.
#[derive(Debug, Clone, Copy)]
struct Sum {
    wrench: Wrench<f64>,
    size: f64,
    /// The sizes of the partial sums of its loads.
    added: f64,
}

impl Sum {
    const ZERO: Self = Self { wrench: Wrench::ZERO, size: 0.0, added: 0.0 };
}

/// The sums of all links.
struct Sums<'a> {
    linkage: &'a Linkage,
    one: &'a Solved,
    all: Vec<Sum>,
}

impl Sums<'_> {
    /// Adds a force at a place of the ground's frame, and a moment, on a link.
    fn add_at(&mut self, link: LinkId, place: [f64; 2], force: [f64; 2], moment: f64) {
        let body = &self.one.position.bodies[link];
        let arm = [place[0] - body.x, place[1] - body.y];
        let sum = &mut self.all[link];
        sum.wrench.add_at(arm, force, moment);
        let scale = self.linkage.structure.scale;
        let lever = 1.0 + (arm[0].hypot(arm[1]) + body.x.hypot(body.y)) / scale;
        sum.size += force[0].hypot(force[1]) * lever + moment.abs() / scale;
    }

    fn add_balancing(&mut self, reactions: &Reactions) {
        let (mechanism, bodies) = (&self.linkage.mechanism, &self.one.position.bodies);
        let origin = |link: LinkId| [bodies[link].x, bodies[link].y];
        if let Some(unit) = UnitBalance::of(mechanism) {
            let wrench = unit.wrench(bodies);
            let size = reactions.balancing;
            let force = wrench.force().map(|f| size * f);
            self.add_at(unit.link, origin(unit.link), force, size * wrench.m);
            return;
        }
        reactions.of_drives(mechanism).for_each(|(driver, size)| self.add_drive(driver, size));
    }

    /// Adds the load of a drive on both of its links.
    fn add_drive(&mut self, driver: &Driver, size: f64) {
        let (mechanism, bodies) = (&self.linkage.mechanism, &self.one.position.bodies);
        let origin = |link: LinkId| [bodies[link].x, bodies[link].y];
        let ends = [(driver.link, size), (driver.on, -size)];
        for (link, size) in ends.into_iter().filter(|(link, _)| *link != GROUND) {
            match driver.pair {
                InputPair::Pin(_) => self.add_at(link, origin(link), [0.0; 2], size),
                InputPair::Slide(id) => {
                    // Along the guide, through the sliding point.
                    let slide = &mechanism.slides[id];
                    let (s, c) = slide.angle.sin_cos();
                    let place = bodies[slide.link].point(slide.point);
                    let along = bodies[slide.on].turned([c, s]);
                    self.add_at(link, place, along.map(|part| size * part), 0.0);
                }
            }
        }
    }

    fn add_joint(&mut self, joint: &JointReaction) {
        let (mechanism, bodies) = (&self.linkage.mechanism, &self.one.position.bodies);
        for (k, (link, force)) in joint.forces.iter().enumerate() {
            let (place, moment) = match joint.joint {
                PairId::Pin(point) => {
                    let at = mechanism.place_in(point, *link).unwrap_or([f64::NAN; 2]);
                    (bodies[*link].point(at), joint.turning.get(k).copied().unwrap_or(0.0))
                }
                PairId::Slide(id) => {
                    let slide = &mechanism.slides[id];
                    let moment = joint.moment.unwrap_or(0.0);
                    let place = bodies[slide.link].point(slide.point);
                    (place, if k == 0 { moment } else { -moment })
                }
            };
            self.add_at(*link, place, *force, moment);
        }
    }
}

fn joint_name(linkage: &Linkage, joint: PairId) -> Text {
    let mechanism = &linkage.mechanism;
    match joint {
        PairId::Pin(point) => {
            let point = &mechanism.points[point];
            let (pin, ground) = (&point.name, point.on(GROUND).is_some());
            if ground { text!("check-pin-on-ground", pin) } else { text!("check-pin", pin) }
        }
        PairId::Slide(slide) => {
            text!("check-slide", slide = &mechanism.slides[slide].name)
        }
    }
}
