//! Panels of figures: curves over the positions or over time, and vectors in a plane of their own.

use assur_analysis::results::{Column, Owner, Quantity, Table};
use assur_book::{Course, Node, Unit};
use assur_figure::number::digits;
use assur_figure::{Axis, AxisKind, Bounds, Cursor, Frame, Ink, Item, Panel, Point, Sign, Stroke};
use assur_kinematics::Linkage;
use assur_words::{Text, joined, list, name, number, text, unit};

use crate::{Base, Found, Series, coordinate_at, coordinate_unit};

/// Positions that are marked on a curve at most; more of them would hide it.
const MARKED: usize = 24;

/// How a curve is drawn.
pub(crate) type Style = (Stroke, Ink);

/// Strokes and inks of several curves, told apart without color.
pub(crate) const STYLES: [Style; 6] = [
    (Stroke::Solid, Ink::First),
    (Stroke::Dotted, Ink::Third),
    (Stroke::Chain, Ink::Second),
    (Stroke::Dashed, Ink::Link(5)),
    (Stroke::Solid, Ink::Link(2)),
    (Stroke::Chain, Ink::Link(4)),
];

/// The axis of the coordinate, from the first position to the end of the cycle or to the last position.
pub(crate) fn coordinate_axis(linkage: &Linkage) -> Axis {
    let (symbol, input) = (coordinate_unit(linkage).0, &linkage.mechanism.input);
    let last = input.positions - usize::from(!input.is_cycle());
    let ends = [0.0, last as f64].map(|at| coordinate_at(linkage, at));
    let kind = if linkage.angular() { AxisKind::Degrees } else { AxisKind::Linear };
    Axis { kind, ..Axis::around(list([coordinate_name(linkage), unit(symbol)]), ends, 0.0) }
}

/// The curve of a quantity over the positions or samples, with the cursor at the present one, at which it has a value.
pub fn over_positions(
    Base { axis: x, factor: coordinate, cursor: at }: Base,
    [title, value]: [Text; 2],
    curves: &[(&Series, Stroke, Ink)],
    signs: Vec<Item>,
) -> Panel {
    let at_positions = |series: &Series| {
        let place = |node: &Node| [coordinate * node.at, series.unit.factor * node.value];
        series.course.nodes().iter().map(place).collect::<Vec<Point>>()
    };
    let line = |(series, stroke, ink): &(&Series, Stroke, Ink)| {
        // Each star is a position.
        let points = match stroke {
            Stroke::Stars => at_positions(series),
            _ => series.course.points([coordinate, series.unit.factor]),
        };
        Item::line(points, *stroke, *ink)
    };
    let mut items: Vec<Item> = curves.iter().map(line).collect();
    let are_few = |series: &Series| series.course.nodes().len() <= MARKED;
    let marked =
        curves.first().filter(|(series, ..)| are_few(series)).map(|(series, ..)| at_positions(series));
    items.extend(marked.into_iter().flatten().map(|at| Item::sign(at, Sign::Node, Ink::Title)));
    let values: Vec<f64> = items.iter().flat_map(Item::points).map(|at| at[1]).collect();
    let (floor, unit) = curves.first().map_or((0.0, Text::default()), |(series, ..)| {
        (series.unit.factor * series.floor, unit(series.unit.name))
    });
    items.extend(signs);
    let y = Axis::around(unit, values, floor);
    let cursor = Some(Cursor { at, value });
    Panel { title, frame: Frame::Axes { x, y, cursor }, items }
}

/// Courses, at most as many as there are [`STYLES`], each with its name; where there are several, with a number on them. `factor`: from SI to the unit of
/// the horizontal axis.
pub(crate) fn curves(
    title: Text,
    curves: Vec<(Text, Course)>,
    (x, factor): (Axis, f64),
    cursor: Option<Cursor>,
) -> Panel {
    let count = curves.len();
    let cursor = cursor.map(|cursor| {
        let own = |(_, course): &(Text, Course)| {
            number(
                course.between(cursor.at / factor).map_or_else(|| "-".to_owned(), |value| digits(value, 4)),
            )
        };
        let value = if cursor.value.is_empty() { joined("; ", curves.iter().map(own)) } else { cursor.value };
        Cursor { value, ..cursor }
    });
    let names = curves.iter().enumerate().map(|(at, curve)| numbered(at, curve.0.clone()));
    let title = if count > 1 { joined(": ", [title, joined("  ", names)]) } else { title };
    let mut items = Vec::new();
    for (index, ((_, course), (stroke, ink))) in curves.into_iter().zip(STYLES).enumerate() {
        let points = course.points([factor, 1.0]);
        // Each number at its own part of the curve, so that the numbers of curves that meet are still seen.
        let at = points.get((2 * index + 1) * points.len() / (2 * count)).copied();
        items.push(Item::line(points, stroke, ink));
        let sign =
            at.filter(|_| count > 1).map(|at| Item::name(at, name((index + 1).to_string()), Ink::Title));
        items.extend(sign);
    }
    let points = || items.iter().flat_map(Item::points);
    let y = Axis::around(Text::default(), points().map(|at| at[1]), 0.0);
    Panel { title, frame: Frame::Axes { x, y, cursor }, items }
}

/// A quantity with its unit: `input speed, rad/s`.
pub(crate) fn titled(told: Text, of: Unit) -> Text {
    list([told, unit(of.name)])
}

/// What the scene calls the coordinate.
pub(crate) fn coordinate_name(linkage: &Linkage) -> Text {
    linkage.mechanism.input.name.as_ref().map_or(text!("motion-coordinate"), Text::from)
}

