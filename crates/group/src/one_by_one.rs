//! Lanes of a kernel that can only decide for one position, such as an iteration.

use assur_number::{Lanes, Real};

use crate::{AssurGroup, Body, GroupError, GroupFrame, Order, Wrench};

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

    fn reactions(
        &self,
        bodies: &[Body<Lanes>],
        loads: &mut [Wrench<Lanes>],
        reactions: &mut [Wrench<Lanes>],
    ) -> Result<(), GroupError> {
        for lane in 0..Lanes::WIDTH {
            let of_lane = of_lane(bodies, lane);
            let mut own: [Vec<_>; 2] =
                [&*loads, &*reactions].map(|all| all.iter().map(|wrench| wrench.lane(lane)).collect());
            let [own_loads, own_reactions] = &mut own;
            self.0.reactions(&of_lane, own_loads, own_reactions)?;
            for (all, own) in [(&mut *loads, own_loads), (&mut *reactions, own_reactions)] {
                all.iter_mut().zip(own).for_each(|(all, own)| all.set_lane(lane, own));
            }
        }
        Ok(())
    }
}
