//! The motion over the positions, or over its samples: coordinate, speed, acceleration, energies over time, moments of the loads over its way.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::{Course, Unit, catalogue};
use assur_figure::{Axis, Figure, Ink, Panel, Stroke};
use assur_report::topic;
use assur_words::{self as words, Text, joined, list, text};

use crate::{Found, Look, Results, ViewPart, curves, in_a_line, plots, reduction, regime};

/// Speed, acceleration, J, J', Q over the positions (at most `most`), or the motion over time.
pub fn figure(results: &Results, look: &Look<'_>, part: ViewPart, most: usize) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let regime = found.analysis.dynamics.as_ref().map(|dynamics| &dynamics.regime);
    let panels = match (regime, part) {
        (_, ViewPart::Reduction) => reduction::panels(results, look, found),
        (Some(regime), ViewPart::Iteration) => regime::iteration(regime, found.linkage.kind()),
        (Some(regime), ViewPart::Course) => regime::course(found, regime, look),
        (_, part) if part != ViewPart::Overview || found.motion.is_empty() => over_time(results, found, look),
        _ => {
            let shown = most.clamp(1, found.motion.len());
            let from_chosen = found.motion.iter().cycle().skip(look.motion % found.motion.len());
            let wanted: Vec<usize> = from_chosen.take(shown).copied().collect();
            curves::stack(results, look, found, None, &wanted)
        }
    };
    let columns = if part == ViewPart::Reduction { 2 } else { 1 };
    Figure { title: heading(found), panels, columns, legend: Vec::new() }
}

/// The most important line: the unevenness of a regime, or why there is no speed.
pub fn heading(found: &Found) -> Text {
    if found.analysis.dynamics.is_some() {
        let facts = topic::regime_facts(&found.analysis);
        return in_a_line(&facts, &["fact-unevenness", "fact-mean-speed"]);
    }
    match (&found.analysis.no_motion, &found.linkage.mechanism.motion) {
        (Some(reason), _) => not_found(reason, " "),
        (None, None) if !found.linkage.kind().is_time() => text!("motion-none"),
        (None, _) => Text::default(),
    }
}

/// Why there is no motion.
pub fn not_found(reason: &Text, between: &'static str) -> Text {
    joined(between, [text!("no-motion-found"), reason.clone()])
}

fn over_time(results: &Results, found: &Found, look: &Look<'_>) -> Vec<Panel> {
    if found.samples.is_none() {
        return Vec::new();
    }
    let place = &results.series[0];
    let heading = [plots::coordinate_name(&found.linkage), place.show(look.position)];
    let curve = [(place, Stroke::Solid, Ink::First)];
    let coordinate = plots::over_positions(results.base(look), heading, &curve, Vec::new());
    let is_rate = |series: &&usize| {
        [Quantity::Velocity, Quantity::Acceleration].contains(&found.series[**series].column.quantity)
    };
    let rates: Vec<usize> = found.motion.iter().filter(is_rate).copied().collect();
    let base = results.base(look);
    let energies = plots::energies(found, Column::TIME, (base.axis, base.factor), base.cursor);
    let panels = std::iter::once(coordinate).chain(curves::stack(results, look, found, None, &rates));
    panels.chain(energies).chain(loads_over_way(found, look.position)).collect()
}

/// The moments of drive and loads, reduced to the input, over its way (E fig. 3): what drives along the motion, what resists
/// against it, so that it is seen where they are equal; of many the first ones.
fn loads_over_way(found: &Found, row: usize) -> Option<Panel> {
    /// Curves in one panel.
    const MOST: usize = 3;
    let (analysis, place) = (&found.analysis, Column::COORDINATE);
    let table = &analysis.trajectory;
    let (schema, last) = (table.schema(), table.len().checked_sub(1)?);
    let sense = (table.get(last, place)? - table.get(0, place)?).signum();
    let curve = |owner| {
        let column = Column::of(Quantity::ReducedLoad, owner);
        let resists = table.get(last, Column::of(Quantity::Work, owner)).is_some_and(|work| work < 0.0);
        let course = plots::over_samples(found, place, column, if resists { -sense } else { sense });
        let told =
            if let Owner::Load(_) = owner { schema.named(owner)?.into() } else { catalogue::kind(column) };
        let told = if resists { text!("regime-against", load = told) } else { told };
        (!course.is_empty()).then_some((told, course))
    };
    let owners = schema.owners(Quantity::ReducedLoad);
    let curves: Vec<(Text, Course)> = owners.into_iter().filter_map(curve).take(MOST).collect();
    let now = table.get(row, place).filter(|_| !curves.is_empty())?;
    let told =
        list([plots::coordinate_name(&found.linkage), words::unit(plots::raw_coordinate(&found.linkage))]);
    let x = Axis::around(told, (0..table.len()).filter_map(|row| table.get(row, place)), 0.0);
    // Several curves name themselves.
    let alone = curves.iter().map(|(told, _)| told.clone()).filter(|_| curves.len() == 1);
    let kind = analysis.input.kind;
    let told = if kind.is_angle() { text!("motion-loads") } else { text!("motion-forces") };
    let title = joined(": ", std::iter::once(plots::titled(told, Unit::load_of(kind))).chain(alone));
    Some(plots::curves(title, curves, (x, 1.0), Some(now.into())))
}
