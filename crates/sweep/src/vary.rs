//! A parameter as a user writes it.

use assur_mechanism::Key;
use assur_number::elementary;
use assur_scene::edit::decimal;
use assur_words::{Text, joined, name, quantity, text};

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
    pub(crate) range: Range,
}

impl Vary {
    /// Reads `KEY=FROM..TO:N` or `KEY=VALUE,VALUE,...` for a grid, `KEY=FROM..TO` for a sample.
    pub fn parse(text: &str, points: Points) -> Result<Self, SweepError> {
        let fault = |problem: Text| SweepError::vary(text, problem);
        let (key, range) = text.rsplit_once('=').unwrap_or((text, ""));
        let range = parse_range(range, points).map_err(fault)?;
        Ok(Self { key: Key::parse(key).map_err(fault)?, range })
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
pub(crate) struct Range {
    /// First value.
    pub(crate) from: String,
    /// Last value.
    pub(crate) to: String,
    /// How many values of a grid, at least 1; of a sample 1.
    pub(crate) count: usize,
    /// All values, where they are listed; else none.
    pub(crate) listed: Vec<String>,
}

impl Range {
    /// What is written: the values of a list, or both ends.
    pub(crate) fn written(&self) -> Vec<&str> {
        if self.listed.is_empty() {
            vec![&self.from, &self.to]
        } else {
            self.listed.iter().map(String::as_str).collect()
        }
    }
}

pub(crate) fn parse_range(range: &str, points: Points) -> Result<Range, Text> {
    let wrong = || match points {
        Points::Grid => text!("sweep-write-grid"),
        Points::Sample { .. } => text!("sweep-write-sample"),
    };
    if let (Points::Grid, Some(listed)) = (points, listed(range)) {
        let (from, to) = (listed[0].clone(), listed[listed.len() - 1].clone());
        return Ok(Range { from, to, count: listed.len(), listed });
    }
    let (ends, count) = match points {
        Points::Grid => range.rsplit_once(':').ok_or_else(wrong)?,
        Points::Sample { .. } => (range, "1"),
    };
    let (from, to) = ends.split_once("..").ok_or_else(wrong)?;
    let (from, to) = (from.trim(), to.trim());
    if from.is_empty() || to.is_empty() || to.contains(':') {
        return Err(wrong());
    }
    let found: Option<usize> = count.trim().parse().ok().filter(|count| *count > 0);
    let count = found.ok_or_else(|| text!("sweep-wrong-count", count = name(count.trim().to_owned())))?;
    Ok(Range { from: from.to_owned(), to: to.to_owned(), count, listed: Vec::new() })
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
