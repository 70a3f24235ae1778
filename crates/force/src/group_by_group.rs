//! Kinetostatics group by group, for any scalar type: from the last group to the input link (S, stage 9).

use assur_group::{AssurGroup, Body, Number, Pair, PairGeometry, Wrench, plane};
use assur_kinematics::Linkage;
use assur_number::Real;

/// Finds the reactions of all groups, from the last to the first, and then the equilibrium of the input link; returns
/// the load of the drive at the input: a moment (N m), or a force along the guide (N).
///
/// `loads`: one wrench for each body about the origin of its frame; each group adds its reactions on the bodies that
/// carry it. `pairs`: the reaction on body `a` of each pair. `solve` finds the reactions of one group, given its
/// number; it may skip a group, whose reactions then stay unchanged.
///
/// # Errors
///
/// Those of `solve`.
#[inline]
pub fn group_by_group<T: Number, E>(
    linkage: &Linkage,
    groups: &[Box<dyn AssurGroup<T>>],
    bodies: &[Body<T>],
    loads: &mut [Wrench<T>],
    pairs: &mut [Wrench<T>],
    mut solve: impl FnMut(usize, &dyn AssurGroup<T>, &mut [Wrench<T>], &mut [Wrench<T>]) -> Result<(), E>,
) -> Result<T, E> {
    for (index, group) in groups.iter().enumerate().rev() {
        solve(index, group.as_ref(), loads, pairs)?;
    }
    let input = linkage.mechanism.input.link;
    let (reaction, drive) = input_link(&linkage.structure.pairs[0].pair, input, bodies, loads);
    pairs[0] = reaction;
    Ok(drive)
}

/// Equilibrium of the input link: the reaction on body `a` of its pair with the ground, and the load of the drive.
#[inline]
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
