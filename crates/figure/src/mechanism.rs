//! The items of a linkage in one position: links as bars and bodies, sliders on their guides, pins, ground, springs, brakes.
//!
//! Block brakes act on a disc that turns about the ground: the disc, the shoe on it, the lever with its force (D fig. 3.19).

mod gap;
#[cfg(test)]
mod tests;

use assur_group::Body;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Brake, Driver, GROUND, InputPair, LinkId, Mechanism, PairId, Slide, Surfaces, Value};
use assur_words::{Text, joined, name, quantity};

use crate::model::{Ink, Item, Point, Sign, Stroke};
use crate::number::plain;

/// A guide is longer than the stroke of its slider by this part, at each end.
const BEYOND: f64 = 0.08;
/// The most points that are all named; of more points only the names that cover nothing are written.
const MOST_NAMES: usize = 40;
/// Straight pieces of an arc.
const ARC: usize = 48;
/// Half the length of a guide whose ground is taken away, as part of the size of the mechanism.
const GUIDE: f64 = 0.12;
/// Least excess of a guide, as part of the size of the mechanism.
const LEAST_BEYOND: f64 = 0.02;

/// An arc of a link that rolls and slides along a straight line of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// The link.
    pub link: LinkId,
    /// Center of the arc in the frame of the link, m.
    pub center: Point,
    /// Its radius, m.
    pub radius: f64,
    /// The directions of its ends from the center, in the frame of the link, rad.
    pub ends: [f64; 2],
    /// The ends of the line, m.
    pub line: [Point; 2],
}

impl Arc {
    /// Points along the arc in the frame of the link.
    fn points(&self) -> impl Iterator<Item = Point> {
        let [from, to] = self.ends;
        (0..=ARC).map(move |step| {
            let (s, c) = (from + (to - from) * step as f64 / ARC as f64).sin_cos();
            [self.center[0] + self.radius * c, self.center[1] + self.radius * s]
        })
    }
}

/// What is drawn of a linkage, apart from its position.
#[derive(Debug, Clone, Copy)]
pub struct Drawing<'a> {
    /// The linkage.
    pub linkage: &'a Linkage,
    /// Least and greatest displacement of each slide over all positions, m.
    pub strokes: &'a [[f64; 2]],
    /// The arcs in contact with a line of the ground.
    pub arcs: &'a [Arc],
    /// Links that are drawn as chosen.
    pub marked: &'a [LinkId],
    /// Links that are not drawn, because they are not joined yet, have no place, or are taken away; the ground may be one.
    pub hidden: &'a [LinkId],
}

