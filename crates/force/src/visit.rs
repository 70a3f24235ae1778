//! One pass over the applied loads, with a collector: of wrenches, of power, by cause.

use assur_group::Body;
use assur_group::plane::{dot, minus, opposite, plus, scaled, vector};

use assur_mechanism::Brake;

use crate::LoadNumber;
use crate::choice::{Choice, Formulas};
use crate::law::Law;
use crate::loads::{Along, ArcContact, Cause, Loads, PointForce, SpringDamper};

/// Collects loads. A force acts at `arm` from the origin of the body; everything in the ground's frame.
pub(crate) trait Sink<T> {
    /// The cause of the following calls.
    #[inline(always)]
    fn cause(&mut self, _cause: Cause) {}
    /// A force, N.
    fn force(&mut self, link: usize, body: &Body<T>, arm: [T; 2], force: [T; 2]);
    /// A moment, N m.
    fn moment(&mut self, link: usize, body: &Body<T>, moment: T);
    /// Whether the [size](Self::size) of each load is wanted.
    const SIZES: bool = false;
    /// The size of a load: of a force along its direction (or against the motion), of a moment, of a contact, N or N m; of a
    /// spring its tension.
    #[inline]
    fn size(&mut self, _size: T) {}
}

/// The states at which the loads are visited, and which formulas apply there.
pub(crate) struct Visit<'a, T: LoadNumber, C> {
    pub(crate) loads: &'a Loads,
    pub(crate) choice: &'a C,
    pub(crate) states: &'a T::States,
    pub(crate) bodies: &'a [Body<T>],
}

