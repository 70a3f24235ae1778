//! How much what is left out misses what it should keep together.

use assur_group::{Body, Order, Pair, PairGeometry};
use assur_mechanism::{GROUND, Key, Mechanism, PairId, Range};
use assur_number::{elementary, search::least};
use assur_structure::{NamedPair, Passive, PassivePart, Structure};
use assur_words::Text;
use serde::Serialize;

use crate::{Linkage, Position, passive::hang::Hanging};

/// Places over the cycle at which a misfit is looked for before it is refined.
const SAMPLES: usize = 240;
/// Golden sections of the interval between the two neighbors of the worst sample.
const SECTIONS: usize = 40;
/// A passive part fits if it misses by no more than this part of the size of the mechanism.
const FITS: f64 = 1e-9;
/// Steps of Newton's method for the length that would close.
const STEPS: usize = 12;

/// What a passive part misses over the cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Misfit {
    /// The part in words: `link rod3`.
    pub what: Text,
    /// The part.
    #[serde(skip)]
    pub part: PassivePart,
    /// Greatest distance between the two places that a pair of it should keep together; of a slide the greater of the distance
    /// and of the angle times the size of the mechanism, m.
    pub misfit: f64,
    /// The angle by which a slide misses, rad, where an angle is the greatest misfit.
    #[serde(skip)]
    pub angle: Option<f64>,
    /// Up to this it fits, m.
    pub limit: f64,
    /// The coordinate at which it is greatest, rad or m.
    pub at: f64,
    /// The number of the mechanism that would close, where it does not fit and one alone does.
    pub closes: Option<Closing>,
}

impl Misfit {
    /// Whether the part fits.
    pub fn fits(&self) -> bool {
        self.misfit <= self.limit
    }
}

/// A number of the mechanism with which a passive part would fit.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Closing {
    /// Its key in the scene: `link.rod3.points.B`.
    pub key: Key,
    /// Its value, m or rad.
    pub value: f64,
    /// Whether it is an angle.
    #[serde(skip)]
    pub is_angle: bool,
}

/// A number in the geometry of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Length {
    /// Coordinate (0: x, 1: y) of a point in a link.
    Point(usize, usize, usize),
    /// Coordinate of the point of a slide, in the sliding link.
    SlidePoint(usize, usize),
    /// Coordinate of the point through which the guide goes.
    Through(usize, usize),
    /// Direction of the guide.
    Angle(usize),
    /// Angle of the sliding link from the guide.
    Tilt(usize),
}

/// The misfits of all passive parts, in the order of the scene's greedy choice: the part that was left out first comes first.
pub(crate) fn misfits(linkage: &Linkage) -> Vec<Misfit> {
    let structure = &linkage.structure;
    if structure.passive.is_empty() || linkage.range.is_none() {
        return Vec::new();
    }
    let cycle = Cycle::of(linkage);
    structure.passive.iter().rev().map(|passive| cycle.misfit(passive)).collect()
}

/// The solved positions over the cycle.
struct Cycle<'a> {
    linkage: &'a Linkage,
    positions: Vec<Position>,
}

impl<'a> Cycle<'a> {
    fn of(linkage: &'a Linkage) -> Self {
        let input = &linkage.mechanism.input;
        let span = match input.range {
            Range::Cycle(cycle) => input.sign() * cycle,
            Range::To(to) => to - input.from,
        };
        let solved = |k: usize| {
            let mut position = linkage.position();
            let coordinate = input.from + span * k as f64 / SAMPLES as f64;
            linkage.solve(coordinate, Order::Place, &mut position).ok().map(|()| position)
        };
        Self { linkage, positions: (0..=SAMPLES).filter_map(solved).collect() }
    }

