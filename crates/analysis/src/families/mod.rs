//! The families of columns: what the results of a position or of a sample of a motion consist of.
//!
//! A family emits its columns, each with how its numbers are found in eight solved positions. What becomes of them is up to the
//! [`Sink`]: a schema takes the columns, a table the numbers. A further quantity in the
//! results is a further family in [`Of::emit`]; the writers need a name for it.

mod drives;
mod friction;
mod loads;
mod motion;

use std::cell::OnceCell;
use std::sync::Arc;

use assur_dynamics::Instant;
use assur_force::{LoadState, Reactions};
use assur_group::{Body, Order};
use assur_integrator::Reduced;
use assur_kinematics::LanePosition;
use assur_number::{Lanes, Real};
use assur_words::name;

use crate::results::{Cells, Column, Mask, Owner, Quantity, Schema, Section};
use crate::{Calculation, InputMotion, joints::Joints};

/// Receives the columns of results in their order, each with what finds its numbers in eight positions.
pub(crate) trait Sink {
    /// A new section for columns that some rows lack; `nullable`: for one quantity, and a row that lacks it says so.
    fn section(&mut self, nullable: bool) -> Section {
        let _ = nullable;
        Section::ALWAYS
    }

    /// Columns of a section, and the lanes that have them; `None`: none has.
    fn put<const N: usize>(
        &mut self,
        section: Section,
        columns: [Column; N],
        find: impl FnOnce(&Rows<'_>) -> Option<([Lanes; N], Mask)>,
    );

    /// Columns that have numbers in all rows.
    fn always<const N: usize>(&mut self, columns: [Column; N], find: impl FnOnce(&Rows<'_>) -> [Lanes; N]) {
        self.put(Section::ALWAYS, columns, |rows| Some((find(rows), [true; Lanes::WIDTH])));
    }
}

impl Sink for Schema {
    fn section(&mut self, nullable: bool) -> Section {
        if nullable { self.nullable() } else { self.section() }
    }

    fn put<const N: usize>(
        &mut self,
        section: Section,
        columns: [Column; N],
        _: impl FnOnce(&Rows<'_>) -> Option<([Lanes; N], Mask)>,
    ) {
        self.add(section, columns);
    }
}

/// Writes the numbers of eight positions into a table, which knows its columns.
pub(crate) struct TableRows<'a>(pub(crate) &'a Rows<'a>, pub(crate) Cells<'a>);

impl Sink for TableRows<'_> {
    fn put<const N: usize>(
        &mut self,
        _: Section,
        _: [Column; N],
        find: impl FnOnce(&Rows<'_>) -> Option<([Lanes; N], Mask)>,
    ) {
        let (values, has) = find(self.0).unwrap_or(([Lanes::ZERO; N], [false; Lanes::WIDTH]));
        for values in values {
            self.1.put(values, has);
        }
    }
}

/// Numbers of one column, of the lanes that have one.
#[expect(clippy::unnecessary_wraps, reason = "what a family hands to a sink")]
fn some(values: [Option<f64>; Lanes::WIDTH]) -> Option<([Lanes; 1], Mask)> {
    Some(([Lanes(values.map(Option::unwrap_or_default))], values.map(|value| value.is_some())))
}

/// The columns of a table.
pub(crate) struct Columns {
    pub(crate) of: Of,
    pub(crate) schema: Arc<Schema>,
}

/// What has a row each.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Of {
    /// The positions of a scene.
    Positions,
    /// The samples of a transient motion.
    Transient,
    /// The samples of a steady motion.
    Steady,
    Nothing,
}

impl Columns {
    fn of(calculation: &Calculation, of: Of) -> Self {
        let mut schema = Schema::new(&calculation.linkage.mechanism);
        let names = calculation.analyzer.map_or(&[][..], |method| method.further);
        schema.further = names.iter().map(|told| name(*told).into()).collect();
        of.emit(calculation, &mut schema);
        Self { of, schema: Arc::new(schema) }
    }
}

impl Of {
    /// Hands all columns to a sink, by families, in their order.
    pub(crate) fn emit(self, found: &Calculation, to: &mut impl Sink) {
        let wanted = &found.plan.wanted;
        match self {
            Self::Nothing => {}
            Self::Positions => positions(found, found.positions_move(), found.positions_have_forces(), to),
            Self::Transient => {
                motion::time(to);
                positions(found, true, true, to);
                friction::holding(to);
            }
            Self::Steady => {
                motion::time(to);
                motion::coordinate(to);
                motion::speeds(to);
                motion::links(wanted, to);
            }
        }
    }
}
/// What is known about eight positions, a lane each.
pub(crate) struct Rows<'a> {
    pub(crate) calculation: &'a Calculation,
    pub(crate) instants: [Instant; Lanes::WIDTH],
    pub(crate) position: &'a LanePosition,
    pub(crate) reduced: Option<Reduced<Lanes>>,
    /// Forces of the pins and slides, and the lanes in which they are determined.
    pub(crate) reactions: Option<(&'a Joints, &'a Reactions<Lanes>, Mask)>,
    /// The balancing load, N m or N.
    pub(crate) balancing: [Option<f64>; Lanes::WIDTH],
    /// Over time all links for the derivatives with respect to the coordinate of each drive, the others at rest.
    pub(crate) partials: Vec<Vec<Body<Lanes>>>,
    /// The values of the loads of the scene, once one is asked for.
    pub(crate) sizes: OnceCell<Vec<Lanes>>,
    /// The greatest force of all pins and slides, N, once it is asked for.
    pub(crate) greatest_force: OnceCell<[f64; Lanes::WIDTH]>,
}

