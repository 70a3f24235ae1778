//! `assur sweep`: reads the scene, shows the progress, writes the rows.

mod lines;
mod parts;
mod summary;
mod target;

use std::fmt::Write;
use std::num::{NonZeroU32, NonZeroUsize};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use assur_sweep::{
    Best, Condition, Judged, MEASURES, Measure, Origin, PointTable, Points, Sweep, SweepError, SweepRequest,
    Tally, Target, Tie, Vary,
};
use assur_words::{Describe, Told, number, text};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::MethodArgs;
use super::output::{self, Output};
use super::scene;
use super::style::Style;
use super::table::Table;
use crate::files::{self, FileError};
use crate::lock;
use crate::progress::{ProgressLine, clock};
use target::{Form, begun, form};

/// A sweep of so many points tells beforehand how much it will write.
const LONG: usize = 100_000;

/// Bytes of a number in CSV with its comma: 17 digits, sign, point, exponent.
const BYTES_OF_NUMBER: f64 = 20.0;

/// What the measures are, and what columns there are besides.
fn columns() -> String {
    let mut help =
        "Measures; --measure default,NAME adds to those that are written by default (*):\n".to_owned();
    for measure in MEASURES {
        let mark = if measure.by_default { " *" } else { "" };
        let name = format!("{}{mark}", measure.name);
        let _ = writeln!(help, "  {name:<23}{}", measure.describe());
    }
    help + "  positions.KEY          least and greatest value, mean and root mean square of what a position has under KEY in the \
            JSON: positions.loads\n\n\
            Extremes, means and root mean squares are those over the positions of the scene; with --between those between them \
            too,\nas `assur analyze` reports them.\n\nColumns are in SI, the unit in the name, and empty where something does not apply. The first ones are row \
            (the number of\nthe point, from 0), each parameter, status (ok, no assembly, no solution, error, refused), message (the first failure) and \
            failed_positions."
}

#[derive(Debug, Clone, Args)]
#[command(after_help = columns())]
pub(crate) struct SweepArgs {
    /// Scene file; `-` is standard input
    scene: PathBuf,
    /// N values of a number of the scene, equally spaced, both ends included, such as
    /// "link.crank.points.A=100 mm..140 mm:5"; once more for each further parameter, the last changes fastest.
    /// Or a list of values: "link.crank.points.A=100 mm,110 mm,125 mm", of a text texts: "drive.motor=4A100L4,4A112M4". With --sample
    /// without N: KEY=FROM..TO
    #[arg(long, required_unless_present = "points", value_name = "KEY=VALUES", allow_hyphen_values = true)]
    vary: Vec<String>,
    /// Take the points from the rows of a table (*.csv or *.parquet) instead: its columns are keys of the scene, a number is in SI or has
    /// a unit ("90 mm"). Rows of an earlier sweep are such a table
    #[arg(long, value_name = "FILE", conflicts_with_all = ["vary", "sample"])]
    points: Option<PathBuf>,
    /// A key of the scene that follows a varied one: KEY=KEY gives it the same value, KEY=KEY*FACTOR a multiple, and +CONSTANT behind it adds
    /// to that, such as "+20 mm"
    #[arg(long, value_name = "KEY=KEY[*FACTOR][+CONSTANT]", allow_hyphen_values = true)]
    tie: Vec<String>,
    /// Measure the distance of a point from a place of the ground, such as "E=100 mm,50 mm"; once more for each further place
    #[arg(long, value_name = "POINT=X,Y", allow_hyphen_values = true)]
    target: Vec<String>,
    /// Instead of a grid N points that fill the ranges evenly (a Sobol sequence)
    #[arg(long, value_name = "N")]
    sample: Option<NonZeroUsize>,
    /// Seed of the sample
    #[arg(long, value_name = "S", default_value_t = 0, requires = "sample")]
    seed: u32,
    /// What is written of each point (below)
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', default_value = "default")]
    measure: Vec<String>,
    /// Find extremes, means and root mean squares between the positions too, as `assur analyze` reports them, instead of over the
    /// positions only, which is far faster
    #[arg(long)]
    between: bool,
    /// Write only rows that hold a condition, such as "transmission > 40 deg": a column, or a measure that gives one value, then <, <=,
    /// > or >= and a number in SI or with a unit. Once more for each further condition: all hold
    #[arg(long = "where", value_name = "COLUMN > VALUE", allow_hyphen_values = true)]
    conditions: Vec<String>,
    /// Tell the point with the least or the greatest value of a column, of the written points that are ok; `greatest:COLUMN` the other way
    #[arg(long, value_name = "least:COLUMN")]
    best: Option<String>,
    /// Write the scene of that point
    #[arg(long, value_name = "FILE.toml", requires = "best")]
    best_scene: Option<PathBuf>,
    /// Write to this file (*.csv or *.parquet) instead of CSV to standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Resume a sweep that was interrupted before FILE was complete
    #[arg(long, requires = "output")]
    resume: bool,
    /// Calculate part I of N; the parts of CSV, one after the other, are the whole
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<(NonZeroU32, NonZeroU32)>,
    /// Threads; the results don't depend on them [default: as many as the machine runs at once]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    #[command(flatten)]
    methods: MethodArgs,
}

