//! The parts of a group by its pattern: base, plate and legs.

use assur_group::{BuildError, GroupFrame, Pattern, SeenPair};

/// A leg, its pair with the base and its pair with the plate, both with the leg as body `a`.
pub(crate) type LegPairs = (usize, SeenPair, SeenPair);

/// The parts of a group.
pub(crate) struct Parts<'a> {
    pub(crate) frame: &'a GroupFrame,
    /// The ternary link that is held; `None` where the outer bodies are the base.
    pub(crate) base: Option<usize>,
    /// Its outer pair.
    pub(crate) base_outer: Option<SeenPair>,
    /// The ternary link that the legs hold against the base.
    pub(crate) plate: usize,
    /// Its outer pair; `None` where it has none.
    pub(crate) plate_outer: Option<SeenPair>,
    pub(crate) legs: Vec<LegPairs>,
}

impl<'a> Parts<'a> {
    /// Class III: link 0 of the pattern is the plate; leg k has the k-th inner and the k-th outer pair.
    pub(crate) fn of_triad(frame: &'a GroupFrame, pattern: &Pattern) -> Result<Self, BuildError> {
        let read = pattern.read(frame)?;
        let legs = (0..3).map(|k| (read.links[k + 1], read.outer[k], read.inner[k])).collect();
        Ok(Self { frame, base: None, base_outer: None, plate: read.links[0], plate_outer: None, legs })
    }

    /// Class IV: link 0 of the pattern is the base, link 1 the plate; a leg has two inner pairs, that with the base first.
    pub(crate) fn of_contour(frame: &'a GroupFrame, pattern: &Pattern) -> Result<Self, BuildError> {
        let read = pattern.read(frame)?;
        let legs = (0..2).map(|k| (read.links[k + 2], read.inner[2 * k], read.inner[2 * k + 1])).collect();
        Ok(Self {
            frame,
            base: Some(read.links[0]),
            base_outer: Some(read.outer[0]),
            plate: read.links[1],
            plate_outer: Some(read.outer[1]),
            legs,
        })
    }
}