    fn misfit(&self, passive: &Passive) -> Misfit {
        let scale = self.linkage.structure.scale;
        let gap = |bodies: &[Body<f64>]| greatest(&passive.frame.outer, bodies, scale);
        let mut worst = (0, 0.0);
        for (k, position) in self.positions.iter().enumerate() {
            let found = gap(&position.bodies);
            if found > worst.1 {
                worst = (k, found);
            }
        }
        let (mut at, mut misfit) =
            (self.positions.get(worst.0).map_or(f64::NAN, |of| of.coordinate), worst.1);
        let limit = FITS * scale;
        let around = [worst.0.saturating_sub(1), worst.0 + 1].map(|k| self.positions.get(k));
        if let ([Some(low), Some(high)], true) = (around, misfit > limit) {
            let mut position = self.linkage.position();
            let (place, found) = least(low.coordinate, high.coordinate, SECTIONS, |q| {
                match self.linkage.solve(q, Order::Place, &mut position) {
                    Ok(()) => -gap(&position.bodies),
                    Err(_) => 0.0,
                }
            });
            if -found > misfit {
                (at, misfit) = (place, -found);
            }
        }
        let turned = self.positions.get(worst.0).is_some_and(|position| {
            let slides = passive.frame.outer.iter().filter(|pair| pair.is_slide());
            // The misfit of a slide by its angle is the same to rounding in all positions, or not refined far from the sample.
            slides.map(|pair| missed(pair, &position.bodies, scale)).any(|[_, turn]| turn.abs() >= worst.1)
        });
        let angle = (turned && worst.1 > 0.0).then_some(misfit / scale);
        let closes = if misfit > limit { self.closing(passive, limit) } else { None };
        let what = passive.part.words(&self.linkage.mechanism);
        Misfit { what, part: passive.part, misfit, angle, limit, at, closes }
    }

    /// The first number of the part's pairs, the last pair first, that alone makes it fit over the whole cycle.
    fn closing(&self, passive: &Passive, limit: f64) -> Option<Closing> {
        let Linkage { mechanism, structure, .. } = self.linkage;
        let of_pair = |pair: &Pair| lengths(mechanism, structure, passive, pair);
        let all = passive.frame.outer.iter().rev().flat_map(of_pair);
        all.into_iter().find_map(|number| {
            let value = self.closed_by(passive, number, limit)?;
            Some(Closing { key: number.key(mechanism), value, is_angle: number.is_angle() })
        })
    }

    /// The value of a number with which the part fits.
    fn closed_by(&self, passive: &Passive, number: Length, limit: f64) -> Option<f64> {
        let scale = self.linkage.structure.scale;
        let mut mechanism = self.linkage.mechanism.clone();
        let gaps = |mechanism: &Mechanism| self.gaps(passive, mechanism);
        let mut value = *number.of(&mut mechanism)?;
        let step = 1e-7 * if number.is_angle() { 1.0 } else { scale };
        for _ in 0..STEPS {
            let now = gaps(&mechanism);
            if now.iter().all(|gap| gap.abs() <= limit) {
                return Some(value);
            }
            *number.of(&mut mechanism)? = value + step;
            let beside = gaps(&mechanism);
            let (mut up, mut down) = (0.0, 0.0);
            for (now, beside) in now.iter().zip(&beside) {
                let slope = (beside - now) / step;
                up += slope * now;
                down += slope * slope;
            }
            if down <= 0.0 || !down.is_finite() {
                return None;
            }
            value -= up / down;
            *number.of(&mut mechanism)? = value;
        }
        None
    }

    /// What the pairs of a part miss over the cycle, each component, m, with other lengths of this part alone.
    fn gaps(&self, passive: &Passive, mechanism: &Mechanism) -> Vec<f64> {
        let (mut structure, scale) = (self.linkage.structure.clone(), self.linkage.structure.scale);
        structure.set_geometry(mechanism);
        let Some(varied) = structure.passive.iter().find(|other| other.part == passive.part) else {
            return Vec::new();
        };
        let hanging = Hanging::of(&varied.frame);
        let mut all = Vec::new();
        for position in self.positions.iter().step_by(8) {
            let mut bodies = position.bodies.clone();
            if let Some(hanging) = &hanging {
                hanging.solve(&mut bodies, Order::Place);
            }
            all.extend(varied.frame.outer.iter().flat_map(|pair| missed(pair, &bodies, scale)));
        }
        all
    }
}

/// The greatest gap of some pairs, m.
pub(crate) fn greatest(pairs: &[Pair], bodies: &[Body<f64>], scale: f64) -> f64 {
    let gap = |pair: &Pair| {
        let [one, two] = missed(pair, bodies, scale);
        if pair.is_slide() { one.abs().max(two.abs()) } else { elementary::hypot(one, two) }
    };
    pairs.iter().map(gap).fold(0.0, f64::max)
}

