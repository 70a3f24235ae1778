//! Random formulas of the whole language, whose switches are at zeros that a motion passes.

use assur_formula::{Formula, Variables};

use crate::Rng;

/// What a random formula may use.
#[derive(Debug, Clone, Copy)]
pub struct Terms {
    /// Speed and time.
    pub motion: bool,
    /// The place of a point.
    pub place: bool,
}

/// A formula without poles. The arguments of most of its switches are zero at `at`, up to rounding.
pub fn formula(rng: &mut Rng, terms: Terms, at: &Variables) -> Formula {
    loop {
        let size = rng.range(1.0, 200.0).round();
        let text = format!("{size}*{}", Draft { terms, at }.number(rng, 3));
        // A draft may nest deeper or switch more often than a formula can.
        if let Some(formula) = Formula::read(&text).ok().filter(|formula| formula.value(at).abs() < 1e6) {
            return formula;
        }
    }
}

struct Draft<'a> {
    terms: Terms,
    at: &'a Variables,
}

impl Draft<'_> {
    /// A term of moderate size.
    fn number(&self, rng: &mut Rng, depth: usize) -> String {
        if depth == 0 {
            return self.leaf(rng);
        }
        let below = |rng: &mut Rng| self.number(rng, depth - 1);
        match rng.below(16) {
            0 => format!("({} + {})", below(rng), below(rng)),
            1 => format!("({} - {})", below(rng), below(rng)),
            2 => format!("{}*{}", below(rng), below(rng)),
            3 => format!("{}/(1.5 + ({})^2)", below(rng), below(rng)),
            4 => format!("({})^{}", below(rng), 2 + rng.below(2)),
            5 => format!("abs({})^{:.1}", self.zero(rng, depth - 1), rng.range(0.3, 2.7)),
            6 => format!("sqrt({}({}))", ["abs", "0.3 + abs"][rng.below(2)], self.zero(rng, depth - 1)),
            7 => self.smooth(rng, depth - 1),
            8 => format!("sign({})", self.zero(rng, depth - 1)),
            9 => format!("step({})", self.zero(rng, depth - 1)),
            // Not both of them may be zero.
            10 => format!(
                "atan2({}, {}(1.3 + cos({})))",
                self.zero(rng, depth - 1),
                ["", "-"][rng.below(2)],
                below(rng)
            ),
            11 => format!("abs({})", self.zero(rng, depth - 1)),
            12 => format!("sign({})*{}", self.zero(rng, depth - 1), below(rng)),
            13 => {
                let other = below(rng);
                format!("{}({other}, {other} + {})", ["min", "max"][rng.below(2)], self.zero(rng, depth - 1))
            }
            14 => format!("max(0, {})^{:.1}", self.zero(rng, depth - 1), rng.range(0.4, 2.6)),
            _ => format!("-{}({}, {})", ["min", "max"][rng.below(2)], below(rng), below(rng)),
        }
    }

    /// A smooth function that has a value everywhere.
    fn smooth(&self, rng: &mut Rng, depth: usize) -> String {
        let of = self.number(rng, depth);
        match rng.below(8) {
            0 => format!("sin({of})"),
            1 => format!("cos({of})"),
            2 => format!("tan(0.7*sin({of}))"),
            3 => format!("asin(sin({of}))"),
            4 => format!("acos(0.9*cos({of}))"),
            5 => format!("exp(-({of})^2)"),
            6 => format!("ln(1.2 + abs({of}))"),
            _ => format!("atan({of})"),
        }
    }

    /// A term that mostly is zero at the place: passed, touched, or over an interval.
    fn zero(&self, rng: &mut Rng, depth: usize) -> String {
        let term = if rng.chance(0.6) { self.leaf(rng) } else { self.number(rng, depth) };
        let Some(value) = Formula::read(&term).ok().map(|term| term.value(self.at)) else { return term };
        let apart = if rng.chance(0.5) {
            format!("({term} - ({value:?}))")
        } else {
            format!("sin({}*({term} - ({value:?})))", 1 + rng.below(4))
        };
        match rng.below(10) {
            0 => format!("({apart})^2"),
            1 => format!("({apart})^3"),
            2 => format!("max(0, {apart})"),
            3 => format!("(cos({apart}) - 1)"),
            4 => term,
            _ => apart,
        }
    }

    fn leaf(&self, rng: &mut Rng) -> String {
        match rng.below(8) {
            0 if self.terms.motion => "0.1*w".to_owned(),
            1 if self.terms.motion => "t".to_owned(),
            2 if self.terms.motion => "(q - 2*t)".to_owned(),
            3 if self.terms.place => "x".to_owned(),
            4 => format!("{:.1}", rng.signed(0.1, 3.0)),
            5 => format!("sin({}*q)", 1 + rng.below(3)),
            6 => "cos(q)".to_owned(),
            _ => "q".to_owned(),
        }
    }
}
