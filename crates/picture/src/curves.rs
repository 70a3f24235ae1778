//! PF0, PF1, PF2 of one quantity, stacked over one axis; or the quantities that were picked, those of one unit over each other.

use std::collections::BTreeSet;

use assur_analysis::results::{Column, Owner, Quantity, Schema};
use assur_book::{Unit, catalogue};
use assur_figure::number::number;
use assur_figure::{Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke};
use assur_mechanism::GROUND;
use assur_words::{Text, joined, list, name, quantity, text};

use crate::plots::{self, STYLES, Style, over_positions};
use crate::{Compared, Found, Look, Results, Series};

/// What the signs on the curves are. The zeros of the first derivative mark extremes, those of the second one inflections.
const SIGNS: [(Sign, &str); 3] =
    [(Sign::Cross, "curve-zero"), (Sign::Ring, "curve-extreme"), (Sign::Plus, "curve-inflection")];

/// The three curves of the chosen quantity, or those of the quantities that were picked.
pub fn figure(results: &Results, look: &Look<'_>) -> Figure {
    if !look.picked.is_empty() {
        let all = picked(results, look);
        return together(results, look, &all.iter().collect::<Vec<_>>());
    }
    let Some(transfer) = results.transfers.get(look.transfer) else { return Figure::default() };
    let mut title = transfer.name.clone();
    let mut legend: Vec<Key> = Vec::new();
    if let Some(compared) = look.compared {
        title = if compared.before {
            text!("curve-before", quantity = title)
        } else {
            text!("curve-compared", quantity = title, one = &compared.own, other = &compared.name)
        };
    } else {
        legend.extend(
            SIGNS.map(|(sign, told)| Key { sample: Sample::Sign(sign, Ink::Text), text: text!(told) }),
        );
    }
    let inks = [Ink::First, Ink::Second, Ink::Third];
    let panels =
        inks.into_iter().enumerate().map(|(order, ink)| panel(results, look, transfer.orders, order, ink));
    Figure { title, panels: panels.collect(), columns: 1, legend }
}

fn panel(results: &Results, look: &Look<'_>, orders: [usize; 3], order: usize, ink: Ink) -> Panel {
    let own = &results.series[orders[order]];
    let drawn = |results: &Results| {
        let mut same = results.of_cycle().iter().filter(|series| series.short == own.short);
        same.find(|series| series.unit == own.unit).map(in_radians)
    };
    let other = look.compared.and_then(|compared| Some((compared, drawn(&compared.results)?)));
    let (series, of_cycle) = (&in_radians(own), &in_radians(&results.of_cycle()[orders[order]]));
    let mut value = quantity(series.bare(look.position), series.unit.name);
    let mut curves = vec![(of_cycle, Stroke::Solid, ink)];
    if let Some((compared, other)) = &other {
        curves.push((other, stroke_of(compared), Ink::Text));
        let difference = compared.difference(own, look.position).unwrap_or(f64::NAN) * series.unit.factor
            / own.unit.factor;
        let difference = quantity(number(difference), series.unit.name);
        value = joined("", [value, name("   1 - 2: "), difference]);
    }
    let base = results.base_of_cycle(look);
    let mut signs = Vec::new();
    for (derivative, (sign, _)) in orders[order..].iter().zip(SIGNS) {
        for at in results.of_cycle()[*derivative].course.zeros() {
            let value = if sign == Sign::Cross { Some(0.0) } else { of_cycle.course.between(at) };
            let sign = |value| Item::sign([base.factor * at, series.unit.factor * value], sign, Ink::Text);
            signs.extend(value.map(sign));
        }
    }
    over_positions(base, [catalogue::kind(series.column), value], &curves, signs)
}

/// The place, the velocity and the acceleration of the last quantity over one axis, what the mechanism is for; without a motion its transfer
/// functions.
pub fn of_last(results: &Results, look: &Look<'_>) -> Figure {
    let transfer = results.transfers.len().saturating_sub(1);
    let Some(last) = results.transfers.get(transfer) else { return Figure::default() };
    let look = &Look { transfer, ..*look };
    let owner = Schema::new(&results.linkage.mechanism).named(last.owner).map(Text::from);
    let rates = [Quantity::Velocity, Quantity::Acceleration].map(|quantity| {
        let found = results.found.as_deref()?;
        found.series.iter().find(|series| series.column == Column::of(quantity, last.owner))
    });
    let [Some(velocity), Some(acceleration)] = rates else { return figure(results, look) };
    let place = in_radians(&results.series[last.orders[0]]);
    let all = [&place, velocity, acceleration].into_iter().zip([Ink::First, Ink::Second, Ink::Third]);
    let heading = |series: &Series| {
        let kind = match (series.column.quantity, series.column.owner) {
            (Quantity::Transfer(_), Owner::Link(_)) => text!("curve-angle"),
            (Quantity::Transfer(_), _) => text!("curve-displacement"),
            _ => catalogue::kind(series.column),
        };
        list(
            std::iter::once(joined(" ", [kind, symbol_of_last(results, series.column)])).chain(owner.clone()),
        )
    };
    let panel = |(series, ink): (&Series, Ink)| {
        over_positions(
            results.base(look),
            [heading(series), Text::default()],
            &[(series, Stroke::Solid, ink)],
            Vec::new(),
        )
    };
    Figure { title: last.name.clone(), panels: all.map(panel).collect(), columns: 1, legend: Vec::new() }
}

