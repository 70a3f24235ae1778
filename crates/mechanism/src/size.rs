//! How large a mechanism and its results may be: no scene, however it is made, takes more than 1 GB of memory.
//!
//! The counts are far beyond any machine. Measured on scenes of each limit, the largest takes some 500 MB; docs/ranges.md
//! lists them.

use crate::Mechanism;

/// Most moving links: a link with its pairs takes some 100 kB in all results.
pub const MOST_LINKS: usize = 2_000;
/// Most places of points on links: each takes some 20 kB in all results.
pub const MOST_PLACES: usize = 10_000;
/// Most slides that are read. A mechanism has at most three for two links; more are refused as surplus, with their links.
pub const MOST_SLIDES: usize = 200_000;
/// Most loads: forces, moments, brakes, springs and contacts together.
pub const MOST_LOADS: usize = 10_000;
/// Most characters of a name or title: tables pad every row to the longest name.
pub const LONGEST_NAME: usize = 200;
/// Most samples of a motion.
pub const MOST_SAMPLES: usize = 1_000_000;

/// Most samples of a motion times [`Mechanism::parts`]: a part has some ten numbers, and a number of a sample takes some 30
/// bytes with its text.
pub const MOST_PARTS_SAMPLED: usize = 1_600_000;
/// Most steps of a motion that are kept, because its end is not known before: some 200 bytes each.
pub const MOST_STEPS_KEPT: usize = 1_000_000;
/// Most [`Mechanism::parts`] of a mechanism that is drawn: each has curves, names and rows in many figures.
pub const MOST_PARTS_DRAWN: usize = 1_000;
/// Most positions that are kept; of more, every so many.
pub const MOST_KEPT: usize = 4096;
/// Most positions that are kept times [`Mechanism::parts`]: [`MOST_KEPT`] of a mechanism of 65 four-bars.
pub const MOST_PARTS_KEPT: usize = 200 * MOST_KEPT;

impl Mechanism {
    /// What has numbers in a position: links, points, slides and loads.
    pub fn parts(&self) -> usize {
        self.links.len() + self.points.len() + self.slides.len() + self.loads.len()
    }

    /// How many positions are kept at most, so that their numbers fit into memory.
    pub fn most_kept(&self) -> usize {
        MOST_KEPT.min(MOST_PARTS_KEPT / self.parts().max(1)).max(1)
    }
}
