//! Pictures of the views without a terminal.

use std::path::Path;
use std::sync::Arc;

use assur_analysis::{Coverage, Options, unwatched};
use assur_figure::{Figure, svg};
use assur_words::{self as words, Describe, Language, Text, Told, joined, list, name, number, text};
use clap::Args;
use clap::builder::PossibleValuesParser;

use super::command::{self, COMMANDS, PAGE, picture};
use super::state::{Keymap, Look, Scene, State, View, ViewPart};
use super::view;
use crate::session::Session;

/// What is drawn.
#[derive(Debug, Clone, Args)]
pub(crate) struct PictureArgs {
    /// View of the terminal UI that is drawn
    #[arg(long, value_name = "NAME", default_value = "mechanism", value_parser = PossibleValuesParser::new(views()))]
    pub(crate) view: String,
    /// Part of the view: forces, velocities, accelerations, construction (plans); overview, causes, curves, hodograph
    /// (forces); overview, course, iteration, reduction (motion); overview, curves, places, energy-mass, inertia, reduction
    /// (drive)
    #[arg(long, value_name = "NAME")]
    pub(crate) part: Option<String>,
    /// Quantity, pair, link, group or method of a construction that is shown, found as by `/` in the terminal UI; several
    /// quantities with commas between them lie over each other
    #[arg(long, value_name = "NAME")]
    pub(crate) show: Option<String>,
    /// Step up to which a construction is drawn, counted from 1; without it, all steps
    #[arg(long, value_name = "N")]
    pub(crate) step: Option<usize>,
    /// Position that is drawn
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) position: usize,
    /// Width and height of the page in mm (png: 10 pixels a mm), for example 160x120
    #[arg(long, value_name = "WxH", value_parser = page)]
    pub(crate) size: Option<[f64; 2]>,
    /// Let the drawing move through all positions (svg)
    #[arg(long)]
    pub(crate) animate: bool,
}

/// Sides of a page, mm.
const SIDES: std::ops::RangeInclusive<f64> = 20.0..=2000.0;

fn page(text: &str) -> Result<[f64; 2], Told> {
    let side = |text: &str| text.parse().ok().filter(|side| SIDES.contains(side));
    let sides =
        text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| {
        let [least, most] = [SIDES.start(), SIDES.end()].map(number);
        Told(text!("cli-write-size", least = least, most = most))
    })
}

#[derive(Debug)]
pub(crate) enum StillError {
    /// The request has no meaning for this scene.
    Request(Text),
    /// The scene has nothing of this kind to show.
    Nothing(Text),
}

impl PictureArgs {
    /// Whether the checks belong to what is drawn: residuals are quantities too.
    pub(crate) fn shows_checks(&self) -> bool {
        self.show.is_some() && self.view == View::Curves.command()
    }
}

/// Time of one turn of an animation, s.
const TURN: f64 = 6.0;

/// The views that have a picture.
pub(crate) fn views() -> Vec<&'static str> {
    use View::{Curves, Drive, Forces, Mechanism, Motion, Plans, Structure};
    [Mechanism, Curves, Forces, Plans, Motion, Drive, Structure].map(View::command).to_vec()
}

/// The picture of a view of an [`analyzed`] scene, in the form that the ending of `output` names.
///
/// # Errors
///
/// [`StillError`]: a request without a meaning, a view that has nothing to show.
pub(crate) fn draw(state: &mut State, request: &PictureArgs, output: &Path) -> Result<Vec<u8>, StillError> {
    let size = request.size.unwrap_or(PAGE);
    let wrong = StillError::Request;
    state.view = request.view.parse().unwrap_or(View::Mechanism);
    let last = state.positions() - 1;
    if request.position > last {
        let [position, last] = [request.position, last].map(number);
        return Err(wrong(text!("draw-no-position", position = position, last = last)));
    }
    state.position = request.position;
    if let Some(part) = &request.part {
        choose_part(state, part).map_err(wrong)?;
    }
    if let Some(name) =
        request.show.as_ref().filter(|names| state.view == View::Curves && names.contains(','))
    {
        command::pick_all(state, name.split(',')).map_err(|missing| {
            wrong(text!("say-not-found", text = words::name(missing.trim().to_owned())))
        })?;
    } else if let Some(name) = &request.show {
        command::search(state, name);
        if let Some((_, text)) = state.message.take() {
            return Err(wrong(text));
        }
    }
    if let Some(step) = request.step {
        choose_step(state, step).map_err(wrong)?;
    }
    if request.animate {
        return animation(state, output, size);
    }
    let figure = figure(state)?;
    picture(&figure, output, size, state.language()).map_err(wrong)
}

