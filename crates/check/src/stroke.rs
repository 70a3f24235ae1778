//! Sizes of loads, computed independently: tables, and the stroke of a point from its places alone.

use assur_force::LoadState;
use assur_formula::{Branches, Formula, Sign, Variables};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_mechanism::{LawTable, Over, Place, Value};
use assur_number::search::try_least;

/// Least and greatest place of a point along an axis, m.
pub(crate) type Extremes = [f64; 2];

/// Number of places of the cycle between which the extremes are bracketed.
const GRID: usize = 720;

/// Number of golden-section steps: 0.618^40 of two cells is some 1e-10 of the cycle; the error of the place at an
/// extreme is then the square of that.
const SECTIONS: usize = 40;

/// Distance from a coordinate without a position at which there may be one, as part of the cycle: the error of an extreme
/// there is its square.
const BESIDE: f64 = 1e-9;

/// Tolerance of an argument, relative to itself, to the period, or to 1 rad, m or s: rounding of coordinates and of the
/// extremes. It is wider than the rounding that the compiled loads allow, so a place on a jump there is on a jump here.
const ROUNDING: f64 = 1e-11;

/// The variables on which the size of a load may depend.
pub(crate) struct At<'a> {
    pub(crate) state: &'a LoadState,
    /// Place of the load's point, m, and its PF1.
    pub(crate) point: [f64; 2],
    pub(crate) pf1: [f64; 2],
    pub(crate) extremes: Option<Extremes>,
    /// +1 or -1: direction of the motion.
    pub(crate) sense: f64,
    pub(crate) period: Option<f64>,
    /// A length of the mechanism, m.
    pub(crate) scale: f64,
}

/// The possible sizes of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sizes {
    /// The least and the greatest: one number, an interval from rounding, or both sides of a jump.
    pub(crate) range: [f64; 2],
    /// The size of the terms of a formula, in which it has a rounding unit: where they cancel, more than its value.
    pub(crate) terms: f64,
}

impl Sizes {
    /// With those of another case.
    pub(crate) fn and(self, other: Self) -> Self {
        let [one, two] = [self.range, other.range];
        Self { range: [one[0].min(two[0]), one[1].max(two[1])], terms: self.terms.max(other.terms) }
    }
}

/// The possible sizes of a load, and of its terms.
pub(crate) fn sizes(value: &Value, at: &At<'_>) -> Sizes {
    let range = match value {
        Value::Constant(size) => [*size; 2],
        Value::Table { over, table, repeat } => {
            let period = at.period.filter(|_| *repeat);
            let x = match over {
                Over::Coordinate => at.state.coordinate,
                Over::Time => at.state.time,
                Over::Speed => at.state.speed,
            };
            let tolerance = ROUNDING * x.abs().max(period.unwrap_or(1.0));
            around(table, x, tolerance, period)
        }
        Value::Stroke { axis, forward, back } => on_stroke(*axis, [forward, back], at),
        Value::Formula { formula, factor, axis } => return by_formula(formula, *factor, *axis, at),
    };
    Sizes { range, terms: 0.0 }
}

/// The value of a law over the coordinate at exactly this one, after a jump; not a number of a law over something else.
pub(crate) fn over_coordinate(value: &Value, coordinate: f64, period: Option<f64>) -> f64 {
    match value {
        Value::Constant(size) => *size,
        Value::Table { over: Over::Coordinate, table, repeat } => {
            table.at(within(table, coordinate, period.filter(|_| *repeat)))
        }
        Value::Formula { formula, factor, axis: None } => {
            factor * formula.value(&Variables { coordinate, ..Variables::default() })
        }
        Value::Table { .. } | Value::Formula { .. } | Value::Stroke { .. } => f64::NAN,
    }
}

/// An argument of a table in the cycle that begins with its first row.
fn within(table: &LawTable, x: f64, period: Option<f64>) -> f64 {
    let first = table.rows.first().map_or(0.0, |row| row[0]);
    period.map_or(x, |period| first + (x - first).rem_euclid(period))
}

/// The values of a formula within rounding of its variables, on either side of the jumps that lie there.
fn by_formula(formula: &Formula, factor: f64, axis: Option<f64>, at: &At<'_>) -> Sizes {
    let LoadState { coordinate, speed, time, .. } = *at.state;
    let (place, width) = match (axis, at.extremes) {
        (Some(axis), Some([low, high])) => {
            let (s, c) = axis.sin_cos();
            let share = (c * at.point[0] + s * at.point[1] - low) / (high - low);
            (share.clamp(0.0, 1.0), ROUNDING * (at.scale / (high - low)).max(1.0))
        }
        _ => (0.0, 0.0),
    };
    let width_of = |value: f64, least: f64| (ROUNDING * value.abs().max(least)).max(f64::MIN_POSITIVE);
    let around = |used: bool, value: f64, off: f64| {
        if used { vec![value - off, value, value + off] } else { vec![value] }
    };
    let used = formula.used();
    let coordinates = around(used.coordinate, coordinate, width_of(coordinate, at.period.unwrap_or(1.0)));
    let speeds = around(used.speed, speed, width_of(speed, f64::MIN_POSITIVE));
    let times = around(used.time, time, width_of(time, 1.0));
    let places = around(used.place, place, width);
    let mut near = Vec::new();
    for &coordinate in &coordinates {
        for &speed in &speeds {
            for &time in &times {
                near.extend(places.iter().map(|place| {
                    let place = place.clamp(0.0, 1.0);
                    Variables { coordinate, speed, time, place }
                }));
            }
        }
    }
    // Each side of a jump that lies nearby may hold at each place nearby.
    let mut sides: Vec<Branches> = Vec::new();
    for at in &near {
        for side in all_sides(formula, at) {
            if !sides.contains(&side) {
                sides.push(side);
            }
        }
    }
    let values = sides.iter().flat_map(|side| near.iter().map(|at| factor * formula.value_on(at, *side)));
    let range = values
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)]);
    let exact = Variables { coordinate, speed, time, place };
    let terms = factor.abs() * formula.rounding(&exact, Branches::default()) / f64::EPSILON;
    // At a pole there is no bound, and no value either.
    Sizes { range, terms: if terms.is_finite() { terms } else { 0.0 } }
}

