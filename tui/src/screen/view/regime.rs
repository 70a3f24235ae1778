//! The steady regime as plots: speed with that of the first turn, moments with their mean, motor, iteration, energies, the
//! energy-mass diagram, the shares of the reduced inertia, the link of reduction.

use assur_analysis::results::{
    Analysis, Column, Dynamics, EnergyMass, Owner, Quantity, RegimePoint, RegimeReport, Table, Trial,
};
use assur_book::{Course, Step};
use assur_figure::{Axis, Bounds, Frame, Ink, Item, Kind, Panel, Sign, Stroke};
use assur_mechanism::{InputPair, PointId};
use assur_words::{Text, joined, list, name, number, quantity, text, unit};

use super::plots;
use crate::number::{digits, plain};
use crate::screen::state::{Found, Scene, State, coordinate_unit};

/// A quantity of the regime over the cycle; where `read` gives none, the course has none.
fn over(regime: &RegimeReport, read: impl Fn(&RegimePoint) -> Option<f64>) -> Course {
    Course::from_points(regime.course.iter().filter_map(|row| Some([row.coordinate, read(row)?])))
}

/// The present coordinate in the unit that is shown.
fn cursor(state: &State, scene: &Scene) -> f64 {
    scene.coordinate_at(state.at())
}

/// Speed in the regime and in the first turn, then the moments and the energies.
pub(super) fn course(state: &State, scene: &Scene, found: &Found, regime: &RegimeReport) -> Vec<Panel> {
    let mut lines = vec![(text!("regime-course"), over(regime, |row| Some(row.speed)))];
    let first_turn = over(regime, |row| row.first_turn);
    if !first_turn.is_empty() {
        lines.push((text!("regime-first-turn"), first_turn));
    }
    let speed =
        plots::curves(text!("regime-input-speed"), lines, axis(scene), Some(cursor(state, scene).into()));
    let energies = energies(&found.analysis, Column::COORDINATE, axis(scene), cursor(state, scene));
    [speed, moments(state, scene, found, regime)].into_iter().chain(energies).collect()
}

/// The coordinate over the cycle, and its factor from SI.
fn axis(scene: &Scene) -> (Axis, f64) {
    (plots::coordinate_axis(scene), coordinate_unit(&scene.linkage).1)
}

/// Moments of the drive and the resistance on the input, with the mean resistance.
pub(super) fn moments(state: &State, scene: &Scene, found: &Found, regime: &RegimeReport) -> Panel {
    // What drives is shown along the motion, and the resistance against it, as its mean is. Driving is what does work over the cycle.
    let sense = scene.linkage.mechanism.input.sign();
    let of_loads = Column::of(Quantity::ReducedMoment, Owner::Input);
    let jumps = Course::of(&found.analysis.positions, Some(&found.edges), Column::COORDINATE, of_loads);
    let drive = |sign: f64| over(regime, |row| Some(sign * sense * row.drive));
    let load = |sign: f64| {
        let factor = sign * sense;
        let step = |step: Step| step.values.map(|value| [step.at, factor * value]);
        over(regime, |row| Some(factor * row.load)).with_between(jumps.steps().flat_map(step).collect())
    };
    let mean = |sign: f64| (text!("regime-mean"), over(regime, |_| Some(sign * regime.mean_resistance)));
    let lines = if regime.loads_drive() {
        let driving = (text!("regime-driving-loads"), load(1.0));
        vec![driving, (text!("regime-resistance"), drive(-1.0)), mean(-1.0)]
    } else {
        vec![(text!("regime-motor"), drive(1.0)), (text!("regime-resistance"), load(-1.0)), mean(1.0)]
    };
    plots::curves(text!("regime-moments"), lines, axis(scene), Some(cursor(state, scene).into()))
}

/// The motor's characteristic, with its working section; `None` without a motor of a catalogue.
pub(super) fn characteristic(dynamics: &Dynamics) -> Option<Panel> {
    let work = &dynamics.motor.as_ref()?.work;
    let course = |points: &[[f64; 2]]| Course::from_points(points.iter().copied());
    let lines = vec![
        (text!("regime-whole"), course(&work.curve)),
        (text!("regime-working-section"), course(&work.working_section)),
    ];
    let x = Axis::around(text!("regime-motor-speed"), work.curve.iter().map(|at| at[0]), 0.0);
    let mut panel = plots::curves(text!("regime-characteristic"), lines, (x, 1.0), None);
    mark_section(&mut panel, dynamics, &work.working_section);
    Some(panel)
}

