//! An open scene: the session with its results.

use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use assur_picture::{Found, Results};
use assur_words::Text;

use crate::session::Session;
use crate::verdict::Verdict;

#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) session: Arc<Session>,
    pub(crate) results: Results,
    pub(crate) verdict: Verdict,
    pub(crate) fault: Option<Text>,
}

impl Scene {
    /// Compiles a scene and solves its positions.
    ///
    /// # Errors
    ///
    /// The errors as text, complete with file and line.
    pub(crate) fn of(session: impl Into<Arc<Session>>) -> Result<Self, Text> {
        let session = session.into();
        let results = session.positions()?;
        Ok(Self { session, results, verdict: Verdict::default(), fault: None })
    }

    /// Finds what is to be reported of the analysis.
    pub(crate) fn judge(&mut self) {
        let found = self.results.found.as_deref();
        let of = |found: &Found| Verdict::of(&found.analysis, found.plans.calculation(), None);
        self.verdict = found.map(of).unwrap_or_default();
    }
}

impl Deref for Scene {
    type Target = Results;

    fn deref(&self) -> &Results {
        &self.results
    }
}

impl DerefMut for Scene {
    fn deref_mut(&mut self) -> &mut Results {
        &mut self.results
    }
}
