//! The plans of velocities and of accelerations.

use assur_force::{LoadState, VectorKind};
use assur_group::plane::{minus, perp, plus, scaled};
use assur_kinematics::{Linkage, PointMotion, Position};
use assur_mechanism::{CoordinateKind, GROUND, LinkId, Place, PointId, Slide};
use assur_words::{Text, joined, name, number, text};

use crate::plan::{Component, VectorPlan, length};

/// The plan of velocities at a position: from the pole (the origin) to the image of each point, then the rotation of
/// each link and each slide on a moving guide as separate vectors.
///
/// With a state in m/s; without, PF1: per unit speed of the coordinate. The residual is the greatest difference between
/// the components, found from the rotation of the links, and the images, found from the points.
pub fn velocity_plan(linkage: &Linkage, position: &Position, state: Option<&LoadState>) -> VectorPlan {
    draw(linkage, position, state, 1)
}

/// The plan of accelerations at a position: from the pole (the origin) to the image of each point; then normal and
/// tangential component of each link's rotation, and transport, Coriolis and relative component of each slide on a
/// moving guide.
///
/// With a state in m/s^2; without, PF2: for unit speed of the coordinate and no acceleration of it. `position` needs
/// PF2. The residual is the greatest difference between the sums of the components and PF2 w^2 + PF1 e of the points.
pub fn acceleration_plan(linkage: &Linkage, position: &Position, state: Option<&LoadState>) -> VectorPlan {
    draw(linkage, position, state, 2)
}

fn draw(linkage: &Linkage, position: &Position, state: Option<&LoadState>, order: usize) -> VectorPlan {
    let title = match (order, state.is_some()) {
        (1, true) => text!("plan-velocities"),
        (1, false) => text!("plan-velocities-unit"),
        (_, true) => text!("plan-accelerations"),
        (_, false) => text!("plan-accelerations-unit"),
    };
    let plan = VectorPlan::new(title, unit(linkage, state.is_some(), order));
    let rate = state.map_or([1.0, 0.0], |state| [state.speed, state.acceleration]);
    let mut drawer = Drawer { linkage, position, rate, of_velocities: order == 1, plan, open: 0.0 };
    drawer.plan.point(text!("plan-pole"), [0.0; 2]);
    for id in 0..linkage.mechanism.points.len() {
        drawer.absolute(id);
    }
    for link in 1..linkage.mechanism.links.len() {
        drawer.turn(link);
    }
    for (id, slide) in linkage.mechanism.slides.iter().enumerate().filter(|(_, slide)| slide.on != GROUND) {
        drawer.slide(id, slide);
    }
    let open = drawer.open;
    drawer.plan.finish(open)
}

struct Drawer<'a> {
    linkage: &'a Linkage,
    position: &'a Position,
    /// Speed and acceleration of the coordinate; without a motion the speed is 1 and the acceleration 0.
    rate: [f64; 2],
    of_velocities: bool,
    plan: VectorPlan,
    /// Greatest difference between the components and the images.
    open: f64,
}

