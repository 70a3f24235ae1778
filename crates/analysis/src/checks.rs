//! The checks of the numbers.

use assur_check::{Subject, methods};
use assur_force::State;
use assur_results::CheckRow;

use crate::Study;

impl Study {
    /// Every check that applies to the scene; none where the plan leaves groups out.
    pub fn checks(&self) -> Vec<CheckRow> {
        if self.plan.is_partial() {
            return Vec::new();
        }
        let input = &self.linkage.mechanism.input;
        let coordinates = (0..input.positions).map(|index| input.coordinate(index));
        let first = self.analyzer.map_or(crate::DEFAULT_ANALYZER, |plugin| plugin.name);
        let subject = Subject {
            linkage: &self.linkage,
            loads: self.loads.as_ref().filter(|_| self.plan.forces),
            states: coordinates.map(|q| State::prescribed(&self.linkage.mechanism, q)).collect(),
            methods: methods(&self.linkage, first),
        };
        let rows = subject.checks().into_iter().map(|check| CheckRow {
            name: check.name.to_owned(),
            residual: check.residual,
            limit: check.limit,
            at: check.at,
            place: check.place,
            reason: check.reason.to_owned(),
            left_out: check.left_out,
            ok: check.ok,
        });
        rows.collect()
    }
}
