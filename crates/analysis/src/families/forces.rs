//! Reactions of the pairs, and what balances or holds the motion.

use assur_mechanism::PairId;
use assur_number::Lanes;
use assur_words::name;

use super::Family;
use crate::joints::ends;
use crate::results::{Cells, Column, Owner, Quantity};

/// Forces and moments of the pins and slides.
pub(super) const REACTIONS: Family = Family {
    applies: |calculation| {
        calculation.has_forces() && calculation.analyzer.is_some_and(|method| method.gives_reactions)
    },
    columns: |calculation, schema| {
        let section = schema.section();
        for &pair in &calculation.plan.wanted.reactions {
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
            joint.forces.iter().flatten().for_each(|force| cells.put(*force, determined));
            if let Some((moment, offset, has)) = joint.slide {
                cells.put(moment, determined);
                cells.put(offset, std::array::from_fn(|lane| determined[lane] && has[lane]));
            }
        }
    },
};

/// The further forces of the analyzer.
pub(super) const FURTHER: Family = Family {
    applies: |calculation| calculation.has_forces() && calculation.positions_have_forces(),
    columns: |calculation, schema| {
        let names = calculation.analyzer.map_or(&[][..], |method| method.further);
        schema.further = names.iter().map(|told| name(*told).into()).collect();
        let section = schema.section();
        schema
            .add(section, (0..names.len()).map(|force| Column::of(Quantity::OfMethod, Owner::Method(force))));
    },
    fill: |rows, cells| {
        let Some((_, reactions, determined)) = rows.reactions else { return };
        reactions.further.iter().for_each(|force| cells.put(*force, determined));
    },
};

pub(super) const BALANCING: Family = Family {
    applies: |calculation| calculation.has_forces(),
    columns: |_, schema| {
        let section = schema.section();
        schema.add(section, [Column::BALANCING]);
    },
    fill: |rows, cells| put(cells, rows.balancing),
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
