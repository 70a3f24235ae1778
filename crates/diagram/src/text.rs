//! Tables: pure functions from data to text, ASCII but for names of the scene.

use std::fmt::Write;

use assur_geometry::{Center, CenterAt};

use crate::plan::length;
use crate::{JointForce, Plan, Sheet, Split};

/// A number below this part of the greatest in its column counts as zero.
const ROUNDING: f64 = 1e-13;

/// A plan as a table: name, length and direction of every vector, its start, its meaning; then the points.
pub fn text(plan: &Plan) -> String {
    let mut out = String::new();
    line(&mut out, &plan.title);
    let scale =
        if plan.scale > 0.0 { format!(", 1 mm = {} {}", plan.scale, plan.unit) } else { String::new() };
    line(&mut out, &format!("unit {}{scale}; residual {:.1e}", plan.unit, plan.residual));
    let head = ["vector", "size", "unit", "deg", "from x", "from y", "meaning"].map(str::to_owned);
    let ends = plan.items.iter().flat_map(|item| [item.start, item.end]);
    let number = beside(ends.chain(plan.points.iter().map(|point| point.at)).flatten());
    let rows = plan.items.iter().map(|item| {
        let vector = [item.end[0] - item.start[0], item.end[1] - item.start[1]];
        let [x, y] = item.start;
        let size = beside(plan.items.iter().filter(|one| one.unit == item.unit).map(|one| one.size));
        [
            item.name.clone(),
            size(item.size),
            item.unit.clone(),
            if size(item.size) == "0" { "-".to_owned() } else { degrees(vector) },
            number(x),
            number(y),
            item.note.clone(),
        ]
    });
    table(&mut out, head, rows.collect());
    let points =
        plan.points.iter().map(|point| [point.name.clone(), number(point.at[0]), number(point.at[1])]);
    table(&mut out, ["point", "x", "y"].map(str::to_owned), points.collect());
    out
}

/// All plans of a position, one table after the other.
pub fn sheet_text(sheet: &Sheet) -> String {
    let plans = [&sheet.velocities, &sheet.accelerations].into_iter();
    let plans = plans.chain(&sheet.polygons).chain(&sheet.constructions);
    let mut tables: Vec<String> = plans.map(text).collect();
    tables.insert(2, centers_text(&sheet.centers));
    tables.extend(sheet.by_cause.as_ref().map(split_text));
    tables.join("\n")
}

fn centers_text(centers: &[Center]) -> String {
    let mut out = String::new();
    line(&mut out, "Instant centers (m)");
    let places = centers.iter().filter_map(|center| match center.at {
        CenterAt::Point(place) => Some(place),
        _ => None,
    });
    let (number, unit) = (beside(places.flatten()), beside([1.0]));
    let rows = centers.iter().map(|center| {
        let (x, y, note) = match center.at {
            CenterAt::Point([x, y]) => (number(x), number(y), ""),
            CenterAt::Direction([x, y]) => (unit(x), unit(y), "at infinity, in this direction"),
            CenterAt::Everywhere => ("-".to_owned(), "-".to_owned(), "no motion against each other"),
        };
        [center.link.clone(), center.against.clone(), x, y, note.to_owned()]
    });
    table(&mut out, ["link", "against", "x", "y", ""].map(str::to_owned), rows.collect());
    out
}

/// Reactions by cause as a table: one row for each joint and link, one block for each cause.
fn split_text(split: &Split) -> String {
    let mut out = String::new();
    line(
        &mut out,
        &format!("Reactions by cause (N); the shares sum to the whole up to {:.1e}", split.residual),
    );
    let shares = || split.shares.iter().chain([&split.whole]);
    let forces = || shares().flat_map(|share| &share.reactions);
    let number = beside(forces().flat_map(|reaction| reaction.force));
    let balancing = beside(shares().map(|share| share.balancing));
    let mut rows: Vec<[String; 6]> = Vec::new();
    for share in shares() {
        rows.extend(share.reactions.iter().map(|reaction| row(&share.cause, reaction, &number)));
        let dash = || "-".to_owned();
        rows.push([
            share.cause.clone(),
            "balancing".to_owned(),
            dash(),
            dash(),
            dash(),
            balancing(share.balancing),
        ]);
    }
    let head = ["cause", "joint", "on", "fx", "fy", "size"].map(str::to_owned);
    table(&mut out, head, rows);
    out
}

fn row(cause: &str, reaction: &JointForce, number: &impl Fn(f64) -> String) -> [String; 6] {
    let [fx, fy] = reaction.force;
    let size = number(length(reaction.force));
    [cause.to_owned(), reaction.joint.clone(), reaction.on.clone(), number(fx), number(fy), size]
}

fn line(out: &mut String, words: &str) {
    out.push_str(words);
    out.push('\n');
}

/// Columns as wide as their longest entry; the last one is not padded.
fn table<const N: usize>(out: &mut String, head: [String; N], rows: Vec<[String; N]>) {
    if rows.is_empty() {
        return;
    }
    let rows: Vec<[String; N]> = std::iter::once(head).chain(rows).collect();
    let mut width = [0; N];
    for row in &rows {
        for (width, entry) in width.iter_mut().zip(row) {
            *width = (*width).max(entry.chars().count());
        }
    }
    for row in &rows {
        let mut text = String::new();
        for (entry, width) in row.iter().zip(width) {
            let _ = write!(text, "  {entry:<width$}");
        }
        line(out, text.trim_end());
    }
}

/// Direction of a vector, degrees in (-180, 180]; a dash for none.
fn degrees([x, y]: [f64; 2]) -> String {
    if x == 0.0 && y == 0.0 {
        return "-".to_owned();
    }
    match format!("{:.4}", y.atan2(x).to_degrees()).as_str() {
        "-0.0000" => "0.0000".to_owned(),
        "-180.0000" => "180.0000".to_owned(),
        degrees => degrees.to_owned(),
    }
}

/// Formats the numbers of a column: one that is rounding compared to the greatest is zero.
fn beside(all: impl IntoIterator<Item = f64>) -> impl Fn(f64) -> String {
    let greatest = all.into_iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    move |value| if value.abs() <= ROUNDING * greatest { "0".to_owned() } else { seven(value) }
}

/// Seven significant digits.
fn seven(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    // The exponent of the rounded number: 0.99999999 is 1.
    let scientific = format!("{value:.6e}");
    match scientific.rsplit_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok()) {
        Some(exponent @ -4..=6) => {
            let places = usize::try_from(6 - exponent).unwrap_or(0);
            format!("{value:.places$}")
        }
        _ => scientific,
    }
}
