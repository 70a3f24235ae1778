//! Loads as wrenches on the links.

use assur_group::{Body, Wrench};

use crate::State;
use crate::loads::{Cause, Loads};
use crate::visit::Sink;

/// Adds up loads about the origins of the bodies.
struct Sum<'a> {
    wrenches: &'a mut [Wrench<f64>],
    /// The factor of each load.
    share: f64,
}

impl Sink for Sum<'_> {
    #[inline]
    fn force(&mut self, link: usize, _body: &Body<f64>, arm: [f64; 2], force: [f64; 2]) {
        self.wrenches[link].add_at(arm, force.map(|f| self.share * f), 0.0);
    }

    #[inline]
    fn moment(&mut self, link: usize, _body: &Body<f64>, moment: f64) {
        self.wrenches[link].m += self.share * moment;
    }
}

/// Passes on each load with its cause.
struct Each<'a> {
    cause: Option<Cause>,
    /// The factor of each load.
    share: f64,
    hand_on: &'a mut dyn FnMut(Cause, usize, Wrench<f64>),
}

impl Each<'_> {
    fn give(&mut self, link: usize, wrench: Wrench<f64>) {
        if let Some(cause) = self.cause {
            let Wrench { fx, fy, m } = wrench;
            let share = self.share;
            (self.hand_on)(cause, link, Wrench { fx: share * fx, fy: share * fy, m: share * m });
        }
    }
}

impl Sink for Each<'_> {
    fn cause(&mut self, cause: Cause) {
        self.cause = Some(cause);
    }

    fn force(&mut self, link: usize, _body: &Body<f64>, arm: [f64; 2], force: [f64; 2]) {
        let mut wrench = Wrench::ZERO;
        wrench.add_at(arm, force, 0.0);
        self.give(link, wrench);
    }

    fn moment(&mut self, link: usize, _body: &Body<f64>, moment: f64) {
        self.give(link, Wrench { fx: 0.0, fy: 0.0, m: moment });
    }
}

impl Loads {
    /// Writes the applied loads and weights: one wrench for each link, about the origin of its frame.
    ///
    /// Of loads on the ground, only those of springs fixed to it are included.
    pub fn apply(&self, state: &State, bodies: &[Body<f64>], wrenches: &mut [Wrench<f64>]) {
        wrenches.fill(Wrench::ZERO);
        let mut sum = Sum { wrenches, share: 1.0 };
        self.weights(bodies, &mut sum);
        for (share, selection) in self.selections(state).shares() {
            sum.share = share;
            self.visit(&selection, state, bodies, &mut sum);
        }
    }

    /// Adds the inertia loads -m a, -I e of the links to wrenches about the origins of their frames.
    pub fn inertia(&self, state: &State, bodies: &[Body<f64>], wrenches: &mut [Wrench<f64>]) {
        self.inertia_to(state, bodies, &mut Sum { wrenches, share: 1.0 });
    }

    /// All loads, weights and inertia loads of a state: one wrench for each link, about the origin of its frame.
    pub fn total(&self, state: &State, bodies: &[Body<f64>]) -> Vec<Wrench<f64>> {
        let mut wrenches = vec![Wrench::ZERO; bodies.len()];
        self.apply(state, bodies, &mut wrenches);
        self.inertia(state, bodies, &mut wrenches);
        wrenches
    }

    /// Each load by itself: its cause, its link, and its wrench about the origin of the link's frame. A cause occurs
    /// once for every link that it loads (a spring twice), or as two shares where the motion is held; inertia loads are
    /// last.
    pub fn by_cause(
        &self,
        state: &State,
        bodies: &[Body<f64>],
        hand_on: &mut dyn FnMut(Cause, usize, Wrench<f64>),
    ) {
        let mut each = Each { cause: None, share: 1.0, hand_on };
        self.weights(bodies, &mut each);
        for (share, selection) in self.selections(state).shares() {
            each.share = share;
            self.visit(&selection, state, bodies, &mut each);
        }
        each.share = 1.0;
        self.inertia_to(state, bodies, &mut each);
    }

    #[inline]
    fn weights<S: Sink>(&self, bodies: &[Body<f64>], sink: &mut S) {
        if self.gravity == [0.0, 0.0] {
            return;
        }
        for mass in self.masses.iter().filter(|mass| mass.m > 0.0) {
            let body = &bodies[mass.link];
            sink.cause(Cause::Weight(mass.link));
            let weight = [mass.m * self.gravity[0], mass.m * self.gravity[1]];
            sink.force(mass.link, body, body.arm(mass.center), weight);
        }
    }

    #[inline]
    fn inertia_to<S: Sink>(&self, state: &State, bodies: &[Body<f64>], sink: &mut S) {
        let (square, e) = (state.speed * state.speed, state.acceleration);
        if square == 0.0 && e == 0.0 {
            return;
        }
        for mass in &self.masses {
            let body = &bodies[mass.link];
            let arm = body.arm(mass.center);
            let (first, second) = (body.first(arm), body.second(arm));
            let force = |i: usize| -mass.m * (second[i] * square + first[i] * e);
            sink.cause(Cause::Inertia(mass.link));
            sink.force(mass.link, body, arm, [force(0), force(1)]);
            sink.moment(mass.link, body, -mass.inertia * (body.w2 * square + body.w1 * e));
        }
    }
}
