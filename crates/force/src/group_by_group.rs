//! Kinetostatics group by group, for any number type: from the last group to the input link (S, stage 9).

use assur_group::{AssurGroup, Body, GroupError, Number, Pair, PairGeometry, Wrench, plane};
use assur_kinematics::Linkage;
use assur_mechanism::{Driver, GROUND, Mechanism};
use assur_number::Real;
use assur_structure::NamedPair;

use crate::{ForceError, Reactions, UnitBalance, balance::IdleBalance, drive_direction};

/// Why there are no reactions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unsolved {
    /// A group can't be solved: its index and the reason.
    Group(usize, GroupError),
    /// The balancing load does no work.
    Idle(IdleBalance),
}

impl Unsolved {
    /// The error in words, for one position.
    #[cold]
    pub fn explain(&self, linkage: &Linkage, coordinate: f64) -> ForceError {
        match self {
            Self::Group(index, source) => {
                let group = linkage.structure.group_name(&linkage.mechanism, *index);
                ForceError::Group { group, coordinate, source: *source }
            }
            Self::Idle(idle) => idle.explain(linkage, coordinate),
        }
    }
}

/// The kernel of a group.
type Kernel<T> = dyn AssurGroup<T>;

/// The mechanism in one number type.
struct GroupByGroup<'a, T, S> {
    linkage: &'a Linkage,
    groups: &'a [Box<dyn AssurGroup<T>>],
    bodies: &'a [Body<T>],
    solve: S,
}

/// Finds the reactions of all groups, from the last to the first, then those of the input link, and the balancing load.
///
/// `loads`: one wrench for each body about the origin of its frame; each group adds its reactions on the bodies that
/// carry it. `solve` finds the reactions of one group from its kernel: [`AssurGroup::reactions`], or in another way.
///
/// Where the balancing load acts elsewhere than on the input link, its size follows from linearity: the drive must be
/// idle under all loads together, M(loads) + B M(unit load) = 0.
///
/// # Errors
///
/// [`Unsolved`] for a group without solution, or a balancing load without work; with lanes, in any lane.
#[inline]
pub fn group_by_group<T: Number>(
    linkage: &Linkage,
    groups: &[Box<dyn AssurGroup<T>>],
    bodies: &[Body<T>],
    loads: &mut [Wrench<T>],
    out: &mut Reactions<T>,
    solve: impl Fn(&Kernel<T>, &[Body<T>], &mut [Wrench<T>], &mut [Wrench<T>]) -> Result<(), GroupError>,
) -> Result<(), Unsolved> {
    let method = GroupByGroup { linkage, groups, bodies, solve };
    let drive = method.pass(&out.solved, loads, &mut out.pairs)?;
    match out.unit {
        None => out.balancing = drive,
        Some(unit) => method.balance(&unit, drive, out)?,
    }
    Ok(())
}

impl<T, S> GroupByGroup<'_, T, S>
where
    T: Number,
    S: Fn(&Kernel<T>, &[Body<T>], &mut [Wrench<T>], &mut [Wrench<T>]) -> Result<(), GroupError>,
{
    /// All reactions under these loads, and the load of the drive at the input: a moment (N m), or a force along the
    /// guide (N).
    #[inline]
    fn pass(&self, solved: &[bool], loads: &mut [Wrench<T>], pairs: &mut [Wrench<T>]) -> Result<T, Unsolved> {
        let each = self.groups.iter().zip(solved).enumerate().rev();
        for (index, (group, _)) in each.filter(|(_, (_, solved))| **solved) {
            let found = (self.solve)(group.as_ref(), self.bodies, loads, pairs);
            found.map_err(|reason| Unsolved::Group(index, reason))?;
        }
        Ok(drive(self.linkage, self.bodies, loads, pairs))
    }

    /// Adds the reactions of the balancing load that makes the drive idle.
    #[cold]
    fn balance(&self, unit: &UnitBalance, drive: T, out: &mut Reactions<T>) -> Result<(), Unsolved> {
        out.scratch_bodies.fill(Wrench::ZERO);
        out.scratch_bodies[unit.link] = unit.wrench(self.bodies);
        let unit_drive = self.pass(&out.solved, &mut out.scratch_bodies, &mut out.scratch_pairs)?;
        let size = unit.size(drive, unit_drive, self.linkage).map_err(Unsolved::Idle)?;
        for (sum, unit) in out.pairs.iter_mut().zip(&out.scratch_pairs) {
            sum.fx += size * unit.fx;
            sum.fy += size * unit.fy;
            sum.m += size * unit.m;
        }
        out.balancing = size;
        Ok(())
    }
}

