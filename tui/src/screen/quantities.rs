//! The series of a linkage: coordinate, then PF0, PF1, PF2 of points, links and slides.

use assur_kinematics::{Linkage, Position, continuous_angle};

use super::series::{Key, Series, Transfer};
use super::text::{ENGLISH, fill};

/// What is this small beside the size of the mechanism is rounding.
const ROUNDING: f64 = 1e-13;

type Values = [Vec<f64>; 3];

/// What is gathered.
#[derive(Debug, Default)]
struct Gathered {
    series: Vec<Series>,
    transfers: Vec<Transfer>,
    /// A length typical of the mechanism, m.
    scale: f64,
}

/// All series of the positions, and which of them belong together.
pub(crate) fn of(linkage: &Linkage, poses: &[Option<Position>]) -> (Vec<Series>, Vec<Transfer>) {
    let mut gathered = Gathered { scale: linkage.structure.scale, ..Gathered::default() };
    gathered.series.push(coordinate(linkage, poses.len()));
    let unit = if linkage.angular() { "rad" } else { "m" };
    points(linkage, poses, unit, &mut gathered);
    links(linkage, poses, unit, &mut gathered);
    slides(linkage, poses, unit, &mut gathered);
    (gathered.series, gathered.transfers)
}

fn coordinate(linkage: &Linkage, positions: usize) -> Series {
    let (unit, factor) = coordinate_unit(linkage);
    let values = (0..positions).map(|i| factor * linkage.mechanism.input.coordinate(i)).collect();
    Series { of: ENGLISH.coordinate.into(), short: "q".into(), unit: unit.into(), values, floor: 0.0 }
}

/// Unit in which the coordinate is shown, and how many of it are one SI unit.
pub(crate) fn coordinate_unit(linkage: &Linkage) -> (&'static str, f64) {
    if linkage.angular() { ("deg", 1.0_f64.to_degrees()) } else { ("mm", 1e3) }
}

fn points(linkage: &Linkage, poses: &[Option<Position>], unit: &str, out: &mut Gathered) {
    for (id, point) in linkage.mechanism.points.iter().enumerate() {
        if point.places.iter().any(|place| place.link == assur_mechanism::GROUND) {
            continue;
        }
        for (axis, letter) in ["x", "y"].into_iter().enumerate() {
            let values = gather(poses, |position| {
                let motion = linkage.point_motion(id, position);
                [1e3 * motion.pf0[axis], motion.pf1[axis], motion.pf2[axis]]
            });
            let units = ["mm".into(), format!("m/{unit}"), format!("m/{unit}2")];
            let names = (
                format!("{} {letter}", fill(ENGLISH.point_of, &[&point.name])),
                format!("{}.{letter}", point.name),
            );
            out.add(names, Key::Point(id), units, values);
        }
    }
}

fn links(linkage: &Linkage, poses: &[Option<Position>], unit: &str, out: &mut Gathered) {
    for (id, link) in linkage.mechanism.links.iter().enumerate().skip(1) {
        let mut before: Option<f64> = None;
        let values = gather(poses, |position| {
            let motion = linkage.link_motion(id, position);
            let angle = before.map_or(motion.pf0, |near| continuous_angle(motion.pf0, near));
            before = Some(angle);
            [angle.to_degrees(), motion.pf1, motion.pf2]
        });
        let units = ["deg".into(), format!("rad/{unit}"), format!("rad/{unit}2")];
        out.add((fill(ENGLISH.link_of, &[&link.name]), link.name.clone()), Key::Link(id), units, values);
    }
}

fn slides(linkage: &Linkage, poses: &[Option<Position>], unit: &str, out: &mut Gathered) {
    for (id, slide) in linkage.mechanism.slides.iter().enumerate() {
        let values = gather(poses, |position| {
            let motion = linkage.slide_motion(id, position);
            [1e3 * motion.pf0, motion.pf1, motion.pf2]
        });
        let units = ["mm".into(), format!("m/{unit}"), format!("m/{unit}2")];
        out.add((fill(ENGLISH.slide_of, &[&slide.name]), slide.name.clone()), Key::Slide(id), units, values);
    }
}

fn gather(poses: &[Option<Position>], mut read: impl FnMut(&Position) -> [f64; 3]) -> Values {
    let mut values: Values = Default::default();
    for pose in poses {
        let row = pose.as_ref().map_or([f64::NAN; 3], &mut read);
        values.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
    }
    values
}

impl Gathered {
    fn add(&mut self, (name, short): (String, String), key: Key, units: [String; 3], values: Values) {
        let first = self.series.len();
        // Angles are of the order of 1; lengths of that of the mechanism, and PF0 is shown in mm.
        let size = if matches!(key, Key::Link(_)) { 1.0 } else { self.scale };
        for (order, (unit, values)) in units.into_iter().zip(values).enumerate() {
            let short = format!("{short}{}", "'".repeat(order));
            let floor = ROUNDING * size * if order == 0 { 1e3 } else { 1.0 };
            self.series.push(Series { of: name.clone(), short, unit, values, floor });
        }
        self.transfers.push(Transfer { name, key, orders: [first, first + 1, first + 2] });
    }
}
