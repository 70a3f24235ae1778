//! What is found from the rows of the results: columns as they are; where a sweep asks for it, extremes and means between positions.

use assur_analysis::results::{Column, Edges, Owner, Part, Quantity, Table, Turn};
use assur_analysis::{Calculation, unwatched};
use assur_book::{Course, Range, Read, range, range_of};
use assur_geometry::overview;

use crate::Sweep;
use crate::measured::{Gathered, Measured, ends};

/// Adds what is found from the rows of the results: between the positions too, where the sweep asks for that, or of the columns
/// that are measured as they are.
pub(crate) fn add_rows(found: &mut Measured, calculation: &Calculation, sweep: &Sweep) {
    let gathered = &sweep.layout.gathered;
    if !sweep.between && !gathered.iter().any(|of| matches!(of, Gathered::Plain(_))) {
        return;
    }
    let Ok(table) = calculation.rows(&mut unwatched) else { return };
    if sweep.between {
        let edges = calculation.edges(&table);
        found.ranges = gathered.iter().map(|of| between(calculation, &table, &edges, of)).collect();
        return;
    }
    for (statistic, of) in found.statistics.iter_mut().zip(gathered) {
        let Gathered::Plain(column) = of else { continue };
        let values = table.schema().find(*column).into_iter().flat_map(|column| table.each(column));
        let numbered = table.numbers().iter().zip(values);
        *statistic = numbered.filter_map(|(number, value)| Some((*number, value?))).collect();
    }
}

/// Extremes and means over the positions and between them, as a report has them.
fn between(calculation: &Calculation, table: &Table, edges: &Edges, of: &Gathered) -> Option<Range> {
    let read_range = |read: &Read<'_>| {
        range_of(calculation, &Course::read(table, Some(edges), Column::COORDINATE, read), read)
    };
    let size = |column| read_range(&|table, row| table.get(row, column).map(f64::abs));
    match of {
        Gathered::Health => {
            let groups = table.schema().owners(Quantity::Condition).into_iter();
            let conditions: Vec<_> = groups.map(|group| Column::of(Quantity::Condition, group)).collect();
            // A group without a condition number is singular.
            read_range(&|table, row| {
                let each = conditions.iter().map(|of| table.get(row, *of).map_or(0.0, |of| 1.0 / of));
                each.reduce(f64::min)
            })
        }
        Gathered::Transmission => {
            let (_, angle, at) = overview(&calculation.linkage).ok()?.transmission?;
            let least = Turn::at(at, angle);
            Some(Range { greatest: least, least, means: None })
        }
        Gathered::Force(joint) => {
            let force = |link| Column::of(Quantity::Force, Owner::PairOn(joint.id, link)).part(Part::Modulus);
            let forces: Vec<_> = joint.links[..ends(joint)].iter().map(|link| force(*link)).collect();
            read_range(&|table, row| forces.iter().filter_map(|of| table.get(row, *of)).reduce(f64::max))
        }
        Gathered::BalancingSize(of) => size(*of),
        Gathered::Moment(joint) => size(Column::of(Quantity::Moment, Owner::Pair(joint.id))),
        Gathered::Column(of) | Gathered::Plain(of) => {
            let course = Course::of(table, Some(edges), Column::COORDINATE, *of);
            range(calculation, &course, *of)
        }
    }
}