/// The working section of the characteristic by itself; `None` without a motor of a catalogue.
pub(super) fn working_section(dynamics: &Dynamics) -> Option<Panel> {
    let work = &dynamics.motor.as_ref()?.work;
    let section = Course::from_points(work.working_section.iter().copied());
    let x = Axis::around(text!("regime-motor-speed"), work.speed, 0.0);
    let title = list([text!("regime-working-section"), unit("N m")]);
    let mut panel = plots::curves(title, vec![(text!("regime-working-section"), section)], (x, 1.0), None);
    mark_section(&mut panel, dynamics, &work.working_section);
    Some(panel)
}

/// `δ = 0.05`.
fn unevenness(dynamics: &Dynamics) -> Text {
    text!("regime-delta", delta = number(plain(dynamics.figures.unevenness)))
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
    panel.items.extend(section.last().map(|at| Item::name(*at, unevenness(dynamics), Ink::Title)));
}

/// The energy-mass diagram with its two tangents.
pub(super) fn energy_mass(diagram: &EnergyMass) -> Panel {
    let inertias = || diagram.curve.iter().map(|at| at[0]);
    let x = Axis::around(text!("regime-links-inertia"), inertias(), 0.0);
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
    let mut panel = plots::curves(text!("regime-energy-mass"), lines, (x, 1.0), None);
    panel.items.extend(diagram.tangents.map(|tangent| Item::sign(tangent.touches, Sign::Plus, Ink::Title)));
    panel
}

/// The reduced inertia over the positions, the shares of flywheel with rotor and of each link above each other.
pub(super) fn shares(state: &State, scene: &Scene, found: &Found, dynamics: &Dynamics) -> Panel {
    let positions = &found.analysis.positions;
    let owners = positions.schema().owners(Quantity::ReducedInertia).into_iter();
    let links: Vec<Owner> = owners.filter(|owner| matches!(owner, Owner::Link(_))).collect();
    // The sum of flywheel, rotor and the first `count` links in a row.
    let level = |table: &Table, row: usize, count: usize| {
        let share = |owner: &Owner| table.get(row, Column::of(Quantity::ReducedInertia, *owner));
        let sum = links[..count].iter().map(share).sum::<Option<f64>>()?;
        Some(dynamics.regime.shaft_inertia + sum)
    };
    let (_, factor) = coordinate_unit(&scene.linkage);
    let mut items = Vec::new();
    for count in 0..=links.len() {
        let value = |table: &Table, row: usize| level(table, row, count);
        let course = Course::read(positions, Some(&found.edges), Column::COORDINATE, value);
        let points = course.points([factor, 1.0]);
        let stroke = if count == links.len() { Stroke::Solid } else { Stroke::Dashed };
        let at = points.get((2 * count + 1) * points.len() / (2 * (links.len() + 1))).copied();
        items.push(Item::line(points, stroke, Ink::First));
        items.extend(at.map(|at| Item::name(at, name((count + 1).to_string()), Ink::Title)));
    }
    let values = items.iter().flat_map(Item::points).map(|at| at[1]).collect::<Vec<_>>();
    let links = links.iter().filter_map(|owner| positions.schema().named(*owner));
    let names = links.map(|link| joined("", [name("+"), link.into()]));
    let names = std::iter::once(text!("regime-drive")).chain(names);
    let names = names.enumerate().map(|(at, told)| plots::numbered(at, told));
    let title = text!("regime-shares", names = joined("  ", names));
    let y = Axis::around(unit("kg m2"), values, 0.0);
    let frame =
        Frame::Axes { x: plots::coordinate_axis(scene), y, cursor: Some(cursor(state, scene).into()) };
    Panel { title, frame, items }
}

