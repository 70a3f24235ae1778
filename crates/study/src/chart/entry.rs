//! What takes part in a stage.

use super::{Reference, Row};

/// A method at a setting that can do the work of its stage again and again.
pub(crate) trait Contestant {
    /// The work, to be timed: nothing is compared.
    fn run(&mut self);
    /// The same work once, compared with the reference.
    fn judge(&mut self) -> Verdict;
}

/// What a run gave.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Verdict {
    /// Evaluations in one unit of work.
    pub(crate) evaluations: Option<u64>,
    /// Largest relative deviation; `None` where nothing came out.
    pub(crate) error: Option<f64>,
    /// What failed.
    pub(crate) failure: Option<String>,
}

impl Verdict {
    /// Nothing came out.
    pub(crate) fn failed(why: &impl ToString) -> Self {
        Self { failure: Some(why.to_string()), ..Self::default() }
    }
}

/// A row in the making; without a contestant its reason stands already.
pub(crate) struct Entry<'a> {
    pub(crate) row: Row,
    /// Units of work in one run.
    pub(crate) units: f64,
    pub(crate) contestant: Option<Box<dyn Contestant + 'a>>,
}

impl<'a> Entry<'a> {
    /// A method that takes part.
    pub(crate) fn new(row: Row, units: usize, contestant: impl Contestant + 'a) -> Self {
        Self { row, units: units.max(1) as f64, contestant: Some(Box::new(contestant)) }
    }

    /// A method that can't take part.
    pub(crate) fn refused(mut row: Row, why: &(impl ToString + ?Sized)) -> Self {
        row.reason = Some(why.to_string());
        Self { row, units: 1.0, contestant: None }
    }
}

/// All that takes part in a stage, and by what it is judged.
pub(crate) struct Field<'a> {
    pub(crate) reference: Reference,
    pub(crate) entries: Vec<Entry<'a>>,
}
