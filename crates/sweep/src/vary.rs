//! A parameter as a user writes it.

use std::sync::Arc;

use assur_mechanism::Key;
use assur_number::elementary;
use assur_scene::edit::decimal;
use assur_words::{Text, joined, name, quantity, text};

use crate::table::Places;
use crate::{Points, SweepError};

/// One parameter of a sweep: its key in the scene, and its values.
///
/// # Examples
///
/// ```
/// use assur_sweep::{Points, Vary};
///
/// assert!(Vary::parse("link.crank.points.A=100 mm..140 mm:5", Points::Grid).is_ok());
/// assert!(Vary::parse("link.crank.points.A=100 mm..140 mm", Points::Sample { count: 99, seed: 0 }).is_ok());
/// let error = Vary::parse("link.crank.mass=1..5", Points::Grid).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "`link.crank.mass=1..5`: write it as KEY=FROM..TO:N, such as \"link.crank.mass=1 kg..5 kg:9\""
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Vary {
    pub(crate) key: Key,
    pub(crate) values: Written,
}

impl Vary {
    /// Reads `KEY=FROM..TO:N` or `KEY=VALUE,VALUE,...` for a grid, `KEY=FROM..TO` for a sample.
    pub fn parse(text: &str, points: Points) -> Result<Self, SweepError> {
        let fault = |problem: Text| SweepError::vary(text, problem);
        let (key, range) = text.rsplit_once('=').unwrap_or((text, ""));
        let values = parse_values(range, points).map_err(fault)?;
        Ok(Self { key: Key::parse(key).map_err(fault)?, values })
    }
}

/// A key that follows a parameter: its value is the parameter's, times a factor, plus a constant.
///
/// # Examples
///
/// ```
/// use assur_sweep::Tie;
///
/// assert!(Tie::parse("link.lower.points.B=link.upper.points.A").is_ok());
/// assert!(Tie::parse("link.lower.points.B=link.upper.points.A*1.5").is_ok());
/// assert!(Tie::parse("link.lower.points.B=link.upper.points.A*1.5+20 mm").is_ok());
/// let error = Tie::parse("link.lower.points.B").unwrap_err();
/// assert_eq!(error.to_string(), "`link.lower.points.B`: write it as KEY=KEY, KEY=KEY*FACTOR or KEY=KEY*FACTOR+CONSTANT; the second key is varied");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Tie {
    pub(crate) key: Key,
    pub(crate) follows: Key,
    /// `None` where none is written, which is 1.
    pub(crate) factor: Option<f64>,
    /// What is added, as it is written; `None` where nothing is.
    pub(crate) added: Option<String>,
}

impl Tie {
    /// Reads `KEY=KEY`, `KEY=KEY*FACTOR`, each also with `+CONSTANT`; the second key is that of the parameter.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let fault = |problem: Text| SweepError::vary(text, problem);
        let (key, follows) = text.split_once('=').ok_or_else(|| fault(text!("sweep-write-tie")))?;
        // A number such as 1e+3 has a sign of its own.
        let (follows, added) = match follows.split_once('+').filter(|(before, _)| !is_exponent(before)) {
            Some((follows, added)) => (follows.trim_end(), Some(added.trim().to_owned())),
            None => (follows, None),
        };
        // A `*` in brackets stands for all elements of a list.
        let (follows, factor) = match follows.rsplit_once('*').filter(|(_, factor)| !factor.contains(']')) {
            Some((follows, factor)) => {
                let factor = factor.trim().parse().ok().filter(|factor: &f64| factor.is_finite());
                (follows, Some(factor.ok_or_else(|| fault(text!("sweep-write-tie")))?))
            }
            None => (follows, None),
        };
        Ok(Self {
            key: Key::parse(key).map_err(fault)?,
            follows: Key::parse(follows).map_err(fault)?,
            factor,
            added,
        })
    }
}

/// Whether a text ends within the exponent of a number: `2*1e`.
fn is_exponent(before: &str) -> bool {
    let digits = before.strip_suffix(['e', 'E']).unwrap_or_default();
    before.contains('*') && digits.ends_with(|letter: char| letter.is_ascii_digit() || letter == '.')
}

/// A place in the ground's frame whose distance from a point is measured.
///
/// # Examples
///
/// ```
/// use assur_sweep::Target;
///
/// assert!(Target::parse("E=100 mm,-20 mm").is_ok());
/// assert!(Target::parse("E=100 mm").is_err());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// As it is written.
    pub(crate) text: String,
    pub(crate) point: String,
    pub(crate) at: [f64; 2],
    /// Whether both coordinates are written without a unit.
    is_bare: bool,
}

