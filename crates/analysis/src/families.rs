//! The families of columns: what the results of a position or of a sample of a motion consist of.
//!
//! A family names its columns, and fills them in the same order for a solved position. A further quantity in the results
//! is a further family in [`POSITIONS`], [`TRANSIENT`] or [`STEADY`]; the writers need a name for it.

use assur_dynamics::Holding;
use assur_force::{Cause, Reactions, State};
use assur_group::{Order, Wrench};
use assur_integrator::Reduced;
use assur_kinematics::{Position, ScalarMotion};
use assur_mechanism::{LinkId, Mechanism, PairId};

use crate::joints::{Joints, ends};
use crate::reader::Motions;
use crate::results::{Cells, Column, Owner, Quantity, Schema, Section};
use crate::{Calculation, InputMotion};

/// Columns that belong together.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    /// Whether the calculation gives them.
    pub(crate) applies: fn(&Calculation) -> bool,
    /// Adds them to a schema.
    pub(crate) columns: fn(&Calculation, &mut Schema),
    /// Fills exactly these for one position.
    pub(crate) fill: fn(&Row<'_>, &mut Cells<'_>),
}

/// What is known about one position.
pub(crate) struct Row<'a> {
    pub(crate) calculation: &'a Calculation,
    pub(crate) state: State,
    pub(crate) position: &'a Position,
    pub(crate) motions: &'a Motions,
    pub(crate) reduced: Option<Reduced>,
    /// Where they are determined.
    pub(crate) reactions: Option<(&'a Joints, &'a Reactions)>,
    pub(crate) balancing: Option<f64>,
    pub(crate) holding: Option<Holding>,
}

/// Of the positions of a scene.
pub(crate) const POSITIONS: &[Family] = &[
    COORDINATE,
    Family { applies: |calculation| calculation.positions_move(), ..SPEEDS },
    LINKS,
    POINTS,
    SLIDES,
    Family { applies: |calculation| calculation.positions_move() && calculation.plan.velocities, ..RATES },
    REDUCED,
    INERTIA_OF_LINKS,
    LOADS,
    INERTIA_LOADS,
    SHAKING,
    Family {
        applies: |calculation| calculation.positions_have_forces() && (REACTIONS.applies)(calculation),
        ..REACTIONS
    },
    Family {
        applies: |calculation| calculation.positions_have_forces() && (BALANCING.applies)(calculation),
        ..BALANCING
    },
    CONDITION,
];
/// Of the samples of a transient motion.
pub(crate) const TRANSIENT: &[Family] =
    &[TIME, COORDINATE, SPEEDS, LINKS, PLACES, SLIDES, RATES, REACTIONS, BALANCING, HOLDING];
/// Of the samples of a steady motion.
pub(crate) const STEADY: &[Family] = &[TIME, COORDINATE, SPEEDS, LINKS];

const TIME: Family = Family {
    applies: |_| true,
    columns: |_, schema| schema.add(Section::ALWAYS, [Column::of(Quantity::Time, Owner::Input)]),
    fill: |row, cells| cells.all([row.state.time]),
};

const COORDINATE: Family = Family {
    applies: |_| true,
    columns: |_, schema| schema.add(Section::ALWAYS, [Column::COORDINATE]),
    fill: |row, cells| cells.all([row.state.coordinate]),
};

/// Speed and acceleration of the input.
const SPEEDS: Family = Family {
    applies: |_| true,
    columns: |_, schema| {
        let of = |quantity| Column::of(quantity, Owner::Input);
        schema.add(Section::ALWAYS, [Quantity::Velocity, Quantity::Acceleration].map(of));
    },
    fill: |row, cells| cells.all([row.state.speed, row.state.acceleration]),
};

const LINKS: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        scalars(schema, calculation.plan.wanted.links.iter().map(|id| Owner::Link(*id)));
    },
    fill: |row, cells| row.motions.links.iter().for_each(|motion| cells.all(derivatives(motion))),
};

const SLIDES: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        scalars(schema, calculation.plan.wanted.slides.iter().map(|id| Owner::Slide(*id)));
    },
    fill: |row, cells| row.motions.slides.iter().for_each(|motion| cells.all(derivatives(motion))),
};

/// PF0, PF1 and PF2.
fn scalars(schema: &mut Schema, owners: impl Iterator<Item = Owner>) {
    for owner in owners {
        schema.add(Section::ALWAYS, (0..=2).map(|order| Column::of(Quantity::Transfer(order), owner)));
    }
}

fn derivatives(motion: &ScalarMotion) -> [f64; 3] {
    [motion.pf0, motion.pf1, motion.pf2]
}

const POINTS: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| points(calculation, schema, 2),
    fill: |row, cells| {
        for motion in &row.motions.points {
            for vector in [motion.pf0, motion.pf1, motion.pf2] {
                cells.all(vector);
            }
        }
    },
};

/// Where the points are.
const PLACES: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| points(calculation, schema, 0),
    fill: |row, cells| row.motions.points.iter().for_each(|motion| cells.all(motion.pf0)),
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
const RATES: Family = Family {
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
    fill: |row, cells| {
        let (speed, acceleration) = (row.state.speed, row.state.acceleration);
        rates(row.motions, cells, |pf1, _| pf1 * speed);
        rates(row.motions, cells, |pf1, pf2| pf2 * speed * speed + pf1 * acceleration);
    },
};

