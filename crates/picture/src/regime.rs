//! The steady regime as plots: speed with that of the first turn, moments with their mean, motor, iteration, energies, the
//! energy-mass diagram, the shares of the reduced inertia.

use assur_analysis::results::{
    Column, Dynamics, EnergyMass, Owner, Quantity, RegimeOverCycle, RegimeState, Table, Trial,
};
use assur_book::{Course, Jump, Unit, catalogue};
use assur_figure::number::plain;
use assur_figure::{
    Axis, AxisKind, Bounds, Figure, Frame, Ink, Item, Key, Panel, Point, Sample, Sign, Stroke,
};
use assur_kinematics::Linkage;
use assur_mechanism::CoordinateKind;
use assur_words::{Text, joined, list, measured, name, number, text, unit};

use crate::{Found, Look, Results, ViewPart, coordinate_at, coordinate_unit, places, plots, reduction};

/// Characteristic and moments, the energy-mass diagram, or the shares of the reduced inertia, in so many columns.
pub fn drive(results: &Results, look: &Look<'_>, part: ViewPart, columns: usize) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let Some(dynamics) = &found.analysis.dynamics else { return Figure::default() };
    let panels = match part {
        ViewPart::EnergyMass => vec![energy_mass(&dynamics.energy_mass, found.linkage.kind())],
        ViewPart::Reduction => reduction::link(results, look, found).into_iter().collect(),
        ViewPart::Inertia => {
            let (panel, legend) = shares(found, dynamics, look);
            return Figure { title: text!("drive-title"), panels: vec![panel], columns, legend };
        }
        // The two drives stand beside each other.
        ViewPart::Places => {
            let (panels, legend) =
                (places::panels(&results.linkage.mechanism, dynamics), places::legend(dynamics));
            return Figure { title: text!("places-heading"), columns: panels.len().max(1), panels, legend };
        }
        _ => {
            let moments = moments(found, &dynamics.regime, look);
            let section = working_section(dynamics).filter(|_| part == ViewPart::Curves);
            characteristic(dynamics).into_iter().chain(section).chain([moments]).collect()
        }
    };
    Figure { title: text!("drive-title"), panels, columns, legend: Vec::new() }
}

/// The shares of the reduced inertia as paper has them: their names stand in the legend.
pub fn shares_on_paper(results: &Results, look: &Look<'_>) -> Figure {
    let mut figure = drive(results, look, ViewPart::Inertia, 1);
    let [inertia, _] = Unit::inertias(results.linkage.kind());
    let told = catalogue::kind(Column::of(Quantity::ReducedInertia, Owner::Input));
    for panel in &mut figure.panels {
        panel.title = plots::titled(told.clone(), inertia);
    }
    figure
}

/// A quantity of the regime over the cycle; where `read` gives none, the course has none.
fn over(regime: &RegimeOverCycle, read: impl Fn(&RegimeState) -> Option<f64>) -> Course {
    Course::from_points(regime.course.iter().filter_map(|row| Some([row.coordinate, read(row)?])))
}

/// The present coordinate in the unit that is shown.
fn cursor(linkage: &Linkage, look: &Look<'_>) -> f64 {
    coordinate_at(linkage, look.at())
}

/// Speed in the regime and in the first turn, then the moments and the energies.
pub(crate) fn course(found: &Found, regime: &RegimeOverCycle, look: &Look<'_>) -> Vec<Panel> {
    let mut lines = vec![(text!("regime-course"), over(regime, |row| Some(row.speed)))];
    let first_turn = over(regime, |row| row.first_turn);
    if !first_turn.is_empty() {
        lines.push((text!("regime-first-turn"), first_turn));
    }
    let now = cursor(&found.linkage, look);
    let rate = Unit::rates_of(found.linkage.kind())[0];
    let title = plots::titled(text!("regime-input-speed"), rate);
    let speed = plots::curves(title, lines, axis(&found.linkage), Some(now.into())).measuring(rate.name);
    let energies = plots::energies(found, Column::COORDINATE, axis(&found.linkage), now);
    [speed, moments(found, regime, look)].into_iter().chain(energies).collect()
}

/// The coordinate over the cycle, and its factor from SI.
fn axis(linkage: &Linkage) -> (Axis, f64) {
    (plots::coordinate_axis(linkage), coordinate_unit(linkage).1)
}

