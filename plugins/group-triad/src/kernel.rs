//! The kernel of both classes: places, derivatives and reactions from the lines of the legs.

use std::any::TypeId;

use assur_group::plane::{length, minus, vector};
use assur_group::{
    AssurGroup, Body, BuildError, Forces, GroupError, GroupFrame, Mode, Order, Reading, SeenPair, Wrench,
};
use assur_number::{Lanes, Real};

use crate::leg::{Leg, Line};
use crate::matrix::{Inverse, Matrix};
use crate::mover::{Freedom, Hub, Mover};
use crate::{CONTOUR, TRIAD};

/// A condition is satisfied up to so many units of the last place of the size.
const ROUNDINGS: f64 = 64.0;

/// One group: a plate that legs hold against a base. In class III the base consists of the outer bodies, and the plate is
/// free; in class IV the base is a link of the group too, and base and plate have one freedom each.
#[derive(Debug, Clone)]
pub struct Legged<T> {
    pub(crate) frame: GroupFrame,
    pub(crate) legs: Vec<Leg<T>>,
    pub(crate) plate: Mover<T>,
    pub(crate) base: Option<Mover<T>>,
    /// Product of the sines of the guides of legs with two slides.
    pub(crate) spread: T,
    /// Violation of a condition that is rounding, m.
    pub(crate) rounding: f64,
}

/// The lines of all legs in one position, and what follows from them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lines<T> {
    pub(crate) each: [Line<T>; 3],
    pub(crate) plate: Hub<T>,
    pub(crate) base: Option<Hub<T>>,
    pub(crate) matrix: Matrix<T>,
}

impl<T: Real> Lines<T> {
    /// Whether all conditions are satisfied up to this violation, m or rad, in every lane.
    #[inline(always)]
    pub(crate) fn are_closed(&self, rounding: f64) -> bool {
        let limit = T::from_f64(rounding);
        self.each.iter().all(|line| (limit - line.gap.abs()).at_least(0.0))
    }

    /// The greatest violation, m or rad.
    pub(crate) fn open(&self) -> f64 {
        let gaps = self.each.iter().map(|line| line.gap.abs().to_f64());
        gaps.fold(0.0, |most, gap| if gap <= most { most } else { gap })
    }
}

impl<T: Real> Legged<T> {
    pub(crate) fn new(frame: &GroupFrame) -> Result<Self, BuildError> {
        let is_triad = frame.outer.len() == 3;
        let Reading { links, inner, outer } = if is_triad { TRIAD } else { CONTOUR }.read(frame)?;
        let (base, plate, legs) = if is_triad {
            let legs = (0..3).map(|k| Leg::new(links[k + 1], &outer[k], &inner[k]));
            (None, (links[0], None), legs.collect::<Result<Vec<_>, _>>()?)
        } else {
            let legs = (0..2).map(|k| Leg::new(links[k + 2], &inner[2 * k], &inner[2 * k + 1]));
            let held = |k: usize| (links[k], Some(&outer[k]));
            (Some(held(0)), held(1), legs.collect::<Result<Vec<_>, _>>()?)
        };
        let anchor = legs.first().map_or([T::ZERO; 2], |leg: &Leg<T>| leg.ends()[0]);
        let size = |end: usize, from: [T; 2]| {
            let far = legs.iter().map(|leg| length(minus(leg.ends()[end], from))).fold(0.0, f64::max);
            if far > 0.0 { far } else { frame.scale }
        };
        let held = |outer: Option<&SeenPair>| outer.map_or(anchor, |seen| vector(seen.pair.places()[0].1));
        // One size for both links: what is taken of a determinant by it must not depend on the row.
        let own = size(0, held(plate.1));
        let all = base.map_or(own, |base| own.max(size(1, held(base.1))));
        let plate = Mover::new(plate, anchor, all)?;
        let base = base.map(|base| Mover::new(base, anchor, all)).transpose()?;
        let spread = legs.iter().fold(T::ONE, |all, leg| all * leg.spread());
        let rounding = ROUNDINGS * T::EPSILON * frame.scale.max(all);
        Ok(Self { frame: frame.clone(), legs, plate, base, spread, rounding })
    }

