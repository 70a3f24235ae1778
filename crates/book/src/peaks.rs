//! Values of greatest magnitude over the positions and between them.

use assur_analysis::Calculation;
use assur_analysis::results::{
    Column, Edges, Extreme, Means, Owner, Part, Peaks, Quantity, Schema, Statistic, Table, Turn,
};
use assur_kinematics::continuous_angle;
use assur_number::ROUNDING;

use crate::{Course, catalogue::reactions};

/// Extremes at the positions within this fraction of the greatest one are refined between them; no other can be the greatest.
const NEAR: f64 = 0.02;

/// What reads a number from a row.
pub type Read<'a> = dyn Fn(&Table, usize) -> Option<f64> + 'a;

/// The greatest values of a calculation, found between its positions too; `edges`: what lies between them.
pub fn peaks(calculation: &Calculation, positions: &Table, edges: &Edges) -> Peaks {
    let schema = positions.schema();
    let farthest = |read: &Read<'_>| {
        let course = Course::read(positions, Some(edges), Column::COORDINATE, read);
        most(calculation, &course, read, Statistic::farthest)
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

/// The quantities whose greatest values are asked for: the reactions that are shown, moments of guides, speeds and the balancing load.
fn columns(schema: &Schema) -> Vec<Column> {
    let force = |(pair, link)| Column::of(Quantity::Force, Owner::PairOn(pair, link)).part(Part::Modulus);
    let mut columns: Vec<Column> = reactions(schema).into_iter().map(force).collect();
    columns
        .extend(schema.owners(Quantity::Moment).into_iter().map(|owner| Column::of(Quantity::Moment, owner)));
    let speeds = schema.owners(Quantity::Velocity).into_iter();
    let speeds = speeds.filter(|owner| matches!(owner, Owner::Slide(_) | Owner::Link(_)));
    columns.extend(speeds.map(|owner| Column::of(Quantity::Velocity, owner)));
    let loads = schema.owners(Quantity::Balancing).into_iter();
    columns.extend(loads.map(|owner| Column::of(Quantity::Balancing, owner)));
    columns
}

/// The extreme of a course that `pick` chooses, refined between the positions; infinite where it grows without limit beside places
/// without a value. Of a constant the first position counts.
fn most(
    calculation: &Calculation,
    course: &Course,
    read: &Read<'_>,
    pick: fn(&Statistic) -> Option<Extreme>,
) -> Option<Turn> {
    let turns = course.turns();
    let best = pick(&Turn::statistic(&turns)).map_or(0.0, |best| best.value.abs());
    let far = NEAR * course.size().max(best);
    let near: Vec<Turn> = turns.into_iter().filter(|turn| (turn.value.abs() - best).abs() <= far).collect();
    let mut found = calculation.refined(&near, read);
    found.extend(calculation.unlimited(&course.ends(), read));
    let found = picked(&found, pick);
    // Positions that stand alone among those without a value are no extremes of a curve.
    let nodes: Vec<Turn> = course.nodes().iter().map(|node| Turn::at(node.at, node.value)).collect();
    let node = picked(&nodes, pick);
    let (Some(one), Some(other)) = (found, node) else { return found.or(node) };
    let is_above = (other.value - one.value).abs() > ROUNDING * other.value.abs();
    if is_above { picked(&[one, other], pick) } else { found }
}

/// The extreme that `pick` chooses of some.
fn picked(turns: &[Turn], pick: fn(&Statistic) -> Option<Extreme>) -> Option<Turn> {
    pick(&Turn::statistic(turns)).map(|best| turns[best.number])
}

/// What a quantity reaches over the positions and between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The greatest value.
    pub greatest: Turn,
    /// The least value.
    pub least: Turn,
    /// Means over the coordinate; `None` where there is no value somewhere.
    pub means: Option<Means>,
}

impl Range {
    /// What a course reaches; `None` where it has no value.
    pub fn of_course(course: &Course) -> Option<Self> {
        let [greatest, least] = course.highest_and_lowest()?.map(|[at, value]| Turn::at(at, value));
        Some(Self { greatest, least, means: None })
    }
}

/// What a quantity reaches, with its `course` over the positions; `None` where no position has a value.
pub fn range(calculation: &Calculation, course: &Course, column: Column) -> Option<Range> {
    range_of(calculation, course, &reader(course, column))
}

/// What reads a quantity from a row; an angle without jumps, as its course over the positions has it.
fn reader(course: &Course, column: Column) -> impl Fn(&Table, usize) -> Option<f64> {
    let is_angle = matches!((column.quantity, column.owner), (Quantity::Transfer(0), Owner::Link(_)));
    move |table, row| {
        let value = table.get(row, column)?;
        if !is_angle {
            return Some(value);
        }
        Some(continuous_angle(value, course.between(table.get(row, Column::COORDINATE)?)?))
    }
}

/// A local extreme of a quantity, with its `course` over the positions, as it is found between them; infinite where the quantity grows
/// without limit there.
pub fn extreme(calculation: &Calculation, course: &Course, column: Column, turn: Turn) -> Turn {
    let ends: Vec<_> =
        course.ends().into_iter().filter(|[known, _]| known.to_bits() == turn.at.to_bits()).collect();
    let unlimited = calculation.unlimited(&ends, reader(course, column)).first().copied();
    let refined = || calculation.refined(&[turn], reader(course, column)).first().copied();
    unlimited.or_else(refined).unwrap_or(turn)
}

/// What a number that is made of each row reaches, with its `course` over the positions; `None` where no position has a value.
pub fn range_of(calculation: &Calculation, course: &Course, read: &Read<'_>) -> Option<Range> {
    let greatest = most(calculation, course, read, Statistic::greatest)?;
    let least = most(calculation, course, read, Statistic::least)?;
    Some(Range { greatest, least, means: means(calculation, course, read) })
}

/// Means over the cycle or the part of it that is calculated.
fn means(calculation: &Calculation, course: &Course, read: &Read<'_>) -> Option<Means> {
    let input = &calculation.linkage.mechanism.input;
    let last = if input.is_cycle() { input.positions } else { input.positions.saturating_sub(1) };
    let size = course.highest_and_lowest()?.iter().fold(0.0_f64, |most, [_, value]| most.max(value.abs()));
    calculation.means([0, last].map(|index| input.coordinate(index)), size, read)
}

/// Means over the cycle; a part of a cycle has none of this kind.
fn mean_balancing(calculation: &Calculation, positions: &Table, edges: &Edges) -> Option<Means> {
    if !calculation.linkage.mechanism.input.is_cycle() {
        return None;
    }
    let course = Course::of(positions, Some(edges), Column::COORDINATE, Column::BALANCING);
    means(calculation, &course, &|table, row| table.get(row, Column::BALANCING))
}
