//! The methods of a stage.

use assur_number::greater;
use assur_words::{Text, number, text};

use super::{Measurement, Reference};

/// The outcome of a run.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Verdict {
    /// Evaluations in one unit of work.
    pub(crate) evaluations: Option<u64>,
    /// Largest relative deviation; `None` without a result.
    pub(crate) error: Option<f64>,
    /// What failed.
    pub(crate) failure: Option<Text>,
}

impl Verdict {
    /// The outcome of a run over positions: the largest of their errors, and the failures.
    pub(crate) fn of_positions(
        evaluations: u64,
        errors: impl ExactSizeIterator<Item = Result<f64, Text>>,
    ) -> Self {
        let count = errors.len();
        let (mut worst, mut failures, mut first) = (None, 0, None);
        for error in errors {
            match error {
                Ok(error) => worst = Some(greater(worst.unwrap_or(0.0), error)),
                Err(why) => {
                    failures += 1;
                    first.get_or_insert(why);
                }
            }
        }
        let failure = first.map(|first| {
            if failures == count {
                return first;
            }
            let [failures, count] = [failures, count].map(number);
            text!("chart-some-positions", failures, count, first)
        });
        Self { evaluations: Some(evaluations), error: worst, failure }
    }

    /// The outcome of a run that gives one number: that number and its evaluations, or why there is none.
    pub(crate) fn of_number(solved: Result<(f64, usize), Text>, truth: f64) -> Self {
        match solved {
            Ok((found, count)) => {
                let error = ((found - truth) / truth).abs();
                Self { evaluations: Some(count as u64), error: Some(error), failure: None }
            }
            Err(why) => Self { failure: Some(why), ..Self::default() },
        }
    }
}

/// The work of a method at a setting, done once. With `true` it is compared with the reference; with `false` it is
/// timed, and its return value is ignored.
type Work<'a> = Box<dyn FnMut(bool) -> Verdict + 'a>;

/// A row that is not measured yet; without work it has its reason already.
pub(crate) struct Entry<'a> {
    pub(crate) row: Measurement,
    /// Units of work in one run.
    pub(crate) units: f64,
    pub(crate) work: Option<Work<'a>>,
}

impl<'a> Entry<'a> {
    /// A method whose run is one unit of work.
    pub(crate) fn run(row: Measurement, work: impl FnMut(bool) -> Verdict + 'a) -> Self {
        Self { row, units: 1.0, work: Some(Box::new(work)) }
    }

    /// A method that can't be measured.
    pub(crate) fn refused(mut row: Measurement, why: Text) -> Self {
        row.reason = Some(why);
        Self { row, units: 1.0, work: None }
    }
}

/// All methods of a stage, and their reference.
pub(crate) struct Field<'a> {
    pub(crate) reference: Reference,
    pub(crate) entries: Vec<Entry<'a>>,
}
