//! Symbols of quantities.

use assur_words::{Language, Text, joined, list, name};

/// The symbol of a quantity: a letter with primes and subscripts, each of which is a letter, a name of the scene or a word.
///
/// Its text has them as subscripts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Symbol {
    letter: Text,
    primes: usize,
    below: Vec<Text>,
}

impl Symbol {
    /// The symbol of the derivative of an order.
    #[must_use]
    pub fn prime(mut self, order: usize) -> Self {
        self.primes += order;
        self
    }

    /// The symbol with a further subscript; one that has subscripts itself gives them too.
    #[must_use]
    pub fn of(mut self, below: impl Into<Self>) -> Self {
        let below = below.into();
        self.below.push(below.letter);
        self.below.extend(below.below);
        self
    }

    /// The letter with its primes.
    pub fn letter(&self) -> Text {
        joined("", [self.letter.clone(), name(["", "′", "″"][self.primes.min(2)])])
    }

    /// The subscripts; empty where there are none.
    pub fn subscript(&self) -> Text {
        list(self.below.iter().cloned())
    }

    /// The symbol in a language, with its subscripts on the line.
    pub fn plain(&self, language: &Language) -> String {
        Text::from(self).render(language)
    }
}

impl From<Text> for Symbol {
    fn from(letter: Text) -> Self {
        Self { letter, primes: 0, below: Vec::new() }
    }
}

impl From<&Text> for Symbol {
    fn from(letter: &Text) -> Self {
        letter.clone().into()
    }
}

impl From<&'static str> for Symbol {
    fn from(letter: &'static str) -> Self {
        name(letter).into()
    }
}

impl From<usize> for Symbol {
    fn from(number: usize) -> Self {
        Text::from(number).into()
    }
}

impl From<&Self> for Symbol {
    fn from(symbol: &Self) -> Self {
        symbol.clone()
    }
}

impl From<&Symbol> for Text {
    fn from(symbol: &Symbol) -> Self {
        match symbol.below[..] {
            [] => symbol.letter(),
            _ => symbol.letter().below(symbol.subscript()),
        }
    }
}
