//! Loads as wrenches on the links.

use assur_group::plane::{minus, perp, plus, scaled, vector};
use assur_group::{Body, Wrench};

use crate::choice::{Choice, Live};
use crate::loads::{Cause, Loads, Mass};
use crate::visit::{Sink, Visit};
use crate::{LoadError, LoadFault, LoadNumber, LoadState, Phase};
use assur_mechanism::Mechanism;

/// Adds up loads about the origins of the bodies.
struct Sum<'a, T>(&'a mut [Wrench<T>]);

impl<T: LoadNumber> Sink<T> for Sum<'_, T> {
    #[inline(always)]
    fn force(&mut self, _: Cause, link: usize, _: &Body<T>, arm: [T; 2], force: [T; 2]) {
        self.0[link].add_at(arm, force, T::ZERO);
    }

    #[inline(always)]
    fn moment(&mut self, _: Cause, link: usize, _: &Body<T>, moment: T) {
        self.0[link].m += moment;
    }
}

/// Passes on each load with its cause and the arm of its force.
struct Each<'a, T>(&'a mut dyn FnMut(Cause, usize, Wrench<T>, Option<[T; 2]>));

impl<T: LoadNumber> Sink<T> for Each<'_, T> {
    fn force(&mut self, cause: Cause, link: usize, _: &Body<T>, arm: [T; 2], force: [T; 2]) {
        let mut wrench = Wrench::ZERO;
        wrench.add_at(arm, force, T::ZERO);
        (self.0)(cause, link, wrench, Some(arm));
    }

    fn moment(&mut self, cause: Cause, link: usize, _: &Body<T>, moment: T) {
        (self.0)(cause, link, Wrench { m: moment, ..Wrench::ZERO }, None);
    }
}

/// Passes on the size of each load.
struct Sizes<'a, T>(&'a mut dyn FnMut(Cause, T));

impl<T: LoadNumber> Sink<T> for Sizes<'_, T> {
    const SIZES: bool = true;

    fn size(&mut self, cause: Cause, size: T) {
        (self.0)(cause, size);
    }

    fn force(&mut self, _: Cause, _: usize, _: &Body<T>, _: [T; 2], _: [T; 2]) {}

    fn moment(&mut self, _: Cause, _: usize, _: &Body<T>, _: T) {}
}

/// Speed and acceleration of the input.
struct Rates<T> {
    speed: T,
    square: T,
    acceleration: T,
    /// The input is at rest, in all lanes, and stays there.
    rests: bool,
}

impl<T: LoadNumber> Rates<T> {
    #[inline(always)]
    fn of(states: &T::States) -> Self {
        let speed = T::of_lanes(|lane| T::state(states, lane).speed);
        let acceleration = T::of_lanes(|lane| T::state(states, lane).acceleration);
        let square = speed * speed;
        let rests = (square + acceleration.abs()).greatest() == 0.0;
        Self { speed, square, acceleration, rests }
    }

    /// A second derivative with respect to time from both derivatives with respect to the coordinate.
    #[inline(always)]
    fn second(&self, first: T, second: T) -> T {
        second * self.square + first * self.acceleration
    }
}

