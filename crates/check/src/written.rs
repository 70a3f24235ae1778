//! The loads, computed independently from the scene, without the compiled loads that the methods use.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use assur_force::{Cause, LoadState, Loads, Side};
use assur_group::{Body, Wrench};
use assur_mechanism::{
    Contact, Direction, Driver, Force, GROUND, LinkId, Load, LoadId, LoadKind, Mechanism, Moment, Place,
    Spring, Value,
};

use crate::kinetics::{inertia_terms, own_inertia};
use crate::stroke::{At, Extremes, Sizes, extremes, over_coordinate, sizes};
use crate::subject::Subject;

/// Distance of a rest, in the coordinate, rad or m, that counts as zero: a coordinate of a few turns is rounded by
/// 1e-15, and the limit of an assembly interval, where PF1 grows with the root of the distance, is found with that
/// accuracy.
const REST: f64 = 2e-12;

/// One load on one link.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Item {
    /// About the origin of the link's frame.
    pub(crate) wrench: Wrench<f64>,
    /// Sum of the sizes of its terms, as a force, N: measures its rounding.
    pub(crate) size: f64,
}

/// All loads of one position, by cause and the link on which they act.
pub(crate) type Items = BTreeMap<(Cause, LinkId), Item>;

/// The compiled loads of one position, by cause and link.
pub(crate) type Given = BTreeMap<(Cause, LinkId), Wrench<f64>>;

/// Computes loads; the extremes of strokes are found once.
pub(crate) struct Writer<'a> {
    mechanism: &'a Mechanism,
    scale: f64,
    /// PF1 of a point that is rounding: 1e-14 of the size of the mechanism in a unit of the coordinate.
    standing: f64,
    strokes: Vec<Option<Extremes>>,
}

/// The size of a load.
#[derive(Debug, Clone, Copy)]
struct Size {
    value: f64,
    /// The size of its terms, at least its own.
    terms: f64,
}

/// Bodies and state of one position, and the compiled loads there.
struct Now<'a> {
    bodies: &'a [Body<f64>],
    state: &'a LoadState,
    given: &'a Given,
}

impl Now<'_> {
    fn given(&self, cause: Cause, link: usize) -> Wrench<f64> {
        self.given.get(&(cause, link)).copied().unwrap_or(Wrench::ZERO)
    }
}

/// The compiled loads, summed by cause and link.
pub(crate) fn given(loads: &Loads, state: &LoadState, bodies: &[Body<f64>]) -> Given {
    let mut all = Given::new();
    loads.by_cause(state, bodies, &mut |cause, link, wrench| {
        all.entry((cause, link)).or_insert(Wrench::ZERO).add_at([0.0; 2], wrench.force(), wrench.m);
    });
    all
}

impl<'a> Writer<'a> {
    pub(crate) fn new(subject: &Subject<'a>) -> Self {
        let mechanism = &subject.linkage.mechanism;
        let stroke = |load: &Load| match &load.kind {
            LoadKind::Force(Force {
                at,
                value: Value::Stroke { axis, .. } | Value::Formula { axis: Some(axis), .. },
                ..
            }) => extremes(subject.linkage, *at, *axis),
            _ => None,
        };
        let strokes = mechanism.loads.iter().map(stroke).collect();
        let standing = 1e-14 * subject.unit(1, true);
        Self { mechanism, scale: subject.linkage.structure.scale, standing, strokes }
    }

    /// All loads of a position with the inertia loads. Where the scene leaves a choice (a jump of a table, a force
    /// against the motion of a point at rest), the choice of the compiled loads is accepted if it is possible.
    pub(crate) fn items(&self, given: &Given, state: &LoadState, bodies: &[Body<f64>]) -> Items {
        let now = Now { bodies, state, given };
        let mut items = Items::new();
        for id in 1..self.mechanism.links.len() {
            self.masses(&now, id, &mut items);
        }
        for (id, load) in self.mechanism.loads.iter().enumerate() {
            self.load(&now, id, &load.kind, &mut items);
        }
        items
    }

    fn load(&self, now: &Now<'_>, id: LoadId, load: &LoadKind, items: &mut Items) {
        let cause = Cause::Load(id);
        let moment = |Size { value: m, terms }| Item {
            wrench: Wrench { fx: 0.0, fy: 0.0, m },
            size: terms / self.scale,
        };
        let (link, item) = match load {
            LoadKind::Force(force) => (force.at.link, self.force(now, id, force)),
            LoadKind::Moment(Moment { link, value, against_motion: true }) => {
                (*link, moment(self.against(now, id, *link, (value, 1.0))))
            }
            LoadKind::Moment(Moment { link, value, .. }) => {
                let given = now.given(cause, *link).m;
                let place = Place { link: *link, at: [0.0; 2] };
                (*link, moment(self.size(now, value, place, None, given)))
            }
            LoadKind::Brake(brake) => {
                let law = (&brake.force, brake.moment_of_unit_force());
                (brake.link, moment(self.against(now, id, brake.link, law)))
            }
            LoadKind::Spring(spring) if spring.ends[0].link == spring.ends[1].link => return,
            LoadKind::Spring(spring) => return self.spring(now, id, spring, items),
            LoadKind::Contact(contact) => (contact.center.link, self.contact(now, id, contact)),
        };
        if link != GROUND {
            items.insert((cause, link), item);
        }
    }

