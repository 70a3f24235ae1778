//! `assur report`: the explanatory note.

use std::path::PathBuf;

use clap::Args;

use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::files;
use crate::note;
use crate::screen::state::{Scene, Source};
use crate::screen::still;

/// Arguments of `report`.
#[derive(Debug, Clone, Args)]
pub(crate) struct ReportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Language of the note: en, uk, ru (default: `[note] language` of the scene)
    #[arg(long, value_name = "NAME", value_parser = ["en", "uk", "ru"])]
    language: Option<String>,
    /// File to write: one HTML file with all figures in it
    #[arg(short, long, value_name = "FILE.html")]
    output: PathBuf,
}

/// The languages, as the note names them.
const LANGUAGES: [&str; 3] = ["en", "uk", "ru"];

pub(crate) fn run(args: &ReportArgs, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(Some(&args.output), path)?;
    if args.output.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("html")) {
        return Err(Fault::other(format!("`{}` must end in .html", args.output.display())));
    }
    scene::options(&args.scene.methods)?;
    let text = files::read(path)?;
    let name = path.display().to_string();
    let mut note = assur_scene::note(&name, &text).map_err(|errors| scene::faults(&errors, style))?;
    if let Some(language) = LANGUAGES.into_iter().find(|known| args.language.as_deref() == Some(known)) {
        note.language = language;
    }
    let methods = [args.scene.methods.analyzer.clone(), args.scene.methods.integrator.clone()];
    let mut state = still::analyzed(still::open(path.clone())?, methods, true);
    let failed = state.found().is_none_or(|found| {
        let analysis = &found.analysis;
        analysis.no_motion.is_some() || analysis.checks.iter().any(assur_analysis::results::Check::failed)
    });
    let status = if failed { Status::Failed } else { Status::Done };
    let content = note::write(&mut state, &note).map_err(Fault::other)?;
    output.write(content, status).map(|()| status)
}

/// The note of a scene that is open in the terminal UI, from its name, its present text, and its methods.
///
/// # Errors
///
/// Why there is no note; in words.
pub(crate) fn of_text(name: &str, text: &str, methods: [Option<String>; 2]) -> Result<String, String> {
    let note = assur_scene::note(name, text).map_err(|errors| errors.to_string())?;
    let scene = Scene::read(Source::File(name.into()), text)?;
    note::write(&mut still::analyzed(scene, methods, true), &note)
}