impl Drawer<'_> {
    /// One of two texts.
    fn either(&self, velocity: &'static str, acceleration: &'static str) -> &'static str {
        if self.of_velocities { velocity } else { acceleration }
    }

    /// PF1 w, or PF2 w^2 + PF1 e.
    fn total(&self, motion: &PointMotion) -> [f64; 2] {
        let [w, e] = self.rate;
        if self.of_velocities {
            scaled(w, motion.pf1)
        } else {
            plus(scaled(w * w, motion.pf2), scaled(e, motion.pf1))
        }
    }

    fn image(&self, point: usize) -> [f64; 2] {
        self.total(&self.linkage.point_motion(point, self.position))
    }

    fn is_fixed(&self, point: usize) -> bool {
        self.linkage.mechanism.place_in(point, GROUND).is_some()
    }

    fn name(&self, point: usize) -> Text {
        (&self.linkage.mechanism.points[point].name).into()
    }

    fn absolute(&mut self, point: usize) {
        let (point_name, image) = (self.name(point), self.image(point));
        self.plan.point(point_name.clone(), image);
        if !self.is_fixed(point) {
            let symbol = symbol(self.either("v", "a"), [point_name.clone()]);
            let note = text!(self.either("plan-velocity-of", "plan-acceleration-of"), point = &point_name);
            self.plan.push([0.0; 2], (VectorKind::Absolute, symbol, image, note));
            let letter = self.linkage.mechanism.points[point].name.to_lowercase();
            let print = in_print(self.either("v", "a"), Text::default(), [point_name]);
            if let Some(item) = self.plan.items.last_mut() {
                (item.image, item.symbol) = (letter, print);
            }
        }
    }

    /// Compares the end of the components with the image to which they lead, and draws them head to tail, each with its symbol in print.
    fn parts(&mut self, start: [f64; 2], parts: Vec<(Component, Text)>, image: [f64; 2], drawn: bool) {
        let end = parts.iter().fold(start, |at, ((_, _, vector, _), _)| plus(at, *vector));
        self.open = self.open.max(length(minus(end, image)));
        let mut corner = start;
        for (part, print) in parts.into_iter().filter(|_| drawn) {
            corner = self.plan.push(corner, part);
            self.plan.items.last_mut().into_iter().for_each(|item| item.symbol = print.clone());
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
            let parts = self.turn_parts(link, arm, &self.name(other), &self.name(first));
            // Where the first point is at rest, the velocity of the other one is this component.
            let drawn = !self.of_velocities || !self.is_fixed(first);
            self.parts(self.image(first), parts, self.image(other), drawn);
        }
    }

    fn turn_parts(&self, link: usize, arm: [f64; 2], to: &Text, from: &Text) -> Vec<(Component, Text)> {
        let (body, [w, e]) = (&self.position.bodies[link], self.rate);
        let link = Text::from(&self.linkage.mechanism.links[link].name);
        let of = |letter: &'static str| symbol(letter, [to.clone(), from.clone()]);
        let print = |letter, above| in_print(letter, above, [to.clone(), from.clone()]);
        let speed = w * body.w1;
        if self.of_velocities {
            let note = text!("plan-relative-velocity", point = to, other = from, link = link);
            let part = (VectorKind::Relative, of("v"), scaled(speed, perp(arm)), note);
            return vec![(part, print("v", Text::default()))];
        }
        let turning = w * w * body.w2 + e * body.w1;
        let normal = text!("plan-normal-part", point = to, other = from, link = &link);
        let tangential = text!("plan-tangential-part", link = link);
        let normal = (VectorKind::Normal, of("an"), scaled(-speed * speed, arm), normal);
        let tangential = (VectorKind::Tangential, of("at"), scaled(turning, perp(arm)), tangential);
        let symbols =
            [text!("plan-symbol-normal"), text!("plan-symbol-tangential")].map(|own| print("a", own));
        [normal, tangential].into_iter().zip(symbols).collect()
    }

    /// The name of a sliding point, the letter of its image, and its letter in symbols, where a point
    /// without a name has the number of its link alone.
    fn sliding_point(&self, slide: &Slide) -> (Text, String, Text) {
        let near = 1e-12 * self.linkage.structure.scale;
        let named = self.linkage.mechanism.points.iter().find(|point| {
            let mut places = point.places.iter().filter(|own| own.link == slide.link);
            places.any(|own| length(minus(own.at, slide.point)) <= near)
        });
        match named {
            Some(point) => (Text::from(&point.name), point.name.to_lowercase(), Text::from(&point.name)),
            None => (text!("plan-point-of", slide = &slide.name), slide.name.to_lowercase(), Text::default()),
        }
    }

    /// The motion of the guide's point under a sliding point of a slide on a moving link, and the components of the slide.
    fn slide(&mut self, id: usize, slide: &Slide) {
        let (named, letter, sliding) = self.sliding_point(slide);
        // `A on rocker`.
        let under =
            text!("plan-point-on", point = &named, link = &self.linkage.mechanism.links[slide.on].name);
        let carrier = &self.position.bodies[slide.on];
        let world = self.position.bodies[slide.link].point(slide.point);
        let arm = minus(world, [carrier.x, carrier.y]);
        let guide = carrier.turned([slide.angle.cos(), slide.angle.sin()]);
        let motion = self.linkage.slide_motion(id, self.position);
        let [w, e] = self.rate;
        let on_guide = PointMotion { pf0: [0.0; 2], pf1: carrier.first(arm), pf2: carrier.second(arm) };
        let transport = self.total(&on_guide);
        let note = text!(self.either("plan-velocity-under", "plan-acceleration-under"), point = &named);
        let along = text!(self.either("plan-velocity-along", "plan-acceleration-along"), point = &named);
        let of = |letter: &'static str| symbol(letter, [named.clone(), under.clone()]);
        let own = symbol(self.either("v", "a"), [under.clone()]);
        // `A` of link 2 and of its guide, link 3: `A2`, `A3`.
        let [on_link, on_guide] =
            [slide.link, slide.on].map(|link| joined("", [sliding.clone(), number(link)]));
        let print = |letter, above| in_print(letter, above, [on_link.clone(), on_guide.clone()]);
        let of_guide = in_print(self.either("v", "a"), Text::default(), [on_guide.clone()]);
        let mut parts = vec![((VectorKind::Absolute, own, transport, note), of_guide)];
        if self.of_velocities {
            let relative = scaled(w * motion.pf1, guide);
            parts.push(((VectorKind::Relative, of("v"), relative, along), print("v", Text::default())));
        } else {
            let coriolis = scaled(2.0 * (carrier.w1 * w) * (motion.pf1 * w), perp(guide));
            let note = text!("plan-coriolis-part");
            let above = text!("plan-symbol-coriolis");
            parts.push(((VectorKind::Coriolis, of("ac"), coriolis, note), print("a", above)));
            let relative = scaled(motion.pf2 * w * w + motion.pf1 * e, guide);
            let above = text!("plan-symbol-relative");
            parts.push(((VectorKind::Relative, of("ar"), relative, along), print("a", above)));
        }
        let place = Place { link: slide.link, at: slide.point };
        let image = self.total(&self.linkage.place_motion(place, self.position));
        self.plan.point(under.clone(), transport);
        let first = self.plan.items.len();
        self.parts([0.0; 2], parts, image, true);
        self.plan.items[first].image = format!("{letter}'");
    }
}

