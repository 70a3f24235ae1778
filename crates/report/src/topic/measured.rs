//! The geometry of the motion as tables.

use std::f64::consts::FRAC_PI_2;

use assur_book::{Column, Document, Group, Table, Unit, zero_if_rounding};
use assur_geometry::{AtPosition, Centers, Geometry, PartCourse, Stroke};
use assur_mechanism::Named;
use assur_words::{Text, name, text};

use super::structure::named;

/// What was measured on the motion.
pub fn geometry(found: &Geometry, page: &mut Document) {
    let unit = Unit::coordinate(found.kind);
    page.scene(&found.title);
    strokes(found, unit, page);
    extremes(found, unit, page);
    force_angles(found, unit, page);
    rests(found, unit, page);
    centers(found, unit, page);
    curvature(found, unit, page);
}

fn list(values: &[f64], unit: Unit) -> Text {
    assur_words::list(values.iter().map(|&value| unit.number(value)))
}

/// What goes to and fro: name, stroke, and whether it is a link, which turns.
fn swinging(found: &Geometry) -> impl Iterator<Item = (&Named<usize>, &Stroke, bool)> {
    let all = [(&found.slides, false), (&found.links, true), (&found.points, false)].into_iter();
    let all = all.flat_map(|(parts, turns)| parts.iter().map(move |(name, at)| (name, &at.stroke, turns)));
    all.filter_map(|(name, stroke, turns)| Some((name, stroke.as_ref()?, turns)))
}

fn strokes(found: &Geometry, unit: Unit, page: &mut Document) {
    page.heading(text!("geometry-strokes"));
    let overlap = |stroke: &Stroke| {
        let (angle, [way, _]) = stroke.overlap.zip(stroke.intervals)?;
        Some(zero_if_rounding(angle, way))
    };
    let table = Table::each(Text::default(), swinging(found))
        .column(text!("head-what"), |(name, ..)| Text::from(*name))
        .column(text!("head-stroke"), |(_, stroke, turns)| Unit::place(*turns).show(stroke.stroke))
        .measured(text!("head-dead-points"), unit, |(_, stroke, _)| list(&stroke.dead_points, unit))
        .column(text!("head-time-ratio"), |(_, stroke, _)| stroke.time_ratio)
        .measured(text!("head-overlap"), unit, |(_, stroke, _)| overlap(stroke))
        .column(text!("head-mean-speeds"), |(_, stroke, turns)| {
            stroke.mean_speeds.map(|speeds| list(&speeds, Unit::rates(*turns)[0]))
        })
        .table();
    // Over a part of a cycle a slide may turn back once: a stroke takes two dead points.
    let turns_back = |at: &PartCourse| at.stroke.is_none() && at.pf1.min < 0.0 && at.pf1.max > 0.0;
    let once: Vec<_> = found.slides.iter().filter(|(_, at)| turns_back(at)).collect();
    if !table.is_empty() {
        page.table(table);
    } else if once.is_empty() {
        page.paragraph(text!("geometry-no-strokes"));
    }
    for (slide, at) in once {
        let places = assur_words::list(at.rests.iter().map(|rest| unit.show(*rest)));
        page.paragraph(text!("geometry-turns-back", slide = Text::from(slide), places));
    }
}

fn extremes(found: &Geometry, unit: Unit, page: &mut Document) {
    // Derivatives by time are velocities.
    let [first, second] = if found.kind.is_time() {
        [text!("quantity-velocity"), text!("quantity-acceleration")]
    } else {
        [text!("quantity-pf1"), text!("quantity-pf2")]
    };
    let mut rows = Vec::new();
    let mut add = |of, what, at, unit| rows.push((of, what, at, unit));
    let [length, angle] =
        [false, true].map(|is| [0, 1, 2].map(|order| Unit::transfer(is, found.kind, order)));
    let slides = found.slides.iter().map(|part| (part, text!("geometry-displacement"), length));
    let links = found.links.iter().map(|part| (part, text!("geometry-angle"), angle));
    for ((of, at), place, units) in slides.chain(links) {
        at.pf0.iter().for_each(|pf0| add(of, place.clone(), pf0, units[0]));
        add(of, first.clone(), &at.pf1, units[1]);
        add(of, second.clone(), &at.pf2, units[2]);
    }
    for (of, at) in &found.points {
        let coordinates = [("x", &at.x), ("y", &at.y)].into_iter();
        coordinates.for_each(|(axis, at)| at.iter().for_each(|at| add(of, name(axis), at, length[0])));
        add(of, text!("geometry-modulus", of = first.clone()), &at.pf1, length[1]);
        add(of, text!("geometry-modulus", of = second.clone()), &at.pf2, length[2]);
    }
    page.heading(text!("geometry-extremes"));
    // What is rounding beside the greatest of its unit is zero: a point on a line, a link that does not turn.
    let greatest = |unit: Unit| {
        let same = rows.iter().filter(|(.., own)| own.name == unit.name);
        same.flat_map(|(_, _, at, _)| [at.min.abs(), at.max.abs()]).fold(0.0, f64::max)
    };
    let rows: Vec<_> = rows.iter().map(|row| (row.0, row.1.clone(), row.2, row.3, greatest(row.3))).collect();
    let table = Table::each(Text::default(), rows)
        .column(text!("head-of"), |(of, ..)| Text::from(*of))
        .column(text!("head-quantity"), |(_, what, ..)| what.clone())
        .column(text!("head-unit"), |(_, _, _, unit, _)| assur_words::unit(unit.name))
        .column(text!("head-least"), |(.., at, unit, kind)| unit.number(zero_if_rounding(at.min, *kind)))
        .measured(text!("head-at"), unit, |(.., at, _, _)| at.at_min)
        .column(text!("head-greatest"), |(.., at, unit, kind)| unit.number(zero_if_rounding(at.max, *kind)))
        .measured(text!("head-at"), unit, |(.., at, _, _)| at.at_max);
    page.table(table.table());
}

