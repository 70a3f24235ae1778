//! Dry friction in the whole mechanism at once: the magnitudes of all pairs are unknowns.
//!
//! The loads of friction are written down from the surfaces of the bearings, and what the whole system answers to each of them
//! gives the equations z = |a + W z| of all magnitudes together. The moment of faces offset from the guide line is linear in the normal
//! force and stands in the system itself.

use assur_force::{Doubt, FrictionForces as Found, FrictionSolution, Reactions};
use assur_friction::{Moduli, PathPoint, Solutions, Width, path};
use assur_group::{Body, Wrench};
use assur_mechanism::{LinkId, Mechanism, Middle, PairId, Surfaces};
use assur_number::elementary;

use crate::system::{Solution, System};

/// A magnitude: of which bearing, and how it follows from a solution.
struct Modulus {
    bearing: usize,
    pair: PairId,
    links: [LinkId; 2],
    /// Sense of the relative speed times the coefficient.
    factor: f64,
    kind: Kind,
}

enum Kind {
    /// Force of a pin, with the radius of the journal.
    Journal(f64),
    /// Normal force of a slide: its part, and the factor of the moment about the middle.
    Press { part: f64, by_moment: f64, middle: Middle },
}

/// Moments of the faces of all slides by unit of normal force: what stands in the system.
fn shifts(mechanism: &Mechanism, found: &Found) -> Vec<f64> {
    let mut shifts = vec![0.0; mechanism.slides.len()];
    for (bearing, sense) in found.frictions.bearings.iter().zip(&found.senses) {
        if let (PairId::Slide(slide), Surfaces::Faces { offset, .. }) = (bearing.pair, bearing.surfaces) {
            shifts[slide] = -sense * bearing.coefficient * offset;
        }
    }
    shifts
}

fn moduli(found: &Found) -> Vec<Modulus> {
    let mut all = Vec::new();
    for (bearing, (one, sense)) in found.frictions.bearings.iter().zip(&found.senses).enumerate() {
        let (links, factor) = ([one.link, one.on], sense * one.coefficient);
        let mut add = |kind| all.push(Modulus { bearing, pair: one.pair, links, factor, kind });
        match one.surfaces {
            _ if factor == 0.0 => {}
            Surfaces::Journal { radius, .. } => add(Kind::Journal(radius)),
            Surfaces::Place => add(Kind::Press { part: 1.0, by_moment: 0.0, middle: Middle::Point }),
            Surfaces::Faces { length, middle, .. } => {
                for end in [1.0, -1.0] {
                    add(Kind::Press { part: 0.5, by_moment: end / length, middle });
                }
            }
        }
    }
    all
}

/// Whether a mechanism with friction has an equilibrium.
pub(crate) enum Equilibrium {
    Found,
    /// None was found; whether there is certainly none.
    None {
        proved: bool,
    },
}

/// What a mechanism is at a position.
pub(crate) struct Frictional<'a> {
    pub(crate) system: &'a System<'a>,
    pub(crate) mechanism: &'a Mechanism,
    pub(crate) bodies: &'a [Body<f64>],
}

