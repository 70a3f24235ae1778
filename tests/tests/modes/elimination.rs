//! All modes of a plate on three legs by elimination, in 32 digits, independently of the program's formulas: the closure as a
//! polynomial in t = tan(φ/2), its real roots counted by Sturm's theorem and found by halving.
//!
//! Polynomials in the angle are sums of `c_k z^k` with z = exp(iφ), so that their degree is no greater than it must be.

use assur_group::plane::{cross, direction, dot, minus, mirrored, perp, plus, scaled, times, vector};
use assur_group::{Body, GroupFrame, Pair, PairGeometry};
use assur_number::{Dd, Real};

type V = [Dd; 2];

/// Origin and direction of the plate relative to the base (the ground, or the other ternary link).
pub(crate) type Pose = [[f64; 2]; 2];

/// A pair of a leg with a body: pins on leg and body; or a line of the body on which a point of the leg stays, and the direction
/// of the leg in the frame of the body.
#[derive(Clone, Copy)]
enum Joint {
    Pin { leg: V, body: V },
    Slide { leg: V, body: V, normal: V, turn: V },
}

/// The condition of a leg: the points `at` of the base and `on` of the plate, and what is given of the way between them.
#[derive(Clone, Copy)]
enum Leg {
    Distance(V, V, Dd),
    /// Its part along a normal of the base.
    OnBase(V, V, V, Dd),
    /// Its part along a normal of the plate.
    OnPlate(V, V, V, Dd),
    /// The direction of the plate.
    Turn(V),
}

fn pose(body: &Body<f64>) -> Body<Dd> {
    body.map(Dd::from_f64)
}

impl Joint {
    /// A pair as seen from the leg.
    fn of(pair: &Pair, leg: usize) -> Self {
        let is_leg_first = pair.a == leg;
        match pair.geometry {
            PairGeometry::Pin { at_a, at_b } if is_leg_first => {
                Self::Pin { leg: vector(at_a), body: vector(at_b) }
            }
            PairGeometry::Pin { at_a, at_b } => Self::Pin { leg: vector(at_b), body: vector(at_a) },
            PairGeometry::Slide { point, through, angle, tilt } => {
                let [along, turn] = [direction(angle), times(direction(angle), direction(tilt))];
                let (point, through) = (vector(point), vector(through));
                if is_leg_first {
                    Self::Slide { leg: point, body: through, normal: perp(along), turn }
                } else {
                    let normal = times(perp(along), mirrored(turn));
                    Self::Slide { leg: through, body: point, normal, turn: mirrored(turn) }
                }
            }
        }
    }

    /// With the body in the frame of the ground.
    fn on_ground(self, outer: &Body<f64>) -> Self {
        let at = pose(outer);
        match self {
            Self::Pin { leg, body } => Self::Pin { leg, body: at.point(body) },
            Self::Slide { leg, body, normal, turn } => Self::Slide {
                leg,
                body: at.point(body),
                normal: at.turned(normal),
                turn: times([at.c, at.s], turn),
            },
        }
    }

    /// With the leg, which is an outer body, in the frame of the ground.
    fn of_ground(self, outer: &Body<f64>) -> Self {
        let at = pose(outer);
        match self {
            Self::Pin { leg, body } => Self::Pin { leg: at.point(leg), body },
            Self::Slide { leg, body, normal, turn } => {
                Self::Slide { leg: at.point(leg), body, normal, turn: times(turn, [at.c, -at.s]) }
            }
        }
    }
}

impl Leg {
    fn new(base: Joint, plate: Joint) -> Self {
        match (base, plate) {
            (Joint::Pin { leg: a, body: at }, Joint::Pin { leg: b, body: on }) => {
                let rod = minus(b, a);
                Self::Distance(at, on, dot(rod, rod).sqrt())
            }
            (Joint::Slide { leg, body, normal, turn }, Joint::Pin { leg: pin, body: on }) => {
                Self::OnBase(body, on, normal, dot(normal, times(turn, minus(pin, leg))))
            }
            (Joint::Pin { leg: pin, body: at }, Joint::Slide { leg, body, normal, turn }) => {
                Self::OnPlate(at, body, normal, dot(normal, times(turn, minus(pin, leg))))
            }
            (Joint::Slide { turn: one, .. }, Joint::Slide { turn: other, .. }) => {
                Self::Turn(times(one, mirrored(other)))
            }
        }
    }
}