    /// A force at a place of a link.
    fn at(&self, body: &Body<f64>, at: [f64; 2], force: [f64; 2], terms: f64) -> Item {
        let arm = body.arm(at);
        let mut wrench = Wrench::ZERO;
        wrench.add_at(arm, force, 0.0);
        Item { wrench, size: terms * (1.0 + arm[0].hypot(arm[1]) / self.scale) }
    }

    fn masses(&self, now: &Now<'_>, id: usize, items: &mut Items) {
        let (link, body) = (&self.mechanism.links[id], &now.bodies[id]);
        if let Some(g) = self.mechanism.gravity.filter(|_| link.mass > 0.0) {
            let force = [link.mass * g[0], link.mass * g[1]];
            let item = self.at(body, link.center, force, force[0].hypot(force[1]));
            items.insert((Cause::Weight(id), id), item);
        }
        let (w, e) = (now.state.speed, now.state.acceleration);
        if !link.is_heavy() || (w == 0.0 && e == 0.0) {
            return;
        }
        let arm = body.arm(link.center);
        let (first, second) = (body.first(arm), body.second(arm));
        let a = [0, 1].map(|k| second[k] * w * w + first[k] * e);
        let [inertia, slope] = own_inertia(link, now.state.coordinate);
        let changing = 0.5 * slope * body.w1 * w * w;
        let turn = -inertia * (body.w2 * w * w + body.w1 * e) - changing;
        let lever = arm[0].hypot(arm[1]);
        let terms = (body.x2.hypot(body.y2) + (body.w2.abs() + body.w1 * body.w1) * lever) * w * w
            + (body.x1.hypot(body.y1) + body.w1.abs() * lever) * e.abs();
        let mut item = self.at(body, link.center, a.map(|a| -link.mass * a), link.mass * terms);
        item.wrench.m += turn;
        let [inertia, slope] = inertia_terms(link, now.state.coordinate);
        let turning =
            inertia * (body.w2.abs() * w * w + (body.w1 * e).abs()) + 0.5 * slope * body.w1.abs() * w * w;
        item.size += turning / self.scale;
        items.insert((Cause::Inertia(id), id), item);
    }

    /// The state that laws over the coordinate and the speed of the input see: over time those of its only drive.
    fn of_drive(&self, state: &LoadState) -> LoadState {
        match self.mechanism.input.drivers.as_slice() {
            [Driver { law: Some(law), .. }] => {
                let [coordinate, speed, _] = law.at(state.time);
                LoadState { coordinate, speed, ..*state }
            }
            _ => *state,
        }
    }

    /// Size of a load by its law; of several possible sizes, the one closest to the given size.
    fn size(
        &self,
        now: &Now<'_>,
        value: &Value,
        place: Place,
        extremes: Option<Extremes>,
        given: f64,
    ) -> Size {
        let input = &self.mechanism.input;
        let body = &now.bodies[place.link];
        let arm = body.arm(place.at);
        let state = &self.of_drive(now.state);
        let [one, other] = senses(now.state, input.sign()).map(|sense| {
            let (point, pf1) = (body.point(place.at), body.first(arm));
            let (period, scale) = (input.period(), self.scale);
            sizes(value, &At { state, point, pf1, extremes, sense, period, scale })
        });
        let Sizes { range: [low, high], terms } = one.and(other);
        // Not clamp(): it panics for NaN bounds, and here NaN must appear as a failed check.
        let value = if given < low || !low.is_finite() {
            low
        } else if given > high {
            high
        } else {
            given
        };
        Size { value, terms: value.abs().max(terms) }
    }

