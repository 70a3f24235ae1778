//! The stroke of a point along an axis: its extremes over the cycle, and the coordinates at which the point passes the
//! rows of a table.

use assur_group::Body;
use assur_kinematics::PositionError;
use assur_mechanism::{LawTable, Place};
use assur_number::search::{bisect, try_newton_root};
use assur_number::{ROUNDING, elementary};

use crate::{
    LoadFault,
    breaks::Breaks,
    compile::BESIDE,
    curve::Curve,
    grid::{Bodies, Span},
};

/// Motion of a body at a coordinate, or why there is none.
pub(crate) type BodyAt<'a> = dyn FnMut(f64) -> Result<Body<f64>, PositionError> + 'a;

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Stroke {
    travel: Travel,
    /// While the point moves along the axis, and against it.
    tables: [Curve; 2],
    /// For a growing and for a falling input coordinate.
    senses: [Pieces; 2],
}

/// The extremes of a point along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Travel {
    /// Unit vector of the axis, ground.
    axis: [f64; 2],
    /// Least coordinate along the axis, m.
    least: f64,
    /// 1/(greatest - least), 1/m.
    inverse: f64,
}

impl Travel {
    /// Finds the extremes of the point `at` of a body over a span.
    pub(crate) fn find(
        body: &mut BodyAt<'_>,
        at: [f64; 2],
        angle: f64,
        span: &Span,
        scale: f64,
    ) -> Result<Self, LoadFault> {
        let mut along = Along { body, at, axis: [elementary::cos(angle), elementary::sin(angle)], scale };
        let reversals = along.reversals(span)?;
        Self::between(&mut along, &reversals, span)
    }

    fn between(along: &mut Along<'_, '_>, reversals: &[f64], span: &Span) -> Result<Self, LoadFault> {
        let end = span.from + span.length;
        let [mut least, mut greatest] = [f64::INFINITY, f64::NEG_INFINITY];
        for q in reversals.iter().copied().chain([span.from, end]) {
            let place = along.place(q)?[0];
            if place.is_nan() || place.abs() > GREATEST_DISTANCE * along.scale {
                return Err(LoadFault::InfiniteStroke(q));
            }
            (least, greatest) = (least.min(place), greatest.max(place));
        }
        let travel = greatest - least;
        if travel <= ROUNDING * along.scale {
            return Err(LoadFault::NoStroke(travel));
        }
        Ok(Self { axis: along.axis, least, inverse: 1.0 / travel })
    }

    /// Part of the travel at a coordinate along the axis, m.
    fn share(&self, along: f64) -> f64 {
        (along - self.least) * self.inverse
    }

    /// The part of the travel of a point of a body at a coordinate, and its two derivatives; beyond the ends of the travel too.
    pub(crate) fn motion(
        &self,
        bodies: &mut Bodies<'_>,
        (coordinate, at): (f64, Place),
    ) -> Result<[f64; 3], LoadFault> {
        let body = bodies
            .at(coordinate, at.link)
            .map_err(|reason| LoadFault::NoPosition(coordinate, Box::new(reason)))?;
        let along = |v: [f64; 2]| (self.axis[0] * v[0] + self.axis[1] * v[1]) * self.inverse;
        let [first, second] = body.motion(body.arm(at.at)).map(along);
        let [x, y] = body.point(at.at);
        Ok([self.share(self.axis[0] * x + self.axis[1] * y), first, second])
    }

    /// Part of the travel at a place of the point in the ground's frame, 0 to 1.
    #[inline]
    pub(crate) fn part(&self, point: [f64; 2]) -> f64 {
        self.share(self.axis[0] * point[0] + self.axis[1] * point[1]).clamp(0.0, 1.0)
    }
}

/// The formula in use between two coordinates.
#[derive(Debug, Clone, PartialEq, Default)]
struct Pieces {
    breaks: Breaks,
    chosen: Vec<Segment>,
}

/// A segment of one of the two tables.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Segment {
    /// Whether the point returns, so that the table `back` applies.
    pub(crate) back: bool,
    pub(crate) segment: usize,
}

