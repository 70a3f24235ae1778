//! Dry friction of the pairs: moments, forces and powers, efficiency, certificates.

use assur_force::{Bearing, FrictionForces, UnitBalance};
use assur_mechanism::PairId;
use assur_number::{Lanes, Real};
use assur_words::name;

use super::{Family, Rows};
use crate::Calculation;
use crate::friction::efficiency;
use crate::joints::ends;
use crate::results::{Cells, Column, Owner, Quantity};

/// The frictions of the scene whose pairs are wanted, each with its bearings.
fn wanted(calculation: &Calculation) -> Vec<(PairId, Vec<(usize, &Bearing)>)> {
    let Some(frictions) = calculation.loads.as_ref().and_then(|loads| loads.frictions()) else {
        return Vec::new();
    };
    let mechanism = &calculation.linkage.mechanism;
    let pairs = mechanism.frictions.iter().map(|friction| friction.pair);
    let pairs = pairs.filter(|pair| calculation.plan.wanted.reactions.contains(pair));
    let bearings = |pair| frictions.bearings.iter().enumerate().filter(move |(_, one)| one.pair == pair);
    pairs.map(|pair| (pair, bearings(pair).collect())).collect()
}

fn applies(calculation: &Calculation) -> bool {
    calculation.positions_have_forces() && has_friction(calculation)
}

fn has_friction(calculation: &Calculation) -> bool {
    calculation.has_forces() && !calculation.linkage.mechanism.frictions.is_empty()
}

/// Moments and forces of friction, and their powers.
pub(super) const FRICTION: Family = Family {
    applies: has_friction,
    columns: |calculation, schema| {
        let mut section = schema.section();
        let apart = calculation.rests_leave_unknown();
        for (index, (pair, bearings)) in wanted(calculation).into_iter().enumerate() {
            if index > 0 && apart {
                section = schema.section();
            }
            let several = bearings.len() > 1;
            for (_, bearing) in bearings {
                let column = match pair {
                    PairId::Slide(_) => Column::of(Quantity::FrictionForce, Owner::Pair(pair)),
                    PairId::Pin(_) if several => {
                        Column::of(Quantity::FrictionMoment, Owner::PairOn(pair, bearing.link))
                    }
                    PairId::Pin(_) => Column::of(Quantity::FrictionMoment, Owner::Pair(pair)),
                };
                schema.add(section, [column]);
            }
            // At rest friction has no power, whatever it is.
            let of_power = if apart { schema.section() } else { section };
            schema.add(of_power, [Column::of(Quantity::FrictionPower, Owner::Pair(pair))]);
        }
    },
    fill: |rows, cells| {
        let Some((_, reactions, determined)) = rows.reactions else { return };
        let Some(friction) = &reactions.friction else { return };
        for (_, bearings) in wanted(rows.calculation) {
            let mut power = Lanes::ZERO;
            for (index, bearing) in bearings {
                cells.put(friction.forces[index], rows.known(friction.forces[index], determined));
                power += power_of(rows, friction, index, bearing);
            }
            let rests = |lane: usize| rows.rests(lane) && power.0[lane].is_nan();
            let power = Lanes::of(|lane| if rests(lane) { 0.0 } else { power.0[lane] });
            cells.put(power, determined);
        }
    },
};

/// Power of the friction of a bearing.
fn power_of(rows: &Rows<'_>, friction: &FrictionForces<Lanes>, index: usize, bearing: &Bearing) -> Lanes {
    let power = friction.forces[index] * bearing.relative(&rows.position.bodies) * speed(rows);
    // Where the relative speed is zero but for rounding its sign is not that of the friction.
    Lanes::of(|lane| if power.0[lane] > 0.0 { 0.0 } else { power.0[lane] })
}

/// Speed by which powers are counted.
fn speed(rows: &Rows<'_>) -> Lanes {
    // The rows with friction of a transient motion are its samples.
    let moves = rows.calculation.positions_move() || !rows.calculation.positions_have_forces();
    let loads = rows.calculation.loads.as_ref();
    Lanes::of(|lane| loads.map_or(0.0, |loads| loads.speed_of_friction(&rows.instants[lane].state, moves)))
}

