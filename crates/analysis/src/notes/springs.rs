//! Springs that can't act because their ends meet.

use assur_group::Order;
use assur_mechanism::Spring;

use super::Listed;
use crate::Calculation;

impl Calculation {
    /// Springs whose ends meet in positions of the scene: there they have no direction and give no force, even with a
    /// free length.
    pub(super) fn springs_without_direction(&self) -> Vec<String> {
        /// Ends nearer to each other than this part of the scale of the mechanism meet.
        const NEAR: f64 = 1e-12;
        let (linkage, mechanism) = (&self.linkage, &self.linkage.mechanism);
        let mut position = linkage.position();
        let mut meets = |spring: &Spring, index: usize| {
            if linkage.solve_index(index, Order::Place, &mut position).is_err() {
                return false;
            }
            let [a, b] = spring.ends.map(|end| position.bodies[end.link].point(end.at));
            (b[0] - a[0]).hypot(b[1] - a[1]) <= NEAR * linkage.structure.scale
        };
        let pushing = mechanism.springs.iter().filter(|spring| spring.stiffness > 0.0 && spring.length > 0.0);
        let words = pushing.filter_map(|spring| {
            let found: Listed =
                (0..mechanism.input.positions).filter(|index| meets(spring, *index)).collect();
            (!found.is_empty()).then(|| {
                format!(
                    "The ends of spring `{}` meet in {}: it has no direction and gives no force there, though its free length \
                     is {} m; place one end elsewhere.",
                    spring.name,
                    found.words(),
                    spring.length
                )
            })
        });
        words.collect()
    }
}
