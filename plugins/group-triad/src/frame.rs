//! The conditions of the legs as seen from the base. In class IV the outer bodies are one leg more: they stand still against
//! each other, and base and plate are held to them by the outer pairs.

use assur_group::Body;
use assur_group::plane::{cross, dot, minus, mirrored, perp, plus, scaled, times};
use assur_number::Real;

use crate::kernel::Legged;
use crate::leg::{Hold, Leg, unit};
use crate::locus::{Loci, Locus, Pose};
use crate::mover::{Freedom, Mover};

impl<T: Real> Legged<T> {
    /// The conditions of all legs on the pose of the plate relative to the base, or to the ground where the outer bodies are
    /// the base.
    pub(crate) fn loci(&self, bodies: &[Body<T>]) -> Loci<T> {
        let of = |leg: &Leg<T>| locus(leg, bodies, self.base.is_some());
        match (&self.base, &self.legs[..]) {
            (Some(base), [one, two, ..]) => Loci::new([of(one), of(two), around(base, &self.plate, bodies)]),
            (_, [one, two, three, ..]) => Loci::new([of(one), of(two), of(three)]),
            // There are two legs or three.
            _ => Loci::new([Locus::Angle { direction: [T::ONE, T::ZERO] }; 3]),
        }
    }

    /// Places base and plate.
    pub(crate) fn put_pose(&self, pose: &Pose<T>, bodies: &mut [Body<T>]) {
        let Some(base) = &self.base else {
            let plate = &mut bodies[self.plate.link];
            [plate.c, plate.s] = unit(pose.direction);
            [plate.x, plate.y] = pose.origin;
            return;
        };
        let (d0, o0) = based(pose, (base, &self.plate), bodies);
        let [d0, d2] = [unit(d0), unit(times(d0, pose.direction))];
        let o2 = plus(o0, times(pose.origin, d0));
        for (link, direction, origin) in [(base.link, d0, o0), (self.plate.link, d2, o2)] {
            let body = &mut bodies[link];
            [body.c, body.s] = direction;
            [body.x, body.y] = origin;
        }
    }
}

/// The condition of a leg, with the base in its own frame or in that of the ground.
fn locus<T: Real>(leg: &Leg<T>, bodies: &[Body<T>], is_own: bool) -> Locus<T> {
    let fixed = |body: usize, at: [T; 2]| if is_own { at } else { bodies[body].point(at) };
    let turned =
        |body: usize, direction: [T; 2]| if is_own { direction } else { bodies[body].turned(direction) };
    match &leg.hold {
        Hold::Rr { outer, inner, length, .. } => {
            Locus::Circle { at: fixed(outer.body, outer.at), on: inner.at, length: *length }
        }
        Hold::Pr { outer, inner, offset } => Locus::OnBase {
            at: fixed(outer.body, outer.through),
            on: inner.at,
            normal: turned(outer.body, perp(outer.along)),
            offset: *offset,
        },
        Hold::Rp { outer, inner, offset } => Locus::OnPlate {
            at: fixed(outer.body, outer.at),
            on: inner.through,
            normal: perp(inner.along),
            offset: *offset,
        },
        Hold::Pp { outer, turn, .. } => Locus::Angle { direction: turned(outer.body, *turn) },
    }
}

/// The outer bodies as a leg between base and plate.
fn around<T: Real>(base: &Mover<T>, plate: &Mover<T>, bodies: &[Body<T>]) -> Locus<T> {
    let [at, on] = [base.own(), plate.own()];
    match (&base.freedom, &plate.freedom) {
        (Freedom::Turn(one), Freedom::Turn(other)) => {
            let way = minus(other.place(bodies), one.place(bodies));
            Locus::Circle { at, on, length: dot(way, way).sqrt() }
        }
        (Freedom::Shift(slide), Freedom::Turn(pin)) | (Freedom::Turn(pin), Freedom::Shift(slide)) => {
            let normal = perp(slide.guide(bodies));
            let offset = dot(normal, minus(pin.place(bodies), bodies[slide.body].point(slide.through)));
            let normal = times(normal, mirrored(slide.carried(bodies, slide.turn)));
            if slide.link == base.link {
                Locus::OnBase { at, on, normal, offset }
            } else {
                Locus::OnPlate { at, on, normal, offset }
            }
        }
        (Freedom::Shift(one), Freedom::Shift(other)) => {
            let [d0, d2] = [one, other].map(|slide| slide.carried(bodies, slide.turn));
            Locus::Angle { direction: times(d2, mirrored(d0)) }
        }
        // A link with an outer pair is not free.
        _ => Locus::Angle { direction: [T::ONE, T::ZERO] },
    }
}

/// Direction and origin of the base where the pose of the plate relative to it is known.
fn based<T: Real>(
    pose: &Pose<T>,
    (base, plate): (&Mover<T>, &Mover<T>),
    bodies: &[Body<T>],
) -> ([T; 2], [T; 2]) {
    let on_plate = |own: [T; 2]| plus(pose.origin, times(own, pose.direction));
    match (&base.freedom, &plate.freedom) {
        (Freedom::Turn(one), Freedom::Turn(other)) => {
            let place = one.place(bodies);
            let way = minus(other.place(bodies), place);
            let own = minus(on_plate(other.own), one.own);
            let d0 = unit(times(way, mirrored(own)));
            (d0, minus(place, times(one.own, d0)))
        }
        (Freedom::Shift(one), Freedom::Turn(other)) => {
            let d0 = one.carried(bodies, one.turn);
            (d0, minus(other.place(bodies), times(on_plate(other.own), d0)))
        }
        (Freedom::Turn(one), Freedom::Shift(other)) => {
            let d0 = times(other.carried(bodies, other.turn), mirrored(pose.direction));
            (d0, minus(one.place(bodies), times(one.own, d0)))
        }
        (Freedom::Shift(one), Freedom::Shift(other)) => {
            let d0 = one.carried(bodies, one.turn);
            let [t0, t2] = [one, other].map(|slide| slide.guide(bodies));
            let [s0, s2] = [one, other].map(|slide| bodies[slide.body].point(slide.through));
            // s2 + b t2 = s0 + a t0 + the way between the points of the slides.
            let way = times(minus(on_plate(other.own), one.own), d0);
            let rest = minus(minus(s2, s0), way);
            let a = cross(rest, t2) / cross(t0, t2);
            (d0, minus(plus(s0, scaled(a, t0)), times(one.own, d0)))
        }
        _ => ([T::ONE, T::ZERO], [T::ZERO; 2]),
    }
}