impl Drawing<'_> {
    /// The mechanism in one position, with the names of its points and the numbers of its links.
    pub fn items(&self, pose: &Position) -> Vec<Item> {
        let bodies = &pose.bodies;
        let mut links: Vec<LinkId> =
            (1..self.linkage.structure.links).filter(|link| self.shows(*link)).collect();
        // Chosen links lie over the others.
        links.sort_by_key(|link| self.marked.contains(link));
        let mut items = self.guides(bodies);
        items.extend(self.arcs(bodies));
        if self.shows(GROUND) {
            items.extend(brakes(&self.linkage.mechanism));
        }
        let mut numbers = Vec::new();
        for link in links {
            let outline = self.outline(link, &bodies[link]);
            numbers.extend(middle(&outline).map(|at| (at, link)));
            items.extend(self.body(outline, link));
        }
        items.extend(self.springs(bodies));
        items.extend(self.blocks(bodies));
        items.extend(self.friction_circles(bodies));
        items.extend(self.pins(bodies));
        items.extend(self.driven(bodies));
        for point in &self.linkage.mechanism.points {
            let Some(place) = point.places.iter().find(|place| self.shows(place.link)) else { continue };
            let at = bodies[place.link].point(place.at);
            let needed = self.linkage.mechanism.points.len() <= MOST_NAMES;
            items.push(Item::Name { at, text: (&point.name).into(), ink: Ink::Title, needed });
        }
        items.extend(numbers.into_iter().map(|(at, link)| {
            let (text, ink) = (name(link.to_string()), self.ink(link));
            Item::Name { at, text, ink, needed: false }
        }));
        items
    }

    /// The ground alone, for a position that does not exist.
    pub fn ground(&self) -> Vec<Item> {
        let nowhere = self.linkage.position();
        let bearings =
            self.pins(&nowhere.bodies).filter(|item| matches!(item, Item::Sign { sign: Sign::Bearing, .. }));
        self.guides(&nowhere.bodies).into_iter().chain(bearings).collect()
    }

    fn shows(&self, link: LinkId) -> bool {
        !self.hidden.contains(&link)
    }

    /// The ink of a link: its own, or that of what is highlighted.
    pub fn ink(&self, link: LinkId) -> Ink {
        match link {
            GROUND => Ink::Ground,
            _ if self.marked.contains(&link) => Ink::Marked,
            _ => Ink::Link(link),
        }
    }

    /// The corners of a link where its body is.
    fn outline(&self, link: LinkId, body: &Body<f64>) -> Vec<Point> {
        hull(&self.features(link)).into_iter().map(|at| body.point(at)).collect()
    }

    /// Three corners and more form a closed outline, two a bar.
    fn body(&self, outline: Vec<Point>, link: LinkId) -> Option<Item> {
        let ink = self.ink(link);
        match outline.len() {
            0 | 1 => None,
            2 => Some(Item::line(outline, Stroke::Thick, ink)),
            _ => Some(Item::Area { outline, ink }),
        }
    }

    /// The ends of the guide of a slide in the frame of the link that carries it; `None` if it has no stroke.
    fn guide(&self, slide: &Slide, [low, high]: [f64; 2]) -> Option<[Point; 2]> {
        let beyond = (BEYOND * (high - low)).max(LEAST_BEYOND * self.linkage.structure.scale);
        let (s, c) = slide.angle.sin_cos();
        let at = |d: f64| [slide.through[0] + d * c, slide.through[1] + d * s];
        (low.is_finite() && high.is_finite()).then(|| [at(low - beyond), at(high + beyond)])
    }

    fn guides(&self, bodies: &[Body<f64>]) -> Vec<Item> {
        let slides = self.linkage.mechanism.slides.iter().zip(self.strokes);
        let ground = slides.filter(|(slide, _)| slide.on == GROUND);
        let ends = ground.filter_map(|(slide, stroke)| self.guide(slide, *stroke));
        let ends = ends.map(|ends| ends.map(|at| bodies[GROUND].point(at)));
        ends.map(|ends| Item::Ground { ends, guides: true }).collect()
    }

    /// The arcs with their lines and the radii to their ends.
    fn arcs(&self, bodies: &[Body<f64>]) -> Vec<Item> {
        let mut items = Vec::new();
        for arc in self.arcs.iter().filter(|arc| self.shows(arc.link)) {
            let body = &bodies[arc.link];
            let points: Vec<Point> = arc.points().map(|at| body.point(at)).collect();
            let (center, ends) = (body.point(arc.center), [points[0], points[points.len() - 1]]);
            items.push(Item::Ground { ends: arc.line, guides: false });
            items.push(Item::line([ends[0], center, ends[1]], Stroke::Dashed, Ink::Trace));
            items.push(Item::line(points, Stroke::Thick, self.ink(arc.link)));
        }
        items
    }

    /// The sliders; of one whose guide belongs to a ground that is taken away, the direction of the guide as a fine line too.
    fn blocks(&self, bodies: &[Body<f64>]) -> impl Iterator<Item = Item> {
        let slides = self.linkage.mechanism.slides.iter();
        let is_shown =
            |slide: &&Slide| self.shows(slide.link) && (slide.on == GROUND || self.shows(slide.on));
        slides.filter(is_shown).flat_map(|slide| {
            let (s, c) = slide.angle.sin_cos();
            let (at, along) = (bodies[slide.link].point(slide.point), bodies[slide.on].turned([c, s]));
            let half = GUIDE * self.linkage.structure.scale;
            let ends = [-half, half].map(|far| [at[0] + far * along[0], at[1] + far * along[1]]);
            let guide = (!self.shows(slide.on)).then(|| Item::line(ends, Stroke::Dashed, Ink::Ground));
            guide.into_iter().chain([Item::Sign { at, along, sign: Sign::Block, ink: self.ink(slide.link) }])
        })
    }

    fn pins(&self, bodies: &[Body<f64>]) -> impl Iterator<Item = Item> {
        self.linkage.mechanism.points.iter().filter_map(|point| {
            let ground = point.places.iter().find(|place| place.link == GROUND && self.shows(GROUND));
            let place = ground.or(point.places.iter().find(|place| self.shows(place.link)))?;
            let (sign, ink) = match (ground, point.is_pin()) {
                (Some(_), true) => (Sign::Bearing, Ink::Ground),
                (None, true) => (Sign::Pin, self.ink(place.link)),
                (_, false) => (Sign::Dot, self.ink(place.link)),
            };
            Some(Item::sign(bodies[place.link].point(place.at), sign, ink))
        })
    }

    /// The marks of driven pairs between two moving links: a dot with the name of the coordinate, with its number where several are
    /// driven.
    fn driven(&self, bodies: &[Body<f64>]) -> Vec<Item> {
        let mechanism = &self.linkage.mechanism;
        let input = &mechanism.input;
        let is_shown =
            |driver: &Driver| driver.is_relative() && self.shows(driver.link) && self.shows(driver.on);
        let mark = |(index, driver): (usize, &Driver)| {
            let own = match driver.pair {
                InputPair::Pin(pin) => mechanism.place_in(pin, driver.link).unwrap_or_default(),
                InputPair::Slide(slide) => mechanism.slides[slide].point,
            };
            let at = bodies[driver.link].point(own);
            let numbered = if input.drivers.len() > 1 { format!("q{}", index + 1) } else { "q".to_owned() };
            let text = input.name.as_ref().map_or_else(|| name(numbered), Text::from);
            let name = Item::Name { at, text, ink: Ink::Second, needed: false };
            [Item::sign(at, Sign::Dot, Ink::Second), name]
        };
        input.drivers.iter().enumerate().filter(|(_, driver)| is_shown(driver)).flat_map(mark).collect()
    }

    /// The circles of friction of the pins, of radius coefficient times that of the journal: what the reactions with friction touch.
    fn friction_circles(&self, bodies: &[Body<f64>]) -> impl Iterator<Item = Item> {
        let mechanism = &self.linkage.mechanism;
        mechanism.frictions.iter().filter_map(|friction| {
            let (PairId::Pin(point), Surfaces::Journal { radius, .. }) = (friction.pair, friction.surfaces)
            else {
                return None;
            };
            let place = mechanism.points[point].places.iter().find(|place| self.shows(place.link))?;
            let (center, radius) = (bodies[place.link].point(place.at), friction.coefficient * radius);
            (radius > 0.0).then(|| Item::circle(center, radius, Stroke::Solid, Ink::Trace))
        })
    }

    fn springs(&self, bodies: &[Body<f64>]) -> impl Iterator<Item = Item> {
        let springs = self.linkage.mechanism.loads.iter().filter_map(|load| load.kind.spring());
        springs.filter(|spring| spring.ends.iter().all(|end| self.shows(end.link))).map(|spring| {
            let [from, to] = spring.ends.map(|end| bodies[end.link].point(end.at));
            let (elastic, damped) = (spring.stiffness != 0.0, spring.damping != 0.0);
            Item::Spring { from, to, elastic, damped }
        })
    }

    /// The places of a link that its outline joins, in its frame: its points, its sliders, the guides that it carries.
    fn features(&self, link: LinkId) -> Vec<Point> {
        let mechanism = &self.linkage.mechanism;
        let named = (0..mechanism.points.len()).filter_map(|id| mechanism.place_in(id, link));
        let stones = mechanism.slides.iter().filter(|slide| slide.link == link).map(|slide| slide.point);
        let carried = mechanism.slides.iter().zip(self.strokes).filter(|(slide, _)| slide.on == link);
        let guides = carried.filter_map(|(slide, stroke)| self.guide(slide, *stroke)).flatten();
        let springs =
            mechanism.loads.iter().filter_map(|load| load.kind.spring()).flat_map(|spring| spring.ends);
        let held = springs.filter(|end| end.link == link).map(|end| end.at);
        named.chain(stones).chain(guides).chain(held).collect()
    }
}

