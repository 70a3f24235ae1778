//! Measures of the motion between positions: strokes, transfer functions, speeds, the shaking force.

use assur_geometry::{Extremes, Stroke};

use crate::layout::{Layout, Named};
use crate::measure::{Measured, Sink};

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
