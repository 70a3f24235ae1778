//! Points, poses and directions of a working.

use std::f64::consts::{PI, TAU};

use crate::sheet::symbol_of;
use crate::{Expr, Sheet};

/// A point and its transfer functions.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Its name in the symbols.
    pub name: String,
    /// PF0, PF1, PF2, each with its x and y component.
    pub pf: [[Expr; 2]; 3],
}

impl Point {
    /// Vector from another point to this one, of the given order (0: m).
    pub fn from(&self, other: &Self, order: usize) -> [Expr; 2] {
        [0, 1].map(|i| &self.pf[order][i] - &other.pf[order][i])
    }
}

/// A placed link: a point of it, and its angle with derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct Pose {
    /// A point of the link whose position is known.
    pub base: Point,
    /// That point in the frame of the link, m.
    pub at: [f64; 2],
    /// Angle of the link's x axis (rad) and its derivatives.
    pub phi: [Expr; 3],
}

/// The distance between two points of a link, and its direction in the frame of the link.
#[derive(Debug, Clone, PartialEq)]
pub struct Rod {
    /// Length, m.
    pub length: Expr,
    /// Angle from the link's x axis, rad.
    pub beta: Expr,
}

/// Direction of a guide.
#[derive(Debug, Clone, PartialEq)]
pub struct Guide {
    /// Its angle, rad.
    pub alpha: Expr,
    /// Its unit vector.
    pub t: [Expr; 2],
}

const AXES: [&str; 2] = ["x", "y"];
const PRIMES: [&str; 3] = ["", "'", "''"];

/// Whether two places have identical coordinates in the scene, without a tolerance, because they are copies.
fn is_same(a: [f64; 2], b: [f64; 2]) -> bool {
    a[0] - b[0] == 0.0 && a[1] - b[1] == 0.0
}

impl Sheet {
    /// Angle of a body and its derivatives.
    pub fn angle(&self, body: usize) -> [Expr; 3] {
        let pose = self.poses.get(body).and_then(Option::as_ref);
        pose.map_or_else(|| [Expr::zero(), Expr::zero(), Expr::zero()], |pose| pose.phi.clone())
    }

    /// Pose of a body, if it is already set.
    pub fn pose(&self, body: usize) -> Option<&Pose> {
        self.poses[body].as_ref()
    }

    /// Sets the pose of a link; after that its points can be calculated.
    pub fn set_pose(&mut self, body: usize, pose: Pose) {
        self.poses[body] = Some(pose);
    }

    /// Name of a place of a body in the symbols; a new one is chosen if the scene has none.
    pub fn place_name(&mut self, body: usize, at: [f64; 2]) -> String {
        let same = |place: &&(usize, [f64; 2], String)| place.0 == body && is_same(place.1, at);
        if let Some((_, _, name)) = self.names.places.iter().find(same) {
            return symbol_of(name);
        }
        let name = format!("P{}", self.names.places.len());
        self.names.places.push((body, at, name.clone()));
        name
    }

    /// Sets PF0, PF1 and PF2 of a point as found by a group.
    pub fn set_point(&mut self, body: usize, at: [f64; 2], pf: [[Expr; 2]; 3]) -> Point {
        let name = self.place_name(body, at);
        let point = Point { name, pf };
        self.points.push(point.clone());
        point
    }

    /// Writes both components of a vector: `x''_B` for the name B and order 2.
    pub fn vector(&mut self, name: &str, order: usize, xy: &[Expr; 2]) -> [Expr; 2] {
        let unit = self.units.length[order];
        [0, 1].map(|i| {
            let symbol = format!("{}{}_{name}", AXES[i], PRIMES[order]);
            if order > 0 {
                self.work_unless_zero(&symbol, &xy[i], unit)
            } else {
                self.work(&symbol, &xy[i], unit)
            }
        })
    }

    /// Writes both components of a named quantity: `Rx_B`, `Ry_B` for `R` and `B`.
    pub fn components(&mut self, name: &str, of: &str, xy: &[Expr; 2], unit: &str) -> [Expr; 2] {
        [0, 1].map(|i| self.work_unless_zero(&format!("{name}{}_{of}", AXES[i]), &xy[i], unit))
    }

