//! Kernels with closed forms. Quantities that several formulas need in one position are computed once.

use assur_number::Real;

use crate::{AssurGroup, Body, BuildError, Forces, GroupError, GroupFrame, GroupKind, Number, Order, Wrench};

/// A group with closed forms; [`Closed`] makes an [`AssurGroup`] of it.
///
/// The formulas for places, derivatives and reactions share lengths and directions of one position, such as the
/// triangle of the pins. They are computed when the group is placed, or from links that are already placed.
pub trait ClosedForm<T: Real>: Sized + std::fmt::Debug + Send + Sync {
    /// The quantities of one position that the formulas share.
    type Position;

    /// Number of ways of assembly.
    const WAYS: usize;

    /// The formulas with the lengths of one group.
    fn new(frame: &GroupFrame) -> Result<Self, BuildError>;

    /// Places the links (PF0) in a way; returns the shared quantities.
    ///
    /// # Errors
    ///
    /// [`GroupError::NoAssembly`] if no real assembly exists (with lanes: in any lane); [`GroupError::Singular`] if the
    /// place is not determined.
    fn close(&self, bodies: &mut [Body<T>], way: usize) -> Result<Self::Position, GroupError>;

    /// The shared quantities of links that are already placed.
    fn read(&self, bodies: &[Body<T>]) -> Self::Position;

    /// Dimensionless determinant of a position: 0 at a singular one, at most about 1 elsewhere.
    fn health(&self, position: &Self::Position) -> T;

    /// Returns an error for a position in which derivatives and reactions are not determined.
    #[inline(always)]
    fn determined(&self, position: &Self::Position) -> Result<(), GroupError> {
        GroupError::if_singular(self.health(position))
    }

    /// Computes PF1 and, for [`Order::Second`], PF2 of the placed links; returns a number that is NaN where one of them is.
    fn differentiate(&self, bodies: &mut [Body<T>], position: &Self::Position, order: Order) -> T;

    /// Computes the reactions in all pairs, with the conventions of [`AssurGroup::reactions`]; returns a number that is NaN where
    /// one of them is.
    fn balance(&self, bodies: &[Body<T>], position: &Self::Position, forces: &mut Forces<'_, T>) -> T;

    /// Smallest determinant that is not rounding; see [`AssurGroup::resolution`].
    fn resolution(&self, _bodies: &[Body<T>]) -> f64 {
        (256.0 * T::EPSILON).sqrt()
    }
}

/// The kernel of a group with closed forms.
#[derive(Debug, Clone)]
pub struct Closed<K> {
    form: K,
    frame: GroupFrame,
}

impl<K> Closed<K> {
    /// The kernel of one group.
    pub fn new<T: Real>(frame: &GroupFrame) -> Result<Self, BuildError>
    where
        K: ClosedForm<T>,
    {
        Ok(Self { form: K::new(frame)?, frame: frame.clone() })
    }

    /// PF1 and PF2 where they are determined.
    #[inline(always)]
    fn differentiate<T: Real>(
        &self,
        bodies: &mut [Body<T>],
        position: &K::Position,
        order: Order,
    ) -> Result<(), GroupError>
    where
        K: ClosedForm<T>,
    {
        self.form.determined(position)?;
        GroupError::if_nan(self.form.differentiate(bodies, position, order))
    }
}

/// A kind of group with closed forms; its formulas in one number type may stand for it.
pub trait ClosedKind {
    /// Its formulas in one number type.
    type Form<T: Number>: ClosedForm<T> + 'static;
}

impl<K: ClosedKind> GroupKind for K {
    type Kernel<T: Number> = Closed<K::Form<T>>;

    fn build<T: Number>(frame: &GroupFrame) -> Result<Self::Kernel<T>, BuildError> {
        Closed::new(frame)
    }
}

impl<T: Real, K: ClosedForm<T>> AssurGroup<T> for Closed<K> {
    fn frame(&self) -> &GroupFrame {
        &self.frame
    }

    fn ways(&self) -> usize {
        K::WAYS
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        self.solve(bodies, way, Order::Place)
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        if order == Order::Place {
            return Ok(());
        }
        T::evaluate(
            #[inline(always)]
            move || self.differentiate(bodies, &self.form.read(bodies), order),
        )
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        T::evaluate(
            #[inline(always)]
            move || {
                let position = self.form.close(bodies, way)?;
                if order > Order::Place {
                    self.differentiate(bodies, &position, order)?;
                }
                Ok(self.form.health(&position))
            },
        )
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        self.form.health(&self.form.read(bodies)).least()
    }

    fn resolution(&self, bodies: &[Body<T>]) -> f64 {
        self.form.resolution(bodies)
    }

    // As one of several sets these would take a fifth longer.
    fn reactions(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
    ) -> Result<(), GroupError> {
        T::evaluate(
            #[inline(always)]
            move || {
                let position = self.form.read(bodies);
                self.form.determined(&position)?;
                GroupError::if_nan(self.form.balance(bodies, &position, &mut Forces { loads, reactions }))
            },
        )
    }

    fn reactions_under(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
        sets: usize,
    ) -> Result<(), GroupError> {
        T::evaluate(
            #[inline(always)]
            move || {
                let position = self.form.read(bodies);
                self.form.determined(&position)?;
                for mut forces in Forces::sets(loads, reactions, sets) {
                    GroupError::if_nan(self.form.balance(bodies, &position, &mut forces))?;
                }
                Ok(())
            },
        )
    }
}
