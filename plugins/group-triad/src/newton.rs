//! Newton's method on the conditions of the legs, from a pose near the wanted one.
//!
//! From a pose that is kept beside a position two steps are enough nearly everywhere: they are the same for one position and for
//! lanes, and a position that needs more is solved alone.

use std::any::TypeId;

use assur_group::{AssurGroup, Body, GroupError, Order};
use assur_number::{Lanes, ROUNDING, Real};

use crate::{kernel::Legged, matrix::Inverse};

/// Most steps from a pose near the wanted one.
const MOST_STEPS: usize = 12;

/// A second step of at most this part of the first shows that the root belongs to the start (Kantorovich: 1/2 would do for
/// exact steps), ...
const CONTRACTION: f64 = 0.25;

/// ... or one that is [`ROUNDING`] in rad or parts of the size, or below so many units of the last place.
const LAST_PLACES: f64 = 64.0;

/// The result of an iteration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Polished {
    pub(crate) converged: bool,
    /// Whether the root belongs to the start.
    is_near: bool,
    /// Length of the way, rad or parts of the size.
    pub(crate) way: f64,
}

/// Whether the first two steps show that the root belongs to the start, in every lane.
#[inline(always)]
fn is_near<T: Real>(before: T, size: T) -> bool {
    let tiny = T::from_f64(ROUNDING.max(LAST_PLACES * T::EPSILON));
    (T::from_f64(CONTRACTION) * before + tiny - size).at_least(0.0)
}

/// Whether a step after this one would be rounding, in every lane: of quadratic steps it is about size³ / before²; one of few
/// units of the last place is rounding itself.
#[inline(always)]
fn is_last<T: Real>(before: T, size: T) -> bool {
    let limit = T::from_f64(0.1 * T::EPSILON) * before * before;
    let least = T::from_f64((LAST_PLACES * T::EPSILON).powi(3));
    (limit + least - size * size * size).at_least(0.0)
}

impl<T: Real> Legged<T> {
    /// Places the group near the poses of its bodies and sets what the order asks for.
    #[inline]
    pub(crate) fn solve_near(
        &self,
        bodies: &mut [Body<T>],
        way: usize,
        order: Order,
    ) -> Result<T, GroupError> {
        if !self.spread.abs().at_least(ROUNDING) {
            return Err(GroupError::Singular { health: 0.0 });
        }
        if T::EPSILON < f64::EPSILON {
            // Numbers of more digits are references: what is fast for others would only be compiled once more.
            return self.solve_far(bodies, way, order);
        }
        let start = self.core(bodies);
        let near = T::evaluate(
            #[inline(always)]
            || self.in_two_steps(bodies, way, order),
        );
        if let Some(found) = near {
            return found;
        }
        self.put_core(&start, bodies);
        if TypeId::of::<T>() == TypeId::of::<Lanes>() {
            // Each lane is then solved alone.
            return Err(GroupError::NoAssembly { gap_m: 0.0 });
        }
        self.solve_far(bodies, way, order)
    }

    /// Two steps with all that follows; `None` where they are not enough, in any lane.
    #[inline(always)]
    fn in_two_steps(
        &self,
        bodies: &mut [Body<T>],
        way: usize,
        order: Order,
    ) -> Option<Result<T, GroupError>> {
        self.settle(bodies);
        let before = self.step(bodies);
        let size = self.step(bodies);
        if !is_near(before, size) || !is_last(before, size) {
            return None;
        }
        let lines = self.lines(bodies);
        let health = self.measure(&lines);
        let is_of_way = if way == 0 { health } else { -health }.exceeds(0.0);
        let is_found = is_of_way && lines.are_closed(self.rounding);
        is_found.then(|| self.complete(bodies, (&lines, health), order))
    }

    /// The same with as many steps as it takes, or in another mode of the way.
    #[cold]
    fn solve_far(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        let start = self.core(bodies);
        let polished = self.polish(bodies);
        let is_found = polished.converged && polished.is_near && {
            let (lines, health) = self.lone_lines(bodies);
            (health.to_f64() > 0.0) == (way == 0) && lines.open() <= self.rounding_at(bodies)
        };
        if !is_found {
            self.put_core(&start, bodies);
            self.place_far(bodies, &start, way)?;
        }
        let health = self.lone_lines(bodies).1;
        if health.to_f64().is_nan() {
            return Err(GroupError::Singular { health: f64::NAN });
        }
        self.put_legs(bodies)?;
        if order > Order::Place {
            self.derive(bodies, order)?;
        }
        Ok(health.abs())
    }

    /// One step: its size in rad and parts of the size of the links.
    #[inline(always)]
    pub(crate) fn step(&self, bodies: &mut [Body<T>]) -> T {
        let found = self.lines(bodies);
        let inverse = Inverse::of(&found.matrix);
        let (own, other) = self.parts(inverse.solve(found.each.map(|line| -line.gap)));
        self.plate.step(bodies, &found.plate, other);
        let size = self.plate.size_of(other);
        let (Some(base), Some(hub)) = (&self.base, &found.base) else { return size };
        base.step(bodies, hub, own);
        base.size_of(own) + size
    }

    /// [`Self::step`] where one position is solved alone, compiled once for all its callers.
    #[inline(never)]
    pub(crate) fn lone_step(&self, bodies: &mut [Body<T>]) -> T {
        self.step(bodies)
    }

    /// Satisfies the outer pairs of base and plate.
    #[inline(always)]
    pub(crate) fn settle(&self, bodies: &mut [Body<T>]) {
        if let Some(base) = &self.base {
            base.settle(bodies);
        }
        self.plate.settle(bodies);
    }

    /// Newton's method from the pose of the bodies, of one position.
    pub(crate) fn polish(&self, bodies: &mut [Body<T>]) -> Polished {
        self.settle(bodies);
        let mut before = self.lone_step(bodies);
        let mut found = Polished { converged: false, is_near: false, way: before.to_f64() };
        for step in 1..MOST_STEPS {
            let size = self.lone_step(bodies);
            found.way += size.to_f64();
            if found.way.is_nan() || found.way > 1e3 {
                return Polished { converged: false, is_near: false, way: f64::INFINITY };
            }
            if step == 1 {
                found.is_near = is_near(before, size);
            }
            if is_last(before, size) {
                return Polished { converged: true, ..found };
            }
            if step > 2 && size.to_f64() >= 0.9 * before.to_f64() && size.to_f64() < 1e6 * T::EPSILON {
                return Polished { converged: true, is_near: false, ..found };
            }
            before = size;
        }
        Polished { converged: before.to_f64() < T::EPSILON.sqrt(), is_near: false, ..found }
    }
}
