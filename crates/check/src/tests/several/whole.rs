//! A mechanism as one system of equations of the poses of all links, solved by Newton's method, and everything else by differences of
//! its places: nothing of the program but the scene as it was read.

use std::f64::consts::TAU;

use assur_mechanism::{
    Direction, Driver, Force, GROUND, InputPair, LinkId, LoadKind, Mechanism, Moment, Place, Spring, Value,
};
use nalgebra::{DMatrix, DVector, Dyn, LU};

/// The coordinate of a drive at a time.
pub(super) type Law = Box<dyn Fn(f64) -> f64>;

/// A mechanism whose drives follow these laws.
pub(super) struct Whole<'a> {
    pub(super) mechanism: &'a Mechanism,
    pub(super) laws: &'a [Law],
}

/// The poses of all moving links: origin and angle of each.
pub(super) type Poses = DVector<f64>;

/// Derivatives of numbers that depend on the poses.
struct Derivatives {
    first: DVector<f64>,
    second: DVector<f64>,
}

/// What is found by differences at an instant.
pub(super) struct Found {
    /// Velocities and accelerations of the poses.
    pub(super) motion: [Poses; 2],
    /// Derivatives of the poses by the coordinate of each drive.
    pub(super) by_drive: Vec<Poses>,
    /// The load of each drive, by virtual power.
    pub(super) loads: Vec<f64>,
    /// The sizes of the parts of it.
    pub(super) sizes: Vec<f64>,
}

/// The point of a system at which its neighbors are found with the same Jacobian.
pub(super) struct Center {
    poses: Poses,
    coordinates: Vec<f64>,
    jacobian: LU<f64, Dyn, Dyn>,
}

fn constant(value: &Value) -> f64 {
    if let Value::Constant(size) = value { *size } else { f64::NAN }
}

fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