fn rates(motions: &Motions, cells: &mut Cells<'_>, rate: impl Fn(f64, f64) -> f64) {
    cells.all(motions.links.iter().map(|motion| rate(motion.pf1, motion.pf2)));
    for motion in &motions.points {
        cells.all([0, 1].map(|axis| rate(motion.pf1[axis], motion.pf2[axis])));
    }
    cells.all(motions.slides.iter().map(|motion| rate(motion.pf1, motion.pf2)));
}

const REDUCED: Family = Family {
    applies: |calculation| calculation.plan.reduction && calculation.loads.is_some(),
    columns: |_, schema| {
        let all = [Quantity::ReducedInertia, Quantity::ReducedInertiaDerivative, Quantity::ReducedMoment];
        schema.add(Section::ALWAYS, all.map(|quantity| Column::of(quantity, Owner::Input)));
    },
    fill: |row, cells| {
        if let Some(reduced) = row.reduced {
            cells.all([reduced.inertia, reduced.inertia_derivative, reduced.moment]);
        }
    },
};

/// The reduced moment of inertia of each link, of which the whole one is the sum; where an equation of motion is solved.
const INERTIA_OF_LINKS: Family = Family {
    applies: |calculation| {
        (REDUCED.applies)(calculation) && calculation.plan.dynamics && calculation.knows_all_loads()
    },
    columns: |calculation, schema| {
        for link in heavy(&calculation.linkage.mechanism) {
            schema.add(Section::ALWAYS, [Column::of(Quantity::ReducedInertia, Owner::Link(link))]);
        }
    },
    fill: |row, cells| {
        for link in heavy(&row.calculation.linkage.mechanism) {
            let (found, body) = (&row.calculation.linkage.mechanism.links[link], &row.position.bodies[link]);
            let [x, y] = body.first(body.arm(found.center));
            cells.all([found.mass * (x * x + y * y) + found.inertia * body.w1 * body.w1]);
        }
    },
};

/// Values of the loads of the scene.
const LOADS: Family = Family {
    applies: |calculation| calculation.positions_have_forces() && calculation.knows_all_loads(),
    columns: |_, schema| {
        let loads = (0..schema.loads()).map(|load| Column::of(Quantity::Load, Owner::Load(load)));
        let loads: Vec<Column> = loads.collect();
        schema.add(Section::ALWAYS, loads);
    },
    fill: |row, cells| {
        let Mechanism { forces, moments, springs, contacts, .. } = &row.calculation.linkage.mechanism;
        let starts = [0, forces.len(), moments.len(), springs.len()];
        let starts: Vec<usize> = starts
            .iter()
            .scan(0, |sum, count| {
                *sum += count;
                Some(*sum)
            })
            .collect();
        let mut sizes = vec![0.0; starts[3] + contacts.len()];
        if let Some(loads) = &row.calculation.loads {
            loads.sizes(&row.state, &row.position.bodies, |cause, size| {
                let load = match cause {
                    Cause::Force(id) => starts[0] + id,
                    Cause::Moment(id) => starts[1] + id,
                    Cause::Spring(id) => starts[2] + id,
                    Cause::Contact(id) => starts[3] + id,
                    Cause::Weight(_) | Cause::Inertia(_) => return,
                };
                sizes[load] = size;
            });
        }
        cells.all(sizes);
    },
};

/// Inertia loads of the links with mass.
const INERTIA_LOADS: Family = Family {
    applies: |calculation| calculation.has_inertia_loads(),
    columns: |calculation, schema| {
        for link in heavy(&calculation.linkage.mechanism) {
            schema.add(Section::ALWAYS, Column::vector(Quantity::InertiaForce, Owner::Link(link)));
            schema.add(Section::ALWAYS, [Column::of(Quantity::InertiaMoment, Owner::Link(link))]);
        }
    },
    fill: |row, cells| {
        for link in heavy(&row.calculation.linkage.mechanism) {
            let (force, moment) = inertia_load(row, link);
            cells.all(force);
            cells.all([moment]);
        }
    },
};

/// What all inertia loads together do to the ground.
const SHAKING: Family = Family {
    applies: |calculation| calculation.has_inertia_loads(),
    columns: |_, schema| {
        schema.add(Section::ALWAYS, Column::vector(Quantity::ShakingForce, Owner::Input));
        schema.add(Section::ALWAYS, [Column::of(Quantity::ShakingMoment, Owner::Input)]);
    },
    fill: |row, cells| {
        let mechanism = &row.calculation.linkage.mechanism;
        let mut sum = Wrench::ZERO;
        for link in heavy(mechanism) {
            let (force, moment) = inertia_load(row, link);
            sum.add_at(row.position.bodies[link].point(mechanism.links[link].center), force, moment);
        }
        cells.all([sum.fx, sum.fy, sum.m]);
    },
};

