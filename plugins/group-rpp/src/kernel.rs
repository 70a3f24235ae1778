//! The closed forms of type 5.

use assur_group::plane::{cross, dot, minus, opposite, perp, plus, scaled, times};
use assur_group::{
    Anchor, Body, BuildError, ClosedForm, Forces, GroupError, GroupFrame, Order, PinJoint, SlideJoint,
};
use assur_number::Real;

use crate::PATTERN;

/// One group RPP, with its lengths in the number type `T`.
#[derive(Debug, Clone)]
pub struct Rpp<T> {
    /// The link with the pin, and the link between the guides.
    pub(crate) links: [usize; 2],
    pub(crate) end: PinJoint<T>,
    pub(crate) inner: SlideJoint<T>,
    pub(crate) outer: SlideJoint<T>,
    /// The pin on link 1, and the point of the outer slide on link 2.
    anchors: [Anchor<T>; 2],
    /// Direction of the inner guide in the frame of the outer body with the guide.
    inner_along: [T; 2],
    /// Rotation of link 1 relative to that body.
    turn: [T; 2],
    /// Distance of the point of link 2 from the outer pin across the inner guide, m.
    pub(crate) across: T,
    /// Distance of the point of the inner slide from the outer pin along the inner guide, m.
    reach: T,
    /// Height of the outer guide above the origin of its carrier, m.
    height: T,
    /// Sine of the angle from the inner to the outer guide, which is constant.
    d: T,
    inverse: T,
    /// Cosine of the angle from the inner to the outer guide.
    cosine: T,
}

/// The quantities of one position that the formulas share.
#[derive(Debug)]
pub struct Lines<T> {
    /// A, and P of link 2.
    points: [[T; 2]; 2],
    /// Their arms on their links.
    arms: [[T; 2]; 2],
    /// Directions of the inner and the outer guide.
    t: [[T; 2]; 2],
}

impl<T: Real> Rpp<T> {
    #[inline(always)]
    fn guides(&self, bodies: &[Body<T>]) -> [[T; 2]; 2] {
        [self.outer.carried(bodies, self.inner_along), self.outer.guide(bodies)]
    }
}

impl<T: Real> ClosedForm<T> for Rpp<T> {
    type Position = Lines<T>;
    const WAYS: usize = 1;

    fn new(frame: &GroupFrame) -> Result<Self, BuildError> {
        let group = PATTERN.read(frame)?;
        let end = PinJoint::<T>::new(&group.outer[0])?;
        let inner = SlideJoint::<T>::new(&group.inner[0])?;
        let outer = SlideJoint::<T>::new(&group.outer[1])?;
        let inner_along = times(outer.turn, inner.along);
        // Link 2 alone holds the angle between the guides, and the sum of two angles keeps its digits: the directions of
        // the guides would leave those that are nearly parallel a difference of products of order 1.
        let between = T::from_f64(outer.tilt_angle) + T::from_f64(inner.along_angle);
        let (sine, cosine) = between.sin_cos();
        let d = -sine;
        Ok(Self {
            links: [group.links[0], group.links[1]],
            anchors: [end.own, outer.own].map(Anchor::new),
            end,
            inner,
            outer,
            inner_along,
            turn: times(outer.turn, inner.turn),
            across: -(cross(inner.along, minus(inner.through, outer.own)) + inner.offset(end.own)),
            reach: -inner.lever(end.own)[0],
            height: outer.height(),
            d,
            inverse: T::ONE / d,
            cosine,
        })
    }

