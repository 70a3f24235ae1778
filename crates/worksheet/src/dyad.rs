//! Functions that the workings of several dyads use.

use assur_group::SlideJoint;
use assur_words::Text;

use crate::{Expr, Guide, Point, Pose, Rod, Sheet, Symbol};

impl Sheet {
    /// Writes the direction of the guide of a slide, whose carrier is an outer body or the other link.
    pub fn guide_of(&mut self, slide: &SlideJoint<f64>) -> Guide {
        self.guide(slide.id, slide.body, slide.along_angle)
    }

    /// Sets the pose of a rod with one known end, and writes its angle from the vector along it.
    pub fn rod_angle(&mut self, body: usize, rod: &Rod, along: &[Expr; 2]) -> Expr {
        let [x, y] = along;
        self.link_angle(body, &(y.atan2(x) - &rod.beta))
    }

    /// Writes, under the name `n`, the part of the second derivative of the end of a vector that comes from rotation
    /// alone: -phi'^2 r.
    pub fn normal_part(&mut self, of: impl Into<Symbol>, rate: &Expr, along: &[Expr; 2]) -> [Expr; 2] {
        let square = rate.squared();
        let unit = self.units.length[2];
        let parts = [0, 1].map(|i| -(&square * &along[i]));
        self.components("n", of, &parts, unit)
    }

    /// Writes a constant length of a group; zero is left out.
    pub fn fixed_length(&mut self, symbol: impl Into<Symbol>, value: f64, what: Text) -> Expr {
        let symbol = self.local(symbol);
        if value == 0.0 { Expr::zero() } else { self.given(symbol, value, "m", what) }
    }

    /// Sets the pose of a link from one of its points and its angle with derivatives.
    pub fn place(&mut self, body: usize, base: &Point, at: [f64; 2], phi: [Expr; 3]) {
        self.set_pose(body, Pose { base: base.clone(), at, phi });
    }

    /// Writes the angle of a link that can't rotate relative to a body, with the derivatives of that body's angle;
    /// sets the pose.
    pub fn place_turned(&mut self, body: usize, base: &Point, at: [f64; 2], from: &Expr, carrier: usize) {
        let phi = self.link_angle(body, from);
        let [_, first, second] = self.angle(carrier);
        let first = self.link_rate(body, 1, &first);
        let second = self.link_rate(body, 2, &second);
        self.place(body, base, at, [phi, first, second]);
    }
}

/// Component along a direction.
pub fn along(t: &[Expr; 2], v: &[Expr; 2]) -> Expr {
    &t[0] * &v[0] + &t[1] * &v[1]
}

/// Component along the normal of a direction, which is the direction rotated by +90 degrees.
pub fn across(t: &[Expr; 2], v: &[Expr; 2]) -> Expr {
    &t[0] * &v[1] - &t[1] * &v[0]
}

/// The vector with the given components along a direction and along its normal.
pub fn compose(t: &[Expr; 2], along: &Expr, across: &Expr) -> [Expr; 2] {
    [along * &t[0] - across * &t[1], along * &t[1] + across * &t[0]]
}

/// a + b.
pub fn plus(a: &[Expr; 2], b: &[Expr; 2]) -> [Expr; 2] {
    [&a[0] + &b[0], &a[1] + &b[1]]
}

/// a - b.
pub fn minus(a: &[Expr; 2], b: &[Expr; 2]) -> [Expr; 2] {
    [&a[0] - &b[0], &a[1] - &b[1]]
}

/// -a.
pub fn opposite(a: &[Expr; 2]) -> [Expr; 2] {
    [-&a[0], -&a[1]]
}
