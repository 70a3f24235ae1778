//! `assur report`: the explanatory note.

use std::io::Write;
use std::path::PathBuf;

use assur_words::{Describe, Language, Text, name, text};
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

/// Arguments of `report`.
#[derive(Debug, Clone, Args)]
pub(crate) struct ReportArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// File to write; its ending chooses the form: .html and .typ are one file with all figures in it, .md has its figures
    /// in a folder beside it
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

/// The note is in the language that is asked for, or else in that of the scene.
pub(crate) fn run(args: &ReportArgs, language: Option<&str>, style: Style) -> Result<Status, Fault> {
    let path = &args.scene.scene;
    let output = Output::of(Some(&args.output), path)?;
    let ending = args.output.extension().unwrap_or_default().to_string_lossy().into_owned();
    let form = Form::of(&ending)
        .ok_or_else(|| text!("cli-note-ending", file = name(args.output.display().to_string())))
        .map_err(Fault::Other)?;
    scene::options(&args.scene.methods)?;
    let text = files::read(path)?;
    let file = path.display().to_string();
    let mut note = assur_scene::note(&file, &text).map_err(|errors| scene::faults(&errors))?;
    if let Some(language) = language.and_then(Language::find) {
        note.language = language.code;
    }
    let language = Language::find(note.language).unwrap_or_else(Language::english);
    let methods = [args.scene.methods.analyzer.clone(), args.scene.methods.integrator.clone()];
    let mut state = still::analyzed(still::open(path.clone())?, methods, true, language);
    let verdict = scene::verdict_of(&state, &args.scene, style)?;
    verdict.tell(style);
    let status = verdict.proved();
    let stem = args.output.file_stem().unwrap_or_default().to_string_lossy();
    let figures = format!("{stem}-figures");
    let written =
        note::write(&mut state, &note, form, &figures).map_err(|error| Fault::Other(error.describe()))?;
    if !written.figures.is_empty() {
        let folder = args.output.with_file_name(&figures);
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
pub(crate) fn of_text(file: &str, text: &str, methods: [Option<String>; 2]) -> Result<String, Text> {
    let note = assur_scene::note(file, text).map_err(|errors| name(errors.to_string()))?;
    let scene = Scene::read(Source::File(file.into()), text)?;
    let language = Language::find(note.language).unwrap_or_else(Language::english);
    let mut state = still::analyzed(scene, methods, true, language);
    note::write(&mut state, &note, Form::Html, "")
        .map(|written| written.text)
        .map_err(|error| error.describe())
}
