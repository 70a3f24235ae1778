//! The families of columns: what the results of a position or of a sample of a motion consist of.
//!
//! A family names its columns, and fills them in the same order for eight solved positions. A further quantity in the
//! results is a further family in [`POSITIONS`], [`TRANSIENT`] or [`STEADY`]; the writers need a name for it.

mod friction;
mod loads;
mod motion;

use std::sync::Arc;

use assur_dynamics::Instant;
use assur_force::{LoadState, Reactions};
use assur_group::Order;
use assur_integrator::Reduced;
use assur_kinematics::LanePosition;
use assur_number::{Lanes, Real};

use crate::joints::Joints;
use crate::results::{Cells, Column, Mask, Owner, Quantity, Schema};
use crate::{Calculation, InputMotion};

pub(crate) use motion::Motions;

use friction::{BALANCING, EFFICIENCY, FRICTION, FURTHER, HOLDING, REACTIONS};
use loads::{INERTIA_LOADS, INERTIA_OF_LINKS, LOADS, REDUCED, SHAKING};
use motion::{COORDINATE, LINKS, PLACES, POINTS, RATES, SLIDES, SPEEDS, TIME};

/// Columns that belong together.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    /// Whether the calculation gives them.
    pub(crate) applies: fn(&Calculation) -> bool,
    /// Adds them to a schema.
    pub(crate) columns: fn(&Calculation, &mut Schema),
    /// Fills exactly these; columns that are left over have no numbers.
    pub(crate) fill: fn(&Rows<'_>, &mut Cells<'_>),
}

/// The columns of a table, by families.
pub(crate) struct Columns {
    /// Each with the number of columns up to its end.
    pub(crate) families: Vec<(Family, usize)>,
    pub(crate) schema: Arc<Schema>,
}

impl Columns {
    /// The columns of the families that apply.
    fn of(calculation: &Calculation, families: &[Family]) -> Self {
        let mut schema = Schema::new(&calculation.linkage.mechanism);
        let applying = families.iter().filter(|family| (family.applies)(calculation));
        let ending = applying.map(|family| {
            (family.columns)(calculation, &mut schema);
            (*family, schema.columns().len())
        });
        Self { families: ending.collect(), schema: Arc::new(schema) }
    }
}

/// What is known about eight positions, a lane each.
pub(crate) struct Rows<'a> {
    pub(crate) calculation: &'a Calculation,
    pub(crate) instants: [Instant; Lanes::WIDTH],
    pub(crate) position: &'a LanePosition,
    pub(crate) motions: &'a Motions,
    pub(crate) reduced: Option<Reduced<Lanes>>,
    /// Forces of the pins and slides, and the lanes in which they are determined.
    pub(crate) reactions: Option<(&'a Joints, &'a Reactions<Lanes>, Mask)>,
    /// The balancing load, N m or N.
    pub(crate) balancing: [Option<f64>; Lanes::WIDTH],
}

impl Rows<'_> {
    /// In which lanes a number that depends on dry friction is known: not where that holds a motion at rest, unless it does not
    /// reach the number.
    fn known(&self, value: Lanes, determined: Mask) -> Mask {
        std::array::from_fn(|lane| determined[lane] && (value.0[lane].is_finite() || !self.rests(lane)))
    }

    /// Whether dry friction holds a motion at rest.
    fn rests(&self, lane: usize) -> bool {
        self.calculation.rests_by_friction(&self.instants[lane].state)
    }

    /// A number of the state of each lane.
    fn state(&self, number: fn(&LoadState) -> f64) -> Lanes {
        Lanes::of(|lane| number(&self.instants[lane].state))
    }
}

/// Of the positions of a scene.
const POSITIONS: &[Family] = &[
    COORDINATE,
    Family { applies: Calculation::positions_move, ..SPEEDS },
    LINKS,
    POINTS,
    SLIDES,
    Family { applies: |found| found.positions_move() && found.plan.velocities, ..RATES },
    REDUCED,
    INERTIA_OF_LINKS,
    LOADS,
    INERTIA_LOADS,
    SHAKING,
    Family { applies: |found| found.positions_have_forces() && (REACTIONS.applies)(found), ..REACTIONS },
    FURTHER,
    Family { applies: |found| found.positions_have_forces() && (FRICTION.applies)(found), ..FRICTION },
    Family { applies: |found| found.positions_have_forces() && (BALANCING.applies)(found), ..BALANCING },
    EFFICIENCY,
    CONDITION,
];
/// Of the samples of a transient motion.
const TRANSIENT: &[Family] =
    &[TIME, COORDINATE, SPEEDS, LINKS, PLACES, SLIDES, RATES, REACTIONS, FRICTION, BALANCING, HOLDING];
/// Of the samples of a steady motion.
const STEADY: &[Family] = &[TIME, COORDINATE, SPEEDS, LINKS];

/// 1 / |health| of the groups that are solved; a group in a singular position has none that is a number.
const CONDITION: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        for group in solved(calculation) {
            let section = schema.section();
            schema.add(section, [Column::of(Quantity::Condition, Owner::Group(group))]);
        }
    },
    fill: |rows, cells| {
        for group in solved(rows.calculation) {
            let health = rows.position.health[group].abs();
            cells.put(Lanes::ONE / health, health.0.map(|health| health > f64::MIN_POSITIVE));
        }
    },
};

/// The groups that are solved.
fn solved(calculation: &Calculation) -> impl Iterator<Item = usize> {
    let needed = calculation.plan.groups_needed.iter().enumerate();
    needed.filter(|(_, needed)| **needed).map(|(group, _)| group)
}

impl Calculation {
    pub(crate) fn columns_of_positions(&self) -> Columns {
        Columns::of(self, POSITIONS)
    }

    /// The columns of the samples of a motion over time; none with a prescribed motion.
    pub(crate) fn columns_of_motion(&self) -> Columns {
        match self.motion {
            InputMotion::Prescribed => Columns::of(self, &[]),
            InputMotion::Transient(_) => Columns::of(self, TRANSIENT),
            InputMotion::Steady(_) => Columns::of(self, STEADY),
        }
    }

    /// Whether the positions have a speed.
    fn positions_move(&self) -> bool {
        self.motion.moves(&self.linkage.mechanism)
    }

    /// Whether all loads can be evaluated: groups that nothing wanted depends on are not solved.
    pub(crate) fn knows_all_loads(&self) -> bool {
        self.loads.is_some() && self.plan.all
    }

    /// Whether the positions have inertia loads.
    fn has_inertia_loads(&self) -> bool {
        let solved = self.plan.groups_needed.iter().all(|needed| *needed);
        self.plan.order == Order::Second && solved && self.knows_all_loads() && self.positions_move()
    }

    /// Whether there is a force analysis.
    fn has_forces(&self) -> bool {
        self.loads.is_some() && self.analyzer.is_some()
    }
}
