//! Loads and masses: reduced to the input, each by itself, and what inertia does to the ground.

use assur_force::Cause;
use assur_group::Wrench;
use assur_group::plane::{dot, scaled};
use assur_mechanism::LinkId;
use assur_number::{Lanes, Real};

use super::{Rows, Sink};
use crate::Calculation;
use crate::results::{Column, Owner, Quantity};

/// Inertia and loads reduced to the input, and, where an equation of motion is solved, the reduced moment of inertia of each link, of
/// which the whole one is the sum.
pub(super) fn reduced(found: &Calculation, to: &mut impl Sink) {
    let all = [Quantity::ReducedInertia, Quantity::ReducedInertiaDerivative, Quantity::ReducedMoment];
    to.always(all.map(|quantity| Column::of(quantity, Owner::Input)), |rows| {
        let reduced = rows.reduced.as_ref();
        reduced.map_or([Lanes::ZERO; 3], |of| [of.inertia, of.inertia_derivative, of.moment])
    });
    if !found.plan.dynamics || !found.knows_all_loads() {
        return;
    }
    for link in found.linkage.mechanism.heavy_links() {
        to.always([Column::of(Quantity::ReducedInertia, Owner::Link(link))], |rows| {
            let (part, body) = (&found.linkage.mechanism.links[link], &rows.position.bodies[link]);
            let [inertia, _] = own_inertia(rows, link);
            let mass = Lanes::from_f64(part.mass);
            let first = body.first(body.arm(part.center.map(Lanes::from_f64)));
            [mass * dot(first, first) + inertia * body.w1 * body.w1]
        });
    }
}

/// Values of the loads of the scene.
pub(super) fn loads(found: &Calculation, to: &mut impl Sink) {
    for load in 0..found.linkage.mechanism.loads.len() {
        to.always([Column::of(Quantity::Load, Owner::Load(load))], |rows| [rows.load(load)]);
    }
}

/// Inertia loads of the links with mass, and what all of them together do to the ground.
pub(super) fn inertia_loads(found: &Calculation, to: &mut impl Sink) {
    let mechanism = &found.linkage.mechanism;
    let columns = |force, moment, owner| {
        let [x, y] = Column::vector(force, owner);
        [x, y, Column::of(moment, owner)]
    };
    for link in mechanism.heavy_links() {
        to.always(columns(Quantity::InertiaForce, Quantity::InertiaMoment, Owner::Link(link)), |rows| {
            let ([x, y], moment) = inertia_load(rows, link);
            [x, y, moment]
        });
    }
    to.always(columns(Quantity::ShakingForce, Quantity::ShakingMoment, Owner::Input), |rows| {
        let mut sum = Wrench::ZERO;
        for link in mechanism.heavy_links() {
            let (force, moment) = inertia_load(rows, link);
            let center = mechanism.links[link].center.map(Lanes::from_f64);
            sum.add_at(rows.position.bodies[link].point(center), force, moment);
        }
        [sum.fx, sum.fy, sum.m]
    });
}

/// Force at the center of mass, and moment: -m a and -I e; of a moment of inertia I(q) less I' phi' w² / 2.
fn inertia_load(rows: &Rows<'_>, link: LinkId) -> ([Lanes; 2], Lanes) {
    let (found, body) = (&rows.calculation.linkage.mechanism.links[link], &rows.position.bodies[link]);
    let speed = rows.state(|state| state.speed);
    let (square, acceleration) = (speed * speed, rows.state(|state| state.acceleration));
    let rate = |first: Lanes, second: Lanes| second * square + first * acceleration;
    let arm = body.arm(found.center.map(Lanes::from_f64));
    let (first, second) = (body.first(arm), body.second(arm));
    let force = scaled(Lanes::from_f64(-found.mass), [0, 1].map(|axis| rate(first[axis], second[axis])));
    let [inertia, slope] = own_inertia(rows, link);
    let moment = -inertia * rate(body.w1, body.w2);
    // Without a slope the sign of a zero stays.
    let moment =
        if found.inertia.varying().is_some() { moment - (slope * body.w1 * square).half() } else { moment };
    (force, moment)
}

/// The moment of inertia of a link about its center of mass, and its derivative with respect to the coordinate.
fn own_inertia(rows: &Rows<'_>, link: LinkId) -> [Lanes; 2] {
    let inertia = &rows.calculation.linkage.mechanism.links[link].inertia;
    let coordinates = rows.position.coordinates.0.map(|coordinate| inertia.at(coordinate));
    [0, 1].map(|order| Lanes(coordinates.map(|at| at[order])))
}

impl Rows<'_> {
    /// The value of a load of the scene; all are found when the first one is asked for.
    fn load(&self, load: usize) -> Lanes {
        self.sizes.get_or_init(|| {
            let mut sizes = vec![Lanes::ZERO; self.calculation.linkage.mechanism.loads.len()];
            if let Some(loads) = &self.calculation.loads {
                let states = self.instants.map(|instant| instant.state);
                loads.sizes(&states, &self.position.bodies, |cause, size| {
                    if let Cause::Load(load) = cause {
                        sizes[load] = size;
                    }
                });
            }
            sizes
        })[load]
    }
}