fn shard(text: &str) -> Result<(NonZeroU32, NonZeroU32), Told> {
    let parts = text.split_once('/').and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
    let parts: Option<(NonZeroU32, NonZeroU32)> = parts.filter(|(part, of)| part <= of);
    parts.ok_or_else(|| Told(text!("cli-write-shard")))
}

pub(crate) fn run(args: &SweepArgs, style: Style) -> Result<Status, Fault> {
    // A target that is the scene itself is refused before anything is calculated.
    Output::of(args.output.as_deref(), &args.scene)?;
    let output = args.output.as_deref().filter(|path| !output::is_standard(path));
    let form = output.map_or(Ok(Form::Csv), form)?;
    let sweep = sweep(args, style)?;
    let job = Job { judge: judge(args, &sweep)?, ..Job::of(args, &sweep, style) };
    let best_scene = Output::of(args.best_scene.as_deref(), &args.scene)?;
    job.tell_size();
    if let Some(path) = output.filter(|path| !files::is_stream(path)) {
        job.refuse_without_room(path, form)?;
    }
    let mut elapsed = clock();
    let (status, tally) = match (output, form) {
        (Some(path), Form::Parquet) => parts::run(&job, path, args.resume),
        (path, _) => lines::run(&job, path, args.resume),
    }?;
    if let Some(best) = job.tell_best()
        && args.best_scene.is_some()
    {
        best_scene.write(sweep.scene(best), Status::Done)?;
    }
    summary::tell(&tally, elapsed(), &sweep, style);
    Ok(status)
}

/// What is looked for among the rows, and the index of its column.
fn judge(args: &SweepArgs, sweep: &Sweep) -> Result<Option<(Best, usize)>, Fault> {
    let best = args.best.as_deref().map(Best::parse).transpose()?;
    Ok(best.map(|best| best.find(&sweep.columns).map(|column| (best, column))).transpose()?)
}

fn sweep(args: &SweepArgs, style: Style) -> Result<Sweep, Fault> {
    let fault = |error| fault(&args.scene, error);
    let options = scene::options(&args.methods, false)?;
    let text = scene::open(&args.scene, style)?.text;
    let (points, vary) = points(args, &text)?;
    let request = SweepRequest {
        points,
        ties: each(&args.tie, Tie::parse).map_err(fault)?,
        targets: each(&args.target, Target::parse).map_err(fault)?,
        measures: Measure::named(&args.measure).map_err(fault)?,
        between: args.between,
        conditions: each(&args.conditions, Condition::parse).map_err(fault)?,
        options,
    };
    let sweep = Sweep::of(&files::shown(&args.scene), &text, &vary, request).map_err(fault)?;
    let warnings = sweep.warnings().into_iter();
    let told = warnings.map(|(point, note)| text!("cli-sweep-doubt", point, note));
    scene::tell_all(told.collect(), style)?;
    Ok(sweep)
}

/// What each of some texts of the command line says.
fn each<T>(texts: &[String], parse: fn(&str) -> Result<T, SweepError>) -> Result<Vec<T>, SweepError> {
    texts.iter().map(|text| parse(text)).collect()
}

/// The points, and the parameters with their values.
fn points(args: &SweepArgs, scene: &str) -> Result<(Points, Vec<Vary>), Fault> {
    let fault = |error| fault(&args.scene, error);
    let Some(file) = &args.points else {
        let sample = args.sample.map(|count| Points::Sample { count: count.get(), seed: args.seed });
        let points = sample.unwrap_or_default();
        let vary = args.vary.iter().map(|vary| Vary::parse(vary, points)).collect::<Result<_, _>>();
        return Ok((points, vary.map_err(fault)?));
    };
    let read = Table::open(file)?;
    let header = read.header.iter().map(String::as_str);
    let mut table = PointTable::new(&files::shown(file), read.numbering, header);
    for row in read.rows {
        let (at, cells) = row?;
        table.push(at, cells.iter().map(String::as_str)).map_err(fault)?;
    }
    Ok((Points::Table, table.vary(scene).map_err(fault)?))
}

fn fault(path: &Path, error: SweepError) -> Fault {
    match error {
        SweepError::Scene(errors) => Fault::scene(errors),
        SweepError::AllRefused(_) => FileError::read(path, error.describe()).into(),
        error => Fault::Other(error.describe()),
    }
}

/// A sweep, or a part of it, that is calculated now.
struct Job<'a> {
    scene: &'a Path,
    sweep: &'a Sweep,
    points: Range<usize>,
    /// Whether it has the first points, and with them the header.
    is_first: bool,
    threads: NonZeroUsize,
    style: Style,
    /// By what points are judged.
    judge: Option<(Best, usize)>,
    /// The best point so far.
    best: Mutex<Option<Judged>>,
}