    /// A point of a solved body; its equations are written when it is used for the first time.
    pub fn point(&mut self, body: usize, at: [f64; 2]) -> Point {
        let name = self.place_name(body, at);
        if let Some(found) = self.points.iter().find(|point| point.name == name) {
            return found.clone();
        }
        let pf = match self.poses[body].clone() {
            None => self.fixed(&name, at),
            Some(pose) => self.carried(body, &name, at, &pose),
        };
        let point = Point { name, pf };
        self.points.push(point.clone());
        point
    }

    fn fixed(&mut self, name: &str, at: [f64; 2]) -> [[Expr; 2]; 3] {
        let place = [0, 1].map(|i| self.given(&format!("{}_{name}", AXES[i]), at[i], "m", "fixed"));
        [place, [Expr::zero(), Expr::zero()], [Expr::zero(), Expr::zero()]]
    }

    /// P = base + arm rotated by phi; P' and P'' from the rotated arm.
    fn carried(&mut self, body: usize, name: &str, at: [f64; 2], pose: &Pose) -> [[Expr; 2]; 3] {
        let base = &pose.base;
        if is_same(at, pose.at) {
            return base.pf.clone();
        }
        let turned = self.turned(body, pose, name, at);
        let pf0 = self.vector(name, 0, &turned);
        let [pf1, pf2] = [1, 2].map(|order| {
            let carried = self.under(body, base, &pf0, order);
            self.vector(name, order, &carried)
        });
        [pf0, pf1, pf2]
    }

    /// Position of a place of a body whose pose is set.
    fn turned(&mut self, body: usize, pose: &Pose, name: &str, at: [f64; 2]) -> [Expr; 2] {
        let [u, v] = self.arm(body, (&pose.base.name, pose.at), (name, at));
        let (c, s) = (pose.phi[0].cos(), pose.phi[0].sin());
        let [x, y] = &pose.base.pf[0];
        [x + (&u * &c - &v * &s), y + (&u * &s + &v * &c)]
    }

    /// PF0, PF1 and PF2 of a place as a point of a body, as expressions; `place` is its position.
    pub fn carried_by(&mut self, body: usize, at: [f64; 2], place: &[Expr; 2]) -> [[Expr; 2]; 3] {
        let Some(pose) = self.poses[body].clone() else {
            return self.point(body, at).pf;
        };
        let name = self.place_name(body, at);
        let pf0 = self.turned(body, &pose, &name, at);
        let [first, second] = [1, 2].map(|order| self.under(body, &pose.base, place, order));
        [pf0, first, second]
    }

    /// The vector between two places of a link in its frame; components that are 0 in the scene are left out.
    fn arm(&mut self, body: usize, from: (&str, [f64; 2]), to: (&str, [f64; 2])) -> [Expr; 2] {
        let link = self.body_name(body).to_owned();
        [0, 1].map(|i| {
            let length = to.1[i] - from.1[i];
            if length == 0.0 {
                return Expr::zero();
            }
            let (letter, axis) = (["u", "v"][i], AXES[i]);
            let what = format!("from {} to {}, along the {axis} axis of {link}", from.0, to.0);
            self.given(&format!("{letter}_{}_{}", from.0, to.0), length, "m", &what)
        })
    }

    /// Writes length and direction between two places of a link.
    pub fn rod(&mut self, body: usize, from: [f64; 2], to: [f64; 2]) -> Rod {
        let names = [self.place_name(body, from), self.place_name(body, to)];
        let [p, q] = &names;
        let [u, v] = [to[0] - from[0], to[1] - from[1]];
        if v == 0.0 && u > 0.0 {
            let length = self.given(&format!("l_{p}_{q}"), u, "m", &format!("length {p}-{q}"));
            return Rod { length, beta: Expr::zero() };
        }
        let [u, v] = self.arm(body, (p, from), (q, to));
        let length = (u.squared() + v.squared()).sqrt();
        let length = self.work(&format!("l_{p}_{q}"), &length, "m");
        let beta = self.work(&format!("beta_{p}_{q}"), &v.atan2(&u), "rad");
        Rod { length, beta }
    }

