//! What is reported of a calculation, topic by topic: from the results to blocks of a document, which every form shows.

mod checks;
mod contact;
mod course;
mod drive;
mod events;
mod explain;
mod facts;
mod forces;
mod friction;
mod given;
mod measured;
mod motion;
mod plans;
mod regime;
mod shaking;
mod structure;

use std::cell::RefCell;

use assur_analysis::results::{Analysis, Column as Values, Owner, Quantity, Table};
use assur_book::{Column, Document, Group, Unit, catalogue};
use assur_kinematics::Linkage;
use assur_mechanism::{CoordinateKind, Mechanism};
use assur_words::{Text, name, text};

pub use checks::checks;
pub use drive::{advice, drive, flywheel_methods, flywheel_shaft, motor_facts};
pub use events::{Event, events, list_of_events};
pub use explain::explain;
pub use facts::{About, checks_fact, results, summary};
pub use forces::{balancing_at_positions, direction, force_heads, inertia_loads, reactions_at_positions};
pub use friction::friction_tables;
pub use given::{dimensions, loads_given, motion_given, task_text};
pub use measured::geometry;
pub use motion::{rates_of_links, rates_of_points};
pub use plans::plans;
pub use regime::{facts as regime_facts, iteration};
pub use shaking::shaking;
pub use structure::{groups, mobility, pairs, passive_part, study as structure_study};

use contact::contacts;
use course::{motion_over_time, no_motion};
use forces::{balancing, causes, loads, reactions, reduction};
use friction::friction;
use motion::{condition, positions, rates, shown_positions, transfer};
use regime::course as regime_over_cycle;

/// What the topics are made from.
#[derive(Debug)]
pub struct Source<'a> {
    analysis: &'a Analysis,
    linkage: &'a Linkage,
    mechanism: &'a Mechanism,
    /// Those that are shown of the positions.
    positions: Table,
    /// The quantities already reported by a topic.
    told: RefCell<Vec<Quantity>>,
    /// Whether the coordinate of the input is an angle.
    kind: CoordinateKind,
}

impl<'a> Source<'a> {
    /// A calculation, of which the tables show the positions of these numbers, `None` for all.
    pub fn of(analysis: &'a Analysis, linkage: &'a Linkage, positions: Option<&[usize]>) -> Self {
        let all = &analysis.positions;
        let positions =
            positions.map_or_else(|| all.clone(), |list| all.only(|number| list.contains(&number)));
        let (mechanism, kind) = (&linkage.mechanism, analysis.input.kind);
        Self { analysis, linkage, mechanism, positions, told: RefCell::default(), kind }
    }

    /// The unit of the coordinate of the input.
    fn coordinate(&self) -> Unit {
        Unit::coordinate(self.kind)
    }

    /// The head of a column of the coordinate: its own name, or the link whose coordinate it is.
    fn coordinate_head(&self) -> Text {
        if self.kind.is_time() {
            return name("t");
        }
        self.mechanism.input.name.as_ref().map_or_else(|| Text::from(self.analysis.input.name()), Text::from)
    }

    /// Number and coordinate of the positions.
    fn keys(&self) -> Vec<Column> {
        let numbers = Column::counted(text!("head-number"), self.positions.numbers().iter().copied());
        if self.kind.is_time() {
            self.told.borrow_mut().push(Quantity::Time);
        }
        vec![numbers, self.headed(self.coordinate_head(), Values::COORDINATE)]
    }

    /// A column of one quantity over the positions; a dash where a position has none.
    fn column(&self, values: Values) -> Column {
        self.headed(catalogue::head(values), values)
    }

    /// The same with a head of its own.
    fn headed(&self, head: Text, values: Values) -> Column {
        self.told.borrow_mut().push(values.quantity);
        column(&self.positions, head, values)
    }

    /// The owners of a quantity that are shown.
    fn owners(&self, quantity: Quantity, wanted: impl Fn(&Owner) -> bool) -> Vec<Owner> {
        self.positions.schema().owners(quantity).into_iter().filter(wanted).collect()
    }

    /// The name of an owner; of a group its index.
    fn name(&self, owner: Owner) -> Text {
        let schema = self.positions.schema();
        schema.named(owner).map_or_else(|| name(schema.name(owner).into_owned()), Text::from)
    }
}

