//! Pictures of results as files.

use std::collections::HashSet;
use std::ops::Range;
use std::path::Path;

use assur_figure::{Figure, Page, dxf, one_scale, svg};
use assur_picture::{Arrows, Look, Picture, Results, ViewPart, find};
use assur_png as png;
use assur_scene::{by_likeness, nearest};
use assur_words::{Describe, Language, Text, Told, joined, list, name, number, text};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use strum::VariantNames;

/// A page as wide as A4 leaves it between its margins, in a good ratio.
const SIZE: [f64; 2] = [160.0, 120.0];
pub(crate) const PAGE: Page = Page::Within(SIZE);

/// What is drawn.
#[derive(Debug, Clone, Args)]
pub(crate) struct PictureArgs {
    /// View of the terminal UI that is drawn; without it the one that has the part, or the mechanism
    #[arg(long, value_name = "NAME", value_parser = views())]
    pub(crate) view: Option<Picture>,
    /// Part of the view: forces, velocities, accelerations, construction (plans); overview, causes, curves, hodograph
    /// (forces); overview, course, iteration, reduction (motion); overview, curves, places, energy-mass, inertia, reduction
    /// (drive); overview, events (structure)
    #[arg(long, value_name = "NAME")]
    pub(crate) part: Option<String>,
    /// Quantity, pair, link, group or method of a construction that is shown, found as by `/` in the terminal UI, or a strip of
    /// motion or drive by its heading; several quantities or reactions with commas between them lie over each other
    #[arg(long, value_name = "NAME")]
    pub(crate) show: Option<String>,
    /// Step up to which a construction is drawn, or group up to which force polygons are, counted from 1; without it, all
    #[arg(long, value_name = "N")]
    pub(crate) step: Option<usize>,
    /// Position that is drawn, of a transient motion the instant; several with commas between them beside each other, to one scale
    #[arg(long, value_name = "N", default_value = "0", value_delimiter = ',')]
    pub(crate) position: Vec<usize>,
    /// Vectors on the mechanism (default: velocities)
    #[arg(long, value_name = "KIND", value_parser = arrows())]
    pub(crate) arrows: Option<Arrows>,
    /// Width and height of the page in mm (png: 10 pixels a mm), for example 160x120; without it the page fits its drawing
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

fn arrows() -> impl TypedValueParser<Value = Arrows> {
    PossibleValuesParser::new(<Arrows as VariantNames>::VARIANTS).try_map(|name| name.parse::<Arrows>())
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

/// Whether a file is a drawing for CAD by its ending.
pub(crate) fn is_dxf(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("dxf"))
}

/// The SVG of a page in the form that the ending of a file names.
pub(crate) fn picture(svg: String, path: &Path, size: [f64; 2]) -> Result<Vec<u8>, Text> {
    match path.extension().unwrap_or_default().to_string_lossy().to_lowercase().as_str() {
        "svg" => Ok(svg.into_bytes()),
        "png" => png::write(&svg, size).map_err(|error| error.describe()),
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
        self.show.is_some() && self.view() == Picture::Curves
    }

    /// The view that is asked for, or else the first one that has the part.
    fn view(&self) -> Picture {
        let all = || Picture::VARIANTS.iter().filter_map(|name| name.parse::<Picture>().ok());
        let has = |view: &Picture| view.parts().iter().any(|part| self.part.as_deref() == Some(part.into()));
        self.view.or_else(|| all().find(has)).unwrap_or(Picture::Mechanism)
    }

    /// The part that is asked for.
    fn part(&self) -> Result<Option<ViewPart>, Text> {
        let (view, Some(wanted)) = (self.view(), &self.part) else { return Ok(None) };
        let parts = view.parts();
        if parts.is_empty() {
            return Err(text!("draw-no-parts", view = name(<&str>::from(view))));
        }
        let part = parts.iter().find(|part| <&str>::from(**part) == wanted).copied();
        part.map(Some).ok_or_else(|| {
            let names = list(parts.iter().map(|part| name(<&str>::from(*part))));
            text!("draw-no-part", part = name(wanted.to_owned()), parts = names)
        })
    }

    /// What is to be shown by its name; a number is a position.
    fn sought(&self) -> Option<&str> {
        self.show.as_deref().filter(|sought| !sought.is_empty() && sought.parse::<usize>().is_err())
    }

    fn positions(&self, results: &Results) -> Result<Vec<usize>, Text> {
        let shown = self.show.as_ref().and_then(|sought| sought.parse().ok());
        let wanted = shown.map_or_else(|| self.position.clone(), |position| vec![position]);
        let last = results.positions() - 1;
        match wanted.iter().find(|position| **position > last) {
            Some(beyond) => Err(text!("draw-no-position", position = number(*beyond), last = number(last))),
            None => Ok(wanted),
        }
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
    let (view, wanted, positions) = (request.view(), request.part()?, request.positions(results)?);
    if request.arrows.is_some() && !matches!(view, Picture::Mechanism | Picture::Structure) {
        return Err(text!("draw-no-arrows").into());
    }
    // All frames of an animation are on one page.
    let page = request.size.or(request.animate.then_some(SIZE)).map_or(PAGE, Page::Of);
    let arrows = request.arrows.unwrap_or_default();
    let alone = !request.animate && positions.len() == 1;
    let mut look = Look { position: positions[0], arrows, alone, ..Look::default() };
    // A construction is drawn whole, unless a step is asked for.
    look.step = if wanted == Some(ViewPart::Construction) { usize::MAX } else { 0 };
    let part = view.part(results, &look, wanted);
    let (picked, panels) = choose(results, request, part, &mut look, language)?;
    look.picked = &picked;
    // Several lie over each other as curves, and have no other part.
    let several = vec![ViewPart::Overview, ViewPart::Curves];
    let there = if picked.len() > 1 { several } else { view.parts_of(results, &look) };
    if let Some(wanted) = wanted.filter(|wanted| view.is_in(results) && !there.contains(wanted)) {
        let parts = list(there.into_iter().map(|part| name(<&str>::from(part))));
        return Err(text!("draw-no-part-here", part = name(<&str>::from(wanted)), parts).into());
    }
    let part = view.part(results, &look, wanted);
    let is_sequence = part == ViewPart::Forces && request.sought().is_none();
    let polygons =
        if is_sequence { polygons(results, &look, request.step)? } else { look.polygon..look.polygon + 1 };
    if let Some(step) = request.step.filter(|_| !is_sequence) {
        look.step = step_of(results, &look, part, step)?;
    }
    let of = |look: &Look<'_>| figure(results, view, look, part, &panels);
    if !request.animate {
        let row = |polygon| {
            let of = |position| of(&Look { position, polygon, ..look });
            positions.iter().copied().map(of).collect::<Result<_, _>>().map(to_one_scale)
        };
        let rows = polygons.map(row).collect::<Result<Vec<_>, StillError>>()?.concat();
        if is_dxf(output) {
            return Ok(dxf::write(&rows, language)?.into_bytes());
        }
        return sheet(&rows, positions.len(), page, output, language);
    }
    if output.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("svg")) {
        return Err(text!("draw-svg-alone").into());
    }
    animated(results, &of, &look, page, language)
}

/// One turn through all positions that exist.
fn animated(
    results: &Results,
    of: &dyn Fn(&Look<'_>) -> Result<Figure, StillError>,
    look: &Look<'_>,
    page: Page,
    language: &'static Language,
) -> Result<Vec<u8>, StillError> {
    let title = Text::from(&results.linkage.mechanism.title);
    let frame = |position| Ok(Figure { title: title.clone(), ..of(&Look { position, ..*look })? });
    let frames = results.frames().map(frame);
    let mut frames = to_one_scale(frames.collect::<Result<Vec<_>, StillError>>()?);
    // A text stands still: what has other numbers in each frame is left out.
    if frames.windows(2).any(|two| two[0].legend != two[1].legend) {
        for frame in &mut frames {
            frame.legend.clear();
        }
    }
    Ok(svg::animate(&frames, page, TURN, language).0.into_bytes())
}

/// The same figure of several positions: each of its panels has one scale in all.
fn to_one_scale(mut figures: Vec<Figure>) -> Vec<Figure> {
    for panel in 0..figures.first().map_or(0, |figure| figure.panels.len()) {
        one_scale(figures.iter_mut().filter_map(|figure| figure.panels.get_mut(panel)));
    }
    figures
}

/// Figures in rows of so many, or in about as many rows as columns, in the form that the ending of `output` names.
fn sheet(
    figures: &[Figure],
    row: usize,
    page: Page,
    output: &Path,
    language: &Language,
) -> Result<Vec<u8>, StillError> {
    let square = (1..=figures.len()).find(|side| side * side >= figures.len()).unwrap_or(1);
    let columns = if row > 1 { row } else { square };
    let (svg, size) = svg::sheet(figures, columns, page, language);
    Ok(picture(svg, output, size)?)
}

/// The force polygons of all groups, one after the other with the input link last, or up to a step.
fn polygons(results: &Results, look: &Look<'_>, step: Option<usize>) -> Result<Range<usize>, Text> {
    let plans = results.found.as_ref().map(|found| found.plans.at(look.position));
    let count = plans.and_then(|plans| Some(plans.sheet.as_ref().ok()?.polygons.len())).unwrap_or(0);
    match step {
        // Without any, the first one says why.
        _ if count == 0 => Ok(0..1),
        Some(step) if step == 0 || step > count => Err(no_step(step, count)),
        _ => Ok(0..step.unwrap_or(count)),
    }
}

fn no_step(step: usize, last: usize) -> Text {
    text!("draw-no-step", step = number(step), last = number(last))
}

/// Chooses what is to be shown by its name: the quantities that lie over each other, or one without derivatives; and strips.
fn choose(
    results: &Results,
    request: &PictureArgs,
    part: ViewPart,
    look: &mut Look<'_>,
    language: &Language,
) -> Result<(Vec<String>, Vec<usize>), Text> {
    let (view, mut picked, mut panels) = (request.view(), Vec::new(), Vec::new());
    let Some(sought) = request.sought() else { return Ok((picked, panels)) };
    let (is_curves, is_forces) = (view == Picture::Curves, view == Picture::Forces);
    let is_strips = matches!(view, Picture::Motion | Picture::Drive);
    let is_list = is_curves || is_forces || is_strips;
    let all: Vec<&str> =
        if is_list { sought.split(',').map(str::trim).collect() } else { vec![sought.trim()] };
    let strips = if is_strips { view.figure(results, look, part).panels } else { Vec::new() };
    // A heading goes on with the unit and the curves.
    let names =
        |heading: String| vec![heading.split([',', ':']).next().unwrap_or_default().to_owned(), heading];
    let strips: Vec<_> = strips.iter().map(|panel| names(panel.title.render(language))).collect();
    for one in &all {
        look.column = 0;
        let found = if is_strips {
            let strip = find::by_name(&strips, strips.len().saturating_sub(1), one);
            panels.extend(strip);
            strip.map(|_| ()).ok_or_else(|| strips.clone())
        } else {
            look.choose(results, (view, part), one, |text| text.render(language))
        };
        found.map_err(|known| not_found(one, &known))?;
        // The last series of a reaction is its modulus.
        let modulus = || results.found.as_ref()?.reactions.get(look.reaction)?.series.last().copied();
        let column = match modulus() {
            Some(index) if is_forces && all.len() > 1 => Some(results.series.len() + index),
            _ => Some(look.column)
                .filter(|column| is_curves && (all.len() > 1 || results.transfer_of(*column).is_none())),
        };
        picked.extend(column.and_then(|column| Some(results.column(column)?.short.clone())));
    }
    Ok((picked, panels))
}

/// Most names that an error lists.
const MOST_NAMES: usize = 12;

/// What is said where nothing has a name: what there is, by the first of all its names, with those most like it first.
fn not_found(sought: &str, known: &[Vec<String>]) -> Text {
    let firsts = known.iter().filter_map(|names| names.first()).map(String::as_str);
    let mut all = by_likeness(sought, firsts);
    let mut seen = HashSet::new();
    all.retain(|one| seen.insert(*one));
    let text = name(sought.to_owned());
    if all.is_empty() {
        return text!("say-not-found", text, offer = Text::default());
    }
    let shown = all.len().min(MOST_NAMES);
    let names = joined(", ", all[..shown].iter().map(|one| name((*one).to_owned())));
    let offer = if shown < all.len() {
        text!("say-there-are-more", names, more = all.len() - shown)
    } else {
        text!("say-there-are", names)
    };
    text!("say-not-found", text, offer)
}

/// A step of the construction that is shown, counted from 1, as a step of all constructions.
fn step_of(results: &Results, look: &Look<'_>, of: ViewPart, step: usize) -> Result<usize, Text> {
    let plans = results.found.as_ref().map(|found| found.plans.at(look.position));
    let Some(plans) = plans.filter(|plans| of == ViewPart::Construction && plans.step_count() > 0) else {
        let options = name("--view plans --part construction");
        return Err(text!("draw-step-of-construction", step = name("--step"), options = options));
    };
    let shown = look.step.min(plans.step_count() - 1);
    let mut steps = (0..plans.constructions.len()).map(|number| plans.steps_of(number));
    let steps = steps.find(|steps| steps.contains(&shown)).unwrap_or(0..0);
    if step == 0 || step > steps.len() {
        return Err(no_step(step, steps.len()));
    }
    Ok(steps.start + step - 1)
}

/// A picture says of which scene and position it is.
fn figure(
    results: &Results,
    view: Picture,
    look: &Look<'_>,
    part: ViewPart,
    panels: &[usize],
) -> Result<Figure, StillError> {
    // Several reactions lie over each other as curves.
    let view = if look.picked.len() > 1 { Picture::Curves } else { view };
    let mut figure = if view.is_in(results) { view.figure(results, look, part) } else { Figure::default() };
    if figure.panels.is_empty() {
        return Err(StillError::Nothing(view.missing(results, look, part).0));
    }
    if let Some(why) = assur_picture::missing(results, look) {
        return Err(StillError::Nothing(why));
    }
    if !panels.is_empty() {
        figure.panels = panels.iter().map(|panel| figure.panels[*panel].clone()).collect();
    }
    if matches!(view, Picture::Mechanism | Picture::Structure) {
        return Ok(figure);
    }
    let of_scene = Text::from(&results.linkage.mechanism.title);
    let parts = [of_scene, results.place(look.position), figure.title.clone()];
    let title = joined("; ", parts.into_iter().filter(|part| !part.is_empty()));
    Ok(Figure { title, ..figure })
}