    /// Writes the angle of a link's x axis, reduced to (-pi, pi], in radians and in degrees.
    pub fn link_angle(&mut self, body: usize, expr: &Expr) -> Expr {
        let tag = self.tag(body);
        let value = expr.value();
        let turns = ((value - PI) / TAU).ceil();
        let expr = if turns == 0.0 || !turns.is_finite() {
            expr.clone()
        } else {
            expr - Expr::number(2.0 * turns) * Expr::pi()
        };
        let phi = self.work(&format!("phi_{tag}"), &expr, "rad");
        self.work(&format!("phi_deg_{tag}"), &(&phi * Expr::number(180.0) / Expr::pi()), "deg");
        phi
    }

    /// Writes a derivative of the angle of a link.
    pub fn link_rate(&mut self, body: usize, order: usize, expr: &Expr) -> Expr {
        let name = format!("phi{}_{}", PRIMES[order], self.tag(body));
        self.work_unless_zero(&name, expr, self.units.angle[order])
    }

    /// Writes a constant angle of the scene; zero is left out.
    pub fn fixed_angle(&mut self, name: &str, value: f64, what: &str) -> Expr {
        if value == 0.0 { Expr::zero() } else { self.given(name, value, "rad", what) }
    }

    /// Writes the direction of the guide of a pair, whose carrier has this angle.
    pub fn guide(&mut self, pair: usize, carrier: usize, angle: f64) -> Guide {
        let tag = self.pair_tag(pair);
        let known = ["alpha", "tx", "ty"].map(|name| self.find(&format!("{name}_{tag}")));
        if let [Some(alpha), Some(tx), Some(ty)] = known {
            return Guide { alpha, t: [tx, ty] };
        }
        let what = format!("angle of the guide on {}", self.body_name(carrier));
        let alpha = if self.poses[carrier].is_none() {
            self.given(&format!("alpha_{tag}"), angle, "rad", &what)
        } else {
            let gamma = self.fixed_angle(&format!("gamma_{tag}"), angle, &what);
            let phi = &self.angle(carrier)[0];
            self.work(&format!("alpha_{tag}"), &(phi + gamma), "rad")
        };
        let t = [alpha.cos(), alpha.sin()];
        let [tx, ty] = [0, 1].map(|i| self.work(&format!("t{}_{tag}", AXES[i]), &t[i], ""));
        Guide { alpha, t: [tx, ty] }
    }

    /// Writes the velocity (order 1) or acceleration (order 2) of the point of a body that momentarily coincides with
    /// a given point; `through` is a known point of the body.
    pub fn under(&mut self, body: usize, through: &Point, point: &[Expr; 2], order: usize) -> [Expr; 2] {
        let [_, first, second] = self.angle(body);
        let arm = [&point[0] - &through.pf[0][0], &point[1] - &through.pf[0][1]];
        let [x, y] = &through.pf[order];
        if order == 1 {
            return [x - &arm[1] * &first, y + &arm[0] * &first];
        }
        let square = first.squared();
        [x - &arm[1] * &second - &arm[0] * &square, y + &arm[0] * &second - &arm[1] * &square]
    }

    /// Writes the known quantities of a point at the beginning of a group.
    pub fn outline(&mut self, what: &str, point: &Point) {
        let show = |expr: &Expr| crate::figure::shortest(expr.value(), 6);
        let pair = |order: usize| format!("({}, {})", show(&point.pf[order][0]), show(&point.pf[order][1]));
        let [zero, one, two] = self.units.length;
        let name = &point.name;
        let known =
            format!("{what} {name}: PF0 {} {zero}, PF1 {} {one}, PF2 {} {two}", pair(0), pair(1), pair(2));
        self.note(known);
    }

    /// Writes the known angle of a body at the beginning of a group.
    pub fn outline_angle(&mut self, what: &str, body: usize) {
        let name = self.body_name(body);
        let known = if self.poses[body].is_none() {
            format!("{what}: {name}, at rest")
        } else {
            let [a, b, c] = self.angle(body).map(|expr| crate::figure::shortest(expr.value(), 6));
            let [zero, one, two] = self.units.angle;
            format!("{what}: {name}, angle {a} {zero}, PF1 {b} {one}, PF2 {c} {two}")
        };
        self.note(known);
    }
}
