//! Numerical differentiation at ever smaller steps.

use assur_check::Finding;
use assur_group::{Body, Order};
use assur_kinematics::{Chain, Linkage};
use assur_number::{Dd, Real};

use super::Law;
use crate::chart::kinematics::differences::{Differentiator, Stencil};
use crate::stability::exact::{ORDERS, transfer};
use crate::stability::row::{Comparison, DISTANCES, FACTOR};
use crate::stability::walk::growth;

pub(super) static LAW: Law = Law {
    section: "Numerical differentiation",
    along: "step of the differences, rad or parts of the size",
    expected: "2 (h^p M + 16 eps (1 + |q|) groups / determinants * k / h^order): p = 2, 4 for three and five \
               points, M the next derivative over its factor (6, 30 for PF1, 12, 90 for PF2) on the points, \
               k the sum of the weights",
};

/// The closed forms at the place, in 32 digits.
struct Exact<'a> {
    linkage: &'a Linkage,
    chain: Chain<Dd>,
    q: f64,
    /// Of the coordinate, m or rad; and of lengths.
    units: [f64; 2],
}

/// Both stencils over all steps at one coordinate.
pub(crate) fn rows(linkage: &Linkage, q: f64, name: &str) -> Vec<Comparison> {
    let Ok(chain) = Chain::<Dd>::compile(&linkage.mechanism, &linkage.structure) else { return Vec::new() };
    let scale = linkage.structure.scale;
    let exact = Exact { linkage, chain, q, units: [linkage.coordinate_unit(), scale] };
    let mut rows = Vec::new();
    for (stencil, order) in Stencil::ALL.into_iter().zip([2, 4]) {
        for step in DISTANCES {
            exact.step((stencil, order), step, name, &mut rows);
        }
    }
    rows
}

impl Exact<'_> {
    fn bodies(&self, q: Dd) -> Option<(Vec<Body<Dd>>, Vec<Dd>)> {
        let (mut bodies, mut health) = (self.chain.bodies(), vec![Dd::ZERO; self.chain.groups.len()]);
        let ways = self.linkage.ways.at(q.to_f64());
        self.chain.solve(q, ways, Order::Second, &mut bodies, &mut health).ok()?;
        Some((bodies, health))
    }

    fn step(&self, (stencil, order): (Stencil, i32), step: f64, name: &str, rows: &mut Vec<Comparison>) {
        let Some((bodies, health)) = self.bodies(Dd::from_f64(self.q)) else { return };
        let Some(beyond) = self.beyond(step) else { return };
        let links: Vec<usize> = (1..bodies.len()).collect();
        let mut differentiator = Differentiator::new(self.linkage, stencil, step);
        let found = differentiator.solve(self.q);
        let [unit, scale] = self.units;
        let growth = growth(health.iter().map(|health| health.abs().to_f64()));
        let rounding = FACTOR * f64::EPSILON * (1.0 + (self.q / unit).abs()) * growth;
        for derivative in [1, 2] {
            let (next, factor, weights) = match (order, derivative) {
                (2, 1) => (beyond[0], 6.0, 1.0),
                (2, _) => (beyond[1], 12.0, 4.0),
                (_, 1) => (beyond[2], 30.0, 1.5),
                _ => (beyond[3], 90.0, 17.0 / 3.0),
            };
            let power = i32::try_from(derivative).unwrap_or(2);
            let bound = 2.0 * (step.powi(order) * next / factor + rounding * weights / step.powi(power));
            let floor = unit.powi(-power);
            let outcome = match &found {
                Ok(middle) => Ok(transfer(&middle.bodies, &bodies, &links, derivative, scale, floor)),
                Err(why) => Err(why.clone()),
            };
            let subject = Comparison {
                method: assur_words::name(stencil.name),
                quantity: ORDERS[derivative],
                distance: step,
                health: health.iter().fold(1.0, |least, health| health.abs().to_f64().min(least)),
                finding: Finding::within(assur_words::name(name.to_owned()), bound),
            };
            rows.push(without_digits(subject.judged_or(outcome, false)));
        }
    }

    /// Largest third to sixth derivative of the places of all links on the points of the stencils; by differences of PF2 in
    /// 32 digits.
    fn beyond(&self, step: f64) -> Option<[f64; 4]> {
        /// Leaves 1e-8 of the derivative and loses 1e-14 of it.
        const DELTA: f64 = 1e-4;
        let unit = self.units[0];
        let mut most = [0.0_f64; 4];
        for i in -4..=4 {
            let center = Dd::from_f64(self.q) + Dd::from_f64(0.5 * step * unit * f64::from(i));
            let second = |k: f64| Some(self.second(&self.bodies(center + Dd::from_f64(k * DELTA * unit))?.0));
            let f = [second(-2.0)?, second(-1.0)?, second(0.0)?, second(1.0)?, second(2.0)?];
            for (k, &c) in f[2].iter().enumerate() {
                let [a, b, d, e] = [0, 1, 3, 4].map(|i: usize| f[i][k]);
                let found = [
                    (d - b).half(),
                    d - c.twice() + b,
                    (e - d.twice() + b.twice() - a).half(),
                    e - (d + b).twice().twice() + (c.twice() + c).twice() + a,
                ];
                for ((most, found), power) in most.iter_mut().zip(found).zip(1..) {
                    *most = most.max(found.abs().to_f64() / DELTA.powi(power));
                }
            }
        }
        Some(most)
    }

    /// Second derivatives of all places and directions, in units.
    fn second(&self, bodies: &[Body<Dd>]) -> Vec<Dd> {
        let [unit, scale] = self.units.map(Dd::from_f64);
        let of = |body: &Body<Dd>| {
            let square = body.w1 * body.w1;
            let direction = [-(body.s * body.w2) - body.c * square, body.c * body.w2 - body.s * square];
            let [c2, s2] = direction.map(|part| part * unit * unit);
            [body.x2 * unit * unit / scale, body.y2 * unit * unit / scale, c2, s2]
        };
        bodies.iter().skip(1).flat_map(of).collect()
    }
}

/// At steps so small nothing is left, as the bound says; the program takes no derivative this way.
fn without_digits(mut row: Comparison) -> Comparison {
    if row.finding.number().is_some_and(|error| error <= row.finding.bound) && row.finding.failed() {
        row.finding.holds = None;
        row.finding.why =
            assur_words::name("no digit is left, as the bound says: the step is too small, or too great");
    }
    row
}