/// Moments of the drive and the resistance on the input, with the mean resistance.
pub(crate) fn moments(found: &Found, regime: &RegimeOverCycle, look: &Look<'_>) -> Panel {
    // What drives is shown along the motion, and the resistance against it, as its mean is. Driving is what does work over the cycle.
    let sense = found.linkage.mechanism.input.sign();
    let of_loads = Column::of(Quantity::ReducedMoment, Owner::Input);
    let jumps = Course::of(&found.analysis.positions, Some(&found.edges), Column::COORDINATE, of_loads);
    let drive = |sign: f64| over(regime, |row| Some(sign * sense * row.drive));
    let load = |sign: f64| {
        let factor = sign * sense;
        let step = |step: Jump| step.values.map(|value| [step.at, factor * value]);
        over(regime, |row| Some(factor * row.load)).with_between(jumps.jumps().flat_map(step).collect())
    };
    let mean =
        |sign: f64| (text!("regime-mean"), over(regime, |_| Some(sign * regime.found.mean_resistance)));
    let against = || text!("regime-against", load = text!("regime-resistance"));
    let loads_drive = found.analysis.dynamics.as_ref().is_some_and(Dynamics::loads_drive);
    let lines = if loads_drive {
        let driving = (text!("regime-driving-loads"), load(1.0));
        vec![driving, (against(), drive(-1.0)), mean(-1.0)]
    } else {
        vec![(text!("regime-motor"), drive(1.0)), (against(), load(-1.0)), mean(1.0)]
    };
    let area = found.analysis.dynamics.as_ref().and_then(|found| excess(found, [&lines[0].1, &lines[1].1]));
    let (x, factor) = axis(&found.linkage);
    let kind = found.linkage.kind();
    let told = if kind.is_angle() { text!("regime-moments") } else { text!("regime-forces") };
    let title = plots::titled(told, Unit::load_of(kind));
    let panel = plots::curves(title, lines, (x, factor), Some(cursor(&found.linkage, look).into()));
    let mut panel = panel.measuring(Unit::load_of(kind).name);
    if let Some((mut outline, work)) = area {
        for at in &mut outline {
            at[0] *= factor;
        }
        let middle = Bounds::around(outline.iter().copied()).center();
        panel.items.insert(0, Item::Area { outline, ink: Ink::Trace });
        let told = text!("regime-excess-area", work = measured(work, 6, "J"));
        panel.items.push(Item::name(middle, told, Ink::Title));
    }
    panel
}

/// The area between the driving and the resisting moment from the place of one extreme of the speed to that of the other one, and
/// the excess work (E fig. 4: F* and A*); `None` where the area is not that work, as with links of much inertia.
fn excess(found: &Dynamics, [driving, resisting]: [&Course; 2]) -> Option<(Vec<Point>, f64)> {
    /// Allowed relative difference between the area of the drawn polygon and the excess work; beyond it nothing is shaded.
    const ROUGH: f64 = 1e-3;
    let figures = &found.figures;
    let [from, to] = [figures.coordinate_at_min, figures.coordinate_at_max];
    let ends = [from.min(to), from.max(to)];
    let between = |course: &Course| {
        let inner = course.nodes().iter().filter(|node| node.at > ends[0] && node.at < ends[1]);
        let mut points: Vec<Point> = inner.map(|node| [node.at, node.value]).collect();
        points.insert(0, [ends[0], course.between(ends[0])?]);
        points.push([ends[1], course.between(ends[1])?]);
        Some(points)
    };
    let area = |points: &[Point]| -> f64 {
        points.windows(2).map(|two| 0.5 * (two[1][0] - two[0][0]) * (two[0][1] + two[1][1])).sum()
    };
    let (upper, mut lower) = (between(driving)?, between(resisting)?);
    let work = (area(&upper) - area(&lower)).abs();
    lower.reverse();
    let fits = (work - figures.excess_work).abs() <= ROUGH * work;
    fits.then(|| (upper.into_iter().chain(lower).collect(), figures.excess_work))
}

