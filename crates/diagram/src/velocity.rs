//! The plan of velocities.

use assur_force::State;
use assur_group::plane::{minus, perp, scaled};
use assur_kinematics::{Linkage, Position};

use crate::images::{Rate, Sliding, is_fixed, points_of, slidings, unit};
use crate::plan::{Plan, VectorKind, length};

/// The plan of velocities at a position: from the pole (the origin) to the image of each point, then each link's turn and each
/// slide on a moving guide as separate vectors.
///
/// With a state in m/s; without, PF1: per unit speed of the coordinate. The residual says how far the parts, found from the
/// turn of the links, miss the images, found from the points.
pub fn velocity_plan(linkage: &Linkage, position: &Position, state: Option<&State>) -> Plan {
    let title = if state.is_some() {
        "Plan of velocities"
    } else {
        "Plan of velocities for a unit speed of the input (PF1)"
    };
    let mut drawer = Drawer {
        linkage,
        position,
        w: Rate::of(state).w,
        plan: Plan::new(title, unit(linkage, state.is_some(), 1)),
        open: 0.0,
    };
    drawer.plan.point("pole", [0.0; 2]);
    for id in 0..linkage.mechanism.points.len() {
        drawer.absolute(id);
    }
    for link in 1..linkage.mechanism.links.len() {
        drawer.turn(link);
    }
    for sliding in slidings(linkage, position) {
        drawer.slide(&sliding);
    }
    let open = drawer.open;
    drawer.plan.finish(open)
}

struct Drawer<'a> {
    linkage: &'a Linkage,
    position: &'a Position,
    w: f64,
    plan: Plan,
    open: f64,
}

impl Drawer<'_> {
    fn image(&self, point: usize) -> [f64; 2] {
        scaled(self.w, self.linkage.point_motion(point, self.position).pf1)
    }

    fn name(&self, point: usize) -> &str {
        &self.linkage.mechanism.points[point].name
    }

    fn absolute(&mut self, point: usize) {
        let (name, image) = (self.name(point).to_owned(), self.image(point));
        self.plan.point(&name, image);
        if !is_fixed(self.linkage, point) {
            let note = format!("velocity of {name}");
            self.plan.push(VectorKind::Absolute, format!("v({name})"), [0.0; 2], image, note);
        }
    }

    /// What the turn of a link adds from its first point to the others.
    fn turn(&mut self, link: usize) {
        let points = points_of(self.linkage, link);
        let Some((&first, others)) = points.split_first() else { return };
        let (body, place) = (&self.position.bodies[link], |id| self.linkage.mechanism.place_in(id, link));
        let start = self.image(first);
        for &other in others {
            let (Some(from), Some(to)) = (place(first), place(other)) else { continue };
            let vector = scaled(self.w * body.w1, perp(body.arm(minus(to, from))));
            self.open =
                self.open.max(length(minus([start[0] + vector[0], start[1] + vector[1]], self.image(other))));
            if is_fixed(self.linkage, first) {
                continue; // the absolute velocity says the same
            }
            let (to, from) = (self.name(other), self.name(first));
            let (name, note) = (
                format!("v({to}/{from})"),
                format!(
                    "velocity of {to} against {from}: turn of `{}`",
                    self.linkage.mechanism.links[link].name
                ),
            );
            self.plan.push(VectorKind::Relative, name, start, vector, note);
        }
    }

    fn slide(&mut self, at: &Sliding) {
        let carrier = &self.position.bodies[at.carrier];
        let transport = scaled(self.w, carrier.first(at.arm));
        let motion = self.linkage.slide_motion(at.slide, self.position);
        let image = scaled(self.w, self.linkage.place_motion(at.place, self.position).pf1);
        self.plan.point(&at.under, transport);
        let note = format!("velocity of the point of the guide under {}", at.name);
        let start =
            self.plan.push(VectorKind::Absolute, format!("v({})", at.under), [0.0; 2], transport, note);
        let note = format!("velocity of {} along the guide", at.name);
        let along = scaled(self.w * motion.pf1, at.along);
        let name = format!("v({}/{})", at.name, at.under);
        let end = self.plan.push(VectorKind::Relative, name, start, along, note);
        self.open = self.open.max(length(minus(end, image)));
    }
}
