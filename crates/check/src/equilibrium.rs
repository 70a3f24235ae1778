//! Equilibrium of every link from the reactions as they are named, of every joint, and of slides along their guides.

use assur_force::{JointReaction, Reactions, UnitBalance};
use assur_group::Wrench;
use assur_mechanism::{GROUND, InputPair, LinkId, PairId};

use crate::forces::{NO_ANSWER, SOLUTION, largest};
use crate::subject::{Solved, Subject};
use crate::worst::{Check, Worst};
use crate::written::Items;

/// Sums of one link with the size of what was added, N.
#[derive(Debug, Clone, Copy)]
struct Sum {
    wrench: Wrench<f64>,
    size: f64,
}

pub(crate) struct Equilibrium<'a> {
    subject: &'a Subject<'a>,
    links: Worst,
    joints: Worst,
    guides: Worst,
}

impl<'a> Equilibrium<'a> {
    pub(crate) fn new(subject: &'a Subject<'a>) -> Self {
        let links = Worst::new(
            "equilibrium of links",
            "forces and moments on each link, from named reactions and written-out loads; limit: 64 rounding units of what \
             is summed and of the largest reaction, by the sum of 1/determinant over the groups",
        );
        let joints = Worst::new(
            "forces of joints",
            "the forces of each pin or slide on its links sum to zero; limit: 64 rounding units of them",
        );
        let guides = Worst::new(
            "slides push across",
            "the force of a slide along its guide is zero; limit as for the equilibrium",
        );
        Self { subject, links, joints, guides }
    }

    pub(crate) fn add(
        &mut self,
        one: &Solved,
        items: &Items,
        reactions: &Reactions,
        joints: &[JointReaction],
    ) {
        let linkage = self.subject.linkage;
        let scale = linkage.structure.scale;
        let mut sums = vec![Sum { wrench: Wrench::ZERO, size: 0.0 }; linkage.structure.links];
        for ((_, link), item) in items {
            sums[*link].wrench.add_at([0.0; 2], item.wrench.force(), item.wrench.m);
            sums[*link].size += item.size;
        }
        self.add_balancing(one, reactions.balancing, &mut sums);
        for joint in joints {
            self.add_joint(one, joint, &mut sums);
        }
        let greatest = largest(&reactions.pairs, scale);
        let total = greatest + sums.iter().map(|sum| sum.size).fold(0.0, f64::max);
        for (link, sum) in sums.iter().enumerate().skip(1) {
            let off = sum.wrench.fx.hypot(sum.wrench.fy) + sum.wrench.m.abs() / scale;
            let limit = SOLUTION * f64::EPSILON * (sum.size + greatest) * one.condition;
            let name = || format!("link {}", linkage.mechanism.links[link].name);
            self.links.offer(one.index, off / total, limit / total, name);
        }
        for joint in joints {
            self.offer_joint(one, joint, greatest);
        }
    }

    fn add_at(
        &self,
        one: &Solved,
        sum: &mut Sum,
        link: LinkId,
        world: [f64; 2],
        force: [f64; 2],
        moment: f64,
    ) {
        let body = &one.position.bodies[link];
        let arm = [world[0] - body.x, world[1] - body.y];
        sum.wrench.add_at(arm, force, moment);
        let scale = self.subject.linkage.structure.scale;
        let lever = 1.0 + (arm[0].hypot(arm[1]) + body.x.hypot(body.y)) / scale;
        sum.size += force[0].hypot(force[1]) * lever + moment.abs() / scale;
    }

    fn add_balancing(&self, one: &Solved, size: f64, sums: &mut [Sum]) {
        let mechanism = &self.subject.linkage.mechanism;
        if let Some(unit) = UnitBalance::of(mechanism, &one.position.bodies) {
            let body = &one.position.bodies[unit.link];
            let force = unit.wrench.force().map(|f| size * f);
            self.add_at(one, &mut sums[unit.link], unit.link, [body.x, body.y], force, size * unit.wrench.m);
            return;
        }
        let link = mechanism.input.link;
        match mechanism.input.pair {
            InputPair::Pin(_) => {
                let body = &one.position.bodies[link];
                self.add_at(one, &mut sums[link], link, [body.x, body.y], [0.0; 2], size);
            }
            InputPair::Slide(id) => {
                // Along the guide of the ground, through the sliding point.
                let slide = &mechanism.slides[id];
                let (s, c) = slide.angle.sin_cos();
                let world = one.position.bodies[slide.link].point(slide.point);
                self.add_at(one, &mut sums[link], link, world, [size * c, size * s], 0.0);
            }
        }
    }

    fn add_joint(&self, one: &Solved, joint: &JointReaction, sums: &mut [Sum]) {
        let mechanism = &self.subject.linkage.mechanism;
        for (k, (link, force)) in joint.forces.iter().enumerate() {
            let (world, moment) = match joint.joint {
                PairId::Pin(point) => {
                    let at = mechanism.place_in(point, *link).unwrap_or([f64::NAN; 2]);
                    (one.position.bodies[*link].point(at), 0.0)
                }
                PairId::Slide(id) => {
                    let slide = &mechanism.slides[id];
                    let moment = joint.moment.unwrap_or(0.0);
                    let world = one.position.bodies[slide.link].point(slide.point);
                    (world, if k == 0 { moment } else { -moment })
                }
            };
            self.add_at(one, &mut sums[*link], *link, world, *force, moment);
        }
    }

    fn offer_joint(&mut self, one: &Solved, joint: &JointReaction, greatest: f64) {
        let linkage = self.subject.linkage;
        let unit = greatest.max(f64::MIN_POSITIVE);
        let sum = joint.forces.iter().fold([0.0; 2], |sum, (_, f)| [sum[0] + f[0], sum[1] + f[1]]);
        let limit = SOLUTION * f64::EPSILON;
        let name = || assur_name(linkage, joint.joint);
        self.joints.offer(one.index, sum[0].hypot(sum[1]) / unit, limit, name);
        if let PairId::Slide(id) = joint.joint {
            let slide = &linkage.mechanism.slides[id];
            let (s, c) = slide.angle.sin_cos();
            let carrier = &one.position.bodies[slide.on];
            let along = [carrier.c * c - carrier.s * s, carrier.s * c + carrier.c * s];
            let force = joint.forces.first().map_or([f64::NAN; 2], |(_, force)| *force);
            let off = (force[0] * along[0] + force[1] * along[1]).abs();
            self.guides.offer(one.index, off / unit, limit * one.condition, name);
        }
    }

    pub(crate) fn leave_out(&mut self, at: usize) {
        self.links.leave_out(at, NO_ANSWER);
        self.joints.leave_out(at, NO_ANSWER);
        if !self.subject.linkage.mechanism.slides.is_empty() {
            self.guides.leave_out(at, NO_ANSWER);
        }
    }

    pub(crate) fn into_checks(self) -> [Option<Check>; 3] {
        [self.links, self.joints, self.guides].map(Worst::into_check)
    }
}

fn assur_name(linkage: &assur_kinematics::Linkage, joint: PairId) -> String {
    let mechanism = &linkage.mechanism;
    match joint {
        PairId::Pin(point) => {
            let places = &mechanism.points[point].places;
            let ground = places.iter().any(|place| place.link == GROUND);
            format!("pin {}{}", mechanism.points[point].name, if ground { " on the ground" } else { "" })
        }
        PairId::Slide(slide) => format!("slide {}", mechanism.slides[slide].name),
    }
}
