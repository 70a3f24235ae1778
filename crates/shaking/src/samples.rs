//! Shaking force and moment, and what a unit counterweight adds, at one coordinate.

use std::f64::consts::TAU;

use assur_force::{LoadState, Loads};
use assur_group::plane::{minus, perp, plus, scaled};
use assur_group::{Body, Order, Wrench};
use assur_kinematics::{Linkage, Position, PositionError};
use assur_mechanism::{GROUND, LinkId};
use assur_number::elementary;

use crate::{ShakingError, data::Harmonic};

/// A link that turns about a pin on the ground, and so may carry a counterweight.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Carrier {
    pub(crate) link: LinkId,
    /// The pin in the frame of the ground, m.
    pub(crate) pin: [f64; 2],
    /// Greatest distance of a point of the link from the pin, m.
    pub(crate) radius: f64,
}

/// The links that turn about a pin on the ground, the input link first.
pub(crate) fn carriers(linkage: &Linkage) -> Vec<Carrier> {
    let mechanism = &linkage.mechanism;
    let carrier = |link: LinkId| {
        let pin = mechanism.points.iter().find_map(|point| {
            let place =
                |link: LinkId| point.places.iter().find(|place| place.link == link).map(|place| place.at);
            Some((place(GROUND)?, place(link)?))
        });
        let (pin, own) = pin?;
        let places = mechanism.points.iter().flat_map(|point| &point.places);
        let arms = places.filter(|place| place.link == link).map(|place| minus(place.at, own));
        let radius = arms.map(|[x, y]| elementary::hypot(x, y)).fold(0.0, f64::max);
        (radius > 0.0).then_some(Carrier { link, pin, radius })
    };
    let mut found: Vec<_> = (1..mechanism.links.len()).filter_map(carrier).collect();
    found.sort_by_key(|carrier| !mechanism.input.places(carrier.link));
    found
}

/// Forces and moments on the ground at one coordinate.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sample {
    pub(crate) coordinate: f64,
    /// Shaking force, N.
    pub(crate) force: [f64; 2],
    /// Shaking moment about the origin, N m.
    pub(crate) moment: f64,
    /// Sums of the magnitudes of the terms of force and moment.
    pub(crate) terms: Terms,
    /// What a unit counterweight on each carrier adds.
    pub(crate) units: Vec<Unit>,
}

/// Sums of the magnitudes of the terms of force (N) and moment (N m), by which their rounding is measured.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Terms {
    pub(crate) force: f64,
    pub(crate) moment: f64,
}

impl Sample {
    /// Force and moment with counterweights on the first carriers, given by their mass times radius in the frames of the
    /// links, kg m.
    pub(crate) fn balanced(&self, carriers: &[Carrier], products: &[[f64; 2]]) -> ([f64; 2], f64) {
        let (mut force, mut moment) = (self.force, self.moment);
        for ((unit, product), carrier) in self.units.iter().zip(products).zip(carriers) {
            let [x, y] = unit.force(*product);
            force = [force[0] + x, force[1] + y];
            moment += unit.moment(*product, carrier.radius);
        }
        (force, moment)
    }
}

/// The shaking force of a counterweight of 1 kg m: along the x axis of the link, and along its y axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit {
    pub(crate) forces: [[f64; 2]; 2],
    /// The pin, m.
    pin: [f64; 2],
    /// Shaking moment of 1 kg m² about the pin, N m.
    turning: f64,
}

impl Unit {
    fn of(carrier: &Carrier, body: &Body<f64>, state: &LoadState) -> Self {
        let (w, e) =
            (body.w1 * state.speed, body.w2 * state.speed * state.speed + body.w1 * state.acceleration);
        // -m a of a point at the arm r from the pin: m (w² r - e x r).
        let force = |axis: [f64; 2]| plus(scaled(w * w, axis), scaled(-e, perp(axis)));
        let along = [body.c, body.s];
        Self { forces: [force(along), force(perp(along))], pin: carrier.pin, turning: -e }
    }

    /// Modulus of the force of 1 kg m, N.
    pub(crate) fn size(&self) -> f64 {
        elementary::hypot(self.forces[0][0], self.forces[0][1])
    }

