//! `assur report`: the explanatory note.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;

use super::fault::{Fault, Status};
use super::options::SceneArgs;
use super::output::Output;
use super::scene;
use super::style::Style;
use crate::files;
use crate::note::{self, Form};
use crate::screen::state::{Scene, Source};
use crate::screen::still;
use crate::words::LANGUAGES;

/// Arguments of `report`.
#[derive(Debug, Clone, Args)]
pub(crate) struct ReportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Language of the note: en, uk, ru (default: `[note] language` of the scene)
    #[arg(long, value_name = "NAME", value_parser = LANGUAGES)]
    language: Option<String>,
    /// File to write; its ending chooses the form: .html and .typ are one file with all figures in it, .md has its figures
    /// in a folder beside it
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

pub(crate) fn run(args: &ReportArgs, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(Some(&args.output), path)?;
    let ending = args.output.extension().unwrap_or_default().to_string_lossy().into_owned();
    let form = Form::of(&ending)
        .ok_or_else(|| Fault::other(format!("`{}` must end in .html, .md or .typ", args.output.display())))?;
    scene::options(&args.scene.methods)?;
    let text = files::read(path)?;
    let name = path.display().to_string();
    let mut note = assur_scene::note(&name, &text).map_err(|errors| scene::faults(&errors, style))?;
    if let Some(language) = LANGUAGES.into_iter().find(|known| args.language.as_deref() == Some(known)) {
        note.language = language;
    }
    let methods = [args.scene.methods.analyzer.clone(), args.scene.methods.integrator.clone()];
    let mut state = still::analyzed(still::open(path.clone())?, methods, true);
    let verdict = scene::verdict_of(&state, &args.scene, style)?;
    verdict.tell(style);
    let status = verdict.proved();
    let stem = args.output.file_stem().unwrap_or_default().to_string_lossy();
    let name = format!("{stem}-figures");
    let written = note::write(&mut state, &note, form, &name).map_err(Fault::other)?;
    if !written.figures.is_empty() {
        let folder = args.output.with_file_name(&name);
        let names: Vec<&str> = written.figures.iter().map(|(name, _)| name.as_str()).collect();
        Output::of(Some(&folder), path)?.write_folder(status, &names, &names, |files| {
            files
                .iter_mut()
                .zip(&written.figures)
                .try_for_each(|(file, (_, drawn))| file.write_all(drawn.as_bytes()))
        })?;
    }
    output.write(written.text, status).map(|()| status)
}

/// The note of a scene that is open in the terminal UI, from its name, its present text, and its methods.
///
/// # Errors
///
/// Why there is no note; in words.
pub(crate) fn of_text(name: &str, text: &str, methods: [Option<String>; 2]) -> Result<String, String> {
    let note = assur_scene::note(name, text).map_err(|errors| errors.to_string())?;
    let scene = Scene::read(Source::File(name.into()), text)?;
    let mut state = still::analyzed(scene, methods, true);
    let written = note::write(&mut state, &note, Form::Html, "").map_err(|error| error.to_string())?;
    Ok(written.text)
}
