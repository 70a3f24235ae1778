//! Time, coordinate and speeds of the input; transfer functions, velocities and accelerations.

use assur_kinematics::{PointMotion, ScalarMotion};
use assur_mechanism::{InputPair, LinkId, Place, SlideId};
use assur_number::{Lanes, Real, elementary};

use super::{Rows, Sink};
use crate::plan::Wanted;
use crate::results::{Column, Owner, Quantity};

pub(super) fn time(to: &mut impl Sink) {
    to.always([Column::TIME], |rows| [rows.state(|state| state.time)]);
}

pub(super) fn coordinate(to: &mut impl Sink) {
    to.always([Column::COORDINATE], |rows| [rows.state(|state| state.coordinate)]);
}

/// Speed and acceleration of the input.
pub(super) fn speeds(to: &mut impl Sink) {
    let columns = [Quantity::Velocity, Quantity::Acceleration].map(|of| Column::of(of, Owner::Input));
    to.always(columns, |rows| [rows.state(|state| state.speed), rows.state(|state| state.acceleration)]);
}

/// Angles of the links, in (-pi, pi], and their derivatives.
pub(super) fn links(wanted: &Wanted, to: &mut impl Sink) {
    for link in wanted.links.iter().copied() {
        let columns = [0, 1, 2].map(|order| Column::of(Quantity::Transfer(order), Owner::Link(link)));
        to.always(columns, |rows| {
            let body = &rows.position.bodies[link];
            [rows.angle(link), body.w1, body.w2]
        });
    }
}

/// Where the points are, and the derivatives.
pub(super) fn points(wanted: &Wanted, to: &mut impl Sink) {
    for (id, at) in &wanted.points {
        let [[x0, y0], [x1, y1], [x2, y2]] =
            [0, 1, 2].map(|order| Column::vector(Quantity::Transfer(order), Owner::Point(*id)));
        to.always([x0, y0, x1, y1, x2, y2], |rows| {
            let PointMotion { pf0: [x0, y0], pf1: [x1, y1], pf2: [x2, y2] } = rows.point(at);
            [x0, y0, x1, y1, x2, y2]
        });
    }
}

/// Displacements of the slides, and their derivatives.
pub(super) fn slides(wanted: &Wanted, to: &mut impl Sink) {
    for slide in wanted.slides.iter().copied() {
        let columns = [0, 1, 2].map(|order| Column::of(Quantity::Transfer(order), Owner::Slide(slide)));
        to.always(columns, |rows| {
            let ScalarMotion { pf0, pf1, pf2 } = rows.slide(slide);
            [pf0, pf1, pf2]
        });
    }
}

/// Velocities and accelerations: v = PF1 w, a = PF2 w² + PF1 e.
pub(super) fn rates(wanted: &Wanted, to: &mut impl Sink) {
    for quantity in [Quantity::Velocity, Quantity::Acceleration] {
        let rate = |rows: &Rows<'_>, pf1: Lanes, pf2: Lanes| {
            let speed = rows.state(|state| state.speed);
            if quantity == Quantity::Velocity {
                return pf1 * speed;
            }
            pf2 * speed * speed + pf1 * rows.state(|state| state.acceleration)
        };
        for link in wanted.links.iter().copied() {
            to.always([Column::of(quantity, Owner::Link(link))], |rows| {
                let body = &rows.position.bodies[link];
                [rate(rows, body.w1, body.w2)]
            });
        }
        for (id, at) in &wanted.points {
            to.always(Column::vector(quantity, Owner::Point(*id)), |rows| {
                let PointMotion { pf1, pf2, .. } = rows.point(at);
                [0, 1].map(|axis| rate(rows, pf1[axis], pf2[axis]))
            });
        }
        for slide in wanted.slides.iter().copied() {
            to.always([Column::of(quantity, Owner::Slide(slide))], |rows| {
                let ScalarMotion { pf1, pf2, .. } = rows.slide(slide);
                [rate(rows, pf1, pf2)]
            });
        }
    }
}

impl Rows<'_> {
    /// The angle of a link, in (-pi, pi].
    pub(super) fn angle(&self, link: LinkId) -> Lanes {
        let body = &self.position.bodies[link];
        Lanes::of(|lane| elementary::atan2(body.s.0[lane], body.c.0[lane]))
    }

    #[inline]
    pub(super) fn point(&self, at: &Place) -> PointMotion<Lanes> {
        PointMotion::of(&self.position.bodies[at.link], at.at)
    }

    #[inline]
    pub(super) fn slide(&self, slide: SlideId) -> ScalarMotion<Lanes> {
        let input = &self.calculation.linkage.mechanism.input;
        if input.is_displacement_of(slide) {
            return ScalarMotion {
                pf0: self.position.coordinates,
                pf1: Real::from_f64(1.0),
                pf2: Real::from_f64(0.0),
            };
        }
        let driven = input
            .drivers
            .iter()
            .find(|driver| driver.law.is_some() && driver.pair == InputPair::Slide(slide));
        if let Some(driver) = driven {
            let [pf0, pf1, pf2] = [0, 1, 2].map(|order| self.of_law(driver, order));
            return ScalarMotion { pf0, pf1, pf2 };
        }
        ScalarMotion::of_slide(&self.calculation.linkage.mechanism.slides[slide], &self.position.bodies)
    }
}
