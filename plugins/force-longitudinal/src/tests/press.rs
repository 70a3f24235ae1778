//! The press of L with the equations as printed: a central slider-crank whose rod carries an arc that rolls and slides along a
//! straight line.
//!
//! O is above, the slider B below it, the center N of the arc on the line BA beyond A. f1 is the angle of the crank from the
//! downward axis, towards x; forces count y upward.

/// Lengths and load, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Press {
    /// r1 = |OA|, m.
    pub(super) crank: f64,
    /// b = |AB|, m.
    pub(super) rod: f64,
    /// r2 = |AN|, m: from the crank pin to the center of the arc.
    pub(super) center: f64,
    /// R, radius of the arc, m.
    pub(super) radius: f64,
    /// Fc, normal force of the contact, N.
    pub(super) force: f64,
    /// f, coefficient of sliding friction.
    pub(super) friction: f64,
}

/// What the equations give in one position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Answer {
    /// X2, Y2, m: distances of K from the pole (eqs. 8, 9).
    pub(super) x2: f64,
    pub(super) y2: f64,
    /// AP, m.
    pub(super) ap: f64,
    /// Mc, N m: moment of the force about the pole, clockwise (eq. 7).
    pub(super) mc: f64,
    /// Mb, N m: balancing moment on the crank, clockwise (eq. 6).
    pub(super) balancing: f64,
    /// Fb, N: balancing force at A (eq. 5), to the left of the crank seen from O.
    pub(super) balancing_force: f64,
    /// R1, N: longitudinal reaction of the crank, from O to A on the rod (eq. 10).
    pub(super) r1: f64,
    /// R3, N: longitudinal reaction of the slider, towards -x on the rod (eq. 11).
    pub(super) r3: f64,
    /// RO = RA, N (eq. 12).
    pub(super) ra: f64,
}

impl Press {
    /// All equations at the crank angle `f1`, with the contact at half of `alpha`; rad.
    ///
    /// Where cos f1 = 0 the pole is at infinity and numbers are infinite or NaN: the print has no other answer there.
    pub(super) fn at(&self, f1: f64, alpha: f64) -> Answer {
        let (sin, cos) = f1.sin_cos();
        let (sa, ca) = (0.5 * alpha).sin_cos();
        let (fc, f) = (self.force, self.friction);
        let fy = fc * (ca - f * sa); // eq. (2)
        let fx = fc * (sa + f * ca); // eq. (2)
        let lean = self.crank * sin / self.rod; // sine of the rod's angle from y
        let up = (1.0 - lean * lean).sqrt(); // cos arcsin of it
        let y2 = self.center * up - self.radius * ca + self.rod * up; // eq. (8)
        let yp = self.crank * cos + self.rod * up;
        let x2 = yp * (sin / cos) - self.crank * sin - self.center * lean + self.radius * sa; // eq. (9)
        let mc = fy * x2 + fx * y2; // eq. (7)
        let ap = yp / cos - self.crank;
        let mb = mc * self.crank / ap; // eq. (6)
        let fb = mb / self.crank; // eq. (5)
        let r1 = (fy - fb * sin) / cos; // eq. (10), which is (3) and so (1) solved for R1
        let r3 = fx - fb * cos + r1 * sin; // eq. (11), which is (4) solved for R3
        let ra = fb.hypot(r1); // eq. (12); RB = R3
        Answer { x2, y2, ap, mc, balancing: mb, balancing_force: fb, r1, r3, ra }
    }
}