/// Up to this many jumps at one place, all combinations of their sides are tried.
const TOGETHER: usize = 4;

/// The sides of all jumps of a formula at a place; of those whose arguments are zero within their rounding, every side.
fn all_sides(formula: &Formula, at: &Variables) -> Vec<Branches> {
    let (known, undecided) = formula.jumps_at(at);
    let jumps = (0..formula.switches().len()).filter(|jump| undecided >> jump & 1 == 1).take(TOGETHER);
    let mut all = vec![known];
    for jump in jumps {
        let with = |branches: &Branches| {
            [Sign::Negative, Sign::Zero, Sign::Positive].map(|side| {
                let mut branches = *branches;
                branches.set(jump, side);
                branches
            })
        };
        all = all.iter().flat_map(with).collect();
    }
    all
}

fn on_stroke(axis: f64, [forward, back]: [&LawTable; 2], at: &At<'_>) -> [f64; 2] {
    let Some([low, high]) = at.extremes else { return [f64::NAN; 2] };
    let (s, c) = axis.sin_cos();
    let share = ((c * at.point[0] + s * at.point[1] - low) / (high - low)).clamp(0.0, 1.0);
    let rate = at.sense * (c * at.pf1[0] + s * at.pf1[1]);
    let tolerance = ROUNDING * (at.scale / (high - low)).max(1.0);
    let (one, two) = (around(forward, share, tolerance, None), around(back, share, tolerance, None));
    // At a reversal either table is possible.
    let turning = 1e-7 * (high - low);
    if rate > turning {
        one
    } else if rate < -turning {
        two
    } else {
        [one[0].min(two[0]), one[1].max(two[1])]
    }
}

/// Least and greatest value of a table within a tolerance of the argument. Near a row, the formulas of both sides count,
/// continued by the tolerance: at a jump both values, at a steep line what it gains over the rounding of the argument.
fn around(table: &LawTable, x: f64, tolerance: f64, period: Option<f64>) -> [f64; 2] {
    let place = |x: f64| within(table, x, period);
    let apart = |row: f64| {
        let distance = (row - place(x)).abs();
        period.map_or(distance, |period| distance.min((period - distance).abs()))
    };
    let beside = [x - tolerance, x, x + tolerance].map(|x| table.at(place(x)));
    let near = table.rows.iter().enumerate().filter(|(_, row)| apart(row[0]) <= tolerance);
    let at_rows = near.flat_map(|(index, [row, _])| {
        // The argument is at most one tolerance from the row, and rounded by another.
        let ends = [row - 2.0 * tolerance, row + 2.0 * tolerance];
        [index, index + 1].into_iter().flat_map(move |segment| ends.map(|x| table.at_segment(segment, x)))
    });
    // Between the two rows of a jump there is no formula.
    let at_rows = at_rows.filter(|value| value.is_finite());
    beside
        .into_iter()
        .chain(at_rows)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// Extremes of a place along an axis over the cycle; where the mechanism can't run through the whole cycle, over the
/// range.
pub(crate) fn extremes(linkage: &Linkage, place: Place, axis: f64) -> Option<Extremes> {
    let input = &linkage.mechanism.input;
    let turns = input.period().filter(|_| input.turns_wholly());
    let cycle = turns.and_then(|turns| over(linkage, place, axis, [input.from, input.from + turns]));
    cycle.or_else(|| over(linkage, place, axis, input.ends()))
}

fn over(linkage: &Linkage, place: Place, axis: f64, [one, other]: [f64; 2]) -> Option<Extremes> {
    let (from, to) = (one.min(other), one.max(other));
    let mut position = linkage.position();
    let (s, c) = axis.sin_cos();
    let mut along = |q: f64| {
        // Guides may be parallel, and another link at infinity, in one place of the cycle.
        let beside = q + BESIDE * (to - from);
        let mut solve = |q| linkage.solve(q, Order::Place, &mut position);
        solve(q).or_else(|_| solve(beside)).ok()?;
        let [x, y] = linkage.place_motion(place, &position).pf0;
        Some(c * x + s * y)
    };
    let at = |i: usize| from + (to - from) * (i as f64 / GRID as f64);
    let places = (0..=GRID).map(|i| along(at(i))).collect::<Option<Vec<_>>>()?;
    let mut found = [f64::INFINITY, f64::NEG_INFINITY];
    for i in 0..=GRID {
        let ends = [at(i.saturating_sub(1)), at((i + 1).min(GRID))];
        let near = [places[i.saturating_sub(1)], places[(i + 1).min(GRID)]];
        for (k, sign) in [(0, -1.0), (1, 1.0)] {
            if near.iter().all(|other| sign * places[i] >= sign * other) {
                let (_, least) =
                    try_least(ends[0], ends[1], SECTIONS, |q| along(q).map(|x| -sign * x).ok_or(())).ok()?;
                // At an end of the range the extreme may lie on the grid.
                let least = least.min(-sign * places[i]);
                found[k] = if k == 0 { found[k].min(least) } else { found[k].max(-least) };
            }
        }
    }
    Some(found)
}

#[cfg(test)]
mod tests;
