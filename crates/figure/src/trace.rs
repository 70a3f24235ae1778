//! Items on paper, as lines, areas, signs and names alone, before a renderer draws them.
//!
//! Lengths on paper have equal units in both directions: widths of a cell, or millimeters; y grows downwards.

use crate::model::{Ink, Item, Point, Sign, Stroke};

/// Half length and half thickness of a slider, in text sizes.
pub(crate) const BLOCK: [f64; 2] = [1.0, 0.55];
const TURNS: usize = 6;
/// Half width of a spring and of a damper's cylinder, in text sizes.
const COIL: f64 = 0.4;
/// Distance of a spring and of a damper from the line between their ends, where there are both, in text sizes.
const BESIDE: f64 = 0.55;
/// Length of the straight ends of a spring, as part of its length.
const ENDS: f64 = 0.15;
/// Distance of the strokes of a hatching, in text sizes.
const HATCHING: f64 = 0.5;
/// Most strokes of a hatching: no paper has more.
const MOST_HATCHES: f64 = 2000.0;
const MOST_STARS: usize = 24;
/// Arrows shorter than this have a head without a direction, in text sizes.
const SHORTEST: f64 = 0.5;

/// How a panel comes to paper.
#[derive(Debug)]
pub(crate) struct Paper<F> {
    /// Place on paper of a point of the panel.
    pub(crate) place: F,
    pub(crate) em: f64,
    /// What must stay free between two lines that are to be told apart.
    pub(crate) gap: f64,
}

impl<F: Fn(Point) -> Point> Paper<F> {
    /// An item as lines, areas, signs and names; a sign or a name without a place is left out.
    pub(crate) fn marks(&self, item: &Item) -> Vec<Item> {
        let place = &self.place;
        let all = |points: &[Point]| points.iter().map(|at| place(*at)).collect::<Vec<_>>();
        let mut marks = match item {
            Item::Line { points, stroke, ink } => vec![Item::line(all(points), *stroke, *ink)],
            Item::Area { outline, ink } => vec![Item::Area { outline: all(outline), ink: *ink }],
            Item::Arrow { from, to, stroke, ink } => self.arrow(place(*from), place(*to), *stroke, *ink),
            // A slider stands between its path and the face of the guide.
            Item::Ground { ends, guides } => {
                self.hatched(ends.map(place), if *guides { BLOCK[1] * self.em + self.gap } else { 0.0 })
            }
            Item::Spring { from, to, elastic, damped } => {
                self.suspension(place(*from), place(*to), *elastic, *damped)
            }
            Item::Sign { at, along, sign, ink } => {
                let tip = place([at[0] + along[0], at[1] + along[1]]);
                let at = place(*at);
                vec![Item::Sign { at, along: unit(at, tip).0, sign: *sign, ink: *ink }]
            }
            Item::Name { at, text, ink, needed } => {
                vec![Item::Name { at: place(*at), text: text.clone(), ink: *ink, needed: *needed }]
            }
        };
        marks.retain(|mark| match mark {
            Item::Sign { at, .. } | Item::Name { at, .. } => at[0].is_finite() && at[1].is_finite(),
            _ => true,
        });
        marks
    }

    fn arrow(&self, from: Point, to: Point, stroke: Stroke, ink: Ink) -> Vec<Item> {
        let (along, length) = unit(from, to);
        // A short arrow keeps its head, without a direction, so that all frames of an animation have the same marks.
        let along = if length >= SHORTEST * self.em { along } else { [0.0; 2] };
        vec![Item::line([from, to], stroke, ink), Item::Sign { at: to, along, sign: Sign::Head, ink }]
    }

    /// A line of the ground at a distance from two points, hatched on the side away from them.
    fn hatched(&self, [from, to]: [Point; 2], away: f64) -> Vec<Item> {
        let (along, length) = unit(from, to);
        // The lower side; of a vertical guide the right one.
        let upright = along[0].abs() <= 1e-9;
        let side = if along[0] > 1e-9 || (upright && along[1] < 0.0) { 1.0 } else { -1.0 };
        let out = [-side * along[1], side * along[0]];
        let [from, to] = [from, to].map(|at| shifted(at, out, away));
        let mut marks = vec![Item::line([from, to], Stroke::Solid, Ink::Ground)];
        let steps = (length / (HATCHING * self.em)).ceil().clamp(1.0, MOST_HATCHES);
        let mut step = 0.0;
        while step <= steps && length.is_finite() {
            let at = shifted(from, along, step / steps * length);
            marks.push(Item::Sign { at, along: out, sign: Sign::Hatch, ink: Ink::Ground });
            step += 1.0;
        }
        marks
    }