    #[inline(always)]
    fn close(&self, bodies: &mut [Body<T>], _way: usize) -> Result<Lines<T>, GroupError> {
        GroupError::if_singular(self.d.abs())?;
        let carrier = &bodies[self.outer.body];
        let t = self.guides(bodies);
        let a = self.end.place(bodies);
        let b = self.height + dot(perp(t[1]), minus(carrier.origin(), a));
        // (across t2 - b t1) / D with t1 = cosine t2 - D n2: the part across the outer guide is b itself, however far P
        // lies along it.
        let along = (self.across - b * self.cosine) * self.inverse;
        let p = plus(a, plus(scaled(along, t[1]), scaled(b, perp(t[1]))));
        GroupError::if_nan(p[0] + p[1])?;
        let directions = [self.outer.carried(bodies, self.turn), self.outer.carried(bodies, self.outer.turn)];
        let [one, two] = self.links;
        let arms = [
            self.anchors[0].put(&mut bodies[one], directions[0], a),
            self.anchors[1].put(&mut bodies[two], directions[1], p),
        ];
        Ok(Lines { points: [a, p], arms, t })
    }

    #[inline(always)]
    fn read(&self, bodies: &[Body<T>]) -> Lines<T> {
        let [one, two] = [&bodies[self.links[0]], &bodies[self.links[1]]];
        let arms = [self.anchors[0].arm(one), self.anchors[1].arm(two)];
        let points = [plus(one.origin(), arms[0]), plus(two.origin(), arms[1])];
        Lines { points, arms, t: self.guides(bodies) }
    }

    #[inline(always)]
    fn health(&self, _position: &Lines<T>) -> T {
        self.d.abs()
    }

    #[inline(always)]
    fn differentiate(&self, bodies: &mut [Body<T>], position: &Lines<T>, order: Order) -> T {
        let Lines { points, arms, t } = position;
        let carrier = &bodies[self.outer.body];
        let (turning1, turning2) = (carrier.w1, carrier.w2);
        let [a1, a2] = self.end.motion(bodies, points[0]);
        // The points of the carrier under A and P.
        let [under_a, under_p] = [self.outer.under(bodies, points[0]), self.outer.under(bodies, points[1])];
        // Seen from the carrier, A moves with `v`, and P along the outer guide such that both keep their distance
        // across the inner guide.
        let n = scaled(self.inverse, perp(t[0]));
        let v = minus(a1, under_a[0]);
        let relative = scaled(dot(n, v), t[1]);
        let p1 = plus(under_p[0], relative);
        let [one, two] = self.links;
        self.anchors[0].put_first(&mut bodies[one], turning1, arms[0], a1);
        self.anchors[1].put_first(&mut bodies[two], turning1, arms[1], p1);
        if order < Order::Second {
            return p1[0] + p1[1];
        }
        let coriolis = turning1.twice();
        let a = minus(minus(a2, under_a[1]), scaled(coriolis, perp(v)));
        let turning = plus(under_p[1], scaled(coriolis, perp(relative)));
        let p2 = plus(turning, scaled(dot(n, a), t[1]));
        self.anchors[0].put_second(&mut bodies[one], turning2, arms[0], a2);
        self.anchors[1].put_second(&mut bodies[two], turning2, arms[1], p2);
        p2[0] + p2[1]
    }

    #[inline(always)]
    fn balance(&self, bodies: &[Body<T>], position: &Lines<T>, forces: &mut Forces<'_, T>) -> T {
        let &Lines { points, arms, t } = position;
        let [first, second] = [forces.loads[self.links[0]], forces.loads[self.links[1]]];
        // Along the outer guide link 2 leaves its load to the inner one.
        let normal = dot(t[1], second.force()) * self.inverse;
        let inner = scaled(normal, perp(t[0]));
        // The lever of the normal force about the pin is one of the lengths: a large force leaves no rounding where it has
        // no lever.
        let moment = -(first.about(arms[0]) + normal * self.reach);
        self.inner.store(bodies, inner, moment, forces.reactions);
        self.end.hand_on(bodies, opposite(plus(first.force(), inner)), forces);
        // The same force and moment, turned round, act on link 2 at the point of link 1.
        let way = dot(t[0], minus(bodies[self.links[0]].point(self.inner.own), points[1]));
        let held = normal * way + moment - second.about(arms[1]);
        let n = perp(t[1]);
        let outer = dot(n, minus(inner, second.force()));
        self.outer.hand_on(bodies, scaled(outer, n), held, forces);
        normal + moment
    }
}
