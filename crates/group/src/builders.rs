//! Builders of a kind's kernel, one for each number type.

use assur_number::{Dd, Intervals, Lanes, Real};

use crate::one_by_one::OneByOne;
use crate::{AssurGroup, BuildError, GroupFrame};

type Build<T> = fn(&GroupFrame) -> Result<Box<dyn AssurGroup<T>>, BuildError>;

/// One builder for each number type, made by [`Builders::of`] or [`Builders::in_lanes`].
#[derive(Debug, Clone, Copy)]
pub struct Builders {
    pub(crate) double: Build<f64>,
    pub(crate) single: Build<f32>,
    pub(crate) extended: Build<Dd>,
    pub(crate) lanes: Build<Lanes>,
    pub(crate) intervals: Build<Intervals>,
}

/// A kind of group whose formulas are generic over the number type.
pub trait GroupKind {
    /// The kernel in one number type.
    type Kernel<T: Number>: AssurGroup<T> + 'static;

    /// Builds the kernel of one group of a mechanism.
    ///
    /// # Errors
    ///
    /// [`BuildError`] if the lengths don't form a group of this kind.
    fn build<T: Number>(frame: &GroupFrame) -> Result<Self::Kernel<T>, BuildError>;
}

fn boxed<K: GroupKind, T: Number>(frame: &GroupFrame) -> Result<Box<dyn AssurGroup<T>>, BuildError> {
    Ok(Box::new(K::build::<T>(frame)?))
}

fn one_by_one<K: GroupKind>(frame: &GroupFrame) -> Result<Box<dyn AssurGroup<Lanes>>, BuildError> {
    Ok(Box::new(OneByOne(boxed::<K, f64>(frame)?)))
}

fn not_enclosed(_: &GroupFrame) -> Result<Box<dyn AssurGroup<Intervals>>, BuildError> {
    Err(BuildError::new("the formulas of this kind decide by single numbers"))
}

impl Builders {
    /// The builders of any kind: several positions are solved one by one, and none over intervals.
    pub const fn of<K: GroupKind>() -> Self {
        Self {
            double: boxed::<K, f64>,
            single: boxed::<K, f32>,
            extended: boxed::<K, Dd>,
            lanes: one_by_one::<K>,
            intervals: not_enclosed,
        }
    }

    /// The builders of a kind whose places come from one formula for all numbers, as closed forms do: several positions are
    /// solved at once, each with the bits that `f64` gets alone, and places are enclosed over intervals. A kernel that decides
    /// by its numbers what it calculates, such as an iteration, or the general solution by its choice of pivots, has none.
    pub const fn in_lanes<K: GroupKind>() -> Self {
        Self { lanes: boxed::<K, Lanes>, intervals: boxed::<K, Intervals>, ..Self::of::<K>() }
    }
}

/// A number type for which the kernels of groups can be built.
pub trait Number: Real {
    /// Builds the kernel of a group of this kind in this number type.
    ///
    /// # Errors
    ///
    /// [`BuildError`] if the lengths don't form a group of this kind.
    fn build(builders: &Builders, frame: &GroupFrame) -> Result<Box<dyn AssurGroup<Self>>, BuildError>;
}

macro_rules! number {
    ($type:ty, $field:ident) => {
        impl Number for $type {
            fn build(
                builders: &Builders,
                frame: &GroupFrame,
            ) -> Result<Box<dyn AssurGroup<Self>>, BuildError> {
                (builders.$field)(frame)
            }
        }
    };
}
number!(f64, double);
number!(f32, single);
number!(Dd, extended);
number!(Lanes, lanes);
number!(Intervals, intervals);
