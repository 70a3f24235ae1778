//! The links that could drive a mechanism, and what its structure would be with each.

use assur_kinematics::{Linkage, decompose};
use assur_mechanism::{GROUND, InputPair, LinkId, Mechanism, Name, Named, PairId};
use assur_structure::StructureError;
use assur_words::{Describe, Text};
use serde::Serialize;

use crate::modes::GroupModes;
use crate::results::StructureReport;
use crate::results::structure::report;

/// Structure of a mechanism, and of the same links driven by another one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StructureStudy {
    /// Version of the form.
    pub format: u8,
    /// Title of the scene; may be empty.
    pub title: String,
    /// With the input of the scene; `None` where it gives no mechanism.
    pub structure: Option<StructureReport>,
    /// Why it gives none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub why: Option<Text>,
    /// Every possible input, if requested: links in the order of the scene, pinned to the ground or sliding on it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<PossibleInput>,
    /// Whether the input of the scene is pinned: its coordinate is an angle.
    #[serde(skip)]
    pub angular: bool,
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
    /// Why it gives none.
    pub why: Option<Text>,
    /// Whether its groups are of a lower class than those of the present input.
    pub simpler: bool,
}

impl StructureStudy {
    /// The structure of a compiled mechanism.
    pub fn of(linkage: &Linkage) -> Self {
        let structure = Some(report(linkage, true));
        let title = linkage.mechanism.title.clone();
        let angular = linkage.angular();
        Self { format: 1, title, structure, why: None, inputs: Vec::new(), angular, modes: Vec::new() }
    }

    /// Of a mechanism whose input gives none.
    pub fn without(mechanism: &Mechanism, error: &StructureError) -> Self {
        let why = Some(error.describe());
        let (title, angular) = (mechanism.title.clone(), mechanism.input.is_angle());
        Self { format: 1, title, structure: None, why, inputs: Vec::new(), angular, modes: Vec::new() }
    }

    /// Adds every possible input.
    pub fn add_inputs(&mut self, mechanism: &Mechanism) {
        self.inputs = inputs(mechanism);
    }

    /// Adds the modes of every group over the cycle.
    pub fn add_modes(&mut self, linkage: &Linkage) {
        self.modes = crate::modes::of(linkage);
    }

    /// The possible inputs that would make the groups simpler.
    pub fn simpler(&self) -> impl Iterator<Item = &PossibleInput> {
        self.inputs.iter().filter(|input| input.simpler)
    }
}

/// Every possible input of a mechanism, links in the order of the scene.
fn inputs(mechanism: &Mechanism) -> Vec<PossibleInput> {
    let mut found: Vec<PossibleInput> =
        possible(mechanism).into_iter().map(|(link, pair)| one(mechanism, link, pair)).collect();
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

fn one(mechanism: &Mechanism, link: LinkId, pair: InputPair) -> PossibleInput {
    let present = (link, pair) == (mechanism.input.link, mechanism.input.pair);
    let mut driven = mechanism.clone();
    (driven.input.link, driven.input.pair) = (link, pair);
    let found = decompose(&driven);
    let of = match pair {
        InputPair::Pin(point) => PairId::Pin(point),
        InputPair::Slide(slide) => PairId::Slide(slide),
    };
    PossibleInput {
        link: mechanism.named_link(link),
        pair: mechanism.named_pair(of),
        present,
        class: found.as_ref().ok().map(assur_structure::Structure::class),
        formula: found.as_ref().ok().map(|structure| structure.formula.clone()),
        why: found.err().map(|error| error.describe()),
        simpler: false,
    }
}