/// The state of a scene with its analysis done, and with its checks where they are wanted.
///
/// # Errors
///
/// Why there is no analysis: the text is complete, with file and line.
pub(crate) fn analyzed(
    session: &Arc<Session>,
    options: Options,
    checks: bool,
    language: &'static Language,
) -> Result<State, Text> {
    let mut scene = Scene::of(Arc::clone(session))?;
    let mut found = session.found(&options, &mut unwatched).map_err(|error| session.fault(&error))?;
    if checks {
        let all = found.plans.calculation().checks(Coverage::Sample, &mut unwatched);
        found.take_checks(all.map_err(|stopped| stopped.describe())?);
    }
    scene.found = Some(Box::new(found));
    let look = Look { language: language.code, ..Look::default() };
    let state = State::new(Some(scene), look, COMMANDS, Keymap::of(COMMANDS));
    Ok(State { options, ..state })
}

fn choose_part(state: &mut State, wanted: &str) -> Result<(), Text> {
    let (view, parts) = (state.view, state.view.parts());
    if parts.is_empty() {
        return Err(text!("draw-no-parts", view = name(view.command())));
    }
    let Some(part) = parts.iter().find(|part| <&str>::from(**part) == wanted) else {
        let names = list(parts.iter().map(|part| name(<&str>::from(*part))));
        return Err(text!("draw-no-part", part = name(wanted.to_owned()), parts = names));
    };
    state.parts.insert(view, *part);
    if *part == ViewPart::Construction {
        state.chosen.step = usize::MAX;
    }
    Ok(())
}

/// A step of the construction that is shown, counted from 1.
fn choose_step(state: &mut State, step: usize) -> Result<(), Text> {
    let plans = state.found().map(|found| found.plans.at(state.position));
    let is_drawn = state.view == View::Plans && state.part(View::Plans) == ViewPart::Construction;
    let Some(plans) = plans.filter(|plans| is_drawn && plans.step_count() > 0) else {
        let options = name("--view plans --part construction");
        return Err(text!("draw-step-of-construction", step = name("--step"), options = options));
    };
    let shown = state.chosen.step.min(plans.step_count() - 1);
    let steps = (0..plans.constructions.len()).map(|number| plans.steps_of(number));
    let steps = steps.into_iter().find(|steps| steps.contains(&shown)).unwrap_or(0..0);
    if step == 0 || step > steps.len() {
        return Err(text!("draw-no-step", step = number(step), last = number(steps.len())));
    }
    state.chosen.step = steps.start + step - 1;
    Ok(())
}

/// A picture says of which scene and position it is.
fn figure(state: &State) -> Result<Figure, StillError> {
    let figure = view::figure(state, state.view).ok_or_else(|| {
        let text =
            state.scene.as_ref().map(|scene| view::advice(state, scene, state.view)).unwrap_or_default();
        StillError::Nothing(text)
    })?;
    let Some(scene) =
        state.scene.as_ref().filter(|_| !matches!(state.view, View::Mechanism | View::Structure))
    else {
        return Ok(figure);
    };
    let of_scene = name(scene.linkage.mechanism.title.clone());
    let parts = [of_scene, scene.place(state.position), figure.title.clone()];
    let title = joined("; ", parts.into_iter().filter(|part| !part.is_empty()));
    Ok(Figure { title, ..figure })
}

/// One turn through all positions that exist.
fn animation(state: &mut State, output: &Path, size: [f64; 2]) -> Result<Vec<u8>, StillError> {
    if output.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("svg")) {
        return Err(StillError::Request(text!("draw-svg-alone")));
    }
    let mut frames = Vec::new();
    for position in 0..state.positions() {
        let exists = state.scene.as_ref().is_some_and(|scene| !scene.broken.contains_key(&position));
        state.position = position;
        if exists {
            frames.push(figure(state)?);
        }
    }
    let title = state.scene.as_ref().map(|scene| name(scene.linkage.mechanism.title.clone()));
    for frame in &mut frames {
        frame.title = title.clone().unwrap_or_default();
    }
    Ok(svg::animate(&frames, size, TURN, state.language()).into_bytes())
}
