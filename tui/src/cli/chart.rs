//! `assur chart`: provides the clock, shows the progress, handles Ctrl-C.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use assur_analysis::Options;
use assur_figure::svg;
use assur_report::{json, text as report};
use assur_study::chart::{self, ChartData, ChartError};
use assur_words::{Describe, text, text_of};
use clap::Args;
use signal_hook::consts::SIGINT;

use super::fault::{Fault, Status};
use super::options::Format;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::progress::{ProgressLine, clock};
use crate::session::Session;
use crate::still;

/// Exit status after Ctrl-C, the usual one in shells.
const INTERRUPTED: u8 = 130;

#[derive(Debug, Clone, Args)]
pub(crate) struct ChartArgs {
    /// Scene file; `-` is standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Every second setting and few repetitions: within five seconds
    #[arg(long)]
    quick: bool,
    /// Form of the chart
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Write to this file instead of standard output; one that ends in .svg or .png is a picture: error over time
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

const PAGE: [f64; 2] = [240.0, 200.0];

fn is_picture(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("svg") || ending.eq_ignore_ascii_case("png"))
}

pub(crate) fn run(args: &ChartArgs, style: Style) -> Result<Status, Fault> {
    let output = Output::of(args.output.as_deref(), &args.scene)?;
    let stop = on_interrupt()?;
    let session = scene::open(&args.scene, style)?;
    let options = Options { whole: true, ..Options::default() };
    let verdict = scene::verdict(&session, &scene::calculation(&session, &options, style)?, style)?;
    verdict.tell(style);
    let data = match charted(&session, args.quick, style, &stop)? {
        Ok(data) => data,
        Err(failure) => {
            style.tell(session.in_file(failure.describe()));
            return Ok(Status::Failed);
        }
    };
    let stopped = stop.load(Ordering::Relaxed);
    if stopped {
        style.tell(text!("cli-chart-stopped"));
    }
    let status = if stopped { Status::Code(INTERRUPTED) } else { verdict.status() };
    if let Some(path) = args.output.as_deref().filter(|path| is_picture(path)) {
        let svg = svg::write(&chart::figure(&data), PAGE, style.language);
        let picture = still::picture(svg, path, PAGE).map_err(Fault::Other)?;
        return output.write(picture, status);
    }
    let text = match args.format {
        Format::Text => report::told(style.words(), |page| data.tell(page)),
        Format::Json => json::to_json(&data, style.ascii_data).map_err(Fault::told)?,
        Format::Csv => chart::csv(&data).map_err(Fault::told)?,
    };
    output.write(text, status)
}

/// Ctrl-C sets the flag; a second Ctrl-C ends the program.
fn on_interrupt() -> Result<Arc<AtomicBool>, Fault> {
    let stop = Arc::new(AtomicBool::new(false));
    signal_hook::flag::register_conditional_shutdown(SIGINT, i32::from(INTERRUPTED), Arc::clone(&stop))
        .and_then(|_| signal_hook::flag::register(SIGINT, Arc::clone(&stop)))
        .map_err(|error| Fault::Other(text!("cli-no-interrupt", problem = text_of(&error))))?;
    Ok(stop)
}

/// The chart of one scene; the inner error says why a good scene has none.
fn charted(
    session: &Session,
    quick: bool,
    style: Style,
    stop: &AtomicBool,
) -> Result<Result<ChartData, ChartError>, Fault> {
    let linkage = scene::linkage(session)?;
    let options = if quick { chart::ChartOptions::QUICK } else { chart::ChartOptions::THOROUGH };
    let line = ProgressLine::new(style.language);
    let found = chart::chart(&linkage, &mut clock(), options, &mut |progress| {
        line.count(&progress.stage.heading(), progress.done, progress.total);
        if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    drop(line);
    match found {
        Err(error @ ChartError::Compile(_)) => Err(Fault::Scene(session.in_file(error.describe()))),
        other => Ok(other),
    }
}
