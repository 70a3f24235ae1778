//! The conventions of a working.

use crate::{Place, Work};

/// One convention a line: of positions and transfer functions, and of forces.
const CONVENTIONS: &str = include_str!("conventions.txt");
const FORCES: &str = include_str!("conventions_of_forces.txt");
/// Added if a joint has more than two links.
const SHARES: &str = "In a joint B of more than two links, Rx_B_s_t_r is the share of links s and t alone; the reaction of B on r \
                      is the sum of its shares.";

impl Work<'_> {
    /// Writes the first section: signs, symbols, assumptions.
    pub(crate) fn conventions(&mut self, place: Place, forces: bool) {
        let mechanism = &self.linkage.mechanism;
        let title = if mechanism.title.is_empty() { "Working" } else { mechanism.title.as_str() };
        let what = match place {
            Place::Position(index) => format!("position {index}"),
            Place::Sample(number) => format!("sample {number}, time {} s", self.state.time),
        };
        self.sheet.section(&format!("{title}: working of {what}"));
        self.sheet.note(format!("Structure: {}", self.linkage.structure.formula));
        self.sheet.section("Conventions and assumptions");
        for words in CONVENTIONS.lines() {
            self.sheet.note(words);
        }
        if forces {
            for words in FORCES.lines() {
                self.sheet.note(words);
            }
            let structure = &self.linkage.structure;
            if (0..structure.pairs.len()).any(|pair| structure.is_share(pair)) {
                self.sheet.note(SHARES);
            }
        }
    }
}