/// A function of the angle: `Σ c_k z^k`, k = -n to n, as complex numbers.
#[derive(Clone)]
struct Trig(Vec<V>);

impl Trig {
    fn constant(value: Dd) -> Self {
        Self(vec![[value, Dd::ZERO]])
    }

    /// The parts of a vector of the plate in the frame of the base.
    fn turned(of: V) -> [Self; 2] {
        let (x, y) = (of[0].half(), of[1].half());
        let o = Dd::ZERO;
        // x cos - y sin and x sin + y cos.
        [Self(vec![[x, -y], [o, o], [x, y]]), Self(vec![[y, x], [o, o], [y, -x]])]
    }

    fn add(&self, other: &Self, factor: f64) -> Self {
        let size = self.0.len().max(other.0.len());
        let mut sum = vec![[Dd::ZERO; 2]; size];
        for (part, by) in [(self, 1.0), (other, factor)] {
            let shift = (size - part.0.len()) / 2;
            for (k, c) in part.0.iter().enumerate() {
                sum[k + shift] = plus(sum[k + shift], scaled(Dd::from_f64(by), *c));
            }
        }
        Self(sum)
    }

    fn by(&self, other: &Self) -> Self {
        let mut product = vec![[Dd::ZERO; 2]; self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (k, b) in other.0.iter().enumerate() {
                product[i + k] = plus(product[i + k], times(*a, *b));
            }
        }
        Self(product)
    }

    fn at(&self, z: V) -> Dd {
        let n = self.0.len() / 2;
        let power = |k: usize| (0..k).fold([Dd::ONE, Dd::ZERO], |all, _| times(all, z));
        let term = |(k, c): (usize, &V)| {
            let z = if k >= n { power(k - n) } else { mirrored(power(n - k)) };
            times(*c, z)[0]
        };
        self.0.iter().enumerate().map(term).fold(Dd::ZERO, |sum, part| sum + part)
    }

    /// The polynomial in t whose real roots are the zeros, of at most this degree in the angle.
    fn polynomial(&self, degree: usize) -> Vec<Dd> {
        let n = self.0.len() / 2;
        let size = |c: &V| c[0].to_f64().hypot(c[1].to_f64());
        let most = self.0.iter().map(size).fold(0.0, f64::max);
        let mut sum = vec![Dd::ZERO; 2 * degree + 1];
        for (k, c) in self.0.iter().enumerate() {
            if k.abs_diff(n) > degree {
                assert!(size(c) < 1e-24 * most, "the degree is greater");
                continue;
            }
            let up = (k + degree) - n;
            let mut power = vec![*c];
            for i in 0..2 * degree {
                // (1 + it)^(n + k) (1 - it)^(n - k).
                let factor = [Dd::ZERO, Dd::from_f64(if i < up { 1.0 } else { -1.0 })];
                let mut next = power.clone();
                next.push([Dd::ZERO; 2]);
                for (j, part) in power.iter().enumerate() {
                    next[j + 1] = plus(next[j + 1], times(*part, factor));
                }
                power = next;
            }
            sum.iter_mut().zip(power).for_each(|(sum, part)| *sum += part[0]);
        }
        sum
    }
}

fn value(p: &[Dd], t: f64) -> Dd {
    p.iter().rev().fold(Dd::ZERO, |sum, c| sum * Dd::from_f64(t) + *c)
}

/// Sturm's sequence; each member but for a positive factor.
fn sturm(p: &[Dd]) -> Vec<Vec<Dd>> {
    let normal = |p: Vec<Dd>| -> Vec<Dd> {
        let most = p.iter().map(|c| c.to_f64().abs()).fold(0.0, f64::max);
        p.iter().map(|c| *c / Dd::from_f64(most)).collect()
    };
    let p = normal(p.to_vec());
    let slope = (1..p.len()).map(|k| p[k] * Dd::from_f64(k as f64)).collect();
    let mut all = vec![p, normal(slope)];
    while all[all.len() - 1].len() > 1 {
        let (mut rest, by) = (all[all.len() - 2].clone(), &all[all.len() - 1]);
        while rest.len() >= by.len() {
            let shift = rest.len() - by.len();
            let factor = rest[rest.len() - 1] / by[by.len() - 1];
            by.iter().enumerate().for_each(|(k, c)| rest[k + shift] -= factor * *c);
            rest.pop();
        }
        all.push(normal(rest.into_iter().map(|c| -c).collect()));
    }
    all
}

