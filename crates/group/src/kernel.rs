//! The trait of an Assur group.

use assur_number::Real;

use crate::{Body, GroupError, GroupFrame, Wrench, derive_generally, health_generally, reactions_generally};

/// Up to which order transfer functions are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Places only (PF0).
    Place,
    /// Places and first derivatives (PF0, PF1).
    First,
    /// Places, first and second derivatives (PF0, PF1, PF2).
    Second,
}

/// A chain of zero mobility that can be solved on its own, built for one place in a mechanism.
///
/// Two methods are required. The others follow from the pairs of the group through one linear system; override them
/// only with closed forms, and test the closed form against the default.
///
/// `bodies` holds all bodies of the mechanism; those at the outer ends of the group are solved already. Nothing here
/// allocates.
pub trait AssurGroup<T: Real = f64>: std::fmt::Debug + Send + Sync {
    /// Links and pairs of the group.
    fn frame(&self) -> &GroupFrame;

    /// Places the links (PF0) in assembly `way`, 0 to [`ways`](Self::ways) - 1.
    ///
    /// On entry the bodies of the group hold a former or guessed place; a kind with closed forms does not look at it, a
    /// kind without them starts its iteration there. Returns the health: the dimensionless determinant of the group, 0
    /// at a singular position and at most about 1; its sign carries no meaning.
    ///
    /// # Errors
    ///
    /// [`GroupError::NoAssembly`] if no real assembly exists (with lanes: in any lane); [`GroupError::Singular`] if the
    /// place is not determined.
    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError>;

    /// In how many ways the group can be assembled.
    fn ways(&self) -> usize {
        1
    }

    /// PF1 and, for [`Order::Second`], PF2 of the placed links.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] where the linear system of the group cannot be solved.
    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        derive_generally(self.frame(), bodies, order)
    }

    /// [`place`](Self::place) and [`derive`](Self::derive) in one call, for the inner loop.
    ///
    /// # Errors
    ///
    /// As the two.
    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        let health = self.place(bodies, way)?;
        if order > Order::Place {
            self.derive(bodies, order)?;
        }
        Ok(health)
    }

    /// Dimensionless determinant of the placed group: 0 at a singular position.
    fn health(&self, bodies: &[Body<T>]) -> f64 {
        health_generally(self.frame(), bodies)
    }

    /// Least determinant that is not rounding: what the last places of the lengths make of one that is zero. Below it
    /// two ways of the group are one.
    ///
    /// The default is for determinants that are a square root of what the lengths say. `bodies` hold the placed group.
    fn resolution(&self, _bodies: &[Body<T>]) -> f64 {
        (256.0 * T::EPSILON).sqrt()
    }

    /// Reactions in all pairs of the group that balance the loads on its links.
    ///
    /// `loads`: one wrench for each body, about the origin of its frame; those of the group's links are read, and the
    /// reactions on the outer bodies are added to theirs. `reactions`: one for each pair of the chain; those of the
    /// group are written: on body `a` of the pair, about the pin or about the point of the sliding link.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] where the linear system of the group cannot be solved.
    fn reactions(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
    ) -> Result<(), GroupError> {
        reactions_generally(self.frame(), bodies, loads, reactions)
    }
}
