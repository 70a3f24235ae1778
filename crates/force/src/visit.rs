//! One walk over the applied loads, for whoever collects them: as wrenches, as power, by cause.

use assur_group::Body;

use crate::law::Active;
use crate::loads::{Along, ArcContact, Cause, Loads, PointForce, SpringDamper};
use crate::{Phase, State};

/// Collects loads. A force acts at `arm` from the origin of the body; everything in the ground's frame.
pub(crate) trait Sink {
    /// What the next calls belong to.
    #[inline]
    fn cause(&mut self, _cause: Cause) {}
    /// A force, N.
    fn force(&mut self, link: usize, body: &Body<f64>, arm: [f64; 2], force: [f64; 2]);
    /// A moment, N m.
    fn moment(&mut self, link: usize, body: &Body<f64>, moment: f64);
}

/// Says which formula of each load holds.
pub(crate) trait Choice {
    /// Of a law.
    fn active(&self, loads: &Loads, law: usize, state: &State) -> Active;
    /// Whether a contact touches.
    fn touches(&self, loads: &Loads, contact: usize, state: &State) -> bool;
    /// By what a force against the motion multiplies the unit vector of PF1; 0 where the point stands.
    fn against(&self, loads: &Loads, force: usize, state: &State, pf: [[f64; 2]; 2]) -> f64;
}

/// Chooses by the state itself.
pub(crate) struct Live;

impl Choice for Live {
    #[inline]
    fn active(&self, loads: &Loads, law: usize, state: &State) -> Active {
        loads.laws[law].at(state, loads.sense_of(state), loads.period)
    }

    #[inline]
    fn touches(&self, loads: &Loads, contact: usize, state: &State) -> bool {
        loads.contacts[contact].touches(state.coordinate, loads.period)
    }

    #[inline]
    fn against(&self, loads: &Loads, _force: usize, state: &State, [first, second]: [[f64; 2]; 2]) -> f64 {
        /// A rest nearer than this, in the coordinate, is one: the difference is rounding.
        const AT_REST: f64 = 1e-12;
        let (v, a) = (first[0].hypot(first[1]), second[0].hypot(second[1]));
        if state.speed == 0.0 || v <= loads.standing.max(AT_REST * a) { 0.0 } else { -state.speed.signum() }
    }
}

impl Choice for Phase {
    #[inline]
    fn active(&self, _loads: &Loads, law: usize, _state: &State) -> Active {
        self.actives[law]
    }

    #[inline]
    fn touches(&self, _loads: &Loads, contact: usize, _state: &State) -> bool {
        self.contacts[contact]
    }

    #[inline]
    fn against(&self, _loads: &Loads, force: usize, state: &State, _pf: [[f64; 2]; 2]) -> f64 {
        let [low, high] = self.sides[force];
        // Beyond a rest PF1 has turned round; the formula of the piece has not.
        let within = state.coordinate >= low && state.coordinate <= high;
        if within { -self.sense } else { self.sense }
    }
}

impl Loads {
    /// Sense of the motion: of the speed, else of the input.
    #[inline]
    pub(crate) fn sense_of(&self, state: &State) -> f64 {
        if state.speed == 0.0 { self.sense } else { state.speed.signum() }
    }

    /// All applied loads except weights.
    #[inline]
    pub(crate) fn visit<C: Choice, S: Sink>(
        &self,
        choice: &C,
        state: &State,
        bodies: &[Body<f64>],
        sink: &mut S,
    ) {
        for (index, force) in self.forces.iter().enumerate() {
            self.visit_force(choice, index, force, state, &bodies[force.at.link], sink);
        }
        for (index, moment) in self.moments.iter().enumerate() {
            let law = self.forces.len() + index;
            let size = self.laws[law].value(choice.active(self, law, state), state, [0.0, 0.0]);
            sink.cause(Cause::Moment(moment.id));
            sink.moment(moment.link, &bodies[moment.link], size);
        }
        for spring in &self.springs {
            visit_spring(spring, state, bodies, sink);
        }
        for (index, contact) in self.contacts.iter().enumerate() {
            if choice.touches(self, index, state) {
                self.visit_contact(choice, index, contact, state, &bodies[contact.center.link], sink);
            }
        }
    }

