//! The samples of a motion from an initial state with everything that positions have, and left limits at the instants where it comes to
//! rest: dry resistance jumps there, and the sample itself has the right limit.

use std::sync::Arc;

use assur_dynamics::{Instant, equation};
use assur_force::{LoadState, Side, beside};
use assur_integrator::Sample;
use assur_number::Lanes;

use crate::filler::Filler;
use crate::results::{Column, Edges, Quantity, Schema, Table};
use crate::{Calculation, InputMotion, acting::Acting, angles::Angles, energies::by_load};

impl Calculation {
    /// A row for each sample of a transient motion, with its time, state, places, forces and reduced loads; beside them, at their times,
    /// the rows just before it comes to rest and is held, with the reduced loads. `None` for another motion.
    pub fn over_time(&self) -> Option<(Table, Edges)> {
        let InputMotion::Transient(found) = &self.motion else { return None };
        let columns = self.columns_of_motion();
        let mut filler = Filler::new(self, &columns, true);
        let (mut table, mut between) = (filler.table(), filler.table());
        for (block, instants) in found.instants.chunks(Lanes::WIDTH).enumerate() {
            let eight = std::array::from_fn(|lane| instants[lane.min(instants.len() - 1)]);
            filler.add(Lanes::WIDTH * block, &eight, instants.len(), &mut table);
        }
        let mut angles = Angles::new(table.schema());
        angles.follow(&self.linkage, &mut table);
        let mechanism = &self.linkage.mechanism;
        let mut schema = Schema::new(mechanism);
        let (section, by_load) = (schema.section(), by_load(mechanism, schema.loads.len()));
        schema.add(section, by_load.iter().map(|(owner, _)| Column::of(Quantity::ReducedLoad, *owner)));
        let (mut loads, mut places) = (Table::new(Arc::new(schema)), Vec::new());
        let mut samples = Vec::new();
        for (number, two) in found.instants.windows(2).enumerate() {
            let Some((instant, acting)) = self.before_rest(two) else { continue };
            samples.push(number + 1);
            filler.add(places.len(), &[instant; Lanes::WIDTH], 1, &mut between);
            loads.push(places.len(), by_load.iter().map(|(_, place)| Some(acting.each[*place])));
            places.push(instant.state.time);
        }
        angles.follow_at(&self.linkage, (&table, &samples), &mut between);
        between.join(&loads);
        Some((table, Edges { places, between, ending: filler.table() }))
    }

    /// The motion just before the second of two samples, and what acts there; `None` where the motion is not held at rest there.
    fn before_rest(&self, two: &[Instant]) -> Option<(Instant, Acting)> {
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
