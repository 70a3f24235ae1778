//! The pattern of a kind of group (its links and the pairs between them, as data), and a group's links and pairs in
//! the order of that pattern.

use assur_words::text;

use crate::{BuildError, GroupFrame, Pair};

/// The sort of a pair in a pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PairSort {
    /// Revolute pair R.
    Pin,
    /// Prismatic pair P.
    Slide,
    /// A revolute or a prismatic pair.
    Any,
}

impl PairSort {
    /// Whether a pair is of this sort.
    pub fn fits(self, pair: &Pair) -> bool {
        match self {
            Self::Pin => !pair.is_slide(),
            Self::Slide => pair.is_slide(),
            Self::Any => true,
        }
    }
}

/// Links and pairs of a kind of group. Its links are numbered from 0.
///
/// A crank-side pin, a pin between the links and a slide outside, RRP:
///
/// ```
/// use assur_group::{PairSort::{Pin, Slide}, Pattern};
/// const RRP: Pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Slide)] };
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pattern {
    /// Number of links.
    pub links: usize,
    /// The pairs between two links of the group.
    pub inner: &'static [([usize; 2], PairSort)],
    /// The pairs of a link of the group with a body outside.
    pub outer: &'static [(usize, PairSort)],
}

/// A pair of which body `a` is a link of the group.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeenPair {
    /// The pair, with the link of the group as `a`.
    pub pair: Pair,
    /// Whether the scene names the two bodies in the opposite order; the stored reaction then acts on the other body.
    pub turned: bool,
}

impl Pair {
    /// The pair with the given body as its body `a`.
    pub fn seen_from(&self, body: usize) -> SeenPair {
        let turned = self.a != body;
        SeenPair { pair: if turned { self.turned_round() } else { *self }, turned }
    }
}

/// The links and pairs of a group in the order of a pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The bodies that are the links of the pattern, in its order.
    pub links: Vec<usize>,
    /// The inner pairs in the order of the pattern, each with its first link there as body `a`.
    pub inner: Vec<SeenPair>,
    /// The outer pairs in the order of the pattern, each with the link of the group as body `a`.
    pub outer: Vec<SeenPair>,
}

impl Pattern {
    /// Number of pairs of either sort; of two matching patterns the one with fewer is more specific.
    pub fn open_pairs(&self) -> usize {
        let sorts = self.inner.iter().map(|(_, sort)| sort).chain(self.outer.iter().map(|(_, sort)| sort));
        sorts.filter(|&&sort| sort == PairSort::Any).count()
    }

    /// Assigns the links and pairs of a group to this pattern; `None` if they don't match it.
    ///
    /// If several orders of the links match, the one closest to the order in the group is taken.
    pub fn find(&self, frame: &GroupFrame) -> Option<Reading> {
        let same_size = frame.links.len() == self.links
            && frame.inner.len() == self.inner.len()
            && frame.outer.len() == self.outer.len();
        same_size.then(|| self.assign(frame, &mut Vec::with_capacity(self.links))).flatten()
    }

    /// Assigns the links and pairs of a group to this pattern, as the builder of a kind needs them.
    pub fn read(&self, frame: &GroupFrame) -> Result<Reading, BuildError> {
        self.find(frame).ok_or_else(|| BuildError::new(text!("group-other-pattern")))
    }

    /// Extends an assignment of bodies to the first links of the pattern by all possible next bodies, in order.
    fn assign(&self, frame: &GroupFrame, links: &mut Vec<usize>) -> Option<Reading> {
        if links.len() == self.links {
            return self.paired(frame, links);
        }
        for &body in &frame.links {
            if links.contains(&body) {
                continue;
            }
            links.push(body);
            if self.agrees(frame, links)
                && let Some(found) = self.assign(frame, links)
            {
                return Some(found);
            }
            links.pop();
        }
        None
    }

    /// Whether the last assigned body has as many outer pairs, and pairs with the assigned links, as the pattern
    /// demands.
    fn agrees(&self, frame: &GroupFrame, links: &[usize]) -> bool {
        let last = links.len() - 1;
        let outer = frame.outer.iter().filter(|pair| pair.joins(links[last])).count();
        outer == self.outer.iter().filter(|(link, _)| *link == last).count()
            && (0..last).all(|other| {
                let joined = |pair: &&Pair| pair.joins(links[last]) && pair.joins(links[other]);
                let wanted =
                    |(ends, _): &&([usize; 2], PairSort)| *ends == [other, last] || *ends == [last, other];
                frame.inner.iter().filter(joined).count() == self.inner.iter().filter(wanted).count()
            })
    }

    /// Assigns to each pair of the pattern a pair of the group between the same links.
    fn paired(&self, frame: &GroupFrame, links: &[usize]) -> Option<Reading> {
        let inner =
            self.inner.iter().map(|(ends, sort)| (ends.map(|link| links[link]), *sort)).collect::<Vec<_>>();
        let outer = self.outer.iter().map(|(link, sort)| ([links[*link]; 2], *sort)).collect::<Vec<_>>();
        Some(Reading {
            links: links.to_vec(),
            inner: distribute(&inner, &frame.inner)?,
            outer: distribute(&outer, &frame.outer)?,
        })
    }
}

/// Assigns pairs to the wanted places, each given by the two bodies that the pair joins (the first becomes its `a`)
/// and by its sort.
fn distribute(wanted: &[([usize; 2], PairSort)], pairs: &[Pair]) -> Option<Vec<SeenPair>> {
    let mut found: Vec<Option<&Pair>> = vec![None; wanted.len()];
    // Places of either sort are filled last, with the pairs that remain.
    for any in [false, true] {
        for (i, (bodies, sort)) in
            wanted.iter().enumerate().filter(|(_, (_, sort))| any == (*sort == PairSort::Any))
        {
            let free = |pair: &&Pair| !found.iter().flatten().any(|taken| taken.id == pair.id);
            let fits = |pair: &&Pair| bodies.iter().all(|body| pair.joins(*body)) && sort.fits(pair);
            found[i] = Some(pairs.iter().filter(free).find(fits)?);
        }
    }
    let seen = wanted.iter().zip(found).map(|((bodies, _), pair)| Some(pair?.seen_from(bodies[0])));
    seen.collect()
}
