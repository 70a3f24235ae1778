//! Where the inner pairs of what is added are put in the plane.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur_group::plane::{cross, direction, minus, perp, plus, scaled};
use assur_group::{Body, GroupFrame, Pair, PairGeometry, health_generally};
use assur_mechanism::GROUND;

use crate::pose::{Line, angle_of, distance, foot, way};
use crate::shape::{Bond, Joint, Shape};

/// Most arrangements that are returned.
const MOST: usize = 6;

/// An arrangement is as good as the best one if its score is at least this part of it.
const GOOD: f64 = 0.4;

/// The height of the apex above two points, in parts of their distance: the legs are 0.9 of it.
const APEX: f64 = 0.75;

/// How an arrangement differs from the first one.
#[derive(Debug, Clone, Copy)]
struct Trial {
    /// Factor of lengths.
    stretch: f64,
    /// Angle by which directions are turned, rad.
    turn: f64,
}

/// Arrangements of the inner and outer pairs, those first that are to be tried first.
pub(crate) fn layouts(shape: &Shape, outer: &[Joint], size: f64, rod: f64) -> Vec<Vec<Joint>> {
    let scale = Scale::of(outer, size, rod);
    let stretched = [1.0, 1.5, 2.2].map(|stretch| Trial { stretch, turn: 0.0 });
    let turned = (1..12).flat_map(|part| {
        [1.0, 1.5, 0.7].map(|stretch| Trial { stretch, turn: PI + TAU * f64::from(part) / 12.0 })
    });
    let trials: Vec<_> = stretched.into_iter().chain(turned).collect();
    let all = trials.into_iter().map(|trial| scale.arranged(shape, outer, trial));
    let scored: Vec<_> = all.map(|joints| (score(shape, &joints, size), joints)).collect();
    let best = scored.iter().map(|(score, _)| *score).fold(0.0, f64::max);
    let good = scored.into_iter().filter(|(score, _)| *score >= GOOD * best).map(|(_, joints)| joints);
    if shape.inner == 0 { good.take(1).collect() } else { good.take(MOST).collect() }
}

/// The outer pairs as a whole.
struct Scale {
    /// Their middle.
    center: [f64; 2],
    /// Their distance from it, m.
    reach: f64,
    size: f64,
    /// The usual length of a rod to a slide, m.
    rod: f64,
}

impl Scale {
    fn of(outer: &[Joint], size: f64, rod: f64) -> Self {
        let places = || outer.iter().map(|joint| joint.place());
        let count = outer.len().max(1) as f64;
        let center = scaled(1.0 / count, places().fold([0.0; 2], plus));
        let reach = places().map(|place| distance(place, center)).sum::<f64>() / count;
        Self { center, reach: reach.max(0.4 * size), size, rod }
    }

    fn arranged(&self, shape: &Shape, outer: &[Joint], trial: Trial) -> Vec<Joint> {
        let mut joints: Vec<Option<Joint>> = vec![None; shape.inner];
        joints.extend(outer.iter().copied().map(Some));
        for bond in 0..shape.inner {
            if !shape.bonds[bond].slides {
                joints[bond] = Some(Joint::Pin(self.pin(shape, &joints, bond, trial)));
            }
        }
        for bond in 0..shape.inner {
            if shape.bonds[bond].slides {
                joints[bond] = Some(Joint::Guide(self.guide(shape, &joints, bond, trial)));
            }
        }
        joints.into_iter().flatten().collect()
    }

    /// The place of an inner pin.
    fn pin(&self, shape: &Shape, joints: &[Option<Joint>], bond: usize, trial: Trial) -> [f64; 2] {
        let Bond { link, on, .. } = shape.bonds[bond];
        let links = [link, on.unwrap_or(link)];
        let lines = links.map(|link| line_of(shape, joints, link));
        let held = links.map(|link| outer_pin(shape, joints, link));
        if let [Some(one), Some(other)] = lines {
            let near = |place: &[f64; 2]| distance(*place, self.center) < 5.0 * self.size;
            return meet(one, other).filter(near).unwrap_or_else(|| foot(one, self.center));
        }
        let between = match held {
            [Some(one), Some(other)] => self.apex(one, other, trial),
            [Some(one), None] | [None, Some(one)] => self.leg(shape, bond, one, trial),
            [None, None] => self.leg(shape, bond, self.center, trial),
        };
        match (lines[0].or(lines[1]), held[0].or(held[1])) {
            (Some(line), Some(from)) => self.along(line, from, trial),
            (Some(line), None) => foot(line, between),
            (None, _) => between,
        }
    }

    /// Above two places, to the left of the way from the first to the other.
    fn apex(&self, one: [f64; 2], other: [f64; 2], Trial { stretch, turn }: Trial) -> [f64; 2] {
        let apart = minus(other, one);
        let apart = if distance(one, other) > 1e-3 * self.size { apart } else { [self.size, 0.0] };
        let up = assur_group::plane::times(scaled(stretch * APEX, perp(apart)), direction(turn));
        plus(scaled(0.5, plus(one, other)), up)
    }

    /// On the way from an outer pin to the middle, each pin beside the others, without symmetry: symmetric groups are often singular.
    fn leg(&self, shape: &Shape, bond: usize, from: [f64; 2], Trial { stretch, turn }: Trial) -> [f64; 2] {
        let middle = plus(self.center, [0.0, 0.6 * stretch * self.reach]);
        let base = plus(from, scaled(0.6, minus(middle, from)));
        let part = bond as f64 / shape.inner as f64;
        let beside = FRAC_PI_2 + turn + TAU * part * (1.0 - 0.2 * part);
        plus(base, scaled((0.3 + 0.25 * part) * stretch * self.reach, direction(beside)))
    }

