//! The geometry of the motion as tables.

use assur_geometry::{AtPosition, CenterAt, Centers, Extremes, Geometry, Stroke};

use super::layout::{Column, Page};
use super::number::short;
use super::units::{ANGLE, LENGTH, MOVING, TURNING, Unit, Units};
use crate::json::{NotFinite, finite};

/// The tables; `ascii`: no character beyond ASCII.
///
/// # Errors
///
/// [`NotFinite`] for a number that is not finite.
pub fn geometry(found: &Geometry, ascii: bool) -> Result<String, NotFinite> {
    let found = finite(found)?;
    let units = Units::of(found.angular);
    let mut page = Page::new(ascii);
    if !found.title.is_empty() {
        page.title(&found.title);
    }
    strokes(found, &units, &mut page);
    extremes(found, &units, &mut page);
    force_angles(found, &units, &mut page);
    rests(found, &units, &mut page);
    centers(found, &units, &mut page);
    curvature(found, &units, &mut page);
    Ok(page.finish())
}

/// A value below this part of the value it stands beside is rounding.
const ROUNDING: f64 = 1e-12;

fn show(value: f64, unit: Unit) -> String {
    short(value * unit.factor)
}

/// A value beside another one of its kind.
fn beside(value: f64, other: f64, unit: Unit) -> String {
    show(if value.abs() <= ROUNDING * other.abs() { 0.0 } else { value }, unit)
}

fn list(values: &[f64], unit: Unit) -> String {
    values.iter().map(|&value| show(value, unit)).collect::<Vec<_>>().join(", ")
}

/// What goes to and fro: name, stroke, units of its displacement and of its speed.
fn swinging(found: &Geometry) -> impl Iterator<Item = (&str, &Stroke, Unit, Unit)> {
    let slides = found.slides.iter().map(|(name, at)| (name, &at.stroke, LENGTH, MOVING[0]));
    let links = found.links.iter().map(|(name, at)| (name, &at.stroke, ANGLE, TURNING[0]));
    let points = found.points.iter().map(|(name, at)| (name, &at.stroke, LENGTH, MOVING[0]));
    let all = slides.chain(links).chain(points);
    all.filter_map(|(name, stroke, unit, speed)| Some((name.as_str(), stroke.as_ref()?, unit, speed)))
}

fn strokes(found: &Geometry, units: &Units, page: &mut Page) {
    page.section("Strokes and dead points");
    let row = |(name, stroke, unit, speed): (&str, &Stroke, Unit, Unit)| {
        let overlap = stroke.overlap.zip(stroke.intervals);
        let overlap = overlap.map(|(angle, [way, _])| beside(angle, way, units.coordinate));
        let ratio = stroke.time_ratio.map_or_else(|| "-".to_owned(), short);
        let speeds = stroke.mean_speeds.map_or_else(|| "-".to_owned(), |speeds| list(&speeds, speed));
        vec![
            name.to_owned(),
            format!("{} {}", show(stroke.stroke, unit), unit.name),
            list(&stroke.dead_points, units.coordinate),
            ratio,
            overlap.unwrap_or_else(|| "-".to_owned()),
            speeds,
        ]
    };
    let rows: Vec<_> = swinging(found).map(row).collect();
    if rows.is_empty() {
        page.paragraph("Nothing goes to and fro.");
        return;
    }
    let unit = units.coordinate.name;
    let [dead, overlap] = ["dead points", "overlap"].map(|head| format!("{head}, {unit}"));
    page.rows(&["what", "stroke", &dead, "time ratio", &overlap, "mean speeds, SI"], &rows);
}

fn extremes(found: &Geometry, units: &Units, page: &mut Page) {
    let mut rows = Vec::new();
    let mut add = |name: &str, what: &str, at: &Extremes, unit: Unit| {
        let coordinate = |value: f64| show(value, units.coordinate);
        let [min, max] = [beside(at.min, at.max, unit), beside(at.max, at.min, unit)];
        let name = name.to_owned();
        rows.push(vec![
            name,
            what.to_owned(),
            unit.name.to_owned(),
            min,
            coordinate(at.at_min),
            max,
            coordinate(at.at_max),
        ]);
    };
    for (name, at) in &found.slides {
        let orders = [&at.pf0, &at.pf1, &at.pf2];
        orders
            .into_iter()
            .zip(units.length)
            .zip(["displacement", "PF1", "PF2"])
            .for_each(|((at, unit), what)| add(name, what, at, unit));
    }
    for (name, at) in &found.links {
        if let Some(pf0) = &at.pf0 {
            add(name, "angle", pf0, units.angle[0]);
        }
        add(name, "PF1", &at.pf1, units.angle[1]);
        add(name, "PF2", &at.pf2, units.angle[2]);
    }
    for (name, at) in &found.points {
        add(name, "x", &at.x, units.length[0]);
        add(name, "y", &at.y, units.length[0]);
        add(name, "|PF1|", &at.pf1, units.length[1]);
        add(name, "|PF2|", &at.pf2, units.length[2]);
    }
    page.section("Extremes over the cycle");
    let at = format!("at, {}", units.coordinate.name);
    page.rows(&["of", "quantity", "unit", "least", &at, "greatest", &at], &rows);
}