/// The symbol of a place, a velocity or an acceleration with what it is of: `s_5`, `ω_3`.
fn symbol_of_last(results: &Results, column: Column) -> Text {
    let letters = if matches!(column.owner, Owner::Link(_)) { ["φ", "ω", "ε"] } else { ["s", "v", "a"] };
    let letter = match column.quantity {
        Quantity::Velocity => letters[1],
        Quantity::Acceleration => letters[2],
        _ => letters[0],
    };
    let mechanism = &results.linkage.mechanism;
    let index = match column.owner {
        Owner::Link(link) => name(link.to_string()),
        Owner::Slide(id) if mechanism.slides[id].on == GROUND => name(mechanism.slides[id].link.to_string()),
        Owner::Slide(id) => name(format!("{}/{}", mechanism.slides[id].link, mechanism.slides[id].on)),
        Owner::Point(id) => Text::from(&mechanism.points[id].name),
        _ => return name(letter),
    };
    name(letter).below(index)
}

fn stroke_of(compared: &Compared) -> Stroke {
    if compared.before { Stroke::Dotted } else { Stroke::Stars }
}

/// Curves of these series of the analysis, of the corresponding ones of another analyzer, and of those of a second scene,
/// over one axis.
pub(crate) fn stack(
    results: &Results,
    look: &Look<'_>,
    found: &Found,
    other: Option<&Found>,
    wanted: &[usize],
) -> Vec<Panel> {
    let panel = |index: &usize| {
        let series = &found.series[*index];
        let same = other.and_then(|other| other.series.iter().find(|other| other.column == series.column));
        let mut curves = vec![(series, Stroke::Solid, Ink::First)];
        if let Some(compared) = look.compared {
            curves.extend(compared.series(series).map(|same| (same, stroke_of(compared), Ink::Text)));
        }
        curves.extend(same.map(|same| (same, Stroke::Stars, Ink::Third)));
        let heading = [series.of.clone(), series.show(look.position)];
        over_positions(results.base(look), heading, &curves, Vec::new())
    };
    wanted.iter().map(panel).collect()
}

/// The picked quantities that the scene has.
pub fn picked(results: &Results, look: &Look<'_>) -> Vec<Series> {
    look.picked.iter().filter_map(|short| results.named(short)).map(in_radians).collect()
}

/// The angle of a link in radians, by which its derivatives are taken, so that all three have one axis; other quantities as they are
/// shown elsewhere.
pub fn in_radians(series: &Series) -> Series {
    let is_angle =
        matches!((series.column.quantity, series.column.owner), (Quantity::Transfer(0), Owner::Link(_)));
    Series { unit: if is_angle { Unit::si("rad") } else { series.unit }, ..series.clone() }
}

/// Relative size of a change that is rounding.
const CONSTANT: f64 = 1e-9;

/// A panel for each unit, with a ring at the greatest and the least value of each curve; the curves of each follow each other in their
/// strokes. Several have numbers, under which the legend has their units and their values at the position.
pub(crate) fn together(results: &Results, look: &Look<'_>, all: &[&Series]) -> Figure {
    let units: Vec<&str> = all.iter().map(|series| without_radians(series.unit.name)).collect();
    let style = |number: usize| {
        let before = units[..number].iter().filter(|unit| **unit == units[number]).count();
        STYLES[before % STYLES.len()]
    };
    let panel = |unit| {
        let own = (0..all.len()).filter(|number| units[*number] == unit);
        let own: Vec<_> = own.map(|number| (number, style(number))).collect();
        panel_of_unit(results, look, all, &own)
    };
    let key = |(number, series): (usize, &&Series)| {
        let (stroke, ink) = style(number);
        let text = joined(": ", [plots::numbered(number, series.title()), series.number_told(look.position)]);
        Key { sample: Sample::Line(stroke, ink), text }
    };
    let panels = different(units.iter().copied()).into_iter().map(panel).collect();
    let legend = all.iter().enumerate().filter(|_| all.len() > 1).map(key).collect();
    Figure { panels, columns: 1, legend, ..Figure::default() }
}