    #[inline]
    fn visit_force<C: Choice, S: Sink>(
        &self,
        choice: &C,
        index: usize,
        force: &PointForce,
        state: &State,
        body: &Body<f64>,
        sink: &mut S,
    ) {
        let arm = body.arm(force.at.at);
        let point = [body.x + arm[0], body.y + arm[1]];
        let size = self.laws[index].value(choice.active(self, index, state), state, point);
        let along = match force.along {
            Along::Ground(unit) => unit,
            Along::Link(unit) => body.turned(unit),
            Along::AgainstMotion => {
                let first = body.first(arm);
                let length = first[0].hypot(first[1]);
                let turn = choice.against(self, index, state, [first, body.second(arm)]);
                if length == 0.0 { [0.0, 0.0] } else { [turn * first[0] / length, turn * first[1] / length] }
            }
        };
        sink.cause(Cause::Force(force.id));
        sink.force(force.at.link, body, arm, [size * along[0], size * along[1]]);
    }

    #[inline]
    fn visit_contact<C: Choice, S: Sink>(
        &self,
        choice: &C,
        index: usize,
        contact: &ArcContact,
        state: &State,
        body: &Body<f64>,
        sink: &mut S,
    ) {
        let center = body.arm(contact.center.at);
        let law = self.forces.len() + self.moments.len() + index;
        let point = [body.x + center[0], body.y + center[1]];
        let size = self.laws[law].value(choice.active(self, law, state), state, point);
        let arm = [center[0] + contact.to_contact[0], center[1] + contact.to_contact[1]];
        sink.cause(Cause::Contact(contact.id));
        sink.force(contact.center.link, body, arm, [size * contact.force[0], size * contact.force[1]]);
    }
}

/// The two forces of a spring with a damper.
#[inline]
fn visit_spring<S: Sink>(spring: &SpringDamper, state: &State, bodies: &[Body<f64>], sink: &mut S) {
    let [one, two] = spring.ends.map(|end| &bodies[end.link]);
    let arms = [one.arm(spring.ends[0].at), two.arm(spring.ends[1].at)];
    let pull = spring.pull(one, two, arms, state.speed);
    sink.cause(Cause::Spring(spring.id));
    sink.force(spring.ends[0].link, one, arms[0], pull);
    sink.force(spring.ends[1].link, two, arms[1], [-pull[0], -pull[1]]);
}

impl SpringDamper {
    /// Force on the first end, N: towards the second where the spring is stretched or is being stretched.
    #[inline]
    fn pull(&self, one: &Body<f64>, two: &Body<f64>, arms: [[f64; 2]; 2], speed: f64) -> [f64; 2] {
        let d = [two.x + arms[1][0] - one.x - arms[0][0], two.y + arms[1][1] - one.y - arms[0][1]];
        let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
        if length == 0.0 {
            // Without a direction a free length pushes nowhere, and a damper has no line to act along.
            return [0.0, 0.0];
        }
        let mut tension = self.stiffness * (length - self.length);
        if self.damping != 0.0 {
            let (v1, v2) = (one.first(arms[0]), two.first(arms[1]));
            let rate = (d[0] * (v2[0] - v1[0]) + d[1] * (v2[1] - v1[1])) / length;
            tension += self.damping * rate * speed;
        }
        let each = tension / length;
        [each * d[0], each * d[1]]
    }

    /// Energy stored in the spring, J.
    pub(crate) fn energy(&self, bodies: &[Body<f64>]) -> f64 {
        let [a, b] = self.ends.map(|end| bodies[end.link].point(end.at));
        let stretch = (b[0] - a[0]).hypot(b[1] - a[1]) - self.length;
        0.5 * self.stiffness * stretch * stretch
    }
}

impl ArcContact {
    /// Whether there is contact at a coordinate; both ends of the interval belong to it.
    #[inline]
    pub(crate) fn touches(&self, coordinate: f64, period: Option<f64>) -> bool {
        let rounding = crate::breaks::tolerance(coordinate, period);
        [coordinate + rounding, coordinate - rounding]
            .iter()
            .any(|q| self.breaks.interval(*q).index == self.touching)
    }
}
