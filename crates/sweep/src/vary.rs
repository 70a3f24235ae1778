//! A parameter as a user writes it.

use assur_scene::edit::Key;

use crate::SweepError;
use crate::range::{self, Range};

/// One parameter of the grid: its key in the scene, and its values.
///
/// # Examples
///
/// ```
/// assert!(assur_sweep::Vary::parse("link.crank.points.A=100 mm..140 mm:5").is_ok());
/// let error = assur_sweep::Vary::parse("link.crank.mass=1..5").unwrap_err();
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
    /// Reads `KEY=FROM..TO:N`.
    ///
    /// # Errors
    ///
    /// [`SweepError::Vary`] where it is written otherwise.
    pub fn parse(text: &str) -> Result<Self, SweepError> {
        let fault = |problem: String| SweepError::vary(text, problem);
        let (key, range) = text.rsplit_once('=').unwrap_or((text, ""));
        let range = range::parse(range).map_err(fault)?;
        Ok(Self { key: Key::parse(key).map_err(fault)?, range })
    }

    /// The key.
    pub fn key(&self) -> String {
        self.key.to_string()
    }
}
