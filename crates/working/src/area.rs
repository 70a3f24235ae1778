//! The area under the graph of a moment of the scene.

use assur_mechanism::{LawTable, LinkId, LoadId, LoadKind, Mechanism, Over, Value};

/// Straight lines, each from a coordinate and a moment to a coordinate and a moment.
pub(crate) type Area = Vec<[[f64; 2]; 2]>;

/// Most lines: more of them are too many to be added up by hand.
const MOST: usize = 12;

/// The lines of a moment of the scene between two coordinates; `None` where it is no constant, no brake and no table over the
/// coordinate, does not act on the input link as a moment, or has very many lines.
pub(crate) fn area_under(mechanism: &Mechanism, load: LoadId, [from, to]: [f64; 2]) -> Option<Area> {
    let found = match &mechanism.loads.get(load)?.kind {
        LoadKind::Moment(found) if found.against_motion => {
            return braking(mechanism, found.link, (&found.value, 1.0), [from, to]);
        }
        LoadKind::Moment(found) => found,
        LoadKind::Brake(brake) => {
            let law = (&brake.force, brake.moment_of_unit_force());
            return braking(mechanism, brake.link, law, [from, to]);
        }
        _ => return None,
    };
    if Some(found.link) != mechanism.input.crank() || !mechanism.input.is_angle() {
        return None;
    }
    match &found.value {
        Value::Constant(value) => Some(vec![[[from, *value], [to, *value]]]),
        Value::Table { over: Over::Coordinate, table, repeat } => {
            let period = if *repeat { mechanism.input.period() } else { None };
            lines(table, period, [from, to])
        }
        _ => None,
    }
}

/// A constant moment against the motion, from its law and its moment where the law gives 1.
fn braking(
    mechanism: &Mechanism,
    link: LinkId,
    (law, unit): (&Value, f64),
    [from, to]: [f64; 2],
) -> Option<Area> {
    let Value::Constant(value) = law else { return None };
    if Some(link) != mechanism.input.crank() || !mechanism.input.is_angle() {
        return None;
    }
    let moment = -unit * value * (to - from).signum();
    Some(vec![[[from, moment], [to, moment]]])
}

fn lines(table: &LawTable, period: Option<f64>, [from, to]: [f64; 2]) -> Option<Area> {
    let [low, high] = [from.min(to), from.max(to)];
    let first = table.rows.first()?[0];
    // Whole cycles from the one of the rows.
    let cycles = period
        .map_or([0.0; 2], |period| [((low - first) / period).floor(), ((high - first) / period).ceil()]);
    let mut ends = vec![low, high];
    let mut cycle = cycles[0];
    while cycle <= cycles[1] {
        let shift = period.map_or(0.0, |period| cycle * period);
        let inside = |at: &f64| *at > low + 1e-12 && *at < high - 1e-12;
        ends.extend(table.rows.iter().map(|row| row[0] + shift).filter(inside));
        if ends.len() > 2 + MOST {
            return None;
        }
        cycle += 1.0;
    }
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|one, other| (*one - *other).abs() < 1e-12);
    let mut lines: Area =
        ends.windows(2).map(|pair| line(table, period, first, [pair[0], pair[1]])).collect();
    if to < from {
        lines.reverse();
        for line in &mut lines {
            line.reverse();
        }
    }
    Some(lines)
}

/// The line between two neighboring ends.
fn line(table: &LawTable, period: Option<f64>, first: f64, ends: [f64; 2]) -> [[f64; 2]; 2] {
    let middle = f64::midpoint(ends[0], ends[1]);
    let shift = period.map_or(0.0, |period| ((middle - first) / period).floor() * period);
    let segment = table.segment(middle - shift);
    ends.map(|end| [end, table.at_segment(segment, end - shift)])
}
