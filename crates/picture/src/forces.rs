//! Reactions over the cycle, their hodographs and their causes.

use assur_figure::{Bounds, Figure, Ink, Item, Key, Panel, Point, Sample, Scale, Sign, Stroke};
use assur_words::{Text, joined, list, name, quantity, text, unit};

pub use crate::friction::beside_friction;
use crate::{Found, Look, Reaction, Results, Series, ViewPart, causes, curves, plots};

/// The chosen reaction: its modulus beside its hodograph, its projections, its hodograph, or its causes.
pub fn figure(results: &Results, look: &Look<'_>, part: ViewPart) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let mut legend = Vec::new();
    let panels = match part {
        ViewPart::Causes => {
            let panels;
            (panels, legend) = causes::panels(results, look, found);
            panels
        }
        // The curves of a second analyzer or scene need frames of their own.
        ViewPart::Curves if results.other.is_none() && look.compared.is_none() => {
            let all = chosen(found, look).map_or(&[][..], |reaction| &reaction.series);
            let all: Vec<&Series> = all.iter().map(|index| &found.series[*index]).collect();
            return Figure { title: heading(results, look, found), ..curves::together(results, look, &all) };
        }
        ViewPart::Curves => causes::curves(results, look, found, &[0, 1, 2]),
        ViewPart::Hodograph => {
            let mut panels: Vec<Panel> = hodograph(results, found, look, &mut legend).into_iter().collect();
            let touching = |reaction| beside_friction(found, look.position, reaction);
            panels.extend(chosen(found, look).and_then(touching));
            panels
        }
        _ => {
            let hodograph = hodograph(results, found, look, &mut legend);
            causes::curves(results, look, found, &[usize::MAX]).into_iter().chain(hodograph).collect()
        }
    };
    let columns = match part {
        ViewPart::Causes => 2,
        ViewPart::Curves => 1,
        _ => panels.len().max(1),
    };
    let name = chosen(found, look).map(|reaction| reaction.name.clone()).unwrap_or_default();
    Figure { title: list([name, heading(results, look, found)]), panels, columns, legend }
}

/// By which analyzer the reactions are, and their difference to those of another one.
pub fn heading(results: &Results, look: &Look<'_>, found: &Found) -> Text {
    let own = name(found.analyzer.clone());
    match &results.other {
        // One method has no difference to itself.
        Some(other) if other.analyzer != found.analyzer => {
            let difference = format!("{:.1e}", largest_difference(results, found, other));
            let (theirs, difference) = (name(other.analyzer.clone()), quantity(difference, "N"));
            text!("forces-two-analyzers", one = own, other = theirs, difference = difference)
        }
        _ if look.calculating => text!("forces-calculating", method = own),
        _ => text!("forces-analyzer", method = own),
    }
}

fn chosen<'a>(found: &'a Found, look: &Look<'_>) -> Option<&'a Reaction> {
    found.reactions.get(look.reaction)
}

/// Modulus of the difference of a reaction by two analyzers, or of two scenes, in a position; `None` if one of them does not have it.
pub fn difference(found: &Found, other: &Found, reaction: &Reaction, position: usize) -> Option<f64> {
    let same = other.reactions.iter().find(|other| other.name == reaction.name)?;
    // Both projections, or the balancing load.
    let parts = reaction.series.iter().zip(&same.series).take(2);
    let apart = |(own, theirs): (&usize, &usize)| {
        found.series[*own].at(position) - other.series[*theirs].at(position)
    };
    Some(parts.map(apart).map(|part| part * part).sum::<f64>().sqrt()).filter(|size| size.is_finite())
}

/// Greatest modulus of the difference of a reaction over all positions, N.
fn largest_difference(results: &Results, found: &Found, other: &Found) -> f64 {
    let reactions = found.reactions.iter().filter(|reaction| reaction.of.is_some());
    let all = reactions.flat_map(|reaction| {
        (0..results.positions()).filter_map(move |position| difference(found, other, reaction, position))
    });
    all.fold(0.0, f64::max)
}

/// Least distance of two positions that are marked on a hodograph, as part of its size.
const APART: f64 = 0.12;

/// The path of the tip of the force over the cycle with axes and some positions by their numbers, and the force of the position.
fn hodograph(results: &Results, found: &Found, look: &Look<'_>, legend: &mut Vec<Key>) -> Option<Panel> {
    let reaction = chosen(found, look).filter(|reaction| reaction.series.len() == 3)?;
    let [xs, ys, size] = [0, 1, 2].map(|part| &found.series[reaction.series[part]]);
    let force = joined(": ", [results.place(look.position), size.show(look.position)]);
    let key = |sample, text| Key { sample, text };
    legend.push(key(Sample::Line(Stroke::Solid, Ink::First), force));
    legend.push(key(Sample::Line(Stroke::Dashed, Ink::Second), text!("forces-path")));
    legend.push(key(Sample::Sign(Sign::Node, Ink::Title), text!("forces-numbers")));
    let tips: Vec<Point> = xs.course.against(&ys.course);
    let bounds = Bounds::around(tips.iter().copied().chain([[0.0; 2]]));
    let tip = |position| Some([xs.course.get(position)?, ys.course.get(position)?]);
    let mut items =
        plots::axes(&bounds, ["x", "y"].map(|axis| list([name("R").below(name(axis)), unit("N")])));
    items.push(Item::line(tips, Stroke::Dashed, Ink::Second));
    let now = tip(look.position);
    items.extend(now.map(|to| Item::Arrow { from: [0.0; 2], to, stroke: Stroke::Solid, ink: Ink::First }));
    let apart = APART * bounds.size().into_iter().fold(0.0, f64::max);
    let mut marked: Vec<Point> = Vec::new();
    let numbers = std::iter::once(look.position).chain(xs.course.nodes().iter().map(|node| node.number));
    for (number, at) in numbers.filter_map(|number| Some((number, tip(number)?))) {
        if marked.iter().all(|other| (at[0] - other[0]).hypot(at[1] - other[1]) > apart) {
            marked.push(at);
            items.push(Item::sign(at, Sign::Node, Ink::Title));
            items.push(Item::name(at, name(number.to_string()), Ink::Title));
        }
    }
    items.push(Item::sign([0.0; 2], Sign::Plus, Ink::Title));
    let title = text!("forces-hodograph", reaction = &reaction.name);
    Some(Panel { title, ..Panel::plane(bounds, Scale::of("F", "N"), items) })
}
