//! The links that could drive a mechanism, and what its structure would be with each.

use std::f64::consts::TAU;

use assur_group::Order;
use assur_kinematics::{Linkage, Position, decompose};
use assur_mechanism::{
    CoordinateKind, GROUND, InputPair, LinkId, Mechanism, Name, Named, PairId, Point, Range,
};
use assur_number::elementary;
use assur_structure::StructureError;
use assur_words::{Describe, Text};
use serde::Serialize;

use crate::{modes::GroupModes, results::StructureReport, results::structure::report};

/// Structure of a mechanism, and of the same links driven by another one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StructureStudy {
    /// Version of the form.
    pub format: u8,
    /// Title of the scene; may be empty.
    pub title: Name,
    /// The structure with the input of the scene; `None` where it gives no mechanism.
    pub structure: Option<StructureReport>,
    /// Why it gives none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<Text>,
    /// Every possible input, if requested: links in the order of the scene, pinned to the ground or sliding on it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<PossibleInput>,
    /// What the coordinate of the mechanism is.
    #[serde(skip)]
    pub kind: CoordinateKind,
    /// The modes of every group over the cycle, if requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub modes: Vec<GroupModes>,
}

/// A link that could be the input.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PossibleInput {
    /// The link.
    pub link: Named<LinkId>,
    /// Its pair with the ground.
    pub pair: Named<PairId>,
    /// Whether it is the input of the scene.
    pub present: bool,
    /// Class of the mechanism; `None` where this input gives none.
    pub class: Option<u8>,
    /// `I(ground,crank) -> II3(stone2,rocker)`.
    pub formula: Option<Name>,
    /// What would be passive: `link rod3`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub passive: Vec<Text>,
    /// Why it gives none.
    pub why: Option<Text>,
    /// Whether its groups are of a lower class than those of the present input.
    pub simpler: bool,
}

impl StructureStudy {
    /// The structure of a compiled mechanism.
    pub fn of(linkage: &Linkage) -> Self {
        Self::new(&linkage.mechanism, Some(report(linkage, true)), None)
    }

    /// The structure of a mechanism whose input leaves links loose or locked.
    pub fn without(mechanism: &Mechanism, error: &StructureError) -> Self {
        Self::new(mechanism, None, Some(error.describe()))
    }

    fn new(mechanism: &Mechanism, structure: Option<StructureReport>, why: Option<Text>) -> Self {
        let (title, kind) = (mechanism.title.clone(), mechanism.input.kind());
        Self { format: 1, title, structure, why, inputs: Vec::new(), kind, modes: Vec::new() }
    }

    /// Adds every possible input.
    pub fn add_inputs(&mut self, mechanism: &Mechanism, linkage: Option<&Linkage>) {
        let mut posed = mechanism.clone();
        let position = linkage.and_then(|linkage| {
            let mut position = linkage.position();
            linkage.solve_index(0, Order::Place, &mut position).ok().map(|()| position)
        });
        // Every input begins where the mechanism is in its first position.
        if let Some(position) = &position {
            let place = |point: &Point| {
                let place = point.places.first()?;
                Some(position.bodies[place.link].point(place.at))
            };
            let places = mechanism.points.iter().enumerate();
            posed.assembly = places.filter_map(|(id, point)| Some((id, place(point)?))).collect();
        }
        self.inputs = inputs(mechanism, &posed, position.as_ref());
    }

    /// The possible inputs that would make the groups simpler.
    pub fn simpler(&self) -> impl Iterator<Item = &PossibleInput> {
        self.inputs.iter().filter(|input| input.simpler)
    }
}

/// Every possible input of a mechanism, links in the order of the scene; none of a mechanism over time.
fn inputs(mechanism: &Mechanism, posed: &Mechanism, position: Option<&Position>) -> Vec<PossibleInput> {
    let Some(sole) = mechanism.input.sole() else { return Vec::new() };
    let present = (sole.link, sole.pair);
    let of = |input: (LinkId, InputPair)| {
        let present = input == present;
        one(if present { mechanism } else { posed }, input, present, position)
    };
    let relative = sole.is_relative().then_some(present);
    // A pin of a driven link may stand on the ground too: it is one input, the present one.
    let others = possible(mechanism).into_iter().filter(|input| relative != Some(*input));
    let mut found: Vec<PossibleInput> = relative.into_iter().chain(others).map(of).collect();
    let present = found.iter().find(|input| input.present).and_then(|input| input.class);
    for input in &mut found {
        input.simpler = input.class.zip(present).is_some_and(|(class, present)| class < present);
    }
    found
}

/// The pairs with the ground, each with the link that it joins to it.
fn possible(mechanism: &Mechanism) -> Vec<(LinkId, InputPair)> {
    let mut found = Vec::new();
    for (id, point) in mechanism.points.iter().enumerate() {
        let links = || point.places.iter().map(|place| place.link);
        if links().any(|link| link == GROUND) {
            found.extend(links().filter(|link| *link != GROUND).map(|link| (link, InputPair::Pin(id))));
        }
    }
    for (id, slide) in mechanism.slides.iter().enumerate() {
        let ends = [(slide.link, slide.on), (slide.on, slide.link)];
        found.extend(ends.iter().filter(|ends| ends.1 == GROUND).map(|ends| (ends.0, InputPair::Slide(id))));
    }
    found.sort_by_key(|(link, _)| *link);
    found
}

/// Coordinate of an input in a position, and a cycle of it.
fn begin(mechanism: &Mechanism, (link, pair): (LinkId, InputPair), position: &Position) -> (f64, Range) {
    let bodies = &position.bodies;
    match pair {
        InputPair::Pin(_) => (elementary::atan2(bodies[link].s, bodies[link].c), Range::Cycle(TAU)),
        InputPair::Slide(slide) => {
            let slide = &mechanism.slides[slide];
            let along = bodies[slide.on].turned([elementary::cos(slide.angle), elementary::sin(slide.angle)]);
            let [point, line] =
                [bodies[slide.link].point(slide.point), bodies[slide.on].point(slide.through)];
            let from = along[0] * (point[0] - line[0]) + along[1] * (point[1] - line[1]);
            let far = bodies.iter().map(|body| elementary::hypot(body.x, body.y)).fold(1e-3, f64::max);
            (from, Range::Cycle(far))
        }
    }
}

fn one(
    mechanism: &Mechanism,
    (link, pair): (LinkId, InputPair),
    present: bool,
    position: Option<&Position>,
) -> PossibleInput {
    let mut driven = mechanism.clone();
    if !present {
        let driver = &mut driven.input.drivers[0];
        (driver.link, driver.on, driver.pair) = (link, GROUND, pair);
    }
    if let Some(position) = position.filter(|_| !present) {
        (driven.input.from, driven.input.range) = begin(mechanism, (link, pair), position);
    }
    let found = decompose(&driven);
    let of = driven.input.first().pair_id();
    PossibleInput {
        link: mechanism.named_link(link),
        pair: mechanism.named_pair(of),
        present,
        class: found.as_ref().ok().map(assur_structure::Structure::class),
        formula: found.as_ref().ok().map(|structure| structure.formula.clone()),
        passive: found
            .iter()
            .flat_map(|structure| &structure.passive)
            .map(|one| one.part.words(mechanism))
            .collect(),
        why: found.err().map(|error| error.describe()),
        simpler: false,
    }
}
