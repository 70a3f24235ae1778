//! The pairs of a group in the number type of its kernel: their motion, and how their reactions are stored and passed
//! to the outer bodies.
//!
//! Where the other body is the ground, its motion is not calculated: it is zero.

use assur_number::Real;
use assur_words::text;

use crate::plane::{cross, direction, minus, opposite, times, vector};
use crate::{Body, BuildError, Forces, PairGeometry, SeenPair, Wrench};

/// The first of all bodies, [`Body::ground`]: it never moves.
const GROUND: usize = 0;

/// PF1 and PF2 of the point of a body that is at a place.
#[inline(always)]
pub fn motion_at<T: Real>(bodies: &[Body<T>], body: usize, place: [T; 2]) -> [[T; 2]; 2] {
    if body == GROUND {
        return [[T::ZERO; 2]; 2];
    }
    let body = &bodies[body];
    body.motion(minus(place, body.origin()))
}

/// A pin between a link of the group and another body.
#[derive(Debug, Clone, Copy)]
pub struct PinJoint<T> {
    /// Index of the pair in the chain.
    pub id: usize,
    /// The other body.
    pub body: usize,
    /// The pin in the frame of the link, m.
    pub own: [T; 2],
    /// The pin in the frame of the other body, m.
    pub at: [T; 2],
    /// Whether the scene names the other body first; the stored reaction then acts on that body.
    pub turned: bool,
}

impl<T: Real> PinJoint<T> {
    /// Reads a pair of the group as a pin.
    pub fn new(seen: &SeenPair) -> Result<Self, BuildError> {
        let SeenPair { pair, turned } = *seen;
        match pair.geometry {
            PairGeometry::Pin { at_a, at_b } => {
                let (own, at) = (vector(at_a), vector(at_b));
                Ok(Self { id: pair.id, body: pair.b, own, at, turned })
            }
            PairGeometry::Slide { .. } => Err(BuildError::new(text!("group-slide-not-pin", pair = pair.id))),
        }
    }

    /// Position of the pin as a point of the other body, m.
    #[inline(always)]
    pub fn place(&self, bodies: &[Body<T>]) -> [T; 2] {
        if self.body == GROUND { self.at } else { bodies[self.body].point(self.at) }
    }

    /// PF1 and PF2 of the pin at this position, as a point of the other body.
    #[inline(always)]
    pub fn motion(&self, bodies: &[Body<T>], place: [T; 2]) -> [[T; 2]; 2] {
        motion_at(bodies, self.body, place)
    }

    /// Stores the force (N) that acts on the link of the group.
    #[inline(always)]
    pub fn store(&self, force: [T; 2], reactions: &mut [Wrench<T>]) {
        let [fx, fy] = if self.turned { opposite(force) } else { force };
        reactions[self.id] = Wrench { fx, fy, m: T::ZERO };
    }

    /// Stores the force (N) that acts on the link of the group, and adds the opposite force to the load of the other
    /// body.
    #[inline(always)]
    pub fn hand_on(&self, bodies: &[Body<T>], force: [T; 2], forces: &mut Forces<'_, T>) {
        self.store(force, forces.reactions);
        let arm = if self.body == GROUND { self.at } else { bodies[self.body].arm(self.at) };
        forces.loads[self.body].add_at(arm, opposite(force), T::ZERO);
    }
}

/// A slide between a link of the group and another body: the point `own` stays on a line of the other body.
#[derive(Debug, Clone, Copy)]
pub struct SlideJoint<T> {
    /// Index of the pair in the chain.
    pub id: usize,
    /// The link of the group.
    pub link: usize,
    /// The other body, which carries the line.
    pub body: usize,
    /// Point of the link on the line, in the frame of the link, m.
    pub own: [T; 2],
    /// Point of the other body on the line, in its frame, m.
    pub through: [T; 2],
    /// Angle of the line in the frame of the other body, rad.
    pub along_angle: f64,
    /// Unit vector along the line, in the frame of the other body.
    pub along: [T; 2],
    /// Angle of the link's x axis relative to the line, rad.
    pub tilt_angle: f64,
    /// Unit vector at the angle `tilt_angle`.
    pub tilt: [T; 2],
    /// Rotation of the link's x axis relative to that of the other body, as a unit vector.
    pub turn: [T; 2],
    /// Whether the scene has the guide on the link of the group; the stored reaction then acts on the other body.
    pub turned: bool,
}

