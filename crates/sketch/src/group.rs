//! Adds a group to a scene.

use assur_group::plane::plus;
use assur_words::{Text, text};

use crate::frame::Frame;
use crate::layout::layouts;
use crate::naming::Taken;
use crate::number::{FINEST, step_of};
use crate::reach::{BEST, Quality, quality};
use crate::shape::{Joint, Outer, Shape};
use crate::sketch::size_of;
use crate::tables::tables;
use crate::{Added, Addition, Fit, Names, Sketch, Target};

/// What is added, in the plane of the sketch.
pub(crate) struct Plan<'a> {
    /// The scene before.
    pub(crate) text: &'a str,
    pub(crate) sketch: &'a Sketch,
    pub(crate) addition: &'a Addition,
    pub(crate) shape: Shape,
    pub(crate) outer: Vec<Outer>,
    /// Names of the new links.
    pub(crate) links: Vec<String>,
    /// The points that are the pins, by pair; empty for slides.
    pub(crate) pins: Vec<String>,
    /// Names of all new points.
    pub(crate) points: Vec<String>,
    /// Of links without a pin the points that they get; of a group whose modes no pin tells apart, of one that carries a guide.
    pub(crate) own: Vec<(usize, String)>,
    /// The ends of a link that nothing holds.
    pub(crate) ends: [[f64; 2]; 2],
    /// The size of the mechanism, m.
    pub(crate) size: f64,
    /// The usual length of a rod to a slide, m.
    pub(crate) rod: f64,
    /// To multiples of this numbers are rounded, m.
    pub(crate) step: f64,
}

/// Adds something to a scene, with a target for each outer pair in the order of the pattern; a free link may have two places as targets.
/// `sketch` is of this scene. What is new is placed in the position that is drawn, with round lengths, so that it can be assembled
/// there, and in all positions where one of the arrangements that are tried allows it.
///
/// # Errors
///
/// What is wrong with a target or a name, in the reader's words, or with the text.
pub fn add(
    text: &str,
    sketch: &Sketch,
    addition: &Addition,
    targets: &[Target],
    names: &Names,
) -> Result<Added, Text> {
    let mut plan = Plan::of((text, sketch), addition, targets, names)?;
    let mut best: Option<(Quality, Added)> = None;
    for step in [plan.step, FINEST] {
        plan.step = step;
        try_all(text, &plan, &mut best)?;
        if best.as_ref().is_some_and(|(quality, _)| quality.0 > Fit::Nowhere) {
            break;
        }
    }
    let rigid_with = if addition.outer().len() > 1 { common_link(sketch, targets) } else { None };
    best.map(|(_, added)| Added { rigid_with, ..added }).ok_or_else(Text::default)
}

/// The link that has all targets: what is joined to it alone does not move against it.
fn common_link(sketch: &Sketch, targets: &[Target]) -> Option<String> {
    let links = &sketch.mechanism.links;
    let carries = |link: usize, target: &Target| match target {
        Target::Point(point) => {
            let point = sketch.mechanism.points.iter().find(|own| own.name.as_str() == point);
            point.is_some_and(|point| point.on(link).is_some())
        }
        Target::New { link: own, .. } | Target::Guide { link: own, .. } => links[link].name.as_str() == own,
    };
    let carries_all = |link: &usize| targets.iter().all(|target| carries(*link, target));
    let link = (0..links.len()).find(carries_all)?;
    Some(links[link].name.to_string())
}

/// Adds by each arrangement until one is best of all.
fn try_all(text: &str, plan: &Plan<'_>, best: &mut Option<(Quality, Added)>) -> Result<(), Text> {
    let joints: Vec<Joint> = plan.outer.iter().map(|outer| outer.joint).collect();
    for joints in layouts(&plan.shape, &joints, plan.size, plan.rod) {
        let frames = Frame::all(plan, &joints);
        let tables = tables(plan, &joints, &frames);
        let scene = assur_draft::append(text, &tables.toml)?;
        let quality = quality(&scene, &frames, plan);
        if best.as_ref().is_none_or(|(best, _)| quality > *best) {
            let (links, points, fit) = (plan.links.clone(), plan.points.clone(), quality.0);
            let (slides, fields) = (tables.slides, tables.fields);
            let added = Added { text: scene, links, points, slides, fields, fit, rigid_with: None };
            *best = Some((quality, added));
        }
        if quality == BEST {
            break;
        }
    }
    Ok(())
}

