//! Number and unit of a quantity. A unit is a product of named units with exponents, so that `kg*mm^2` needs no entry.

use super::dimension::{Dimension, Powers};
use super::{UnitError, UnitFault};
use crate::text::nearest;

/// A unit: `up / down * pi^turns` times the SI unit with these powers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    pub(super) up: f64,
    pub(super) down: f64,
    pub(super) turns: i32,
    pub(super) powers: Powers,
}

impl Scale {
    /// The unit 1.
    pub(super) const ONE: Self = Self { up: 1.0, down: 1.0, turns: 0, powers: [0; 4] };
}

const M: Powers = [1, 0, 0, 0];
const KG: Powers = [0, 1, 0, 0];
const S: Powers = [0, 0, 1, 0];
const RAD: Powers = [0, 0, 0, 1];
const N: Powers = [1, 1, -2, 0];
const NM: Powers = [2, 1, -2, 0];
const W: Powers = [2, 1, -3, 0];

/// The pound, kg (international yard and pound agreement, 1959).
const POUND: f64 = 0.453_592_37;
/// Standard gravity, m/s² (3rd General Conference on Weights and Measures, 1901).
const GRAVITY: f64 = 9.806_65;

/// Name, up, down, power of pi, powers. The inch is 0.0254 m and the foot 0.3048 m by the agreement of 1959; a horsepower is
/// the mechanical one, 550 ft lbf/s.
pub(super) const NAMED: &[(&str, f64, f64, i32, Powers)] = &[
    ("1", 1.0, 1.0, 0, [0; 4]),
    ("m", 1.0, 1.0, 0, M),
    ("mm", 1.0, 1e3, 0, M),
    ("cm", 1.0, 1e2, 0, M),
    ("dm", 1.0, 10.0, 0, M),
    ("km", 1e3, 1.0, 0, M),
    ("um", 1.0, 1e6, 0, M),
    ("in", 0.0254, 1.0, 0, M),
    ("ft", 0.3048, 1.0, 0, M),
    ("\u{b5}m", 1.0, 1e6, 0, M),
    ("\u{3bc}m", 1.0, 1e6, 0, M),
    ("rad", 1.0, 1.0, 0, RAD),
    ("mrad", 1.0, 1e3, 0, RAD),
    ("deg", 1.0, 180.0, 1, RAD),
    ("\u{b0}", 1.0, 180.0, 1, RAD),
    ("rev", 2.0, 1.0, 1, RAD),
    ("turn", 2.0, 1.0, 1, RAD),
    ("kg", 1.0, 1.0, 0, KG),
    ("g", 1.0, 1e3, 0, KG),
    ("t", 1e3, 1.0, 0, KG),
    ("lb", POUND, 1.0, 0, KG),
    // The mass that a pound of force accelerates by a foot per second squared.
    ("slug", POUND * GRAVITY, 0.3048, 0, KG),
    ("s", 1.0, 1.0, 0, S),
    ("ms", 1.0, 1e3, 0, S),
    ("min", 60.0, 1.0, 0, S),
    ("h", 3600.0, 1.0, 0, S),
    ("rpm", 2.0, 60.0, 1, [0, 0, -1, 1]),
    ("N", 1.0, 1.0, 0, N),
    ("mN", 1.0, 1e3, 0, N),
    ("kN", 1e3, 1.0, 0, N),
    ("MN", 1e6, 1.0, 0, N),
    ("kgf", GRAVITY, 1.0, 0, N),
    ("lbf", POUND * GRAVITY, 1.0, 0, N),
    ("Nm", 1.0, 1.0, 0, NM),
    ("kNm", 1e3, 1.0, 0, NM),
    ("Nmm", 1.0, 1e3, 0, NM),
    ("W", 1.0, 1.0, 0, W),
    ("kW", 1e3, 1.0, 0, W),
    ("MW", 1e6, 1.0, 0, W),
    ("hp", 550.0 * 0.3048 * POUND * GRAVITY, 1.0, 0, W),
];

