//! What is found between positions: strokes, transfer functions, speeds, the shaking force; where a sweep asks for it, extremes
//! and means of everything.

use assur_analysis::results::{Column, Edges, Owner, Quantity, Table, Turn};
use assur_analysis::{Calculation, unwatched};
use assur_book::{Course, Range, range, range_of};
use assur_geometry::{Extremes, Stroke, overview};

use crate::Sweep;
use crate::layout::{Gathered, Layout, Named};
use crate::measure::{Measured, Sink};

impl Measured {
    /// Adds what is found from the rows of the results: between the positions too, where the sweep asks for that, or of the columns
    /// that are measured as they are.
    pub(crate) fn add_rows(&mut self, calculation: &Calculation, sweep: &Sweep) {
        let layout = &sweep.layout;
        if !sweep.between && layout.plain.is_empty() {
            return;
        }
        let Ok(table) = calculation.rows(&mut unwatched) else { return };
        if sweep.between {
            let edges = calculation.edges(&table);
            let asked = layout.gathered.iter().zip(&sweep.asked);
            let ranges =
                asked.map(|(of, asked)| asked.then(|| between(calculation, &table, &edges, of)).flatten());
            self.ranges = ranges.collect();
            return;
        }
        for plain in &layout.plain {
            let Gathered::Column(column) = layout.gathered[plain.first] else { continue };
            let values = table.schema().find(column).into_iter().flat_map(|column| table.each(column));
            let numbered = table.numbers().iter().zip(values);
            self.statistics[plain.first] =
                numbered.filter_map(|(number, value)| Some((*number, value?))).collect();
        }
    }
}

/// Extremes and means over the positions and between them, as a report has them.
fn between(calculation: &Calculation, table: &Table, edges: &Edges, of: &Gathered) -> Option<Range> {
    let conditions: Vec<Column> = {
        let groups = table.schema().owners(Quantity::Condition).into_iter();
        groups.map(|group: Owner| Column::of(Quantity::Condition, group)).collect()
    };
    let read = |table: &Table, row: usize| {
        let most = |columns: &[Column]| columns.iter().filter_map(|of| table.get(row, *of)).reduce(f64::max);
        match of {
            // A group without a condition number is singular.
            Gathered::Health => {
                let each = conditions.iter().map(|of| table.get(row, *of).map_or(0.0, |of| 1.0 / of));
                each.reduce(f64::min)
            }
            Gathered::Size(column) => table.get(row, *column).map(f64::abs),
            Gathered::Force(moduli) => most(moduli),
            Gathered::Column(_) | Gathered::Transmission => None,
        }
    };
    match of {
        Gathered::Column(column) => {
            let course = Course::of(table, Some(edges), Column::COORDINATE, *column);
            range(calculation, &course, *column)
        }
        Gathered::Transmission => {
            let (_, angle, at) = overview(&calculation.linkage).ok()?.transmission?;
            let least = Turn::at(at, angle);
            Some(Range { greatest: least, least, means: None })
        }
        _ => range_of(calculation, &Course::read(table, Some(edges), Column::COORDINATE, read), &read),
    }
}

/// A part of what is measured with what is known of it between positions.
fn each<'a, T, C>(
    of: &'a [Named<T>],
    courses: Option<&'a Vec<C>>,
) -> impl Iterator<Item = (&'a str, Option<&'a C>)> {
    let course = move |index: usize| courses.and_then(|courses| courses.get(index));
    of.iter().enumerate().map(move |(index, part)| (part.name.as_str(), course(index)))
}

pub(crate) fn stroke(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let courses = found.courses.as_ref();
    for (name, slide) in each(&layout.slides, courses.map(|all| &all.slides)) {
        sink.put(slide.map(|of| of.pf0.max - of.pf0.min), || format!("{name}_stroke_m"));
    }
    for (name, link) in each(&layout.links, courses.map(|all| &all.links)) {
        sink.put(link.and_then(|of| Some(of.pf0?.max - of.pf0?.min)), || format!("{name}_stroke_rad"));
    }
}

pub(crate) fn time_ratio(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let courses = found.courses.as_ref();
    let ratio = |of: &Option<Stroke>| of.as_ref()?.time_ratio;
    for (name, slide) in each(&layout.slides, courses.map(|all| &all.slides)) {
        sink.put(slide.and_then(|of| ratio(&of.stroke)), || format!("{name}_time_ratio"));
    }
    for (name, link) in each(&layout.links, courses.map(|all| &all.links)) {
        sink.put(link.and_then(|of| ratio(&of.stroke)), || format!("{name}_time_ratio"));
    }
}

/// The greatest modulus of a quantity.
fn modulus(of: &Extremes) -> f64 {
    of.min.abs().max(of.max.abs())
}

/// Puts the greatest magnitudes of the first or second derivative of everything that moves; `factor`: of a derivative with respect to the coordinate,
/// `None` where it is not known; `name`: of the part and the unit of what moves, rad or m.
fn derivatives(
    layout: &Layout,
    found: &Measured,
    sink: &mut Sink<'_>,
    (second, factor): (bool, Option<f64>),
    name: impl Fn(&str, &str) -> String,
) {
    let courses = found.courses.as_ref().filter(|_| factor.is_some());
    let size = |[first, then]: [&Extremes; 2]| {
        factor.map(|factor| factor * modulus(if second { then } else { first }))
    };
    for (part, point) in each(&layout.points, courses.map(|all| &all.points)) {
        sink.put(point.and_then(|of| size([&of.pf1, &of.pf2])), || name(part, "m"));
    }
    for (part, slide) in each(&layout.slides, courses.map(|all| &all.slides)) {
        sink.put(slide.and_then(|of| size([&of.pf1, &of.pf2])), || name(part, "m"));
    }
    for (part, link) in each(&layout.links, courses.map(|all| &all.links)) {
        sink.put(link.and_then(|of| size([&of.pf1, &of.pf2])), || name(part, "rad"));
    }
}

pub(crate) fn transfer(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let of = layout.units.coordinate;
    let one = Some(1.0);
    derivatives(layout, found, sink, (false, one), |part, unit| {
        format!("{part}_pf1_greatest_{unit}_per_{of}")
    });
    derivatives(layout, found, sink, (true, one), |part, unit| {
        format!("{part}_pf2_greatest_{unit}_per_{of}2")
    });
}

pub(crate) fn speed(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let factor = found.speed.map(f64::abs);
    derivatives(layout, found, sink, (false, factor), |part, unit| {
        format!("{part}_speed_greatest_{unit}_per_s")
    });
}

pub(crate) fn acceleration(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let factor = found.speed.map(|speed| speed * speed);
    derivatives(layout, found, sink, (true, factor), |part, unit| {
        format!("{part}_acceleration_greatest_{unit}_per_s2")
    });
}

pub(crate) fn shaking(_: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let size = found.shaking.as_ref();
    sink.put(size.map(|size| size.greatest_force), || "shaking_force_greatest_N".to_owned());
    sink.put(size.map(|size| size.rms_force), || "shaking_force_rms_N".to_owned());
    sink.put(size.map(|size| size.greatest_moment), || "shaking_moment_greatest_Nm".to_owned());
}