fn force_angles(found: &Geometry, unit: Unit, page: &mut Document) {
    if found.groups.is_empty() {
        return;
    }
    page.heading(text!("geometry-force-angles"));
    for (group, at) in &found.groups {
        let ends = &at.extremes;
        // Rounding beside a right angle, of which both angles are a part.
        let clean = |angle| zero_if_rounding(angle, FRAC_PI_2);
        let [least, most] = [ends.min, ends.max].map(|angle| Unit::ANGLE.show(clean(angle)));
        if clean(ends.max - ends.min) == 0.0 {
            page.paragraph(text!("geometry-force-angle-constant", group, what = &at.what, angle = most));
            continue;
        }
        let [at_least, at_most] = [ends.at_min, ends.at_max].map(|at| unit.show(at));
        page.paragraph(text!("geometry-force-angle", group, what = &at.what, least, at_least, most, at_most));
    }
}

fn rests(found: &Geometry, unit: Unit, page: &mut Document) {
    let resting = found.links.iter().chain(&found.points).filter(|(_, at)| !at.rests.is_empty());
    let table = Table::each(Text::default(), resting)
        .column(text!("head-link-or-point"), |(of, _)| Text::from(*of))
        .measured(text!("head-rests-at"), unit, |(_, at)| list(&at.rests, unit))
        .table();
    let always =
        found.links.iter().filter(|(_, at)| at.rests_always == Some(true)).map(|(link, _)| Text::from(link));
    let always: Vec<_> = always.collect();
    if table.is_empty() && always.is_empty() {
        return;
    }
    page.heading(text!("geometry-rests"));
    page.table(table);
    if !always.is_empty() {
        page.paragraph(text!("geometry-rests-always", links = assur_words::list(always)));
    }
}

/// Number and coordinate of the positions.
fn keys(found: &Geometry, unit: Unit) -> Vec<Column> {
    let numbers = Column::counted(text!("head-number"), found.positions.iter().map(|at| at.index));
    let coordinates = found.positions.iter().map(|at| Some(at.coordinate));
    vec![numbers, Column::numbers(text!("head-coordinate"), unit, coordinates)]
}

fn centers(found: &Geometry, unit: Unit, page: &mut Document) {
    page.heading(text!("geometry-centers"));
    let against = Text::from(&found.against);
    page.paragraph(text!("geometry-centers-text", link = against.clone()));
    if !found.rigid.is_empty() {
        let rigid = named(&found.rigid);
        page.paragraph(text!("geometry-rigid", against, links = rigid));
    }
    let Some(first) = found.positions.first() else { return };
    let groups = first.links.keys().filter(|name| !found.rigid.contains(name)).map(|link| {
        let column = |head: String, at: fn(&Centers) -> Option<[f64; 2]>, axis: usize| {
            let value = |row: &AtPosition| at(row.links.get(link)?).map(|at| at[axis]);
            Column::numbers(name(head), Unit::LENGTH, found.positions.iter().map(value))
        };
        let point = |letter: &str, at: fn(&Centers) -> Option<[f64; 2]>| {
            [("x", 0), ("y", 1)].map(|(axis, i)| column(format!("{letter}{axis}"), at, i))
        };
        let all = [
            point("P", |at| at.center.point()),
            point("p", |at| at.on_link),
            point("J", |at| at.inflection_pole),
            point("Q", |at| at.acceleration_pole),
        ];
        Group { owner: Text::from(link), columns: all.into_iter().flatten().collect() }
    });
    let (groups, keys) = (groups.collect(), keys(found, unit));
    page.table(Table { caption: text!("head-links"), keys, owners: text!("head-link"), groups });
}

fn curvature(found: &Geometry, unit: Unit, page: &mut Document) {
    if found.points.is_empty() {
        return;
    }
    page.heading(text!("geometry-curvature"));
    page.paragraph(text!("geometry-curvature-text"));
    let column = |point: &Named<usize>| {
        let value = |row: &AtPosition| row.points.get(point).map(|at| at.curvature);
        Column::numbers(Text::from(point), Unit::CURVATURE, found.positions.iter().map(value))
    };
    let columns = found.points.keys().map(column).collect();
    page.table(Table::over(text!("head-curvature"), keys(found, unit), columns));
}
