//! Reads a printed working back and evaluates it: shares nothing with what wrote it.

use std::collections::BTreeMap;

/// The equations of a printed working as (row, parts between the equality signs).
pub(crate) fn equations(text: &str) -> Vec<Vec<String>> {
    let mut rows: Vec<String> = Vec::new();
    for row in text.lines() {
        match row.strip_prefix("    ") {
            Some(rest) => {
                let last = rows.last_mut().unwrap();
                let space = if last.ends_with('*') { "" } else { " " };
                *last = format!("{last}{space}{}", rest.trim());
            }
            None => rows.push(row.to_owned()),
        }
    }
    let equation = |row: &String| {
        let parts: Vec<String> = row.trim().split(" = ").map(str::to_owned).collect();
        let named = row.starts_with("  ") && parts.len() > 1 && !parts[0].contains(' ');
        named.then_some(parts)
    };
    rows.iter().filter_map(equation).collect()
}

/// Value and half a unit of the last digit of a printed number, which may be followed by a unit.
pub(crate) fn printed(part: &str) -> (f64, f64) {
    let number = part.split(' ').next().unwrap();
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let exponent: i32 = exponent.parse().unwrap_or_else(|_| panic!("no number: {part}"));
    let half = 0.5 * 10.0_f64.powi(exponent - i32::try_from(decimals).unwrap());
    (number.parse().unwrap(), half)
}

/// The value of an expression of numbers, + - * / ^, sqrt, sin, cos, atan2, pi and parentheses.
pub(crate) fn evaluate(text: &str) -> f64 {
    let text = text.replace('π', "pi");
    let mut reader = Reader { rest: text.as_bytes() };
    let value = reader.sum();
    assert!(reader.rest.is_empty(), "left over in {text}: {}", String::from_utf8_lossy(reader.rest));
    value
}

struct Reader<'a> {
    rest: &'a [u8],
}

impl Reader<'_> {
    fn skip(&mut self) {
        self.rest = self.rest.trim_ascii_start();
    }

    fn take(&mut self, sign: u8) -> bool {
        self.skip();
        let found = self.rest.first() == Some(&sign);
        if found {
            self.rest = &self.rest[1..];
        }
        found
    }

    fn sum(&mut self) -> f64 {
        let mut value = if self.take(b'-') { -self.product() } else { self.product() };
        loop {
            if self.take(b'+') {
                value += self.product();
            } else if self.take(b'-') {
                value -= self.product();
            } else {
                return value;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut value = self.power();
        loop {
            if self.take(b'*') {
                value *= self.power();
            } else if self.take(b'/') {
                value /= self.power();
            } else {
                return value;
            }
        }
    }

    fn power(&mut self) -> f64 {
        let value = self.atom();
        if self.take(b'^') { value.powf(self.atom()) } else { value }
    }

    fn atom(&mut self) -> f64 {
        if self.take(b'(') {
            let value = self.sum();
            assert!(self.take(b')'));
            return value;
        }
        let letters = self.rest.iter().take_while(|c| c.is_ascii_alphanumeric()).count();
        if self.rest[0].is_ascii_alphabetic() {
            let name = String::from_utf8(self.rest[..letters].to_vec()).unwrap();
            self.rest = &self.rest[letters..];
            return self.call(&name);
        }
        self.number()
    }

    fn call(&mut self, name: &str) -> f64 {
        if name == "pi" {
            return std::f64::consts::PI;
        }
        assert!(self.take(b'('), "{name} is no number");
        let first = self.sum();
        let value = match name {
            "sqrt" => first.sqrt(),
            "sin" => first.sin(),
            "cos" => first.cos(),
            "atan2" => {
                assert!(self.take(b','));
                first.atan2(self.sum())
            }
            other => panic!("{other} is no function"),
        };
        assert!(self.take(b')'));
        value
    }

    fn number(&mut self) -> f64 {
        let mut end = 0;
        while end < self.rest.len() {
            let exponent_sign = self.rest[end] == b'-' && end > 0 && self.rest[end - 1] == b'e';
            if !(self.rest[end].is_ascii_digit() || matches!(self.rest[end], b'.' | b'e') || exponent_sign) {
                break;
            }
            end += 1;
        }
        let number = std::str::from_utf8(&self.rest[..end]).unwrap();
        self.rest = &self.rest[end..];
        number.parse().unwrap_or_else(|_| panic!("{number} is no number"))
    }
}

/// Every equation of a printed working recomputes to what it prints; their number.
pub(crate) fn recomputes(what: &str, text: &str) -> usize {
    let mut count = 0;
    let mut known = BTreeMap::new();
    for parts in equations(text) {
        let [name, .., last] = &parts[..] else { continue };
        let (wanted, half) = printed(last);
        if parts.len() > 2 {
            let expression = &parts[parts.len() - 2];
            // A quantity that is another one, or its opposite, with its number printed once.
            let opposite =
                expression.strip_prefix('-').and_then(|name| known.get(name)).map(|value: &f64| -value);
            let found = known.get(expression).copied().or(opposite).unwrap_or_else(|| evaluate(expression));
            let slack = half * (1.0 + 1e-9) + f64::EPSILON;
            assert!((found - wanted).abs() <= slack, "{what}: {name}: {found} is not {last}\n{parts:?}");
            count += 1;
        }
        assert!(known.insert(name.clone(), wanted).is_none(), "{what}: {name} stands for two quantities");
    }
    assert!(text.lines().all(|row| row.chars().count() <= 100), "{what}: a row is too long");
    count
}

#[test]
fn the_evaluator_knows_its_signs() {
    for (text, wanted) in [
        ("2 - 3 - 4", -5.0),
        ("-2^2*3 + (-2)^2", -8.0),
        ("12/3/2*-1".trim_end_matches("*-1"), 2.0),
        ("sqrt(9) + atan2(1, 0)*2/pi", 4.0),
        ("-(1.5e-3 - 2e3)", 1999.9985),
        ("cos(0) - sin(0)", 1.0),
    ] {
        assert!((evaluate(text) - wanted).abs() < 1e-12, "{text}");
    }
}

#[test]
fn a_wrong_line_is_found() {
    let wrong = "A\n-\n  c = a*b = 2*3 = 6.00001 m\n";
    assert!(std::panic::catch_unwind(|| recomputes("wrong", wrong)).is_err());
    assert_eq!(recomputes("right", "A\n-\n  c = a*b = 2*3 = 6.00000 m\n  d = 4 m\n"), 1);
}
