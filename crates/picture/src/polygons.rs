//! Force polygons of groups and of the input links, with the symbols that forces have on the links, and what acts on the links as a list.

use assur_diagram::{JointForce, PlanVector, VectorPlan};
use assur_figure::Figure;
use assur_force::VectorKind;
use assur_mechanism::{LinkId, PairId};
use assur_words::{Text, joined, name, text};

use crate::plans::{Shown, labelled, length, panel_of, shown};
use crate::rubbing::{Rubbing, rubbing};
use crate::{Look, Results, ViewPart, arrows};

/// Two vectors that differ by no more than this part are one.
const SAME: f64 = 1e-9;

/// The polygon of some links in a position, whose vectors have the symbols that they have on the links, where forces and moments from
/// outside act on these; a part of a force, and the reaction within a group, has the name of the plan. What a symbol stands for, and its
/// size, [`acting`] says.
pub fn polygon(results: &Results, position: usize, polygon: usize, links: &[LinkId]) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let plans = found.plans.at(position);
    let look = Look { position, polygon, ..Look::default() };
    let Shown::Plan(plan) = shown(found, &look, ViewPart::Forces, &plans) else { return Figure::default() };
    let acting = arrows::Shown::on_links(results, position, links);
    let acting = acting.as_ref().map_or(&[][..], arrows::Shown::all);
    let named = named(results, plan, acting);
    let panel = panel_of(ViewPart::Forces, plan, &named);
    Figure { title: plan.title.clone(), ..Figure::of(panel) }
}

/// What acts on some links, or within their group.
#[derive(Debug, Clone, PartialEq)]
pub struct Acting {
    /// Its symbol in the drawing.
    pub symbol: Text,
    /// What it is.
    pub told: Text,
    /// Its size, in this unit: of a force its modulus, of a moment counter-clockwise.
    pub size: f64,
    /// N or N m.
    pub unit: &'static str,
}

/// What acts on some links in a position, with its size: the vectors of their polygon, then the moments.
pub fn acting(results: &Results, position: usize, polygon: usize, links: &[LinkId]) -> Vec<Acting> {
    let shown = arrows::Shown::on_links(results, position, links);
    let arrows = shown.as_ref().map_or(&[][..], arrows::Shown::all);
    let told = |own: &arrows::Arrow| {
        if own.of_pair { text!("assembly-reaction", of = &own.told) } else { own.told.clone() }
    };
    let force = |(symbol, item): (Text, PlanVector)| {
        let known = same(arrows, &item).filter(|own| !own.told.is_empty());
        let inner = || match item.kind {
            VectorKind::Inner => text!("assembly-inner-reaction"),
            _ => item.name.clone(),
        };
        Acting { symbol, told: known.map_or_else(inner, told), size: item.size, unit: "N" }
    };
    let moments = arrows.iter().filter(|own| own.kind == arrows::Kind::Moment);
    let moment = |own: &arrows::Arrow| {
        let symbol = own.name.clone();
        Acting { symbol, told: told(own), size: own.vector[0], unit: "N m" }
    };
    let forces = vectors(results, position, polygon, links).into_iter().map(force);
    forces.chain(moments.map(moment)).chain(within(results, position, links)).collect()
}

/// What acts in the pairs of some links beside the forces and moments from outside: the moments of the inner slides, the friction of
/// the inner pins, and that of all slides, which is a part of their reactions.
fn within(results: &Results, position: usize, links: &[LinkId]) -> Vec<Acting> {
    let of_slides = inner_moments(results, position, links).into_iter();
    let is_shown = |own: &Rubbing| match own.pair {
        PairId::Pin(_) => own.links.iter().all(|link| links.contains(link)),
        PairId::Slide(_) => links.contains(&own.links[0]),
    };
    let friction = rubbing(results, position, links).into_iter().filter(is_shown);
    let friction = friction.map(|own| {
        let is_moment = matches!(own.pair, PairId::Pin(_));
        let size = if is_moment { own.size } else { own.size.abs() };
        Acting { symbol: own.symbol, told: own.told, size, unit: if is_moment { "N m" } else { "N" } }
    });
    of_slides.chain(friction).collect()
}

