//! The pattern of a kind of group: which pairs its links have, as data; and a group read in its order.

use crate::{BuildError, GroupFrame, Pair};

/// What a pair of a pattern may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PairSort {
    /// Revolute pair R.
    Pin,
    /// Prismatic pair P.
    Slide,
    /// Either of them.
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

/// A pair seen from one of its bodies, a link of the group: that body is `a` of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeenPair {
    /// The pair, with that body as `a`.
    pub pair: Pair,
    /// Whether the scene names the bodies the other way round, so that the stored reaction acts on `b`.
    pub turned: bool,
}

impl Pair {
    /// The pair seen from one of its bodies.
    pub fn seen_from(&self, body: usize) -> SeenPair {
        let turned = self.a != body;
        SeenPair { pair: if turned { self.turned_round() } else { *self }, turned }
    }
}

/// A group read in the order of a pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// The bodies that are the links of the pattern, in its order.
    pub links: Vec<usize>,
    /// The inner pairs in the order of the pattern, each seen from its first link there.
    pub inner: Vec<SeenPair>,
    /// The outer pairs in the order of the pattern, each seen from the link of the group.
    pub outer: Vec<SeenPair>,
}

impl Pattern {
    /// Number of pairs whose sort is left open: a kind with fewer is the more special one.
    pub fn open_pairs(&self) -> usize {
        let sorts = self.inner.iter().map(|(_, sort)| sort).chain(self.outer.iter().map(|(_, sort)| sort));
        sorts.filter(|&&sort| sort == PairSort::Any).count()
    }

    /// Reads a group in the order of this pattern; `None` if its links and pairs are not of it.
    ///
    /// Where several orders of the links fit, it is the one closest to that of the group.
    pub fn find(&self, frame: &GroupFrame) -> Option<Reading> {
        let same_size = frame.links.len() == self.links
            && frame.inner.len() == self.inner.len()
            && frame.outer.len() == self.outer.len();
        same_size.then(|| self.assign(frame, &mut Vec::with_capacity(self.links))).flatten()
    }

    /// As [`find`](Self::find), for the builder of a kind.
    ///
    /// # Errors
    ///
    /// [`BuildError`] where the group is not of this pattern.
    pub fn read(&self, frame: &GroupFrame) -> Result<Reading, BuildError> {
        self.find(frame)
            .ok_or_else(|| BuildError::new("links and pairs of the group are not those of the kind"))
    }

    /// Extends an assignment of bodies to the first links of the pattern by all that can follow, in order.
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

    /// Whether the last assigned body has as many pairs, outside and with the others, as the pattern says.
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

    /// Gives each pair of the pattern one of the group between the same links.
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

/// Distributes pairs over what is wanted: bodies that each joins, the first being the one it is seen from, and its sort.
fn distribute(wanted: &[([usize; 2], PairSort)], pairs: &[Pair]) -> Option<Vec<SeenPair>> {
    let mut found: Vec<Option<&Pair>> = vec![None; wanted.len()];
    // A place for any sort takes what the others leave.
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