/// Real roots of a polynomial.
fn roots(p: &[Dd]) -> Vec<f64> {
    let all = sturm(p);
    let changes = |t: f64| {
        let signs: Vec<bool> = all.iter().map(|p| value(p, t).to_f64() > 0.0).collect();
        signs.windows(2).filter(|two| two[0] != two[1]).count()
    };
    let last = p[p.len() - 1].to_f64().abs();
    let bound = 1.0 + p.iter().map(|c| c.to_f64().abs() / last).fold(0.0, f64::max);
    let mut left = vec![(-bound, bound)];
    let mut found = Vec::new();
    while let Some((low, high)) = left.pop() {
        let middle = 0.5 * (low + high);
        match changes(low) - changes(high) {
            0 => {}
            1 if middle <= low || middle >= high => found.push(middle),
            1 => {
                let is_below = changes(low) > changes(middle);
                left.push(if is_below { (low, middle) } else { (middle, high) });
            }
            _ => left.extend([(low, middle), (middle, high)]),
        }
    }
    found
}

/// m r = k for the way r of the first leg, as functions of the angle.
type Line = ([Trig; 2], Trig);

fn product(a: &[Trig; 2], b: &[Trig; 2]) -> Trig {
    a[0].by(&b[0]).add(&a[1].by(&b[1]), 1.0)
}

fn across(a: &[Trig; 2], b: &[Trig; 2]) -> Trig {
    a[0].by(&b[1]).add(&a[1].by(&b[0]), -1.0)
}

fn ends(leg: &Leg) -> [V; 2] {
    match *leg {
        Leg::Distance(at, on, _) | Leg::OnBase(at, on, ..) | Leg::OnPlate(at, on, ..) => [at, on],
        Leg::Turn(_) => [[Dd::ZERO; 2]; 2],
    }
}

/// The condition of a leg for the way from `at` to `on` of the first.
fn line(leg: &Leg, first: &Leg) -> Line {
    let [[at, on], [at0, on0]] = [ends(leg), ends(first)];
    let far = minus(at, at0);
    let offset = Trig::turned(minus(on, on0));
    let offset = [0, 1].map(|k| offset[k].add(&Trig::constant(far[k]), -1.0));
    match (leg, first) {
        (Leg::OnBase(_, _, normal, part), _) => {
            let m = normal.map(Trig::constant);
            let k = Trig::constant(*part).add(&product(&m, &offset), -1.0);
            (m, k)
        }
        (Leg::OnPlate(_, _, normal, part), _) => {
            let m = Trig::turned(*normal);
            // The way is counted from the plate.
            let k = Trig::constant(-*part).add(&product(&m, &offset), -1.0);
            (m, k)
        }
        (Leg::Distance(_, _, length), Leg::Distance(_, _, own)) => {
            let difference = Trig::constant((*length * *length - *own * *own).half());
            let square = product(&offset, &offset);
            (offset, difference.add(&square, -0.5))
        }
        _ => panic!("a leg of two pins comes first"),
    }
}

