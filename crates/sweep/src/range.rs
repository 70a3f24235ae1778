//! `FROM..TO:N`.

/// The values of a parameter as they are written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Range {
    /// First value.
    pub(crate) from: String,
    /// Last value.
    pub(crate) to: String,
    /// How many, at least 1.
    pub(crate) count: usize,
}

pub(crate) fn parse(text: &str) -> Result<Range, String> {
    let wrong = || "write it as KEY=FROM..TO:N, such as \"link.crank.mass=1 kg..5 kg:9\"".to_owned();
    let (ends, count) = text.rsplit_once(':').ok_or_else(wrong)?;
    let (from, to) = ends.split_once("..").ok_or_else(wrong)?;
    let (from, to) = (from.trim(), to.trim());
    if from.is_empty() || to.is_empty() {
        return Err(wrong());
    }
    let points: Option<usize> = count.trim().parse().ok().filter(|count| *count > 0);
    let count = points.ok_or_else(|| format!("N is `{}`: write a whole number from 1", count.trim()))?;
    Ok(Range { from: from.to_owned(), to: to.to_owned(), count })
}

/// A number and what follows it, the unit: "100 mm" is (100, "mm").
pub(crate) fn split(text: &str) -> Option<(f64, String)> {
    let text = text.replace('\u{2212}', "-");
    let number = |end: &usize| {
        let head = text[..*end].trim();
        let digits = head.ends_with(|c: char| c.is_ascii_digit() || c == '.');
        head.parse().ok().filter(|value: &f64| digits && value.is_finite()).map(|value| (value, *end))
    };
    let mut ends = text.char_indices().map(|(at, c)| at + c.len_utf8()).rev();
    let (value, end) = ends.find_map(|end| number(&end))?;
    let unit: Vec<&str> = text[end..].split_whitespace().collect();
    Some((value, unit.join(" ")))
}

/// Value `index` of `count` equally spaced ones; the ends are exact.
pub(crate) fn between(from: f64, to: f64, index: usize, count: usize) -> f64 {
    if index == 0 || count < 2 {
        from
    } else if index + 1 == count {
        to
    } else {
        decimal(from + (to - from) * (index as f64) / ((count - 1) as f64))
    }
}

/// Rounded to the 15 digits that every double keeps, so that decimal steps stay decimal: 0.12, not 0.12000000000000001.
fn decimal(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}
