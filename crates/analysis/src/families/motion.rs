//! Time, coordinate and speeds of the input; transfer functions, velocities and accelerations.

use assur_group::Body;
use assur_kinematics::{Linkage, PointMotion, ScalarMotion};
use assur_number::{Lanes, elementary};

use super::Family;
use crate::Calculation;
use crate::plan::Wanted;
use crate::results::{Cells, Column, Owner, Quantity, Schema, Section};

pub(super) const TIME: Family = Family {
    applies: |_| true,
    columns: |_, schema| schema.add(Section::ALWAYS, [Column::of(Quantity::Time, Owner::Input)]),
    fill: |rows, cells| cells.all([rows.state(|state| state.time)]),
};

pub(super) const COORDINATE: Family = Family {
    applies: |_| true,
    columns: |_, schema| schema.add(Section::ALWAYS, [Column::COORDINATE]),
    fill: |rows, cells| cells.all([rows.state(|state| state.coordinate)]),
};

/// Speed and acceleration of the input.
pub(super) const SPEEDS: Family = Family {
    applies: |_| true,
    columns: |_, schema| {
        let of = |quantity| Column::of(quantity, Owner::Input);
        schema.add(Section::ALWAYS, [Quantity::Velocity, Quantity::Acceleration].map(of));
    },
    fill: |rows, cells| cells.all([rows.state(|state| state.speed), rows.state(|state| state.acceleration)]),
};

pub(super) const LINKS: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        scalars(schema, calculation.plan.wanted.links.iter().map(|id| Owner::Link(*id)));
    },
    fill: |rows, cells| rows.motions.links.iter().for_each(|motion| cells.all(derivatives(motion))),
};

pub(super) const SLIDES: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        scalars(schema, calculation.plan.wanted.slides.iter().map(|id| Owner::Slide(*id)));
    },
    fill: |rows, cells| rows.motions.slides.iter().for_each(|motion| cells.all(derivatives(motion))),
};

/// PF0, PF1 and PF2.
fn scalars(schema: &mut Schema, owners: impl Iterator<Item = Owner>) {
    for owner in owners {
        schema.add(Section::ALWAYS, (0..=2).map(|order| Column::of(Quantity::Transfer(order), owner)));
    }
}

fn derivatives(motion: &ScalarMotion<Lanes>) -> [Lanes; 3] {
    [motion.pf0, motion.pf1, motion.pf2]
}

pub(super) const POINTS: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| points(calculation, schema, 2),
    fill: |rows, cells| {
        for motion in &rows.motions.points {
            cells.all([motion.pf0, motion.pf1, motion.pf2].into_iter().flatten());
        }
    },
};

/// Where the points are.
pub(super) const PLACES: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| points(calculation, schema, 0),
    fill: |rows, cells| rows.motions.points.iter().for_each(|motion| cells.all(motion.pf0)),
};

/// Transfer functions of the points up to an order.
fn points(calculation: &Calculation, schema: &mut Schema, highest: u8) {
    for (id, _) in &calculation.plan.wanted.points {
        for order in 0..=highest {
            schema.add(Section::ALWAYS, Column::vector(Quantity::Transfer(order), Owner::Point(*id)));
        }
    }
}

/// Velocities and accelerations: v = PF1 w, a = PF2 w² + PF1 e.
pub(super) const RATES: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        let wanted = &calculation.plan.wanted;
        for quantity in [Quantity::Velocity, Quantity::Acceleration] {
            let scalar = |owner| Column::of(quantity, owner);
            schema.add(Section::ALWAYS, wanted.links.iter().map(|id| scalar(Owner::Link(*id))));
            let points = wanted.points.iter().flat_map(|(id, _)| Column::vector(quantity, Owner::Point(*id)));
            schema.add(Section::ALWAYS, points);
            schema.add(Section::ALWAYS, wanted.slides.iter().map(|id| scalar(Owner::Slide(*id))));
        }
    },
    fill: |rows, cells| {
        let speed = rows.state(|state| state.speed);
        let acceleration = rows.state(|state| state.acceleration);
        rates(rows.motions, cells, |pf1, _| pf1 * speed);
        rates(rows.motions, cells, |pf1, pf2| pf2 * speed * speed + pf1 * acceleration);
    },
};

fn rates(motions: &Motions, cells: &mut Cells<'_>, rate: impl Fn(Lanes, Lanes) -> Lanes) {
    cells.all(motions.links.iter().map(|motion| rate(motion.pf1, motion.pf2)));
    for motion in &motions.points {
        cells.all([0, 1].map(|axis| rate(motion.pf1[axis], motion.pf2[axis])));
    }
    cells.all(motions.slides.iter().map(|motion| rate(motion.pf1, motion.pf2)));
}

/// Transfer functions of the links, points and slides that results show, in eight positions; angles in (-pi, pi].
#[derive(Debug, Default)]
pub(crate) struct Motions {
    links: Vec<ScalarMotion<Lanes>>,
    points: Vec<PointMotion<Lanes>>,
    slides: Vec<ScalarMotion<Lanes>>,
}

impl Motions {
    pub(crate) fn read(&mut self, linkage: &Linkage, wanted: &Wanted, bodies: &[Body<Lanes>]) {
        let slides = &linkage.mechanism.slides;
        self.links.clear();
        self.links.extend(wanted.links.iter().map(|link| turning(&bodies[*link])));
        self.points.clear();
        self.points.extend(wanted.points.iter().map(|(_, at)| PointMotion::of(&bodies[at.link], at.at)));
        self.slides.clear();
        self.slides.extend(wanted.slides.iter().map(|slide| ScalarMotion::of_slide(&slides[*slide], bodies)));
    }
}

/// The angle of a link and its derivatives.
fn turning(body: &Body<Lanes>) -> ScalarMotion<Lanes> {
    let angle = Lanes::of(|lane| elementary::atan2(body.s.0[lane], body.c.0[lane]));
    ScalarMotion { pf0: angle, pf1: body.w1, pf2: body.w2 }
}