/// The symbol of a vector with its points: `v(B/A)`.
fn symbol<const N: usize>(letter: &'static str, points: [Text; N]) -> Text {
    joined("", [name(letter), name("("), joined("/", points), name(")")])
}

/// The symbol of a vector in print, with what it is above the letter and its points below: `a^n_BA`.
fn in_print<const N: usize>(letter: &'static str, above: Text, points: [Text; N]) -> Text {
    name(letter).above(above).below(joined("", points))
}

/// Unit of derivatives: by time with a motion, else by the coordinate.
fn unit(linkage: &Linkage, moves: bool, order: usize) -> &'static str {
    match (moves, linkage.kind(), order) {
        (true, _, 1) | (false, CoordinateKind::Time, 1) => "m/s",
        (true, _, _) | (false, CoordinateKind::Time, _) => "m/s^2",
        (false, CoordinateKind::Angle, 1) => "m/rad",
        (false, CoordinateKind::Angle, _) => "m/rad^2",
        (false, CoordinateKind::Length, 1) => "m/m",
        (false, CoordinateKind::Length, _) => "m/m^2",
    }
}

/// Place in the solving order: ground, input link, groups.
fn rank(linkage: &Linkage, link: LinkId) -> usize {
    let group = linkage.structure.groups.iter().position(|group| group.frame.links.contains(&link));
    match group {
        Some(group) => group + 2,
        None => usize::from(link != GROUND),
    }
}

/// The named points of a link. The first one, from which the others are found, is known before the link.
fn points_of(linkage: &Linkage, link: LinkId) -> Vec<PointId> {
    let points = 0..linkage.mechanism.points.len();
    let mut own: Vec<PointId> = points.filter(|id| linkage.mechanism.place_in(*id, link).is_some()).collect();
    let before = |id: &PointId| {
        let places = linkage.mechanism.points[*id].places.iter();
        places.map(|place| rank(linkage, place.link)).min().unwrap_or(usize::MAX)
    };
    if let Some(first) = (0..own.len()).min_by_key(|&index| before(&own[index])) {
        own[..=first].rotate_right(1);
    }
    own
}
