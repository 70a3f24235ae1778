//! Residuals of single positions and samples, as columns beside their results.

use std::borrow::Cow;

use assur_check::Check;

use super::{Analysis, Owner, Table};

/// What a residual of one position compares; relative to the size of what is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Residual {
    /// PF1, PF2 and J' against numerical differentiation: the largest deviation.
    TestPf,
    /// Sums of forces and moments on the links of a group: the largest.
    Equilibrium,
    /// The equation of motion of the input, written out over every load.
    Dynamics,
    /// The power of the balancing load against that of all loads and inertia loads.
    Global,
}

impl Residual {
    /// Its name: `group 0`, `global`.
    pub fn name(self, owner: Owner) -> Cow<'static, str> {
        match (self, owner) {
            (Self::Equilibrium, Owner::Group(group)) => format!("group {group}").into(),
            (Self::Equilibrium, _) => "equilibrium".into(),
            (Self::TestPf, _) => "TestPf".into(),
            (Self::Dynamics, _) => "dynamics".into(),
            (Self::Global, _) => "global".into(),
        }
    }
}

/// Checks, and the residuals of the positions and samples that they went through.
#[derive(Debug, Clone, PartialEq)]
pub struct Checks {
    /// The checks.
    pub all: Vec<Check>,
    /// Residuals of the checked positions; of very many positions a sample is checked.
    pub(crate) of_positions: Table,
    /// Residuals of the checked samples of a transient motion.
    pub(crate) of_trajectory: Table,
}

impl Checks {
    /// No checks.
    pub fn none() -> Self {
        Self { all: Vec::new(), of_positions: Table::default(), of_trajectory: Table::default() }
    }
}

impl Analysis {
    /// Adds the checks to the results, and the residuals to the rows of the positions and samples that were checked.
    pub fn add_checks(&mut self, checks: Checks) {
        let Checks { all, of_positions, of_trajectory } = checks;
        self.checks = all;
        self.survey.join(&self.positions, &of_positions);
        self.positions.join(&of_positions);
        self.trajectory.join(&of_trajectory);
        self.residuals = of_positions;
    }
}