    fn force(&self, now: &Now<'_>, id: LoadId, force: &Force) -> Item {
        let body = &now.bodies[force.at.link];
        let given = now.given(Cause::Load(id), force.at.link).force();
        let mut terms = 1.0;
        let along = match force.direction {
            Direction::Ground(angle) => [angle.cos(), angle.sin()],
            Direction::Link(angle) => {
                let (s, c) = angle.sin_cos();
                [body.c * c - body.s * s, body.s * c + body.c * s]
            }
            Direction::AgainstMotion => {
                let arm = body.arm(force.at.at);
                let v = body.first(arm);
                let speed = v[0].hypot(v[1]);
                let parts = body.x1.hypot(body.y1) + body.w1.abs() * arm[0].hypot(arm[1]);
                // At rest up to rounding: no force, or a force in any direction, which may be the difference of both.
                if now.state.speed == 0.0 || speed <= 1e-11 * parts || speed <= self.standing {
                    let bounds = [f64::NEG_INFINITY, f64::INFINITY];
                    let sizes =
                        bounds.map(|any| self.size(now, &force.value, force.at, self.strokes[id], any).terms);
                    let greatest = sizes.into_iter().fold(given[0].hypot(given[1]), f64::max);
                    return self.at(body, force.at.at, given, greatest);
                }
                let bend = body.second(arm);
                // The velocity passes zero within rounding of the coordinate: the point may count as at rest.
                let idle = given[0].hypot(given[1]) == 0.0;
                if idle && speed <= REST * bend[0].hypot(bend[1]) {
                    return self.at(body, force.at.at, given, 0.0);
                }
                terms += parts / speed;
                v.map(|v| -v / speed * now.state.speed.signum())
            }
        };
        let found = given[0] * along[0] + given[1] * along[1];
        let size = self.size(now, &force.value, force.at, self.strokes[id], found);
        self.at(body, force.at.at, along.map(|a| size.value * a), size.terms * terms)
    }

    /// A moment against the rotation of its link, as that of a brake, from its law and its moment where the law gives 1.
    fn against(&self, now: &Now<'_>, id: LoadId, link: LinkId, (law, unit): (&Value, f64)) -> Size {
        let given = now.given(Cause::Load(id), link).m;
        let body = &now.bodies[link];
        let speed = body.w1 * now.state.speed;
        let place = Place { link, at: [0.0; 2] };
        let lever = -speed.signum() * unit;
        // At rest up to rounding the moment is zero, or of either sense.
        let rests = speed == 0.0 || body.w1.abs() <= REST * (body.w2.abs() + 1.0);
        let found = if lever == 0.0 { 0.0 } else { given / lever };
        if rests {
            // The sense of the motion is not known, so neither is that of the force behind the moment.
            let either = [found, -found].map(|found| self.size(now, law, place, None, found).value);
            let most = either.into_iter().fold(0.0, |most, force| f64::max(most, (lever * force).abs()));
            let value = if given.abs() <= most { given } else { most.copysign(given) };
            return Size { value, terms: given.abs() };
        }
        let size = self.size(now, law, place, None, found);
        Size { value: lever * size.value, terms: unit.abs() * size.terms }
    }

    fn spring(&self, now: &Now<'_>, id: LoadId, spring: &Spring, items: &mut Items) {
        let ends = spring.ends.map(|end| &now.bodies[end.link]);
        let places = [0, 1].map(|k| ends[k].point(spring.ends[k].at));
        let d = [places[1][0] - places[0][0], places[1][1] - places[0][1]];
        let length = d[0].hypot(d[1]);
        let along = if length > 0.0 { d.map(|d| d / length) } else { [0.0; 2] };
        let rates = [0, 1].map(|k| ends[k].first(ends[k].arm(spring.ends[k].at)));
        let rate = (rates[1][0] - rates[0][0]) * along[0] + (rates[1][1] - rates[0][1]) * along[1];
        let pull = spring.stiffness * (length - spring.length) + spring.damping * rate * now.state.speed;
        // Distances of the places and their velocities cancel; so do length and free length.
        let far = places.iter().map(|p| p[0].hypot(p[1])).sum::<f64>();
        let fast = rates.iter().map(|v| v[0].hypot(v[1])).sum::<f64>() * now.state.speed.abs();
        let direction = if length > 0.0 { 1.0 + far / length } else { 0.0 };
        let terms = direction * (pull.abs() + spring.damping * fast)
            + spring.stiffness * (far + length + spring.length)
            + spring.damping * fast;
        for (k, sign) in [(0, 1.0), (1, -1.0)] {
            let item = self.at(ends[k], spring.ends[k].at, along.map(|a| sign * pull * a), terms);
            items.insert((Cause::Load(id), spring.ends[k].link), item);
        }
    }