impl<'a> Plan<'a> {
    fn of(
        (text, sketch): (&'a str, &'a Sketch),
        addition: &'a Addition,
        targets: &[Target],
        names: &Names,
    ) -> Result<Self, Text> {
        let shape = Shape::of(addition);
        let is_free = shape.bonds.is_empty();
        let sorts = addition.outer();
        if !is_free && targets.len() != sorts.len() {
            return Err(text!("sketch-targets", needed = sorts.len(), given = targets.len()));
        }
        let step = step_of(sketch.size());
        let slides = shape.bonds[shape.inner..].iter().map(|bond| bond.slides);
        let outer =
            (1..).zip(targets).zip(slides).map(|(target, slides)| Outer::of(sketch, target, slides, step));
        let outer: Vec<Outer> = outer.collect::<Result<_, Text>>()?;
        let joints = outer.iter().map(|outer| outer.joint.place());
        let size = size_of(sketch.points().map(|(_, at)| at).chain(joints));
        // A rod on a crank alone must be longer than the crank.
        let is_crank = sketch.mechanism.links.len() <= 2;
        let rod = sketch.size() * if is_crank { 1.6 } else { 0.7 };
        refuse_same_pins(&shape, &outer)?;
        let mut taken = Taken::of(&sketch.mechanism);
        let links = taken.links(&shape, names)?;
        let mut points = Vec::new();
        let mut new = || -> Result<String, Text> {
            points.push(taken.point(names, points.len())?);
            Ok(points.last().cloned().unwrap_or_default())
        };
        let mut pins = Vec::with_capacity(shape.bonds.len());
        for (index, bond) in shape.bonds.iter().enumerate() {
            let known =
                index.checked_sub(shape.inner).and_then(|outer_index| outer[outer_index].point.clone());
            pins.push(match known {
                _ if bond.slides => String::new(),
                Some(known) => known,
                None => new()?,
            });
        }
        let mut own = Vec::new();
        for link in (0..shape.links).filter(|link| shape.pins(*link).next().is_none()) {
            own.push((link, new()?));
            if is_free {
                own.push((link, new()?));
            }
        }
        let tells = pins[..shape.inner].iter().any(|pin| !pin.is_empty()) || !own.is_empty();
        let has_modes = addition.plugin.is_some_and(|plugin| plugin.ways.most > 1);
        let carrier = shape.bonds[..shape.inner].iter().find_map(|bond| bond.on);
        if let (false, true, Some(link)) = (tells, has_modes, carrier) {
            own.push((link, new()?));
        }
        let ends = ends(sketch, targets, size);
        Ok(Self { text, sketch, addition, shape, outer, links, pins, points, own, ends, size, rod, step })
    }
}

/// One link can't have a point twice.
fn refuse_same_pins(shape: &Shape, outer: &[Outer]) -> Result<(), Text> {
    for link in 0..shape.links {
        let pins =
            shape.pins(link).filter_map(|bond| outer.get(bond.checked_sub(shape.inner)?)?.point.as_ref());
        let pins: Vec<&String> = pins.collect();
        if let Some(twice) = pins.iter().enumerate().find(|(index, pin)| pins[..*index].contains(pin)) {
            return Err(text!("sketch-same-point", name = crate::shape::quoted(twice.1)));
        }
    }
    Ok(())
}

/// The ends of a free link: the places of its targets, or above the mechanism.
fn ends(sketch: &Sketch, targets: &[Target], size: f64) -> [[f64; 2]; 2] {
    let mut given = targets.iter().filter_map(|target| match target {
        Target::New { at, .. } | Target::Guide { through: at, .. } => Some(*at),
        Target::Point(point) => sketch.place(point),
    });
    let above = || {
        let places: Vec<_> = sketch.points().map(|(_, at)| at).collect();
        let top = places.iter().map(|at| at[1]).fold(0.0, f64::max);
        let left = places.iter().map(|at| at[0]).fold(f64::INFINITY, f64::min);
        [if left.is_finite() { left } else { 0.0 }, top + 0.3 * size]
    };
    let first = given.next().unwrap_or_else(above);
    [first, given.next().unwrap_or_else(|| plus(first, [size, 0.0]))]
}
