//! The closed forms of type 4.

use assur_group::plane::{cross, dot, minus, opposite, perp, plus, scaled};
use assur_group::{
    Anchor, Body, BuildError, ClosedForm, Forces, GroupError, GroupFrame, Order, PinJoint, SlideJoint,
};
use assur_number::Real;

use crate::PATTERN;

/// One group PRP, with its lengths in the number type `T`.
#[derive(Debug, Clone)]
pub struct Prp<T> {
    pub(crate) links: [usize; 2],
    pub(crate) slides: [SlideJoint<T>; 2],
    pub(crate) inner: PinJoint<T>,
    /// The inner pin in the frame of each link, m.
    pub(crate) pin: [[T; 2]; 2],
    anchors: [Anchor<T>; 2],
    /// From the point of each slide to the inner pin, along and across its guide, m.
    levers: [[T; 2]; 2],
    /// Height of the inner pin's line above the origin of each body with a guide, m.
    heights: [T; 2],
}

/// The intersection of the two lines in one position.
#[derive(Debug)]
pub struct Crossing<T> {
    c: [T; 2],
    /// Arms of the inner pin on the links.
    arms: [[T; 2]; 2],
    /// Directions of the guides, the sine of the angle between them and its reciprocal.
    t: [[T; 2]; 2],
    d: T,
    inverse: T,
}

/// The vector with given components along the normals of two directions.
#[inline(always)]
fn meet<T: Real>(t: &[[T; 2]; 2], b: [T; 2], inverse: T) -> [T; 2] {
    scaled(inverse, minus(scaled(b[0], t[1]), scaled(b[1], t[0])))
}

impl<T: Real> Prp<T> {
    /// Directions of the guides, and the sine of the angle between them.
    #[inline(always)]
    fn guides(&self, bodies: &[Body<T>]) -> ([[T; 2]; 2], T) {
        let t = [self.slides[0].guide(bodies), self.slides[1].guide(bodies)];
        (t, cross(t[0], t[1]))
    }

    /// The bodies with the guides.
    #[inline(always)]
    fn carriers<'a>(&self, bodies: &'a [Body<T>]) -> [&'a Body<T>; 2] {
        [&bodies[self.slides[0].body], &bodies[self.slides[1].body]]
    }
}

impl<T: Real> ClosedForm<T> for Prp<T> {
    type Position = Crossing<T>;
    const WAYS: usize = 1;

    fn new(frame: &GroupFrame) -> Result<Self, BuildError> {
        let group = PATTERN.read(frame)?;
        let slides = [SlideJoint::<T>::new(&group.outer[0])?, SlideJoint::new(&group.outer[1])?];
        let inner = PinJoint::<T>::new(&group.inner[0])?;
        let pin = [inner.own, inner.at];
        let heights = [0, 1].map(|i| slides[i].height() + slides[i].offset(pin[i]));
        Ok(Self {
            links: [group.links[0], group.links[1]],
            slides,
            anchors: pin.map(Anchor::new),
            inner,
            levers: [0, 1].map(|i| slides[i].lever(pin[i])),
            pin,
            heights,
        })
    }

    #[inline(always)]
    fn close(&self, bodies: &mut [Body<T>], _way: usize) -> Result<Crossing<T>, GroupError> {
        let (t, d) = self.guides(bodies);
        GroupError::if_singular(d.abs())?;
        let [one, two] = self.carriers(bodies);
        let b = [self.heights[0], self.heights[1] + dot(perp(t[1]), minus(two.origin(), one.origin()))];
        let inverse = T::ONE / d;
        let c = plus(one.origin(), meet(&t, b, inverse));
        GroupError::if_nan(c[0] + c[1])?;
        let [first, second] = &self.slides;
        let directions = [first.carried(bodies, first.turn), second.carried(bodies, second.turn)];
        let arms = [
            self.anchors[0].put(&mut bodies[self.links[0]], directions[0], c),
            self.anchors[1].put(&mut bodies[self.links[1]], directions[1], c),
        ];
        Ok(Crossing { c, arms, t, d, inverse })
    }

    #[inline(always)]
    fn read(&self, bodies: &[Body<T>]) -> Crossing<T> {
        let (t, d) = self.guides(bodies);
        let [one, two] = [&bodies[self.links[0]], &bodies[self.links[1]]];
        let arms = [self.anchors[0].arm(one), self.anchors[1].arm(two)];
        Crossing { c: plus(one.origin(), arms[0]), arms, t, d, inverse: T::ONE / d }
    }

    #[inline(always)]
    fn health(&self, position: &Crossing<T>) -> T {
        position.d.abs()
    }

    #[inline(always)]
    fn differentiate(&self, bodies: &mut [Body<T>], position: &Crossing<T>, order: Order) -> T {
        let Crossing { c, arms, t, inverse, .. } = position;
        let n = [perp(t[0]), perp(t[1])];
        let [one, two] = self.carriers(bodies);
        // The points of the bodies with the guides under C.
        let under = [self.slides[0].under(bodies, *c), self.slides[1].under(bodies, *c)];
        let (turning1, turning2) = ([one.w1, two.w1], [one.w2, two.w2]);
        let c1 = meet(t, [dot(n[0], under[0][0]), dot(n[1], under[1][0])], *inverse);
        for i in 0..2 {
            self.anchors[i].put_first(&mut bodies[self.links[i]], turning1[i], arms[i], c1);
        }
        if order < Order::Second {
            return c1[0] + c1[1];
        }
        let mut b = [T::ZERO; 2];
        for i in 0..2 {
            let [first, second] = under[i];
            b[i] = dot(n[i], second) + (turning1[i] * dot(t[i], minus(c1, first))).twice();
        }
        let c2 = meet(t, b, *inverse);
        for i in 0..2 {
            self.anchors[i].put_second(&mut bodies[self.links[i]], turning2[i], arms[i], c2);
        }
        c2[0] + c2[1]
    }

    #[inline(always)]
    fn balance(&self, bodies: &[Body<T>], position: &Crossing<T>, forces: &mut Forces<'_, T>) -> T {
        let &Crossing { t, inverse, .. } = position;
        let n = [perp(t[0]), perp(t[1])];
        let given = [forces.loads[self.links[0]], forces.loads[self.links[1]]];
        // Along its guide each link passes its load to the inner pin.
        let (one, two) = (dot(t[0], given[0].force()), dot(t[1], given[1].force()));
        let force = scaled(inverse, plus(scaled(two, n[0]), scaled(one, n[1])));
        self.inner.store(force, forces.reactions);
        for (i, at_pin) in [(0, force), (1, opposite(force))] {
            let (load, [ahead, left]) = (given[i], self.levers[i]);
            // The component of the pin's force along the guide balances the load of the link, however large the
            // reaction is.
            let (along, across) = (-dot(t[i], load.force()), dot(n[i], at_pin));
            let normal = -(dot(n[i], load.force()) + across);
            let on_line = bodies[self.links[i]].arm(self.slides[i].own);
            let moment = left * along - ahead * across - load.about(on_line);
            self.slides[i].hand_on(bodies, scaled(normal, n[i]), moment, forces);
        }
        force[0] + force[1]
    }
}