    fn contact(&self, now: &Now<'_>, id: LoadId, contact: &Contact) -> Item {
        let center = contact.center;
        let body = &now.bodies[center.link];
        let given = now.given(Cause::Load(id), center.link).force();
        let friction = self.contact_friction(now, contact, given);
        let angle = self.contact_angle(now, contact, friction, given);
        let (s, c) = angle.sin_cos();
        let along = [s + friction * c, c - friction * s];
        let square = along[0] * along[0] + along[1] * along[1];
        let found = (given[0] * along[0] + given[1] * along[1]) / square;
        let mut size = self.size(now, &contact.force, center, None, found);
        match self.touching(contact, now.state.coordinate) {
            Some(true) => {}
            Some(false) => size = Size { value: 0.0, terms: 0.0 },
            // At an end of the interval.
            None => size.value = found,
        }
        let arm = body.arm(center.at);
        let arm = [arm[0] - contact.radius * s, arm[1] - contact.radius * c];
        let mut wrench = Wrench::ZERO;
        wrench.add_at(arm, along.map(|a| size.value * a), 0.0);
        let lever = 1.0 + (arm[0].hypot(arm[1]) + contact.radius) / self.scale;
        // The rounding of the angle turns the force, and beyond half a turn there is nothing left of its direction.
        let terms = self.size(now, &contact.angle, center, None, angle).terms;
        let turned = (terms + self.turned(now, contact) / f64::EPSILON).min(1.0 / f64::EPSILON);
        Item { wrench, size: size.terms.max(size.value.abs()) * square.sqrt() * lever * (1.0 + turned) }
    }

    /// By how much the angle of a contact changes over the rounding of the coordinate.
    fn turned(&self, now: &Now<'_>, contact: &Contact) -> f64 {
        let rounding = f64::EPSILON * now.state.coordinate;
        let [before, after] =
            [-rounding, rounding].map(|off| self.angle(contact, now.state.coordinate + off));
        (after - before).abs()
    }

    /// The angle of a contact at exactly this coordinate, after a jump.
    fn angle(&self, contact: &Contact, coordinate: f64) -> f64 {
        over_coordinate(&contact.angle, coordinate, self.mechanism.input.period())
    }

    /// The friction of a contact with its sign. Where the arc just rolls, or the input rests and stays there, the scene leaves the
    /// sign open.
    fn contact_friction(&self, now: &Now<'_>, contact: &Contact, given: [f64; 2]) -> f64 {
        if !contact.against_sliding {
            return contact.friction;
        }
        let (s, c) = self.angle(contact, now.state.coordinate).sin_cos();
        let body = &now.bodies[contact.center.link];
        let arm = body.arm(contact.center.at);
        let slides = body.first([arm[0] - contact.radius * s, arm[1] - contact.radius * c]);
        let along = slides[0] * c - slides[1] * s;
        let LoadState { speed, acceleration, side, .. } = *now.state;
        let of_input = self.mechanism.input.sign();
        let rests = speed == 0.0;
        let sense = if rests && side == Side::Prescribed { of_input } else { senses(now.state, of_input)[0] };
        let stays = acceleration == 0.0 || matches!(side, Side::Held { .. });
        let open = rests && stays && side != Side::Prescribed;
        if open || along.abs() <= REST * (slides[0].hypot(slides[1]) + contact.radius * body.w1.abs()) {
            let [across, pressed] = [given[0] * c - given[1] * s, given[0] * s + given[1] * c];
            let found = if pressed == 0.0 { 0.0 } else { across / pressed };
            return found.clamp(-contact.friction, contact.friction);
        }
        -(along * sense).signum() * contact.friction
    }

    /// The angle of a contact: the one of the given force, if the scene allows it.
    fn contact_angle(&self, now: &Now<'_>, contact: &Contact, friction: f64, given: [f64; 2]) -> f64 {
        let of_scene = self.angle(contact, now.state.coordinate);
        // The force may point either way along its line.
        let apart = given[0].atan2(given[1]) - friction.atan() - of_scene;
        let apart = if given[0].hypot(given[1]) == 0.0 { 0.0 } else { apart - PI * (apart / PI).round() };
        self.size(now, &contact.angle, contact.center, None, of_scene + apart).value
    }

    /// Whether there is contact; `None` at an end of the interval.
    fn touching(&self, contact: &Contact, coordinate: f64) -> Option<bool> {
        let Some([from, to]) = contact.during else { return Some(true) };
        let (mut before, mut after) = (coordinate - from, to - coordinate);
        if let Some(period) = self.mechanism.input.period() {
            if to - from >= period {
                return Some(true);
            }
            before = before.rem_euclid(period);
            after = to - from - before;
            // A place just before the interval begins again counts as its beginning, too.
            before = before.min((period - before).abs().max(1e-9));
        }
        if before.abs() <= 1e-9 || after.abs() <= 1e-9 { None } else { Some(before > 0.0 && after > 0.0) }
    }
}

/// The directions of the motion of the input at a state, 1 or -1: a motion that is held has both; one that begins or ends
/// at rest has that of its acceleration, or of the input if there is none.
fn senses(state: &LoadState, of_input: f64) -> [f64; 2] {
    let ahead = if state.side == Side::Before { -state.acceleration } else { state.acceleration };
    let mut directions = [state.speed, ahead].into_iter().filter(|direction| *direction != 0.0);
    match (directions.next(), state.side) {
        (None, Side::Held { .. }) => [1.0, -1.0],
        (direction, _) => [direction.unwrap_or(of_input).signum(); 2],
    }
}

#[cfg(test)]
mod tests;
