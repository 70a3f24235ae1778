//! The closed forms of type 1.

use assur_group::plane::{cross, dot, minus, mirrored, opposite, perp, plus, scaled, times};
use assur_group::{Anchor, Body, BuildError, ClosedForm, Forces, GroupError, GroupFrame, Order, PinJoint};
use assur_number::Real;
use assur_words::text;

use crate::PATTERN;

/// Rounding of a squared distance, in units of the last place, up to which the group can still be assembled.
const SLACK: f64 = 8.0;

/// One group RRR, with its lengths in the number type `T`.
#[derive(Debug, Clone)]
pub struct Rrr<T> {
    pub(crate) links: [usize; 2],
    /// Outer pins of link 1 and link 2.
    pub(crate) ends: [PinJoint<T>; 2],
    pub(crate) inner: PinJoint<T>,
    /// The outer pins on the links.
    anchors: [Anchor<T>; 2],
    /// From the outer to the inner pin of each link, in its frame, m.
    rods: [[T; 2]; 2],
    /// Factor that turns this vector, rotated into the ground's frame, into the direction of the link: mirrored
    /// vector / length².
    unrods: [[T; 2]; 2],
    /// (l1 + l2)², m².
    stretched: T,
    /// (l1 - l2)², m².
    folded: T,
    /// l1² - l2², m².
    excess: T,
    /// 1 / (l1 l2), 1/m².
    inverse_product: T,
    /// Lengths, m, for the gap in an error.
    lengths: [f64; 2],
    /// Rounding of d² near `stretched` and near `folded`, m².
    slack: [f64; 2],
    /// (size of the coordinates / l1 l2)², 1/m²: times d, the effect of their rounding on the square of the
    /// determinant.
    sensitivity: T,
}

/// The triangle of the pins in one position.
#[derive(Debug)]
pub struct Triangle<T> {
    /// A and its arm on link 1; B and its arm on link 2.
    pins: [[T; 2]; 2],
    arms: [[T; 2]; 2],
    /// C - A and C - B.
    r: [[T; 2]; 2],
    /// r1 x r2, and its reciprocal.
    d: T,
    inverse: T,
}

impl<T: Real> Rrr<T> {
    #[inline(always)]
    fn pins(&self, bodies: &[Body<T>]) -> [[T; 2]; 2] {
        [self.ends[0].place(bodies), self.ends[1].place(bodies)]
    }

    /// Why there is no triangle: a gap, or a direction that is not determined.
    #[cold]
    fn refusal(&self, square: T, far: T, near: T) -> GroupError {
        let [l1, l2] = self.lengths;
        let too_far = square.greatest().sqrt() - (l1 + l2);
        let too_near = (l1 - l2).abs() - square.least().max(0.0).sqrt();
        let open = far.least() < -self.slack[0] || near.least() < -self.slack[1];
        if open {
            GroupError::NoAssembly { gap_m: too_far.max(too_near) }
        } else {
            // Coincident equal links may point in any direction; or a number is NaN.
            GroupError::Singular { health: if square.least().is_nan() { f64::NAN } else { 0.0 } }
        }
    }
}

impl<T: Real> ClosedForm<T> for Rrr<T> {
    type Position = Triangle<T>;
    const WAYS: usize = 2;

    fn new(frame: &GroupFrame) -> Result<Self, BuildError> {
        let group = PATTERN.read(frame)?;
        let ends = [PinJoint::<T>::new(&group.outer[0])?, PinJoint::new(&group.outer[1])?];
        let inner = PinJoint::<T>::new(&group.inner[0])?;
        let rods = [minus(inner.own, ends[0].own), minus(inner.at, ends[1].own)];
        let squares = rods.map(|rod| dot(rod, rod));
        let [l1, l2] = squares.map(Real::sqrt);
        let lengths = [l1.to_f64(), l2.to_f64()];
        if let Some(i) = lengths.iter().position(|&l| l.is_nan() || l <= 0.0) {
            let what = text!("group-rrr-no-link", link = i + 1);
            return Err(BuildError::new(what).of_link(group.links[i]));
        }
        let (sum, difference) = (l1 + l2, l1 - l2);
        let size = frame.scale.max(sum.to_f64());
        let rounding = SLACK * T::EPSILON * size;
        Ok(Self {
            links: [group.links[0], group.links[1]],
            anchors: [0, 1].map(|i| Anchor::new(ends[i].own)),
            ends,
            inner,
            rods,
            unrods: [0, 1].map(|i| scaled(T::ONE / squares[i], mirrored(rods[i]))),
            stretched: sum * sum,
            folded: difference * difference,
            excess: difference * sum,
            inverse_product: T::ONE / (l1 * l2),
            lengths,
            sensitivity: {
                let condition = T::from_f64(size) / (l1 * l2);
                condition * condition
            },
            slack: [rounding * sum.to_f64(), rounding * (difference.abs().to_f64() + rounding)],
        })
    }

