//! A parameter as a user writes it.

use assur_scene::edit::Key;

use crate::range::{self, Range};
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
    /// Reads `KEY=FROM..TO:N` for a grid, `KEY=FROM..TO` for a sample.
    ///
    /// # Errors
    ///
    /// [`SweepError::Vary`] where it is written otherwise.
    pub fn parse(text: &str, points: Points) -> Result<Self, SweepError> {
        let fault = |problem: String| SweepError::vary(text, problem);
        let (key, range) = text.rsplit_once('=').unwrap_or((text, ""));
        let range = range::parse(range, points).map_err(fault)?;
        Ok(Self { key: Key::parse(key).map_err(fault)?, range })
    }

    /// The key.
    pub fn key(&self) -> String {
        self.key.to_string()
    }
}
