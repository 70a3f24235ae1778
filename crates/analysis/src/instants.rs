//! The samples of a motion from an initial state with everything that positions have: what is drawn of such a motion.

use assur_number::Lanes;

use crate::filler::Filler;
use crate::results::{Edges, Table};
use crate::{Calculation, InputMotion, angles::Angles};

impl Calculation {
    /// A row for each sample of a transient motion, with its time, state, places, forces and reduced loads, and beside them the rows
    /// just before it comes to rest, whose places are times; `None` for another motion.
    pub fn over_time(&self) -> Option<(Table, Edges)> {
        let InputMotion::Transient(found) = &self.motion else { return None };
        let columns = self.columns_of_motion();
        let mut filler = Filler::new(self, &columns, true);
        let (mut table, mut between) = (filler.table(), filler.table());
        for (block, instants) in found.instants.chunks(Lanes::WIDTH).enumerate() {
            let eight = std::array::from_fn(|lane| instants[lane.min(instants.len() - 1)]);
            filler.add(Lanes::WIDTH * block, &eight, instants.len(), &mut table);
        }
        Angles::new(table.schema()).follow(&self.linkage, &mut table);
        let mut places = Vec::new();
        for two in found.instants.windows(2) {
            if let Some((instant, _)) = self.before_rest(two) {
                filler.add(places.len(), &[instant; Lanes::WIDTH], 1, &mut between);
                places.push(instant.state.time);
            }
        }
        Some((table, Edges { places, between, ending: filler.table() }))
    }
}
