//! The series of a linkage: coordinate, then PF0, PF1, PF2 of points, links and slides.

use assur_analysis::DRAWN;
use assur_analysis::results::{Column, Owner, Part, Quantity, Schema};
use assur_book::catalogue;
use assur_book::{Course, Node};
use assur_group::Order;
use assur_kinematics::{Linkage, Position, continuous_angle, first_angle};

use super::series::{Series, Transfer};

/// A value this small compared with the size of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// Positions times parts of the mechanism: one of very many parts has fewer coordinates.
const PARTS: usize = 1 << 15;

/// All series of the positions and of the end of the cycle, and which of them belong together.
pub(crate) fn series(
    linkage: &Linkage,
    poses: &[Option<Position>],
    end: Option<&Position>,
) -> (Vec<Series>, Vec<Transfer>) {
    let between = between(linkage, poses);
    let end = end.map(|pose| (poses.len(), pose));
    let schema = Schema::new(&linkage.mechanism);
    let mut gather =
        Gather { schema, linkage, poses, between, end, series: Vec::new(), transfers: Vec::new() };
    gather.coordinate();
    gather.points();
    gather.links();
    gather.slides();
    (gather.series, gather.transfers)
}

/// What is drawn beside the positions, in their order: after each position the number of that position, and coordinates up to the
/// next one with what is solved there; a position without a solution is among them.
fn between(linkage: &Linkage, poses: &[Option<Position>]) -> Vec<(usize, f64, Option<Position>)> {
    let input = &linkage.mechanism.input;
    let intervals = poses.len() - usize::from(!input.is_cycle());
    let parts = DRAWN.min(PARTS / linkage.mechanism.parts().max(1)).div_ceil(intervals.max(1)).max(1);
    let mut all = Vec::new();
    for (number, pose) in poses.iter().enumerate() {
        let count = if number < intervals { parts } else { 1 };
        let [from, to] = [number, number + 1].map(|number| input.coordinate(number));
        for part in usize::from(pose.is_some())..count {
            let mut position = linkage.position();
            let at = if part == 0 { from } else { from + (to - from) * part as f64 / parts as f64 };
            let solved = linkage.solve(at, Order::Second, &mut position).is_ok();
            all.push((number, at, solved.then_some(position)));
        }
    }
    all
}

/// Unit in which the coordinate is shown, and its factor from SI.
pub(crate) fn coordinate_unit(linkage: &Linkage) -> (&'static str, f64) {
    if linkage.angular() { catalogue::ANGLE } else { catalogue::LENGTH }
}

struct Gather<'a> {
    schema: Schema,
    linkage: &'a Linkage,
    poses: &'a [Option<Position>],
    /// What lies between the positions.
    between: Vec<(usize, f64, Option<Position>)>,
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
                self.add(place(Owner::Point(id)).part(part), |position, _| {
                    let motion = linkage.point_motion(id, position);
                    [motion.pf0[axis], motion.pf1[axis], motion.pf2[axis]]
                });
            }
        }
    }

    fn links(&mut self) {
        let linkage = self.linkage;
        for id in 1..linkage.mechanism.links.len() {
            self.add(place(Owner::Link(id)), |position, before| {
                let motion = linkage.link_motion(id, position);
                let angle = before.map_or(first_angle(motion.pf0), |before| {
                    let mut near = before.value;
                    linkage.each_between([before.at, position.coordinate], |between| {
                        near = continuous_angle(linkage.link_motion(id, between).pf0, near);
                    });
                    continuous_angle(motion.pf0, near)
                });
                [angle, motion.pf1, motion.pf2]
            });
        }
    }

    fn slides(&mut self) {
        let linkage = self.linkage;
        for id in 0..linkage.mechanism.slides.len() {
            self.add(place(Owner::Slide(id)), |position, _| {
                let motion = linkage.slide_motion(id, position);
                [motion.pf0, motion.pf1, motion.pf2]
            });
        }
    }

    /// Adds PF0, PF1 and PF2 of a place, which `read` gives by a position and by PF0 of one before it.
    fn add(&mut self, column: Column, read: impl Fn(&Position, Option<Node>) -> [f64; 3]) {
        let mut nodes: [Vec<Node>; 3] = Default::default();
        let poses = self.poses.iter().enumerate().filter_map(|(number, pose)| Some((number, pose.as_ref()?)));
        for (number, pose) in poses.chain(self.end) {
            let at = pose.coordinate;
            let orders = read(pose, nodes[0].last().copied()).map(|value| Node { number, at, value });
            nodes.iter_mut().zip(orders).for_each(|(all, node)| all.push(node));
        }
        let (mut before, mut passed): (Option<Node>, _) = (None, nodes[0].iter().peekable());
        let mut between: [Vec<[f64; 2]>; 3] = Default::default();
        for &(number, at, ref pose) in &self.between {
            while let Some(node) = passed.next_if(|node| node.number <= number) {
                before = Some(*node);
            }
            let values = pose.as_ref().map_or([f64::NAN; 3], |pose| read(pose, before));
            before =
                Some(Node { number, at, value: values[0] }).filter(|node| !node.value.is_nan()).or(before);
            between.iter_mut().zip(values).for_each(|(all, value)| all.push([at, value]));
        }
        // Angles are of the order of 1; lengths of that of the mechanism.
        let size = if let Owner::Link(_) = column.owner { 1.0 } else { self.linkage.structure.scale };
        let first = self.series.len();
        for (order, (mut nodes, between)) in (0_u8..).zip(nodes.into_iter().zip(between)) {
            let end = if self.end.is_some() { nodes.pop() } else { None };
            let column = Column { quantity: Quantity::Transfer(order), ..column };
            let course = Course::from_nodes(nodes, end).with_between(between);
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
