//! A point that is moved over the drawing, to see which curve a point of a link describes.

use assur_figure::Bounds;
use assur_geometry::Curvature;
use assur_kinematics::Position;
use assur_mechanism::{GROUND, LinkId, Place};

use crate::Results;

/// A point of a link that the scene does not name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Probe {
    /// The link.
    pub link: LinkId,
    /// Its place in the frame of the link, m.
    pub at: [f64; 2],
}

/// The path of a probe, and where on it the probe is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathFigures {
    /// Its place in the plane, m.
    pub place: [f64; 2],
    /// Width and height of the path, m.
    pub size: [f64; 2],
    /// Length of the path, as that of the polygon that is drawn, m.
    pub length: f64,
    /// Radius of curvature of the path there, m; `None` where it is infinite.
    pub radius: Option<f64>,
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
            let is_pin = |point| [link, GROUND].iter().all(|on| mechanism.place_in(point, *on).is_some());
            let pinned = (0..mechanism.points.len()).any(is_pin);
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

    /// What it describes, in a position of the mechanism.
    pub fn measured(&self, results: &Results, pose: &Position) -> PathFigures {
        let motion = results.linkage.place_motion(Place { link: self.link, at: self.at }, pose);
        let path = self.path(results);
        let pieces = path.windows(2).map(|two| (two[1][0] - two[0][0]).hypot(two[1][1] - two[0][1]));
        let curvature = Curvature::of(&motion, motion.pf1[0].hypot(motion.pf1[1]));
        let curvature = curvature.map(|found| found.curvature.abs()).filter(|curvature| *curvature > 0.0);
        PathFigures {
            place: motion.pf0,
            size: Bounds::around(path.iter().copied()).size(),
            length: pieces.filter(|piece| piece.is_finite()).sum(),
            radius: curvature.map(f64::recip),
        }
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
