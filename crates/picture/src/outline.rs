//! What a drawing of a linkage needs of its whole cycle: closely spaced positions, paths, strokes, bounds.

use std::f64::consts::{PI, TAU};

use assur_diagram::enveloping;
use assur_figure::mechanism::{Arc, brakes};
use assur_figure::{Bounds, Item, Point};
use assur_force::{LoadState, Loads};
use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Contact, GROUND, Load, LoadId, Place, Range};

/// Number of steps of the cycle that make a path smooth.
const STEPS: usize = 240;
/// Of so many of these positions one serves to find the bounds of guides that move.
const COARSE: usize = 8;
/// Part of its length by which an arc and its line go beyond the places that touch, at each end; at least this angle, rad.
const BEYOND: f64 = 0.15;
const LEAST_ARC: f64 = 0.02;

/// The whole cycle of a linkage for drawings.
#[derive(Debug)]
pub struct Outline {
    /// Closely spaced positions over the whole cycle; `None` where there is no assembly.
    pub fine: Vec<Option<Position>>,
    /// Paths of the points over the whole cycle, m; empty for points of the ground.
    pub paths: Vec<Vec<[f64; 2]>>,
    /// Least and greatest displacement of each slide, m.
    pub strokes: Vec<[f64; 2]>,
    /// The arcs in contact with a line of the ground.
    pub arcs: Vec<Arc>,
    /// Bounds of the drawing over the whole cycle.
    pub bounds: Bounds,
}

impl Outline {
    /// Calculates it; `others`: further positions to be within the bounds, in which links without a place have none.
    pub fn of<'a>(linkage: &Linkage, others: impl Iterator<Item = &'a Position>) -> Self {
        let fine = fine(linkage);
        let paths = paths(linkage, &fine);
        let strokes = strokes(linkage, &fine);
        let arcs = arcs(linkage);
        let mut bounds = bounds(linkage, &fine, &paths, &strokes);
        arcs.iter().flat_map(|arc| arc.line).for_each(|at| bounds.add(at));
        brakes(&linkage.mechanism).iter().flat_map(Item::points).for_each(|at| bounds.add(at));
        for position in others {
            let places = linkage.mechanism.points.iter().flat_map(|point| &point.places);
            let at = places.map(|place| position.bodies[place.link].point(place.at));
            at.filter(|at| at[0].is_finite()).for_each(|at| bounds.add(at));
        }
        Self { fine, paths, strokes, arcs, bounds }
    }
}

fn fine(linkage: &Linkage) -> Vec<Option<Position>> {
    let input = &linkage.mechanism.input;
    let (from, to) = match input.range {
        Range::Cycle(cycle) => (input.from, input.from + input.direction.sign() * cycle),
        Range::To(to) => (input.from, to),
    };
    let solved = |step| {
        let mut position = linkage.position();
        let coordinate = from + (to - from) * step as f64 / STEPS as f64;
        linkage.solve(coordinate, Order::Place, &mut position).is_ok().then_some(position)
    };
    (0..=STEPS).map(solved).collect()
}

fn paths(linkage: &Linkage, fine: &[Option<Position>]) -> Vec<Vec<[f64; 2]>> {
    let points = &linkage.mechanism.points;
    let path = |id: usize| {
        if points[id].places.iter().any(|place| place.link == GROUND) {
            return Vec::new();
        }
        let at = |p: &Option<Position>| p.as_ref().map_or([f64::NAN; 2], |p| linkage.point_motion(id, p).pf0);
        fine.iter().map(at).collect()
    };
    (0..points.len()).map(path).collect()
}

fn strokes(linkage: &Linkage, fine: &[Option<Position>]) -> Vec<[f64; 2]> {
    let stroke = |id: usize| {
        let displacements = fine.iter().flatten().map(|position| linkage.slide_motion(id, position).pf0);
        displacements.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], s| [l.min(s), h.max(s)])
    };
    (0..linkage.mechanism.slides.len()).map(stroke).collect()
}

/// The arcs of the contacts, as far as they touch their line, and beyond by a part; the line is the one from which the lowest point
/// of the arc deviates least.
fn arcs(linkage: &Linkage) -> Vec<Arc> {
    let loads = Loads::compile(linkage).ok();
    let all = linkage.mechanism.loads.iter().enumerate();
    all.filter_map(|(id, load)| arc(linkage, loads.as_ref(), id, load)).collect()
}

fn arc(linkage: &Linkage, loads: Option<&Loads>, id: LoadId, load: &Load) -> Option<Arc> {
    let contact = load.kind.contact()?;
    let Contact { center: Place { link, at }, radius, .. } = *contact;
    let found = enveloping(linkage, &load.name, contact, STEPS).ok()?;
    let mut position = linkage.position();
    let mut first = None;
    // Direction from the center in the frame of the link, and place along the line, of the lowest point and of K beside it.
    let mut reach = Bounds::EMPTY;
    for point in &found.path {
        linkage.solve(point.coordinate, Order::Place, &mut position).ok()?;
        let body = &position.bodies[link];
        let state = LoadState::prescribed(&linkage.mechanism, point.coordinate);
        let angle = loads.and_then(|loads| loads.contact(id, &state)).map_or(0.0, |[angle, _]| angle);
        for angle in [0.0, angle] {
            let (s, c) = angle.sin_cos();
            let toward = (s * body.s - c * body.c).atan2(-s * body.c - c * body.s);
            let first = *first.get_or_insert(toward);
            let turned = (toward - first + PI).rem_euclid(TAU) - PI;
            reach.add([first + turned, body.point(at)[0] - radius * s]);
        }
    }
    let size = reach.size();
    let beyond = [0, 1].map(|axis| (BEYOND * size[axis]).max([LEAST_ARC, LEAST_ARC * radius][axis]));
    let ends = |axis: usize| [reach.low[axis] - beyond[axis], reach.high[axis] + beyond[axis]];
    Some(Arc { link, center: at, radius, ends: ends(0), line: ends(1).map(|x| [x, found.level]) })
}

fn bounds(
    linkage: &Linkage,
    fine: &[Option<Position>],
    paths: &[Vec<Point>],
    strokes: &[[f64; 2]],
) -> Bounds {
    let mut bounds = Bounds::EMPTY;
    for point in &linkage.mechanism.points {
        point.places.iter().filter(|place| place.link == GROUND).for_each(|place| bounds.add(place.at));
    }
    paths.iter().flatten().for_each(|at| bounds.add(*at));
    for (slide, &[low, high]) in linkage.mechanism.slides.iter().zip(strokes) {
        for position in fine.iter().flatten().step_by(COARSE) {
            let body = &position.bodies[slide.on];
            let (s, c) = slide.angle.sin_cos();
            let (through, along) = (body.point(slide.through), body.turned([c, s]));
            for d in [low, high] {
                bounds.add([through[0] + d * along[0], through[1] + d * along[1]]);
            }
        }
    }
    bounds
}
