//! Loads of a prescribed motion that drive over the cycle: a resistance may have been meant.

use std::collections::BTreeMap;

use assur_force::{Cause, State, power};
use assur_group::Order;
use assur_mechanism::{LoadId, Motion, Range};
use assur_words::{Text, list, text};

use crate::Calculation;

/// Loads drive if their net work over the cycle is more than this part of all their work: the works of a constant force cancel, but for
/// what few positions leave.
const NET: f64 = 0.1;
/// The works are summed at so many places of the cycle: few positions of a scene say little of it.
const PLACES: u32 = 144;

impl Calculation {
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
            let coordinate = mechanism.input.from + way;
            self.linkage.solve(coordinate, Order::First, &mut position).ok()?;
            let state = State::prescribed(mechanism, position.coordinate);
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
