//! The closed forms of type 3.

use assur_group::plane::{cross, direction, dot, minus, mirrored, opposite, perp, plus, scaled, times};
use assur_group::{
    Anchor, Body, BuildError, ClosedForm, Forces, GroupError, GroupFrame, Order, Pair, PairGeometry,
    PinJoint, SlideJoint,
};
use assur_number::{Real, elementary};

use crate::PATTERN;

/// Rounding of a length, in units of the last place, up to which the group can still be assembled.
const SLACK: f64 = 8.0;

/// One group RPR, with its lengths in the number type `T`.
///
/// Its health is |s| / sqrt(D² + scale²): the distance of the pins along the guide, relative to the size of the
/// mechanism or the distance of the pins, whichever is greater.
#[derive(Debug, Clone)]
pub struct Rpr<T> {
    /// The sliding link, and the link with the guide.
    pub(crate) links: [usize; 2],
    pub(crate) ends: [PinJoint<T>; 2],
    pub(crate) inner: SlideJoint<T>,
    /// The outer pins on the links.
    anchors: [Anchor<T>; 2],
    /// From the outer pin of the sliding link to its point on the guide, in the directions of the guide, m.
    reach: [T; 2],
    /// Offset of the outer pins across the guide, m.
    pub(crate) e: T,
    /// scale², m².
    scale: T,
    /// Rounding of a squared distance near e², m².
    slack: f64,
}

/// The right triangle of outer pins and guide in one position.
#[derive(Debug)]
pub struct Triangle<T> {
    pins: [[T; 2]; 2],
    /// Arms of the pins on their links.
    arms: [[T; 2]; 2],
    /// Direction of the guide.
    t: [T; 2],
    /// Reciprocal of the distance s of the pins along the guide.
    inverse: T,
    /// D² / (D² + scale²). s is a root of D² - e², so a rounding of the distance D of the pins is magnified by D/s²; for
    /// a central guide only by 1/s.
    condition: T,
    health: T,
}

impl<T: Real> Rpr<T> {
    #[inline(always)]
    fn pins(&self, bodies: &[Body<T>]) -> [[T; 2]; 2] {
        [self.ends[0].place(bodies), self.ends[1].place(bodies)]
    }

    #[cold]
    fn refusal(&self, square: T, rest: T) -> GroupError {
        if rest.least() < -self.slack {
            return GroupError::NoAssembly { gap_m: self.e.abs().to_f64() - square.least().sqrt() };
        }
        // The pins lie upon each other and on the guide, which may point anywhere; or a number is NaN.
        GroupError::Singular { health: if square.least().is_nan() { f64::NAN } else { 0.0 } }
    }
}

impl<T: Real> ClosedForm<T> for Rpr<T> {
    type Position = Triangle<T>;
    const WAYS: usize = 2;

    fn new(frame: &GroupFrame) -> Result<Self, BuildError> {
        let group = PATTERN.read(frame)?;
        let ends = [PinJoint::<T>::new(&group.outer[0])?, PinJoint::new(&group.outer[1])?];
        let inner = SlideJoint::<T>::new(&group.inner[0])?;
        let reach = times(inner.tilt, minus(inner.own, ends[0].own));
        let line = cross(inner.along, minus(inner.through, ends[1].own));
        let e = line - reach[1];
        let rounding = SLACK * T::EPSILON * frame.scale.max(e.abs().to_f64());
        Ok(Self {
            links: [group.links[0], group.links[1]],
            anchors: [0, 1].map(|i| Anchor::new(ends[i].own)),
            ends,
            inner,
            reach,
            e,
            scale: T::from_f64(frame.scale * frame.scale),
            slack: rounding * (e.abs().to_f64() + rounding),
        })
    }

    #[inline(always)]
    fn close(&self, bodies: &mut [Body<T>], way: usize) -> Result<Triangle<T>, GroupError> {
        let pins = self.pins(bodies);
        let d = minus(pins[0], pins[1]);
        let square = dot(d, d);
        let rest = square - self.e * self.e;
        if !(rest.at_least(-self.slack) && square.exceeds(self.slack)) {
            return Err(self.refusal(square, rest));
        }
        let rest = rest.clamp_negative();
        let root = rest.sqrt();
        let whole = square + self.scale;
        // One division for 1 / D² and 1 / whole.
        let per_both = T::ONE / (square * whole);
        let (per_square, per_whole) = (whole * per_both, square * per_both);
        let health = (rest * per_whole).sqrt();
        let s = if way == 0 { root } else { -root };
        // s / s²: the division does not have to wait for the root.
        let inverse = s * (T::ONE / rest);
        // t = D / (s + i e), and |s + i e|² = D².
        let t = scaled(per_square, times(d, [s, -self.e]));
        let [slider, guide] = self.links;
        let arms = [
            self.anchors[0].put(&mut bodies[slider], times(t, self.inner.tilt), pins[0]),
            self.anchors[1].put(&mut bodies[guide], times(t, mirrored(self.inner.along)), pins[1]),
        ];
        Ok(Triangle { pins, arms, t, inverse, condition: square * per_whole, health })
    }