fn force_angles(found: &Geometry, units: &Units, page: &mut Page) {
    if found.groups.is_empty() {
        return;
    }
    page.section("Angles of transmission and pressure");
    for (name, at) in &found.groups {
        let ends = &at.extremes;
        let [min, max] = [ends.min, ends.max].map(|angle| show(angle, ANGLE));
        let [at_min, at_max] = [ends.at_min, ends.at_max].map(|at| show(at, units.coordinate));
        let unit = units.coordinate.name;
        page.paragraph(&format!(
            "{name}: {} from {min} deg (at {at_min} {unit}) to {max} deg (at {at_max} {unit})",
            at.what
        ));
    }
}

fn rests(found: &Geometry, units: &Units, page: &mut Page) {
    let links = found.links.iter().map(|(name, at)| (name, &at.rests));
    let points = found.points.iter().map(|(name, at)| (name, &at.rests));
    let at = links.chain(points).filter(|(_, rests)| !rests.is_empty());
    let rows: Vec<_> = at.map(|(name, at)| vec![name.clone(), list(at, units.coordinate)]).collect();
    let always = found.links.iter().filter(|(_, at)| at.rests_always).map(|(name, _)| name.as_str());
    let always: Vec<_> = always.collect();
    if rows.is_empty() && always.is_empty() {
        return;
    }
    page.section("Positions of rest");
    if !rows.is_empty() {
        page.rows(&["link or point", &format!("rests at, {}", units.coordinate.name)], &rows);
    }
    if !always.is_empty() {
        page.paragraph(&format!("At rest over the whole cycle: {}.", always.join(", ")));
    }
}

/// Number and coordinate of the positions.
fn keys(found: &Geometry, units: &Units) -> [Column; 2] {
    let numbers = found.positions.iter().map(|at| at.index.to_string()).collect();
    let coordinate = Column::of(&found.positions, "coordinate", units.coordinate, |at| Some(at.coordinate));
    [Column::texts("No.", numbers), coordinate]
}

fn centers(found: &Geometry, units: &Units, page: &mut Page) {
    page.section("Centers of the links");
    page.paragraph(&format!(
        "P: instant center in the frame of the link `{}` (fixed centrode); p: in the frame of the link itself (moving \
         centrode); J: inflection pole, the other end of the diameter of the inflection circle from P; Q: pole of \
         accelerations at constant input speed. A dash: at infinity.",
        found.against
    ));
    if !found.rigid.is_empty() {
        page.paragraph(&format!(
            "Rigid with `{}` over the whole cycle, and so without centers: {}.",
            found.against,
            found.rigid.join(", ")
        ));
    }
    let Some(first) = found.positions.first() else { return };
    let groups = first.links.keys().filter(|name| !found.rigid.contains(name)).map(|name| {
        let column = |head: String, at: fn(&Centers) -> Option<[f64; 2]>, axis: usize| {
            Column::of(&found.positions, head, LENGTH, move |row| at(row.links.get(name)?).map(|at| at[axis]))
        };
        let point = |letter: &str, at: fn(&Centers) -> Option<[f64; 2]>| {
            [("x", 0), ("y", 1)].map(|(axis, i)| column(format!("{name} {letter}{axis}"), at, i))
        };
        let mut columns = Vec::new();
        columns.extend(point("P", |at| place(&at.center)));
        columns.extend(point("p", |at| at.on_link));
        columns.extend(point("J", |at| at.inflection_pole));
        columns.extend(point("Q", |at| at.acceleration_pole));
        columns
    });
    page.table("Links", &keys(found, units), groups.collect());
}

fn place(center: &CenterAt) -> Option<[f64; 2]> {
    if let CenterAt::Point(place) = center { Some(*place) } else { None }
}

fn curvature(found: &Geometry, units: &Units, page: &mut Page) {
    if found.points.is_empty() {
        return;
    }
    page.section("Curvature of the paths of points");
    page.paragraph("The curvature is positive where the path turns left. A dash: the point rests.");
    let unit = Unit { name: "1/m", factor: 1.0 };
    let groups = found.points.keys().map(|name| {
        let value = |row: &AtPosition| row.points.get(name).map(|at| at.curvature);
        vec![Column::of(&found.positions, name.clone(), unit, value)]
    });
    page.table("Curvature", &keys(found, units), groups.collect());
}
