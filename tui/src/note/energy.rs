//! Reduced inertia and energy: the link of reduction, shares of the links, the energy-mass diagram.

use assur_analysis::results::{Column, Dynamics, Owner, Quantity, RegimeReport};
use assur_figure::mechanism::Drawing;
use assur_figure::{Axis, Figure, Frame, Ink, Item, Panel, Point, Stroke};
use assur_mechanism::LinkId;

use super::Context;
use super::curves::plot;
use super::document::Block;
use super::words::Words;
use crate::number::{digits, trimmed};

/// Pages of the link of reduction, of a curve, and of the energy-mass diagram, mm.
const LINK: [f64; 2] = [165.0, 70.0];
const CURVE: [f64; 2] = [160.0, 80.0];
const DIAGRAM: [f64; 2] = [130.0, 110.0];
/// A share of this part of the greatest reduced inertia has no line of its own.
const LEAST_SHARE: f64 = 0.03;
/// Length of the arrow of the reduced force, as part of its radius.
const ARROW: f64 = 0.8;
/// Digits of a number in a figure, and in a caption.
const DIGITS: [usize; 2] = [4, 6];

/// The figures of a regime.
pub(super) fn blocks(context: &Context<'_>, dynamics: &Dynamics) -> Vec<Block> {
    let all = [
        link_of_reduction(context, dynamics),
        shares(context, dynamics),
        energy_mass(context.words, &dynamics.regime),
    ];
    all.into_iter().flatten().collect()
}

/// The input link alone in the chosen positions, with the reduced force at its point of reduction and the reduced mass
/// there (E fig. 1c).
fn link_of_reduction(context: &Context<'_>, dynamics: &Dynamics) -> Option<Block> {
    let (scene, found, point) =
        (context.state.scene.as_ref()?, context.state.found()?, dynamics.reduction_point.as_ref()?);
    let linkage = &scene.linkage;
    let input = linkage.mechanism.input.link;
    let hidden: Vec<LinkId> = (1..linkage.mechanism.links.len()).filter(|link| *link != input).collect();
    let drawing = Drawing { linkage, strokes: &scene.strokes, marked: &[], hidden: &hidden };
    let id = linkage.mechanism.point(&point.name)?;
    let table = &found.analysis.positions;
    let panel = |position: &usize| {
        let (pose, row) = (scene.poses.get(*position)?.as_ref()?, table.row_of(*position)?);
        let of = |quantity| table.get(row, Column::of(quantity, Owner::Input));
        let (force, mass) = (
            of(Quantity::ReducedMoment)? / point.radius,
            of(Quantity::ReducedInertia)? / point.radius.powi(2),
        );
        let motion = linkage.point_motion(id, pose);
        let to = [0, 1].map(|axis| motion.pf0[axis] + ARROW * force.signum() * motion.pf1[axis]);
        let mut items = drawing.items(pose);
        items.push(Item::Arrow { from: motion.pf0, to, stroke: Stroke::Solid, ink: Ink::Second });
        items.push(Item::name(to, "F", Ink::Title));
        let bounds = assur_figure::Bounds::around(items.iter().flat_map(Item::points));
        let frame = Frame::Plane { bounds, unit: "mm".into(), factor: 1e3, scale: ("l", "m".into()) };
        let [force, mass] = [force.abs(), mass].map(|value| digits(value, DIGITS[0]));
        Some(Panel {
            title: format!("{}: F = {force} N, m = {mass} kg", context.place(*position)),
            frame,
            items,
        })
    };
    let panels: Vec<Panel> = context.positions.iter().filter_map(panel).collect();
    let columns = panels.len().clamp(1, 2);
    let caption = context.words.with("link-of-reduction", &[("point", point.name.clone())]);
    let figure = Figure { panels, columns, ..Figure::default() };
    (!figure.panels.is_empty()).then(|| Block::picture(figure, LINK, caption))
}

/// The reduced inertia of the links over the cycle, one upon the other (E fig. 2); of small shares the line is left out.
fn shares(context: &Context<'_>, dynamics: &Dynamics) -> Option<Block> {
    let (words, schema) = (context.words, context.state.found()?.analysis.positions.schema());
    let of = |owner| context.cycle(Column::of(Quantity::ReducedInertia, owner));
    let greatest = |points: &[Point]| points.iter().map(|at| at[1]).fold(0.0, f64::max);
    let mut sum = of(Owner::Input)?;
    let whole = greatest(&sum);
    sum.iter_mut().for_each(|at| at[1] = 0.0);
    let (mut curves, mut names) = (Vec::new(), Vec::new());
    let links =
        schema.owners(Quantity::ReducedInertia).into_iter().filter(|owner| matches!(owner, Owner::Link(_)));
    for owner in links {
        let (Owner::Link(link), share) = (owner, of(owner)?) else { continue };
        let most = (0..share.len()).max_by(|one, other| share[*one][1].total_cmp(&share[*other][1]))?;
        let middle = [share[most][0], sum[most][1] + 0.5 * share[most][1]];
        sum.iter_mut().zip(&share).for_each(|(sum, share)| sum[1] += share[1]);
        if greatest(&share) >= LEAST_SHARE * whole {
            names.push(Item::name(middle, schema.link(link), Ink::Link(link)));
            curves.push((sum.clone(), Stroke::Solid, Ink::Link(link)));
        }
    }
    curves.push((sum.clone(), Stroke::Thick, Ink::Text));
    let mut panel = plot(words.get("links-inertia"), context.coordinate_axis(&[sum]), curves);
    panel.items.extend(names);
    if let Frame::Axes { y, .. } = &mut panel.frame {
        y.range[0] = 0.0;
    }
    let shaft = words.number(&trimmed(dynamics.regime.shaft_inertia, DIGITS[1]));
    Some(Block::picture(Figure::of(panel), CURVE, words.with("shares-drawn", &[("shaft", shaft)])))
}

/// The energy-mass diagram of Wittenbauer: kinetic energy over reduced inertia of the links, with the two lines
/// T = J w²/2 of the greatest and the least speed, which touch it.
fn energy_mass(words: &Words, regime: &RegimeReport) -> Option<Block> {
    let rows = &regime.course;
    let first = rows.first()?;
    let energy = |inertia: f64, speed: f64| 0.5 * (regime.shaft_inertia + inertia) * speed * speed;
    let start = energy(first.inertia, first.speed);
    let diagram: Vec<Point> =
        rows.iter().map(|row| [row.inertia, energy(row.inertia, row.speed) - start]).collect();
    let speeds = || rows.iter().map(|row| row.speed.abs());
    let (least, most) = (speeds().fold(f64::INFINITY, f64::min), speeds().fold(0.0, f64::max));
    let x = Axis::around(words.get("links-inertia"), diagram.iter().map(|at| at[0]), 0.0);
    let line = |speed: f64| x.range.map(|inertia| [inertia, energy(inertia, speed) - start]).to_vec();
    let lines = vec![
        (line(most), Stroke::Chain, Ink::Third),
        (line(least), Stroke::Dashed, Ink::Second),
        (diagram, Stroke::Solid, Ink::First),
    ];
    let panel = plot(words.get("energy-change"), x, lines);
    Some(Block::picture(Figure::of(panel), DIAGRAM, words.get("energy-mass")))
}
