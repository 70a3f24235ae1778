//! The same mechanism in micrometers and kilometers, nanograms and kilotons.

use assur_check::Finding;
use assur_force::{LoadState, Loads, Reactions};
use assur_group::{Order, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Mechanism, Range};
use assur_words::name;

use super::Law;
use crate::stability::row::{Comparison, FACTOR};
use crate::stability::walk::{self, analyzers_of, growth, test_loads};

pub(super) static LAW: Law = Law {
    section: "Scales",
    along: "factor of all lengths, or of all masses",
    expected: "nothing for a power of two, which rounds nothing; else 2 * 16 eps (1 + |q|) (longest / \
               shortest length) (groups / product of determinants)^k for the rounding of the data: k = 1 for \
               places, 2 for PF1, PF2 and reactions; for the published longitudinal form also / sine^2 of \
               the angle at the pole",
};

/// Micrometers and kilometers, by powers of two and of ten.
const LENGTHS: [f64; 4] = [9.536_743_164_062_5e-7, 1024.0, 1e-6, 1e3];

/// 1e-9 and 1e9, by powers of two and of ten.
const MASSES: [f64; 4] = [9.313_225_746_154_785e-10, 1_073_741_824.0, 1e-9, 1e9];

/// Beyond this a method that has a pole may refuse.
const AT_INFINITY: f64 = 1e4;

/// Earth's, m/s².
const GRAVITY: f64 = 9.81;

/// Rows at one coordinate.
pub(crate) fn rows(linkage: &Linkage, q: f64, name: &str) -> Vec<Comparison> {
    let mut rows = Vec::new();
    let bare = bare(&linkage.mechanism);
    let mut position = linkage.position();
    if linkage.solve(q, Order::Second, &mut position).is_err() {
        return rows;
    }
    for factor in LENGTHS {
        let scaled = Linkage::compile(longer(&bare, factor)).map_err(|error| error.to_string());
        Pair { name, q, factor, before: (linkage, &position), rows: &mut rows }.lengths(scaled.as_ref());
    }
    if bare.links.iter().any(|link| link.mass > 0.0) {
        // Masses change nothing of what is compiled but the loads.
        let Ok(mut heavy) = Linkage::compile(bare.clone()) else { return rows };
        let light = weights(&heavy, &position);
        for factor in MASSES {
            for (link, given) in heavy.mechanism.links.iter_mut().zip(&bare.links) {
                (link.mass, link.inertia) = (given.mass * factor, given.inertia.clone());
                link.inertia *= factor;
            }
            let pair = Pair { name, q, factor, before: (&heavy, &position), rows: &mut rows };
            pair.masses(light.as_deref(), &weights(&heavy, &position));
        }
    }
    rows
}

/// Weights of all links.
fn weights(linkage: &Linkage, position: &Position) -> Result<Vec<Wrench<f64>>, String> {
    let loads = Loads::compile(linkage).map_err(|error| error.to_string())?;
    let state = LoadState { coordinate: position.coordinate, ..LoadState::default() };
    Ok(loads.total(&state, &position.bodies))
}

/// A mechanism before and after, and where its rows go.
struct Pair<'a> {
    name: &'a str,
    q: f64,
    factor: f64,
    before: (&'a Linkage, &'a Position),
    rows: &'a mut Vec<Comparison>,
}