/// A point that is this many sizes of the mechanism away runs through infinity.
const GREATEST_DISTANCE: f64 = 1e9;

/// Distance between the places at the two ends of a cycle above which it is not closed, in sizes of the mechanism.
const OPEN: f64 = 1e-6;

/// Coordinate of the point along the axis and its two derivatives with respect to the input coordinate.
struct Along<'a, 'b> {
    body: &'a mut BodyAt<'b>,
    at: [f64; 2],
    axis: [f64; 2],
    /// Size of the mechanism, m.
    scale: f64,
}

impl Along<'_, '_> {
    fn place(&mut self, q: f64) -> Result<[f64; 3], LoadFault> {
        let body = (self.body)(q).map_err(|reason| LoadFault::NoPosition(q, Box::new(reason)))?;
        let arm = body.arm(self.at);
        let along = |v: [f64; 2]| self.axis[0] * v[0] + self.axis[1] * v[1];
        Ok([along(body.point(self.at)), along(body.first(arm)), along(body.second(arm))])
    }

    /// The span; one after which the point is elsewhere, as where the mechanism passes a change point into another assembly mode, does
    /// not repeat and begins with the cycle.
    fn closed(&mut self, span: &Span) -> Result<Span, LoadFault> {
        let [start, end] = [self.place(span.from)?[0], self.place(span.from + span.length)?[0]];
        if !span.periodic || (end - start).abs() <= OPEN * self.scale {
            return Ok(*span);
        }
        Ok(Span { from: span.from - BESIDE * span.length, periodic: false, ..*span })
    }

    /// Where the point reverses, ascending.
    fn reversals(&mut self, span: &Span) -> Result<Vec<f64>, LoadFault> {
        let mut found = Vec::new();
        let mut before = self.place(span.from)?;
        for index in 1..=span.cells {
            let (low, high) = (span.at(index - 1), span.at(index));
            let after = self.place(high)?;
            if before[1] * after[1] < 0.0 {
                found.push(self.reversal(low, high)?);
            } else if before[1] == 0.0 {
                found.push(low);
            } else if before[2] * after[2] < 0.0 && before[1] * before[2] < 0.0 {
                found.extend(self.close_pair(low, high, before[1])?);
            } else if self.runs_back(before, after) {
                return Err(LoadFault::InfiniteStroke(self.pole(low, high, before)));
            }
            before = after;
        }
        Ok(found)
    }

    /// Whether a point that moves in one direction at both ends of a cell is displaced in the other: it left through infinity,
    /// and came back from the other side.
    fn runs_back(&self, before: [f64; 3], after: [f64; 3]) -> bool {
        let displacement = after[0] - before[0];
        displacement * before[1] < 0.0 && displacement.abs() > ROUNDING * self.scale
    }

    /// Where the point is at infinity in a cell in which it [runs back](Self::runs_back).
    fn pole(&mut self, low: f64, high: f64, start: [f64; 3]) -> f64 {
        let on_this_side = |q| self.place(q).is_ok_and(|s| (s[0] - start[0]) * start[1] >= 0.0);
        bisect(low, high, 0.0, on_this_side)[1]
    }

    /// The one reversal between two coordinates.
    fn reversal(&mut self, low: f64, high: f64) -> Result<f64, LoadFault> {
        try_newton_root(low, high, |q| self.place(q).map(|s| (s[1], s[2])))
    }

    /// Two reversals in one cell of the grid: PF1 changes its sign twice inside.
    fn close_pair(&mut self, low: f64, high: f64, velocity: f64) -> Result<Vec<f64>, LoadFault> {
        let step = 1e-3 * (high - low);
        let turn = try_newton_root(low, high, |q| {
            let third = (self.place(q + step)?[2] - self.place(q - step)?[2]) / (2.0 * step);
            self.place(q).map(|s| (s[2], third))
        })?;
        if self.place(turn)?[1] * velocity >= 0.0 {
            return Ok(Vec::new());
        }
        Ok(vec![self.reversal(low, turn)?, self.reversal(turn, high)?])
    }
}