impl Whole<'_> {
    fn pose(poses: &Poses, link: LinkId) -> [f64; 3] {
        if link == GROUND { [0.0; 3] } else { std::array::from_fn(|k| poses[3 * (link - 1) + k]) }
    }

    fn place(poses: &Poses, place: Place) -> [f64; 2] {
        let [x, y, angle] = Self::pose(poses, place.link);
        let ((s, c), [u, v]) = (angle.sin_cos(), place.at);
        [x + c * u - s * v, y + s * u + c * v]
    }

    /// Displacement along a guide, distance from it, and how far the link is turned from it.
    fn slide(&self, poses: &Poses, slide: usize) -> [f64; 3] {
        let slide = &self.mechanism.slides[slide];
        let [x, y] = Self::place(poses, Place { link: slide.link, at: slide.point });
        let [u, v] = Self::place(poses, Place { link: slide.on, at: slide.through });
        let guide = Self::pose(poses, slide.on)[2] + slide.angle;
        let (s, c) = guide.sin_cos();
        let turned = Self::pose(poses, slide.link)[2] - guide - slide.tilt;
        [c * (x - u) + s * (y - v), c * (y - v) - s * (x - u), wrapped(turned)]
    }

    fn off(&self, driver: &Driver, poses: &Poses, coordinate: f64) -> f64 {
        match driver.pair {
            InputPair::Pin(_) => {
                wrapped(Self::pose(poses, driver.link)[2] - Self::pose(poses, driver.on)[2] - coordinate)
            }
            InputPair::Slide(slide) => self.slide(poses, slide)[0] - coordinate,
        }
    }

    /// By how much pins, slides and drives miss.
    fn gaps(&self, poses: &Poses, coordinates: &[f64]) -> DVector<f64> {
        let mut gaps = Vec::with_capacity(poses.len());
        for point in &self.mechanism.points {
            let first = Self::place(poses, point.places[0]);
            for place in &point.places[1..] {
                let [x, y] = Self::place(poses, *place);
                gaps.extend([x - first[0], y - first[1]]);
            }
        }
        gaps.extend(
            (0..self.mechanism.slides.len()).flat_map(|slide| self.slide(poses, slide)[1..].to_vec()),
        );
        let drivers = self.mechanism.input.drivers.iter().zip(coordinates);
        gaps.extend(drivers.map(|(driver, coordinate)| self.off(driver, poses, *coordinate)));
        gaps.into()
    }

    fn jacobian(&self, poses: &Poses, coordinates: &[f64]) -> LU<f64, Dyn, Dyn> {
        let column = |k: usize| {
            let near = |step: f64| {
                let mut near = poses.clone();
                near[k] += step;
                self.gaps(&near, coordinates)
            };
            (near(1e-6) - near(-1e-6)) / 2e-6
        };
        let columns: Vec<_> = (0..poses.len()).map(column).collect();
        DMatrix::from_columns(&columns).lu()
    }

    /// The poses at a time, from some that are near.
    pub(super) fn solve(&self, time: f64, mut poses: Poses) -> Option<Center> {
        let coordinates: Vec<f64> = self.laws.iter().map(|law| law(time)).collect();
        for _ in 0..20 {
            let jacobian = self.jacobian(&poses, &coordinates);
            let step = jacobian.solve(&self.gaps(&poses, &coordinates))?;
            poses -= &step;
            if step.norm() < 1e-13 * (1.0 + poses.norm()) {
                return Some(Center { jacobian: self.jacobian(&poses, &coordinates), poses, coordinates });
            }
        }
        None
    }

    /// The poses at coordinates near those of a center; `None` where the Jacobian of the center is too far from theirs.
    fn near(&self, center: &Center, coordinates: &[f64]) -> Option<Poses> {
        let mut poses = center.poses.clone();
        for _ in 0..40 {
            let step = center.jacobian.solve(&self.gaps(&poses, coordinates))?;
            poses -= &step;
            if step.norm() < 1e-15 * (1.0 + poses.norm()) {
                return Some(poses);
            }
        }
        (self.gaps(&poses, coordinates).norm() < 1e-14 * (1.0 + poses.norm())).then_some(poses)
    }

    /// What the loads ask for: of each moving link origin, angle and center of mass, of each force its point, of each spring its length.
    fn numbers(&self, poses: &Poses) -> DVector<f64> {
        let mut numbers: Vec<f64> = poses.iter().copied().collect();
        for (link, found) in self.mechanism.links.iter().enumerate().skip(1) {
            numbers.extend(Self::place(poses, Place { link, at: found.center }));
        }
        for load in &self.mechanism.loads {
            match &load.kind {
                LoadKind::Force(Force { at, .. }) => numbers.extend(Self::place(poses, *at)),
                LoadKind::Spring(Spring { ends, .. }) => {
                    let [[x, y], [u, v]] = ends.each_ref().map(|end| Self::place(poses, *end));
                    numbers.push((x - u).hypot(y - v));
                }
                _ => {}
            }
        }
        numbers.into()
    }

    /// Derivatives along a line of coordinates by differences of the fourth order; `at`: the coordinates after so many steps.
    fn along(&self, center: &Center, step: f64, at: impl Fn(f64) -> Vec<f64>) -> Option<Derivatives> {
        let near = |k: f64| Some(self.numbers(&self.near(center, &at(k * step))?));
        let (one, other, here) = (near(1.0)?, near(-1.0)?, self.numbers(&center.poses));
        let (far, back) = (near(2.0)?, near(-2.0)?);
        let first = (8.0 * (&one - &other) - (&far - &back)) / (12.0 * step);
        let second = (16.0 * (one + other) - (far + back) - 30.0 * here) / (12.0 * step * step);
        Some(Derivatives { first, second })
    }

    /// Everything at an instant with differences of these steps: a part of the time, and of each unit of a coordinate.
    pub(super) fn find(
        &self,
        time: f64,
        center: &Center,
        [step, part]: [f64; 2],
        size: f64,
    ) -> Option<Found> {
        let count = center.poses.len();
        let of_poses = |numbers: &DVector<f64>| numbers.rows(0, count).into_owned();
        let motion = self.along(center, step, |way| self.laws.iter().map(|law| law(time + way)).collect())?;
        let mut found = Found {
            motion: [of_poses(&motion.first), of_poses(&motion.second)],
            by_drive: Vec::new(),
            loads: Vec::new(),
            sizes: Vec::new(),
        };
        for (index, driver) in self.mechanism.input.drivers.iter().enumerate() {
            let unit = if driver.is_angle() { 1.0 } else { size };
            let moved = |way: f64| {
                let mut coordinates = center.coordinates.clone();
                coordinates[index] += way;
                coordinates
            };
            let virtual_motion = self.along(center, part * unit, moved)?.first;
            let powers = self.powers(&center.poses, &motion, &virtual_motion);
            found.loads.push(-powers.iter().sum::<f64>());
            found.sizes.push(powers.iter().map(|power| power.abs()).sum());
            found.by_drive.push(of_poses(&virtual_motion));
        }
        Some(found)
    }

    /// What inertia and loads do in a virtual motion.
    fn powers(&self, poses: &Poses, motion: &Derivatives, virtually: &DVector<f64>) -> Vec<f64> {
        let Derivatives { first, second } = motion;
        let mut powers = Vec::new();
        let links = self.mechanism.links.len() - 1;
        let [gx, gy] = self.mechanism.gravity.unwrap_or_default();
        for (id, link) in self.mechanism.links.iter().skip(1).enumerate() {
            let (turn, center) = (3 * id + 2, 3 * links + 2 * id);
            powers.extend([
                -link.inertia.constant() * second[turn] * virtually[turn],
                link.mass * (gx - second[center]) * virtually[center],
                link.mass * (gy - second[center + 1]) * virtually[center + 1],
            ]);
        }
        let numbers = self.numbers(poses);
        let mut at = 5 * links;
        for load in &self.mechanism.loads {
            match &load.kind {
                LoadKind::Force(Force { at: place, direction, value }) => {
                    let [x, y] = match direction {
                        Direction::Ground(angle) => [angle.cos(), angle.sin()],
                        Direction::Link(angle) => {
                            let (s, c) = (angle + Self::pose(poses, place.link)[2]).sin_cos();
                            [c, s]
                        }
                        Direction::AgainstMotion => {
                            // A point that is at rest has no direction but that of rounding.
                            let speed = first[at].hypot(first[at + 1]).max(1e-9);
                            [-first[at] / speed, -first[at + 1] / speed]
                        }
                    };
                    powers.push(constant(value) * (x * virtually[at] + y * virtually[at + 1]));
                    at += 2;
                }
                LoadKind::Moment(Moment { link, value, .. }) => {
                    powers.push(constant(value) * virtually[3 * (link - 1) + 2]);
                }
                LoadKind::Spring(Spring { stiffness, length, damping, .. }) => {
                    let force = stiffness * (numbers[at] - length) + damping * first[at];
                    powers.push(-force * virtually[at]);
                    at += 1;
                }
                _ => powers.push(f64::NAN),
            }
        }
        powers
    }
}

impl Center {
    pub(super) fn poses(&self) -> &Poses {
        &self.poses
    }
}