    /// Force of a counterweight, given by its mass times radius in the frame of the link, kg m.
    pub(crate) fn force(&self, product: [f64; 2]) -> [f64; 2] {
        plus(scaled(product[0], self.forces[0]), scaled(product[1], self.forces[1]))
    }

    /// Its moment about the origin when it is put at a radius, N m.
    pub(crate) fn moment(&self, product: [f64; 2], radius: f64) -> f64 {
        let [fx, fy] = self.force(product);
        self.pin[0] * fy - self.pin[1] * fx
            + self.turning * elementary::hypot(product[0], product[1]) * radius
    }
}

pub(crate) struct Sampler<'a> {
    pub(crate) linkage: &'a Linkage,
    loads: &'a Loads,
    state: &'a dyn Fn(f64) -> LoadState,
    pub(crate) carriers: Vec<Carrier>,
    position: Position,
    wrenches: Vec<Wrench<f64>>,
}

impl<'a> Sampler<'a> {
    pub(crate) fn new(linkage: &'a Linkage, loads: &'a Loads, state: &'a dyn Fn(f64) -> LoadState) -> Self {
        let (carriers, position) = (carriers(linkage), linkage.position());
        let wrenches = vec![Wrench::ZERO; position.bodies.len()];
        Self { linkage, loads, state, carriers, position, wrenches }
    }

    /// Forces and moments on the ground.
    pub(crate) fn at(&mut self, coordinate: f64) -> Result<Sample, PositionError> {
        self.linkage.solve(coordinate, Order::Second, &mut self.position)?;
        let (bodies, state) = (&self.position.bodies, (self.state)(coordinate));
        self.wrenches.fill(Wrench::ZERO);
        self.loads.inertia(&state, bodies, &mut self.wrenches);
        let (mut total, mut terms) = (Wrench::ZERO, Terms::default());
        for (body, wrench) in bodies.iter().zip(&self.wrenches) {
            total.add_at([body.x, body.y], wrench.force(), wrench.m);
            let force = elementary::hypot(wrench.fx, wrench.fy);
            terms.force += force;
            terms.moment += wrench.m.abs() + elementary::hypot(body.x, body.y) * force;
        }
        let units = self.carriers.iter().map(|carrier| Unit::of(carrier, &bodies[carrier.link], &state));
        Ok(Sample { coordinate, force: total.force(), moment: total.m, terms, units: units.collect() })
    }

    /// Forces and moments on the ground, and the torque (sliding input: force) that the input needs for the motion under all loads.
    pub(crate) fn driven(&mut self, coordinate: f64) -> Result<(Sample, f64), ShakingError> {
        let sample = self.at(coordinate)?;
        let (bodies, state) = (&self.position.bodies, (self.state)(coordinate));
        let reduced = self.loads.reduced(&state, bodies);
        let inertia = reduced.inertia * state.acceleration;
        let torque = inertia + 0.5 * reduced.inertia_derivative * state.speed * state.speed - reduced.moment;
        if !torque.is_finite() {
            self.loads.finite(&self.linkage.mechanism, &state, bodies)?;
        }
        Ok((sample, torque))
    }
}

/// Greatest order of a harmonic in the results.
const GREATEST: usize = 12;

/// Harmonics of the shaking force and moment and of the torque of the input. The samples are equally spaced over a cycle of the
/// length `period`.
pub(crate) fn harmonics(samples: &[(Sample, f64)], period: f64) -> Vec<Harmonic> {
    let count = samples.len() as f64;
    let of = |order: usize| {
        let factor = if order == 0 { 1.0 / count } else { 2.0 / count };
        let mut sum = Harmonic { order, ..Harmonic::default() };
        for (sample, torque) in samples {
            let (sin, cos) = elementary::sin_cos(order as f64 * TAU * sample.coordinate / period);
            let add = |to: &mut [f64; 2], value: f64| {
                to[0] += factor * value * cos;
                to[1] += factor * value * sin;
            };
            add(&mut sum.x, sample.force[0]);
            add(&mut sum.y, sample.force[1]);
            add(&mut sum.moment, sample.moment);
            add(&mut sum.torque, *torque);
        }
        sum
    };
    (0..=GREATEST).map(of).collect()
}
