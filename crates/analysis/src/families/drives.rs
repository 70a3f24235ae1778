//! Over time: the coordinate, speed and acceleration of each drive, derivatives with respect to each coordinate, the load of each
//! drive.

use assur_force::{Cause, power};
use assur_integrator::Reduced;
use assur_kinematics::{PointMotion, ScalarMotion};
use assur_mechanism::Driver;
use assur_number::{Lanes, Real};

use super::{Rows, Sink};
use crate::Calculation;
use crate::results::{Column, Owner, Quantity};

/// Coordinates and, where it moves, speeds and accelerations of the drives.
pub(super) fn coordinates(found: &Calculation, moves: bool, to: &mut impl Sink) {
    let drivers = &found.linkage.mechanism.input.drivers;
    let quantities = [Quantity::Transfer(0), Quantity::Velocity, Quantity::Acceleration];
    for (order, quantity) in quantities.into_iter().enumerate().take(if moves { 3 } else { 1 }) {
        for (index, driver) in drivers.iter().enumerate() {
            to.always([Column::of(quantity, Owner::Drive(index))], |rows| [rows.of_law(driver, order)]);
        }
    }
}

/// The drives with the orders of the derivatives with respect to the coordinate of each: PF1, of a single drive PF2 too; none where
/// the coordinate is that of a drive.
fn partials(found: &Calculation) -> impl Iterator<Item = (usize, u8)> {
    let input = &found.linkage.mechanism.input;
    let drives = if input.kind().is_time() { input.drivers.len() } else { 0 };
    let most = if input.is_list { 1 } else { 2 };
    (1..=most).flat_map(move |order| (0..drives).map(move |drive| (drive, order)))
}

/// Angles of the links, and their derivatives with respect to the coordinate of each drive, the others at rest.
pub(super) fn links(found: &Calculation, to: &mut impl Sink) {
    for link in found.plan.wanted.links.iter().copied() {
        to.always([Column::of(Quantity::Transfer(0), Owner::Link(link))], |rows| [rows.angle(link)]);
        for (drive, order) in partials(found) {
            to.always([Column::of(Quantity::Partial { drive, order }, Owner::Link(link))], |rows| {
                let body = &rows.partials[drive][link];
                [if order == 1 { body.w1 } else { body.w2 }]
            });
        }
    }
}

/// Places of the points, and the same derivatives.
pub(super) fn points(found: &Calculation, to: &mut impl Sink) {
    for (id, at) in &found.plan.wanted.points {
        to.always(Column::vector(Quantity::Transfer(0), Owner::Point(*id)), |rows| rows.point(at).pf0);
        for (drive, order) in partials(found) {
            to.always(Column::vector(Quantity::Partial { drive, order }, Owner::Point(*id)), |rows| {
                let PointMotion { pf1, pf2, .. } = PointMotion::of(&rows.partials[drive][at.link], at.at);
                if order == 1 { pf1 } else { pf2 }
            });
        }
    }
}

/// Displacements of the slides, and the same derivatives.
pub(super) fn slides(found: &Calculation, to: &mut impl Sink) {
    for slide in found.plan.wanted.slides.iter().copied() {
        to.always([Column::of(Quantity::Transfer(0), Owner::Slide(slide))], |rows| [rows.slide(slide).pf0]);
        for (drive, order) in partials(found) {
            to.always([Column::of(Quantity::Partial { drive, order }, Owner::Slide(slide))], |rows| {
                let slide = &rows.calculation.linkage.mechanism.slides[slide];
                let ScalarMotion { pf1, pf2, .. } = ScalarMotion::of_slide(slide, &rows.partials[drive]);
                [if order == 1 { pf1 } else { pf2 }]
            });
        }
    }
}

/// Inertia and loads reduced to a single drive.
pub(super) fn reduced(found: &Calculation, to: &mut impl Sink) {
    if found.linkage.mechanism.input.is_list || !found.knows_all_loads() {
        return;
    }
    let all = [Quantity::ReducedInertia, Quantity::ReducedInertiaDerivative, Quantity::ReducedMoment];
    to.always(all.map(|quantity| Column::of(quantity, Owner::Drive(0))), |rows| {
        let reduced = by_coordinate(rows);
        reduced.map_or([Lanes::ZERO; 3], |of| [of.inertia, of.inertia_derivative, of.moment])
    });
}

/// Inertia and loads reduced to the coordinate of the only drive.
pub(super) fn by_coordinate(rows: &Rows<'_>) -> Option<Reduced<Lanes>> {
    let (Some(loads), [bodies]) = (&rows.calculation.loads, &rows.partials[..]) else { return None };
    let states = rows.instants.map(|instant| instant.state);
    // Which way a load acts follows from the motion in time, its power from the motion with the coordinate.
    let mut moment = Lanes::ZERO;
    loads.by_cause(&states, &rows.position.bodies, &mut |cause, link, wrench| {
        if !matches!(cause, Cause::Inertia(_)) {
            moment += power(&wrench, &bodies[link]);
        }
    });
    Some(Reduced { moment, ..loads.reduced(&states, bodies) })
}

/// Speed and acceleration of the first drive.
pub(super) fn rates(rows: &Rows<'_>) -> [Lanes; 2] {
    let driver = rows.calculation.linkage.mechanism.input.first();
    [1, 2].map(|order| rows.of_law(driver, order))
}

/// The load of each drive: a moment, or a force along the guide.
pub(super) fn loads(found: &Calculation, to: &mut impl Sink) {
    for drive in 0..found.linkage.mechanism.input.drivers.len() {
        let section = to.section(true);
        to.put(section, [Column::of(Quantity::Balancing, Owner::Drive(drive))], |rows| {
            let (_, reactions, determined) = rows.reactions.as_ref()?;
            let value = *reactions.drives.get(drive)?;
            Some(([value], std::array::from_fn(|lane| determined[lane] && value.0[lane].is_finite())))
        });
    }
}

impl Rows<'_> {
    /// The coordinate of a drive over time, or a derivative of it.
    pub(super) fn of_law(&self, driver: &Driver, order: usize) -> Lanes {
        let law = driver.law.as_ref();
        Lanes::of(|lane| law.map_or(f64::NAN, |law| law.at(self.instants[lane].state.time)[order]))
    }
}