    #[inline(always)]
    fn close(&self, bodies: &mut [Body<T>], way: usize) -> Result<Triangle<T>, GroupError> {
        let pins = self.pins(bodies);
        let d = minus(pins[1], pins[0]);
        let square = dot(d, d);
        // Two factors, each accurate near its own zero: l1² - alpha² d² would lose half the digits near both.
        let (far, near) = (self.stretched - square, square - self.folded);
        if !(far.at_least(-self.slack[0]) && near.at_least(-self.slack[1]) && square.exceeds(self.slack[1])) {
            return Err(self.refusal(square, far, near));
        }
        let product = (far * near).clamp_negative();
        let root = product.sqrt().half();
        let root = if way == 0 { root } else { -root };
        // root / root²: the division does not have to wait for the root.
        let inverse_root = root * (T::from_f64(4.0) / product);
        let inverse = T::ONE / square;
        // Both from their own formula: r1 - d would lose the digits of a short second link.
        let part = (self.excess * inverse).half();
        let (alpha, gamma) = (part + T::ONE.half(), part - T::ONE.half());
        let across = scaled(root * inverse, perp(d));
        let r = [plus(scaled(alpha, d), across), plus(scaled(gamma, d), across)];
        let mut arms = [[T::ZERO; 2]; 2];
        for i in 0..2 {
            let direction = times(r[i], self.unrods[i]);
            arms[i] = self.anchors[i].put(&mut bodies[self.links[i]], direction, pins[i]);
        }
        Ok(Triangle { pins, arms, r, d: root, inverse: inverse_root })
    }

    #[inline(always)]
    fn read(&self, bodies: &[Body<T>]) -> Triangle<T> {
        let [one, two] = [&bodies[self.links[0]], &bodies[self.links[1]]];
        let r = [one.arm(self.rods[0]), two.arm(self.rods[1])];
        let arms = [self.anchors[0].arm(one), self.anchors[1].arm(two)];
        let d = cross(r[0], r[1]);
        Triangle { pins: self.pins(bodies), arms, r, d, inverse: T::ONE / d }
    }

    #[inline(always)]
    fn health(&self, position: &Triangle<T>) -> T {
        (position.d * self.inverse_product).abs()
    }

    #[inline(always)]
    fn determined(&self, position: &Triangle<T>) -> Result<(), GroupError> {
        let apart = minus(position.r[0], position.r[1]);
        GroupError::if_lost(position.d * self.inverse_product, self.sensitivity * dot(apart, apart))
    }

    #[inline(always)]
    fn differentiate(&self, bodies: &mut [Body<T>], position: &Triangle<T>, order: Order) -> T {
        let &Triangle { pins, arms, r, inverse, .. } = position;
        let outer = [self.ends[0].motion(bodies, pins[0]), self.ends[1].motion(bodies, pins[1])];
        let v = minus(outer[1][0], outer[0][0]);
        let w = [dot(v, r[1]) * inverse, dot(v, r[0]) * inverse];
        for i in 0..2 {
            self.anchors[i].put_first(&mut bodies[self.links[i]], w[i], arms[i], outer[i][0]);
        }
        if order < Order::Second {
            return w[0] + w[1];
        }
        let centripetal = minus(scaled(w[0] * w[0], r[0]), scaled(w[1] * w[1], r[1]));
        let a = plus(minus(outer[1][1], outer[0][1]), centripetal);
        let e = [dot(a, r[1]) * inverse, dot(a, r[0]) * inverse];
        for i in 0..2 {
            self.anchors[i].put_second(&mut bodies[self.links[i]], e[i], arms[i], outer[i][1]);
        }
        e[0] + e[1]
    }

    fn resolution(&self, bodies: &[Body<T>]) -> f64 {
        let d = minus(self.ends[1].place(bodies), self.ends[0].place(bodies));
        let square = dot(d, d).to_f64();
        let (stretched, folded) = (self.stretched.to_f64(), self.folded.to_f64());
        // The determinant is sqrt(far near) / 2 l1 l2; the factor that is not small is 4 l1 l2.
        let slack = self.slack[usize::from(2.0 * square < stretched + folded)];
        (slack * self.inverse_product.to_f64()).sqrt()
    }

    #[inline(always)]
    fn balance(&self, bodies: &[Body<T>], position: &Triangle<T>, forces: &mut Forces<'_, T>) -> T {
        let &Triangle { arms, r, inverse, .. } = position;
        let [one, two] = [forces.loads[self.links[0]], forces.loads[self.links[1]]];
        // The moments about A and about B contain only the inner reaction: r1 x F = -m1, r2 x F = m2.
        let (m1, m2) = (one.about(arms[0]), two.about(arms[1]));
        let k = -inverse;
        let force = plus(scaled(m2 * k, r[0]), scaled(m1 * k, r[1]));
        self.inner.store(force, forces.reactions);
        self.ends[0].hand_on(bodies, opposite(plus(one.force(), force)), forces);
        self.ends[1].hand_on(bodies, minus(force, two.force()), forces);
        force[0] + force[1]
    }
}
