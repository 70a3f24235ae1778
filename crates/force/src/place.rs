//! The place of a point along its stroke as a function of the coordinate, with bounds over an interval: polynomials that join with
//! two derivatives.

use assur_number::panel::Bernstein;

use crate::LoadFault;
use crate::grid::Span;

/// Into how many equal parts a span is divided first.
const FEWEST: u32 = 32;
/// Halvings of such a part: beyond them a place that is not smooth there is taken as it is.
const HALVINGS: u32 = 12;
/// Parts of a stroke by which a polynomial may miss the place in the middle of its part.
const ACCURACY: f64 = 1e-13;

/// The places, as parts of the stroke, of a point over a span. Beyond a span that does not repeat, the place at its end.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlaceCourse {
    /// Where the parts begin, and the end of the last one.
    ends: Vec<f64>,
    parts: Vec<Bernstein<6>>,
    period: Option<f64>,
}

impl PlaceCourse {
    /// Fits the place and its two derivatives by the coordinate, which `at` gives.
    pub(crate) fn fit(
        span: &Span,
        mut at: impl FnMut(f64) -> Result<[f64; 3], LoadFault>,
    ) -> Result<Self, LoadFault> {
        let first = Span { cells: FEWEST, ..*span };
        let mut left = Vec::new();
        for cell in (0..FEWEST).rev() {
            let [from, to] = [first.at(cell), first.at(cell + 1)];
            left.push(([(from, at(from)?), (to, at(to)?)], HALVINGS));
        }
        let (mut ends, mut parts) = (vec![span.from], Vec::new());
        while let Some(([low, high], halvings)) = left.pop() {
            let part = joined([low.1, high.1], high.0 - low.0);
            let middle = f64::midpoint(low.0, high.0);
            let there = at(middle)?;
            if halvings > 0 && (part.halves()[0].end() - there[0]).abs() > ACCURACY {
                left.extend(
                    [[(middle, there), high], [low, (middle, there)]].map(|half| (half, halvings - 1)),
                );
                continue;
            }
            ends.push(high.0);
            parts.push(part);
        }
        Ok(Self { ends, parts, period: span.period() })
    }

    /// The place at a coordinate.
    pub(crate) fn at(&self, coordinate: f64) -> f64 {
        self.bounds([coordinate; 2])[0][0]
    }

    /// Bounds of the place between two coordinates, and of its derivative.
    pub(crate) fn bounds(&self, [mut from, mut to]: [f64; 2]) -> [[f64; 2]; 2] {
        let (mut places, mut slopes) = (NOTHING, NOTHING);
        let whole = [self.ends[0], self.ends[self.parts.len()]];
        if let Some(period) = self.period {
            // Of several cycles one has all places.
            to = to.min(from + period);
        } else {
            if from < whole[0] || to > whole[1] {
                widen(&mut slopes, [0.0; 2]);
            }
            [from, to] = [from, to].map(|at| at.clamp(whole[0], whole[1]));
        }
        let mut shift = self.period.map_or(0.0, |period| ((from - whole[0]) / period).floor() * period);
        let first = self.ends.partition_point(|end| end + shift <= from).clamp(1, self.parts.len()) - 1;
        for index in (first..self.parts.len()).chain(0..self.parts.len()) {
            let (part, [low, high]) =
                (&self.parts[index], [index, index + 1].map(|end| self.ends[end] + shift));
            let inside = [from, to].map(|at| ((at - low) / (high - low)).clamp(0.0, 1.0));
            widen(&mut places, part.within(inside).bounds());
            widen(&mut slopes, part.derivative(high - low).within(inside).bounds());
            if high >= to {
                break;
            }
            if index + 1 == self.parts.len() {
                shift += self.period.unwrap_or_default();
            }
        }
        clamped(places, slopes)
    }
}

/// Bounds of nothing.
const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

fn widen(bounds: &mut [f64; 2], [low, high]: [f64; 2]) {
    *bounds = [bounds[0].min(low), bounds[1].max(high)];
}

/// The places that lie on the stroke; those beyond its ends stay at them.
fn clamped(places: [f64; 2], mut slopes: [f64; 2]) -> [[f64; 2]; 2] {
    if places[0] < 0.0 || places[1] > 1.0 {
        widen(&mut slopes, [0.0; 2]);
    }
    [places.map(|place| place.clamp(0.0, 1.0)), slopes]
}

/// The polynomial with a value and two derivatives at each end of an interval (Hermite).
fn joined([a, b]: [[f64; 3]; 2], length: f64) -> Bernstein<6> {
    let side = |[value, first, second]: [f64; 3], length: f64| {
        let next = value + length * first / 5.0;
        [value, next, 2.0 * next - value + length * length * second / 20.0]
    };
    let ([c0, c1, c2], [c5, c4, c3]) = (side(a, length), side(b, -length));
    Bernstein([c0, c1, c2, c3, c4, c5])
}
