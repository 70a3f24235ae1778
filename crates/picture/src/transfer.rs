//! The series of a linkage: coordinate, then PF0, PF1, PF2 of points, links and slides.

use std::sync::Arc;

use assur_analysis::results::{Column, Edges, Owner, Quantity, Schema, Table};
use assur_analysis::{AnalysisError, Calculation, Options, plan, unwatched};
use assur_book::catalogue;
use assur_book::{Course, Node};
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, PointId};

use crate::{Series, Transfer};

/// A value this small compared with the size of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// All series, and which of them belong together.
pub(crate) fn series(linkage: &Linkage, table: &Table, edges: &Edges) -> (Vec<Series>, Vec<Transfer>) {
    let (mechanism, schema) = (&linkage.mechanism, Schema::new(&linkage.mechanism));
    let node = |number| {
        let at = mechanism.input.coordinate(number);
        Node { number, at, value: at }
    };
    // Positions that can't be assembled have a coordinate too.
    let count = mechanism.input.positions;
    let end = (!edges.ending.is_empty()).then(|| node(count));
    let course = Course::from_nodes((0..count).map(node), end);
    let mut series = vec![Series::of(&schema, Column::COORDINATE, course, 0.0)];
    let mut transfers = Vec::new();
    let moves = |id: &PointId| mechanism.points[*id].places.iter().all(|place| place.link != GROUND);
    let points = (0..mechanism.points.len()).filter(moves).map(Owner::Point);
    let points = points.flat_map(|owner| Column::vector(Quantity::Transfer(0), owner));
    let links = (1..mechanism.links.len()).map(Owner::Link);
    let others = links.chain((0..mechanism.slides.len()).map(Owner::Slide));
    for place in points.chain(others.map(|owner| Column::of(Quantity::Transfer(0), owner))) {
        // Angles are of the order of 1; lengths of that of the mechanism.
        let size = if let Owner::Link(_) = place.owner { 1.0 } else { linkage.structure.scale };
        let first = series.len();
        series.extend((0..=2).map(|order| {
            let column = Column { quantity: Quantity::Transfer(order), ..place };
            let course = Course::of(table, Some(edges), Column::COORDINATE, column);
            Series::of(&schema, column, course, ROUNDING * size)
        }));
        let name = catalogue::subject(&schema, place);
        transfers.push(Transfer { name, owner: place.owner, orders: [first, first + 1, first + 2] });
    }
    (series, transfers)
}

/// The transfer functions of the positions and of what is drawn between and after them, whatever the scene requests and however it
/// is loaded.
pub(crate) fn positions(linkage: &Linkage) -> Result<(Table, Edges), AnalysisError> {
    let mut bare = linkage.clone();
    let mechanism = &mut bare.mechanism;
    (mechanism.motion, mechanism.drive) = (None, None);
    mechanism.loads.clear();
    mechanism.frictions.clear();
    let options = Options { whole: true, ..Options::default() };
    let mut plan = plan(mechanism, &bare.structure, &options);
    plan.reduction = false;
    let calculation = Calculation::planned(Arc::new(bare), plan, None, &options, &mut unwatched)?;
    let table = calculation.analyze(&mut unwatched)?.positions;
    let edges = calculation.edges(&table);
    Ok((table, edges))
}
