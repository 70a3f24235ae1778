//! Loads and masses: reduced to the input, each by itself, and what inertia does to the ground.

use assur_force::Cause;
use assur_group::Wrench;
use assur_group::plane::{dot, scaled};
use assur_mechanism::LinkId;
use assur_number::{Lanes, Real};

use super::{Family, Rows};
use crate::results::{Column, Owner, Quantity, Section};

pub(super) const REDUCED: Family = Family {
    applies: |calculation| calculation.plan.reduction && calculation.loads.is_some(),
    columns: |_, schema| {
        let all = [Quantity::ReducedInertia, Quantity::ReducedInertiaDerivative, Quantity::ReducedMoment];
        schema.add(Section::ALWAYS, all.map(|quantity| Column::of(quantity, Owner::Input)));
    },
    fill: |rows, cells| {
        if let Some(reduced) = rows.reduced {
            cells.all([reduced.inertia, reduced.inertia_derivative, reduced.moment]);
        }
    },
};

/// The reduced moment of inertia of each link, of which the whole one is the sum; where an equation of motion is solved.
pub(super) const INERTIA_OF_LINKS: Family = Family {
    applies: |calculation| {
        (REDUCED.applies)(calculation) && calculation.plan.dynamics && calculation.knows_all_loads()
    },
    columns: |calculation, schema| {
        for link in calculation.linkage.mechanism.heavy_links() {
            schema.add(Section::ALWAYS, [Column::of(Quantity::ReducedInertia, Owner::Link(link))]);
        }
    },
    fill: |rows, cells| {
        let mechanism = &rows.calculation.linkage.mechanism;
        for link in mechanism.heavy_links() {
            let (found, body) = (&mechanism.links[link], &rows.position.bodies[link]);
            let [inertia, _] = own_inertia(rows, link);
            let mass = Lanes::from_f64(found.mass);
            let first = body.first(body.arm(found.center.map(Lanes::from_f64)));
            cells.all([mass * dot(first, first) + inertia * body.w1 * body.w1]);
        }
    },
};

/// Values of the loads of the scene.
pub(super) const LOADS: Family = Family {
    applies: |calculation| calculation.positions_have_forces() && calculation.knows_all_loads(),
    columns: |_, schema| {
        let loads: Vec<Column> =
            (0..schema.loads()).map(|load| Column::of(Quantity::Load, Owner::Load(load))).collect();
        schema.add(Section::ALWAYS, loads);
    },
    fill: |rows, cells| {
        let mut sizes = vec![Lanes::ZERO; rows.calculation.linkage.mechanism.loads.len()];
        if let Some(loads) = &rows.calculation.loads {
            let states = rows.instants.map(|instant| instant.state);
            loads.sizes(&states, &rows.position.bodies, |cause, size| {
                if let Cause::Load(load) = cause {
                    sizes[load] = size;
                }
            });
        }
        cells.all(sizes);
    },
};

/// Inertia loads of the links with mass.
pub(super) const INERTIA_LOADS: Family = Family {
    applies: |calculation| calculation.has_inertia_loads(),
    columns: |calculation, schema| {
        for link in calculation.linkage.mechanism.heavy_links() {
            schema.add(Section::ALWAYS, Column::vector(Quantity::InertiaForce, Owner::Link(link)));
            schema.add(Section::ALWAYS, [Column::of(Quantity::InertiaMoment, Owner::Link(link))]);
        }
    },
    fill: |rows, cells| {
        for link in rows.calculation.linkage.mechanism.heavy_links() {
            let (force, moment) = inertia_load(rows, link);
            cells.all(force);
            cells.all([moment]);
        }
    },
};

/// What all inertia loads together do to the ground.
pub(super) const SHAKING: Family = Family {
    applies: |calculation| calculation.has_inertia_loads(),
    columns: |_, schema| {
        schema.add(Section::ALWAYS, Column::vector(Quantity::ShakingForce, Owner::Input));
        schema.add(Section::ALWAYS, [Column::of(Quantity::ShakingMoment, Owner::Input)]);
    },
    fill: |rows, cells| {
        let mechanism = &rows.calculation.linkage.mechanism;
        let mut sum = Wrench::ZERO;
        for link in mechanism.heavy_links() {
            let (force, moment) = inertia_load(rows, link);
            let center = mechanism.links[link].center.map(Lanes::from_f64);
            sum.add_at(rows.position.bodies[link].point(center), force, moment);
        }
        cells.all([sum.fx, sum.fy, sum.m]);
    },
};

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

/// The moment of inertia of a link about its center of mass, and its derivative by the coordinate.
fn own_inertia(rows: &Rows<'_>, link: LinkId) -> [Lanes; 2] {
    let inertia = &rows.calculation.linkage.mechanism.links[link].inertia;
    let coordinates = rows.position.coordinates.0.map(|coordinate| inertia.at(coordinate));
    [0, 1].map(|order| Lanes(coordinates.map(|at| at[order])))
}
