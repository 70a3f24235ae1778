//! Kinetostatics group by group, for any number type: from the last group to the input link (S, stage 9).

use assur_group::{AssurGroup, Body, GroupError, Number, Pair, PairGeometry, Wrench, plane};
use assur_kinematics::Linkage;
use assur_number::Real;

use crate::{ForceError, Reactions, UnitBalance, balance::IdleBalance};

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
/// the guide (N). Of an input link the reaction of its pair is written too; a driven pair of a group loses the part of the drive.
#[inline(always)]
pub fn drive<T: Real>(
    linkage: &Linkage,
    bodies: &[Body<T>],
    loads: &[Wrench<T>],
    pairs: &mut [Wrench<T>],
) -> T {
    let pair = &linkage.structure.pairs[0].pair;
    let Some(input) = linkage.mechanism.input.placed() else {
        return drive_of_pair(pair, bodies, &mut pairs[0]);
    };
    let (reaction, drive) = input_link(pair, input, bodies, loads);
    pairs[0] = reaction;
    drive
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
fn input_link<T: Real>(pair: &Pair, input: usize, bodies: &[Body<T>], loads: &[Wrench<T>]) -> (Wrench<T>, T) {
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
            // The coordinate is the displacement along the guide, so that PF1 of the origin is the guide's direction.
            // The drive takes the component along it, the guide the one across.
            let along = [body.x1, body.y1];
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