    /// A spring, a damper, or both beside each other.
    fn suspension(&self, from: Point, to: Point, elastic: bool, damped: bool) -> Vec<Item> {
        let (along, _) = unit(from, to);
        let across = [along[1], -along[0]];
        let aside = if elastic && damped { BESIDE * self.em } else { 0.0 };
        let both = |by: f64| [from, to].map(|end| shifted(end, across, by));
        let mut marks = Vec::new();
        if elastic {
            let [from, to] = both(aside);
            marks.push(line(&self.spring(from, to)));
        }
        if damped {
            let [from, to] = both(-aside);
            marks.extend(self.damper(from, to));
        }
        if aside > 0.0 {
            let ([a, b], [c, d]) = (both(aside), both(-aside));
            marks.extend([line(&[a, c]), line(&[b, d])]);
        }
        marks
    }

    fn spring(&self, from: Point, to: Point) -> Vec<Point> {
        let (along, length) = unit(from, to);
        let across = [along[1], -along[0]];
        let coil = length * (1.0 - 2.0 * ENDS) / (2 * TURNS) as f64;
        let mut points = vec![from, shifted(from, along, ENDS * length)];
        for half in 0..2 * TURNS {
            let side = if half % 2 == 0 { COIL } else { -COIL } * self.em;
            let at = shifted(from, along, ENDS * length + (half as f64 + 0.5) * coil);
            points.push(shifted(at, across, side));
        }
        points.extend([shifted(from, along, (1.0 - ENDS) * length), to]);
        points
    }

    /// A cylinder, open towards the second end, with its piston.
    fn damper(&self, from: Point, to: Point) -> Vec<Item> {
        let (along, length) = unit(from, to);
        let across = [along[1], -along[0]];
        let (half, [bottom, top]) = (COIL * self.em, [0.35, 0.65].map(|part| part * length));
        let at = |far: f64, side: f64| shifted(shifted(from, along, far), across, side * half);
        let middle = 0.5 * length;
        vec![
            line(&[from, at(bottom, 0.0)]),
            line(&[at(top, 1.0), at(bottom, 1.0), at(bottom, -1.0), at(top, -1.0)]),
            line(&[at(middle, 0.8), at(middle, -0.8)]),
            line(&[at(middle, 0.0), to]),
        ]
    }
}

fn line(points: &[Point]) -> Item {
    Item::line(points, Stroke::Solid, Ink::Text)
}

/// Direction and distance from one point to another; to the right where they are one.
pub(crate) fn unit(from: Point, to: Point) -> (Point, f64) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy);
    if length > 0.0 && length.is_finite() {
        ([dx / length, dy / length], length)
    } else {
        ([1.0, 0.0], length)
    }
}

pub(crate) fn shifted(at: Point, along: Point, by: f64) -> Point {
    [at[0] + by * along[0], at[1] + by * along[1]]
}

pub(crate) fn block(at: Point, along: Point, em: f64) -> [Point; 4] {
    let across = [-along[1], along[0]];
    [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
        .map(|[u, v]| shifted(shifted(at, along, u * BLOCK[0] * em), across, v * BLOCK[1] * em))
}

/// The stars on a curve that is drawn in stars: its dots alone are hard to tell from a line nearby.
pub(crate) fn stars(item: &Item) -> Vec<Item> {
    let Item::Line { points, stroke: Stroke::Stars, ink } = item else { return Vec::new() };
    let step = points.len().div_ceil(MOST_STARS).max(1);
    let finite = points.iter().step_by(step).filter(|at| at[1].is_finite());
    finite.map(|at| Item::sign(*at, Sign::Star, *ink)).collect()
}
