//! Kernels of closed forms: what they know of one position is worked out once for all that is asked of it.

use assur_number::Real;

use crate::{AssurGroup, Body, GroupError, GroupFrame, Order, Wrench};

/// A group with closed forms; [`Closed`] makes an [`AssurGroup`] of it.
///
/// The formulas for places, derivatives and reactions share lengths and directions of one position, such as the
/// triangle of the pins. They are found while the group is placed, or read from links that are placed already.
pub trait ClosedForm<T: Real>: std::fmt::Debug + Send + Sync {
    /// What the formulas share of one position.
    type Position;

    /// In how many ways the group can be assembled.
    const WAYS: usize;

    /// Links and pairs of the group.
    fn frame(&self) -> &GroupFrame;

    /// Places the links (PF0) in a way; the position and the health.
    ///
    /// # Errors
    ///
    /// [`GroupError::NoAssembly`] if no real assembly exists (with lanes: in any lane); [`GroupError::Singular`] if the
    /// place is not determined.
    fn close(&self, bodies: &mut [Body<T>], way: usize) -> Result<(Self::Position, T), GroupError>;

    /// The position of links that are placed already.
    fn read(&self, bodies: &[Body<T>]) -> Self::Position;

    /// Dimensionless determinant of a position: 0 at a singular one, and at most about 1.
    fn health(&self, position: &Self::Position) -> T;

    /// PF1 and, for [`Order::Second`], PF2 of the placed links.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] where they are not determined.
    fn differentiate(
        &self,
        bodies: &mut [Body<T>],
        position: &Self::Position,
        order: Order,
    ) -> Result<(), GroupError>;

    /// Reactions in all pairs, as [`AssurGroup::reactions`] says.
    ///
    /// # Errors
    ///
    /// [`GroupError::Singular`] where they are not determined.
    fn balance(
        &self,
        bodies: &[Body<T>],
        position: &Self::Position,
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
    ) -> Result<(), GroupError>;

    /// Least determinant that is not rounding, as [`AssurGroup::resolution`] says.
    fn resolution(&self, _bodies: &[Body<T>]) -> f64 {
        (256.0 * T::EPSILON).sqrt()
    }
}

/// The kernel of closed forms.
#[derive(Debug, Clone)]
pub struct Closed<K>(
    /// The formulas with the lengths of one group.
    pub K,
);

impl<T: Real, K: ClosedForm<T>> AssurGroup<T> for Closed<K> {
    fn frame(&self) -> &GroupFrame {
        self.0.frame()
    }

    fn ways(&self) -> usize {
        K::WAYS
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        self.0.close(bodies, way).map(|(_, health)| health)
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        if order == Order::Place {
            return Ok(());
        }
        self.0.differentiate(bodies, &self.0.read(bodies), order)
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        let (position, health) = self.0.close(bodies, way)?;
        if order > Order::Place {
            self.0.differentiate(bodies, &position, order)?;
        }
        Ok(health)
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        self.0.health(&self.0.read(bodies)).least()
    }

    fn resolution(&self, bodies: &[Body<T>]) -> f64 {
        self.0.resolution(bodies)
    }

    fn reactions(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
    ) -> Result<(), GroupError> {
        self.0.balance(bodies, &self.0.read(bodies), loads, reactions)
    }
}