impl<'a> Job<'a> {
    fn of(args: &'a SweepArgs, sweep: &'a Sweep, style: Style) -> Self {
        let (part, parts) = args.shard.unwrap_or((NonZeroU32::MIN, NonZeroU32::MIN));
        let [part, parts] = [part, parts].map(|number| number.get() as usize);
        let threads = args.threads.or_else(|| std::thread::available_parallelism().ok());
        let (points, threads) = (sweep.part(part, parts), threads.unwrap_or(NonZeroUsize::MIN));
        Self {
            scene: &args.scene,
            sweep,
            points,
            is_first: part == 1,
            threads,
            style,
            judge: None,
            best: Mutex::new(None),
        }
    }

    /// What the rows take as CSV, at most about.
    fn bytes(&self) -> f64 {
        self.points.len() as f64 * self.sweep.columns.names.len() as f64 * BYTES_OF_NUMBER
    }

    /// Refuses rows that need more room than the file system of the target has.
    fn refuse_without_room(&self, target: &Path, form: Form) -> Result<(), Fault> {
        // Parquet takes less than half of CSV.
        let needed = if form == Form::Parquet { 0.5 } else { 1.0 } * self.bytes();
        // How many rows conditions leave is not known.
        let room = files::free_beside(target).filter(|_| !self.sweep.has_conditions());
        let Some(free) = room else { return Ok(()) };
        if needed <= free as f64 + begun(target) as f64 {
            return Ok(());
        }
        let [needed, free] = [needed, free as f64].map(|bytes| number((bytes / 1e6).ceil()));
        Err(FileError::refused(target, text!("cli-sweep-no-room", needed, free)).into())
    }

    /// What its rows are made of, and which of all they are.
    fn origin(&self) -> Origin {
        let mut origin = self.sweep.origin();
        origin.insert("points".to_owned(), format!("{}..{}", self.points.start, self.points.end));
        origin
    }

    fn tell_size(&self) {
        let (rows, columns) = (self.points.len(), self.sweep.columns.names.len());
        if rows >= LONG {
            let megabytes = (self.bytes() / 1e6).ceil();
            let [rows, columns] = [rows, columns].map(number);
            self.style.tell(text!("cli-sweep-size", rows, columns, megabytes = number(megabytes)));
        }
    }

    fn run<T: Send>(
        &self,
        done: usize,
        encode: impl Fn(assur_sweep::Rows) -> Result<T, Fault> + Sync,
        mut accept: impl FnMut(T, Tally) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let (line, total) = (ProgressLine::new(self.style.language), self.points.len());
        line.count(&text!("progress-point"), done, total);
        let mut finished = done;
        let judge = self.judge.as_ref();
        let encode = |rows: assur_sweep::Rows| {
            let tally = Tally::of(&rows);
            let best = judge.and_then(|(judge, column)| judge.of(&rows, *column));
            encode(rows).map(|encoded| (encoded, tally, best))
        };
        let points = self.points.start + done..self.points.end;
        self.sweep.run(&points, self.threads, encode, |block| {
            let (encoded, tally, best) = block?;
            self.judge(best);
            finished += tally.points();
            accept(encoded, tally)?;
            line.count(&text!("progress-point"), finished, total);
            Ok(())
        })
    }

    /// Keeps the better of the best point so far and a later one.
    fn judge(&self, later: Option<Judged>) {
        if let Some((judge, _)) = &self.judge {
            let mut found = lock(&self.best);
            *found = judge.better(*found, later);
        }
    }

    /// If no point can be calculated, the call is at fault, so there is no table.
    fn refuse_hopeless(&self, tally: &Tally) -> Result<(), Fault> {
        if !tally.is_hopeless() {
            return Ok(());
        }
        Err(fault(self.scene, self.sweep.all_refused(self.points.start)))
    }

    /// Tells the best point, and returns its number.
    fn tell_best(&self) -> Option<usize> {
        let (judge, _) = self.judge.as_ref()?;
        let column = assur_words::name(judge.column().to_owned());
        let Some(Judged { point, value }) = *lock(&self.best) else {
            self.style.tell(text!("cli-sweep-no-best", column));
            return None;
        };
        let values = self.sweep.describe(point);
        self.style.tell(text!(
            "cli-sweep-best",
            column,
            value = number(value),
            point = number(point),
            values
        ));
        Some(point)
    }

    /// Points without a solution are reported on standard error, the first one in full; where conditions leave rows out, they are
    /// left out too.
    fn tell_failures(&self, tally: &Tally) -> Status {
        let Some(first) = tally.first_failure.filter(|_| !self.sweep.has_conditions()) else {
            return Status::Done;
        };
        self.style.tell(text!(
            "cli-sweep-failures",
            failures = number(tally.failures()),
            points = number(tally.points()),
            point = self.sweep.describe(first),
            message = self.sweep.failure(first).unwrap_or_default(),
        ));
        Status::Failed
    }
}

impl From<SweepError> for Fault {
    fn from(error: SweepError) -> Self {
        Self::told(error)
    }
}
