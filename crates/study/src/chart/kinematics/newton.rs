//! The general solution: derivatives from the one linear system of a group, and places by Newton's method.

use std::hint::black_box;

use assur_group::{Body, Number, Order, derive_generally, place_by_newton};
use assur_kinematics::{Chain, ChainError};

use super::{extended, failure, groups_of};
use crate::chart::entry::{Contestant, Verdict};
use crate::chart::work::Work;

/// How far back Newton's method begins, rad or parts of the scale: a mechanism followed in some 300 steps a turn.
const BACK: f64 = 0.02;

/// Where the places come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Places {
    /// Closed forms.
    Closed,
    /// Newton's method on the constraints.
    Newton,
}

pub(super) struct General<'a, T: Number> {
    work: &'a Work<'a>,
    chain: Chain<T>,
    places: Places,
    /// Where Newton's method begins, by position.
    starts: Vec<Vec<Body<T>>>,
    bodies: Vec<Body<T>>,
}

impl<'a, T: Number> General<'a, T> {
    pub(super) fn new(work: &'a Work<'a>, chain: Chain<T>, places: Places) -> Self {
        let starts = work.coordinates.iter().map(|q| start(work, &chain, *q)).collect();
        Self { work, bodies: chain.bodies(), chain, places, starts }
    }

    fn solve(&mut self, index: usize, q: f64) -> Result<(), ChainError> {
        let ways = self.work.linkage.ways.at(q);
        self.chain.set_input(T::from_f64(q), &mut self.bodies);
        for (group, kernel) in self.chain.groups.iter().enumerate() {
            let frame = kernel.frame();
            let placed = match self.places {
                Places::Closed => kernel.place(&mut self.bodies, usize::from(ways[group])),
                Places::Newton => {
                    for link in &frame.links {
                        self.bodies[*link] = self.starts[index][*link];
                    }
                    place_by_newton(frame, &mut self.bodies)
                }
            };
            let solved = placed.and_then(|_| derive_generally(frame, &mut self.bodies, Order::Second));
            solved.map_err(|source| ChainError { group, source })?;
        }
        Ok(())
    }
}

/// The bodies a little before a position, in the number of the chain.
fn start<T: Number>(work: &Work<'_>, chain: &Chain<T>, q: f64) -> Vec<Body<T>> {
    let linkage = work.linkage;
    let unit = linkage.coordinate_unit();
    let mut position = linkage.position();
    // At the end of the range there is nothing before; beyond lies the same.
    let solved = [-BACK, BACK, 0.0]
        .iter()
        .any(|back| linkage.solve(q + back * unit, Order::Place, &mut position).is_ok());
    let mut bodies = chain.bodies();
    if solved {
        for (to, from) in bodies.iter_mut().zip(&position.bodies) {
            (to.x, to.y) = (T::from_f64(from.x), T::from_f64(from.y));
            (to.c, to.s) = (T::from_f64(from.c), T::from_f64(from.s));
        }
    }
    bodies
}

impl<T: Number> Contestant for General<'_, T> {
    fn run(&mut self) {
        let work = self.work;
        for (index, q) in work.coordinates.iter().enumerate() {
            let _ = black_box(self.solve(index, *q));
        }
    }

    fn judge(&mut self) -> Verdict {
        let work = self.work;
        work.verdict(groups_of(work.linkage), |index, q| {
            self.solve(index, q).map_err(|error| failure(work.linkage, q, &error))?;
            Ok(extended(&self.bodies))
        })
    }
}
