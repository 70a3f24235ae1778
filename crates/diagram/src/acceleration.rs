//! The plan of accelerations.

use assur_force::State;
use assur_group::plane::{minus, perp, plus, scaled};
use assur_kinematics::{Linkage, PointMotion, Position};

use crate::images::{Rate, Sliding, is_fixed, points_of, slidings, unit};
use crate::plan::{Plan, VectorKind, length};

/// The plan of accelerations at a position: from the pole (the origin) to the image of each point; then normal and tangential
/// part of each link's turn, and transport, Coriolis and relative part of each slide on a moving guide.
///
/// With a state in m/s^2; without, PF2: for unit speed of the coordinate and no acceleration of it. `position` needs PF2. The
/// residual says how far the parts miss PF2 w^2 + PF1 e of the points.
pub fn acceleration_plan(linkage: &Linkage, position: &Position, state: Option<&State>) -> Plan {
    let title = if state.is_some() {
        "Plan of accelerations"
    } else {
        "Plan of accelerations for a unit speed of the input (PF2)"
    };
    let mut drawer = Drawer {
        linkage,
        position,
        rate: Rate::of(state),
        plan: Plan::new(title, unit(linkage, state.is_some(), 2)),
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
    rate: Rate,
    plan: Plan,
    open: f64,
}

impl Drawer<'_> {
    /// PF2 w^2 + PF1 e.
    fn total(&self, motion: &PointMotion) -> [f64; 2] {
        plus(scaled(self.rate.w * self.rate.w, motion.pf2), scaled(self.rate.e, motion.pf1))
    }

    fn image(&self, point: usize) -> [f64; 2] {
        self.total(&self.linkage.point_motion(point, self.position))
    }

    fn name(&self, point: usize) -> &str {
        &self.linkage.mechanism.points[point].name
    }

    fn absolute(&mut self, point: usize) {
        let (name, image) = (self.name(point).to_owned(), self.image(point));
        self.plan.point(&name, image);
        if !is_fixed(self.linkage, point) {
            let note = format!("acceleration of {name}");
            self.plan.push(VectorKind::Absolute, format!("a({name})"), [0.0; 2], image, note);
        }
    }

    /// Normal and tangential part from the first point of a link to each other one.
    fn turn(&mut self, link: usize) {
        let points = points_of(self.linkage, link);
        let Some((&first, others)) = points.split_first() else { return };
        let (body, place) = (&self.position.bodies[link], |id| self.linkage.mechanism.place_in(id, link));
        let speed = self.rate.w * body.w1;
        let turning = self.rate.w * self.rate.w * body.w2 + self.rate.e * body.w1;
        for &other in others {
            let (Some(from), Some(to)) = (place(first), place(other)) else { continue };
            let arm = body.arm(minus(to, from));
            let link = &self.linkage.mechanism.links[link].name;
            let (to, from) = (self.name(other), self.name(first));
            let names = [format!("an({to}/{from})"), format!("at({to}/{from})")];
            let notes = [
                format!("normal part, from {to} to {from}: turn of `{link}`"),
                format!("tangential part: angular acceleration of `{link}`"),
            ];
            let [normal_name, tangential_name] = names;
            let [normal_note, tangential_note] = notes;
            let start = self.image(first);
            let normal = scaled(-speed * speed, arm);
            let corner = self.plan.push(VectorKind::Normal, normal_name, start, normal, normal_note);
            let tangential = scaled(turning, perp(arm));
            let end =
                self.plan.push(VectorKind::Tangential, tangential_name, corner, tangential, tangential_note);
            self.open = self.open.max(length(minus(end, self.image(other))));
        }
    }

    fn slide(&mut self, at: &Sliding) {
        let carrier = &self.position.bodies[at.carrier];
        let motion = self.linkage.slide_motion(at.slide, self.position);
        let (w, e) = (self.rate.w, self.rate.e);
        let under = PointMotion { pf0: [0.0; 2], pf1: carrier.first(at.arm), pf2: carrier.second(at.arm) };
        let transport = self.total(&under);
        let coriolis = scaled(2.0 * (carrier.w1 * w) * (motion.pf1 * w), perp(at.along));
        let relative = scaled(motion.pf2 * w * w + motion.pf1 * e, at.along);
        let image = self.total(&self.linkage.place_motion(at.place, self.position));
        self.plan.point(&at.under, transport);
        let against = format!("{}/{}", at.name, at.under);
        let note = format!("acceleration of the point of the guide under {}", at.name);
        let start =
            self.plan.push(VectorKind::Absolute, format!("a({})", at.under), [0.0; 2], transport, note);
        let note = "Coriolis part: twice the turn of the guide by the speed along it".to_owned();
        let corner = self.plan.push(VectorKind::Coriolis, format!("ac({against})"), start, coriolis, note);
        let note = format!("acceleration of {} along the guide", at.name);
        let end = self.plan.push(VectorKind::Relative, format!("ar({against})"), corner, relative, note);
        self.open = self.open.max(length(minus(end, image)));
    }
}
