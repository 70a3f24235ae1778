//! The trait of an Assur group.

use assur_number::Real;

use crate::{
    Body, GroupError, GroupFrame, Order, Wrench, derive_generally, health_generally, reactions_generally,
};

/// One real assembly of a group at the poses of the bodies around it.
#[derive(Debug, Clone)]
pub struct Mode<T: Real> {
    /// The links, in the order of [`GroupFrame::links`]; places alone.
    pub bodies: Vec<Body<T>>,
    /// The way in which [`AssurGroup::place`] finds it, from these poses.
    pub way: usize,
    /// Its dimensionless determinant, not negative.
    pub health: f64,
}

/// A chain of zero mobility that can be solved on its own, built for one place in a mechanism.
///
/// Two methods are required. The others are computed from the pairs of the group through one linear system; override
/// them only with closed forms, and test these against the default.
///
/// `bodies` holds all bodies of the mechanism; the outer bodies of the group are already solved. No method allocates.
pub trait AssurGroup<T: Real = f64>: std::fmt::Debug + Send + Sync {
    /// Links and pairs of the group.
    fn frame(&self) -> &GroupFrame;

    /// Places the links (PF0) in assembly `way`, 0 to [`ways`](Self::ways) - 1.
    ///
    /// On entry the links of the group hold a previous or guessed pose. Kinds with closed forms ignore it; iterating
    /// kinds start from it. Returns the health: the dimensionless determinant of the group, 0 at a singular position
    /// and at most about 1 elsewhere; its sign has no meaning.
    ///
    /// # Errors
    ///
    /// [`GroupError::NoAssembly`] if no real assembly exists (with lanes: in any lane, or where lanes would have
    /// to be treated differently; they are then placed one at a time); [`GroupError::Singular`] if the
    /// place is not determined.
    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError>;

    /// Number of ways of assembly. A kind that iterates may have two: in way 0 it finds modes with a positive determinant, in
    /// way 1 those with a negative one. Two modes that meet have opposite signs, so that the way tells them apart.
    fn ways(&self) -> usize {
        1
    }

    /// Whether [`modes`](Self::modes) lists them.
    fn lists_modes(&self) -> bool {
        false
    }

    /// All real assemblies at the present poses of the outer bodies, in the order that the kind documents; `None` where the
    /// kind can't list them. It need not answer where it doesn't iterate: its ways are its modes then.
    ///
    /// # Errors
    ///
    /// [`GroupError::NoAssembly`] where there is none; [`GroupError::Singular`] where there is no end of them.
    fn modes(&self, _bodies: &[Body<T>]) -> Result<Option<Vec<Mode<T>>>, GroupError> {
        Ok(None)
    }

    /// Computes PF1 and, for [`Order::Second`], PF2 of the placed links.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] where the linear system of the group cannot be solved.
    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        derive_generally(self.frame(), bodies, order)
    }

    /// Calls [`place`](Self::place) and [`derive`](Self::derive); closed forms share their intermediate results.
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

    /// Smallest determinant that is not rounding: the value that rounding of the lengths can give to a determinant
    /// that is exactly zero. Below it, two ways of the group coincide.
    ///
    /// The default holds for determinants that are the square root of a difference of lengths. `bodies` holds the
    /// placed group.
    fn resolution(&self, _bodies: &[Body<T>]) -> f64 {
        (256.0 * T::EPSILON).sqrt()
    }

    /// Computes the reactions in all pairs of the group, which balance the loads on its links.
    ///
    /// `loads` has one wrench for each body, about the origin of its frame. Those of the group's links are read; the
    /// reactions on the outer bodies are added to theirs. `reactions` has one wrench for each pair of the chain.
    /// Those of the group are written: they act on body `a` of the pair, with the moment about the pin or about the
    /// sliding link's point on the guide.
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
        self.reactions_under(bodies, loads, reactions, 1)
    }

    /// Computes the reactions under several sets of loads: `loads` and `reactions` hold, set after set, what
    /// [`reactions`](Self::reactions) takes, which asks for those under one. What does not depend on loads is shared.
    fn reactions_under(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
        sets: usize,
    ) -> Result<(), GroupError> {
        reactions_generally(self.frame(), bodies, loads, reactions, sets)
    }
}
