//! The series of a linkage: coordinate, then PF0, PF1, PF2 of points, links and slides.

use assur_kinematics::{Linkage, Position, continuous_angle};

use super::series::{Owner, Series, Transfer};

/// A value this small compared with the size of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// All series of the positions, and which of them belong together.
pub(crate) fn series(linkage: &Linkage, poses: &[Option<Position>]) -> (Vec<Series>, Vec<Transfer>) {
    let mut gather = Gather { linkage, poses, series: Vec::new(), transfers: Vec::new() };
    gather.coordinate();
    gather.points();
    gather.links();
    gather.slides();
    (gather.series, gather.transfers)
}

/// Unit in which the coordinate is shown, and its factor from SI.
pub(crate) fn coordinate_unit(linkage: &Linkage) -> (&'static str, f64) {
    if linkage.angular() { ("deg", 1.0_f64.to_degrees()) } else { ("mm", 1e3) }
}

struct Gather<'a> {
    linkage: &'a Linkage,
    poses: &'a [Option<Position>],
    series: Vec<Series>,
    transfers: Vec<Transfer>,
}

impl Gather<'_> {
    fn coordinate(&mut self) {
        let (unit, factor) = coordinate_unit(self.linkage);
        let input = &self.linkage.mechanism.input;
        let values = (0..self.poses.len()).map(|index| factor * input.coordinate(index)).collect();
        let [of, short, unit] = ["coordinate", "q", unit].map(str::to_owned);
        self.series.push(Series { of, short, kind: "", unit, values, floor: 0.0 });
    }

    fn points(&mut self) {
        let linkage = self.linkage;
        for (id, point) in linkage.mechanism.points.iter().enumerate() {
            if point.places.iter().any(|place| place.link == assur_mechanism::GROUND) {
                continue;
            }
            for (axis, letter) in ["x", "y"].into_iter().enumerate() {
                let (name, short) =
                    (format!("point {} {letter}", point.name), format!("{}.{letter}", point.name));
                self.add(name, &short, Owner::Point(id), |position| {
                    let motion = linkage.point_motion(id, position);
                    [1e3 * motion.pf0[axis], motion.pf1[axis], motion.pf2[axis]]
                });
            }
        }
    }

    fn links(&mut self) {
        let linkage = self.linkage;
        for (id, link) in linkage.mechanism.links.iter().enumerate().skip(1) {
            let mut before: Option<f64> = None;
            self.add(format!("link {}", link.name), &link.name, Owner::Link(id), |position| {
                let motion = linkage.link_motion(id, position);
                let angle = before.map_or(motion.pf0, |near| continuous_angle(motion.pf0, near));
                before = Some(angle);
                [angle.to_degrees(), motion.pf1, motion.pf2]
            });
        }
    }

    fn slides(&mut self) {
        let linkage = self.linkage;
        for (id, slide) in linkage.mechanism.slides.iter().enumerate() {
            self.add(format!("slide {}", slide.name), &slide.name, Owner::Slide(id), |position| {
                let motion = linkage.slide_motion(id, position);
                [1e3 * motion.pf0, motion.pf1, motion.pf2]
            });
        }
    }

    /// Adds PF0, PF1 and PF2 of a quantity; `read` gives PF0 in degrees or millimeters.
    fn add(&mut self, name: String, short: &str, owner: Owner, mut read: impl FnMut(&Position) -> [f64; 3]) {
        let mut values: [Vec<f64>; 3] = Default::default();
        for pose in self.poses {
            let orders = pose.as_ref().map_or([f64::NAN; 3], &mut read);
            values.iter_mut().zip(orders).for_each(|(column, value)| column.push(value));
        }
        let q = if self.linkage.angular() { "rad" } else { "m" };
        // Angles are of the order of 1; lengths of that of the mechanism.
        let (shown, unit, size) = match owner {
            Owner::Link(_) => ("deg", "rad", 1.0),
            Owner::Point(_) | Owner::Slide(_) => ("mm", "m", self.linkage.structure.scale),
        };
        let units = [shown.to_owned(), format!("{unit}/{q}"), format!("{unit}/{q}2")];
        let first = self.series.len();
        for (order, (unit, values)) in units.into_iter().zip(values).enumerate() {
            let short = format!("{short}{}", "'".repeat(order));
            // PF0 is shown in a unit that is a thousand times smaller.
            let floor = ROUNDING * size * if order == 0 { 1e3 } else { 1.0 };
            self.series.push(Series {
                of: name.clone(),
                short,
                kind: ["PF0", "PF1", "PF2"][order],
                unit,
                values,
                floor,
            });
        }
        self.transfers.push(Transfer { name, owner, orders: [first, first + 1, first + 2] });
    }
}
