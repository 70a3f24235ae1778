//! What happens to the modes of a group between two coordinates next to each other: they meet, begin, end, or go on.

use assur_group::Mode;
use assur_number::elementary;

use crate::modes::nearest_first;

use super::{CourseEnd, FAR_AWAY, FARTHEST, ModeMeeting, PAIR, TOGETHER, UNSIGNED, Walk, is_turned};

/// Modes on both sides of an event; which of those before are left, and the numbers of those after it, as far as they are known.
struct Sides<'a> {
    before: &'a [(usize, Mode<f64>)],
    after: &'a [Mode<f64>],
    left: Vec<bool>,
    numbers: Vec<Option<usize>>,
}

impl Sides<'_> {
    fn go_on(&mut self, [at, next]: [usize; 2]) {
        self.left[at] = false;
        self.numbers[next] = Some(self.before[at].0);
    }

    /// The modes before and after the event that are left.
    fn rest(&self) -> [Vec<usize>; 2] {
        let before = (0..self.before.len()).filter(|at| self.left[*at]).collect();
        [before, (0..self.after.len()).filter(|next| self.numbers[*next].is_none()).collect()]
    }
}

impl Walk<'_> {
    /// What happens between the present coordinate and the next one, next to it; the numbers of the next modes.
    pub(super) fn event(&mut self, to: f64, next: Option<&[Mode<f64>]>) -> Option<Vec<usize>> {
        let now = self.now.1.take();
        let (Some(now), Some(next)) = (&now, next) else {
            now.iter().flatten().for_each(|(number, _)| self.end(*number, CourseEnd::Barrier));
            return next.map(|next| next.iter().map(|_| self.begin(to, CourseEnd::Barrier)).collect());
        };
        let (left, numbers) = (vec![true; now.len()], vec![None; next.len()]);
        let mut sides = Sides { before: now, after: next, left, numbers };
        // What hardly moves goes on. Only of what is left two can have met and vanished, or begin: they run the faster the nearer
        // they are to that.
        self.go_on(&mut sides, 2.0 * TOGETHER, true);
        self.pass(to, &mut sides);
        self.begin_and_end_in_pairs(to, &mut sides);
        self.go_on(&mut sides, FARTHEST, true);
        self.turn_over(to, &mut sides);
        let [before, after] = sides.rest();
        let each = before.iter().map(|at| &now[*at].1).chain(after.iter().map(|at| &next[*at]));
        self.is_lost |= each.into_iter().any(|mode| !is_far(mode, self.scale()));
        for at in before {
            self.end(now[at].0, CourseEnd::Infinity);
        }
        let numbers = sides.numbers.into_iter();
        Some(numbers.map(|known| known.unwrap_or_else(|| self.begin(to, CourseEnd::Infinity))).collect())
    }

    /// Modes that are left go on where they are, the nearest first; those that did.
    fn go_on(&self, sides: &mut Sides<'_>, limit: f64, keeps_way: bool) -> Vec<usize> {
        let [before, after] = sides.rest();
        let pairs = before.iter().flat_map(|at| after.iter().map(move |next| [*at, *next]));
        let apart = |[at, next]: [usize; 2]| {
            let [one, other] = [&sides.before[at].1, &sides.after[next]];
            let fits = (!keeps_way || one.way == other.way) && !is_turned(one, other, self.scale());
            fits.then(|| self.apart(one, other))
        };
        let taken = nearest_first(pairs, apart, limit, |[a, b], [c, d]| a == c || b == d);
        for pair in &taken {
            sides.go_on(*pair);
        }
        taken.into_iter().map(|[at, _]| sides.before[at].0).collect()
    }

    /// Two modes that meet and both go on: past the meeting each has the opposite sign of its determinant, so that each was
    /// taken for the other one.
    fn pass(&mut self, to: f64, sides: &mut Sides<'_>) {
        let known = (0..sides.after.len()).filter(|next| sides.numbers[*next].is_some());
        for [j, k] in self.pairs(|at| &sides.after[at], &known.collect::<Vec<_>>(), TOGETHER) {
            let (Some(one), Some(other)) = (sides.numbers[j], sides.numbers[k]) else { continue };
            let before = sides.before.iter().find(|(number, _)| *number == one);
            if before.is_some_and(|(_, mode)| self.is_passed(to, mode)) {
                self.found.meetings.push(ModeMeeting { at: to, ways: [other, one] });
                (sides.numbers[j], sides.numbers[k]) = (Some(other), Some(one));
            }
        }
    }

    /// Of the modes that are left, two that are next to each other end or begin together.
    fn begin_and_end_in_pairs(&mut self, to: f64, sides: &mut Sides<'_>) {
        let [before, after] = sides.rest();
        for [a, b] in self.pairs(|at| &sides.before[at].1, &before, PAIR) {
            (sides.left[a], sides.left[b]) = (false, false);
            self.end(sides.before[a].0, CourseEnd::With(sides.before[b].0));
            self.end(sides.before[b].0, CourseEnd::With(sides.before[a].0));
        }
        for [j, k] in self.pairs(|at| &sides.after[at], &after, PAIR) {
            let [one, other] = [0, 1].map(|_| self.begin(to, CourseEnd::Cycle));
            for (number, partner) in [(one, other), (other, one)] {
                self.found.modes[number].begins = CourseEnd::With(partner);
            }
            (sides.numbers[j], sides.numbers[k]) = (Some(one), Some(other));
        }
    }

    /// Where a group can turn freely, each of its two modes goes on with the other sign of its determinant.
    fn turn_over(&mut self, to: f64, sides: &mut Sides<'_>) {
        let turned = self.go_on(sides, TOGETHER, false);
        let meeting = |pair: &[usize]| ModeMeeting { at: to, ways: [pair[0], pair[1]] };
        self.found.meetings.extend(turned.chunks_exact(2).map(meeting));
    }

    /// Whether a mode meets another one before the next coordinate: its determinant, which falls evenly, is zero there.
    fn is_passed(&self, to: f64, mode: &Mode<f64>) -> bool {
        let back = self.modes_at(self.now.0 - (to - self.now.0)).unwrap_or_default();
        let back: Vec<(usize, Mode<f64>)> = back.into_iter().enumerate().collect();
        let earlier = self.nearest(&back, mode).filter(|(_, moved)| *moved < 2.0 * TOGETHER);
        earlier.is_some_and(|(at, _)| mode.health < back[at].1.health - mode.health)
    }

    /// Pairs of modes that are about to meet.
    fn pairs<'m>(&self, mode: impl Fn(usize) -> &'m Mode<f64>, all: &[usize], limit: f64) -> Vec<[usize; 2]> {
        let both =
            all.iter().enumerate().flat_map(|(k, one)| all[k + 1..].iter().map(|other| [*one, *other]));
        let apart = |[one, other]: [usize; 2]| {
            let [one, other] = [mode(one), mode(other)];
            let meets = one.way != other.way || is_unsigned(one) || is_unsigned(other);
            meets.then(|| self.apart(one, other))
        };
        nearest_first(both, apart, limit, |[a, b], [c, d]| [a, b].contains(&c) || [a, b].contains(&d))
    }
}

/// Whether a link is so far away that it may run to infinity.
fn is_far(mode: &Mode<f64>, scale: f64) -> bool {
    mode.bodies.iter().any(|body| elementary::hypot(body.x, body.y) > FAR_AWAY * scale)
}

/// Whether the sign of a determinant, and so its way, may be rounding.
fn is_unsigned(mode: &Mode<f64>) -> bool {
    mode.health < UNSIGNED
}