impl Stroke {
    /// Finds the stroke of the point `at` of a body over a span; its direction is known over the `reach` of the motion, of which
    /// the span may be a part.
    pub(crate) fn find(
        body: &mut BodyAt<'_>,
        at: [f64; 2],
        angle: f64,
        tables: [&LawTable; 2],
        [span, reach]: [&Span; 2],
        scale: f64,
    ) -> Result<Self, LoadFault> {
        let axis = [elementary::cos(angle), elementary::sin(angle)];
        let mut along = Along { body, at, axis, scale };
        let [span, reach] = &[along.closed(span)?, along.closed(reach)?];
        let within = along.reversals(span)?;
        let travel = Travel::between(&mut along, &within, span)?;
        // A point that runs through infinity beyond the span has a stroke over it all the same.
        let beyond = if reach == span { None } else { along.reversals(reach).ok() };
        let (reversals, span) = beyond.map_or((within, span), |all| (all, reach));
        let mut stroke = Self { travel, tables: tables.map(Curve::of), senses: Default::default() };
        let monotone = monotone_ends(&reversals, span);
        stroke.senses = [
            stroke.pieces(&mut along, &monotone, span, false)?,
            stroke.pieces(&mut along, &monotone, span, true)?,
        ];
        Ok(stroke)
    }

    /// The pieces for one sense of the input: every reversal, and every row that the place passes between two of them.
    fn pieces(
        &self,
        along: &mut Along<'_, '_>,
        monotone: &[f64],
        span: &Span,
        falling: bool,
    ) -> Result<Pieces, LoadFault> {
        let share = |s: f64| self.travel.share(s);
        let mut points = Vec::new();
        for ends in monotone.windows(2) {
            let (first, last) = (share(along.place(ends[0])?[0]), share(along.place(ends[1])?[0]));
            let table = &self.tables[usize::from((last < first) != falling)];
            let (low, high) = (first.min(last), first.max(last));
            points.push(ends[0]);
            for row in table.arguments().iter().copied().filter(|row| *row > low && *row < high) {
                let gap = |q: f64, along: &mut Along<'_, '_>| {
                    along.place(q).map(|s| (share(s[0]) - row, s[1] * self.travel.inverse))
                };
                points.push(try_newton_root(ends[0], ends[1], |q| gap(q, along))?);
            }
        }
        if !span.periodic {
            // No formula changes at the ends of what the motion reaches.
            points.remove(0);
        }
        let breaks = Breaks::new(points, span.period());
        let mut chosen = Vec::with_capacity(breaks.count());
        for index in 0..breaks.count() {
            let [s, velocity, curvature] = along.place(breaks.inside(index, span.ends()))?;
            let velocity = if velocity == 0.0 { curvature } else { velocity };
            let back = (velocity < 0.0) != falling;
            chosen.push(Segment { back, segment: self.tables[usize::from(back)].segment(share(s)) });
        }
        Ok(Pieces { breaks, chosen })
    }

    /// The formula at a coordinate for this direction of the input, and the coordinates between which it is valid.
    #[inline(always)]
    pub(crate) fn piece(&self, coordinate: f64, sense: f64) -> (Segment, [f64; 2]) {
        let pieces = &self.senses[usize::from(sense < 0.0)];
        let interval = pieces.breaks.interval(coordinate);
        (pieces.chosen[interval.index], interval.ends)
    }

    /// The load at a position in the ground's frame by one formula.
    #[inline(always)]
    pub(crate) fn value(&self, piece: Segment, point: [f64; 2]) -> f64 {
        self.tables[usize::from(piece.back)].value(piece.segment, self.travel.part(point))
    }
}

/// Ends of the intervals in which the point moves in one direction, ascending.
fn monotone_ends(reversals: &[f64], span: &Span) -> Vec<f64> {
    let mut ends = reversals.to_vec();
    match ends.first() {
        Some(&first) if span.periodic => ends.push(first + span.length),
        _ => {
            ends.insert(0, span.from);
            ends.push(span.from + span.length);
        }
    }
    ends.dedup();
    ends
}