impl Pair<'_> {
    /// With the power of the healths in the bound, and what the method's own singular position adds to it.
    fn row(
        &mut self,
        (place, method): (&str, &str),
        (quantity, power): (&'static str, i32),
        own: f64,
        found: Result<f64, String>,
    ) {
        let (linkage, position) = self.before;
        let lost = growth(position.health.iter().map(|health| health.abs())).powi(power) * disparity(linkage);
        // Both sides are rounded.
        let rounding = 2.0
            * FACTOR
            * f64::EPSILON
            * (1.0 + (self.q / linkage.coordinate_unit()).abs())
            * lost
            * own
            * own;
        let subject = Comparison {
            method: name(method.to_owned()),
            quantity,
            distance: self.factor,
            health: position.health.iter().fold(1.0, |least, health| health.abs().min(least)),
            finding: Finding::within(
                name(format!("{}, {place}", self.name)),
                if is_power_of_two(self.factor) { 0.0 } else { rounding },
            ),
        };
        self.rows.push(subject.judged_or(found.map_err(name), own > AT_INFINITY));
    }

    fn lengths(mut self, scaled: Result<&Linkage, &String>) {
        let (linkage, before) = self.before;
        let factor = self.factor;
        let unit = if linkage.kind().is_angle() { 1.0 } else { factor };
        let solved = scaled.map_err(Clone::clone).and_then(|scaled| {
            let mut after = scaled.position();
            let found = scaled.solve(self.q * unit, Order::Second, &mut after);
            found.map(|()| (scaled, after)).map_err(|error| error.to_string())
        });
        let of = ("lengths scaled", "closed forms");
        for (quantity, order) in [("pf0", 0), ("pf1", 1), ("pf2", 2)] {
            let apart = solved.as_ref().map_err(Clone::clone).map(|(_, after)| {
                let step = unit.powi(order);
                let parts = before.bodies.iter().zip(&after.bodies).skip(1).map(|(a, b)| {
                    let size = linkage.structure.scale;
                    match order {
                        0 => [
                            (a.x, b.x / factor, size),
                            (a.y, b.y / factor, size),
                            (a.c, b.c, 1.0),
                            (a.s, b.s, 1.0),
                        ],
                        1 => two([a.x1, a.y1, a.w1], [b.x1, b.y1, b.w1].map(|x| x * step), factor, size),
                        _ => two([a.x2, a.y2, a.w2], [b.x2, b.y2, b.w2].map(|x| x * step), factor, size),
                    }
                });
                worst(parts, 0.0)
            });
            self.row(of, (quantity, if order == 0 { 1 } else { 2 }), 1.0, apart);
        }
        for plugin in analyzers_of(linkage) {
            let pole = plugin.instance.condition(linkage, before);
            let found = solved.as_ref().map_err(Clone::clone).and_then(|(scaled, after)| {
                let reactions = |linkage: &Linkage, position: &Position| {
                    let (mut loads, mut out) = (test_loads(linkage), Reactions::new(linkage));
                    let solved = plugin.instance.solve(linkage, position, &mut loads, &mut out);
                    solved.map(|()| out.pairs).map_err(|error| error.to_string())
                };
                let found = (reactions(linkage, before)?, reactions(scaled, after)?);
                Ok(forces(&test_loads(linkage), (&found.0, &found.1), [1.0, factor], linkage))
            });
            self.row(("lengths scaled", plugin.name), ("reactions", 2), pole, found);
        }
    }

    fn masses(mut self, light: Result<&[Wrench<f64>], &String>, heavy: &Result<Vec<Wrench<f64>>, String>) {
        let (linkage, before) = self.before;
        for plugin in analyzers_of(linkage) {
            let pole = plugin.instance.condition(linkage, before);
            let reactions = |loads: &[Wrench<f64>]| {
                let (mut loads, mut out) = (loads.to_vec(), Reactions::new(linkage));
                let solved = plugin.instance.solve(linkage, before, &mut loads, &mut out);
                solved.map(|()| out.pairs).map_err(|error| error.to_string())
            };
            let found = light.map_err(Clone::clone).and_then(|light| {
                let heavy = heavy.as_ref().map_err(Clone::clone)?;
                let found = (reactions(light)?, reactions(heavy)?);
                Ok(forces(light, (&found.0, &found.1), [self.factor; 2], linkage))
            });
            self.row(("masses scaled", plugin.name), ("reactions", 2), pole, found);
        }
    }
}

/// Components x, y in units of the lengths, and a turn.
fn two(a: [f64; 3], b: [f64; 3], factor: f64, size: f64) -> [(f64, f64, f64); 4] {
    [(a[0], b[0] / factor, size), (a[1], b[1] / factor, size), (a[2], b[2], 1.0), (0.0, 0.0, 1.0)]
}

/// Largest ratio of lengths in a group.
fn disparity(linkage: &Linkage) -> f64 {
    linkage.structure.groups.iter().map(walk::disparity).fold(1.0, f64::max)
}

/// Largest deviation over the largest number, at least `least`, in units of a size each.
fn worst(parts: impl Iterator<Item = [(f64, f64, f64); 4]>, least: f64) -> f64 {
    let (mut apart, mut most) = (0.0, least.max(f64::MIN_POSITIVE));
    for (a, b, size) in parts.flatten() {
        most = f64::max(most, a.abs() / size);
        apart = assur_number::greater(apart, (a - b).abs() / size);
    }
    apart / most
}

/// The same of reactions under these loads; forces grow by the first factor, moments by both of lengths or by the one of masses.
fn forces(
    loads: &[Wrench<f64>],
    (a, b): (&[Wrench<f64>], &[Wrench<f64>]),
    [force, moment]: [f64; 2],
    linkage: &Linkage,
) -> f64 {
    let scale = linkage.structure.scale;
    let parts = a.iter().zip(b).skip(1).map(|(a, b)| {
        [(a.fx, b.fx / force, 1.0), (a.fy, b.fy / force, 1.0), (a.m, b.m / moment, scale), (0.0, 0.0, 1.0)]
    });
    // Where no load comes to a pair its reaction is the rounding of the loads.
    worst(parts, loads.iter().fold(0.0, |most, load| most.max(load.fx.hypot(load.fy))))
}

fn is_power_of_two(factor: f64) -> bool {
    /// Bits of the fraction of an f64.
    const FRACTION: u64 = (1 << 52) - 1;
    factor.to_bits() & FRACTION == 0
}

/// Links and pairs under their weight, without loads and drive.
fn bare(mechanism: &Mechanism) -> Mechanism {
    Mechanism {
        gravity: Some([0.0, -GRAVITY]),
        loads: Vec::new(),
        frictions: Vec::new(),
        balance: None,
        motion: None,
        drive: None,
        output: None,
        ..mechanism.clone()
    }
}

/// All lengths by a factor.
fn longer(mechanism: &Mechanism, factor: f64) -> Mechanism {
    let mut longer = mechanism.clone();
    let scale = |at: &mut [f64; 2]| *at = at.map(|x| x * factor);
    longer.points.iter_mut().flat_map(|point| &mut point.places).for_each(|place| scale(&mut place.at));
    longer.assembly.iter_mut().for_each(|(_, at)| scale(at));
    longer.links.iter_mut().for_each(|link| scale(&mut link.center));
    for slide in &mut longer.slides {
        scale(&mut slide.point);
        scale(&mut slide.through);
    }
    if !longer.input.is_angle() {
        longer.input.from *= factor;
        longer.input.range = match longer.input.range {
            Range::Cycle(cycle) => Range::Cycle(cycle * factor),
            Range::To(to) => Range::To(to * factor),
        };
    }
    longer
}
