//! What happens to the modes of a group between two coordinates next to each other: they meet, begin, end, or go on.

use assur_group::Mode;

use super::{SpanEnd, TOGETHER, Walk, is_turned};

/// Modes on both sides of an event; which of those before are left, and the numbers of those after it, as far as they are known.
struct Sides<'a> {
    before: &'a [(usize, Mode<f64>)],
    after: &'a [Mode<f64>],
    left: Vec<bool>,
    numbers: Vec<Option<usize>>,
}

impl Sides<'_> {
    fn go_on(&mut self, at: usize, next: usize) {
        self.left[at] = false;
        self.numbers[next] = Some(self.before[at].0);
    }

    /// The first mode before the event that is left and fits.
    fn find_left(&self, fits: impl Fn(&Mode<f64>) -> bool) -> Option<usize> {
        (0..self.before.len()).find(|at| self.left[*at] && fits(&self.before[*at].1))
    }
}

impl Walk<'_> {
    /// What happens between the present coordinate and the next one, next to it; the numbers of the next modes.
    pub(super) fn event(&mut self, to: f64, next: Option<&[Mode<f64>]>) -> Option<Vec<usize>> {
        let now = self.now.1.take();
        let (Some(now), Some(next)) = (&now, next) else {
            now.iter().flatten().for_each(|(number, _)| self.end(*number, SpanEnd::Barrier));
            return next.map(|next| next.iter().map(|_| self.begin(to, SpanEnd::Barrier)).collect());
        };
        let (left, numbers) = (vec![true; now.len()], vec![None; next.len()]);
        let mut sides = Sides { before: now, after: next, left, numbers };
        self.meet_or_begin(to, &mut sides);
        self.end_in_pairs(&mut sides);
        self.go_on(&mut sides);
        self.turn_over(to, &mut sides);
        for (at, _) in sides.left.iter().enumerate().filter(|(_, left)| **left) {
            self.end(now[at].0, SpanEnd::Infinity);
        }
        let numbers = sides.numbers.into_iter();
        Some(numbers.map(|known| known.unwrap_or_else(|| self.begin(to, SpanEnd::Infinity))).collect())
    }

    /// Pairs that are next to each other after the event: two modes have met, or begin together.
    fn meet_or_begin(&mut self, to: f64, sides: &mut Sides<'_>) {
        for [j, k] in self.pairs(&sides.after.iter().collect::<Vec<_>>()) {
            let modes = [&sides.after[j], &sides.after[k]];
            // After a meeting each mode has the opposite sign of its determinant. The two are within this of each other, and each of
            // them of where it was.
            let near = |way: usize| {
                sides.find_left(|one| one.way == way && self.apart(one, modes[0]) < 2.0 * TOGETHER)
            };
            if let (Some(a), Some(b)) = (near(modes[1].way), near(modes[0].way)) {
                if self.is_passed(to, &sides.before[a].1) {
                    self.found.meetings.push((to, [sides.before[a].0, sides.before[b].0]));
                    sides.go_on(a, j);
                    sides.go_on(b, k);
                } else {
                    sides.go_on(b, j);
                    sides.go_on(a, k);
                }
            } else {
                let [one, other] = [0, 1].map(|_| self.begin(to, SpanEnd::Cycle));
                for (number, partner) in [(one, other), (other, one)] {
                    self.found.spans[number].begins = SpanEnd::With(partner);
                }
                (sides.numbers[j], sides.numbers[k]) = (Some(one), Some(other));
            }
        }
    }

    /// Pairs that were next to each other before the event end together.
    fn end_in_pairs(&mut self, sides: &mut Sides<'_>) {
        let before: Vec<&Mode<f64>> = sides.before.iter().map(|(_, mode)| mode).collect();
        for [a, b] in self.pairs(&before) {
            if sides.left[a] && sides.left[b] {
                (sides.left[a], sides.left[b]) = (false, false);
                self.end(sides.before[a].0, SpanEnd::With(sides.before[b].0));
                self.end(sides.before[b].0, SpanEnd::With(sides.before[a].0));
            }
        }
    }

    /// The others go on where they are.
    fn go_on(&self, sides: &mut Sides<'_>) {
        for next in (0..sides.after.len()).filter(|next| sides.numbers[*next].is_none()).collect::<Vec<_>>() {
            let mode = &sides.after[next];
            let is_left = |at: usize| sides.left[at] && !is_turned(&sides.before[at].1, mode, self.scale());
            if let Some((at, _)) = self.nearest(sides.before, mode, is_left) {
                sides.go_on(at, next);
            }
        }
    }

    /// Where a group can turn freely, each of its two modes goes on with the other sign of its determinant.
    fn turn_over(&mut self, to: f64, sides: &mut Sides<'_>) {
        let mut turned = Vec::new();
        for next in (0..sides.after.len()).filter(|next| sides.numbers[*next].is_none()).collect::<Vec<_>>() {
            let near = sides.find_left(|one| self.apart(one, &sides.after[next]) < TOGETHER);
            if let Some(at) = near {
                sides.go_on(at, next);
                turned.push(sides.before[at].0);
            }
        }
        self.found.meetings.extend(turned.chunks_exact(2).map(|pair| (to, [pair[0], pair[1]])));
    }

    /// Whether a mode meets another one before the next coordinate: its determinant, which falls evenly, is zero there.
    fn is_passed(&self, to: f64, mode: &Mode<f64>) -> bool {
        let back = self.linkage.modes_at(self.group, self.now.0 - (to - self.now.0)).unwrap_or_default();
        let back: Vec<(usize, Mode<f64>)> = back.into_iter().enumerate().collect();
        let earlier = self.nearest(&back, mode, |_| true);
        earlier.is_some_and(|(at, _)| mode.health < back[at].1.health - mode.health)
    }

    /// Pairs of modes that are about to meet.
    fn pairs(&self, all: &[&Mode<f64>]) -> Vec<[usize; 2]> {
        let mut pairs: Vec<[usize; 2]> = Vec::new();
        for (j, one) in all.iter().enumerate() {
            let free = |k: usize| !pairs.iter().flatten().any(|taken| *taken == k);
            let meets = |k: &usize| all[*k].way != one.way && self.apart(one, all[*k]) < TOGETHER && free(*k);
            if free(j)
                && let Some(k) = (j + 1..all.len()).find(meets)
            {
                pairs.push([j, k]);
            }
        }
        pairs
    }
}