/// What a pair misses, m: of a pin along x and y, of a slide across the guide and by the angle times the size.
fn missed(pair: &Pair, bodies: &[Body<f64>], scale: f64) -> [f64; 2] {
    let (a, b) = (&bodies[pair.a], &bodies[pair.b]);
    match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => {
            let [one, two] = [a.point(at_a), b.point(at_b)];
            [one[0] - two[0], one[1] - two[1]]
        }
        PairGeometry::Slide { point, through, angle, tilt } => {
            let (s, c) = elementary::sin_cos(angle);
            let along = b.turned([c, s]);
            let [place, line] = [a.point(point), b.point(through)];
            let off = along[0] * (place[1] - line[1]) - along[1] * (place[0] - line[0]);
            let (s, c) = elementary::sin_cos(angle + tilt);
            let axis = b.turned([c, s]);
            let turn = elementary::atan2(axis[0] * a.s - axis[1] * a.c, axis[0] * a.c + axis[1] * a.s);
            [off, turn * scale]
        }
    }
}

/// The numbers of a pair: those in the passive link before those in the other.
fn lengths(mechanism: &Mechanism, structure: &Structure, passive: &Passive, pair: &Pair) -> Vec<Length> {
    let NamedPair { source, .. } = structure.pairs[pair.id];
    match source {
        PairId::Slide(slide) => {
            let [x, y] = [0, 1];
            vec![
                Length::Through(slide, y),
                Length::Through(slide, x),
                Length::SlidePoint(slide, y),
                Length::SlidePoint(slide, x),
                // With another tilt the guide stays where it is.
                Length::Tilt(slide),
                Length::Angle(slide),
            ]
        }
        PairId::Pin(point) => {
            let own = |link: usize| passive.frame.links.contains(&link);
            let mut links = [pair.a, pair.b];
            links.sort_by_key(|link| !own(*link));
            // A place that other pairs use too is not this part's to change.
            let only = mechanism.points[point].places.len() == 2;
            let links = links.into_iter().filter(|link| only || own(*link));
            links.flat_map(|link| [0, 1].map(|axis| Length::Point(point, link, axis))).collect()
        }
    }
}

impl Length {
    fn of(self, mechanism: &mut Mechanism) -> Option<&mut f64> {
        Some(match self {
            Self::Point(point, link, axis) => {
                let places = &mut mechanism.points[point].places;
                &mut places.iter_mut().find(|place| place.link == link)?.at[axis]
            }
            Self::SlidePoint(slide, axis) => &mut mechanism.slides[slide].point[axis],
            Self::Through(slide, axis) => &mut mechanism.slides[slide].through[axis],
            Self::Angle(slide) => &mut mechanism.slides[slide].angle,
            Self::Tilt(slide) => &mut mechanism.slides[slide].tilt,
        })
    }

    fn key(self, mechanism: &Mechanism) -> Key {
        let slide = |slide: usize| Key::of("slide").at(&mechanism.slides[slide].name);
        match self {
            Self::Point(point, GROUND, axis) => {
                Key::of("ground").at("points").at(&mechanism.points[point].name).at(axis)
            }
            Self::Point(point, link, axis) => {
                let at = mechanism.place_in(point, link).unwrap_or_default();
                let link = Key::of("link").at(&mechanism.links[link].name);
                let key = link.at("points").at(&mechanism.points[point].name);
                // On the x axis of a link a point is written as one number.
                if at[1].abs() > 0.0 || axis == 1 { key.at(axis) } else { key }
            }
            Self::SlidePoint(id, axis) => slide(id).at("point").at(axis),
            Self::Through(id, axis) => slide(id).at("through").at(axis),
            Self::Angle(id) => slide(id).at("angle"),
            Self::Tilt(id) => slide(id).at("tilt"),
        }
    }

    /// Whether it is an angle, rad; otherwise a length, m.
    fn is_angle(self) -> bool {
        matches!(self, Self::Angle(_) | Self::Tilt(_))
    }
}
