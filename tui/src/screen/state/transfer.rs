//! The series of a linkage: coordinate, then PF0, PF1, PF2 of points, links and slides.

use assur_analysis::results::{Column, Owner, Part, Quantity};
use assur_book::{Course, Node};
use assur_kinematics::{Linkage, Position, continuous_angle, first_angle};
use assur_words::{Text, joined, name, text};

use super::series::{Series, Transfer};

/// A value this small compared with the size of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// All series of the positions and of the end of the cycle, and which of them belong together.
pub(crate) fn series(
    linkage: &Linkage,
    poses: &[Option<Position>],
    end: Option<&Position>,
) -> (Vec<Series>, Vec<Transfer>) {
    let end = end.map(|pose| (poses.len(), pose));
    let mut gather = Gather { linkage, poses, end, series: Vec::new(), transfers: Vec::new() };
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
    /// The number after that of the last position, and the end of the cycle.
    end: Option<(usize, &'a Position)>,
    series: Vec<Series>,
    transfers: Vec<Transfer>,
}

impl Gather<'_> {
    fn coordinate(&mut self) {
        let (unit, factor) = coordinate_unit(self.linkage);
        let input = &self.linkage.mechanism.input;
        let node = |number| {
            let at = input.coordinate(number);
            Node { number, at, value: at }
        };
        let end = self.end.map(|(number, _)| node(number));
        let course = Course::from_nodes((0..self.poses.len()).map(node), end);
        let (of, head, unit) = (text!("series-coordinate"), name("q"), unit.to_owned());
        let (column, kind, short) = (Column::COORDINATE, Text::default(), head.to_string());
        self.series.push(Series { column, of, head, short, kind, unit, factor, course, floor: 0.0 });
    }

    fn points(&mut self) {
        let linkage = self.linkage;
        for (id, point) in linkage.mechanism.points.iter().enumerate() {
            if point.places.iter().any(|place| place.link == assur_mechanism::GROUND) {
                continue;
            }
            for (axis, (letter, part)) in [("x", Part::X), ("y", Part::Y)].into_iter().enumerate() {
                let of = text!("series-point", point = &point.name);
                let head = joined(".", [(&point.name).into(), name(letter)]);
                self.add(
                    joined(" ", [of, name(letter)]),
                    &head,
                    place(Owner::Point(id)).part(part),
                    |position| {
                        let motion = linkage.point_motion(id, position);
                        [motion.pf0[axis], motion.pf1[axis], motion.pf2[axis]]
                    },
                );
            }
        }
    }

    fn links(&mut self) {
        let linkage = self.linkage;
        for (id, link) in linkage.mechanism.links.iter().enumerate().skip(1) {
            let mut before: Option<[f64; 2]> = None;
            self.add(
                text!("series-link", link = &link.name),
                &(&link.name).into(),
                place(Owner::Link(id)),
                |position| {
                    let motion = linkage.link_motion(id, position);
                    let angle = before.map_or(first_angle(motion.pf0), |[at, angle]| {
                        let mut near = angle;
                        linkage.each_between([at, position.coordinate], |between| {
                            near = continuous_angle(linkage.link_motion(id, between).pf0, near);
                        });
                        continuous_angle(motion.pf0, near)
                    });
                    before = Some([position.coordinate, angle]);
                    [angle, motion.pf1, motion.pf2]
                },
            );
        }
    }

    fn slides(&mut self) {
        let linkage = self.linkage;
        for (id, slide) in linkage.mechanism.slides.iter().enumerate() {
            self.add(
                text!("series-slide", slide = &slide.name),
                &(&slide.name).into(),
                place(Owner::Slide(id)),
                |position| {
                    let motion = linkage.slide_motion(id, position);
                    [motion.pf0, motion.pf1, motion.pf2]
                },
            );
        }
    }

    /// Adds PF0, PF1 and PF2 of a place, which `read` gives.
    fn add(&mut self, of: Text, head: &Text, column: Column, mut read: impl FnMut(&Position) -> [f64; 3]) {
        let mut nodes: [Vec<Node>; 3] = Default::default();
        let poses = self.poses.iter().enumerate().filter_map(|(number, pose)| Some((number, pose.as_ref()?)));
        for (number, pose) in poses.chain(self.end) {
            let at = pose.coordinate;
            let orders = read(pose).map(|value| Node { number, at, value });
            nodes.iter_mut().zip(orders).for_each(|(all, node)| all.push(node));
        }
        let q = if self.linkage.angular() { "rad" } else { "m" };
        // Angles are of the order of 1; lengths of that of the mechanism.
        let (shown, unit, size) = match column.owner {
            Owner::Link(_) => (("deg", 1.0_f64.to_degrees()), "rad", 1.0),
            _ => (("mm", 1e3), "m", self.linkage.structure.scale),
        };
        let units =
            [(shown.0.to_owned(), shown.1), (format!("{unit}/{q}"), 1.0), (format!("{unit}/{q}2"), 1.0)];
        let first = self.series.len();
        for (order, ((unit, factor), mut nodes)) in (0_u8..).zip(units.into_iter().zip(nodes)) {
            let end = if self.end.is_some() { nodes.pop() } else { None };
            let head = joined("", [head.clone(), name("'".repeat(order.into()))]);
            self.series.push(Series {
                column: Column { quantity: Quantity::Transfer(order), ..column },
                of: of.clone(),
                short: head.to_string(),
                head,
                kind: name(["PF0", "PF1", "PF2"][usize::from(order)]),
                unit,
                factor,
                course: Course::from_nodes(nodes, end),
                floor: ROUNDING * size,
            });
        }
        self.transfers.push(Transfer {
            name: of,
            owner: column.owner,
            orders: [first, first + 1, first + 2],
        });
    }
}

/// PF0 of a link, a point or a slide.
fn place(owner: Owner) -> Column {
    Column::of(Quantity::Transfer(0), owner)
}
