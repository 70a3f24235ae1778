//! One pass over the applied loads, with a collector: of wrenches, of power, by cause.

use assur_group::Body;

use crate::law::Active;
use crate::loads::{Along, ArcContact, Cause, Loads, PointForce, SpringDamper};
use crate::selection::Selection;
use crate::state::Side;
use crate::{Phase, State};

/// Collects loads. A force acts at `arm` from the origin of the body; everything in the ground's frame.
pub(crate) trait Sink {
    /// The cause of the following calls.
    #[inline]
    fn cause(&mut self, _cause: Cause) {}
    /// A force, N.
    fn force(&mut self, link: usize, body: &Body<f64>, arm: [f64; 2], force: [f64; 2]);
    /// A moment, N m.
    fn moment(&mut self, link: usize, body: &Body<f64>, moment: f64);
}

/// Says which formula of each load is in use.
pub(crate) trait Choice {
    /// Of a law.
    fn active(&self, loads: &Loads, law: usize, state: &State) -> Active;
    /// Whether a contact touches.
    fn touches(&self, loads: &Loads, contact: usize, state: &State) -> bool;
    /// Factor of the unit vector of PF1 for a force against the motion; 0 where the point is at rest.
    fn against(&self, loads: &Loads, force: usize, state: &State, pf: [[f64; 2]; 2]) -> f64;
}

/// The formulas in use at a state.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Selections {
    /// Of one side.
    One(Selection),
    /// Of both sides, with their shares.
    Held([(f64, Selection); 2]),
}

impl Selections {
    /// Each with its share.
    #[inline]
    pub(crate) fn shares(&self) -> impl Iterator<Item = (f64, Selection)> {
        let (one, held) = match self {
            Self::One(selection) => (Some((1.0, *selection)), None),
            Self::Held(both) => (None, Some(*both)),
        };
        one.into_iter().chain(held.into_iter().flatten())
    }
}

impl Choice for Selection {
    #[inline]
    fn active(&self, loads: &Loads, law: usize, state: &State) -> Active {
        loads.laws[law].at(state, self, loads.period)
    }

    #[inline]
    fn touches(&self, loads: &Loads, contact: usize, state: &State) -> bool {
        let contact = &loads.contacts[contact];
        let ahead = self.coordinate(state, loads.period);
        let behind = 2.0 * state.coordinate - ahead;
        contact.touches(ahead) || (self.closed && contact.touches(behind))
    }

    #[inline]
    fn against(&self, loads: &Loads, _force: usize, _state: &State, [first, second]: [[f64; 2]; 2]) -> f64 {
        /// A rest within this distance of the coordinate is at the coordinate: the difference is rounding.
        const AT_REST: f64 = 1e-12;
        let (v, a) = (first[0].hypot(first[1]), second[0].hypot(second[1]));
        if !self.moves || v <= loads.standing.max(AT_REST * a) { 0.0 } else { -self.sense }
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
        // Beyond a rest PF1 has reversed; the formula of the piece has not.
        let within = state.coordinate >= low && state.coordinate <= high;
        if within { -self.sense } else { self.sense }
    }
}

impl Loads {
    /// The formulas in use at a state, with their shares: those of one side, or both where the motion is held.
    #[inline]
    pub(crate) fn selections(&self, state: &State) -> Selections {
        let (speed, acceleration) = (state.speed, state.acceleration);
        let sign = |value: f64| if value == 0.0 { 0.0 } else { value.signum() };
        let one = |ahead: f64| Selection {
            sense: [speed, ahead * acceleration, self.sense]
                .into_iter()
                .map(sign)
                .find(|s| *s != 0.0)
                .unwrap_or(1.0),
            ahead,
            speed_side: ahead * sign(acceleration),
            moves: speed != 0.0 || acceleration != 0.0,
            closed: false,
        };
        let held = |side: f64| Selection {
            sense: if speed == 0.0 { side } else { speed.signum() },
            speed_side: side,
            moves: true,
            ..one(1.0)
        };
        match state.side {
            Side::After => Selections::One(one(1.0)),
            Side::Before => Selections::One(one(-1.0)),
            Side::Held { upper } => Selections::Held([(1.0 - upper, held(-1.0)), (upper, held(1.0))]),
            Side::Prescribed => {
                Selections::One(Selection { speed_side: 0.0, moves: speed != 0.0, closed: true, ..one(1.0) })
            }
        }
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
            // A spring without length has no direction: neither its free length nor its damper gives a force.
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
    /// Whether there is contact at a coordinate.
    #[inline]
    fn touches(&self, coordinate: f64) -> bool {
        self.breaks.interval(coordinate).index == self.touching
    }
}
