//! Mechanisms with several drives over time.

use assur_group::GroupPlugin;
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, Mechanism, Motion, Range, TimeLaw};

use super::draft::{Draft, Drive};
use super::recipe::{LEAST_HEALTH, Recipe, TRIES, health, mechanism_of};

/// Number of instants.
const INSTANTS: usize = 4;

impl Recipe {
    /// Constructs a mechanism with so many drives, in pins and slides against the ground and between moving links, whose coordinates
    /// grow evenly in time; the same for the same seed. Groups are as in [`mixed`](Self::mixed), or of the only kind. `None` if none of
    /// many constructions stayed away from singular positions.
    pub fn several(&self, seed: u64, drives: usize) -> Option<Mechanism> {
        let mut kinds = Self::mixed_kinds()?;
        kinds.retain(|kind| self.only.is_none_or(|only| only == kind.name));
        let attempt = |attempt| self.driven(seed.wrapping_mul(TRIES).wrapping_add(attempt), drives, &kinds);
        (0..TRIES).find_map(attempt)
    }

    fn driven(&self, seed: u64, count: usize, kinds: &[&'static GroupPlugin]) -> Option<Mechanism> {
        let mut draft = Draft::new(seed);
        let mut drives: Vec<Drive> = Vec::new();
        for group in 0..self.groups {
            while drives.len() < count && (drives.is_empty() || group < count && draft.rng.chance(0.4)) {
                let on = if drives.is_empty() || draft.rng.chance(0.4) {
                    GROUND
                } else {
                    draft.rng.below(draft.links.len())
                };
                let sliding = draft.rng.chance(0.3);
                drives.push(draft.driven(on, sliding));
            }
            Self::group(&mut draft, kinds)?;
        }
        while drives.len() < count {
            let sliding = draft.rng.chance(0.5);
            drives.push(draft.part(&drives, sliding)?);
        }
        let mut mechanism = mechanism_of(&mut draft, &drives);
        let until = draft.rng.range(0.3, 3.0);
        for (driver, drive) in mechanism.input.drivers.iter_mut().zip(&drives) {
            let unit = if driver.is_angle() { 1.0 } else { draft.size };
            let way = draft.rng.signed(0.03, 0.4) * unit;
            driver.law = Some(TimeLaw::uniform(drive.from, way / until));
        }
        let input = &mut mechanism.input;
        (input.is_list, input.from, input.positions, input.range) = (true, 0.0, INSTANTS, Range::To(until));
        mechanism.motion = Some(Motion::Prescribed { speed: 1.0, acceleration: 0.0 });
        if self.loads {
            super::loads::add_over_time(&mut draft, &mut mechanism);
        }
        let linkage = Linkage::compile(mechanism.clone()).ok()?;
        (health(&linkage, &mechanism.input, 10) > LEAST_HEALTH).then_some(mechanism)
    }
}