impl Rows<'_> {
    /// In which lanes a number that depends on what holds a motion at rest is known: not at rest, unless that does not reach the number.
    fn known(&self, value: Lanes, determined: Mask) -> Mask {
        std::array::from_fn(|lane| determined[lane] && (value.0[lane].is_finite() || !self.rests(lane)))
    }

    /// Whether dry friction, or several loads together, hold a motion at rest.
    fn rests(&self, lane: usize) -> bool {
        let (found, state) = (self.calculation, &self.instants[lane].state);
        found.rests_by_friction(state) || found.rests_by_shares(state)
    }

    /// A number of the state of each lane.
    fn state(&self, number: fn(&LoadState) -> f64) -> Lanes {
        Lanes::of(|lane| number(&self.instants[lane].state))
    }
}

/// The columns of places, with rates if these move, and with loads and reactions if they have forces.
fn positions(found: &Calculation, moves: bool, has_forces: bool, to: &mut impl Sink) {
    let wanted = &found.plan.wanted;
    if found.linkage.kind().is_time() {
        motion::time(to);
        drives::coordinates(found, moves, to);
    } else {
        motion::coordinate(to);
        if moves {
            motion::speeds(to);
        }
    }
    if found.linkage.kind().is_time() {
        drives::links(found, to);
        drives::points(found, to);
        drives::slides(found, to);
    } else {
        motion::links(wanted, to);
        motion::points(wanted, to);
        motion::slides(wanted, to);
    }
    if moves && found.plan.velocities {
        motion::rates(wanted, to);
    }
    if found.plan.reduction && found.loads.is_some() {
        if found.linkage.kind().is_time() {
            drives::reduced(found, to);
        } else {
            loads::reduced(found, to);
        }
    }
    if has_forces && found.knows_all_loads() {
        loads::loads(found, to);
    }
    let accelerates = found.plan.order == Order::Second && moves;
    if accelerates && !found.plan.is_partial() && found.knows_all_loads() {
        loads::inertia_loads(found, to);
    }
    if has_forces {
        forces(found, to);
        // The efficiency of a motion over time would be 0/0 at rest.
        if found.has_forces() && found.has_friction() && found.positions_have_forces() {
            friction::efficiencies(found, to);
        }
    }
    conditions(found, to);
}

/// Reactions, friction and the balancing load.
fn forces(found: &Calculation, to: &mut impl Sink) {
    if !found.has_forces() {
        return;
    }
    if found.analyzer.is_some_and(|method| method.gives_reactions) {
        friction::reactions(found, to);
    }
    if found.positions_have_forces() {
        friction::further(found, to);
    }
    if found.has_friction() {
        friction::frictions(found, to);
    }
    // A balancing load elsewhere is one load, and leaves the drive nothing.
    let mechanism = &found.linkage.mechanism;
    if mechanism.input.kind().is_time() && mechanism.balance.is_none() {
        drives::loads(found, to);
    } else {
        friction::balancing(to);
    }
}

/// 1 / |determinant| of the groups that are solved; a group in a singular position has none that is a number.
fn conditions(found: &Calculation, to: &mut impl Sink) {
    for group in solved(found) {
        let section = to.section(false);
        to.put(section, [Column::of(Quantity::Condition, Owner::Group(group))], |rows| {
            let health = rows.position.health[group].abs();
            Some(([Lanes::ONE / health], health.0.map(|health| health > f64::MIN_POSITIVE)))
        });
    }
}

/// The groups that are solved.
fn solved(calculation: &Calculation) -> impl Iterator<Item = usize> {
    let needed = calculation.plan.groups_needed.iter().enumerate();
    needed.filter(|(_, needed)| **needed).map(|(group, _)| group)
}

impl Calculation {
    pub(crate) fn columns_of_positions(&self) -> Columns {
        Columns::of(self, Of::Positions)
    }

    /// The columns of the samples of a motion over time; none with a prescribed motion.
    pub(crate) fn columns_of_motion(&self) -> Columns {
        let of = match self.motion {
            InputMotion::Prescribed => Of::Nothing,
            InputMotion::Transient(_) => Of::Transient,
            InputMotion::Steady(_) => Of::Steady,
        };
        Columns::of(self, of)
    }

    /// Whether the positions have a speed.
    pub fn positions_move(&self) -> bool {
        self.motion.moves(&self.linkage.mechanism)
    }

    /// Whether all loads can be evaluated: groups that nothing wanted depends on are not solved.
    pub(crate) fn knows_all_loads(&self) -> bool {
        self.loads.is_some() && self.plan.all
    }

    fn has_friction(&self) -> bool {
        !self.linkage.mechanism.frictions.is_empty()
    }

    fn has_forces(&self) -> bool {
        self.loads.is_some() && self.analyzer.is_some()
    }
}
