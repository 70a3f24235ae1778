//! Builders of a kind's kernel, one for each number type.

use assur_number::{Dd, Intervals, Lanes, Real};
use assur_words::text;

use crate::driven::Merged;
use crate::{AssurGroup, Body, BuildError, GroupError, GroupFrame, Order, Wrench};

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
    fn build<T: Number>(frame: &GroupFrame) -> Result<Self::Kernel<T>, BuildError>;
}

fn boxed<K: GroupKind, T: Number>(frame: &GroupFrame) -> Result<Box<dyn AssurGroup<T>>, BuildError> {
    Ok(Box::new(K::build::<T>(frame)?))
}

fn one_by_one<K: GroupKind>(frame: &GroupFrame) -> Result<Box<dyn AssurGroup<Lanes>>, BuildError> {
    Ok(in_each_lane(boxed::<K, f64>(frame)?))
}

fn in_each_lane(kernel: Box<dyn AssurGroup<f64>>) -> Box<dyn AssurGroup<Lanes>> {
    Box::new(OneByOne(kernel))
}

fn not_enclosed(_: &GroupFrame) -> Result<Box<dyn AssurGroup<Intervals>>, BuildError> {
    Err(BuildError::new(text!("group-single-numbers")))
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

    /// The builders of a kind that iterates from near poses by the same few steps in each lane: several positions are solved at
    /// once, each with the bits that `f64` gets alone, and its kernel in lanes gives [`GroupError::NoAssembly`] where that would
    /// not be so; none over intervals.
    pub const fn near_in_lanes<K: GroupKind>() -> Self {
        Self { lanes: boxed::<K, Lanes>, ..Self::of::<K>() }
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
    fn build(builders: &Builders, frame: &GroupFrame) -> Result<Box<dyn AssurGroup<Self>>, BuildError>;
}

macro_rules! number {
    ($type:ty, $field:ident, $driven:expr) => {
        impl Number for $type {
            fn build(
                builders: &Builders,
                frame: &GroupFrame,
            ) -> Result<Box<dyn AssurGroup<Self>>, BuildError> {
                if frame.driven.is_empty() { (builders.$field)(frame) } else { $driven(builders, frame) }
            }
        }
    };
}
number!(f64, double, merged);
number!(f32, single, merged);
number!(Dd, extended, merged);
number!(Lanes, lanes, |builders, frame| Ok(in_each_lane(merged(builders, frame)?)));
number!(Intervals, intervals, |_, frame| not_enclosed(frame));

/// The kernel of a group with driven pairs.
fn merged<T: Number>(builders: &Builders, frame: &GroupFrame) -> Result<Box<dyn AssurGroup<T>>, BuildError> {
    Ok(Box::new(Merged::new(builders, frame)?))
}

/// A kernel that treats the lanes one after the other by a kernel for a single position, and so gives each lane the bits
/// of its position alone. It allocates.
#[derive(Debug)]
pub(crate) struct OneByOne(pub(crate) Box<dyn AssurGroup<f64>>);

impl OneByOne {
    /// Treats the bodies of each lane; the links of the group are changed.
    fn each(
        &self,
        bodies: &mut [Body<Lanes>],
        treat: impl Fn(&mut [Body<f64>]) -> Result<f64, GroupError>,
    ) -> Result<Lanes, GroupError> {
        let mut health = Lanes::ZERO;
        for lane in 0..Lanes::WIDTH {
            let mut own = of_lane(bodies, lane);
            health.0[lane] = treat(&mut own)?;
            for &link in &self.0.frame().links {
                bodies[link].set_lane(lane, &own[link]);
            }
        }
        Ok(health)
    }
}

fn of_lane(bodies: &[Body<Lanes>], lane: usize) -> Vec<Body<f64>> {
    bodies.iter().map(|body| body.lane(lane)).collect()
}

impl AssurGroup<Lanes> for OneByOne {
    fn frame(&self) -> &GroupFrame {
        self.0.frame()
    }

    fn ways(&self) -> usize {
        self.0.ways()
    }

    fn place(&self, bodies: &mut [Body<Lanes>], way: usize) -> Result<Lanes, GroupError> {
        self.each(bodies, |bodies| self.0.place(bodies, way))
    }

    fn derive(&self, bodies: &mut [Body<Lanes>], order: Order) -> Result<(), GroupError> {
        self.each(bodies, |bodies| self.0.derive(bodies, order).map(|()| 0.0)).map(|_| ())
    }

    fn solve(&self, bodies: &mut [Body<Lanes>], way: usize, order: Order) -> Result<Lanes, GroupError> {
        self.each(bodies, |bodies| self.0.solve(bodies, way, order))
    }

    fn health(&self, bodies: &[Body<Lanes>]) -> f64 {
        Lanes::of(|lane| self.0.health(&of_lane(bodies, lane))).least()
    }

    fn resolution(&self, bodies: &[Body<Lanes>]) -> f64 {
        Lanes::of(|lane| self.0.resolution(&of_lane(bodies, lane))).greatest()
    }

    fn reactions_under(
        &self,
        bodies: &[Body<Lanes>],
        loads: &mut [Wrench<Lanes>],
        reactions: &mut [Wrench<Lanes>],
        sets: usize,
    ) -> Result<(), GroupError> {
        for lane in 0..Lanes::WIDTH {
            let of_lane = of_lane(bodies, lane);
            let mut own: [Vec<_>; 2] =
                [&*loads, &*reactions].map(|all| all.iter().map(|wrench| wrench.lane(lane)).collect());
            let [own_loads, own_reactions] = &mut own;
            self.0.reactions_under(&of_lane, own_loads, own_reactions, sets)?;
            for (all, own) in [(&mut *loads, own_loads), (&mut *reactions, own_reactions)] {
                all.iter_mut().zip(own).for_each(|(all, own)| all.set_lane(lane, own));
            }
        }
        Ok(())
    }
}
