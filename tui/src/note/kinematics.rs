//! Kinematics: positions, plans, transfer functions, velocities and accelerations.

use assur_analysis::results::{Column, Owner, Part, Quantity, Table};
use assur_mechanism::GROUND;

use super::Context;
use super::document::Block;
use crate::number::digits;
use crate::screen::state::{Part as Shown, View};
use crate::words::Words;

/// Page of two mechanisms, of two plans, and of three curves, mm.
const MECHANISMS: [f64; 2] = [165.0, 100.0];
const PLANS: [f64; 2] = [165.0, 85.0];
const CURVES: [f64; 2] = [160.0, 130.0];
/// Digits of a number in a table.
const DIGITS: usize = 5;
/// What is this small beside the greatest number of its kind in the position is rounding.
const ROUNDING: f64 = 1e-12;

/// Heading, the mechanism and its plans in the chosen positions, tables of rates, curves of the last quantity.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let mut blocks = vec![Block::Heading(words.get("kinematics")), Block::Text(words.get("kinematics-text"))];
    let place = context.places();
    let mechanism = context.beside(View::Mechanism, |_| {});
    let caption = words.with("mechanism-at", &[("place", place.clone())]);
    blocks.extend(mechanism.map(|figure| Block::picture(figure, MECHANISMS, caption)));
    for (kind, id) in [(Shown::Velocities, "velocity-plan"), (Shown::Accelerations, "acceleration-plan")] {
        let caption = words.with(id, &[("place", place.clone())]);
        let figure = context.beside(View::Plans, |state| {
            state.parts.insert(View::Plans, kind);
        });
        blocks.extend(figure.map(|figure| Block::picture(figure, PLANS, caption)));
    }
    for &position in context.positions {
        blocks.extend(rates(context, position));
    }
    // The last quantity is that of the last slide, or of the last link: what the mechanism is for.
    let last = context.state.scene.as_ref().map_or(0, |scene| scene.transfers.len().saturating_sub(1));
    let curves = context.figure(View::Curves, context.positions[0], |state| state.chosen.transfer = last);
    blocks.extend(curves.map(|(figure, title)| {
        let caption = words.with("transfer-functions", &[("of", words.phrase(&title))]);
        Block::picture(figure, CURVES, caption)
    }));
    blocks
}

/// Tables of velocities and accelerations of the points and of the links in a position.
fn rates(context: &Context<'_>, position: usize) -> Vec<Block> {
    let (words, values) = (context.words, [("place", context.place(position))]);
    let (Some(scene), Some(found)) = (&context.state.scene, context.state.found()) else { return Vec::new() };
    let table = &found.analysis.positions;
    let Some(row) = table.row_of(position) else { return Vec::new() };
    let fixed = |point: usize| scene.linkage.mechanism.place_in(point, GROUND).is_some();
    let [v, a] = [Quantity::Velocity, Quantity::Acceleration];
    let owners = table.schema().owners(v);
    let of_points = owners.iter().filter(|owner| matches!(owner, Owner::Point(point) if !fixed(*point)));
    let of_links = owners.iter().filter(|owner| matches!(owner, Owner::Link(_)));
    let points = cells(words, table, row, of_points.copied(), &[v, a]);
    let links = cells(words, table, row, of_links.copied(), &[v, a]);
    let head = |id: &str, all: &[(&str, &str)]| -> Vec<String> {
        let quantities = all.iter().map(|(symbol, unit)| format!("{symbol}, {}", words.unit(unit)));
        std::iter::once(words.get(id)).chain(quantities).collect()
    };
    let (speed, acceleration) = ("m/s", "m/s2");
    let of_point = [
        ("v_{x}", speed),
        ("v_{y}", speed),
        ("v", speed),
        ("a_{x}", acceleration),
        ("a_{y}", acceleration),
        ("a", acceleration),
    ];
    let all = [
        ("velocities-of-points", head("point", &of_point), points),
        ("velocities-of-links", head("link", &[("ω", "rad/s"), ("ε", "rad/s2")]), links),
    ];
    let shown = all.into_iter().filter(|(.., rows)| !rows.is_empty());
    shown.map(|(id, head, rows)| Block::Table { caption: words.with(id, &values), head, rows }).collect()
}

/// A row for each owner: its name and the numbers of each quantity in a row of the results, of a vector its projections
/// and its modulus.
pub(super) fn cells(
    words: &Words,
    table: &Table,
    row: usize,
    owners: impl Iterator<Item = Owner>,
    quantities: &[Quantity],
) -> Vec<Vec<String>> {
    let numbers = |owner: Owner| {
        let of = |(index, quantity): (usize, &Quantity)| {
            let column = Column::of(*quantity, owner);
            let values = match vector(table, row, column) {
                Some([x, y]) => vec![x, y, x.hypot(y)],
                None => table.get(row, column).into_iter().collect(),
            };
            values.into_iter().map(move |value| (index, value))
        };
        (table.schema().name(owner).to_string(), quantities.iter().enumerate().flat_map(of).collect())
    };
    let rows: Vec<(String, Vec<(usize, f64)>)> = owners.map(numbers).collect();
    let greatest = |index: usize| {
        let all = rows.iter().flat_map(|(_, all)| all).filter(|(of, _)| *of == index);
        all.fold(0.0_f64, |most, (_, value)| most.max(value.abs()))
    };
    let limits: Vec<f64> = (0..quantities.len()).map(|index| ROUNDING * greatest(index)).collect();
    let row = |(name, all): &(String, Vec<(usize, f64)>)| {
        let shown = all.iter().map(|(index, value)| printed(words, *value, limits[*index]));
        std::iter::once(words.name(name)).chain(shown).collect()
    };
    rows.iter().map(row).collect()
}

/// A number of a table; 0 where it is below a limit, a dash where there is none.
pub(super) fn printed(words: &Words, value: f64, limit: f64) -> String {
    if value.abs() <= limit { "0".to_owned() } else { words.number(&digits(value, DIGITS)) }
}

/// Both projections of a vector in a row of the results.
fn vector(table: &Table, row: usize, column: Column) -> Option<[f64; 2]> {
    Some([table.get(row, column.part(Part::X))?, table.get(row, column.part(Part::Y))?])
}
