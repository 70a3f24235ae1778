//! A scene with its parameters, and the calculation of its points in threads.

use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::mpsc::{Receiver, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};

use assur_analysis::Options;
use assur_mechanism::Mechanism;
use assur_number::elementary;
use assur_scene::edit::ParsedText;
use assur_words::{Describe, Text, list, name, number, text};

use crate::axis::Axis;
use crate::condition::{Test, with_named};
use crate::layout::Layout;
use crate::measure::Measure;
use crate::point::Worker;
use crate::points::MOST_SAMPLED;
use crate::reach::Reach;
use crate::rows::{Columns, Rows, Status};
use crate::shape::same_shape;
use crate::variants::Variants;
use crate::{Condition, Points, SweepError, Target, Tie, Vary};

/// Most points of a sweep: at a million points a second they would take eleven days.
pub const MOST_POINTS: usize = 1_000_000_000_000;

/// Most points that a thread calculates before it hands on their rows.
const BLOCK: usize = 64;

/// Most numbers of these rows: with all that threads are [`AHEAD`], some megabytes for each of them.
const NUMBERS: usize = 1 << 15;

/// Blocks that a thread may be ahead of the writer: with a thread that does not get its turn for some milliseconds the others
/// need not wait.
const AHEAD: usize = 16;

/// Number of parts of a sweep, so that little is lost if it is ended early; and fewest rows of a part.
const PARTS: usize = 64;

/// Most rows of a part.
const MOST_ROWS: usize = 65_536;

/// Most numbers of a part: 64 MB, of which some copies are in memory.
const PART_NUMBERS: usize = 1 << 23;

/// What a sweep calculates.
#[derive(Debug, Clone, Default)]
pub struct SweepRequest {
    /// The points.
    pub points: Points,
    /// Keys that follow parameters.
    pub ties: Vec<Tie>,
    /// Places from which the distance of a point is measured.
    pub targets: Vec<Target>,
    /// The families of columns; the usual ones where none is named.
    pub measures: Vec<Measure>,
    /// Whether extremes, means and root mean squares are found between the positions too, as a report has them.
    pub between: bool,
    /// What written rows hold, all of it; a point without a solution holds none. A measure that one names is calculated.
    pub conditions: Vec<Condition>,
    /// The methods.
    pub options: Options,
}

/// A scene and the points at which it is calculated, ready to be run.
#[derive(Debug, Clone)]
pub struct Sweep {
    pub(crate) axes: Vec<Axis>,
    pub(crate) points: Points,
    pub(crate) variants: Variants,
    pub(crate) layout: Layout,
    pub(crate) measures: Vec<Measure>,
    /// Whether extremes and means are found between the positions too.
    pub(crate) between: bool,
    /// What written rows hold.
    pub(crate) conditions: Vec<Test>,
    pub(crate) options: Options,
    /// The columns of its rows.
    pub columns: Arc<Columns>,
    count: usize,
    /// What is probably not meant in the call itself.
    warnings: Vec<(Text, Text)>,
}

impl Sweep {
    /// Finds the parameters in the scene. `file_name` is only repeated in errors.
    ///
    /// # Errors
    ///
    /// [`SweepError`]: a faulty scene, a parameter that is not in it or not a number, units that don't fit, too many points.
    pub fn of(
        file_name: &str,
        scene: &str,
        vary: &[Vary],
        request: SweepRequest,
    ) -> Result<Self, SweepError> {
        let reading = assur_scene::reading(file_name, scene)?;
        if vary.is_empty() {
            return Err(SweepError::Request(text!("sweep-nothing-varied")));
        }
        let SweepRequest { points, ties, targets, measures, between, conditions, options } = request;
        let measures = if measures.is_empty() { Measure::defaults() } else { measures };
        let measures = with_named(measures, &conditions);
        let count = count(points, vary)?;
        let document = ParsedText::of(scene);
        let axis = |vary| Axis::of(vary, &document, &reading);
        let mut axes = vary.iter().map(axis).collect::<Result<Vec<_>, _>>()?;
        for tie in &ties {
            axes.push(Axis::tied(tie, &axes[..vary.len()], &document, &reading)?);
        }
        refuse_twice(&axes)?;
        let variants = Variants::of(file_name, scene, reading.mechanism, &axes);
        let richest = variants.richest(&axes).unwrap_or_else(|| variants.base.clone());
        let reach = Reach::of(&richest, &variants, &axes);
        let layout = |of: &Mechanism| Layout::of(of, &options, reach.clone(), (&measures, &targets));
        same_shape(&axes, &variants, &layout)?;
        let layout = layout(&richest)?;
        let places = richest.points.iter().flat_map(|point| &point.places);
        let size = places.map(|place| elementary::hypot(place.at[0], place.at[1])).fold(0.0, f64::max);
        let of_units = axes.iter().filter_map(|axis| Some((axis.told(axis.from), axis.warning()?)));
        let warnings = of_units.chain(targets.iter().filter_map(|target| target.warning(size))).collect();
        let names = layout.values.iter().map(|value| value.name.clone()).collect();
        let columns = Arc::new(Columns::new(&axes, names, layout.has_motor));
        let tests = conditions.into_iter().map(|condition| condition.among(&columns, &layout));
        let conditions = tests.collect::<Result<_, _>>()?;
        Ok(Self {
            axes,
            points,
            variants,
            layout,
            measures,
            between,
            conditions,
            options,
            columns,
            count,
            warnings,
        })
    }