/// The link of reduction (E fig. 1c): the input link with the reduced force and mass at its point.
pub(super) fn reduction(state: &State, scene: &Scene, found: &Found, dynamics: &Dynamics) -> Option<Panel> {
    let table = &found.analysis.positions;
    let (point, row) = (dynamics.reduction_point.as_ref()?, table.row_of(state.position)?);
    let at = |point: PointId, order| {
        let column = Column::vector(Quantity::Transfer(order), Owner::Point(point));
        let [x, y] = column.map(|column| table.get(row, column));
        Some([x?, y?])
    };
    let (tip, along) = (at(point.name.id, 0)?, at(point.name.id, 1)?);
    let pin = match scene.linkage.mechanism.input.pair {
        InputPair::Pin(pin) => at(pin, 0)?,
        InputPair::Slide(_) => tip,
    };
    let moment = table.schema().find(Column::of(Quantity::ReducedMoment, Owner::Input))?;
    let force = table.at(row, moment)? / point.radius;
    let inertia = table.get(row, Column::of(Quantity::ReducedInertia, Owner::Input))?;
    let most =
        table.each(moment).flatten().fold(0.0_f64, |most, moment| most.max(moment.abs())) / point.radius;
    // The greatest force of the cycle is as long as the radius.
    let length = if most > 0.0 { force / most } else { 0.0 };
    let to = [0, 1].map(|axis| tip[axis] + length * along[axis]);
    let around = [0, 1].map(|axis| [-1.0, 1.0].map(|side| pin[axis] + 1.5 * side * point.radius));
    let bounds = Bounds::around([[around[0][0], around[1][0]], [around[0][1], around[1][1]]].into_iter());
    let mass = inertia / (point.radius * point.radius);
    let items = vec![
        Item::line(vec![pin, tip], Stroke::Solid, Ink::First),
        Item::sign(pin, Sign::Plus, Ink::Title),
        Item::Arrow { from: tip, to, stroke: Stroke::Solid, ink: Ink::Second },
        Item::name(tip, Text::from(&point.name), Ink::Title),
    ];
    let (force, mass) = (quantity(digits(force, 5), "N"), quantity(digits(mass, 5), "kg"));
    let title = text!("regime-reduced", point = &point.name, force = force, mass = mass);
    let frame = Frame::Plane { bounds, unit: "m".into(), factor: 1.0, scale: ("l", "m".into()) };
    Some(Panel { title, frame, items })
}

/// The iteration to the periodic regime, and the trials of ratio and flywheel, as parts of the values found (S fig. 10).
pub(super) fn iteration(regime: &RegimeReport) -> Vec<Panel> {
    let curve = |told: &'static str, values: Vec<f64>| {
        let points = values.into_iter().enumerate().map(|(at, y)| [(at + 1) as f64, y]);
        (text!(told), Course::from_points(points))
    };
    let panel = |title: &'static str, label: &'static str, count: usize, curves| {
        let x = Axis { kind: Kind::Whole, ..Axis::around(text!(label), [1.0, count.max(2) as f64], 0.0) };
        plots::curves(text!(title), curves, (x, 1.0), None)
    };
    let (turns, trials) = (&regime.iteration, &regime.trials);
    let mut panels = Vec::new();
    if !turns.is_empty() {
        let ends = vec![
            curve("regime-start", turns.iter().map(|turn| turn.speed_start).collect()),
            curve("regime-end", turns.iter().map(|turn| turn.speed_end).collect()),
        ];
        panels.push(panel("regime-ends", "regime-cycle", turns.len(), ends));
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
    panels.push(panel("regime-parts", "regime-trial", trials.len(), curves));
    panels
}

/// A quantity of the input over the samples of the motion: over their times, or over their coordinates.
pub(super) fn sampled(analysis: &Analysis, over: Column, quantity: Quantity) -> Course {
    Course::of(&analysis.trajectory, None, over, Column::of(quantity, Owner::Input))
}

/// The works of the driving and the resisting loads and of dry friction, and the kinetic energy at the samples of the motion; `None` where they are
/// not known.
pub(super) fn energies(analysis: &Analysis, over: Column, x: (Axis, f64), cursor: f64) -> Option<Panel> {
    let all = [
        ("regime-driving-work", Quantity::DrivingWork),
        ("regime-resisting-work", Quantity::ResistingWork),
        ("regime-kinetic-energy", Quantity::KineticEnergy),
    ];
    let mut curves: Vec<_> = all.map(|(told, of)| (text!(told), sampled(analysis, over, of))).into();
    let known = curves.iter().all(|(_, course)| !course.is_empty());
    let friction = sampled(analysis, over, Quantity::FrictionWork);
    curves.extend((!friction.is_empty()).then(|| (text!("regime-friction-work"), friction)));
    known.then(|| plots::curves(text!("regime-energies"), curves, x, Some(cursor.into())))
}
