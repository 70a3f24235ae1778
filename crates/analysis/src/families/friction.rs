//! Dry friction of the pairs: moments, forces and powers, efficiency, certificates.

use assur_force::{Bearing, FrictionForces, UnitBalance};
use assur_mechanism::PairId;
use assur_number::{Lanes, Real};

use super::{Rows, Sink, some};
use crate::results::{Column, Owner, Quantity};
use crate::{Calculation, friction::efficiency};

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

/// Moments and forces of friction, and their powers.
pub(super) fn frictions(found: &Calculation, to: &mut impl Sink) {
    let mut section = to.section(false);
    let apart = found.rests_leave_unknown();
    for (index, (pair, bearings)) in wanted(found).into_iter().enumerate() {
        if index > 0 && apart {
            section = to.section(false);
        }
        let several = bearings.len() > 1;
        for (index, bearing) in &bearings {
            let column = match pair {
                PairId::Slide(_) => Column::of(Quantity::FrictionForce, Owner::Pair(pair)),
                PairId::Pin(_) if several => {
                    Column::of(Quantity::FrictionMoment, Owner::PairOn(pair, bearing.link))
                }
                PairId::Pin(_) => Column::of(Quantity::FrictionMoment, Owner::Pair(pair)),
            };
            to.put(section, [column], |rows| {
                let (friction, determined) = rows.friction()?;
                let force = friction.forces[*index];
                Some(([force], rows.known(force, determined)))
            });
        }
        // At rest friction has no power, whatever it is.
        let of_power = if apart { to.section(false) } else { section };
        to.put(of_power, [Column::of(Quantity::FrictionPower, Owner::Pair(pair))], |rows| {
            let (friction, determined) = rows.friction()?;
            let power = rows.power(friction, bearings.iter().copied());
            let rests = |lane: usize| rows.rests(lane) && power.0[lane].is_nan();
            Some(([Lanes::of(|lane| if rests(lane) { 0.0 } else { power.0[lane] })], determined))
        });
    }
}

/// What friction makes of the balancing load.
pub(super) fn efficiencies(found: &Calculation, to: &mut impl Sink) {
    let unit = |rows: &Rows<'_>| {
        UnitBalance::of(&found.linkage.mechanism).map(|unit| unit.power(&rows.position.bodies))
    };
    // Several drives have no efficiency in common.
    if !found.linkage.mechanism.input.is_list {
        efficiency_of_one(found, unit, to);
    }
    for group in super::solved(found) {
        let section = to.section(false);
        to.put(section, [Column::of(Quantity::FrictionCertificate, Owner::Group(group))], |rows| {
            let (friction, determined) = rows.friction()?;
            let radius = friction.certificates[group];
            Some(([radius], std::array::from_fn(|lane| determined[lane] && radius.0[lane].is_finite())))
        });
    }
}

