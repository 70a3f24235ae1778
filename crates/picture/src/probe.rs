//! A point that is moved over the drawing, to see which curve a point of a link describes.

use assur_kinematics::Position;
use assur_mechanism::{GROUND, LinkId};

use crate::Results;

/// A point of a link that the scene does not name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Probe {
    /// The link.
    pub link: LinkId,
    /// Its place in the frame of the link, m.
    pub at: [f64; 2],
}

impl Probe {
    /// The middle of the named points of a link.
    pub fn of(results: &Results, link: LinkId) -> Self {
        let mechanism = &results.linkage.mechanism;
        let points: Vec<[f64; 2]> =
            (0..mechanism.points.len()).filter_map(|point| mechanism.place_in(point, link)).collect();
        let count = points.len().max(1) as f64;
        let at = [0, 1].map(|axis| points.iter().map(|at| at[axis]).sum::<f64>() / count);
        Self { link, at }
    }

    /// The link whose points describe the most general curves: the first that has no point on the ground.
    pub fn first_link(results: &Results) -> LinkId {
        let mechanism = &results.linkage.mechanism;
        let fixed = |link: LinkId| {
            let pinned = mechanism.points.iter().any(|point| {
                let on = |wanted: LinkId| point.places.iter().any(|place| place.link == wanted);
                on(link) && on(GROUND)
            });
            pinned || mechanism.slides.iter().any(|slide| slide.link == link && slide.on == GROUND)
        };
        (1..mechanism.links.len()).find(|link| !fixed(*link)).unwrap_or(1)
    }

    /// Its path over the whole cycle, m; NaN where there is no assembly.
    pub fn path(&self, results: &Results) -> Vec<[f64; 2]> {
        let at = |position: &Option<Position>| {
            position.as_ref().map_or([f64::NAN; 2], |position| position.bodies[self.link].point(self.at))
        };
        results.outline.fine.iter().map(at).collect()
    }

    /// Moves it so that it is at a place of the plane (m) in a position of the mechanism.
    pub fn put(&mut self, pose: &Position, place: [f64; 2]) {
        let body = &pose.bodies[self.link];
        let origin = body.point([0.0; 2]);
        let [x, y] = [place[0] - origin[0], place[1] - origin[1]];
        let [[ax, ay], [bx, by]] = [body.turned([1.0, 0.0]), body.turned([0.0, 1.0])];
        self.at = [ax * x + ay * y, bx * x + by * y];
    }
}