    /// The parameters and what follows them, with their ranges, one text each, as they are given: `link.crank.mass=1 kg..5 kg:9`.
    pub(crate) fn ranges(&self) -> impl Iterator<Item = String> + '_ {
        let has_count = matches!(self.points, Points::Grid);
        self.axes.iter().map(move |axis| format!("{}={}", axis.key, axis.range(has_count)))
    }

    /// How many points there are.
    pub fn points(&self) -> usize {
        self.count
    }

    /// Whether some points are left out of what is written.
    pub fn has_conditions(&self) -> bool {
        !self.conditions.is_empty()
    }

    /// Whether a row is written: without conditions every one is, else those that are ok and hold them all.
    pub(crate) fn holds(&self, rows: &Rows, row: usize) -> bool {
        let is_ok = || rows.status(row).is_some_and(|(status, _)| status == Status::Ok);
        self.conditions.is_empty() || is_ok() && self.conditions.iter().all(|test| test.holds(rows, row))
    }

    /// Rows of each part of a Parquet file of `points` rows, except the last part: few enough to keep in memory.
    pub fn rows_of_part(&self, points: usize) -> usize {
        let few = points.div_ceil(PARTS).clamp(PARTS, MOST_ROWS);
        few.min(PART_NUMBERS / self.columns.names.len().max(1)).max(1)
    }

    /// The points of part `part` of `parts` (from 1), in which the points are divided in their order.
    pub fn part(&self, part: usize, parts: usize) -> Range<usize> {
        let parts = parts.max(1);
        // The product of two numbers of points may be too large.
        let start = |part: usize| self.count / parts * part + self.count % parts * part / parts;
        start(part.saturating_sub(1))..start(part.min(parts))
    }

    /// Calculates points of the sweep and hands on their rows block by block, in the order of the points, those that conditions leave
    /// out among them. The rows do not
    /// depend on `threads`; `encode` is called in these threads, `accept` in the caller's, and an error of it ends the run.
    ///
    /// # Errors
    ///
    /// The first error of `accept`; [`SweepError::Threads`].
    pub fn run<T: Send, E: From<SweepError>>(
        &self,
        points: &Range<usize>,
        threads: NonZeroUsize,
        encode: impl Fn(Rows) -> T + Sync,
        mut accept: impl FnMut(T) -> Result<(), E>,
    ) -> Result<(), E> {
        let together = BLOCK.min(NUMBERS / self.columns.names.len().max(1)).max(1);
        let blocks = points.len().div_ceil(together);
        // A thread takes the next block when it is free, notes that it has taken it, and has a channel of its own: the order
        // needs no sorting.
        let threads = threads.get().min(blocks);
        let (note, taken) = channel();
        let next = Mutex::new((0..blocks, note));
        let (encode, next) = (&encode, &next);
        let take = move |thread: usize| {
            let (blocks, note) = &mut *next.lock().unwrap_or_else(PoisonError::into_inner);
            blocks.next().filter(|_| note.send(thread).is_ok())
        };
        std::thread::scope(|scope| {
            let spawn = |thread: usize| {
                let (sender, receiver) = sync_channel(AHEAD);
                let work = move || {
                    let mut worker = Worker::new(self);
                    while let Some(block) = take(thread) {
                        let start = points.start + block * together;
                        let rows = worker.rows(start..points.end.min(start + together));
                        // The caller has ended the run.
                        if sender.send(encode(rows)).is_err() {
                            return;
                        }
                    }
                };
                let spawned = std::thread::Builder::new().spawn_scoped(scope, work);
                let problem = |error: std::io::Error| {
                    SweepError::Threads(text!("sweep-no-threads", threads, problem = name(error.to_string())))
                };
                spawned.map(|_| receiver).map_err(problem)
            };
            let receivers: Vec<Receiver<T>> = (0..threads).map(spawn).collect::<Result<_, _>>()?;
            for thread in taken.iter().take(blocks) {
                // A thread that panics closes its channel; the scope passes the panic on.
                let Ok(encoded) = receivers[thread].recv() else { break };
                accept(encoded)?;
            }
            Ok(())
        })
    }

    /// The row of one point.
    pub fn row(&self, index: usize) -> Rows {
        Worker::new(self).rows(index..index + 1)
    }

    /// The text of the scene of one point, its comments kept.
    pub fn scene(&self, index: usize) -> String {
        self.variants.text(&self.axes, &self.numbers(index))
    }

    /// Why one point has no values; `None` where it has.
    pub fn failure(&self, index: usize) -> Option<Text> {
        Worker::new(self).calculate(index).err().map(|failure| failure.message)
    }

    /// Keys and values of a point: "link.crank.mass = 2 kg, drive.ratio = 24".
    pub fn describe(&self, index: usize) -> Text {
        let numbers = self.numbers(index);
        list(self.axes.iter().zip(numbers).map(|(axis, number)| axis.told(number)))
    }

    /// What is probably not meant in the call and at the ends of the ranges, as far as the scene itself does not say it: "link.crank.mass = 3000 kg",
    /// and the note.
    pub fn warnings(&self) -> Vec<(Text, Text)> {
        let mut numbers: Vec<f64> = self.axes.iter().map(|axis| axis.from).collect();
        let known = &self.variants.base.warnings;
        let mut found = self.warnings.clone();
        for (index, axis) in self.axes.iter().enumerate().filter(|(_, axis)| axis.warning().is_none()) {
            for end in [axis.from, axis.to] {
                numbers[index] = end;
                let notes = self.variants.read(&self.axes, &numbers).map(|scene| scene.warnings);
                let new = notes.unwrap_or_default().into_iter().filter(|note| !known.contains(note));
                let told: Vec<_> = new
                    .filter(|note| known.iter().all(|other| other.key != note.key))
                    .map(|note| (axis.told(end), note.text))
                    .collect();
                found.extend(told);
                numbers[index] = axis.from;
            }
        }
        found
    }

    /// The error of a sweep without a point that can be calculated: then the call is at fault, and there is no table.
    pub fn all_refused(&self, first: usize) -> SweepError {
        let problem = match self.variants.read(&self.axes, &self.numbers(first)) {
            Err(errors) => errors.describe(),
            Ok(_) => self.failure(first).unwrap_or_default(),
        };
        SweepError::AllRefused(text!("sweep-all-refused", point = self.describe(first), problem))
    }

    fn numbers(&self, index: usize) -> Vec<f64> {
        let mut numbers = vec![0.0; self.axes.len()];
        self.points.numbers(&self.axes, index, &mut numbers);
        numbers
    }
}