fn middle(outline: &[Point]) -> Option<Point> {
    let sides = outline.iter().zip(outline.iter().skip(1).chain(outline.first()));
    let length = |(a, b): &(&Point, &Point)| (b[0] - a[0]).hypot(b[1] - a[1]);
    let longest = sides.max_by(|one, other| length(one).total_cmp(&length(other)));
    longest.map(|(a, b)| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])
}

/// Convex hull (Andrew's monotone chain); collinear points give their two ends.
fn hull(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    sorted.dedup_by(|a, b| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9);
    if sorted.len() < 3 {
        return sorted;
    }
    let mut lower = half_hull(sorted.iter().copied());
    let mut upper = half_hull(sorted.iter().rev().copied());
    lower.pop();
    upper.pop();
    lower.extend(upper);
    lower
}

fn half_hull(points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut chain: Vec<[f64; 2]> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..] {
            let cross = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            let size = (b[0] - a[0]).hypot(b[1] - a[1]) * (p[0] - a[0]).hypot(p[1] - a[1]);
            if cross > 1e-9 * size {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain
}

/// Height of the lever above the disc and length of the arrow of its force, as parts of the radius.
const ABOVE: f64 = 0.25;
const ARROW: f64 = 0.6;

/// Everything that is drawn of the brakes; it does not move.
pub fn brakes(mechanism: &Mechanism) -> Vec<Item> {
    let brakes = mechanism.loads.iter().filter_map(|load| load.kind.brake());
    let drawn = |brake: &Brake| {
        // The disc has its center at its pin on the ground.
        let mut pins = (0..mechanism.points.len()).filter(|id| mechanism.place_in(*id, brake.link).is_some());
        Some(drawn_brake(brake, pins.find_map(|id| mechanism.place_in(id, GROUND))?))
    };
    brakes.filter_map(drawn).flatten().collect()
}

/// The shoe presses down on the top of the disc; the lever has its pin one radius to the left of it, and the force at the end of
/// its ratio.
fn drawn_brake(brake: &Brake, center: Point) -> Vec<Item> {
    let radius = brake.radius;
    let at = |x: f64, y: f64| [center[0] + x * radius, center[1] + y * radius];
    let (height, end) = (1.0 + ABOVE, brake.lever.max(1.0) - 1.0);
    let force = at(end, height + ARROW);
    let told = match brake.force {
        Value::Constant(size) => joined(" = ", [name("P"), quantity(plain(size), "N")]),
        _ => name("P"),
    };
    vec![
        Item::circle(center, radius, Stroke::Solid, Ink::Link(brake.link)),
        Item::line([at(0.0, 1.0), at(0.0, height)], Stroke::Thick, Ink::Text),
        Item::line([at(-1.0, height), at(end.max(0.0), height)], Stroke::Thick, Ink::Text),
        Item::sign(at(-1.0, height), Sign::Bearing, Ink::Ground),
        Item::sign(at(0.0, 1.0 + 0.3 * ABOVE), Sign::Block, Ink::Text),
        Item::Arrow { from: force, to: at(end, height), stroke: Stroke::Solid, ink: Ink::Second },
        Item::name(force, told, Ink::Second),
    ]
}
