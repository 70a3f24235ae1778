//! Parts that are left out, and how many constraints are too many without them.

use std::collections::HashSet;

use assur_mechanism::{LinkId, Mechanism, PairId};

use crate::PassivePart;
use crate::compose::counted_system;

/// The parts that are left out.
pub(crate) struct LeftOut {
    links: Vec<bool>,
    pairs: HashSet<(PairId, LinkId)>,
}

impl LeftOut {
    pub(crate) fn of(mechanism: &Mechanism, parts: &[PassivePart]) -> Self {
        let mut found = Self { links: vec![false; mechanism.links.len()], pairs: HashSet::new() };
        for part in parts {
            match *part {
                PassivePart::Link(link) => found.links[link] = true,
                PassivePart::Pair(pair, link) => _ = found.pairs.insert((pair, link)),
            }
        }
        found
    }

    /// Whether a link is left out.
    pub(crate) fn link(&self, link: LinkId) -> bool {
        self.links[link]
    }

    /// Whether a pair of a link is left out, alone or with the link.
    pub(crate) fn pair(&self, pair: PairId, link: LinkId) -> bool {
        self.link(link) || self.is_alone(pair, link)
    }

    /// Whether a pair of a link is left out by itself.
    pub(crate) fn is_alone(&self, pair: PairId, link: LinkId) -> bool {
        self.pairs.contains(&(pair, link))
    }
}

/// What the count of equations says of a mechanism without some parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Excess {
    /// Number of surplus constraints.
    pub surplus: usize,
    /// Whether a link can move while the input is fixed.
    pub loose: bool,
}

impl Excess {
    /// Counts; nothing is solved, and lengths don't matter.
    pub fn of(mechanism: &Mechanism, without: &[PassivePart]) -> Self {
        let graph = counted_system(mechanism, &LeftOut::of(mechanism, without));
        Self { surplus: graph.unmatched(), loose: graph.is_loose() }
    }
}
