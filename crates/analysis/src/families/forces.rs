//! Reactions of the pairs, and what balances or holds the motion.

use assur_mechanism::PairId;
use assur_number::Lanes;

use super::Family;
use crate::joints::ends;
use crate::results::{Cells, Column, Owner, Quantity};

/// Forces and moments of the pins and slides.
pub(super) const REACTIONS: Family = Family {
    applies: |calculation| {
        calculation.has_forces() && calculation.analyzer.is_some_and(|method| method.gives_reactions)
    },
    columns: |calculation, schema| {
        let mut section = schema.section();
        for (index, &pair) in calculation.plan.wanted.reactions.iter().enumerate() {
            // At rest some depend on dry friction, which is not determined there, and others don't.
            if index > 0 && calculation.rests_leave_unknown() {
                section = schema.section();
            }
            for link in ends(&calculation.linkage, pair) {
                schema.add(section, Column::vector(Quantity::Force, Owner::PairOn(pair, link)));
            }
            if matches!(pair, PairId::Slide(_)) {
                schema.add(section, [Column::of(Quantity::Moment, Owner::Pair(pair))]);
                let offset = schema.section();
                schema.add(offset, [Column::of(Quantity::Offset, Owner::Pair(pair))]);
            }
        }
    },
    fill: |rows, cells| {
        let Some((joints, reactions, determined)) = rows.reactions else { return };
        for joint in joints.wanted(reactions, rows.position) {
            for force in joint.forces.iter().flatten() {
                cells.put(*force, rows.known(*force, determined));
            }
            if let Some((moment, offset, has)) = joint.slide {
                let known = rows.known(moment, determined);
                cells.put(moment, known);
                cells.put(offset, std::array::from_fn(|lane| known[lane] && has[lane]));
            }
        }
    },
};

pub(super) const BALANCING: Family = Family {
    applies: |calculation| calculation.has_forces(),
    columns: |_, schema| {
        let section = schema.section();
        schema.add(section, [Column::BALANCING]);
    },
    fill: |rows, cells| {
        let values = Lanes(rows.balancing.map(Option::unwrap_or_default));
        cells.put(values, rows.known(values, rows.balancing.map(|value| value.is_some())));
    },
};

/// The load that holds the motion at rest or at its speed, and its greatest possible size.
pub(super) const HOLDING: Family = Family {
    applies: |_| true,
    columns: |_, schema| {
        let section = schema.section();
        let of = |quantity| Column::of(quantity, Owner::Input);
        schema.add(section, [Quantity::Holding, Quantity::HoldingBound].map(of));
    },
    fill: |rows, cells| {
        put(cells, rows.instants.map(|instant| Some(instant.holding?.moment)));
        put(cells, rows.instants.map(|instant| Some(instant.holding?.bound)));
    },
};

fn put(cells: &mut Cells<'_>, values: [Option<f64>; Lanes::WIDTH]) {
    cells.put(Lanes(values.map(Option::unwrap_or_default)), values.map(|value| value.is_some()));
}
