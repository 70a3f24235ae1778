//! Pictures of results as files.

use std::path::Path;

use assur_figure::{Figure, svg};
use assur_picture::{Look, Picture, Results, ViewPart};
use assur_png as png;
use assur_scene::nearest;
use assur_words::{Describe, Language, Text, Told, joined, list, name, number, text};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use strum::VariantNames;

/// Width and height of a page, mm: what A4 leaves between its margins, in a good ratio.
pub(crate) const PAGE: [f64; 2] = [160.0, 120.0];

/// What is drawn.
#[derive(Debug, Clone, Args)]
pub(crate) struct PictureArgs {
    /// View of the terminal UI that is drawn
    #[arg(long, value_name = "NAME", default_value = "mechanism", value_parser = views())]
    pub(crate) view: Picture,
    /// Part of the view: forces, velocities, accelerations, construction (plans); overview, causes, curves, hodograph
    /// (forces); overview, course, iteration, reduction (motion); overview, curves, places, energy-mass, inertia, reduction
    /// (drive)
    #[arg(long, value_name = "NAME")]
    pub(crate) part: Option<String>,
    /// Quantity, pair, link, group or method of a construction that is shown, found as by `/` in the terminal UI; several
    /// quantities or reactions with commas between them lie over each other
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

fn views() -> impl TypedValueParser<Value = Picture> {
    PossibleValuesParser::new(Picture::VARIANTS).try_map(|name| name.parse::<Picture>())
}

fn page(text: &str) -> Result<[f64; 2], Told> {
    let side = |text: &str| text.parse().ok().filter(|side| SIDES.contains(side));
    let sides =
        text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some([side(width)?, side(height)?]));
    sides.ok_or_else(|| {
        let [least, most] = [SIDES.start(), SIDES.end()].map(number);
        Told(text!("cli-write-size", least = least, most = most))
    })
}

/// A figure in the form that the ending of a file names.
pub(crate) fn picture(
    figure: &Figure,
    path: &Path,
    size: [f64; 2],
    language: &Language,
) -> Result<Vec<u8>, Text> {
    match path.extension().unwrap_or_default().to_string_lossy().to_lowercase().as_str() {
        "svg" => Ok(svg::write(figure, size, language).into_bytes()),
        "png" => png::write(figure, size, language).map_err(|error| error.describe()),
        _ => Err(text!("say-picture-ending", file = name(path.display().to_string()))),
    }
}

/// `; did you mean ...?` or nothing.
pub(crate) fn suggestion(word: &str, known: &[String]) -> Text {
    let near = nearest(word, known.iter().map(String::as_str));
    near.map_or_else(Text::default, |near| text!("say-offer", offer = name(near.to_owned())))
}

#[derive(Debug)]
pub(crate) enum StillError {
    /// The request has no meaning for this scene.
    Request(Text),
    /// The scene has nothing of this kind to show.
    Nothing(Text),
}

impl From<Text> for StillError {
    fn from(problem: Text) -> Self {
        Self::Request(problem)
    }
}

impl PictureArgs {
    /// Whether the checks belong to what is drawn: residuals are quantities too.
    pub(crate) fn shows_checks(&self) -> bool {
        self.show.is_some() && self.view == Picture::Curves
    }

    /// The part that is asked for.
    fn part(&self) -> Result<Option<ViewPart>, Text> {
        let (parts, Some(wanted)) = (self.view.parts(), &self.part) else { return Ok(None) };
        if parts.is_empty() {
            return Err(text!("draw-no-parts", view = name(<&str>::from(self.view))));
        }
        let part = parts.iter().find(|part| <&str>::from(**part) == wanted).copied();
        part.map(Some).ok_or_else(|| {
            let names = list(parts.iter().map(|part| name(<&str>::from(*part))));
            text!("draw-no-part", part = name(wanted.to_owned()), parts = names)
        })
    }
}

/// Time of one turn of an animation, s.
const TURN: f64 = 6.0;