/// The balancing load without friction, and the efficiency.
fn efficiency_of_one(found: &Calculation, unit: impl Fn(&Rows<'_>) -> Option<Lanes>, to: &mut impl Sink) {
    let [ideal, determined] = [to.section(false), to.section(false)];
    to.put(ideal, [Column::of(Quantity::IdealBalancing, Owner::Input)], |rows| {
        let is_timed = found.linkage.kind().is_time();
        let reduced = if is_timed { super::drives::by_coordinate(rows) } else { rows.reduced };
        let ideal = reduced.map_or(Lanes::ZERO, |reduced| {
            let [speed, acceleration] = if is_timed {
                super::drives::rates(rows)
            } else {
                [rows.state(|state| state.speed), rows.state(|state| state.acceleration)]
            };
            let slope = reduced.inertia_derivative.half() * speed * speed;
            let drive = reduced.inertia * acceleration + slope - reduced.moment;
            // A load elsewhere moves as the coordinate does.
            let bodies = if is_timed { &rows.partials[0] } else { &rows.position.bodies };
            UnitBalance::of(&found.linkage.mechanism).map_or(drive, |unit| drive / unit.power(bodies))
        });
        Some(([ideal], ideal.0.map(f64::is_finite)))
    });
    to.put(determined, [Column::of(Quantity::Efficiency, Owner::Input)], |rows| {
        let (friction, determined) = rows.friction()?;
        let (_, reactions, _) = rows.reactions?;
        let power = rows.power(friction, friction.frictions.bearings.iter().enumerate());
        let driving = reactions.balancing * unit(rows).unwrap_or(Lanes::ONE) * rows.speed();
        let of = |lane: usize| efficiency(driving.0[lane], -power.0[lane]).filter(|_| determined[lane]);
        some(std::array::from_fn(of))
    });
}

/// Forces and moments of the pins and slides.
pub(super) fn reactions(found: &Calculation, to: &mut impl Sink) {
    // Beside passive parts each reaction may lack by itself, and the row says so.
    let beside_passive = !found.linkage.structure.passive.is_empty();
    // At rest some depend on dry friction or on the shares of loads, which are not determined there, and others don't.
    let at_rest = found.rests_leave_unknown();
    let shared = at_rest && found.may_share();
    let mut section = to.section(shared);
    for (index, &pair) in found.plan.wanted.reactions.iter().enumerate() {
        if index > 0 && at_rest {
            section = to.section(shared);
        }
        let links = crate::joints::ends(&found.linkage, pair);
        for (nth, link) in links.iter().enumerate() {
            if beside_passive {
                section = to.section(true);
            }
            to.put(section, Column::vector(Quantity::Force, Owner::PairOn(pair, *link)), |rows| {
                let (joints, reactions, _) = rows.reactions?;
                let force = joints.of(index).joint.force(nth, &reactions.pairs);
                Some((force, rows.known(force[1], rows.given(index, nth)?)))
            });
        }
        if matches!(pair, PairId::Slide(_)) {
            if beside_passive {
                section = to.section(true);
            }
            let known = |rows: &Rows<'_>, moment, nth| Some(rows.known(moment, rows.given(index, nth)?));
            to.put(section, [Column::of(Quantity::Moment, Owner::Pair(pair))], |rows| {
                let (joints, reactions, _) = rows.reactions?;
                let moment = joints.of(index).joint.moment(&reactions.pairs)?;
                Some(([moment], known(rows, moment, links.len())?))
            });
            let offset = to.section(false);
            to.put(offset, [Column::of(Quantity::Offset, Owner::Pair(pair))], |rows| {
                let (joints, reactions, _) = rows.reactions?;
                let moment = joints.of(index).joint.moment(&reactions.pairs)?;
                let normal = joints.of(index).normal(reactions, rows.position)?;
                let least =
                    rows.greatest_force.get_or_init(|| joints.greatest(reactions)).map(|of| LEAST_FORCE * of);
                let [force, known] = [known(rows, moment, 0)?, known(rows, moment, links.len())?];
                let has = |lane: usize| force[lane] && known[lane] && normal.0[lane].abs() > least[lane];
                Some(([moment / normal], std::array::from_fn(has)))
            });
        }
    }
}

/// A force below this part of the greatest of the position has no meaningful line of action.
const LEAST_FORCE: f64 = 1e-9;

/// The further forces of the analyzer.
pub(super) fn further(found: &Calculation, to: &mut impl Sink) {
    let section = to.section(false);
    for force in 0..found.analyzer.map_or(0, |method| method.further.len()) {
        to.put(section, [Column::of(Quantity::OfMethod, Owner::Method(force))], |rows| {
            let (_, reactions, determined) = rows.reactions?;
            Some(([*reactions.further.get(force)?], determined))
        });
    }
}

pub(super) fn balancing(to: &mut impl Sink) {
    let section = to.section(false);
    to.put(section, [Column::BALANCING], |rows| {
        let values = Lanes(rows.balancing.map(Option::unwrap_or_default));
        Some(([values], rows.known(values, rows.balancing.map(|value| value.is_some()))))
    });
}

/// The load that holds the motion at rest or at its speed, and its greatest possible size.
pub(super) fn holding(to: &mut impl Sink) {
    let section = to.section(false);
    let of = |quantity| [Column::of(quantity, Owner::Input)];
    to.put(section, of(Quantity::Holding), |rows| some(rows.instants.map(|at| Some(at.holding?.moment))));
    to.put(section, of(Quantity::HoldingBound), |rows| some(rows.instants.map(|at| Some(at.holding?.bound))));
}

impl<'a> Rows<'a> {
    /// The dry friction of the pairs, and the lanes in which it is determined.
    fn friction(&self) -> Option<(&'a FrictionForces<Lanes>, [bool; Lanes::WIDTH])> {
        let (_, reactions, determined) = self.reactions?;
        Some((reactions.friction.as_ref()?, determined))
    }

    /// Lanes in which the force of a pin or slide on one of its links is determined, or, after the links, the moment of a slide.
    fn given(&self, joint: usize, nth: usize) -> Option<[bool; Lanes::WIDTH]> {
        let (joints, reactions, determined) = self.reactions?;
        let open =
            joints.of(joint).joint.open(&reactions.open).get(nth).filter(|_| !self.calculation.least_norm);
        let is_given = |open: &Lanes| std::array::from_fn(|lane| determined[lane] && open.0[lane] == 0.0);
        Some(open.map_or(determined, is_given))
    }

    /// Power of the friction of some bearings.
    fn power<'b>(
        &self,
        friction: &FrictionForces<Lanes>,
        bearings: impl Iterator<Item = (usize, &'b Bearing)>,
    ) -> Lanes {
        let speed = self.speed();
        bearings.fold(Lanes::ZERO, |sum, (index, bearing)| {
            let power = friction.forces[index] * bearing.relative(&self.position.bodies) * speed;
            // Where the relative speed is zero but for rounding its sign is not that of the friction.
            sum + Lanes::of(|lane| if power.0[lane] > 0.0 { 0.0 } else { power.0[lane] })
        })
    }

    /// Speed by which powers are counted.
    fn speed(&self) -> Lanes {
        // The rows with friction of a transient motion are its samples.
        let moves = self.calculation.positions_move() || !self.calculation.positions_have_forces();
        let loads = self.calculation.loads.as_ref();
        Lanes::of(|lane| {
            loads.map_or(0.0, |loads| loads.speed_of_friction(&self.instants[lane].state, moves))
        })
    }
}
