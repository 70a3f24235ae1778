//! The acceleration of a motion, where the certificate proves that there is one: in small fixed memory, since an integrator asks for
//! it at every evaluation.

use assur_force::{FreeMotion, FrictionForces, FrictionSolution, Reactions};
use assur_number::Real;

use crate::quick::{Bearings, Quick, Table};

impl Quick<'_, f64> {
    /// The acceleration with its reactions and friction; `None` where a more careful method is needed.
    pub(crate) fn accelerated(
        &self,
        motion: &FreeMotion<'_>,
        out: &mut Reactions,
    ) -> Option<FrictionSolution> {
        f64::evaluate(
            #[inline(always)]
            move || match out.friction.as_ref()?.frictions.whole.firsts.len() {
                1..=3 => self.moving::<3, 8>(motion, out),
                4..=8 => self.moving::<8, 18>(motion, out),
                _ => None,
            },
        )
    }

    #[inline(always)]
    fn moving<const N: usize, const C: usize>(
        &self,
        motion: &FreeMotion<'_>,
        out: &mut Reactions,
    ) -> Option<FrictionSolution> {
        let FrictionForces { frictions, senses, .. } = out.friction.as_ref()?;
        let (frictions, senses) = (frictions.clone(), senses.clone());
        let stages = &frictions.whole.stages;
        let bearings = Bearings::<f64, N>::of(&frictions, &senses, &frictions.whole)?;
        out.pairs.fill(assur_group::Wrench::ZERO);
        let mut table: Table<f64, N, C> =
            self.table(&bearings, stages, [motion.loads, motion.inertia], out)?;
        table.accelerate(motion.drive, motion.drive_inertia)?;
        table.without_normals(&bearings)?;
        let (_, sums) = table.equations(&bearings).solve(false)?;
        let acceleration = table.drive(&sums);
        let Reactions { friction: Some(friction), pairs, solved, .. } = out else { return None };
        friction.forces.fill(0.0);
        let FrictionForces { loads, forces, .. } = friction;
        loads.clear();
        loads.extend_from_slice(motion.loads);
        crate::chain::add(loads, acceleration, motion.inertia);
        self.rub(&bearings, &table, &sums, forces, loads);
        for &stage in stages {
            self.respond(stage, solved, loads, pairs)?;
        }
        self.tell(friction, pairs);
        let (pairs, forces) = (pairs.clone(), friction.forces.clone());
        acceleration.is_finite().then_some(FrictionSolution {
            balancing: acceleration,
            pairs,
            forces,
            taken: false,
        })
    }
}