    /// Violation of a condition that is rounding where base and plate are, m: far away places are rounded by their distance.
    pub(crate) fn rounding_at(&self, bodies: &[Body<T>]) -> f64 {
        let [base, plate] = self.core(bodies).map(|body| length(body.origin()));
        self.rounding * (base.max(plate) / self.frame.scale).max(1.0)
    }

    #[inline(always)]
    pub(crate) fn lines(&self, bodies: &[Body<T>]) -> Lines<T> {
        let plate = self.plate.hub(bodies);
        let base = self.base.as_ref().map(|base| base.hub(bodies));
        let mut lines = [Line::NONE; 3];
        let mut matrix = [[T::ZERO; 3]; 3];
        matrix[2][2] = T::ONE;
        for (k, leg) in self.legs.iter().enumerate() {
            lines[k] = leg.line(bodies);
            matrix[k] = self.row(&plate, base.as_ref(), &lines[k]);
        }
        Lines { each: lines, plate, base, matrix }
    }

    /// [`Self::lines`] with their determinant where one position is solved alone, compiled once for all its callers.
    #[inline(never)]
    pub(crate) fn lone_lines(&self, bodies: &[Body<T>]) -> (Lines<T>, T) {
        let lines = self.lines(bodies);
        (lines, self.measure(&lines))
    }

    /// What a line of action does on all freedoms: on the plate, with the opposite on the base.
    #[inline(always)]
    pub(crate) fn row(&self, plate: &Hub<T>, base: Option<&Hub<T>>, line: &Line<T>) -> [T; 3] {
        let on_plate = self.plate.column(plate, line);
        match (&self.base, base) {
            (Some(mover), Some(hub)) => [-mover.column(hub, line)[0], on_plate[0], T::ZERO],
            _ => on_plate,
        }
    }

