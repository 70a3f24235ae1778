//! Mechanisms that go through change points, with their motion in closed form: by symmetry, without the equations of a
//! group, so that nothing is lost at the change point.

use std::f64::consts::{FRAC_PI_2, PI};

use assur_group::Body;
use assur_number::{Dd, Real};

use super::jet::Jet;

type Vector = [Jet; 2];

/// A mechanism with its motion: a crank OA of the length `crank` on the origin, and one group.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    pub(crate) name: &'static str,
    /// Change points, rad.
    pub(crate) centers: &'static [f64],
    kind: Kind,
}

#[derive(Debug, Clone, Copy)]
enum Kind {
    /// Crank and rocker parallel.
    Parallelogram { crank: f64, ground: f64 },
    /// The same lengths crossed.
    Crossed { crank: f64, ground: f64 },
    /// Ground and rocker 1 long, crank and coupler short.
    Kite { short: f64 },
    /// Ground and crank 1 long, coupler and rocker longer.
    Deltoid { long: f64 },
    /// Slider-crank with crank = rod = 1, in line.
    Isosceles,
    /// Slider-crank with a crank 1 and rod = crank + offset.
    Touching { offset: f64 },
}

/// All of them. What comes close in the complex plane tells how fast the motion changes at the change point: ln(ground/crank)
/// for the crossed parallelogram, ln(1/short) for the kite.
pub(crate) const KNOWN: [Known; 9] = [
    Known {
        name: "parallelogram 0.5 : 1",
        centers: &[0.0, PI],
        kind: Kind::Parallelogram { crank: 0.5, ground: 1.0 },
    },
    Known {
        name: "crossed parallelogram 0.5 : 1",
        centers: &[0.0, PI],
        kind: Kind::Crossed { crank: 0.5, ground: 1.0 },
    },
    Known {
        name: "crossed parallelogram 0.95 : 1",
        centers: &[0.0, PI],
        kind: Kind::Crossed { crank: 0.95, ground: 1.0 },
    },
    Known { name: "kite 0.5 : 1", centers: &[0.0, PI], kind: Kind::Kite { short: 0.5 } },
    Known { name: "kite 0.9 : 1", centers: &[0.0, PI], kind: Kind::Kite { short: 0.9 } },
    Known { name: "kite 0.99 : 1", centers: &[0.0, PI], kind: Kind::Kite { short: 0.99 } },
    Known { name: "kite 1 : 1.5, pins meeting", centers: &[0.0], kind: Kind::Deltoid { long: 1.5 } },
    Known {
        name: "slider-crank, crank = rod",
        centers: &[FRAC_PI_2, 3.0 * FRAC_PI_2],
        kind: Kind::Isosceles,
    },
    Known {
        name: "slider-crank, rod = crank + offset",
        centers: &[-FRAC_PI_2],
        kind: Kind::Touching { offset: 0.25 },
    },
];

/// Crank angle of the first position, rad.
const FROM: f64 = 1.0;

impl Known {
    /// The scene; the crank is link 1, the group's links are 2 and 3.
    pub(crate) fn scene(&self) -> String {
        let bodies = self.bodies(Dd::from_f64(FROM));
        let rod = |length: f64| bodies[1].point([Dd::from_f64(length), Dd::ZERO]).map(Real::to_f64);
        let text = match self.kind {
            Kind::Parallelogram { crank, ground } | Kind::Crossed { crank, ground } => {
                four_bar([crank, ground, crank, ground], rod(ground))
            }
            Kind::Kite { short } => four_bar([short, short, 1.0, 1.0], rod(short)),
            Kind::Deltoid { long } => four_bar([1.0, long, long, 1.0], rod(long)),
            Kind::Isosceles => slider_crank(1.0, 0.0, rod(1.0)),
            Kind::Touching { offset } => slider_crank(1.0 + offset, offset, rod(1.0 + offset)),
        };
        format!("title = \"{}\"\n{text}", self.name)
    }