/// The SI unit of the coordinate, in which a motion over time has it.
pub(crate) fn raw_coordinate(linkage: &Linkage) -> &'static str {
    if linkage.angular() { "rad" } else { "m" }
}

/// A name behind its number: `2 resistance`.
pub fn numbered(at: usize, told: Text) -> Text {
    joined(" ", [name((at + 1).to_string()), told])
}

/// The head of an arrow at the end of a line of several points, however short its last piece is.
pub(crate) fn head_of(line: &[Point], ink: Ink) -> Item {
    let [from, at] = *line.last_chunk().unwrap_or(&[[0.0; 2]; 2]);
    Item::Sign { at, along: [0, 1].map(|axis| at[axis] - from[axis]), sign: Sign::Head, ink }
}

/// A vector from one point to another; without a name it is a thin line.
pub(crate) fn arrow([from, to]: [Point; 2], name: &Text, ink: Ink) -> Item {
    if name.is_empty() {
        Item::line([from, to], Stroke::Dotted, ink)
    } else {
        Item::Arrow { from, to, stroke: Stroke::Solid, ink }
    }
}

/// Arrows, lines and points that are drawn together, each with its name, which may be empty; in a unit, with the index of its scale
/// factor. With a pole, it is marked and names are at the tips, as in textbooks.
pub(crate) fn vectors(
    title: Text,
    vectors: Vec<(Item, Text)>,
    (unit, symbol): (&str, &'static str),
    pole: Option<&'static str>,
) -> Panel {
    let part = if pole.is_some() { 1.0 } else { 0.6 };
    let name_of = |(item, text): &(Item, Text)| {
        let part = if matches!(item, Item::Line { .. }) { 0.5 } else { part };
        let ends = item.points();
        let [from, to] = [ends[0], ends[ends.len() - 1]];
        let at = [0, 1].map(|axis| (1.0 - part) * from[axis] + part * to[axis]);
        Item::name(at, text.clone(), Ink::Title)
    };
    let names: Vec<Item> = vectors.iter().filter(|(_, text)| !text.is_empty()).map(name_of).collect();
    let mut items: Vec<Item> = vectors.into_iter().map(|(item, _)| item).chain(names).collect();
    if let Some(pole) = pole {
        items.push(Item::sign([0.0; 2], Sign::Ring, Ink::Title));
        items.push(Item::name([0.0; 2], name(pole), Ink::Title));
    }
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    let frame = Frame::Plane { bounds, unit: unit.into(), factor: 1.0, scale: (symbol, unit.into()) };
    Panel { title, frame, items }
}

/// Gives all panels the bounds of the largest one, so that they have one scale.
pub fn one_scale<'a>(panels: impl IntoIterator<Item = &'a mut Panel>) {
    let mut panels: Vec<&mut Panel> = panels.into_iter().collect();
    let of = |panel: &&mut Panel| {
        if let Frame::Plane { bounds, .. } = &panel.frame { bounds.size() } else { [0.0; 2] }
    };
    let most =
        panels.iter().map(of).fold([0.0_f64; 2], |most, size| [most[0].max(size[0]), most[1].max(size[1])]);
    for panel in &mut panels {
        if let Frame::Plane { bounds, .. } = &mut panel.frame {
            let center = bounds.center();
            let corner = |side: f64| [0, 1].map(|axis| center[axis] + side * most[axis] / 2.0);
            *bounds = Bounds { low: corner(-1.0), high: corner(1.0) };
        }
    }
}

/// A quantity of the input over the samples of the motion: over their times, or over their coordinates.
pub(crate) fn sampled(found: &Found, over: Column, quantity: Quantity) -> Course {
    over_samples(found, over, Column::of(quantity, Owner::Input), 1.0)
}

/// A column over the samples of the motion, times a factor; where the motion comes to rest, the value before it comes first.
pub(crate) fn over_samples(found: &Found, over: Column, column: Column, factor: f64) -> Course {
    let point = |table: &Table, row| Some([table.get(row, over)?, factor * table.get(row, column)?]);
    let samples = &found.analysis.trajectory;
    let edges = found.samples.as_ref().map(|_| &found.edges);
    let before = |row| {
        let (edges, time) = (edges?, samples.get(row, Column::TIME)?);
        let place = edges.places.iter().position(|place| place.to_bits() == time.to_bits())?;
        point(&edges.between, edges.between.row_of(place)?)
    };
    let points = (0..samples.len()).flat_map(|row| before(row).into_iter().chain(point(samples, row)));
    Course::from_points(points)
}

/// The works of the driving and the resisting loads and of dry friction, and the kinetic energy at the samples of the motion; `None` where they are
/// not known.
pub(crate) fn energies(found: &Found, over: Column, x: (Axis, f64), cursor: f64) -> Option<Panel> {
    let all = [
        ("regime-driving-work", Quantity::DrivingWork),
        ("regime-resisting-work", Quantity::ResistingWork),
        ("regime-kinetic-energy", Quantity::KineticEnergy),
    ];
    let mut works: Vec<_> = all.map(|(told, of)| (text!(told), sampled(found, over, of))).into();
    let known = works.iter().all(|(_, course)| !course.is_empty());
    let friction = sampled(found, over, Quantity::FrictionWork);
    works.extend((!friction.is_empty()).then(|| (text!("regime-friction-work"), friction)));
    known.then(|| curves(text!("regime-energies"), works, x, Some(cursor.into())))
}
