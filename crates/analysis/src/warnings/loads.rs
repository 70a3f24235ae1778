//! Springs without a direction, times that a prescribed motion does not have, and loads that drive it where a resistance may have
//! been meant.

use std::collections::BTreeMap;

use assur_force::{Cause, LoadState, power};
use assur_group::Order;
use assur_mechanism::{LoadId, Motion, Over, Range, Spring, Value, passage};
use assur_number::{ROUNDING, elementary};
use assur_words::{Text, list, quantity, text};

use super::Listed;
use crate::Calculation;

/// Loads drive if their net work over the cycle is more than this part of all their work: the works of a constant force cancel, but for
/// what few positions leave.
const NET: f64 = 0.1;
/// The works are summed at so many places of the cycle: few positions of a scene say little of it.
const PLACES: u32 = 144;

impl Calculation {
    /// Positions that lie before time zero of a prescribed motion, or that it never reaches, where a load depends on time.
    pub(super) fn positions_out_of_time(&self) -> Vec<Text> {
        let mechanism = &self.linkage.mechanism;
        let Some(Motion::Prescribed { speed, acceleration }) = mechanism.motion else { return Vec::new() };
        if !mechanism.loads.iter().flat_map(|load| load.kind.laws()).any(depends_on_time) {
            return Vec::new();
        }
        let input = &mechanism.input;
        let (mut before, mut never) = (0, 0);
        for index in 0..input.positions {
            match passage(input.coordinate(index) - input.from, speed, acceleration) {
                Some(time) => before += usize::from(time < 0.0),
                None => never += 1,
            }
        }
        let before = (before > 0).then(|| text!("analysis-before-time-zero", count = before));
        let never = (never > 0).then(|| text!("analysis-never-reached", count = never));
        before.into_iter().chain(never).collect()
    }

    /// Springs whose ends meet in positions of the scene: there they have no direction and give no force, even with a
    /// free length.
    pub(super) fn springs_without_direction(&self) -> Vec<Text> {
        let (linkage, mechanism) = (&self.linkage, &self.linkage.mechanism);
        let mut position = linkage.position();
        let mut meets = |spring: &Spring, index: usize| {
            if linkage.solve_index(index, Order::Place, &mut position).is_err() {
                return false;
            }
            let [a, b] = spring.ends.map(|end| position.bodies[end.link].point(end.at));
            elementary::hypot(b[0] - a[0], b[1] - a[1]) <= ROUNDING * linkage.structure.scale
        };
        let words = mechanism.loads.iter().filter_map(|load| {
            let spring = load.kind.spring().filter(|spring| spring.stiffness > 0.0 && spring.length > 0.0)?;
            let found: Listed =
                (0..mechanism.input.positions).filter(|index| meets(spring, *index)).collect();
            found.note(|positions| {
                let (spring, length) = (&load.name, quantity(spring.length, "m"));
                text!("analysis-spring-without-direction", spring, positions, length)
            })
        });
        words.collect()
    }

    /// Loads that drive, where all loads together do.
    pub(super) fn driving_loads(&self) -> Option<Text> {
        let mechanism = &self.linkage.mechanism;
        let loads = self.loads.as_ref()?;
        let (Range::Cycle(cycle), Some(Motion::Prescribed { speed, .. })) =
            (mechanism.input.range, &mechanism.motion)
        else {
            return None;
        };
        let mut works: BTreeMap<LoadId, [f64; 2]> = BTreeMap::new();
        let mut position = self.linkage.position();
        for place in 0..PLACES {
            let way = mechanism.input.sign() * cycle * f64::from(place) / f64::from(PLACES);
            self.linkage.solve(mechanism.input.from + way, Order::First, &mut position).ok()?;
            let state = LoadState::prescribed(mechanism, position.coordinate);
            loads.by_cause(&state, &position.bodies, &mut |cause, link, wrench| {
                let Cause::Load(load) = cause else { return };
                let work = speed.signum() * power(&wrench, &position.bodies[link]);
                let [net, all] = works.entry(load).or_default();
                (*net, *all) = (*net + work, *all + work.abs());
            });
        }
        let sum = works.values().fold([0.0, 0.0], |[net, all], [one, size]| [net + one, all + size]);
        let drives = |[net, all]: &[f64; 2]| *net > NET * all && *all > 0.0;
        let driving = works.iter().filter(|(_, work)| drives(work));
        let names = driving.map(|(load, _)| Text::from(&mechanism.loads[*load].name));
        drives(&sum).then(|| text!("analysis-driving-loads", loads = list(names)))
    }
}

fn depends_on_time(value: &Value) -> bool {
    match value {
        Value::Table { over: Over::Time, .. } => true,
        Value::Formula { formula, .. } => formula.used().time,
        _ => false,
    }
}
