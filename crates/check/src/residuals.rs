//! The residuals of single positions, as curves over the cycle (S figs. 14, 16 and 18).

use assur_number::greater;

/// Residuals of the positions and states that were checked. A position that can't be checked is left out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Residuals {
    /// By the number of the position, the largest deviation of PF1, PF2 and J' from numerical differentiation, relative to
    /// what is compared.
    pub test_pf: Vec<(usize, f64)>,
    /// Residuals of the forces, by the number of the state.
    pub forces: Vec<ForceResiduals>,
}

/// How exactly the forces of one state are found.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceResiduals {
    /// Number of the state.
    pub number: usize,
    /// By group in solving order, the largest sum of forces and moments on one of its links, relative to all loads and the
    /// largest reaction.
    pub groups: Vec<f64>,
    /// Sum of the equation of motion M + Q - J e - J' w^2/2, relative to its terms; M is the load of the drive, where the motion is
    /// prescribed the balancing load.
    pub dynamics: f64,
    /// Difference of the balancing load and the load of the drive; where the motion is prescribed, sum of the powers of all loads
    /// and inertia loads and of the balancing load. Relative to the terms.
    pub global: f64,
}

/// The greatest of some residuals; NaN if any is, because a residual without a value must not be hidden by others.
pub(crate) fn greatest(residuals: impl IntoIterator<Item = f64>) -> f64 {
    residuals.into_iter().fold(0.0, greater)
}