/// The moments of the slides between some links.
fn inner_moments(results: &Results, position: usize, links: &[LinkId]) -> Vec<Acting> {
    let Some((pose, state)) = results.moving(position, 0.0) else { return Vec::new() };
    let found = results.found.as_deref().and_then(|found| found.plans.calculation().reactions(&state, &pose));
    let (slides, scale) = (&results.linkage.mechanism.slides, results.linkage.structure.scale);
    let moment = |own: JointForce| {
        let PairId::Slide(id) = own.joint.id else { return None };
        let is_inner = [slides[id].link, slides[id].on].iter().all(|link| links.contains(link));
        let symbol = name("M").below(Text::from(&own.joint.name));
        let told = text!("assembly-inner-moment");
        let moment =
            own.moment.filter(|size| is_inner && size.abs() > SAME * scale * length([[0.0; 2], own.force]));
        moment.map(|size| Acting { symbol, told, size, unit: "N m" })
    };
    found.into_iter().flat_map(|found| found.reactions).filter_map(moment).collect()
}

/// The links of each polygon: those of the groups from the last to the first, then the input links.
pub fn bodies(results: &Results) -> Vec<Vec<LinkId>> {
    let (mechanism, structure) = (&results.linkage.mechanism, &results.linkage.structure);
    let groups = structure.groups.iter().rev().map(|group| group.frame.links.clone());
    groups.chain(mechanism.input.placed().map(|input| vec![input])).collect()
}

/// The vectors of the polygon of some links, with the symbols of [`polygon`].
pub fn vectors(
    results: &Results,
    position: usize,
    polygon: usize,
    links: &[LinkId],
) -> Vec<(Text, PlanVector)> {
    let Some(found) = &results.found else { return Vec::new() };
    let plans = found.plans.at(position);
    let look = Look { position, polygon, ..Look::default() };
    let Shown::Plan(plan) = shown(found, &look, ViewPart::Forces, &plans) else { return Vec::new() };
    let acting = arrows::Shown::on_links(results, position, links);
    let acting = acting.as_ref().map_or(&[][..], arrows::Shown::all);
    named(results, plan, acting).into_iter().map(|(symbol, item)| (symbol, item.clone())).collect()
}

/// The vectors of a plan of forces with their symbols.
fn named<'a>(
    results: &Results,
    plan: &'a VectorPlan,
    acting: &[arrows::Arrow],
) -> Vec<(Text, &'a PlanVector)> {
    let symbol =
        |item| same(acting, item).map_or_else(|| inner_symbol(results, item), |own| own.name.clone());
    let all = labelled(ViewPart::Forces, plan);
    all.into_iter().map(|(_, item)| (symbol(item), item)).collect()
}

/// The force on the links that a vector of their polygon is.
fn same<'a>(acting: &'a [arrows::Arrow], item: &PlanVector) -> Option<&'a arrows::Arrow> {
    let vector = [item.end[0] - item.start[0], item.end[1] - item.start[1]];
    let apart = |own: &&arrows::Arrow| length([own.vector, vector]) <= SAME * item.size;
    let is_outer = item.kind != VectorKind::Inner;
    let forces = acting.iter().filter(|own| is_outer && own.kind == arrows::Kind::Force);
    forces.filter(apart).min_by_key(|own| own.told != item.name)
}

/// The symbol of a reaction within a group; what is none keeps its name.
fn inner_symbol(results: &Results, item: &PlanVector) -> Text {
    let mechanism = &results.linkage.mechanism;
    let names = mechanism.slides.iter().map(|slide| &slide.name);
    let mut names = names.chain(mechanism.points.iter().map(|point| &point.name));
    let found = names.find(|pair| item.name == joined("", [name("R("), (*pair).into(), name(")")]));
    found.map_or_else(|| item.name.clone(), |pair| name("R").below(pair))
}
