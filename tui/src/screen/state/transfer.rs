//! The series of a linkage: coordinate, then PF0, PF1, PF2 of points, links and slides.

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema};
use assur_book::catalogue;
use assur_book::{Course, Node};
use assur_kinematics::{Linkage, Position, continuous_angle, first_angle};

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
    let schema = Schema::new(&linkage.mechanism);
    let mut gather = Gather { schema, linkage, poses, end, series: Vec::new(), transfers: Vec::new() };
    gather.coordinate();
    gather.points();
    gather.links();
    gather.slides();
    (gather.series, gather.transfers)
}

/// Unit in which the coordinate is shown, and its factor from SI.
pub(crate) fn coordinate_unit(linkage: &Linkage) -> (&'static str, f64) {
    if linkage.angular() { catalogue::ANGLE } else { catalogue::LENGTH }
}

struct Gather<'a> {
    schema: Schema,
    linkage: &'a Linkage,
    poses: &'a [Option<Position>],
    /// The number after that of the last position, and the end of the cycle.
    end: Option<(usize, &'a Position)>,
    series: Vec<Series>,
    transfers: Vec<Transfer>,
}

impl Gather<'_> {
    fn coordinate(&mut self) {
        let input = &self.linkage.mechanism.input;
        let node = |number| {
            let at = input.coordinate(number);
            Node { number, at, value: at }
        };
        let end = self.end.map(|(number, _)| node(number));
        let course = Course::from_nodes((0..self.poses.len()).map(node), end);
        self.series.push(Series::of(&self.schema, Column::COORDINATE, course, 0.0));
    }

    fn points(&mut self) {
        let linkage = self.linkage;
        for (id, point) in linkage.mechanism.points.iter().enumerate() {
            if point.places.iter().any(|place| place.link == assur_mechanism::GROUND) {
                continue;
            }
            for (axis, part) in [Part::X, Part::Y].into_iter().enumerate() {
                self.add(place(Owner::Point(id)).part(part), |position| {
                    let motion = linkage.point_motion(id, position);
                    [motion.pf0[axis], motion.pf1[axis], motion.pf2[axis]]
                });
            }
        }
    }

    fn links(&mut self) {
        let linkage = self.linkage;
        for id in 1..linkage.mechanism.links.len() {
            let mut before: Option<[f64; 2]> = None;
            self.add(place(Owner::Link(id)), |position| {
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
            });
        }
    }

    fn slides(&mut self) {
        let linkage = self.linkage;
        for id in 0..linkage.mechanism.slides.len() {
            self.add(place(Owner::Slide(id)), |position| {
                let motion = linkage.slide_motion(id, position);
                [motion.pf0, motion.pf1, motion.pf2]
            });
        }
    }

    /// Adds PF0, PF1 and PF2 of a place, which `read` gives.
    fn add(&mut self, column: Column, mut read: impl FnMut(&Position) -> [f64; 3]) {
        let mut nodes: [Vec<Node>; 3] = Default::default();
        let poses = self.poses.iter().enumerate().filter_map(|(number, pose)| Some((number, pose.as_ref()?)));
        for (number, pose) in poses.chain(self.end) {
            let at = pose.coordinate;
            let orders = read(pose).map(|value| Node { number, at, value });
            nodes.iter_mut().zip(orders).for_each(|(all, node)| all.push(node));
        }
        // Angles are of the order of 1; lengths of that of the mechanism.
        let size = if let Owner::Link(_) = column.owner { 1.0 } else { self.linkage.structure.scale };
        let first = self.series.len();
        for (order, mut nodes) in (0_u8..).zip(nodes) {
            let end = if self.end.is_some() { nodes.pop() } else { None };
            let column = Column { quantity: Quantity::Transfer(order), ..column };
            let course = Course::from_nodes(nodes, end);
            self.series.push(Series::of(&self.schema, column, course, ROUNDING * size));
        }
        let name = catalogue::subject(&self.schema, column);
        self.transfers.push(Transfer { name, owner: column.owner, orders: [first, first + 1, first + 2] });
    }
}

/// PF0 of a link, a point or a slide.
fn place(owner: Owner) -> Column {
    Column::of(Quantity::Transfer(0), owner)
}