    /// On a line, a rod away from a place: where the line was given, if that is far enough.
    fn along(&self, line: Line, from: [f64; 2], Trial { stretch, turn }: Trial) -> [f64; 2] {
        let is_first = turn == 0.0 && stretch <= 1.0;
        if is_first && distance(line.0, from) >= self.rod {
            return line.0;
        }
        let foot = foot(line, from);
        let height = distance(foot, from);
        let rod = stretch * self.rod.max(1.5 * height);
        // To the side where the line was given, if that is far; half of the turned trials go the other way.
        let is_behind = way((foot, line.1), line.0) < -self.rod;
        let side = if is_behind == (turn == 0.0 || turn > TAU) { -1.0 } else { 1.0 };
        plus(foot, scaled(side * ((rod - height) * (rod + height)).sqrt(), direction(line.1)))
    }

    /// The line of an inner slide.
    fn guide(&self, shape: &Shape, joints: &[Option<Joint>], bond: usize, trial: Trial) -> Line {
        let Bond { link, on, .. } = shape.bonds[bond];
        let on = on.unwrap_or(link);
        let turn = if trial.turn == 0.0 { 0.0 } else { trial.turn * (bond + 1) as f64 };
        let first = |link: usize| {
            shape.pins(link).find_map(|pin| match joints[pin] {
                Some(Joint::Pin(place)) => Some(place),
                _ => None,
            })
        };
        match (first(link), first(on)) {
            (Some(own), Some(other)) if distance(own, other) > 1e-3 * self.size => {
                let angle = angle_of(minus(own, other));
                if turn == 0.0 { (other, angle) } else { (own, angle + turn) }
            }
            (own, other) => {
                let through = own.or(other).unwrap_or(self.center);
                // Across the guide of the link without a pin, which would else be held twice.
                let guide = [on, link].into_iter().filter(|link| first(*link).is_none()).find_map(|link| {
                    shape.slides(link).find_map(|slide| match joints[slide] {
                        Some(Joint::Guide(line)) => Some(line.1),
                        _ => None,
                    })
                });
                (through, guide.map_or(0.0, |angle| angle + FRAC_PI_2) + turn)
            }
        }
    }
}

/// The outer guide of a link that has one pin and so may have it on the line.
fn line_of(shape: &Shape, joints: &[Option<Joint>], link: usize) -> Option<Line> {
    let outer = (shape.inner..shape.bonds.len()).filter(|bond| shape.bonds[*bond].link == link);
    let line = outer.into_iter().find_map(|bond| match joints[bond] {
        Some(Joint::Guide(line)) => Some(line),
        _ => None,
    });
    line.filter(|_| shape.pins(link).count() == 1)
}

/// The first outer pin of a link.
fn outer_pin(shape: &Shape, joints: &[Option<Joint>], link: usize) -> Option<[f64; 2]> {
    let mut outer = (shape.inner..shape.bonds.len()).filter(|bond| shape.bonds[*bond].link == link);
    outer.find_map(|bond| match joints[bond] {
        Some(Joint::Pin(place)) => Some(place),
        _ => None,
    })
}

/// Where two lines meet that are not nearly parallel.
pub(crate) fn meet(one: Line, other: Line) -> Option<[f64; 2]> {
    let (along, across) = (direction::<f64>(one.1), direction(other.1));
    let sine = cross(along, across);
    let way = cross(minus(other.0, one.0), across) / sine;
    (sine.abs() > 0.1).then(|| plus(one.0, scaled(way, along)))
}

/// How well an arrangement determines the links, from 0 to 1: its determinant, less where pins of a link are close to each other or
/// far away.
fn score(shape: &Shape, joints: &[Joint], size: f64) -> f64 {
    let place = |bond: usize| joints[bond].place();
    let mut fits = 1.0_f64;
    for link in 0..shape.links {
        let pins: Vec<_> = shape.pins(link).map(place).collect();
        for (k, one) in pins.iter().enumerate() {
            for other in &pins[..k] {
                let part = distance(*one, *other) / size;
                fits = fits.min(5.0 * part).min(3.0 / part.max(1e-9));
            }
        }
    }
    if 3 * shape.links != 2 * shape.bonds.len() {
        return fits.max(1e-9);
    }
    let origin = |link: usize| shape.pins(link).chain(shape.slides(link)).next().map_or([0.0; 2], place);
    let mut bodies = vec![Body::ground()];
    bodies.extend((0..shape.links).map(|link| {
        let mut body = Body::ground();
        [body.x, body.y] = origin(link);
        body
    }));
    let pair = |(id, bond): (usize, &Bond)| {
        let (a, b) = (bond.link + 1, bond.on.map_or(GROUND, |on| on + 1));
        let [at_a, at_b] = [a, b].map(|body| minus(place(id), bodies[body].origin()));
        let geometry = match joints[id] {
            Joint::Pin(_) => PairGeometry::Pin { at_a, at_b },
            Joint::Guide((_, angle)) => {
                PairGeometry::Slide { point: at_a, through: at_b, angle, tilt: -angle }
            }
        };
        Pair { id, a, b, geometry }
    };
    let mut inner: Vec<_> = shape.bonds.iter().enumerate().map(pair).collect();
    let outer = inner.split_off(shape.inner);
    let frame =
        GroupFrame { links: (1..=shape.links).collect(), inner, outer, driven: Vec::new(), scale: size };
    fits.clamp(0.0, 1.0) * health_generally(&frame, &bodies)
}