/// The motor's characteristic, with its working section; `None` without a motor of a catalogue.
pub(crate) fn characteristic(dynamics: &Dynamics) -> Option<Panel> {
    let work = &dynamics.motor.as_ref()?.work;
    let course = |points: &[[f64; 2]]| Course::from_points(points.iter().copied());
    let lines = vec![
        (text!("regime-whole"), course(&work.curve)),
        (text!("regime-working-section"), course(&work.working_section)),
    ];
    let x = Axis::around(text!("regime-motor-speed"), work.curve.iter().map(|at| at[0]), 0.0);
    let x = x.measuring("rad/s");
    let mut panel =
        plots::curves(text!("regime-characteristic"), lines, (x, 1.0), None).measuring(Unit::MOMENT.name);
    mark_section(&mut panel, dynamics, &work.working_section);
    Some(panel)
}

/// The working section of the characteristic by itself; `None` without a motor of a catalogue.
pub(crate) fn working_section(dynamics: &Dynamics) -> Option<Panel> {
    let work = &dynamics.motor.as_ref()?.work;
    let section = Course::from_points(work.working_section.iter().copied());
    let x = Axis::around(text!("regime-motor-speed"), work.speed, 0.0).measuring("rad/s");
    let title = list([text!("regime-working-section"), unit("N m")]);
    let curve = vec![(text!("regime-working-section"), section)];
    let mut panel = plots::curves(title, curve, (x, 1.0), None).measuring(Unit::MOMENT.name);
    mark_section(&mut panel, dynamics, &work.working_section);
    Some(panel)
}

/// The working section as a thick line over the characteristic, with the lines of its least and its greatest speed, and the
/// unevenness that belongs to it.
fn mark_section(panel: &mut Panel, dynamics: &Dynamics, section: &[[f64; 2]]) {
    let Frame::Axes { y, .. } = &panel.frame else { return };
    let (low, high) = (y.value(0.0), y.value(1.0));
    panel.items.push(Item::line(section, Stroke::Thick, Ink::Second));
    for end in [section.first(), section.last()].into_iter().flatten() {
        panel.items.push(Item::line([[end[0], low], [end[0], high]], Stroke::Dotted, Ink::Cursor));
        panel.items.push(Item::sign(*end, Sign::Ring, Ink::Text));
    }
    let unevenness = text!("regime-delta", delta = number(plain(dynamics.figures.unevenness)));
    panel.items.extend(section.first().map(|at| Item::name(*at, unevenness, Ink::Title)));
}

/// Work of all loads over the reduced inertia of the links, with the tangents that belong to the least and the greatest speed.
pub(crate) fn energy_mass(diagram: &EnergyMass, kind: CoordinateKind) -> Panel {
    let inertias = || diagram.curve.iter().map(|at| at[0]);
    let told = if kind.is_angle() { text!("regime-links-inertia") } else { text!("regime-links-mass") };
    let inertia = Unit::inertias(kind)[0];
    let x = Axis::around(plots::titled(told, inertia), inertias(), 0.0).measuring(inertia.name);
    let [x0, y0] = diagram.origin;
    let line =
        |slope: f64| Course::from_points(x.range.map(|inertia| [inertia, y0 + slope * (inertia - x0)]));
    let [fast, slow] = diagram.tangents.map(|tangent| line(tangent.slope));
    let curve = Course::from_points(diagram.curve.iter().copied());
    let lines = vec![
        (text!("regime-work"), curve),
        (text!("regime-greatest-speed"), fast),
        (text!("regime-least-speed"), slow),
    ];
    let panel = plots::curves(text!("regime-energy-mass"), lines, (x, 1.0), None);
    let mut panel = panel.measuring(Unit::JOULE.name);
    panel.items.extend(diagram.tangents.map(|tangent| Item::sign(tangent.touches, Sign::Plus, Ink::Title)));
    panel
}

