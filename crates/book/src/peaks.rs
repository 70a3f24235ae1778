//! Values of greatest modulus over the positions and between them.

use assur_analysis::Calculation;
use assur_analysis::results::{Column, Edges, Owner, Part, Peaks, Quantity, Schema, Table, Turn};
use assur_mechanism::GROUND;

use crate::Course;

/// Extremes of a curve that are not farther from the greatest one than this part of it may be the greatest.
const NEAR: f64 = 0.02;

/// The greatest values of a calculation, found between its positions too; `edges`: what lies between them.
pub fn peaks(calculation: &Calculation, positions: &Table, edges: &Edges) -> Peaks {
    let schema = positions.schema();
    let farthest = |read: &dyn Fn(&Table, usize) -> Option<f64>| {
        let course = Course::read(positions, Some(edges), Column::COORDINATE, read);
        farthest(calculation, &course, read)
    };
    let of_column = |column: Column| Some((column, farthest(&|table, row| table.get(row, column))?));
    let speed = Column::of(Quantity::Velocity, Owner::Input);
    let power = |table: &Table, row: usize| Some(table.get(row, Column::BALANCING)? * table.get(row, speed)?);
    let balancing = schema.find(Column::BALANCING).is_some();
    Peaks {
        farthest: columns(schema).into_iter().filter_map(of_column).collect(),
        power: farthest(&power).filter(|_| balancing),
        balancing: if balancing { mean_balancing(calculation, positions, edges) } else { None },
    }
}

/// The quantities whose greatest values are asked for: the reaction of each pair on the first link of two that moves, moments of guides, speeds and
/// the balancing load.
fn columns(schema: &Schema) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    let owners = schema.owners(Quantity::Force);
    let on = |pair| {
        owners.iter().filter(move |owner| matches!(owner, Owner::PairOn(of, _) if *of == pair)).count()
    };
    for owner in &owners {
        let Owner::PairOn(pair, link) = *owner else { continue };
        let known = |column: &Column| matches!(column.owner, Owner::PairOn(of, _) if of == pair);
        if on(pair) > 2 || link != GROUND && !columns.iter().any(known) {
            columns.push(Column::of(Quantity::Force, *owner).part(Part::Modulus));
        }
    }
    columns
        .extend(schema.owners(Quantity::Moment).into_iter().map(|owner| Column::of(Quantity::Moment, owner)));
    let speeds = schema.owners(Quantity::Velocity).into_iter();
    let speeds = speeds.filter(|owner| matches!(owner, Owner::Slide(_) | Owner::Link(_)));
    columns.extend(speeds.map(|owner| Column::of(Quantity::Velocity, owner)));
    columns.extend(schema.find(Column::BALANCING).map(|_| Column::BALANCING));
    columns
}

/// The value of greatest modulus; of a constant its first one.
fn farthest(
    calculation: &Calculation,
    course: &Course,
    read: &dyn Fn(&Table, usize) -> Option<f64>,
) -> Option<Turn> {
    let turns = course.turns();
    let most = turns.iter().fold(0.0_f64, |most, turn| most.max(turn.value.abs()));
    let near: Vec<Turn> = turns.into_iter().filter(|turn| turn.value.abs() >= (1.0 - NEAR) * most).collect();
    let found = calculation.refined(&near, read);
    let found = Turn::statistic(&found).farthest().map(|best| found[best.number]);
    let first = || course.nodes().first().map(|node| Turn::at(node.at, node.value));
    found.or_else(first)
}

/// A mean below this part of the root mean square has no correct digit: some rounding units.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Mean and root mean square over the cycle; a part of a cycle has no mean of this kind.
fn mean_balancing(calculation: &Calculation, positions: &Table, edges: &Edges) -> Option<[f64; 2]> {
    let input = &calculation.linkage.mechanism.input;
    if !input.is_cycle() {
        return None;
    }
    let course = Course::of(positions, Some(edges), Column::COORDINATE, Column::BALANCING);
    let jumps: Vec<f64> = course.jumps().map(|jump| jump.at).collect();
    let ends = [0, input.positions].map(|index| input.coordinate(index));
    let [mean, rms] = calculation.means(ends, &jumps, |table, row| table.get(row, Column::BALANCING))?;
    // What is left of a mean of zero is rounding.
    Some([if mean.abs() <= ROUNDING * rms { 0.0 } else { mean }, rms])
}