/// All poses of the plate, with at most this many.
fn solved(mut legs: [Leg; 3], most: usize) -> Vec<Pose> {
    legs.sort_by_key(|leg| match leg {
        Leg::Distance(..) => 0,
        Leg::OnBase(..) | Leg::OnPlate(..) => 1,
        Leg::Turn(_) => 2,
    });
    let [at, on] = ends(&legs[0]);
    let placed = |z: V, way: V| {
        let origin = plus(at, minus(way, times(on, z)));
        [origin, z].map(|of| of.map(Real::to_f64))
    };
    let second = line(&legs[1], &legs[0]);
    let number = |line: &Line, z: V| ([line.0[0].at(z), line.0[1].at(z)], line.1.at(z));
    let meeting = |(m1, k1): (V, Dd), (m2, k2): (V, Dd)| {
        let d = cross(m1, m2);
        [(k1 * m2[1] - k2 * m1[1]) / d, (k2 * m1[0] - k1 * m2[0]) / d]
    };
    if let Leg::Turn(z) = legs[2] {
        let (m, k) = number(&second, z);
        let Leg::Distance(.., length) = legs[0] else {
            return vec![placed(z, meeting(number(&line(&legs[0], &legs[0]), z), (m, k)))];
        };
        let square = dot(m, m);
        let rest = length * length - k * k / square;
        if rest.to_f64() < 0.0 {
            return Vec::new();
        }
        let (foot, side) = (scaled(k / square, m), scaled((rest / square).sqrt(), perp(m)));
        return vec![placed(z, plus(foot, side)), placed(z, minus(foot, side))];
    }
    let third = line(&legs[2], &legs[0]);
    let d = across(&second.0, &third.0);
    let n = [
        second.1.by(&third.0[1]).add(&third.1.by(&second.0[1]), -1.0),
        third.1.by(&second.0[0]).add(&second.1.by(&third.0[0]), -1.0),
    ];
    let closure = if let Leg::Distance(.., length) = legs[0] {
        product(&n, &n).add(&d.by(&d).by(&Trig::constant(length * length)), -1.0)
    } else {
        let first = line(&legs[0], &legs[0]);
        product(&first.0, &n).add(&first.1.by(&d), -1.0)
    };
    let polynomial = closure.polynomial(most / 2);
    let at_root = |t: f64| {
        // The root has 16 digits, one step of Newton's method gives it all.
        let slope: Vec<Dd> = (1..polynomial.len()).map(|k| polynomial[k] * Dd::from_f64(k as f64)).collect();
        let t = Dd::from_f64(t) - value(&polynomial, t) / value(&slope, t);
        let z = times([Dd::ONE, t], [Dd::ONE, t]);
        let z = scaled(Dd::ONE / (Dd::ONE + t * t), z);
        placed(z, meeting(number(&second, z), number(&third, z)))
    };
    roots(&polynomial).into_iter().map(at_root).collect()
}

/// The ternary links of a group of class III, order 3, or class IV, order 2: base (none in class III) and plate.
pub(crate) fn ternary(frame: &GroupFrame) -> (Option<usize>, usize) {
    let pairs = |link: usize| frame.pairs().filter(|pair| pair.joins(link)).count();
    let found: Vec<usize> = frame.links.iter().copied().filter(|&link| pairs(link) == 3).collect();
    match found[..] {
        [plate] => (None, plate),
        [base, plate] => (Some(base), plate),
        _ => panic!("{} ternary links", found.len()),
    }
}

/// All poses of the plate relative to the base, at the poses of the outer bodies.
pub(crate) fn poses(frame: &GroupFrame, bodies: &[Body<f64>], most: usize) -> Vec<Pose> {
    let (base, plate) = ternary(frame);
    let outer = |link: usize| {
        let pair = frame.outer.iter().find(|pair| pair.joins(link)).unwrap();
        (pair, &bodies[pair.other(link)])
    };
    let inner = |leg: usize, link: usize| {
        Joint::of(frame.inner.iter().find(|pair| pair.joins(leg) && pair.joins(link)).unwrap(), leg)
    };
    let binary = frame.links.iter().copied().filter(|&link| link != plate && Some(link) != base);
    let mut legs: Vec<Leg> = binary
        .map(|leg| {
            let on_base = base.map_or_else(
                || {
                    let (pair, body) = outer(leg);
                    Joint::of(pair, leg).on_ground(body)
                },
                |base| inner(leg, base),
            );
            Leg::new(on_base, inner(leg, plate))
        })
        .collect();
    if let Some(base) = base {
        let [on_base, on_plate] = [base, plate].map(|link| {
            let (pair, body) = outer(link);
            Joint::of(pair, pair.other(link)).of_ground(body)
        });
        legs.push(Leg::new(on_base, on_plate));
    }
    solved(legs.try_into().unwrap_or_else(|_| panic!("three legs")), most)
}
