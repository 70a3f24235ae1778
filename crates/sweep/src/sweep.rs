//! The grid and its run.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};

use assur_analysis::Options;
use assur_mechanism::Mechanism;
use assur_scene::SceneErrors;
use assur_scene::edit::{Document, replaced};
use rayon::ThreadPoolBuilder;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::axis::{Axis, AxisValue};
use crate::row::{Row, SharedNames};
use crate::{Status, SweepError, Table, Vary, point};

/// Most points of a grid.
pub const MOST_POINTS: usize = 1_000_000;

/// A scene and a grid of parameters, ready to be run.
#[derive(Debug, Clone)]
pub struct Sweep {
    file: String,
    scene: String,
    axes: Vec<Axis>,
    points: usize,
}

impl Sweep {
    /// Finds the parameters in the scene. `file_name` is only repeated in errors.
    ///
    /// # Errors
    ///
    /// [`SweepError`]: a faulty scene, a parameter that is not in it or not a number, units that don't fit, too many points.
    pub fn of(file_name: &str, scene: &str, vary: &[Vary]) -> Result<Self, SweepError> {
        assur_scene::read(file_name, scene)?;
        if vary.is_empty() {
            return Err(SweepError::Nothing);
        }
        let points = points(vary)?;
        let document = Document::of(scene);
        let axis = |vary| Axis::of(vary, &document, file_name, scene);
        let axes = vary.iter().map(axis).collect::<Result<Vec<_>, _>>()?;
        for (index, axis) in axes.iter().enumerate() {
            if let Some(same) = axes[..index].iter().find(|other| other.span == axis.span) {
                return Err(SweepError::Twice { first: same.key.clone(), second: axis.key.clone() });
            }
        }
        Ok(Self { file: file_name.to_owned(), scene: scene.to_owned(), axes, points })
    }

    /// Points of the grid.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Calculates every point. The table does not depend on `threads`. `progress` receives the number of finished
    /// points; it is called from any thread.
    ///
    /// # Errors
    ///
    /// [`SweepError::AllRefused`] where no point makes a scene that can be calculated; [`SweepError::Threads`].
    pub fn run(
        &self,
        options: &Options,
        threads: NonZeroUsize,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Table, SweepError> {
        let threads = threads.get().min(self.points);
        let pool = ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.map_err(|error| SweepError::Threads { threads, problem: error.to_string() })?;
        let (done, names) = (AtomicUsize::new(0), SharedNames::default());
        let one = |index| {
            let row = self.row(index, options, &names);
            progress(done.fetch_add(1, Ordering::Relaxed) + 1);
            row
        };
        let rows: Vec<Row> = pool.install(|| (0..self.points).into_par_iter().map(one).collect());
        self.refuse_hopeless(&rows)?;
        Ok(Table::of(self.axes.iter().map(|axis| axis.column.clone()).collect(), rows))
    }

    /// Keys and values of a point: "link.crank.mass = 2 kg, drive.ratio = 24".
    pub fn describe(&self, index: usize) -> String {
        let each = self.axes.iter().zip(self.values(index));
        let each: Vec<_> = each.map(|(axis, value)| format!("{} = {}", axis.key, value.shown)).collect();
        each.join(", ")
    }

    /// The values of a point: the last parameter changes fastest.
    fn values(&self, index: usize) -> Vec<&AxisValue> {
        let mut rest = index;
        let from_last = self.axes.iter().rev().filter_map(|axis| {
            let value = axis.values.get(rest % axis.values.len());
            rest /= axis.values.len();
            value
        });
        let mut values: Vec<_> = from_last.collect();
        values.reverse();
        values
    }

    fn mechanism(&self, values: &[&AxisValue]) -> Result<Mechanism, SceneErrors> {
        let edits = self.axes.iter().zip(values).map(|(axis, value)| (&axis.span, value.toml.as_str()));
        assur_scene::read(&self.file, &replaced(&self.scene, edits))
    }

    fn row(&self, index: usize, options: &Options, names: &SharedNames) -> Row {
        let values = self.values(index);
        let row = match self.mechanism(&values) {
            Ok(mechanism) => point::row(mechanism, options, names),
            Err(errors) => {
                let first = errors.errors.first();
                let message = first.map(|error| format!("{} (line {})", error.message, error.line));
                Row::without(Status::Refused, &message.unwrap_or_default(), None)
            }
        };
        Row { parameters: values.iter().map(|value| value.si).collect(), ..row }
    }

    /// If no point of the grid can be calculated, the call is at fault, so there is no table.
    fn refuse_hopeless(&self, rows: &[Row]) -> Result<(), SweepError> {
        let hopeless = |row: &Row| matches!(row.status, Status::Refused | Status::Error);
        if !rows.iter().all(hopeless) {
            return Ok(());
        }
        let problem = match self.mechanism(&self.values(0)) {
            Err(errors) => errors.to_string(),
            Ok(_) => rows.first().map(|row| row.message.clone()).unwrap_or_default(),
        };
        Err(SweepError::AllRefused { point: self.describe(0), problem })
    }
}

/// The number of points of the grid, within the limit.
fn points(vary: &[Vary]) -> Result<usize, SweepError> {
    let product = vary.iter().try_fold(1_usize, |product, vary| product.checked_mul(vary.range.count));
    match product {
        Some(points) if points <= MOST_POINTS => Ok(points),
        other => {
            let points = other.map_or_else(|| "too many".to_owned(), |points| points.to_string());
            Err(SweepError::TooMany { points, most: MOST_POINTS })
        }
    }
}
