//! Left limits at the instants where a transient motion comes to rest: dry resistance jumps there, and the sample itself has
//! the right limit.

use std::sync::Arc;

use assur_dynamics::{Instant, equation};
use assur_force::{LoadState, Side, beside};
use assur_integrator::Sample;
use assur_number::Lanes;

use crate::results::{Column, Quantity, Schema, Table};
use crate::{Calculation, InputMotion, acting::Acting, energies::by_load, filler::Filler};

impl Calculation {
    /// Left limits at the samples where a transient motion stops and is held: one row for each stop, under the number of its
    /// sample, with the columns of the samples and the reduced loads.
    pub fn stops(&self) -> Table {
        let InputMotion::Transient(found) = &self.motion else { return Table::default() };
        let columns = self.columns_of_motion();
        let mut filler = Filler::new(self, &columns, true);
        let mechanism = &self.linkage.mechanism;
        let mut schema = Schema::new(mechanism);
        let (section, by_load) = (schema.section(), by_load(mechanism, schema.loads.len()));
        schema.add(section, by_load.iter().map(|(owner, _)| Column::of(Quantity::ReducedLoad, *owner)));
        let (mut stops, mut loads) = (filler.table(), Table::new(Arc::new(schema)));
        for (before, two) in found.instants.windows(2).enumerate() {
            if let Some((instant, acting)) = self.before_rest(two) {
                filler.add(before + 1, &[instant; Lanes::WIDTH], 1, &mut stops);
                loads.push(before + 1, by_load.iter().map(|(_, place)| Some(acting.each[*place])));
            }
        }
        stops.join(&loads);
        stops
    }

    /// The motion just before the second of two samples, and what acts there; `None` where the motion is not held at rest there.
    pub(crate) fn before_rest(&self, two: &[Instant]) -> Option<(Instant, Acting)> {
        let (loads, [moving, rest]) = (self.loads.as_ref()?, [two[0].state, two[1].state]);
        let stops = moving.speed != 0.0 && rest.speed == 0.0 && matches!(rest.side, Side::Held { .. });
        let LoadState { time, coordinate, .. } = Some(rest).filter(|_| stops)?;
        let speed = beside(0.0, moving.speed.signum());
        let mut motion = equation(&self.linkage, loads).ok()?;
        let instant = motion.instant(&Sample { time, coordinate, speed, acceleration: 0.0 }, false).ok()?;
        let torque = motion.drive.torque(&instant.state);
        let bodies = motion.bodies(coordinate).ok()?;
        let acting =
            Acting::of(loads, &self.linkage.mechanism, &instant.state, bodies, [torque, instant.friction]);
        Some((instant, acting))
    }
}