/// The numbers of a column, or the moduli of two projections, in all rows.
fn each(table: &Table, values: Values) -> Vec<Option<f64>> {
    match table.schema().find(values) {
        Some(column) => table.each(column).collect(),
        None => (0..table.len()).map(|row| table.get(row, values)).collect(),
    }
}

/// A column of one quantity over the rows of a table, with its unit.
fn column(table: &Table, head: Text, values: Values) -> Column {
    Column::numbers(head, catalogue::unit(table.schema(), values), each(table, values))
}

/// The topics that tell of all positions and of the motion, in the order of the report.
const TOPICS: [fn(&Source<'_>, &mut Document); 15] = [
    shown_positions,
    positions,
    transfer,
    rates,
    no_motion,
    motion_over_time,
    regime,
    loads,
    reduction,
    reactions,
    balancing,
    friction,
    causes,
    contacts,
    condition,
];

/// The whole report: first the results that are asked for first, then the tables.
pub fn report(source: &Source<'_>) -> Document {
    let mut page = Document::default();
    let analysis = source.analysis;
    page.scene(&analysis.title);
    page.heading(text!("report-results-between"));
    page.facts(Text::default(), summary(analysis, source.linkage));
    page.heading(text!("report-structure"));
    mobility(source, &mut page);
    pairs(source, &mut page);
    groups(source, &mut page);
    page.heading(text!("report-task"));
    dimensions(source, &mut page);
    loads_given(source, &mut page);
    motion_given(source, &mut page);
    for topic in TOPICS {
        topic(source, &mut page);
    }
    further(source, &mut page);
    remarks(source, &mut page);
    if !analysis.checks.is_empty() {
        page.heading(text!("report-checks"));
        checks(&analysis.checks, &mut page);
    }
    for found in &analysis.cycle.plans {
        let at = source.coordinate().show(found.sheet.coordinate);
        let (position, link) = (assur_words::number(found.index), source.coordinate_head());
        page.heading(text!("plans-of", position, link, at));
        plans(&found.sheet, &mut page);
    }
    page
}

/// The quantities of the shown positions of which no topic tells.
pub fn further(source: &Source<'_>, page: &mut Document) {
    if source.told.borrow().is_empty() {
        for topic in TOPICS {
            topic(source, &mut Document::default());
        }
    }
    let (schema, told) = (source.positions.schema(), source.told.borrow().clone());
    let is_new = |column: &&Values| {
        let is_residual = matches!(column.quantity, Quantity::Residual(_));
        column.cause.is_none() && !is_residual && !told.contains(&column.quantity)
    };
    let left: Vec<Values> = schema.columns().iter().filter(is_new).copied().collect();
    if source.positions.is_empty() || left.is_empty() {
        return;
    }
    page.heading(text!("report-further"));
    for of_quantity in left.chunk_by(|one, next| one.quantity == next.quantity) {
        let group = |of_owner: &[Values]| Group {
            owner: catalogue::owner(schema, of_owner[0]),
            columns: of_owner.iter().map(|values| source.column(*values)).collect(),
        };
        let groups = of_quantity.chunk_by(|one, next| one.owner == next.owner).map(group);
        page.table(source.table(catalogue::kind(of_quantity[0]), text!("head-of"), groups));
    }
}

fn regime(source: &Source<'_>, page: &mut Document) {
    let Some(found) = &source.analysis.dynamics else { return };
    page.heading(text!("report-regime"));
    page.facts(Text::default(), regime_facts(source.analysis));
    iteration(source, page);
    regime_over_cycle(source, page);
    if found.motor.is_some() || found.flywheel.is_some() {
        page.heading(text!("report-drive"));
        drive(source, page);
    }
}

/// What was decided during the calculation, and what has no solution.
fn remarks(source: &Source<'_>, page: &mut Document) {
    let analysis = source.analysis;
    let failures: Vec<_> = analysis.failures.iter().map(|failure| failure.message.clone()).collect();
    let notes: Vec<_> = analysis.warnings.iter().map(Text::from).collect();
    for (heading, lines) in [(text!("report-notes"), notes), (text!("report-failures"), failures)] {
        if !lines.is_empty() {
            page.heading(heading);
            for line in lines {
                page.paragraph(line);
            }
        }
    }
}