/// The reduced inertia over the positions, the shares of flywheel with rotor and of each link above each other.
pub(crate) fn shares(found: &Found, dynamics: &Dynamics, look: &Look<'_>) -> (Panel, Vec<Key>) {
    let positions = &found.analysis.positions;
    let owners = positions.schema().owners(Quantity::ReducedInertia).into_iter();
    let links: Vec<Owner> = owners.filter(|owner| matches!(owner, Owner::Link(_))).collect();
    // The sum of flywheel, rotor and the first `count` links in a row.
    let level = |table: &Table, row: usize, count: usize| {
        let share = |owner: &Owner| table.get(row, Column::of(Quantity::ReducedInertia, *owner));
        let sum = links[..count].iter().map(share).sum::<Option<f64>>()?;
        Some(dynamics.regime.found.drive_inertia + sum)
    };
    let (_, factor) = coordinate_unit(&found.linkage);
    let [inertia, _] = Unit::inertias(found.linkage.kind());
    let (mut items, mut samples) = (Vec::new(), Vec::new());
    for count in 0..=links.len() {
        let value = |table: &Table, row: usize| level(table, row, count);
        let course = Course::read(positions, Some(&found.edges), Column::COORDINATE, value);
        let points = course.points([factor, 1.0]);
        let stroke = if count == links.len() { Stroke::Solid } else { Stroke::Dashed };
        let at = points.get((2 * count + 1) * points.len() / (2 * (links.len() + 1))).copied();
        let ink = Ink::Link(count + 1);
        let now = positions.row_of(look.position).and_then(|row| level(positions, row, count));
        samples.push((Sample::Line(stroke, ink), now));
        items.push(Item::line(points, stroke, ink));
        items.extend(at.map(|at| Item::name(at, name((count + 1).to_string()), Ink::Title)));
    }
    let values = items.iter().flat_map(Item::points).map(|at| at[1]).collect::<Vec<_>>();
    let links = links.iter().filter_map(|owner| positions.schema().named(*owner));
    let names = links.map(|link| joined("", [name("+"), link.into()]));
    let names = std::iter::once(text!("regime-drive")).chain(names);
    let names: Vec<Text> = names.enumerate().map(|(at, told)| plots::numbered(at, told)).collect();
    let title =
        text!("regime-shares", unit = unit(inertia.name), names = joined("  ", names.iter().cloned()));
    let key = |((sample, now), told): ((Sample, Option<f64>), Text)| {
        let now = now.map(|now| inertia.show(now));
        Key { sample, text: joined(": ", std::iter::once(told).chain(now)) }
    };
    let legend = samples.into_iter().zip(names).map(key).collect();
    let y = Axis::around(Text::default(), values, 0.0).measuring(inertia.name);
    let (x, cursor) = (plots::coordinate_axis(&found.linkage), Some(cursor(&found.linkage, look).into()));
    let frame = Frame::Axes { x, y, cursor };
    (Panel { title, frame, items }, legend)
}

/// The iteration to the periodic regime, and the trials of ratio and flywheel, as parts of the values found (S fig. 10).
pub(crate) fn iteration(regime: &RegimeOverCycle, kind: CoordinateKind) -> Vec<Panel> {
    let curve = |told: &'static str, values: Vec<f64>| {
        let points = values.into_iter().enumerate().map(|(at, y)| [(at + 1) as f64, y]);
        (text!(told), Course::from_points(points))
    };
    let panel = |title: Text, label: &'static str, count: usize, curves| {
        let x = Axis { kind: AxisKind::Whole, ..Axis::around(text!(label), [1.0, count.max(2) as f64], 0.0) };
        plots::curves(title, curves, (x, 1.0), None)
    };
    let (turns, trials) = (&regime.found.iterations, &regime.found.trials);
    let mut panels = Vec::new();
    if !turns.is_empty() {
        let ends = vec![
            curve("regime-start", turns.iter().map(|turn| turn.speed_start).collect()),
            curve("regime-end", turns.iter().map(|turn| turn.speed_end).collect()),
        ];
        let title = plots::titled(text!("regime-ends"), Unit::rates_of(kind)[0]);
        panels.push(panel(title, "regime-cycle", turns.len(), ends));
    }
    let Some(last) = trials.last() else { return panels };
    let part = |read: &dyn Fn(&Trial) -> f64| trials.iter().map(|trial| read(trial) / read(last)).collect();
    let mut curves = Vec::new();
    if last.ratio.is_some() {
        curves.push(curve("regime-ratio", part(&|trial| trial.ratio.unwrap_or(f64::NAN))));
    }
    if last.flywheel > 0.0 {
        curves.push(curve("regime-flywheel", part(&|trial| trial.flywheel)));
    }
    curves.push(curve("regime-unevenness", part(&|trial| trial.unevenness)));
    panels.push(panel(text!("regime-parts"), "regime-trial", trials.len(), curves));
    panels
}
