//! Points, poses and directions of a working.

use std::f64::consts::{PI, TAU};

use assur_words::{Text, exact, joined, name, text, unit};

use crate::{Expr, RESULT_DIGITS, Sheet, Symbol, figure::shortest};

/// A point and its transfer functions.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Its name in the symbols.
    pub name: Symbol,
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
    pub fn place_name(&mut self, body: usize, at: [f64; 2]) -> Symbol {
        let same = |place: &&(usize, [f64; 2], Symbol)| place.0 == body && is_same(place.1, at);
        if let Some((_, _, name)) = self.names.places.iter().find(same) {
            return name.clone();
        }
        let name = Symbol::from("P").of(self.names.places.len());
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

    /// Writes both components of a vector: `x″_B` for the name B and order 2.
    pub fn vector(&mut self, name: &Symbol, order: usize, xy: &[Expr; 2]) -> [Expr; 2] {
        let unit = self.units.length[order];
        [0, 1].map(|i| {
            let symbol = Symbol::from(AXES[i]).prime(order).of(name);
            if order > 0 {
                self.work_unless_zero(symbol, &xy[i], unit)
            } else {
                self.work(symbol, &xy[i], unit)
            }
        })
    }

    /// Writes both components of a named quantity: `R_x_B`, `R_y_B` for `R` and `B`.
    pub fn components(
        &mut self,
        letter: impl Into<Symbol>,
        of: impl Into<Symbol>,
        xy: &[Expr; 2],
        unit: &'static str,
    ) -> [Expr; 2] {
        let (letter, of) = (letter.into(), of.into());
        [0, 1].map(|i| self.work_unless_zero(letter.clone().of(AXES[i]).of(&of), &xy[i], unit))
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

    fn fixed(&mut self, name: &Symbol, at: [f64; 2]) -> [[Expr; 2]; 3] {
        let place =
            [0, 1].map(|i| self.given(Symbol::from(AXES[i]).of(name), at[i], "m", text!("worksheet-fixed")));
        [place, [Expr::zero(), Expr::zero()], [Expr::zero(), Expr::zero()]]
    }

    /// P = base + arm rotated by phi; P' and P'' from the rotated arm.
    fn carried(&mut self, body: usize, name: &Symbol, at: [f64; 2], pose: &Pose) -> [[Expr; 2]; 3] {
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
    fn turned(&mut self, body: usize, pose: &Pose, name: &Symbol, at: [f64; 2]) -> [Expr; 2] {
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
    fn arm(&mut self, body: usize, from: (&Symbol, [f64; 2]), to: (&Symbol, [f64; 2])) -> [Expr; 2] {
        let link = self.body_name(body);
        [0, 1].map(|i| {
            let length = to.1[i] - from.1[i];
            if length == 0.0 {
                return Expr::zero();
            }
            let axis = name(AXES[i]);
            let what = text!("worksheet-from-to", from = from.0, to = to.0, axis, link = &link);
            self.given(Symbol::from(["u", "v"][i]).of(from.0).of(to.0), length, "m", what)
        })
    }

    /// Writes length and direction between two places of a link.
    pub fn rod(&mut self, body: usize, from: [f64; 2], to: [f64; 2]) -> Rod {
        let names = [self.place_name(body, from), self.place_name(body, to)];
        let [p, q] = &names;
        let [u, v] = [to[0] - from[0], to[1] - from[1]];
        if v == 0.0 && u > 0.0 {
            let what = text!("worksheet-length", from = p, to = q);
            let length = self.given(Symbol::from("l").of(p).of(q), u, "m", what);
            return Rod { length, beta: Expr::zero() };
        }
        let [u, v] = self.arm(body, (p, from), (q, to));
        let length = (u.squared() + v.squared()).sqrt();
        let length = self.work(Symbol::from("l").of(p).of(q), &length, "m");
        let beta = self.work(Symbol::from("β").of(p).of(q), &v.atan2(&u), "rad");
        Rod { length, beta }
    }

    /// Writes the angle of a link's x axis, reduced to (-pi, pi], in radians and in degrees.
    pub fn link_angle(&mut self, body: usize, expr: &Expr) -> Expr {
        let symbol = Symbol::from("φ").of(self.body_name(body));
        let value = expr.value();
        let turns = ((value - PI) / TAU).ceil();
        let expr = if turns == 0.0 || !turns.is_finite() {
            expr.clone()
        } else {
            expr - Expr::number(2.0 * turns) * Expr::pi()
        };
        let phi = self.work(&symbol, &expr, "rad");
        self.work(symbol.of(unit("deg")), &(&phi * Expr::number(180.0) / Expr::pi()), "deg");
        phi
    }

    /// Writes a derivative of the angle of a link.
    pub fn link_rate(&mut self, body: usize, order: usize, expr: &Expr) -> Expr {
        let symbol = Symbol::from("φ").prime(order).of(self.body_name(body));
        self.work_unless_zero(symbol, expr, self.units.angle[order])
    }

    /// Writes a constant angle of the scene; zero is left out.
    pub fn fixed_angle(&mut self, symbol: Symbol, value: f64, what: Text) -> Expr {
        if value == 0.0 { Expr::zero() } else { self.given(symbol, value, "rad", what) }
    }

    /// Writes the direction of the guide of a pair, whose carrier has this angle.
    pub fn guide(&mut self, pair: usize, carrier: usize, angle: f64) -> Guide {
        let of_pair = |letter: &'static str, pair: &Text| Symbol::from(letter).of(pair);
        let tag = self.pair_name(pair);
        let symbol = of_pair("α", &tag);
        if let (Some(alpha), [Some(tx), Some(ty)]) = (self.find(&symbol), self.direction_of(pair)) {
            return Guide { alpha, t: [tx, ty] };
        }
        let what = text!("worksheet-guide-angle", link = self.body_name(carrier));
        let alpha = if self.poses[carrier].is_none() {
            self.given(symbol, angle, "rad", what)
        } else {
            let gamma = self.fixed_angle(of_pair("γ", &tag), angle, what);
            let phi = &self.angle(carrier)[0];
            self.work(symbol, &(phi + gamma), "rad")
        };
        let t = [alpha.cos(), alpha.sin()];
        let t = [0, 1].map(|i| self.work(Symbol::from("t").of(AXES[i]).of(&tag), &t[i], ""));
        Guide { alpha, t }
    }

    /// The direction of the guide of a pair as far as it is written.
    pub fn direction_of(&self, pair: usize) -> [Option<Expr>; 2] {
        AXES.map(|axis| self.find(Symbol::from("t").of(axis).of(self.pair_name(pair))))
    }

    /// Writes the constant angle of a sliding link from the guide of a pair; zero is left out.
    pub fn tilt(&mut self, pair: usize, link: usize, value: f64) -> Expr {
        let what = text!("worksheet-tilt", link = self.body_name(link));
        self.fixed_angle(Symbol::from("ψ").of(self.pair_name(pair)), value, what)
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

    /// Writes the known quantities of the outer pin of a group at its beginning.
    pub fn outline(&mut self, pin: &Point) {
        let shown = |order: usize| {
            let [x, y] = pin.pf[order].each_ref().map(printed);
            let vector = joined("", [name("("), x, text!("worksheet-between-arguments"), y, name(")")]);
            joined(" ", [vector, unit(self.units.length[order])])
        };
        let [pf0, pf1, pf2] = [0, 1, 2].map(shown);
        self.note(text!("worksheet-outer-pin", pin = &pin.name, pf0, pf1, pf2));
    }

    /// Writes the known angle of a body with a guide at the beginning of a group.
    pub fn outline_angle(&mut self, body: usize) {
        let link = self.body_name(body);
        if self.poses[body].is_none() {
            return self.note(text!("worksheet-carrier-at-rest", link));
        }
        let angle = self.angle(body);
        let shown = |order: usize| joined(" ", [printed(&angle[order]), unit(self.units.angle[order])]);
        let [pf0, pf1, pf2] = [0, 1, 2].map(shown);
        self.note(text!("worksheet-carrier", link, pf0, pf1, pf2));
    }
}

/// A known value in a remark.
fn printed(expr: &Expr) -> Text {
    exact(expr.value(), shortest(expr.value(), RESULT_DIGITS))
}