impl<T: Real> SlideJoint<T> {
    /// Reads a pair of the group as a slide.
    pub fn new(seen: &SeenPair) -> Result<Self, BuildError> {
        let SeenPair { pair, turned } = *seen;
        let PairGeometry::Slide { point, through, angle: along_angle, tilt: tilt_angle } = pair.geometry
        else {
            return Err(BuildError::new(text!("group-pin-not-slide", pair = pair.id)));
        };
        let (along, tilt) = (direction(along_angle), direction(tilt_angle));
        Ok(Self {
            id: pair.id,
            link: pair.a,
            body: pair.b,
            own: vector(point),
            through: vector(through),
            along_angle,
            along,
            tilt_angle,
            tilt,
            turn: times(along, tilt),
            turned,
        })
    }

    /// Unit vector along the line.
    #[inline(always)]
    pub fn guide(&self, bodies: &[Body<T>]) -> [T; 2] {
        self.carried(bodies, self.along)
    }

    /// A direction of the other body, given in its frame.
    #[inline(always)]
    pub fn carried(&self, bodies: &[Body<T>], direction: [T; 2]) -> [T; 2] {
        if self.body == GROUND { direction } else { bodies[self.body].turned(direction) }
    }

    /// PF1 and PF2 of the point of the other body that is at a place.
    #[inline(always)]
    pub fn under(&self, bodies: &[Body<T>], place: [T; 2]) -> [[T; 2]; 2] {
        motion_at(bodies, self.body, place)
    }

    /// Coordinates of a point of the link relative to `own`: along the line and to the left of it, m. The point is
    /// given in the link's frame.
    ///
    /// These lengths are constant; calculated with them, the moment of a large force about `own` keeps its accuracy.
    pub fn lever(&self, point: [T; 2]) -> [T; 2] {
        times(self.tilt, minus(point, self.own))
    }

    /// Distance to the left of the line at which a point of the link moves, m. The point is given in the link's
    /// frame.
    pub fn offset(&self, point: [T; 2]) -> T {
        self.lever(point)[1]
    }

    /// Distance of the line to the left of the origin of the other body, m.
    pub fn height(&self) -> T {
        cross(self.along, self.through)
    }

    /// Stores the force (N) and the moment (N m, about `own`) that act on the link of the group.
    #[inline(always)]
    pub fn store(&self, bodies: &[Body<T>], force: [T; 2], moment: T, reactions: &mut [Wrench<T>]) {
        let mut on_a = Wrench { fx: force[0], fy: force[1], m: moment };
        if self.turned {
            // In the scene the other body slides: the moment on it is about its own point of the line.
            let [other, link] = [&bodies[self.body], &bodies[self.link]];
            let arm = minus(link.point(self.own), other.point(self.through));
            on_a = Wrench::ZERO;
            on_a.add_at(arm, opposite(force), -moment);
        }
        reactions[self.id] = on_a;
    }

    /// Stores force and moment on the link of the group, and adds the opposite to the load of the other body.
    #[inline(always)]
    pub fn hand_on(&self, bodies: &[Body<T>], force: [T; 2], moment: T, forces: &mut Forces<'_, T>) {
        self.store(bodies, force, moment, forces.reactions);
        let [other, link] = [&bodies[self.body], &bodies[self.link]];
        let arm = minus(link.point(self.own), other.origin());
        forces.loads[self.body].add_at(arm, opposite(force), -moment);
    }
}