/// The moving links with mass or moment of inertia.
fn heavy(mechanism: &Mechanism) -> impl Iterator<Item = LinkId> {
    let links = mechanism.links.iter().enumerate().skip(1);
    links.filter(|(_, link)| link.mass > 0.0 || link.inertia > 0.0).map(|(id, _)| id)
}

/// Force at the center of mass, and moment: -m a and -I e.
fn inertia_load(row: &Row<'_>, link: LinkId) -> ([f64; 2], f64) {
    let (found, body) = (&row.calculation.linkage.mechanism.links[link], &row.position.bodies[link]);
    let (square, acceleration) = (row.state.speed * row.state.speed, row.state.acceleration);
    let arm = body.arm(found.center);
    let (first, second) = (body.first(arm), body.second(arm));
    let force = [0, 1].map(|axis| -found.mass * (second[axis] * square + first[axis] * acceleration));
    (force, -found.inertia * (body.w2 * square + body.w1 * acceleration))
}

/// Forces and moments of the pins and slides.
const REACTIONS: Family = Family {
    applies: |calculation| {
        calculation.has_forces() && calculation.analyzer.is_some_and(|method| method.gives_reactions)
    },
    columns: |calculation, schema| {
        let section = schema.section();
        for &pair in &calculation.plan.wanted.reactions {
            for link in ends(&calculation.linkage, pair) {
                schema.add(section, Column::vector(Quantity::Force, Owner::PairOn(pair, link)));
            }
            if matches!(pair, PairId::Slide(_)) {
                schema.add(section, [Column::of(Quantity::Moment, Owner::Pair(pair))]);
                let offset = schema.section();
                schema.add(offset, [Column::of(Quantity::Offset, Owner::Pair(pair))]);
            }
        }
    },
    fill: |row, cells| {
        let Some((joints, reactions)) = row.reactions else {
            return cells.none(columns_of_reactions(row.calculation));
        };
        for joint in joints.wanted(reactions, row.position) {
            joint.forces.iter().for_each(|force| cells.all(*force));
            if let Some((moment, offset)) = joint.slide {
                cells.all([moment]);
                cells.put(offset);
            }
        }
    },
};

/// How many columns the pins and slides have.
fn columns_of_reactions(calculation: &Calculation) -> usize {
    let linkage = &calculation.linkage;
    let of =
        |pair: &PairId| 2 * ends(linkage, *pair).len() + if matches!(pair, PairId::Slide(_)) { 2 } else { 0 };
    calculation.plan.wanted.reactions.iter().map(of).sum()
}

const BALANCING: Family = Family {
    applies: |calculation| calculation.has_forces(),
    columns: |_, schema| {
        let section = schema.section();
        schema.add(section, [Column::BALANCING]);
    },
    fill: |row, cells| cells.put(row.balancing),
};

/// The load that holds the motion at rest or at its speed, and its greatest possible size.
const HOLDING: Family = Family {
    applies: |_| true,
    columns: |_, schema| {
        let section = schema.section();
        let of = |quantity| Column::of(quantity, Owner::Input);
        schema.add(section, [Quantity::Holding, Quantity::HoldingBound].map(of));
    },
    fill: |row, cells| {
        cells.put(row.holding.map(|held| held.moment));
        cells.put(row.holding.map(|held| held.bound));
    },
};

/// 1 / |health| of the groups that are solved; a group in a singular position has none that is a number.
const CONDITION: Family = Family {
    applies: |_| true,
    columns: |calculation, schema| {
        for (group, _) in solved(calculation) {
            let section = schema.section();
            schema.add(section, [Column::of(Quantity::Condition, Owner::Group(group))]);
        }
    },
    fill: |row, cells| {
        for (group, _) in solved(row.calculation) {
            let health = row.position.health[group].abs();
            cells.put((health > f64::MIN_POSITIVE).then(|| 1.0 / health));
        }
    },
};

/// The groups that are solved.
fn solved(calculation: &Calculation) -> impl Iterator<Item = (usize, &bool)> {
    calculation.plan.groups_needed.iter().enumerate().filter(|(_, needed)| **needed)
}

impl Calculation {
    /// Whether the positions have a speed.
    fn positions_move(&self) -> bool {
        self.motion.moves(&self.linkage.mechanism)
    }

    /// Whether all loads can be evaluated: groups that nothing wanted depends on are not solved.
    pub(crate) fn knows_all_loads(&self) -> bool {
        self.loads.is_some() && self.linkage.mechanism.output.is_none()
    }

    /// Whether the positions have inertia loads.
    fn has_inertia_loads(&self) -> bool {
        let solved = self.plan.groups_needed.iter().all(|needed| *needed);
        self.plan.order == Order::Second && solved && self.knows_all_loads() && self.positions_move()
    }

    /// Whether there is a force analysis.
    pub(crate) fn has_forces(&self) -> bool {
        self.loads.is_some() && self.analyzer.is_some()
    }

    /// The families of a motion over time; none with a prescribed motion.
    pub(crate) fn families_of_motion(&self) -> &'static [Family] {
        match self.motion {
            InputMotion::Prescribed => &[],
            InputMotion::Transient(_) => TRANSIENT,
            InputMotion::Steady(_) => STEADY,
        }
    }
}