impl<T: LoadNumber, C: Choice> Visit<'_, T, C> {
    /// Writes the wrenches of all loads.
    #[inline(always)]
    fn wrenches(self, wrenches: &mut [Wrench<T>]) {
        T::evaluate(
            #[inline(always)]
            move || {
                let Self { loads, states, bodies, .. } = self;
                wrenches.fill(Wrench::ZERO);
                let (gravity, rates) = (vector(loads.gravity), Rates::of(states));
                if !rates.rests || loads.has_weights() {
                    for mass in &loads.masses {
                        let Wrench { fx, fy, m } = mass.load(states, gravity, &rates, &bodies[mass.link]);
                        wrenches[mass.link].add_at([T::ZERO; 2], [fx, fy], m);
                    }
                }
                self.each(&mut Sum(wrenches));
            },
        );
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
        Visit { loads: self, choice: &Live, states, bodies }.wrenches(wrenches);
    }

    /// As [`evaluate`](Self::evaluate), by the formulas of one phase, continued smoothly beyond its bounds.
    pub fn evaluate_in_phase(
        &self,
        phase: &Phase,
        state: &LoadState,
        bodies: &[Body<f64>],
        wrenches: &mut [Wrench<f64>],
    ) {
        Visit { loads: self, choice: phase, states: state, bodies }.wrenches(wrenches);
    }

    /// All loads of a state as [`evaluate`](Self::evaluate) writes them.
    pub fn total<T: LoadNumber>(&self, states: &T::States, bodies: &[Body<T>]) -> Vec<Wrench<T>> {
        let mut wrenches = vec![Wrench::ZERO; self.links];
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
        self.each_at(states, bodies, &mut |cause, link, wrench, _| hand_on(cause, link, wrench));
    }

    /// As [`by_cause`](Self::by_cause), with the arm of each force but those of inertia.
    pub(crate) fn each_at<T: LoadNumber>(
        &self,
        states: &T::States,
        bodies: &[Body<T>],
        hand_on: &mut dyn FnMut(Cause, usize, Wrench<T>, Option<[T; 2]>),
    ) {
        let mut each = Each(&mut *hand_on);
        if self.has_weights() {
            for mass in self.masses.iter().filter(|mass| mass.m > 0.0) {
                let (link, body) = (mass.link, &bodies[mass.link]);
                let (arm, weight) = (body.arm(vector(mass.center)), mass.weight(self.gravity));
                each.force(Cause::Weight(link), link, body, arm, weight);
            }
        }
        Visit { loads: self, choice: &Live, states, bodies }.each(&mut each);
        self.inertia_of_each(states, bodies, |link, wrench| {
            hand_on(Cause::Inertia(link), link, wrench, None);
        });
    }

    /// Whether all loads of a state have finite values.
    ///
    /// # Errors
    ///
    /// [`LoadFault::NotFinite`] with the first load of the scene that has none.
    pub fn finite(
        &self,
        mechanism: &Mechanism,
        state: &LoadState,
        bodies: &[Body<f64>],
    ) -> Result<(), LoadError> {
        let mut without = None;
        self.by_cause(state, bodies, &mut |cause, _, Wrench { fx, fy, m }| {
            if without.is_none() && !(fx.is_finite() && fy.is_finite() && m.is_finite()) {
                without = Some(cause);
            }
        });
        let fault = LoadFault::NotFinite(state.coordinate);
        let error = |cause: Cause| LoadError { load: cause.name(mechanism).into(), fault };
        without.map_or(Ok(()), |cause| Err(error(cause)))
    }

    /// The size of each applied load of a state: of a force along its direction (or against the motion), of a moment
    /// counter-clockwise, of a contact its force F, of a spring its tension; N or N m. Loads that act in no lane are left
    /// out.
    pub fn sizes<T: LoadNumber>(
        &self,
        states: &T::States,
        bodies: &[Body<T>],
        mut hand_on: impl FnMut(Cause, T),
    ) {
        Visit { loads: self, choice: &Live, states, bodies }.each(&mut Sizes(&mut hand_on));
    }

    /// Adds the inertia loads -m a, -I e of the links alone to wrenches about the origins of their frames; of a moment of inertia
    /// I(q) the moment is -I (phi' e + phi'' w²) - I' phi' w² / 2.
    pub fn inertia<T: LoadNumber>(&self, states: &T::States, bodies: &[Body<T>], wrenches: &mut [Wrench<T>]) {
        self.inertia_of_each(states, bodies, |link, Wrench { fx, fy, m }| {
            wrenches[link].add_at([T::ZERO; 2], [fx, fy], m);
        });
    }

    pub(crate) fn inertia_of_each<T: LoadNumber>(
        &self,
        states: &T::States,
        bodies: &[Body<T>],
        mut hand_on: impl FnMut(usize, Wrench<T>),
    ) {
        let rates = Rates::of(states);
        if !rates.rests {
            for mass in &self.masses {
                hand_on(mass.link, mass.load(states, [T::ZERO; 2], &rates, &bodies[mass.link]));
            }
        }
    }

    pub(crate) fn has_weights(&self) -> bool {
        self.gravity != [0.0, 0.0]
    }
}

impl Mass {
    /// Weight and inertia load about the origin of the link's frame.
    #[inline(always)]
    fn load<T: LoadNumber>(
        &self,
        states: &T::States,
        gravity: [T; 2],
        rates: &Rates<T>,
        body: &Body<T>,
    ) -> Wrench<T> {
        let m = T::from_f64(self.m);
        if rates.rests {
            let mut wrench = Wrench::ZERO;
            wrench.add_at(body.arm(vector(self.center)), scaled(m, gravity), T::ZERO);
            return wrench;
        }
        let angular = rates.second(body.w1, body.w2);
        let origin = [rates.second(body.x1, body.x2), rates.second(body.y1, body.y2)];
        let mut moment = -(T::from_f64(self.inertia) * angular);
        if let Some([inertia, slope]) = self.varying_at::<T>(states) {
            moment -= inertia * angular + (slope * body.w1 * rates.square).half();
        }
        if self.at_origin {
            let [fx, fy] = scaled(m, minus(gravity, origin));
            return Wrench { fx, fy, m: moment };
        }
        let arm = body.arm(vector(self.center));
        let turn = body.w1 * rates.speed;
        let about = plus(scaled(angular, perp(arm)), scaled(-(turn * turn), arm));
        let mut wrench = Wrench::ZERO;
        wrench.add_at(arm, scaled(m, minus(gravity, plus(origin, about))), moment);
        wrench
    }

    /// The weight of the link, N.
    #[inline(always)]
    pub(crate) fn weight<T: LoadNumber>(&self, gravity: [f64; 2]) -> [T; 2] {
        scaled(T::from_f64(self.m), vector(gravity))
    }
}