/// The picture of the results of a scene that is asked for, in the form that the ending of `output` names.
pub(crate) fn draw(
    results: &Results,
    request: &PictureArgs,
    output: &Path,
    language: &'static Language,
) -> Result<Vec<u8>, StillError> {
    let size = request.size.unwrap_or(PAGE);
    let wanted = request.part()?;
    let mut look = Look { position: position(results, request.position)?, ..Look::default() };
    // A construction is drawn whole, unless a step is asked for.
    look.step = if wanted == Some(ViewPart::Construction) { usize::MAX } else { 0 };
    let part = request.view.part(results, &look, wanted);
    let picked = choose(results, request, part, &mut look, language)?;
    look.picked = &picked;
    // Several lie over each other as curves, and have no other part.
    let several = vec![ViewPart::Overview, ViewPart::Curves];
    let there = if picked.len() > 1 { several } else { request.view.parts_of(results, &look) };
    if let Some(wanted) = wanted.filter(|wanted| request.view.is_in(results) && !there.contains(wanted)) {
        let parts = list(there.into_iter().map(|part| name(<&str>::from(part))));
        return Err(text!("draw-no-part-here", part = name(<&str>::from(wanted)), parts).into());
    }
    let part = request.view.part(results, &look, wanted);
    if let Some(step) = request.step {
        look.step = step_of(results, &look, (request.view, part), step)?;
    }
    let of = |position| figure(results, request.view, &Look { position, ..look }, part);
    if !request.animate {
        return Ok(picture(&of(look.position)?, output, size, language)?);
    }
    if output.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("svg")) {
        return Err(text!("draw-svg-alone").into());
    }
    // One turn through all positions that exist.
    let title = name(results.linkage.mechanism.title.clone());
    let frames = results.assembled().map(|at| Ok(Figure { title: title.clone(), ..of(at)? }));
    let frames = frames.collect::<Result<Vec<_>, StillError>>()?;
    Ok(svg::animate(&frames, size, TURN, language).into_bytes())
}

fn position(results: &Results, wanted: usize) -> Result<usize, Text> {
    let last = results.positions() - 1;
    if wanted <= last {
        return Ok(wanted);
    }
    Err(text!("draw-no-position", position = number(wanted), last = number(last)))
}

/// Chooses what is to be shown by its name, or a position by its number. Several quantities, which are to lie over each other, and one
/// without derivatives are returned.
fn choose(
    results: &Results,
    request: &PictureArgs,
    part: ViewPart,
    look: &mut Look<'_>,
    language: &Language,
) -> Result<Vec<String>, Text> {
    let mut picked = Vec::new();
    let Some(sought) = request.show.as_ref().filter(|sought| !sought.is_empty()) else { return Ok(picked) };
    if let Ok(number) = sought.parse() {
        look.position = position(results, number)?;
        return Ok(picked);
    }
    let (is_curves, is_forces) = (request.view == Picture::Curves, request.view == Picture::Forces);
    let all: Vec<&str> = if is_curves || is_forces { sought.split(',').collect() } else { vec![sought] };
    for one in &all {
        look.column = 0;
        let found = look.choose(results, (request.view, part), one.trim(), |text| text.render(language));
        found.map_err(|known| {
            let offer = suggestion(one.trim(), &known);
            text!("say-not-found", text = name(one.trim().to_owned()), offer)
        })?;
        // The last series of a reaction is its modulus.
        let modulus = || results.found.as_ref()?.reactions.get(look.reaction)?.series.last().copied();
        let column = match modulus() {
            Some(index) if is_forces && all.len() > 1 => Some(results.series.len() + index),
            _ => Some(look.column)
                .filter(|column| is_curves && (all.len() > 1 || results.transfer_of(*column).is_none())),
        };
        picked.extend(column.and_then(|column| Some(results.column(column)?.short.clone())));
    }
    Ok(picked)
}

/// A step of the construction that is shown, counted from 1, as a step of all constructions.
fn step_of(results: &Results, look: &Look<'_>, of: (Picture, ViewPart), step: usize) -> Result<usize, Text> {
    let plans = results.found.as_ref().map(|found| found.plans.at(look.position));
    let is_drawn = of == (Picture::Plans, ViewPart::Construction);
    let Some(plans) = plans.filter(|plans| is_drawn && plans.step_count() > 0) else {
        let options = name("--view plans --part construction");
        return Err(text!("draw-step-of-construction", step = name("--step"), options = options));
    };
    let shown = look.step.min(plans.step_count() - 1);
    let mut steps = (0..plans.constructions.len()).map(|number| plans.steps_of(number));
    let steps = steps.find(|steps| steps.contains(&shown)).unwrap_or(0..0);
    if step == 0 || step > steps.len() {
        return Err(text!("draw-no-step", step = number(step), last = number(steps.len())));
    }
    Ok(steps.start + step - 1)
}

/// A picture says of which scene and position it is.
fn figure(results: &Results, view: Picture, look: &Look<'_>, part: ViewPart) -> Result<Figure, StillError> {
    // Several reactions lie over each other as curves.
    let view = if look.picked.len() > 1 { Picture::Curves } else { view };
    let figure = if view.is_in(results) { view.figure(results, look, part) } else { Figure::default() };
    if figure.panels.is_empty() {
        return Err(StillError::Nothing(view.missing(results, look, part).0));
    }
    if matches!(view, Picture::Mechanism | Picture::Structure) {
        return Ok(figure);
    }
    let of_scene = name(results.linkage.mechanism.title.clone());
    let parts = [of_scene, results.place(look.position), figure.title.clone()];
    let title = joined("; ", parts.into_iter().filter(|part| !part.is_empty()));
    Ok(Figure { title, ..figure })
}