    #[inline(always)]
    fn read(&self, bodies: &[Body<T>]) -> Triangle<T> {
        let [slider, guide] = [&bodies[self.links[0]], &bodies[self.links[1]]];
        let pins = self.pins(bodies);
        let t = guide.turned(self.inner.along);
        let arms = [self.anchors[0].arm(slider), self.anchors[1].arm(guide)];
        let s = dot(t, minus(pins[0], pins[1]));
        let square = s * s + self.e * self.e;
        let whole = square + self.scale;
        let health = s.abs() / whole.sqrt();
        Triangle { pins, arms, t, inverse: T::ONE / s, condition: square / whole, health }
    }

    #[inline(always)]
    fn health(&self, position: &Triangle<T>) -> T {
        position.health
    }

    #[inline(always)]
    fn determined(&self, position: &Triangle<T>) -> Result<(), GroupError> {
        GroupError::if_lost(position.health, position.condition)
    }

    #[inline(always)]
    fn differentiate(&self, bodies: &mut [Body<T>], position: &Triangle<T>, order: Order) -> T {
        let &Triangle { pins, arms, t, inverse, .. } = position;
        let n = perp(t);
        let outer = [self.ends[0].motion(bodies, pins[0]), self.ends[1].motion(bodies, pins[1])];
        let d1 = minus(outer[0][0], outer[1][0]);
        let w = dot(n, d1) * inverse;
        for i in 0..2 {
            self.anchors[i].put_first(&mut bodies[self.links[i]], w, arms[i], outer[i][0]);
        }
        if order < Order::Second {
            return w;
        }
        let d2 = minus(outer[0][1], outer[1][1]);
        // 2 s' w - e w² with s' = t D' + e w.
        let turning = w * (dot(t, d1).twice() + self.e * w);
        let e = (dot(n, d2) - turning) * inverse;
        for i in 0..2 {
            self.anchors[i].put_second(&mut bodies[self.links[i]], e, arms[i], outer[i][1]);
        }
        e
    }

    fn resolution(&self, _: &[Body<T>]) -> f64 {
        // s² = D² - e²; with a central guide s is the distance of the pins, and no root enlarges its rounding.
        (self.slack / (self.e * self.e + self.scale).to_f64()).sqrt()
    }

    #[inline(always)]
    fn balance(&self, bodies: &[Body<T>], position: &Triangle<T>, forces: &mut Forces<'_, T>) -> T {
        let &Triangle { arms, t, inverse, .. } = position;
        let [one, two] = [forces.loads[self.links[0]], forces.loads[self.links[1]]];
        // The moments of both links about their pins know the normal force only: its arm between the pins is s.
        let (m1, m2) = (one.about(arms[0]), two.about(arms[1]));
        let normal = (m1 + m2) * inverse;
        let force = scaled(normal, perp(t));
        self.inner.store(bodies, force, -(m1 + normal * self.reach[0]), forces.reactions);
        self.ends[0].hand_on(bodies, opposite(plus(one.force(), force)), forces);
        self.ends[1].hand_on(bodies, minus(force, two.force()), forces);
        normal
    }
}

/// Angle (rad) between the line of the outer pins and the guide.
pub(crate) fn pressure_angle(frame: &GroupFrame, bodies: &[Body<f64>], _health: f64) -> f64 {
    let pins: Vec<_> = frame
        .outer
        .iter()
        .filter_map(|pair| match pair.geometry {
            PairGeometry::Pin { at_a, .. } => Some(bodies[pair.a].point(at_a)),
            PairGeometry::Slide { .. } => None,
        })
        .collect();
    let ([a, b], [Pair { b: carrier, geometry: PairGeometry::Slide { angle, .. }, .. }]) =
        (&pins[..], &frame.inner[..])
    else {
        return 0.0;
    };
    let along = bodies[*carrier].turned(direction(*angle));
    let line = minus(*b, *a);
    elementary::atan2(cross(along, line).abs(), dot(along, line).abs())
}
