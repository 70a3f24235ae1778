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
        // Beside passive parts each reaction may lack, and is then told to.
        let may_lack = !calculation.linkage.structure.passive.is_empty();
        let together = schema.section();
        for &pair in &calculation.plan.wanted.reactions {
            for link in ends(&calculation.linkage, pair) {
                let section = if may_lack { schema.nullable() } else { together };
                schema.add(section, Column::vector(Quantity::Force, Owner::PairOn(pair, link)));
            }
            if matches!(pair, PairId::Slide(_)) {
                let section = if may_lack { schema.nullable() } else { together };
                schema.add(section, [Column::of(Quantity::Moment, Owner::Pair(pair))]);
                let offset = schema.section();
                schema.add(offset, [Column::of(Quantity::Offset, Owner::Pair(pair))]);
            }
        }
    },
    fill: |rows, cells| {
        let Some((joints, reactions, determined)) = rows.reactions else { return };
        for joint in joints.wanted(reactions, rows.position) {
            let known = |nth: usize| {
                let open = joint.open.get(nth).filter(|_| !rows.calculation.least_norm);
                open.map_or(determined, |open| {
                    std::array::from_fn(|lane| determined[lane] && open.0[lane] == 0.0)
                })
            };
            for (nth, force) in joint.forces.iter().enumerate() {
                for part in force {
                    cells.put(*part, known(nth));
                }
            }
            if let Some((moment, offset, has)) = joint.slide {
                let [force, turning] = [known(0), known(joint.forces.len())];
                cells.put(moment, turning);
                cells.put(offset, std::array::from_fn(|lane| force[lane] && turning[lane] && has[lane]));
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
