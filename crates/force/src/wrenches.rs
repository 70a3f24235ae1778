//! Loads as wrenches on the links.

use assur_group::plane::{minus, opposite, scaled, vector};
use assur_group::{Body, Wrench};

use crate::LoadNumber;
use crate::choice::Live;
use crate::loads::{Cause, Loads, Mass};
use crate::visit::{Sink, Visit};

/// Adds up loads about the origins of the bodies.
struct Sum<'a, T>(&'a mut [Wrench<T>]);

impl<T: LoadNumber> Sink<T> for Sum<'_, T> {
    #[inline]
    fn force(&mut self, link: usize, _body: &Body<T>, arm: [T; 2], force: [T; 2]) {
        self.0[link].add_at(arm, force, T::ZERO);
    }

    #[inline]
    fn moment(&mut self, link: usize, _body: &Body<T>, moment: T) {
        self.0[link].m += moment;
    }
}

/// Passes on each load with its cause.
struct Each<'a, T> {
    cause: Option<Cause>,
    hand_on: &'a mut dyn FnMut(Cause, usize, Wrench<T>),
}

impl<T: LoadNumber> Each<'_, T> {
    fn give(&mut self, link: usize, wrench: Wrench<T>) {
        if let Some(cause) = self.cause {
            (self.hand_on)(cause, link, wrench);
        }
    }
}

impl<T: LoadNumber> Sink<T> for Each<'_, T> {
    fn cause(&mut self, cause: Cause) {
        self.cause = Some(cause);
    }

    fn force(&mut self, link: usize, _body: &Body<T>, arm: [T; 2], force: [T; 2]) {
        let mut wrench = Wrench::ZERO;
        wrench.add_at(arm, force, T::ZERO);
        self.give(link, wrench);
    }

    fn moment(&mut self, link: usize, _body: &Body<T>, moment: T) {
        self.give(link, Wrench { m: moment, ..Wrench::ZERO });
    }
}

/// Speed and acceleration of the input.
#[derive(Clone, Copy)]
struct Rates<T> {
    speed: T,
    /// Speed squared.
    square: T,
    acceleration: T,
}

impl<T: LoadNumber> Rates<T> {
    #[inline]
    fn of(states: &T::States) -> Self {
        let speed = T::of_lanes(|lane| T::state(states, lane).speed);
        let acceleration = T::of_lanes(|lane| T::state(states, lane).acceleration);
        Self { speed, square: speed * speed, acceleration }
    }

    /// Whether the input is at rest, in all lanes, and stays there.
    #[inline]
    fn rests(&self) -> bool {
        self.square.greatest() == 0.0 && self.acceleration.abs().greatest() == 0.0
    }

    /// Acceleration of a link: of the point at this arm from its origin, m/s², and of its angle, rad/s².
    #[inline]
    fn accelerations(&self, body: &Body<T>, arm: [T; 2]) -> ([T; 2], T) {
        let turn = body.w1 * self.speed;
        let centripetal = turn * turn;
        let angular = body.w2 * self.square + body.w1 * self.acceleration;
        let x = body.x2 * self.square + body.x1 * self.acceleration;
        let y = body.y2 * self.square + body.y1 * self.acceleration;
        let of_point =
            [x - angular * arm[1] - centripetal * arm[0], y + angular * arm[0] - centripetal * arm[1]];
        (of_point, angular)
    }
}

impl Loads {
    /// Writes all loads of a state, weights and inertia loads among them: one wrench for each link, about the origin of
    /// its frame.
    ///
    /// Of loads on the ground, only those of springs fixed to it are included.
    #[inline]
    pub fn evaluate<T: LoadNumber>(
        &self,
        states: &T::States,
        bodies: &[Body<T>],
        wrenches: &mut [Wrench<T>],
    ) {
        wrenches.fill(Wrench::ZERO);
        let rates = Rates::of(states);
        let rests = rates.rests();
        if !rests || self.has_weights() {
            let gravity = vector(self.gravity);
            for mass in &self.masses {
                let body = &bodies[mass.link];
                let arm = body.arm(vector(mass.center));
                let (linear, angular) =
                    if rests { ([T::ZERO; 2], T::ZERO) } else { rates.accelerations(body, arm) };
                let force = scaled(T::from_f64(mass.m), minus(gravity, linear));
                wrenches[mass.link].add_at(arm, force, -(T::from_f64(mass.inertia) * angular));
            }
        }
        Visit { loads: self, choice: &Live, states, bodies }.each(&mut Sum(wrenches));
    }

    /// All loads of a state as [`evaluate`](Self::evaluate) writes them.
    pub fn total<T: LoadNumber>(&self, states: &T::States, bodies: &[Body<T>]) -> Vec<Wrench<T>> {
        let mut wrenches = vec![Wrench::ZERO; bodies.len()];
        self.evaluate(states, bodies, &mut wrenches);
        wrenches
    }

    /// Each load by itself: its cause, its link, and its wrench about the origin of the link's frame. A cause occurs
    /// once for every link that it loads (a spring twice); inertia loads are last.
    pub fn by_cause<T: LoadNumber>(
        &self,
        states: &T::States,
        bodies: &[Body<T>],
        hand_on: &mut dyn FnMut(Cause, usize, Wrench<T>),
    ) {
        let mut each = Each { cause: None, hand_on };
        if self.has_weights() {
            for mass in self.masses.iter().filter(|mass| mass.m > 0.0) {
                let body = &bodies[mass.link];
                each.cause(Cause::Weight(mass.link));
                each.force(mass.link, body, body.arm(vector(mass.center)), mass.weight(self.gravity));
            }
        }
        Visit { loads: self, choice: &Live, states, bodies }.each(&mut each);
        let rates = Rates::of(states);
        if rates.rests() {
            return;
        }
        for mass in &self.masses {
            (each.hand_on)(
                Cause::Inertia(mass.link),
                mass.link,
                mass.inertia_load(&rates, &bodies[mass.link]),
            );
        }
    }

    /// Adds the inertia loads -m a, -I e of the links alone to wrenches about the origins of their frames.
    pub fn inertia<T: LoadNumber>(&self, states: &T::States, bodies: &[Body<T>], wrenches: &mut [Wrench<T>]) {
        let rates = Rates::of(states);
        for mass in &self.masses {
            let Wrench { fx, fy, m } = mass.inertia_load(&rates, &bodies[mass.link]);
            wrenches[mass.link].add_at([T::ZERO; 2], [fx, fy], m);
        }
    }

    fn has_weights(&self) -> bool {
        self.gravity != [0.0, 0.0]
    }
}

impl Mass {
    /// The inertia load about the origin of the link's frame.
    fn inertia_load<T: LoadNumber>(&self, rates: &Rates<T>, body: &Body<T>) -> Wrench<T> {
        let arm = body.arm(vector(self.center));
        let (linear, angular) = rates.accelerations(body, arm);
        let mut wrench = Wrench::ZERO;
        let force = opposite(scaled(T::from_f64(self.m), linear));
        wrench.add_at(arm, force, -(T::from_f64(self.inertia) * angular));
        wrench
    }

    /// The weight of the link, N.
    pub(crate) fn weight<T: LoadNumber>(&self, gravity: [f64; 2]) -> [T; 2] {
        scaled(T::from_f64(self.m), vector(gravity))
    }
}