    /// The dimensionless determinant, with its sign: of the lines of three legs as unit vectors, or of the shares of two legs
    /// in the freedoms of both links.
    #[inline(always)]
    pub(crate) fn measure(&self, lines: &Lines<T>) -> T {
        let size = |mover: &Mover<T>| match mover.freedom {
            Freedom::Shift(_) => T::ONE,
            _ => mover.inverse_size,
        };
        let mut rows = lines.matrix;
        let mut squares = T::ONE;
        for (row, line) in rows.iter_mut().zip(&lines.each).take(self.legs.len()) {
            // A moment has no length: it is taken as it is.
            let is_force = line.moment.to_f64() < 0.5;
            if let Some(base) = &self.base {
                if is_force {
                    (row[0], row[1]) = (row[0] * size(base), row[1] * size(&self.plate));
                }
                squares = squares * (T::ONE + row[0] * row[0] + row[1] * row[1]);
            } else {
                if is_force {
                    row[2] = row[2] * self.plate.inverse_size;
                }
                squares = squares * (row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
            }
        }
        Inverse::determinant(&rows) * self.spread / squares.sqrt()
    }

    #[inline(always)]
    pub(crate) fn finish(&self, bodies: &mut [Body<T>]) {
        self.legs.iter().for_each(|leg| leg.put(bodies));
    }

    /// The parts of base and plate in what belongs to their freedoms.
    #[inline(always)]
    pub(crate) fn parts(&self, u: [T; 3]) -> ([T; 3], [T; 3]) {
        match self.base {
            Some(_) => ([u[0], T::ZERO, T::ZERO], [u[1], T::ZERO, T::ZERO]),
            None => ([T::ZERO; 3], u),
        }
    }

    /// Sets PF1 or PF2 of base and plate for given rates of their freedoms.
    #[inline(always)]
    fn set(&self, bodies: &mut [Body<T>], lines: &Lines<T>, first: [T; 3], second: Option<[T; 3]>) {
        let (base, plate) = self.parts(first);
        let rates = second.map(|rates| self.parts(rates));
        if let (Some(mover), Some(hub)) = (&self.base, &lines.base) {
            mover.set(bodies, hub, base, rates.map(|(base, _)| base));
        }
        self.plate.set(bodies, &lines.plate, plate, rates.map(|(_, plate)| plate));
    }

    /// Places the legs, and sets what the order asks for.
    #[inline(always)]
    pub(crate) fn complete(
        &self,
        bodies: &mut [Body<T>],
        (lines, health): (&Lines<T>, T),
        order: Order,
    ) -> Result<T, GroupError> {
        self.put_legs(bodies)?;
        self.differentiate(bodies, lines, order)?;
        Ok(health.abs())
    }

    /// Places the legs; an error where a place is no number.
    #[inline(always)]
    pub(crate) fn put_legs(&self, bodies: &mut [Body<T>]) -> Result<(), GroupError> {
        self.finish(bodies);
        self.numbers(bodies, [T::ZERO; 3], |leg| leg.x + leg.y)
    }

    /// PF1 and PF2 at these lines.
    #[inline(always)]
    fn differentiate(
        &self,
        bodies: &mut [Body<T>],
        lines: &Lines<T>,
        order: Order,
    ) -> Result<(), GroupError> {
        if order == Order::Place {
            return Ok(());
        }
        let inverse = self.determined(lines)?;
        let zero = [T::ZERO; 3];
        self.set(bodies, lines, zero, None);
        let mut right = zero;
        for (k, leg) in self.legs.iter().enumerate() {
            right[k] = -leg.first(bodies, &lines.each[k]);
        }
        let first = inverse.solve(right);
        self.set(bodies, lines, first, None);
        self.legs.iter().for_each(|leg| leg.put_rates(bodies, 0));
        if order < Order::Second {
            return self.numbers(bodies, first, |leg| leg.x1 + leg.y1);
        }
        self.set(bodies, lines, first, Some(zero));
        for (k, leg) in self.legs.iter().enumerate() {
            right[k] = -leg.second(bodies, &lines.each[k]);
        }
        let second = inverse.solve(right);
        self.set(bodies, lines, first, Some(second));
        self.legs.iter().for_each(|leg| leg.put_rates(bodies, 1));
        self.numbers(bodies, first, |leg| leg.x1 + leg.y1)?;
        self.numbers(bodies, second, |leg| leg.x2 + leg.y2)
    }

    /// An error where a rate, or a number of a leg, is none.
    #[inline(always)]
    fn numbers(
        &self,
        bodies: &[Body<T>],
        rates: [T; 3],
        of: impl Fn(&Body<T>) -> T,
    ) -> Result<(), GroupError> {
        let start = rates[0] + rates[1] + rates[2];
        GroupError::if_nan(self.legs.iter().fold(start, |sum, leg| sum + of(&bodies[leg.link])))
    }

    /// An error where derivatives and reactions are not determined.
    #[inline(always)]
    pub(crate) fn determined(&self, lines: &Lines<T>) -> Result<Inverse<T>, GroupError> {
        let inverse = Inverse::of(&lines.matrix);
        GroupError::if_singular(self.measure(lines).abs())?;
        Ok(inverse)
    }
}

impl<T: Real> AssurGroup<T> for Legged<T> {
    fn frame(&self) -> &GroupFrame {
        &self.frame
    }

    /// Of the modes with this sign of the determinant, the one nearest to the poses on entry.
    fn ways(&self) -> usize {
        2
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        self.solve(bodies, way, Order::Place)
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        self.differentiate(bodies, &self.lone_lines(bodies).0, order)
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        self.solve_near(bodies, way, order)
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        self.lone_lines(bodies).1.abs().least()
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
                let lines = self.lines(bodies);
                let inverse = self.determined(&lines)?;
                let mut sets = Forces::sets(loads, reactions, sets);
                sets.try_for_each(|mut forces| self.balance(bodies, (&lines, &inverse), &mut forces))
            },
        )
    }

    fn lists_modes(&self) -> bool {
        true
    }

    fn modes(&self, bodies: &[Body<T>]) -> Result<Option<Vec<Mode<T>>>, GroupError> {
        // Lanes have modes of their own each.
        if TypeId::of::<T>() == TypeId::of::<Lanes>() { Ok(None) } else { self.listed(bodies).map(Some) }
    }
}