/// The load of the drive, where the reactions of all groups and the loads of an input link are known: a moment (N m), or a force along
/// the guide (N); over time the power of all drives, W. Of an input link the reaction of its pair is written too; a driven pair of a
/// group loses the part of the drive.
#[inline(always)]
pub fn drive<T: Real>(
    linkage: &Linkage,
    bodies: &[Body<T>],
    loads: &[Wrench<T>],
    pairs: &mut [Wrench<T>],
) -> T {
    let input = &linkage.mechanism.input;
    if let Some(driver) = input.sole() {
        let pair = &linkage.structure.pairs[0].pair;
        // The coordinate is the displacement along the guide, so that PF1 of the origin is the guide's direction.
        let along = [bodies[driver.link].x1, bodies[driver.link].y1];
        return drive_of(driver, (pair, along), bodies, (loads, &mut pairs[0]));
    }
    let mut power = T::ZERO;
    for (id, driver) in input.drivers.iter().enumerate() {
        let pair = &linkage.structure.pairs[id].pair;
        let along = drive_direction(&linkage.mechanism, driver, bodies).unwrap_or([T::ZERO; 2]);
        let load = drive_of(driver, (pair, along), bodies, (loads, &mut pairs[id]));
        power += load * rate(pair, bodies);
    }
    power
}

/// The load of one drive; `along`: the direction of the force on its link, of a slide.
#[inline(always)]
fn drive_of<T: Real>(
    driver: &Driver,
    (pair, along): (&Pair, [T; 2]),
    bodies: &[Body<T>],
    (loads, reaction): (&[Wrench<T>], &mut Wrench<T>),
) -> T {
    if driver.is_relative() {
        return drive_of_pair(pair, bodies, reaction);
    }
    let (found, drive) = input_link(pair, (driver.link, along), bodies, loads);
    *reaction = found;
    drive
}

/// The speed at which the coordinate of a pair changes: the angle of `a` counted from `b`, or the displacement along the guide of `b`.
#[inline]
pub fn rate<T: Real>(pair: &Pair, bodies: &[Body<T>]) -> T {
    let [a, b] = [&bodies[pair.a], &bodies[pair.b]];
    match pair.geometry {
        PairGeometry::Pin { .. } => a.w1 - b.w1,
        PairGeometry::Slide { point, angle, .. } => {
            let along = b.turned(plane::direction(angle));
            let arm = a.arm(plane::vector(point));
            // As a point of the guide's body.
            let there = plane::minus(a.point(plane::vector(point)), b.origin());
            plane::dot(along, plane::minus(a.first(arm), b.first(there)))
        }
    }
}

/// The load of each drive over time from the reactions in all pairs, by the equilibrium of links: a moment (N m), or a force along the
/// guide (N). `loads`: on each body, about the origin of its frame, without reactions.
pub fn drives<T: Real>(
    linkage: &Linkage,
    bodies: &[Body<T>],
    loads: &[Wrench<T>],
    reactions: &[Wrench<T>],
    out: &mut Vec<T>,
) {
    let (mechanism, pairs) = (&linkage.mechanism, &linkage.structure.pairs);
    let drivers = &mechanism.input.drivers;
    out.clear();
    out.resize(drivers.len(), T::from_f64(f64::NAN));
    let mut open: Vec<usize> = (0..drivers.len()).collect();
    while let Some((id, link)) = last_on_a_link(drivers, &open) {
        let mut sum = loads[link];
        let mut add = |pair: &Pair, wrench: &Wrench<T>| {
            let sign = if pair.a == link { T::ONE } else { -T::ONE };
            let arm = plane::minus(place_of(pair, bodies), bodies[link].origin());
            sum.add_at(arm, plane::scaled(sign, wrench.force()), sign * wrench.m);
        };
        for NamedPair { pair, .. } in pairs.iter().filter(|one| one.pair.joins(link)) {
            add(pair, &reactions[pair.id]);
        }
        let others = drivers.iter().zip(pairs).enumerate().filter(|(other, _)| *other != id);
        for (other, (driver, NamedPair { pair, .. })) in others.filter(|(_, (_, one))| one.pair.joins(link)) {
            add(pair, &on_first(mechanism, driver, pair, bodies, out[other]));
        }
        let own = plane::minus(place_of(&pairs[id].pair, bodies), bodies[link].origin());
        let load = match drive_direction(mechanism, &drivers[id], bodies) {
            Some(along) => plane::dot(sum.force(), along),
            None => sum.about(own),
        };
        out[id] = if link == drivers[id].link { -load } else { load };
        open.retain(|other| *other != id);
    }
}