impl Target {
    /// Reads `POINT=X,Y`, lengths with a unit, or in m.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let length = |text: &str| assur_scene::quantity(text.trim(), assur_scene::Dimension::Length).ok();
        let read = || {
            let (point, place) = text.split_once('=')?;
            let (x, y) = place.trim().trim_matches(['[', ']']).split_once(',')?;
            let is_bare = [x, y].iter().all(|text| text.trim().parse::<f64>().is_ok());
            let at = [length(x)?, length(y)?];
            Some(Self { text: text.to_owned(), point: point.trim().to_owned(), at, is_bare })
        };
        read().ok_or_else(|| SweepError::vary(text, text!("sweep-write-target")))
    }

    /// What is said of a place without units that lies far from a mechanism of this size, m.
    pub(crate) fn warning(&self, size: f64) -> Option<(Text, Text)> {
        /// A place so many sizes of the mechanism away was meant in mm.
        const FAR: f64 = 20.0;
        let [x, y] = self.at;
        (self.is_bare && elementary::hypot(x, y) > FAR * size).then(|| {
            let shown = |length: f64| quantity(format!("{length:.3e}").parse().unwrap_or(length), "m");
            let told = text!(
                "sweep-far-target",
                away = shown(elementary::hypot(x, y)),
                size = shown(size),
                instead = name(format!("{}={x} mm,{y} mm", self.point))
            );
            (joined(" ", [name("--target"), name(self.text.clone())]), told)
        })
    }
}

/// The values of a parameter as they are written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Written {
    /// Equally spaced ones, both ends among them.
    Range {
        /// First value.
        from: String,
        /// Last value.
        to: String,
        /// How many values of a grid, at least 1; of a sample 1.
        count: usize,
    },
    /// A list; where some have a unit, and all the same, it applies to the others too.
    Listed(Vec<String>),
    /// The cells of a column of a table, each with a unit of its own or in SI.
    Column(Vec<String>, Arc<Places>),
}

impl Written {
    /// The values of a list, or both ends.
    pub(crate) fn texts(&self) -> Vec<&str> {
        match self {
            Self::Range { from, to, .. } => vec![from, to],
            Self::Listed(values) | Self::Column(values, _) => values.iter().map(String::as_str).collect(),
        }
    }

    /// How many values there are.
    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Range { count, .. } => *count,
            Self::Listed(values) | Self::Column(values, _) => values.len(),
        }
    }

    /// Whether each value is written.
    pub(crate) fn is_list(&self) -> bool {
        !matches!(self, Self::Range { .. })
    }

    /// What is wrong with one of the texts, with its place where it is a cell of a table.
    pub(crate) fn located(&self, index: usize, problem: Text) -> Text {
        if let Self::Column(_, places) = self { places.told(index, problem) } else { problem }
    }
}

fn parse_values(range: &str, points: Points) -> Result<Written, Text> {
    let is_sample = matches!(points, Points::Sample { .. });
    let wrong = || if is_sample { text!("sweep-write-sample") } else { text!("sweep-write-grid") };
    if let (false, Some(listed)) = (is_sample, listed(range)) {
        return Ok(Written::Listed(listed));
    }
    let (ends, count) = if is_sample { (range, "1") } else { range.rsplit_once(':').ok_or_else(wrong)? };
    let (from, to) = ends.split_once("..").ok_or_else(wrong)?;
    let (from, to) = (from.trim(), to.trim());
    if from.is_empty() || to.is_empty() || to.contains(':') {
        return Err(wrong());
    }
    let found: Option<usize> = count.trim().parse().ok().filter(|count| *count > 0);
    let count = found.ok_or_else(|| text!("sweep-wrong-count", count = name(count.trim().to_owned())))?;
    Ok(Written::Range { from: from.to_owned(), to: to.to_owned(), count })
}

/// The values of a list, `90 mm,100 mm,125 mm`; `None` of what is none.
fn listed(range: &str) -> Option<Vec<String>> {
    let values: Vec<String> = range.split(',').map(|value| value.trim().to_owned()).collect();
    let is_list = values.len() > 1 && !range.contains("..") && values.iter().all(|value| !value.is_empty());
    is_list.then_some(values)
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