    /// Links 1, 2 and 3 (crank, coupler from A to B, rocker from C to B or slider at B) in closed form.
    pub(crate) fn bodies(&self, q: Dd) -> [Body<Dd>; 3] {
        let [s, c] = Jet::sin_cos(q, 1.0, Dd::ZERO);
        let of = Jet::constant;
        let origin = [of(0.0), of(0.0)];
        let along = [of(1.0), of(0.0)];
        let crank = [c, s];
        let at = |r: f64| [of(r) * c, of(r) * s];
        match self.kind {
            Kind::Parallelogram { crank: r, ground } => {
                [body(origin, crank), body(at(r), along), body([of(ground), of(0.0)], crank)]
            }
            Kind::Crossed { crank: r, ground } => {
                let pivot = [of(ground), of(0.0)];
                let line = minus(at(r), pivot);
                [body(origin, crank), body(at(r), mirrored(along, line)), body(pivot, mirrored(crank, line))]
            }
            Kind::Kite { short } => {
                let pivot = along;
                let line = minus(at(short), pivot);
                let coupler = mirrored([-c, -s], line);
                [
                    body(origin, crank),
                    body(at(short), coupler),
                    body(pivot, mirrored([of(-1.0), of(0.0)], line)),
                ]
            }
            Kind::Deltoid { long } => {
                let [half_s, half_c] = Jet::sin_cos(q, 0.5, Dd::ZERO);
                let reach = half_c + (of(long * long) - half_s * half_s).sqrt();
                let b = [reach * half_c, reach * half_s];
                let unit = |from: Vector| minus(b, from).map(|part| part / of(long));
                [body(origin, crank), body(at(1.0), unit(at(1.0))), body(along, unit(along))]
            }
            Kind::Isosceles => {
                let b = [c + c, of(0.0)];
                [body(origin, crank), body(at(1.0), [c, -s]), body(b, along)]
            }
            Kind::Touching { offset } => {
                let quarter = Dd::from_f64(FRAC_PI_2) + Dd::from_f64(6.123_233_995_736_766e-17);
                let [half, _] = Jet::sin_cos(q, 0.5, quarter.half());
                let (rod, e) = (of(1.0 + offset), of(offset));
                let run = (of(2.0) * (rod + e - s)).sqrt() * half;
                [body(origin, crank), body(at(1.0), [run / rod, (e - s) / rod]), body([c + run, e], along)]
            }
        }
    }
}

/// Crank, coupler, rocker, ground.
fn four_bar([crank, coupler, rocker, ground]: [f64; 4], [x, y]: [f64; 2]) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0], C = [{ground}, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
         [link.coupler]\npoints = {{ A = 0, B = {coupler} }}\n[link.rocker]\npoints = {{ C = 0, B = {rocker} }}\n\
         [input]\nlink = \"crank\"\nfrom = {FROM}\n[assembly]\nB = [{x}, {y}]\n"
    )
}

/// With a crank of 1 and the guide at a height.
fn slider_crank(rod: f64, offset: f64, [x, y]: [f64; 2]) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 1 }}\n\
         [link.rod]\npoints = {{ A = 0, B = {rod} }}\n[link.slider]\npoints = {{ B = 0 }}\n\
         [[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = [0, {offset}]\n\
         [input]\nlink = \"crank\"\nfrom = {FROM}\n[assembly]\nB = [{x}, {y}]\n"
    )
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

/// A direction, mirrored at a line through the origin.
fn mirrored(v: Vector, line: Vector) -> Vector {
    let [x, y] = line;
    let along = (x * v[0] + y * v[1]) / (x * x + y * y);
    let twice = along + along;
    [twice * x - v[0], twice * y - v[1]]
}

fn body(at: Vector, [c, s]: Vector) -> Body<Dd> {
    let ([x, x1, x2], [y, y1, y2]) = (at[0].0, at[1].0);
    let ([c, c1, c2], [s, s1, s2]) = (c.0, s.0);
    Body { x, y, c, s, x1, y1, w1: c * s1 - s * c1, x2, y2, w2: c * s2 - s * c2 }
}
