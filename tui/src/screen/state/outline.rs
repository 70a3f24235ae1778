//! What a drawing of a linkage needs of its whole cycle: closely spaced positions, paths, strokes, bounds.

use assur_figure::Bounds;
use assur_group::Order;
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{GROUND, Range};

/// Number of steps of the cycle that make a path smooth.
const STEPS: usize = 240;
/// Of so many of these positions one serves to find the bounds of guides that move.
const COARSE: usize = 8;

/// The whole cycle of a linkage for drawings.
#[derive(Debug)]
pub(crate) struct Outline {
    /// Closely spaced positions over the whole cycle; `None` where there is no assembly.
    pub(crate) fine: Vec<Option<Position>>,
    /// Paths of the points over the whole cycle, m; empty for points of the ground.
    pub(crate) paths: Vec<Vec<[f64; 2]>>,
    /// Least and greatest displacement of each slide, m.
    pub(crate) strokes: Vec<[f64; 2]>,
    /// Bounds of the drawing over the whole cycle.
    pub(crate) bounds: Bounds,
}

impl Outline {
    /// Calculates it; `others`: further positions to be within the bounds, in which links without a place have none.
    pub(crate) fn of<'a>(linkage: &Linkage, others: impl Iterator<Item = &'a Position>) -> Self {
        let fine = fine(linkage);
        let paths = paths(linkage, &fine);
        let strokes = strokes(linkage, &fine);
        let mut bounds = bounds(linkage, &fine, &paths, &strokes);
        for position in others {
            let places = linkage.mechanism.points.iter().flat_map(|point| &point.places);
            let at = places.map(|place| position.bodies[place.link].point(place.at));
            at.filter(|at| at[0].is_finite()).for_each(|at| bounds.add(at));
        }
        Self { fine, paths, strokes, bounds }
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

fn bounds(
    linkage: &Linkage,
    fine: &[Option<Position>],
    paths: &[Vec<[f64; 2]>],
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
