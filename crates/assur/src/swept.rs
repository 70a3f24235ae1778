//! A scene with many values of its numbers.

use std::num::NonZeroUsize;

use assur_report::csv::CsvCell;
use assur_sweep::{
    Columns, Condition, Measure, PointTable, Points, Rows, Sweep, SweepError, SweepRequest, Tally, Target,
    Tie, Vary,
};
use assur_words::Describe;

use crate::{Error, Scene};

/// What a sweep calculates besides its parameters, each text written as for the option of `assur sweep`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SweepOptions {
    /// Names of measures; the usual ones where none is named.
    pub measures: Vec<String>,
    /// Keys that follow parameters, such as `link.rocker.mass=link.coupler.mass*0.5`.
    pub ties: Vec<String>,
    /// Places from which the distance of a point is measured, such as `E=100 mm,50 mm`.
    pub targets: Vec<String>,
    /// What rows hold to be kept, all of it, such as `transmission > 40 deg`: a column, or a measure that gives one value, and a number in
    /// SI or with a unit.
    pub conditions: Vec<String>,
    /// The points, row by row, in place of parameters with ranges.
    pub points: Option<PointTable>,
    /// Instead of a grid so many points of a Sobol sequence; parameters are `KEY=FROM..TO` then.
    pub sample: Option<NonZeroUsize>,
    /// Seed of the sample.
    pub seed: u32,
    /// Whether extremes, means and root mean squares are found between the positions too.
    pub between: bool,
    /// The points of one part of several alone: its number from 1, and how many there are.
    pub part: Option<(NonZeroUsize, NonZeroUsize)>,
    /// Threads, on which no row depends; `None`: as many as the machine runs at once.
    pub threads: Option<NonZeroUsize>,
}

impl SweepOptions {
    /// The sweep of a scene, ready to be run.
    fn sweep(&self, scene: &Scene, vary: &[&str]) -> Result<Sweep, SweepError> {
        let sample = self.sample.map(|count| Points::Sample { count: count.get(), seed: self.seed });
        let (points, vary) = if let Some(table) = &self.points {
            (Points::Table, table.clone().vary(&scene.text)?)
        } else {
            let points = sample.unwrap_or_default();
            (points, vary.iter().map(|one| Vary::parse(one, points)).collect::<Result<_, _>>()?)
        };
        let request = SweepRequest {
            points,
            measures: Measure::named(&self.measures)?,
            ties: self.ties.iter().map(|tie| Tie::parse(tie)).collect::<Result<_, _>>()?,
            targets: self.targets.iter().map(|target| Target::parse(target)).collect::<Result<_, _>>()?,
            between: self.between,
            conditions: self.conditions.iter().map(|one| Condition::parse(one)).collect::<Result<_, _>>()?,
            ..SweepRequest::default()
        };
        Sweep::of(&scene.file, &scene.text, &vary, request)
    }
}

/// The rows of a sweep: one for each point, in their order, without those that a condition leaves out.
#[derive(Debug, Clone)]
pub struct SweepRows {
    points: Vec<usize>,
    names: Vec<String>,
    statuses: Vec<&'static str>,
    messages: Vec<String>,
    columns: Vec<Values>,
}

/// The cells of a column.
#[derive(Debug, Clone)]
enum Values {
    Numbers(Vec<f64>),
    Texts(Vec<String>),
}

/// Why rows end early.
enum Ended {
    Stopped,
    Failed(SweepError),
}

impl From<SweepError> for Ended {
    fn from(error: SweepError) -> Self {
        Self::Failed(error)
    }
}