/// Units as people write them in words and in other alphabets, and their signs here.
const SPOKEN: &[(&str, &str)] = &[
    ("мм", "mm"),
    ("см", "cm"),
    ("м", "m"),
    ("км", "km"),
    ("кг", "kg"),
    ("г", "g"),
    ("т", "t"),
    ("с", "s"),
    ("мин", "min"),
    ("хв", "min"),
    ("Н", "N"),
    ("кН", "kN"),
    ("Нм", "Nm"),
    ("Вт", "W"),
    ("кВт", "kW"),
    ("рад", "rad"),
    ("град", "deg"),
    ("об", "rev"),
    ("grad", "deg"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("sec", "s"),
    ("Hz", "rev/s"),
];

/// A unit as it is written here, for one in other words: `rev/min` for `об/мин`.
fn spoken(text: &str, wanted: Dimension) -> Option<String> {
    let mut written = String::new();
    for piece in text.split_inclusive(|c| is_operator(c) || c == '^') {
        let end = piece.trim_end_matches(|c| is_operator(c) || c == '^');
        let own = SPOKEN.iter().find(|spoken| spoken.0 == end).map_or(end, |spoken| spoken.1);
        written += own;
        written += &piece[end.len()..];
    }
    let is_unit = written != text && unit(&written, wanted).is_ok_and(|scale| wanted.accepts(scale.powers));
    is_unit.then_some(written)
}

/// The number that a text begins with, and the unit after it, both without white space around.
pub(super) fn split(text: &str, wanted: Dimension) -> Result<(f64, &str), UnitError> {
    let text = text.trim();
    let fault = |fault| UnitError::new(fault, text, wanted);
    let (number, unit) = text.split_at(number_length(text));
    let unit = unit.trim();
    if unit.starts_with(',') && !number.is_empty() {
        return Err(fault(UnitFault::Comma));
    }
    if unit.starts_with(|c: char| c.is_ascii_digit()) && !unit.starts_with("1/") && !number.is_empty() {
        return Err(fault(UnitFault::Grouped));
    }
    let value: f64 = number.replace('\u{2212}', "-").parse().map_err(|_| fault(UnitFault::NotANumber))?;
    if value.is_finite() { Ok((value, unit)) } else { Err(fault(UnitFault::TooLarge)) }
}

/// Length in bytes of the number at the beginning: sign, digits with a point, exponent.
pub(crate) fn number_length(text: &str) -> usize {
    let digits = |at: usize| text[at..].bytes().take_while(u8::is_ascii_digit).count();
    let sign = |at: usize| {
        let first = text[at..].chars().next().filter(|c| matches!(c, '+' | '-' | '\u{2212}'));
        first.map_or(0, char::len_utf8)
    };
    let mut end = sign(0);
    end += digits(end);
    if text[end..].starts_with('.') {
        end += 1 + digits(end + 1);
    }
    if text[end..].starts_with(['e', 'E']) {
        let start = end + 1 + sign(end + 1);
        if digits(start) > 0 {
            end = start + digits(start);
        }
    }
    end
}

/// The scale of a unit: factors joined by `*`, `·`, white space or `/`, each with an exponent (`^2`, `²` or `2`).
pub(super) fn unit(text: &str, wanted: Dimension) -> Result<Scale, UnitError> {
    let mut scale = Scale::ONE;
    let mut rest = text;
    let mut sign = 1;
    // More factors than any unit has; the limit keeps the exponents small.
    for _ in 0..12 {
        let end = rest.find(is_operator).unwrap_or(rest.len());
        let (factor, after) = rest.split_at(end);
        let unknown = || unknown_unit(factor, text, wanted);
        let (name, exponent) = exponent(factor.trim()).ok_or_else(unknown)?;
        let &(_, up, down, turns, powers) = NAMED.iter().find(|named| named.0 == name).ok_or_else(unknown)?;
        apply(&mut scale, &Scale { up, down, turns, powers }, sign * exponent);
        let after = after.trim_start();
        let Some(operator) = after.chars().next() else {
            return Ok(scale);
        };
        sign = if operator == '/' { -1 } else { 1 };
        rest = after.strip_prefix(is_sign).unwrap_or(after).trim_start();
    }
    Err(unknown_unit(text, text, wanted))
}

fn is_operator(c: char) -> bool {
    c == '/' || is_sign(c) || c.is_whitespace()
}

fn is_sign(c: char) -> bool {
    matches!(c, '*' | '/' | '\u{b7}' | '\u{22c5}' | '\u{d7}')
}

fn apply(scale: &mut Scale, factor: &Scale, exponent: i32) {
    let (up, down) = if exponent < 0 { (factor.down, factor.up) } else { (factor.up, factor.down) };
    scale.up *= up.powi(exponent.abs());
    scale.down *= down.powi(exponent.abs());
    scale.turns += factor.turns * exponent;
    for (sum, power) in scale.powers.iter_mut().zip(factor.powers) {
        *sum += power * exponent;
    }
}

/// Name and exponent of one factor.
fn exponent(factor: &str) -> Option<(&str, i32)> {
    if let Some((name, exponent)) = factor.split_once('^') {
        return exponent.parse().ok().filter(|e| (-4..=4).contains(e)).map(|e| (name, e));
    }
    for (sign, exponent) in [("\u{b2}", 2), ("\u{b3}", 3), ("2", 2), ("3", 3)] {
        if let Some(name) = factor.strip_suffix(sign).filter(|name| !name.is_empty()) {
            return Some((name, exponent));
        }
    }
    Some((factor, 1))
}

fn unknown_unit(part: &str, whole: &str, wanted: Dimension) -> UnitError {
    let part = part.trim();
    let unit = if part.is_empty() { whole } else { part };
    let kin = NAMED.iter().filter(|named| wanted.accepts(named.4)).map(|named| named.0);
    let near = nearest(whole, wanted.units().split(", ").chain(kin));
    let near = spoken(whole, wanted).or_else(|| near.map(str::to_owned));
    UnitError::new(UnitFault::UnknownUnit(near), unit, wanted)
}
