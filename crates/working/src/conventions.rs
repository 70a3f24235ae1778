//! The conventions of a working.

use assur_words::{Text, joined, name, number, text};
use assur_worksheet::{RESULT_DIGITS, Symbol};

use crate::{PositionOrSample, Work};

impl Work<'_> {
    /// Writes the first section: signs, symbols, assumptions.
    pub(crate) fn conventions(&mut self, place: PositionOrSample, forces: bool) {
        let title = &self.linkage.mechanism.title;
        let title = if title.is_empty() { text!("worksheet-working") } else { title.into() };
        let of = match place {
            PositionOrSample::Position(index) => text!("working-at-position", position = index),
            PositionOrSample::Sample(index) => {
                // To a nanosecond: the last digits of a sum of steps are rounding.
                let time = (1e9 * self.state.time).round() / 1e9;
                text!("working-at-sample", sample = index, time = number(time))
            }
        };
        self.sheet.section(text!("working-title", title, of));
        let formula = &self.linkage.structure.formula;
        self.sheet.note(text!("working-structure", formula));
        self.sheet.section(text!("working-conventions"));
        self.remarks([
            text!("working-axes"),
            text!("working-units"),
            text!("working-pf"),
            text!(
                "working-symbols",
                x = symbol("x", &["A"]),
                y = symbol("y", &["A"]),
                phi = symbol("φ", &["r"]),
                u = symbol("u", &["A", "B"]),
                v = symbol("v", &["A", "B"]),
                l = symbol("l", &["A", "B"]),
                beta = symbol("β", &["A", "B"]),
                tx = symbol("t", &["x"]),
                ty = symbol("t", &["y"]),
            ),
            text!("working-symbols-of-groups", d = symbol("D", &["2"])),
            text!("working-order"),
            digits_told(RESULT_DIGITS),
            text!(
                "working-atan2",
                arguments = joined("", [name("y"), text!("worksheet-between-arguments"), name("x")])
            ),
            text!("working-assumptions"),
        ]);
        if forces {
            self.conventions_of_forces();
        }
    }

    fn conventions_of_forces(&mut self) {
        self.remarks([
            text!(
                "working-symbols-of-reactions",
                rx = symbol("R", &["x", "B", "r"]),
                ry = symbol("R", &["y", "B", "r"]),
                mr = symbol("M", &["R"]),
            ),
            text!(
                "working-symbols-of-loads",
                x = symbol("X", &["r"]),
                y = symbol("Y", &["r"]),
                m = symbol("M", &["r", "A"]),
            ),
            text!("working-inertia"),
            if self.linkage.mechanism.frictions.is_empty() {
                text!("working-assumptions-of-forces")
            } else {
                text!("working-assumptions-with-friction")
            },
        ]);
        let structure = &self.linkage.structure;
        if (0..structure.pairs.len()).any(|pair| structure.is_share(pair)) {
            let share = symbol("R", &["x", "B", "s", "t", "r"]);
            self.sheet.note(text!("working-shares", share));
        }
    }

    fn remarks(&mut self, all: impl IntoIterator<Item = Text>) {
        all.into_iter().for_each(|remark| self.sheet.note(remark));
    }
}

fn symbol(letter: &'static str, below: &[&'static str]) -> Text {
    Text::from(&below.iter().fold(Symbol::from(letter), |symbol, part| symbol.of(*part)))
}

/// How many significant digits the results of a working have.
pub fn digits_told(digits: usize) -> Text {
    let zero = number(format_args!("{:.*}", digits.saturating_sub(1), 0.0));
    text!("working-digits", digits = number(digits), zero)
}
