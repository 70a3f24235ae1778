//! Pictures of the views without a terminal.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use assur_figure::{Figure, svg};
use assur_words::{Language, Text, list, name, number, text};
use clap::Args;
use clap::builder::PossibleValuesParser;

use super::command::{self, COMMANDS, PAGE, picture};
use super::state::{Cancel, Job, Keymap, Look, Part, Purpose, Report, Scene, Source, State, View, Wish};
use super::{ScreenError, view, work};

/// What is drawn.
#[derive(Debug, Clone, Args)]
pub(crate) struct Request {
    /// View of the terminal UI that is drawn
    #[arg(long, value_name = "NAME", default_value = "mechanism", value_parser = PossibleValuesParser::new(views()))]
    pub(crate) view: String,
    /// Part of the view: forces, velocities, accelerations, construction (plans); overview, causes, curves, hodograph
    /// (forces); overview, course, iteration (motion); overview, curves, energy-mass, inertia, reduction (drive)
    #[arg(long, value_name = "NAME")]
    pub(crate) part: Option<String>,
    /// Quantity, pair or link that is shown, found as by `/` in the terminal UI
    #[arg(long, value_name = "NAME")]
    pub(crate) show: Option<String>,
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

fn page(text: &str) -> Result<[f64; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| SIDES.contains(side));
    let sides =
        text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| {
        format!("a size is two numbers of {} to {} mm, as in 160x120", SIDES.start(), SIDES.end())
    })
}

/// Why there is no picture.
#[derive(Debug)]
pub(crate) enum StillError {
    /// The request has no meaning for this scene.
    Request(Text),
    /// The scene has nothing of this kind to show.
    Nothing(Text),
}

impl Request {
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
pub(crate) fn draw(mut state: State, request: &Request, output: &Path) -> Result<Vec<u8>, StillError> {
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
        choose_part(&mut state, part).map_err(wrong)?;
    }
    if let Some(name) = &request.show {
        command::search(&mut state, name);
        if let Some((_, text)) = state.message.take() {
            return Err(wrong(text));
        }
    }
    if request.animate {
        return animation(&mut state, output, size);
    }
    let figure = figure(&state)?;
    picture(&figure, output, size, state.language()).map_err(wrong)
}

/// Reads a scene from a file.
///
/// # Errors
///
/// A scene that can't be read.
pub(crate) fn open(scene: PathBuf) -> Result<Scene, ScreenError> {
    work::open(Source::File(scene)).map_err(ScreenError::Scene)
}

/// The state of a scene with its analysis done, by a force analyzer and an integrator, and with its checks where they
/// are wanted.
pub(crate) fn analyzed(
    scene: Scene,
    [analyzer, integrator]: [Option<String>; 2],
    checks: bool,
    language: &'static Language,
) -> State {
    let look = Look { language: language.code, ..Look::default() };
    let mut state = State::new(Some(scene), look, COMMANDS, Keymap::of(COMMANDS));
    (state.analyzer, state.integrator) = (analyzer, integrator);
    command::ask(&mut state, Purpose::Main);
    for wish in std::mem::take(&mut state.wishes) {
        let Wish::Work(job) = wish else { continue };
        let cancel =
            if let Job::Calculate(request) = &job { request.cancel.clone() } else { Cancel::default() };
        let reports = RefCell::new(Vec::new());
        let last = work::run(&job, &|report| {
            if matches!(report, Report::Analyzed { .. }) && !checks {
                cancel.stop();
            }
            reports.borrow_mut().push(report);
        });
        for report in reports.into_inner().into_iter().chain([last]) {
            let wanted = checks || !matches!(report, Report::Checked { .. });
            if wanted && !matches!(report, Report::Counted { .. }) {
                command::take(&mut state, report);
            }
        }
    }
    // Checks that nobody asked for were not waited for.
    state.running.clear();
    state.message = None;
    state
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
    if *part == Part::Construction {
        state.chosen.step = usize::MAX;
    }
    Ok(())
}

fn figure(state: &State) -> Result<Figure, StillError> {
    view::figure(state, state.view).ok_or_else(|| {
        let text = state.scene.as_ref().map(|scene| view::advice(state, scene)).unwrap_or_default();
        StillError::Nothing(text)
    })
}

/// One turn through all positions that exist.
fn animation(state: &mut State, output: &Path, size: [f64; 2]) -> Result<Vec<u8>, StillError> {
    if output.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("svg")) {
        return Err(StillError::Request(text!("draw-svg-alone")));
    }
    let mut frames = Vec::new();
    for position in 0..state.positions() {
        let exists = state.scene.as_ref().is_some_and(|scene| scene.poses[position].is_some());
        state.position = position;
        if exists {
            frames.push(figure(state)?);
        }
    }
    if let Some(first) = frames.first_mut() {
        first.title = state
            .scene
            .as_ref()
            .map_or_else(Text::default, |scene| name(scene.linkage.mechanism.title.clone()));
    }
    Ok(svg::animate(&frames, size, TURN, state.language()).into_bytes())
}
