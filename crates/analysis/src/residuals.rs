//! Residuals of the checks as tables.

use std::collections::BTreeMap;
use std::sync::Arc;

use assur_check::{ForceResiduals, Residuals};

use crate::Calculation;
use crate::results::{Column, Owner, Quantity, Residual, Schema, Table};

impl Calculation {
    /// The residuals as columns: those of positions, and those of the samples of a transient motion, whose forces are
    /// checked there.
    pub(crate) fn residual_tables(&self, found: &Residuals, forces_of_samples: bool) -> [Table; 2] {
        // A scene with `[output]` asks for something else.
        if !self.plan.all {
            return [Table::default(), Table::default()];
        }
        let (test_pf, forces) = (found.test_pf.as_slice(), found.forces.as_slice());
        if forces_of_samples {
            return [self.residual_table(test_pf, &[]), self.residual_table(&[], forces)];
        }
        [self.residual_table(test_pf, forces), Table::default()]
    }

    fn residual_table(&self, test_pf: &[(usize, f64)], forces: &[ForceResiduals]) -> Table {
        let mut schema = Schema::new(&self.linkage.mechanism);
        let column = |of, owner| Column::of(Quantity::Residual(of), owner);
        let groups = 0..self.linkage.structure.groups.len();
        if !test_pf.is_empty() {
            let section = schema.section();
            schema.add(section, [column(Residual::TestPf, Owner::Input)]);
        }
        if !forces.is_empty() {
            let section = schema.section();
            schema.add(section, groups.clone().map(|i| column(Residual::Equilibrium, Owner::Group(i))));
            let of_input = [Residual::Dynamics, Residual::Global];
            schema.add(section, of_input.map(|of| column(of, Owner::Input)));
        }
        let mut rows: BTreeMap<usize, (Option<f64>, Option<&ForceResiduals>)> = BTreeMap::new();
        // A residual that is not finite fails its check; a table holds finite numbers only.
        for (number, residual) in test_pf.iter().filter(|(_, residual)| residual.is_finite()) {
            rows.entry(*number).or_default().0 = Some(*residual);
        }
        for found in forces {
            let mut all = found.groups.iter().chain([&found.dynamics, &found.global]);
            if all.all(|residual| residual.is_finite()) {
                rows.entry(found.number).or_default().1 = Some(found);
            }
        }
        let mut table = Table::new(Arc::new(schema));
        for (number, (deviation, found)) in rows {
            let of_forces = groups.clone().map(|group| found.map(|found| found.groups[group]));
            let of_input = [found.map(|found| found.dynamics), found.map(|found| found.global)];
            let of_forces = of_forces.chain(of_input).filter(|_| !forces.is_empty());
            table.push(number, (!test_pf.is_empty()).then_some(deviation).into_iter().chain(of_forces));
        }
        table
    }
}