/// Refuses two parameters that are the same value of the scene.
fn refuse_twice(axes: &[Axis]) -> Result<(), SweepError> {
    for (index, axis) in axes.iter().enumerate() {
        if let Some(same) = axes[..index].iter().find(|other| other.shares(axis)) {
            let [first, second] = [same, axis].map(|axis| name(axis.key.clone()));
            return Err(SweepError::Request(text!("sweep-twice", first, second)));
        }
    }
    Ok(())
}

/// The number of points, within the limits.
fn count(points: Points, vary: &[Vary]) -> Result<usize, SweepError> {
    if matches!(points, Points::Sample { .. }) && vary.len() > MOST_SAMPLED {
        let many = text!("sweep-many-parameters", count = vary.len(), most = MOST_SAMPLED);
        return Err(SweepError::Request(many));
    }
    let most = number(MOST_POINTS);
    let counts = vary.iter().map(|vary| vary.values.count());
    if points == Points::Table && counts.clone().any(|count| count != vary[0].values.count()) {
        let counts = list(counts.map(number));
        return Err(SweepError::Request(text!("sweep-uneven-lists", counts)));
    }
    Err(SweepError::Request(match points.count(counts) {
        Some(points) if points <= MOST_POINTS => return Ok(points),
        Some(points) => text!("sweep-many-points", points = number(points), most),
        None => text!("sweep-uncounted-points", most),
    }))
}