pub(crate) fn of(
    scene: &Scene,
    vary: &[&str],
    options: &SweepOptions,
    goes_on: &mut dyn FnMut() -> bool,
) -> Result<SweepRows, Error> {
    let failed = |error: SweepError| match error {
        SweepError::Scene(errors) => Error::of_scene(&errors, &scene.text),
        error => Error::told(error.describe()),
    };
    if options.points.is_some() && !vary.is_empty() {
        return Err(Error::call("points of a table have all parameters: no ranges go with them"));
    }
    let sweep = options.sweep(scene, vary).map_err(failed)?;
    let (part, parts) = options.part.unwrap_or((NonZeroUsize::MIN, NonZeroUsize::MIN));
    let points = sweep.part(part.get(), parts.get());
    let threads = options.threads.or_else(|| std::thread::available_parallelism().ok());
    let (mut rows, mut tally) = (SweepRows::of(&sweep.columns), Tally::default());
    let taken = sweep.run(
        &points,
        threads.unwrap_or(NonZeroUsize::MIN),
        |rows| rows,
        |block| {
            tally.append(&Tally::of(&block));
            rows.append(&block);
            if goes_on() { Ok(()) } else { Err(Ended::Stopped) }
        },
    );
    match taken {
        Ok(()) if tally.is_hopeless() => Err(failed(sweep.all_refused(points.start))),
        Ok(()) => Ok(rows),
        Err(Ended::Stopped) => Err(Error::told(assur_analysis::Stopped.describe())),
        Err(Ended::Failed(error)) => Err(failed(error)),
    }
}

impl SweepRows {
    /// No rows yet.
    fn of(columns: &Columns) -> Self {
        let empty = |column| {
            if columns.is_text(column) { Values::Texts(Vec::new()) } else { Values::Numbers(Vec::new()) }
        };
        Self {
            points: Vec::new(),
            names: columns.names.clone(),
            statuses: Vec::new(),
            messages: Vec::new(),
            columns: (0..columns.names.len()).map(empty).collect(),
        }
    }

    fn append(&mut self, block: &Rows) {
        for row in block.written() {
            self.points.push(block.first + row);
            if let Some((status, message)) = block.status(row) {
                self.statuses.push(status.text());
                self.messages.push(message.to_owned());
            }
            for (column, values) in self.columns.iter_mut().enumerate() {
                match (block.cell(row, column), values) {
                    (CsvCell::Number(number), Values::Numbers(numbers)) => numbers.push(number),
                    (_, Values::Numbers(numbers)) => numbers.push(f64::NAN),
                    (CsvCell::Text(text), Values::Texts(texts)) => texts.push(text.to_owned()),
                    (_, Values::Texts(texts)) => texts.push(String::new()),
                }
            }
        }
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.statuses.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.statuses.is_empty()
    }

    /// The number of the point of each row, from 0: where a condition leaves rows out, with gaps.
    pub fn points(&self) -> &[usize] {
        &self.points
    }

    /// The names of the columns, as `assur sweep` writes them.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// How each point ended: `ok`, or what it lacks.
    pub fn statuses(&self) -> &[&'static str] {
        &self.statuses
    }

    /// What went wrong at each point; empty where nothing did.
    pub fn messages(&self) -> &[String] {
        &self.messages
    }

    /// Whether a column has texts; otherwise numbers.
    ///
    /// # Errors
    ///
    /// No column has the name; the error names the most similar.
    pub fn is_text(&self, name: &str) -> Result<bool, Error> {
        self.find("column", name, |values| Some(matches!(values, Values::Texts(_))))
    }

    /// The numbers of a column in SI; NaN where a point has none.
    ///
    /// # Errors
    ///
    /// No column of numbers has the name; the error names the most similar.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        self.find("column of numbers", name, |values| match values {
            Values::Numbers(numbers) => Some(&**numbers),
            Values::Texts(_) => None,
        })
    }

    /// The words of a column, such as `motor`; empty where a point has none.
    ///
    /// # Errors
    ///
    /// No column of texts has the name.
    pub fn texts(&self, name: &str) -> Result<&[String], Error> {
        self.find("column of texts", name, |values| match values {
            Values::Texts(texts) => Some(&**texts),
            Values::Numbers(_) => None,
        })
    }

    /// What `of` takes from a column by its name.
    fn find<'s, T>(
        &'s self,
        what: &str,
        name: &str,
        of: impl Fn(&'s Values) -> Option<T>,
    ) -> Result<T, Error> {
        let found = self.names.iter().position(|own| own == name).and_then(|index| of(&self.columns[index]));
        found.ok_or_else(|| {
            let known = self.names.iter().zip(&self.columns).filter(|(_, values)| of(values).is_some());
            Error::unknown(what, name, known.map(|(own, _)| own.as_str()))
        })
    }
}
