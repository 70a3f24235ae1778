//! The plans of velocities and of accelerations.

use assur_force::State;
use assur_group::plane::{minus, perp, plus, scaled};
use assur_kinematics::{Linkage, PointMotion, Position};

use crate::images::{Rate, Sliding, is_fixed, points_of, slidings, unit};
use crate::plan::{Plan, VectorKind, length};

/// The plan of velocities at a position: from the pole (the origin) to the image of each point, then the rotation of
/// each link and each slide on a moving guide as separate vectors.
///
/// With a state in m/s; without, PF1: per unit speed of the coordinate. The residual is the greatest difference between
/// the components, found from the rotation of the links, and the images, found from the points.
pub fn velocity_plan(linkage: &Linkage, position: &Position, state: Option<&State>) -> Plan {
    draw(linkage, position, state, 1)
}

/// The plan of accelerations at a position: from the pole (the origin) to the image of each point; then normal and
/// tangential component of each link's rotation, and transport, Coriolis and relative component of each slide on a
/// moving guide.
///
/// With a state in m/s^2; without, PF2: for unit speed of the coordinate and no acceleration of it. `position` needs
/// PF2. The residual is the greatest difference between the sums of the components and PF2 w^2 + PF1 e of the points.
pub fn acceleration_plan(linkage: &Linkage, position: &Position, state: Option<&State>) -> Plan {
    draw(linkage, position, state, 2)
}

fn draw(linkage: &Linkage, position: &Position, state: Option<&State>, order: usize) -> Plan {
    let (letter, word, plural) =
        if order == 1 { ('v', "velocity", "velocities") } else { ('a', "acceleration", "accelerations") };
    let of_unit_speed =
        if state.is_some() { String::new() } else { format!(" for a unit speed of the input (PF{order})") };
    let plan = Plan::new(format!("Plan of {plural}{of_unit_speed}"), unit(linkage, state.is_some(), order));
    let mut drawer = Drawer { linkage, position, rate: Rate::of(state), letter, word, plan, open: 0.0 };
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

/// A component of a velocity or an acceleration: its kind, its name, the vector, its meaning.
type Part = (VectorKind, String, [f64; 2], String);

struct Drawer<'a> {
    linkage: &'a Linkage,
    position: &'a Position,
    rate: Rate,
    /// `v` or `a`.
    letter: char,
    /// `velocity` or `acceleration`.
    word: &'static str,
    plan: Plan,
    /// Greatest difference between the components and the images.
    open: f64,
}

impl Drawer<'_> {
    fn of_velocities(&self) -> bool {
        self.letter == 'v'
    }

    /// PF1 w, or PF2 w^2 + PF1 e.
    fn total(&self, motion: &PointMotion) -> [f64; 2] {
        let Rate { w, e } = self.rate;
        if self.of_velocities() {
            scaled(w, motion.pf1)
        } else {
            plus(scaled(w * w, motion.pf2), scaled(e, motion.pf1))
        }
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
            let (letter, note) = (self.letter, format!("{} of {name}", self.word));
            self.plan.push(VectorKind::Absolute, format!("{letter}({name})"), [0.0; 2], image, note);
        }
    }

    /// Compares the end of the components with the image to which they lead, and draws them head to tail.
    fn parts(&mut self, start: [f64; 2], parts: Vec<Part>, image: [f64; 2], drawn: bool) {
        let end = parts.iter().fold(start, |at, (_, _, vector, _)| plus(at, *vector));
        self.open = self.open.max(length(minus(end, image)));
        let mut corner = start;
        for (kind, name, vector, note) in parts.into_iter().filter(|_| drawn) {
            corner = self.plan.push(kind, name, corner, vector, note);
        }
    }

    /// Components from the rotation of a link, from its first point to the others.
    fn turn(&mut self, link: usize) {
        let points = points_of(self.linkage, link);
        let Some((&first, others)) = points.split_first() else { return };
        for &other in others {
            let place = |id| self.linkage.mechanism.place_in(id, link);
            let (Some(from), Some(to)) = (place(first), place(other)) else { continue };
            let arm = self.position.bodies[link].arm(minus(to, from));
            let parts = self.turn_parts(link, arm, self.name(other), self.name(first));
            // Where the first point is at rest, the velocity of the other one is this component.
            let drawn = !self.of_velocities() || !is_fixed(self.linkage, first);
            self.parts(self.image(first), parts, self.image(other), drawn);
        }
    }

    fn turn_parts(&self, link: usize, arm: [f64; 2], to: &str, from: &str) -> Vec<Part> {
        let (body, Rate { w, e }) = (&self.position.bodies[link], self.rate);
        let link = &self.linkage.mechanism.links[link].name;
        let speed = w * body.w1;
        if self.of_velocities() {
            let note = format!("velocity of {to} against {from}: turn of `{link}`");
            return vec![(VectorKind::Relative, format!("v({to}/{from})"), scaled(speed, perp(arm)), note)];
        }
        let turning = w * w * body.w2 + e * body.w1;
        let normal = format!("normal part, from {to} to {from}: turn of `{link}`");
        let tangential = format!("tangential part: angular acceleration of `{link}`");
        vec![
            (VectorKind::Normal, format!("an({to}/{from})"), scaled(-speed * speed, arm), normal),
            (VectorKind::Tangential, format!("at({to}/{from})"), scaled(turning, perp(arm)), tangential),
        ]
    }

    /// The motion of the guide's point under a sliding point, and the components of the slide.
    fn slide(&mut self, at: &Sliding) {
        let carrier = &self.position.bodies[at.carrier];
        let motion = self.linkage.slide_motion(at.slide, self.position);
        let (Rate { w, e }, word, Sliding { name, under, .. }) = (self.rate, self.word, at);
        let on_guide = PointMotion { pf0: [0.0; 2], pf1: carrier.first(at.arm), pf2: carrier.second(at.arm) };
        let transport = self.total(&on_guide);
        let note = format!("{word} of the point of the guide under {name}");
        let along = format!("{word} of {name} along the guide");
        let mut parts = vec![(VectorKind::Absolute, format!("{}({under})", self.letter), transport, note)];
        if self.of_velocities() {
            let relative = scaled(w * motion.pf1, at.along);
            parts.push((VectorKind::Relative, format!("v({name}/{under})"), relative, along));
        } else {
            let coriolis = scaled(2.0 * (carrier.w1 * w) * (motion.pf1 * w), perp(at.along));
            let note = "Coriolis part: twice the turn of the guide by the speed along it".to_owned();
            parts.push((VectorKind::Coriolis, format!("ac({name}/{under})"), coriolis, note));
            let relative = scaled(motion.pf2 * w * w + motion.pf1 * e, at.along);
            parts.push((VectorKind::Relative, format!("ar({name}/{under})"), relative, along));
        }
        let image = self.total(&self.linkage.place_motion(at.place, self.position));
        self.plan.point(under, transport);
        self.parts([0.0; 2], parts, image, true);
    }
}