/// The quantities that were picked as paper has them: their names stand in the legend, the heading of each panel says what they have in
/// common.
pub fn with_legend(results: &Results, look: &Look<'_>) -> Figure {
    let all = picked(results, look);
    let mut figure = together(results, look, &all.iter().collect::<Vec<_>>());
    if figure.legend.is_empty() {
        return figure;
    }
    let units = different(all.iter().map(|series| without_radians(series.unit.name)));
    for (panel, unit) in figure.panels.iter_mut().zip(units) {
        let own: Vec<&Series> =
            all.iter().filter(|series| without_radians(series.unit.name) == unit).collect();
        let kind = &own[0].kind;
        let kind = if own.iter().all(|series| series.kind == *kind) { kind.clone() } else { Text::default() };
        let units = different(own.iter().map(|series| series.unit.name));
        let units = units.into_iter().map(|unit| assur_words::unit(unit.to_owned()));
        panel.title = list(std::iter::once(kind).chain(units).filter(|text| !text.is_empty()));
    }
    figure
}

/// Each of them once, in the order in which it comes first.
fn different<'a>(all: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = BTreeSet::new();
    all.filter(|one| seen.insert(*one)).collect()
}

/// A unit without its radians, which are numbers: PF0, PF1 and PF2 of a point are lengths all, on one axis.
fn without_radians(unit: &str) -> &str {
    let bare = unit.split_once("/rad").map_or(unit, |(bare, _)| bare);
    if bare == "rad" { "" } else { bare }
}

/// The quantities of one unit but for radians; each has its number in the list of all, and its style.
fn panel_of_unit(results: &Results, look: &Look<'_>, all: &[&Series], own: &[(usize, Style)]) -> Panel {
    let (_, coordinate) = results.axis_unit();
    let (mut curves, mut signs, mut names) = (Vec::new(), Vec::new(), Vec::new());
    let before = |series: &&Series| look.compared?.series(results.named(&series.short)?).map(in_radians);
    let befores: Vec<Option<Series>> = all.iter().map(before).collect();
    for &(number, (stroke, ink)) in own {
        let series = all[number];
        curves.extend(befores[number].iter().map(|before| (before, Stroke::Dotted, Ink::Trace)));
        curves.push((series, stroke, ink));
        let place = |[at, value]: Point| [coordinate * at, series.unit.factor * value];
        if let Some(ends) = series.course.highest_and_lowest() {
            // A course that is constant to its rounding has no extremes.
            if series.unit.factor * (ends[0][1] - ends[1][1]) > series.least().max(CONSTANT * series.size()) {
                signs.extend(ends.map(|end| Item::sign(place(end), Sign::Ring, Ink::Text)));
            }
            if all.len() > 1 {
                // Each number at its own part of the curve, so that the numbers of curves that meet are still seen.
                let nodes = series.course.nodes();
                let node = nodes[(2 * number + 1) * nodes.len() / (2 * all.len())];
                let number = name((number + 1).to_string());
                signs.push(Item::name(place([node.at, node.value]), number, Ink::Title));
            }
        }
        names.push(plots::numbered(number, series.told()));
    }
    let units = curves.iter().map(|(series, ..)| series.unit.name).filter(|unit| !unit.is_empty());
    let units = list(different(units).into_iter().map(|symbol| assur_words::unit(symbol.to_owned())));
    // The value at the cursor stands in the legend of several, else in the heading.
    let heading = match all {
        [alone] => [alone.told(), alone.show(look.position)],
        _ => {
            [list([joined("  ", names), units].into_iter().filter(|text| !text.is_empty())), Text::default()]
        }
    };
    let mut panel = over_positions(results.base(look), heading, &curves, signs);
    if let Frame::Axes { y, .. } = &mut panel.frame {
        // The heading says it.
        y.label = Text::default();
    }
    panel
}

/// The residuals of the checks over the positions.
pub fn residuals(results: &Results, look: &Look<'_>) -> Figure {
    let residuals = results.found.iter().flat_map(|found| &found.series);
    let residuals = residuals.filter(|series| matches!(series.column.quantity, Quantity::Residual(_)));
    let panels = residuals.map(|series| {
        let heading = [series.of.clone(), series.show(look.position)];
        over_positions(results.base(look), heading, &[(series, Stroke::Solid, Ink::First)], Vec::new())
    });
    Figure { panels: panels.collect(), columns: 1, ..Figure::default() }
}
