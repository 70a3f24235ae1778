//! One pass over the applied loads, with a collector: of wrenches, of power, by cause.

use assur_group::Body;
use assur_group::plane::{dot, minus, opposite, plus, scaled, vector};

use assur_mechanism::Spring;
use assur_number::ROUNDING;

use crate::choice::{Choice, Formulas};
use crate::loads::{Action, Along, ArcContact, Cause, Loads, PointForce, Shoe};
use crate::{LoadNumber, law::Law};

/// Collects loads. A force acts at `arm` from the origin of the body; everything in the ground's frame.
pub(crate) trait Sink<T> {
    /// A force, N.
    fn force(&mut self, cause: Cause, link: usize, body: &Body<T>, arm: [T; 2], force: [T; 2]);
    /// A moment, N m.
    fn moment(&mut self, cause: Cause, link: usize, body: &Body<T>, moment: T);
    /// Whether the [size](Self::size) of each load is wanted.
    const SIZES: bool = false;
    /// The size of a load: of a force along its direction (or against the motion), of a moment, of a contact, N or N m; of a
    /// spring its tension.
    #[inline]
    fn size(&mut self, _cause: Cause, _size: T) {}
}

/// The states at which the loads are visited, and which formulas apply there.
pub(crate) struct Visit<'a, T: LoadNumber, C> {
    pub(crate) loads: &'a Loads,
    pub(crate) choice: &'a C,
    pub(crate) states: &'a T::States,
    pub(crate) bodies: &'a [Body<T>],
}

impl Loads {
    /// By which derivative a point moves, from the lengths of its PF1 and PF2: 0, or 1 where it turns; `None` where it stays at rest.
    #[inline(always)]
    fn moving(&self, [first, second]: [f64; 2]) -> Option<usize> {
        if first > self.standing.max(ROUNDING * second) {
            return Some(0);
        }
        (second > self.standing).then_some(1)
    }
}

