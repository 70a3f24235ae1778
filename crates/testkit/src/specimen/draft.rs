//! Links with their poses in the first position, and pairs that are placed where the links are.

use std::f64::consts::TAU;

use assur_group::Pattern;
use assur_mechanism::{GROUND, Inertia, InputPair, Link, LinkId, Place, Point, PointId, Slide, SlideId};

use crate::Rng;
use crate::arrangement::{Join, Pose, constraints, drawn_pairs, regularity};

/// A mechanism under construction.
#[derive(Debug)]
pub(crate) struct Draft {
    pub(crate) rng: Rng,
    /// Size of the region that contains everything, m.
    pub(crate) size: f64,
    pub(crate) links: Vec<Link>,
    pub(crate) poses: Vec<Pose>,
    pub(crate) points: Vec<Point>,
    pub(crate) slides: Vec<Slide>,
}

/// What is driven, and its coordinate in the first position.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drive {
    pub(crate) link: LinkId,
    /// The body against which it is driven.
    pub(crate) on: LinkId,
    pub(crate) pair: InputPair,
    /// The coordinate, rad or m.
    pub(crate) from: f64,
}

/// The same angle in [-pi, pi].
pub(crate) fn normalized(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

impl Draft {
    pub(crate) fn new(seed: u64) -> Self {
        let mut rng = Rng::new(seed);
        let size = 10.0_f64.powf(rng.range(-1.2, 0.5));
        let ground = Link { name: "ground".into(), mass: 0.0, center: [0.0; 2], inertia: Inertia::NONE };
        let pose = Pose { x: 0.0, y: 0.0, angle: 0.0 };
        Self { rng, size, links: vec![ground], poses: vec![pose], points: Vec::new(), slides: Vec::new() }
    }

    /// A random place in the region, m.
    pub(crate) fn place(&mut self) -> [f64; 2] {
        [self.rng.range(-1.0, 1.0) * self.size, self.rng.range(-1.0, 1.0) * self.size]
    }

    /// Adds a link in a random pose, with one point of interest.
    pub(crate) fn link(&mut self) -> LinkId {
        let id = self.links.len();
        let [x, y] = self.place();
        let angle = self.rng.angle();
        self.poses.push(Pose { x, y, angle });
        // One link in four is massless.
        let mass = if self.rng.chance(0.25) { 0.0 } else { self.rng.range(0.2, 8.0) };
        let mut link =
            Link { name: format!("link{id}").into(), mass, center: [0.0; 2], inertia: Inertia::NONE };
        if mass > 0.0 {
            link.center = [self.rng.range(-0.5, 0.5) * self.size, self.rng.range(-0.5, 0.5) * self.size];
            if self.rng.chance(0.8) {
                link.inertia = (mass * self.size * self.size * self.rng.range(0.01, 0.2)).into();
            }
        }
        self.links.push(link);
        let at = [self.rng.range(-0.5, 0.5) * self.size, self.rng.range(-0.5, 0.5) * self.size];
        self.points.push(Point { name: format!("E{id}").into(), places: vec![Place { link: id, at }] });
        id
    }

    /// Adds a pin of two links at a place of the ground.
    pub(crate) fn pin(&mut self, a: LinkId, b: LinkId, world: [f64; 2]) -> PointId {
        let name = format!("P{}", self.points.len());
        let places = [a, b].map(|link| Place { link, at: self.poses[link].local(world) });
        self.points.push(Point { name: name.into(), places: places.to_vec() });
        self.points.len() - 1
    }

    /// Joins a link to a pin, a point of interest or a new point of an earlier body; returns the place of the pin.
    pub(crate) fn hang(&mut self, link: LinkId, body: LinkId) -> [f64; 2] {
        let ready: Vec<PointId> =
            (0..self.points.len()).filter(|&id| self.holds(id, body) && !self.holds(id, link)).collect();
        if !ready.is_empty() && self.rng.chance(0.35) {
            let point = *self.rng.pick(&ready);
            let world = self.world_of(point);
            let place = Place { link, at: self.poses[link].local(world) };
            self.points[point].places.push(place);
            return world;
        }
        let world = self.place();
        self.pin(link, body, world);
        world
    }

    fn holds(&self, point: PointId, link: LinkId) -> bool {
        self.points[point].places.iter().any(|place| place.link == link)
    }

    /// Position of a point in the first position.
    pub(crate) fn world_of(&self, point: PointId) -> [f64; 2] {
        let place = self.points[point].places[0];
        self.poses[place.link].world(place.at)
    }

    /// Adds a slide of two links along a direction of the ground; the guide is on either of them, but always on the
    /// ground if it is one of them.
    pub(crate) fn slide(&mut self, a: LinkId, b: LinkId, direction: f64) -> SlideId {
        let (link, on) = if a == GROUND || (b != GROUND && self.rng.chance(0.5)) { (b, a) } else { (a, b) };
        // One slide in three has zero offset and zero tilt, which are cases of their own.
        let simple = self.rng.chance(0.33);
        let point_at = if simple { [0.0; 2] } else { self.place() };
        let point = if simple { [0.0; 2] } else { self.poses[link].local(point_at) };
        let start = self.poses[link].world(point);
        let way = self.rng.signed(0.0, 1.0) * self.size;
        let (s, c) = direction.sin_cos();
        let through = self.poses[on].local([start[0] - way * c, start[1] - way * s]);
        let angle = normalized(direction - self.poses[on].angle);
        let tilt = normalized(self.poses[link].angle - direction);
        let name = format!("S{}", self.slides.len());
        self.slides.push(Slide { name: name.into(), link, on, point, through, angle, tilt });
        self.slides.len() - 1
    }
}

/// Least ratio of singular values of a group's constraints in the first position.
const LEAST_REGULARITY: f64 = 0.05;

/// Greatest number of arrangements of the pairs that are tried for a group.
const TRIES: usize = 60;

impl Draft {
    /// Adds a link that is driven against an earlier body, in a pin or a slide.
    pub(crate) fn driven(&mut self, on: LinkId, sliding: bool) -> Drive {
        let link = self.link();
        self.join_driven(link, on, sliding)
    }

    /// Joins two links by a driven pin or slide.
    fn join_driven(&mut self, link: LinkId, on: LinkId, sliding: bool) -> Drive {
        if sliding {
            let direction = self.rng.angle();
            let slide = self.slide(link, on, direction);
            let found = &self.slides[slide];
            let (link, on) = (found.link, found.on);
            let start = self.poses[on].local(self.poses[link].world(found.point));
            let (s, c) = found.angle.sin_cos();
            let from = c * (start[0] - found.through[0]) + s * (start[1] - found.through[1]);
            return Drive { link, on, pair: InputPair::Slide(slide), from };
        }
        // The origin of a crank's frame is usually, but not always, in the pin.
        let world = if self.rng.chance(0.6) { self.poses[link].world([0.0; 2]) } else { self.place() };
        let pair = InputPair::Pin(self.pin(link, on, world));
        let (link, on) = if on != GROUND && self.rng.chance(0.5) { (on, link) } else { (link, on) };
        Drive { link, on, pair, from: self.poses[link].angle - self.poses[on].angle }
    }

    /// Makes two links of one that has two pins and no slides, and drives them against each other, as a cylinder or an elbow; `None` if
    /// there is no such link.
    pub(crate) fn part(&mut self, drives: &[Drive], sliding: bool) -> Option<Drive> {
        let slides = |link: LinkId| self.slides.iter().any(|slide| [slide.link, slide.on].contains(&link));
        let pins = |link: LinkId| -> Vec<PointId> {
            let all = 0..self.points.len();
            all.filter(|id| self.points[*id].is_pin() && self.holds(*id, link)).collect()
        };
        let is_driven = |pin: PointId| drives.iter().any(|drive| drive.pair == InputPair::Pin(pin));
        let ends = (1..self.links.len()).filter_map(|link| match pins(link)[..] {
            [one, other] if !slides(link) => {
                [one, other].into_iter().find(|pin| !is_driven(*pin)).map(|pin| (link, pin))
            }
            _ => None,
        });
        let ends: Vec<_> = ends.collect();
        let (link, pin) = *ends.get(self.rng.below(ends.len()))?;
        let (new, world) = (self.link(), self.world_of(pin));
        let at = self.poses[new].local(world);
        let place = self.points[pin].places.iter_mut().find(|place| place.link == link)?;
        *place = Place { link: new, at };
        Some(self.join_driven(new, link, sliding))
    }

    /// Adds a group of this pattern on these earlier bodies, one for each outer pair; `None` if no arrangement of its
    /// pairs was found that is well away from a singular position.
    pub(crate) fn group(&mut self, pattern: &Pattern, outside: &[LinkId]) -> Option<()> {
        let links: Vec<LinkId> = (0..pattern.links).map(|_| self.link()).collect();
        let (points, slides) = (self.points.clone(), self.slides.clone());
        for _ in 0..TRIES {
            let pairs = drawn_pairs(&mut self.rng, pattern, &links, outside);
            let joins: Vec<Join> =
                pairs.into_iter().map(|(bodies, is_slide)| self.join(bodies, is_slide, &links)).collect();
            let origin = |link: LinkId| [self.poses[link].x, self.poses[link].y];
            if regularity(&constraints(&links, &joins, origin, self.size)) > LEAST_REGULARITY {
                return Some(());
            }
            (self.points, self.slides) = (points.clone(), slides.clone());
        }
        None
    }

    /// Joins the first body to the second: by a slide, by a new pin, or by an existing pin of a body outside the
    /// group.
    fn join(&mut self, bodies: [LinkId; 2], is_slide: bool, group: &[LinkId]) -> Join {
        let [link, body] = bodies;
        if is_slide {
            let guide = self.rng.angle();
            let slide = self.slide(link, body, guide);
            let found = &self.slides[slide];
            return Join { bodies, at: self.poses[found.link].world(found.point), guide: Some(guide) };
        }
        if !group.contains(&body) {
            return Join { bodies, at: self.hang(link, body), guide: None };
        }
        let at = self.place();
        self.pin(link, body, at);
        Join { bodies, at, guide: None }
    }
}
