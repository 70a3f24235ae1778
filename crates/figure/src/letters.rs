//! Letters that stand lower or higher than their line: `_{...}` and `^{...}` in a text.

/// Where a part of a text stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// On the line.
    Line,
    /// Below it, small: a subscript.
    Below,
    /// Above it, small: a superscript.
    Above,
}

impl Level {
    /// Size of the letters as part of the text size.
    pub fn size(self) -> f64 {
        if self == Self::Line { 1.0 } else { 0.7 }
    }

    /// How far below the line they stand, mm, in a text of this size, mm: a subscript in every size as far.
    pub fn down(self, size: f64) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Below => 0.8,
            Self::Above => -0.35 * size,
        }
    }
}

/// The parts of a text with their levels, none of them empty.
pub fn levels(text: &str) -> impl Iterator<Item = (&str, Level)> {
    let mut rest = text;
    let mut raised: Option<(&str, Level)> = None;
    std::iter::from_fn(move || {
        loop {
            if let Some(part) = raised.take().filter(|(part, _)| !part.is_empty()) {
                return Some(part);
            }
            if rest.is_empty() {
                return None;
            }
            let open =
                |(at, _): &(usize, char)| rest[*at..].starts_with("_{") || rest[*at..].starts_with("^{");
            let Some((at, sign)) = rest.char_indices().find(open) else {
                return Some((std::mem::take(&mut rest), Level::Line));
            };
            let (part, behind) = rest.split_at(at);
            let (inner, behind) = behind[2..].split_once('}').unwrap_or((&behind[2..], ""));
            raised = Some((inner, if sign == '_' { Level::Below } else { Level::Above }));
            rest = behind;
            if !part.is_empty() {
                return Some((part, Level::Line));
            }
        }
    })
}

/// The text where nothing stands lower or higher: `F_{bal}` as `F_bal`.
pub(crate) fn flat(text: &str) -> String {
    let part = |(part, level): (&str, Level)| match level {
        Level::Line => part.to_owned(),
        Level::Below => format!("_{part}"),
        Level::Above => format!("^{part}"),
    };
    levels(text).map(part).collect()
}

/// A text in which the number of a single letter is its subscript, as print has it: `S3` is `S_{3}`, while words, units and what is a
/// subscript already stay.
pub fn indexed(text: &str) -> String {
    let part = |(part, level): (&str, Level)| match level {
        Level::Line => with_indices(part),
        Level::Below => format!("_{{{part}}}"),
        Level::Above => format!("^{{{part}}}"),
    };
    levels(text).map(part).collect()
}

fn with_indices(text: &str) -> String {
    let mut told = String::new();
    let mut word = String::new();
    for letter in text.chars() {
        if letter.is_alphanumeric() {
            word.push(letter);
            continue;
        }
        told.push_str(&index_of(&std::mem::take(&mut word)));
        told.push(letter);
    }
    told + &index_of(&word)
}

/// A word with its number as a subscript, where it is a letter with a number.
fn index_of(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().filter(|first| first.is_alphabetic());
    let digits = letters.as_str();
    match first {
        Some(first) if !digits.is_empty() && digits.chars().all(|digit| digit.is_ascii_digit()) => {
            format!("{first}_{{{digits}}}")
        }
        _ => word.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::{Level, flat, indexed, levels};

    #[test]
    fn parts_have_their_levels() {
        let parts: Vec<_> = levels("a^{n}_{BA} = 2").collect();
        let wanted = [("a", Level::Line), ("n", Level::Above), ("BA", Level::Below), (" = 2", Level::Line)];
        assert_eq!(parts, wanted);
        assert_eq!(flat("μ_{F} x_{open a^{n}"), "μ_F x_open a^{n");
    }

    #[test]
    fn the_number_of_a_letter_is_its_subscript() {
        for (text, wanted) in [
            ("S3", "S_{3}"),
            ("F10′ 1500 N", "F_{10}′ 1500 N"),
            ("(F4, M8)", "(F_{4}, M_{8})"),
            ("II3(4,5) PF1 4A71 x_{S3} M7, 1e5", "II3(4,5) PF1 4A71 x_{S3} M_{7}, 1e5"),
        ] {
            assert_eq!(indexed(text), wanted);
        }
    }
}