impl<T: LoadNumber, C: Choice> Visit<'_, T, C> {
    /// Passes on all applied loads except weights.
    #[inline(always)]
    pub(crate) fn each<S: Sink<T>>(&self, sink: &mut S) {
        let loads = self.loads;
        for (index, force) in loads.forces.iter().enumerate() {
            self.force(index, force, sink);
        }
        for (index, moment) in loads.moments.iter().enumerate() {
            let size = match &moment.brake {
                None => self.size(loads.forces.len() + index, [T::ZERO; 2]),
                Some((brake, _)) => self.brake(loads.forces.len() + index, moment.link, brake),
            };
            sink.cause(Cause::Moment(moment.id));
            sink.size(size);
            sink.moment(moment.link, &self.bodies[moment.link], size);
        }
        for spring in &loads.springs {
            self.spring(spring, sink);
        }
        for (index, contact) in loads.contacts.iter().enumerate() {
            self.contact(index, contact, sink);
        }
    }

    /// The size of a load by its law; `point`: its place, m.
    #[inline(always)]
    fn size(&self, law: usize, point: [T; 2]) -> T {
        match &self.loads.laws[law] {
            Law::Constant(value) => T::from_f64(*value),
            _ => self.by_lane(|formulas, lane| self.value(formulas, law, lane, point)),
        }
    }

    /// A number that is found for each lane by the formulas that apply there.
    #[inline(always)]
    fn by_lane(&self, number: impl Fn(&C::Formulas, usize) -> f64) -> T {
        T::of_lanes(|lane| {
            let state = T::state(self.states, lane);
            self.choice.weigh(self.loads, state, |formulas| number(formulas, lane))
        })
    }

    #[inline(always)]
    fn value(&self, formulas: &C::Formulas, law: usize, lane: usize, point: [T; 2]) -> f64 {
        let state = T::state(self.states, lane);
        let active = formulas.active(self.loads, law, state);
        self.loads.laws[law].value(active, state, [point[0].lane(lane), point[1].lane(lane)])
    }

    #[inline(always)]
    fn force<S: Sink<T>>(&self, index: usize, force: &PointForce, sink: &mut S) {
        let body = &self.bodies[force.at.link];
        let arm = body.arm(vector(force.at.at));
        let point = plus([body.x, body.y], arm);
        let along = match force.along {
            Along::Ground(unit) => scaled(self.size(index, point), vector(unit)),
            Along::Link(unit) => scaled(self.size(index, point), body.turned(vector(unit))),
            Along::AgainstMotion => {
                let (first, second) = (body.first(arm), body.second(arm));
                let (length, curvature) = (dot(first, first).sqrt(), dot(second, second).sqrt());
                let per_length = self.by_lane(|formulas, lane| {
                    let lengths = [length.lane(lane), curvature.lane(lane)];
                    if lengths[0] == 0.0 {
                        return 0.0;
                    }
                    let turn = formulas.against(self.loads, index, T::state(self.states, lane), lengths);
                    turn * self.value(formulas, index, lane, point) / lengths[0]
                });
                scaled(per_length, first)
            }
        };
        sink.cause(Cause::Force(force.id));
        if S::SIZES {
            sink.size(match force.along {
                Along::Ground(_) | Along::Link(_) => self.size(index, point),
                Along::AgainstMotion => {
                    let lengths = [body.first(arm), body.second(arm)].map(|of| dot(of, of).sqrt());
                    self.by_lane(|formulas, lane| {
                        let lengths = lengths.map(|length| length.lane(lane));
                        let turn = formulas.against(self.loads, index, T::state(self.states, lane), lengths);
                        turn.abs() * self.value(formulas, index, lane, point)
                    })
                }
            });
        }
        sink.force(force.at.link, body, arm, along);
    }

    /// The moment of a brake, against the rotation of its link.
    #[inline]
    fn brake(&self, index: usize, link: usize, brake: &Brake) -> T {
        let body = &self.bodies[link];
        self.by_lane(|formulas, lane| {
            let [w1, w2] = [body.w1, body.w2].map(|number| number.lane(lane));
            // Of the rim of the disc, for the comparison with lengths.
            let lengths = [w1, w2].map(|number| brake.radius * number.abs());
            let turn = formulas.against(self.loads, index, T::state(self.states, lane), lengths);
            let sense = if w1 < 0.0 { -turn } else { turn };
            sense * brake.lever() * self.value(formulas, index, lane, [T::ZERO; 2])
        })
    }

    /// The two forces of a spring with a damper.
    #[inline(always)]
    fn spring<S: Sink<T>>(&self, spring: &SpringDamper, sink: &mut S) {
        let [one, two] = [&self.bodies[spring.ends[0].link], &self.bodies[spring.ends[1].link]];
        let arms = [one.arm(vector(spring.ends[0].at)), two.arm(vector(spring.ends[1].at))];
        let between = minus(plus([two.x, two.y], arms[1]), plus([one.x, one.y], arms[0]));
        let length = dot(between, between).sqrt();
        let mut tension = T::from_f64(spring.stiffness) * (length - T::from_f64(spring.length));
        if spring.damping != 0.0 {
            let speed = T::of_lanes(|lane| T::state(self.states, lane).speed);
            let apart = minus(two.first(arms[1]), one.first(arms[0]));
            tension += T::from_f64(spring.damping) * (dot(between, apart) / length) * speed;
        }
        let per_length = tension / length;
        // A spring without length has no direction: neither its free length nor its damper gives a force.
        let per_length =
            T::of_lanes(|lane| if length.lane(lane) == 0.0 { 0.0 } else { per_length.lane(lane) });
        let pull = scaled(per_length, between);
        sink.cause(Cause::Spring(spring.id));
        sink.size(tension);
        sink.force(spring.ends[0].link, one, arms[0], pull);
        sink.force(spring.ends[1].link, two, arms[1], opposite(pull));
    }

    #[inline(always)]
    fn contact<S: Sink<T>>(&self, index: usize, contact: &ArcContact, sink: &mut S) {
        let touches = |formulas: &C::Formulas, lane: usize| {
            formulas.touches(self.loads, index, T::state(self.states, lane))
        };
        let share = self.by_lane(|formulas, lane| f64::from(u8::from(touches(formulas, lane))));
        if share.greatest() == 0.0 {
            return;
        }
        let body = &self.bodies[contact.center.link];
        let center = body.arm(vector(contact.center.at));
        let point = plus([body.x, body.y], center);
        let law = self.loads.forces.len() + self.loads.moments.len() + index;
        let size =
            self.by_lane(
                |formulas, lane| {
                    if touches(formulas, lane) { self.value(formulas, law, lane, point) } else { 0.0 }
                },
            );
        let (s, c) = self.size(law + self.loads.contacts.len(), point).sin_cos();
        let arm = minus(center, scaled(T::from_f64(contact.radius), [s, c]));
        let friction = match &contact.sliding {
            None => T::from_f64(contact.friction),
            Some(sliding) => self.by_lane(|formulas, lane| {
                contact.friction * formulas.rubs(self.loads, sliding, index, T::state(self.states, lane))
            }),
        };
        let along = [s + friction * c, c - friction * s];
        sink.cause(Cause::Contact(contact.id));
        sink.size(size);
        sink.force(contact.center.link, body, arm, scaled(size, along));
    }
}

impl SpringDamper {
    /// Energy stored in the spring, J.
    pub(crate) fn energy<T: LoadNumber>(&self, bodies: &[Body<T>]) -> T {
        let stretch = self.span(bodies) - T::from_f64(self.length);
        (T::from_f64(self.stiffness) * stretch * stretch).half()
    }

    /// Size of the terms of which the stored energy consists: it is small where the spring is nearly free, J.
    pub(crate) fn terms_of_energy(&self, bodies: &[Body<f64>]) -> f64 {
        0.5 * self.stiffness * (self.span(bodies) + self.length).powi(2)
    }

    /// Distance of the ends, m.
    fn span<T: LoadNumber>(&self, bodies: &[Body<T>]) -> T {
        let [a, b] = self.ends.map(|end| bodies[end.link].point(vector(end.at)));
        let between = minus(b, a);
        dot(between, between).sqrt()
    }
}