/// What friction makes of the balancing load.
pub(super) const EFFICIENCY: Family = Family {
    applies,
    columns: |calculation, schema| {
        let [ideal, determined] = [schema.section(), schema.section()];
        schema.add(ideal, [Column::of(Quantity::IdealBalancing, Owner::Input)]);
        schema.add(determined, [Column::of(Quantity::Efficiency, Owner::Input)]);
        for group in super::solved(calculation) {
            let section = schema.section();
            schema.add(section, [Column::of(Quantity::FrictionCertificate, Owner::Group(group))]);
        }
    },
    fill: |rows, cells| {
        let linkage = &rows.calculation.linkage;
        let unit = UnitBalance::of(&linkage.mechanism).map(|unit| unit.power(&rows.position.bodies));
        let ideal = rows.reduced.map_or(Lanes::ZERO, |reduced| {
            let (speed, acceleration) =
                (rows.state(|state| state.speed), rows.state(|state| state.acceleration));
            let slope = reduced.inertia_derivative.half() * speed * speed;
            let drive = reduced.inertia * acceleration + slope - reduced.moment;
            unit.map_or(drive, |unit| drive / unit)
        });
        cells.put(ideal, ideal.0.map(f64::is_finite));
        let Some((_, reactions, determined)) = rows.reactions else { return };
        let Some(friction) = &reactions.friction else { return };
        let bearings = friction.frictions.bearings.iter().enumerate();
        let power = bearings
            .fold(Lanes::ZERO, |sum, (index, bearing)| sum + power_of(rows, friction, index, bearing));
        let driving = reactions.balancing * unit.unwrap_or(Lanes::ONE) * speed(rows);
        let found: [Option<f64>; Lanes::WIDTH] = std::array::from_fn(|lane| {
            efficiency(driving.0[lane], -power.0[lane]).filter(|_| determined[lane])
        });
        put(cells, found);
        for group in super::solved(rows.calculation) {
            let radius = friction.certificates[group];
            let has = std::array::from_fn(|lane| determined[lane] && radius.0[lane].is_finite());
            cells.put(radius, has);
        }
    },
};

/// Forces and moments of the pins and slides.
pub(super) const REACTIONS: Family = Family {
    applies: |calculation| {
        calculation.has_forces() && calculation.analyzer.is_some_and(|method| method.gives_reactions)
    },
    columns: |calculation, schema| {
        // Beside passive parts each reaction may lack by itself, and the row says so.
        let beside_passive = !calculation.linkage.structure.passive.is_empty();
        let mut section = schema.section();
        for (index, &pair) in calculation.plan.wanted.reactions.iter().enumerate() {
            // At rest some depend on dry friction, which is not determined there, and others don't.
            if index > 0 && calculation.rests_leave_unknown() {
                section = schema.section();
            }
            for link in ends(&calculation.linkage, pair) {
                if beside_passive {
                    section = schema.nullable();
                }
                schema.add(section, Column::vector(Quantity::Force, Owner::PairOn(pair, link)));
            }
            if matches!(pair, PairId::Slide(_)) {
                if beside_passive {
                    section = schema.nullable();
                }
                schema.add(section, [Column::of(Quantity::Moment, Owner::Pair(pair))]);
                let offset = schema.section();
                schema.add(offset, [Column::of(Quantity::Offset, Owner::Pair(pair))]);
            }
        }
    },
    fill: |rows, cells| {
        let Some((joints, reactions, determined)) = rows.reactions else { return };
        for joint in joints.wanted(reactions, rows.position) {
            let given = |nth: usize| {
                let open = joint.open.get(nth).filter(|_| !rows.calculation.least_norm);
                let is_given =
                    |open: &Lanes| std::array::from_fn(|lane| determined[lane] && open.0[lane] == 0.0);
                open.map_or(determined, is_given)
            };
            for (nth, force) in joint.forces.iter().enumerate() {
                for part in force {
                    cells.put(*part, rows.known(*part, given(nth)));
                }
            }
            if let Some((moment, offset, has)) = joint.slide {
                let [force, known] = [0, joint.forces.len()].map(|nth| rows.known(moment, given(nth)));
                cells.put(moment, known);
                cells.put(offset, std::array::from_fn(|lane| force[lane] && known[lane] && has[lane]));
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
