//! Panels of figures: curves over the positions or over time, and vectors in a plane of their own.

use std::f64::consts::PI;

use assur_analysis::results::{Column, Owner, Quantity, Table};
use assur_book::{Course, Node, Unit};
use assur_figure::number::digits;
use assur_figure::{
    Axis, AxisKind, Bounds, Cursor, Frame, Ink, Item, Key, Panel, Point, Sample, Scale, Sign, Stroke,
};
use assur_kinematics::Linkage;
use assur_mechanism::CoordinateKind;
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
    let kind = if linkage.kind().is_angle() { AxisKind::Degrees } else { AxisKind::Linear };
    Axis { kind, ..Axis::around(list([coordinate_name(linkage), unit(symbol)]), ends, 0.0) }
        .of_coordinate(symbol)
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
    let measured = curves.first().map_or("", |(series, ..)| series.unit.name);
    let y = Axis::around(unit, values, floor).measuring(measured);
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
    if linkage.kind().is_time() {
        return text!("motion-over-time");
    }
    linkage.mechanism.input.name.as_ref().map_or(text!("motion-coordinate"), Text::from)
}

/// The SI unit of the coordinate, in which a motion over time has it.
pub(crate) fn raw_coordinate(linkage: &Linkage) -> &'static str {
    match linkage.kind() {
        CoordinateKind::Angle => "rad",
        CoordinateKind::Length => "m",
        CoordinateKind::Time => "s",
    }
}

/// A name behind its number: `2 resistance`.
pub fn numbered(at: usize, told: Text) -> Text {
    joined(" ", [name((at + 1).to_string()), told])
}

/// A moment as three quarters of a circle in its sense, from an angle on, with its head however short the last piece is; and the middle of
/// the arc, where its name stands.
pub(crate) fn moment(at: Point, radius: f64, from: f64, moment: f64, ink: Ink) -> ([Item; 2], Point) {
    arc(at, radius, [from, moment.signum() * 1.5 * PI], ink)
}

/// An arc from an angle on and as far around a point, rad, with its head; and where its name stands.
pub(crate) fn arc([x, y]: Point, radius: f64, [from, along]: [f64; 2], ink: Ink) -> ([Item; 2], Point) {
    /// Straight pieces of the arc.
    const PIECES: usize = 48;
    let arc: [Point; PIECES + 1] = std::array::from_fn(|piece| {
        let (s, c) = (from + along * piece as f64 / PIECES as f64).sin_cos();
        [x + radius * c, y + radius * s]
    });
    let [before, at] = [arc[PIECES - 1], arc[PIECES]];
    let head = Item::Sign { at, along: [0, 1].map(|axis| at[axis] - before[axis]), sign: Sign::Head, ink };
    ([Item::line(arc, Stroke::Solid, ink), head], arc[PIECES / 3])
}

/// What a vector is, with its size: `F6 cutting  1500 N`; `further` stands behind it.
pub(crate) fn key(names: [&Text; 2], size: Text, further: Option<Text>, (stroke, ink): Style) -> Key {
    let names = joined(" ", names.into_iter().filter(|name| !name.is_empty()).cloned());
    let text = joined("  ", [names, size].into_iter().chain(further));
    Key { sample: Sample::Line(stroke, ink), text }
}

/// Entries of a legend that leave room for the drawing; of very many the first ones, and how many more there are.
pub(crate) fn limited(mut keys: Vec<Key>) -> Vec<Key> {
    /// Entries that are shown.
    const MOST: usize = 24;
    let more = keys.len().saturating_sub(MOST);
    keys.truncate(MOST);
    let sample = Sample::Line(Stroke::Dotted, Ink::Trace);
    keys.extend((more > 0).then(|| Key { sample, text: text!("plans-more", count = more) }));
    keys
}

/// The axes of a plane through its origin with a few round numbers, each with its name at its end.
pub(crate) fn axes(bounds: &Bounds, names: [Text; 2]) -> Vec<Item> {
    /// Most numbers of an axis, and half the length of their marks as part of the size of the plane.
    const NUMBERS: usize = 4;
    const MARK: f64 = 0.008;
    /// A side of the plane below this part of the other is rounding, and no number on its axis is seen.
    const FLAT: f64 = 1e-6;
    let size = bounds.size().into_iter().fold(0.0, f64::max);
    let mark = MARK * size;
    let mut items = Vec::new();
    for (axis, label) in names.into_iter().enumerate() {
        let place = |along: f64, across: f64| if axis == 0 { [along, across] } else { [across, along] };
        let range = [bounds.low[axis], bounds.high[axis]];
        let own = Axis { label, range, kind: AxisKind::Linear, scale: None };
        items.push(Item::line(range.map(|end| place(end, 0.0)), Stroke::Solid, Ink::Dim));
        for (at, text) in own.ticks(NUMBERS).into_iter().filter(|(at, _)| at.abs() > FLAT * size) {
            items.push(Item::line([-mark, mark].map(|across| place(at, across)), Stroke::Solid, Ink::Dim));
            items.push(Item::name(place(at, 0.0), text, Ink::Dim));
        }
        let end = if range[1] > -range[0] { range[1] } else { range[0] };
        items.push(Item::name(place(end, 0.0), own.label, Ink::Dim));
    }
    items
}

/// A vector from one point to another; without a name it is a thin line.
pub(crate) fn arrow([from, to]: [Point; 2], name: &Text, ink: Ink) -> Item {
    if name.is_empty() {
        Item::line([from, to], Stroke::Dotted, ink)
    } else {
        Item::Arrow { from, to, stroke: Stroke::Solid, ink }
    }
}

/// Arrows, lines and points that are drawn together, each with its name, which may be empty; to a scale. With a pole, of which the subscript is given, it is marked and
/// names are at the tips, as in textbooks.
pub(crate) fn vectors(vectors: Vec<(Item, Text)>, scale: Scale, pole: Option<&'static str>) -> Panel {
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
        items.push(Item::name([0.0; 2], name("p").below(name(pole)), Ink::Title));
    }
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    Panel::plane(bounds, scale, items)
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
    known.then(|| curves(text!("regime-energies"), works, x, Some(cursor.into())).measuring(Unit::JOULE.name))
}