/// A drive whose load is not known yet, with a moving link on which it is the only such one. Drives that are independent make no loop,
/// so there is one until all are known.
fn last_on_a_link(drivers: &[Driver], open: &[usize]) -> Option<(usize, usize)> {
    let on =
        |link: usize| open.iter().filter(move |id| [drivers[**id].link, drivers[**id].on].contains(&link));
    let ends = open.iter().flat_map(|id| [(*id, drivers[*id].link), (*id, drivers[*id].on)]);
    ends.into_iter().find(|(_, link)| *link != GROUND && on(*link).count() == 1)
}

/// What a drive of this load exerts on the first body of its pair.
fn on_first<T: Real>(
    mechanism: &Mechanism,
    driver: &Driver,
    pair: &Pair,
    bodies: &[Body<T>],
    load: T,
) -> Wrench<T> {
    let load = if pair.a == driver.link { load } else { -load };
    match drive_direction(mechanism, driver, bodies) {
        Some([x, y]) => Wrench { fx: load * x, fy: load * y, m: T::ZERO },
        None => Wrench { m: load, ..Wrench::ZERO },
    }
}

/// Where the reaction of a pair acts, m.
fn place_of<T: Real>(pair: &Pair, bodies: &[Body<T>]) -> [T; 2] {
    match pair.geometry {
        PairGeometry::Pin { at_a: at, .. } | PairGeometry::Slide { point: at, .. } => {
            bodies[pair.a].point(plane::vector(at))
        }
    }
}

/// The load of the drive of a pair between two moving links, which is taken out of what the pair exerts on its body `a`: the moment of a
/// pin (N m), of a slide the force along its guide (N).
#[inline(always)]
pub fn drive_of_pair<T: Real>(pair: &Pair, bodies: &[Body<T>], reaction: &mut Wrench<T>) -> T {
    match pair.geometry {
        PairGeometry::Pin { .. } => std::mem::replace(&mut reaction.m, T::ZERO),
        PairGeometry::Slide { angle, .. } => {
            let along = bodies[pair.b].turned(plane::direction(angle));
            let drive = plane::dot(reaction.force(), along);
            reaction.fx -= drive * along[0];
            reaction.fy -= drive * along[1];
            drive
        }
    }
}

/// Equilibrium of the input link: the reaction on body `a` of its pair with the ground, and the load of the drive.
#[inline(always)]
fn input_link<T: Real>(
    pair: &Pair,
    (input, along): (usize, [T; 2]),
    bodies: &[Body<T>],
    loads: &[Wrench<T>],
) -> (Wrench<T>, T) {
    let (body, load) = (&bodies[input], &loads[input]);
    let on_input = pair.a == input;
    let signed = |x: T| if on_input { x } else { -x };
    match pair.geometry {
        PairGeometry::Pin { at_a, at_b } => {
            let own = plane::vector(if on_input { at_a } else { at_b });
            let reaction = Wrench { fx: signed(-load.fx), fy: signed(-load.fy), m: T::ZERO };
            (reaction, -load.about(body.arm(own)))
        }
        PairGeometry::Slide { point, .. } => {
            // The drive takes the component along the guide, the guide the one across.
            let force = load.force();
            let across = plane::cross(along, force);
            let [x, y] = bodies[pair.a].point(plane::vector(point));
            let reaction = Wrench {
                fx: signed(across * along[1]),
                fy: signed(-(across * along[0])),
                m: signed(-load.about([x - body.x, y - body.y])),
            };
            (reaction, -plane::dot(force, along))
        }
    }
}
