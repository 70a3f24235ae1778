//! `assur sweep`: reads the scene, shows the progress, writes the table.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use assur_sweep::{Sweep, SweepError, Table, Vary, parquet};
use clap::Args;

use super::fault::{Fault, Status};
use super::options::MethodArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::files::{self, FileError};
use crate::progress::ProgressLine;

/// Explanations of the columns whose names are not self-explanatory.
const COLUMNS: &str = "\
Columns, SI, the unit in the name; empty where something does not apply:
  KEY                    each parameter
  status, message        ok, no assembly, no solution, error, refused; the first failure in words
  smallest_health        least determinant of all groups over the positions; _at_: where
  balancing_greatest     greatest modulus of the balancing load; _at_: where
  balancing_mean         its mean with its sign; _mean_modulus: mean of the modulus
  reaction_P_greatest    greatest force in the pair P; _moment_greatest: greatest moment of a slide
  _min, _max, _travel    extremes over the positions
  flywheel, ratio, ...   periodic regime and drive; end_...: last state of a transient motion";

/// Arguments of `sweep`.
#[derive(Debug, Clone, Args)]
#[command(after_help = COLUMNS)]
pub(crate) struct SweepArgs {
    /// Scene file
    scene: PathBuf,
    /// N values of a number of the scene, equally spaced, both ends included, such as
    /// "link.crank.points.A=100 mm..140 mm:5"; once more for each further parameter, the last changes fastest
    #[arg(long, required = true, value_name = "KEY=FROM..TO:N", allow_hyphen_values = true)]
    vary: Vec<String>,
    /// Write to this file (*.csv or *.parquet) instead of CSV to standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Threads; the results don't depend on them [default: as many as the machine runs at once]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    #[command(flatten)]
    methods: MethodArgs,
}

/// Form of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Csv,
    Parquet,
}

pub(crate) fn run(args: &SweepArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let form = args.output.as_deref().map_or(Ok(Form::Csv), form)?;
    let options = scene::options(&args.methods)?;
    let text = files::read(&args.scene)?;
    let vary = args.vary.iter().map(|vary| Vary::parse(vary)).collect::<Result<Vec<_>, _>>();
    let file = args.scene.display().to_string();
    let fault = |error| fault(&args.scene, error, style);
    let sweep = Sweep::of(&file, &text, &vary.map_err(fault)?).map_err(fault)?;
    let line = ProgressLine::new();
    let points = sweep.points();
    let table =
        sweep.run(&options, threads(args), &|done| line.show(|| format!("{done} of {points} points")));
    drop(line);
    let table = table.map_err(fault)?;
    let status = tell_failures(&table, &sweep, style);
    let content = match form {
        Form::Csv => table.to_csv(style.ascii_data).map_err(Fault::other)?.into_bytes(),
        Form::Parquet => parquet::to_parquet(&table).map_err(Fault::other)?,
    };
    output.write(content, status).map(|()| status)
}

/// The format, from the name of the file; known before anything is calculated.
fn form(path: &Path) -> Result<Form, Fault> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let fault = |problem: String| FileError::write(path, problem).into();
    let form = match extension.as_deref() {
        // Whether the target is a device such as `/dev/null`.
        None | Some("csv") => Form::Csv,
        Some("parquet") => Form::Parquet,
        Some(_) => return Err(fault("name it *.csv or *.parquet".to_owned())),
    };
    match path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()) {
        Some(folder) => Err(fault(format!("there is no folder {}", folder.display()))),
        None => Ok(form),
    }
}

fn threads(args: &SweepArgs) -> NonZeroUsize {
    args.threads.or_else(|| std::thread::available_parallelism().ok()).unwrap_or(NonZeroUsize::MIN)
}

fn fault(path: &Path, error: SweepError, style: Style) -> Fault {
    match error {
        SweepError::Scene(errors) => scene::faults(&errors, style),
        SweepError::AllRefused { .. } => scene::in_file(path, &error.to_string()),
        error => Fault::other(error),
    }
}

/// Points without a solution are reported on standard error, the first one in full.
fn tell_failures(table: &Table, sweep: &Sweep, style: Style) -> Status {
    let failures: Vec<usize> = table.failures().collect();
    let first = failures.first().and_then(|row| Some((*row, table.status(*row)?)));
    let Some((row, (_, message))) = first else { return Status::Done };
    let (count, points) = (failures.len(), table.len());
    let point = sweep.describe(row);
    style.tell(&format!("error: no solution at {count} of {points} points; the first, {point}: {message}"));
    Status::Failed
}