impl Frictional<'_> {
    /// Reactions with friction. Where several exist all are given; the results are those of the one that follows from small coefficients, else that of
    /// the least balancing load.
    ///
    /// # Errors
    ///
    /// The ratio of pivots of a system that can't be solved.
    pub(crate) fn solve(
        &self,
        loads: &[Wrench<f64>],
        found: &mut Found,
        put: impl Fn(&Solution, &mut Reactions),
        out: &mut Reactions,
    ) -> Result<Equilibrium, f64> {
        found.doubts.clear();
        if found.senses.iter().any(|sense| sense.is_nan()) {
            // At rest friction is not determined.
            out.pairs.fill(Wrench { fx: f64::NAN, fy: f64::NAN, m: f64::NAN });
            out.balancing = f64::NAN;
            found.forces.fill(f64::NAN);
            return Ok(Equilibrium::Found);
        }
        let unknowns = moduli(found);
        let shifts = shifts(self.mechanism, found);
        let prepared = |part: f64| self.equations(loads, &shifts, &unknowns, part);
        let (base, each, system) = prepared(1.0)?;
        let zero = vec![0.0; unknowns.len()];
        let only = if system.certificate() < 1.0 { system.follow(&zero) } else { None };
        let mut taken = None;
        let all = if let Some(only) = only {
            Solutions { points: vec![only], complete: true, continuum: false }
        } else {
            let near = |part: f64, expected: &[f64]| {
                if shifts.iter().all(|shift| *shift == 0.0) {
                    return system.scaled(part).near(expected);
                }
                prepared(part).ok()?.2.near(expected)
            };
            let start = PathPoint { part: 0.0, moduli: prepared(0.0)?.2.step(&zero) };
            let mut all = system.solutions();
            taken = path(start, near).ok().map(|z| all.index_of(z));
            all
        };
        let sums: Vec<Solution> = (all.points.iter())
            .map(|z| each.iter().zip(z).fold(base.clone(), |sum, (one, z)| sum.plus(*z, one)))
            .collect();
        let size = |i: &usize| sums[*i].balancing.abs();
        let of_motion = found.driven(sums.iter().map(|sum| sum.balancing)).filter(|_| out.unit.is_none());
        let Some(taken) =
            of_motion.or(taken).or_else(|| (0..sums.len()).min_by(|a, b| size(a).total_cmp(&size(b))))
        else {
            return Ok(Equilibrium::None { proved: all.complete });
        };
        let mut solutions = Vec::new();
        // The one that is taken comes last: it stays in `out`.
        for i in (0..sums.len()).filter(|i| *i != taken).chain([taken]) {
            put(&sums[i], out);
            self.add_friction(&unknowns, &all.points[i], found, &mut out.pairs);
            let (balancing, pairs, forces) = (out.balancing, out.pairs.clone(), found.forces.clone());
            solutions.push(FrictionSolution { balancing, pairs, forces, taken: i == taken });
        }
        if solutions.len() > 1 || !all.complete || all.continuum {
            solutions.sort_by(|a, b| a.balancing.total_cmp(&b.balancing));
            found.doubts.push((0, Doubt { solutions, proved: all.complete, continuum: all.continuum }));
        }
        Ok(Equilibrium::Found)
    }

    /// The friction of a solution, and its part in the reactions.
    fn add_friction(
        &self,
        unknowns: &[Modulus],
        moduli: &[f64],
        found: &mut Found,
        pairs: &mut [Wrench<f64>],
    ) {
        found.forces.fill(0.0);
        for (unknown, z) in unknowns.iter().zip(moduli) {
            let size = match unknown.kind {
                Kind::Journal(radius) => -unknown.factor * radius * z,
                Kind::Press { .. } => -unknown.factor * z,
            };
            found.forces[unknown.bearing] += size;
        }
        add_to_pairs(self.mechanism, self.bodies, found, pairs);
    }

    /// The solution without magnitudes, that by each, and the equations of the magnitudes, with all coefficients times `part`.
    fn equations(
        &self,
        loads: &[Wrench<f64>],
        shifts: &[f64],
        unknowns: &[Modulus],
        part: f64,
    ) -> Result<(Solution, Vec<Solution>, Moduli), f64> {
        let shifts: Vec<f64> = shifts.iter().map(|shift| part * shift).collect();
        let base = self.system.solve(self.bodies, loads, &shifts)?;
        let each = unknowns.iter().map(|unknown| {
            let mut own = vec![Wrench::ZERO; loads.len()];
            self.load(unknown, part, &mut own);
            self.system.solve(self.bodies, &own, &shifts)
        });
        let each = each.collect::<Result<Vec<_>, _>>()?;
        let widths = unknowns.iter().map(|unknown| match unknown.kind {
            Kind::Journal(_) => Width::Two,
            Kind::Press { .. } => Width::One,
        });
        let slopes =
            unknowns.iter().map(|unknown| each.iter().map(|one| self.vector(unknown, one)).collect());
        let moduli = Moduli {
            widths: widths.collect(),
            constants: unknowns.iter().map(|unknown| self.vector(unknown, &base)).collect(),
            slopes: slopes.collect(),
        };
        Ok((base, each, moduli))
    }

    /// Loads of the friction of a magnitude of size 1.
    fn load(&self, unknown: &Modulus, part: f64, loads: &mut [Wrench<f64>]) {
        let ([link, on], factor) = (unknown.links, part * unknown.factor);
        match (&unknown.kind, unknown.pair) {
            (Kind::Journal(radius), _) => {
                loads[link].m -= factor * radius;
                loads[on].m += factor * radius;
            }
            (Kind::Press { .. }, PairId::Slide(id)) => {
                let slide = &self.mechanism.slides[id];
                let (a, b) = (&self.bodies[link], &self.bodies[on]);
                let [x, y] = b.arm([elementary::cos(slide.angle), elementary::sin(slide.angle)]);
                let force = [-factor * x, -factor * y];
                let place = a.point(slide.point);
                loads[link].add_at([place[0] - a.x, place[1] - a.y], force, 0.0);
                loads[on].add_at([place[0] - b.x, place[1] - b.y], [-force[0], -force[1]], 0.0);
            }
            (Kind::Press { .. }, PairId::Pin(_)) => {}
        }
    }

    /// The vector of which a magnitude is the length.
    fn vector(&self, unknown: &Modulus, solution: &Solution) -> [f64; 2] {
        match (&unknown.kind, unknown.pair) {
            (Kind::Press { part, by_moment, middle }, PairId::Slide(id)) => {
                let (slide, found) = (&self.mechanism.slides[id], &solution.slides[id]);
                let [a, b] = unknown.links.map(|link| &self.bodies[link]);
                let [x, y] = b.arm([elementary::cos(slide.angle), elementary::sin(slide.angle)]);
                let normal = x * found.fy - y * found.fx;
                let moment = match middle {
                    Middle::Point => found.m,
                    Middle::Through => {
                        let [p, q] = [a.point(slide.point), b.point(slide.through)];
                        found.m + (x * (p[0] - q[0]) + y * (p[1] - q[1])) * normal
                    }
                };
                [part * normal + by_moment * moment, 0.0]
            }
            (_, PairId::Pin(point)) => self.system.force_on(solution, point, unknown.links[0]),
            _ => [0.0; 2],
        }
    }
}

/// Adds the forces and moments of friction to the reactions in the pairs.
fn add_to_pairs(mechanism: &Mechanism, bodies: &[Body<f64>], found: &Found, pairs: &mut [Wrench<f64>]) {
    let shifts = shifts(mechanism, found);
    for (bearing, force) in found.frictions.bearings.iter().zip(&found.forces) {
        for &(pair, sign) in &bearing.path {
            match bearing.pair {
                PairId::Pin(_) => pairs[pair].m += sign * force,
                PairId::Slide(id) => {
                    let slide = &mechanism.slides[id];
                    let [x, y] =
                        bodies[slide.on].arm([elementary::cos(slide.angle), elementary::sin(slide.angle)]);
                    pairs[pair].m += shifts[id] * (x * pairs[pair].fy - y * pairs[pair].fx);
                    pairs[pair].fx += force * x;
                    pairs[pair].fy += force * y;
                }
            }
        }
    }
}
