//! Loads that hold a motion at rest together: the equilibrium gives what they do to the input in sum, not the share of each.

use std::collections::BTreeMap;

use assur_group::{Body, Wrench};
use assur_mechanism::{LinkId, LoadId};
use assur_number::{ROUNDING, elementary};

use crate::loads::{Applied, Cause};
use crate::{LoadState, Loads, Side, power};

/// What changes of a load with the sense of the motion.
struct Jump {
    wrenches: Vec<(LinkId, Wrench<f64>)>,
    /// Its virtual power for dq = 1.
    power: f64,
}

impl Loads {
    /// Whether several loads may hold a motion at rest together.
    pub fn may_share(&self) -> bool {
        let may_jump = |load: &&Applied| load.turns_with_speed() || load.laws().any(|law| law.used().speed);
        self.applied.iter().filter(may_jump).count() > 1
    }

    /// Whether loads hold a motion at rest in a state.
    pub fn holds_at_rest(state: &LoadState) -> bool {
        state.speed == 0.0 && matches!(state.side, Side::Held { .. })
    }

    /// What changes on the links where a load that holds the motion at rest takes over from another one, each with the size of what it
    /// consists of, N m; all of them do no work together. Empty where one load alone holds it.
    pub(crate) fn exchanges(
        &self,
        state: &LoadState,
        bodies: &[Body<f64>],
        scale: f64,
    ) -> Vec<(Vec<Wrench<f64>>, f64)> {
        let mut jumps = self.jumps(state, bodies, scale);
        let greatest =
            (0..jumps.len()).max_by(|&a, &b| jumps[a].power.abs().total_cmp(&jumps[b].power.abs()));
        let Some(base) = greatest.filter(|_| jumps.len() > 1).map(|greatest| jumps.swap_remove(greatest))
        else {
            return Vec::new();
        };
        let exchange = |jump: &Jump| {
            let (mut wrenches, mut sum) = (vec![Wrench::ZERO; self.links], 0.0);
            let instead = if base.power == 0.0 { 0.0 } else { -jump.power / base.power };
            for (part, jump) in [(1.0, jump), (instead, &base)] {
                for (link, wrench) in &jump.wrenches {
                    let (wrench, all) = (times(wrench, part), &mut wrenches[*link]);
                    *all = Wrench { fx: all.fx + wrench.fx, fy: all.fy + wrench.fy, m: all.m + wrench.m };
                    sum += size(&wrench, scale);
                }
            }
            (wrenches, sum)
        };
        jumps.iter().map(exchange).collect()
    }

    /// The loads that change with the sense of a motion at rest.
    fn jumps(&self, state: &LoadState, bodies: &[Body<f64>], scale: f64) -> Vec<Jump> {
        let mut found: BTreeMap<(LoadId, LinkId), [Wrench<f64>; 2]> = BTreeMap::new();
        for (side, upper) in [0.0, 1.0].into_iter().enumerate() {
            let state = LoadState { side: Side::Held { upper }, ..*state };
            self.by_cause(&state, bodies, &mut |cause, link, wrench| {
                if let Cause::Load(load) = cause {
                    found.entry((load, link)).or_insert([Wrench::ZERO; 2])[side] = wrench;
                }
            });
        }
        let mut jumps: BTreeMap<LoadId, Jump> = BTreeMap::new();
        for ((load, link), [below, above]) in found {
            let jump = Wrench { fx: above.fx - below.fx, fy: above.fy - below.fy, m: above.m - below.m };
            if size(&jump, scale) > ROUNDING * (size(&below, scale) + size(&above, scale)) {
                let all = jumps.entry(load).or_insert(Jump { wrenches: Vec::new(), power: 0.0 });
                all.power += power(&jump, &bodies[link]);
                all.wrenches.push((link, jump));
            }
        }
        jumps.into_values().collect()
    }
}

fn times(wrench: &Wrench<f64>, factor: f64) -> Wrench<f64> {
    Wrench { fx: factor * wrench.fx, fy: factor * wrench.fy, m: factor * wrench.m }
}

/// The size of a wrench on a mechanism of this size, N m.
pub(crate) fn size(wrench: &Wrench<f64>, scale: f64) -> f64 {
    elementary::hypot(wrench.fx, wrench.fy) * scale + wrench.m.abs()
}
