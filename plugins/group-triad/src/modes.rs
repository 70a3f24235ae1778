//! All modes of a group, and the one of a way that is nearest to a pose.

use assur_group::{Body, GroupError, Mode};
use assur_number::{Real, elementary};

use crate::{kernel::Legged, mover::Mover, order};

/// A mode farther than this from the pose on entry, rad or parts of the size, is another one.
const FAR: f64 = 0.5;

/// Most steps towards a place where two modes meet: each halves the distance.
const MOST_STEPS_TO_MEETING: usize = 60;

/// A pose of base and plate: what decides the others.
pub(crate) type Core<T> = [Body<T>; 2];

impl<T: Real> Legged<T> {
    #[inline(always)]
    pub(crate) fn core(&self, bodies: &[Body<T>]) -> Core<T> {
        let base = self.base.as_ref().map_or_else(Body::ground, |base| bodies[base.link]);
        [base, bodies[self.plate.link]]
    }

    pub(crate) fn put_core(&self, core: &Core<T>, bodies: &mut [Body<T>]) {
        if let Some(base) = &self.base {
            bodies[base.link] = core[0];
        }
        bodies[self.plate.link] = core[1];
    }

    /// Distance of two poses, rad or parts of the size.
    fn apart(&self, one: &Core<T>, other: &Core<T>) -> f64 {
        let size = |a: T, b: T| elementary::hypot(a.to_f64(), b.to_f64());
        let movers = [self.base.as_ref(), Some(&self.plate)];
        let distance = |(k, mover): (usize, Option<&Mover<T>>)| {
            let Some(mover) = mover else { return 0.0 };
            let (a, b) = (&one[k], &other[k]);
            let [ha, hb] = [a, b].map(|body| body.point(mover.own()));
            let way = size(ha[0] - hb[0], ha[1] - hb[1]) * mover.inverse_size.to_f64();
            way.max(size(a.c - b.c, a.s - b.s))
        };
        movers.into_iter().enumerate().map(distance).fold(0.0, f64::max)
    }

    /// All poses of base and plate in which the group can be assembled, with their determinants; the bodies are changed.
    fn cores(&self, bodies: &mut [Body<T>]) -> Result<Vec<(Core<T>, f64)>, GroupError> {
        let loci = self.loci(bodies);
        let Some(poses) = loci.poses() else { return Err(GroupError::Singular { health: 0.0 }) };
        let mut found: Vec<(Core<T>, f64)> = Vec::new();
        for pose in &poses {
            self.put_pose(pose, bodies);
            let raw = self.core(bodies);
            let polished = self.polish(bodies);
            if !polished.converged
                || polished.way > FAR
                || self.lone_lines(bodies).0.open() > self.rounding_at(bodies)
            {
                // Where two modes meet, Newton's method converges slowly, if at all.
                self.put_core(&raw, bodies);
                if !self.approach(bodies) {
                    continue;
                }
            }
            let health = self.lone_lines(bodies).1.to_f64();
            let core = self.core(bodies);
            // One mode that is found twice has its rounding, magnified by the determinant; two that are next to each other have
            // opposite signs.
            let rounding = 64.0 * T::EPSILON;
            let is_new = found.iter().all(|(other, its)| {
                let twice = if (*its > 0.0) == (health > 0.0) { rounding / health.abs() } else { 0.0 };
                self.apart(other, &core) > (1e-4 * health.abs()).max(rounding).max(twice)
            });
            if is_new {
                found.push((core, health));
            }
        }
        if found.is_empty() {
            return Err(GroupError::NoAssembly { gap_m: loci.gap() });
        }
        Ok(found)
    }

    /// Goes to the pose with the least violations on the way of Newton's method; whether that closes the group. So it finds
    /// the place where two modes meet, to half of the digits.
    fn approach(&self, bodies: &mut [Body<T>]) -> bool {
        self.settle(bodies);
        let start = self.core(bodies);
        let mut best = (self.lone_lines(bodies).0.open(), start);
        for _ in 0..MOST_STEPS_TO_MEETING {
            if self.lone_step(bodies).to_f64().is_nan() || self.apart(&start, &self.core(bodies)) > FAR {
                break;
            }
            let gap = self.lone_lines(bodies).0.open();
            if gap < best.0 {
                best = (gap, self.core(bodies));
            }
        }
        self.put_core(&best.1, bodies);
        best.0 <= self.rounding_at(bodies)
    }

    /// Places base and plate in the mode whose determinant has the sign of the way and which is nearest to their poses.
    pub(crate) fn place_far(
        &self,
        bodies: &mut [Body<T>],
        start: &Core<T>,
        way: usize,
    ) -> Result<(), GroupError> {
        let found = self.cores(bodies)?;
        let resolution = (256.0 * T::EPSILON).sqrt();
        let fits = |health: f64| health.abs() <= resolution || (health > 0.0) == (way == 0);
        let nearest = found.iter().filter(|(_, health)| fits(*health));
        let nearest =
            nearest.map(|(core, _)| (self.apart(core, start), core)).min_by(|a, b| a.0.total_cmp(&b.0));
        match nearest {
            Some((distance, core)) if distance <= FAR => {
                self.put_core(core, bodies);
                Ok(())
            }
            // Other modes remain: no length misses.
            _ => Err(GroupError::NoAssembly { gap_m: 0.0 }),
        }
    }

    /// All modes in their order.
    pub(crate) fn listed(&self, bodies: &[Body<T>]) -> Result<Vec<Mode<T>>, GroupError> {
        let mut bodies = bodies.to_vec();
        let found = self.cores(&mut bodies)?;
        let mut modes = Vec::new();
        for (core, health) in found {
            self.put_core(&core, &mut bodies);
            self.finish(&mut bodies);
            let own = self.frame.links.iter().map(|&link| bodies[link]).collect();
            let way = usize::from(health <= 0.0);
            modes.push((order::key(self, &bodies), Mode { bodies: own, way, health: health.abs() }));
        }
        order::sort(&mut modes);
        Ok(modes.into_iter().map(|(_, mode)| mode).collect())
    }
}