impl<T: LoadNumber, C: Choice> Visit<'_, T, C> {
    /// Passes on all applied loads except weights.
    #[inline(always)]
    pub(crate) fn each<S: Sink<T>>(&self, sink: &mut S) {
        for (index, load) in self.loads.applied.iter().enumerate() {
            let cause = Cause::Load(load.id);
            match &load.action {
                Action::Force(force) => self.force((cause, index), force, sink),
                Action::Moment(link) => self.moment((cause, *link), self.size(index, [T::ZERO; 2]), sink),
                Action::Brake(shoe) => self.moment((cause, shoe.link), self.brake(index, shoe), sink),
                Action::Spring(spring) => self.spring(cause, spring, sink),
                Action::Contact(contact) => self.contact((cause, index), contact, sink),
            }
        }
    }

    /// The size of a load by its law; `point`: its place, m.
    #[inline(always)]
    fn size(&self, load: usize, point: [T; 2]) -> T {
        match &self.loads.applied[load].size {
            Law::Constant(value) => T::from_f64(*value),
            _ => self.by_lane(|formulas, lane| self.value(formulas, load, lane, point)),
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
    fn value(&self, formulas: &C::Formulas, load: usize, lane: usize, point: [T; 2]) -> f64 {
        let state = T::state(self.states, lane);
        let law = &self.loads.applied[load].size;
        if let Some(value) = self.loads.by_drive(law, state, [point[0].lane(lane), point[1].lane(lane)]) {
            return value;
        }
        let active = formulas.active(self.loads, (load, 0, law), state);
        law.value(active, state, [point[0].lane(lane), point[1].lane(lane)])
    }

    #[inline(always)]
    fn moment<S: Sink<T>>(&self, (cause, link): (Cause, usize), size: T, sink: &mut S) {
        sink.size(cause, size);
        sink.moment(cause, link, &self.bodies[link], size);
    }

    #[inline(always)]
    fn force<S: Sink<T>>(&self, (cause, index): (Cause, usize), force: &PointForce, sink: &mut S) {
        let body = &self.bodies[force.at.link];
        let arm = body.arm(vector(force.at.at));
        let point = plus([body.x, body.y], arm);
        let along = match force.along {
            Along::Ground(unit) => scaled(self.size(index, point), vector(unit)),
            Along::Link(unit) => scaled(self.size(index, point), body.turned(vector(unit))),
            Along::AgainstMotion => {
                let orders = [body.first(arm), body.second(arm)];
                let lengths = orders.map(|of| dot(of, of).sqrt());
                let lengths = |lane: usize| lengths.map(|length| length.lane(lane));
                let of = |part: fn(f64) -> f64| {
                    self.by_lane(|formulas, lane| {
                        let Some(order) = self.loads.moving(lengths(lane)) else { return 0.0 };
                        let state = T::state(self.states, lane);
                        let turn = part(formulas.against(self.loads, index, state, order == 1));
                        turn * self.value(formulas, index, lane, point)
                    })
                };
                if S::SIZES {
                    sink.size(cause, of(f64::abs));
                }
                let order = |lane: usize| self.loads.moving(lengths(lane)).unwrap_or(0);
                let length = T::of_lanes(|lane| lengths(lane)[order(lane)].max(f64::MIN_POSITIVE));
                let along = [0, 1].map(|axis| T::of_lanes(|lane| orders[order(lane)][axis].lane(lane)));
                scaled(of(|turn| turn) / length, along)
            }
        };
        if S::SIZES && !matches!(force.along, Along::AgainstMotion) {
            sink.size(cause, self.size(index, point));
        }
        sink.force(cause, force.at.link, body, arm, along);
    }

    /// The moment of a brake, against the rotation of its link.
    #[inline]
    fn brake(&self, index: usize, shoe: &Shoe) -> T {
        let body = &self.bodies[shoe.link];
        self.by_lane(|formulas, lane| {
            let [w1, w2] = [body.w1, body.w2].map(|number| number.lane(lane));
            let lengths = [w1, w2].map(|number| shoe.reach * number.abs());
            let Some(order) = self.loads.moving(lengths) else { return 0.0 };
            let turn = formulas.against(self.loads, index, T::state(self.states, lane), order == 1);
            let sense = if [w1, w2][order] < 0.0 { -turn } else { turn };
            sense * shoe.lever * self.value(formulas, index, lane, [T::ZERO; 2])
        })
    }

    /// The two forces of a spring with a damper.
    #[inline(always)]
    fn spring<S: Sink<T>>(&self, cause: Cause, spring: &Spring, sink: &mut S) {
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
        sink.size(cause, tension);
        sink.force(cause, spring.ends[0].link, one, arms[0], pull);
        sink.force(cause, spring.ends[1].link, two, arms[1], opposite(pull));
    }

    /// The angle of a contact, rad.
    #[inline(always)]
    fn angle(&self, index: usize, law: &Law) -> T {
        match law {
            Law::Constant(angle) => T::from_f64(*angle),
            _ => self.by_lane(|formulas, lane| {
                let state = T::state(self.states, lane);
                law.value(formulas.active(self.loads, (index, 1, law), state), state, [0.0; 2])
            }),
        }
    }

    #[inline(always)]
    fn contact<S: Sink<T>>(&self, (cause, index): (Cause, usize), contact: &ArcContact, sink: &mut S) {
        let touches = |formulas: &C::Formulas, lane: usize| {
            formulas.touches(self.loads, index, contact, T::state(self.states, lane))
        };
        let share = self.by_lane(|formulas, lane| f64::from(u8::from(touches(formulas, lane))));
        if share.greatest() == 0.0 {
            return;
        }
        let body = &self.bodies[contact.center.link];
        let center = body.arm(vector(contact.center.at));
        let point = plus([body.x, body.y], center);
        let size = self.by_lane(|formulas, lane| {
            if touches(formulas, lane) { self.value(formulas, index, lane, point) } else { 0.0 }
        });
        let (s, c) = self.angle(index, &contact.angle).sin_cos();
        let arm = minus(center, scaled(T::from_f64(contact.radius), [s, c]));
        let friction = match &contact.sliding {
            None => T::from_f64(contact.friction),
            Some(sliding) => self.by_lane(|formulas, lane| {
                contact.friction
                    * formulas.friction_sense(self.loads, sliding, index, T::state(self.states, lane))
            }),
        };
        let along = [s + friction * c, c - friction * s];
        sink.size(cause, size);
        sink.force(cause, contact.center.link, body, arm, scaled(size, along));
    }
}

/// Energy stored in a spring, J.
pub(crate) fn energy<T: LoadNumber>(spring: &Spring, bodies: &[Body<T>]) -> T {
    let stretch = span(spring, bodies) - T::from_f64(spring.length);
    (T::from_f64(spring.stiffness) * stretch * stretch).half()
}

/// Size of the terms of which the stored energy consists: it is small where the spring is nearly free, J.
pub(crate) fn terms_of_energy(spring: &Spring, bodies: &[Body<f64>]) -> f64 {
    0.5 * spring.stiffness * (span(spring, bodies) + spring.length).powi(2)
}

/// Distance of the ends of a spring, m.
fn span<T: LoadNumber>(spring: &Spring, bodies: &[Body<T>]) -> T {
    let [a, b] = spring.ends.map(|end| bodies[end.link].point(vector(end.at)));
    let between = minus(b, a);
    dot(between, between).sqrt()
}
