//! Reactions of joints as plain data.

use assur_force::{Reactions, joints};
use assur_kinematics::Linkage;
use assur_structure::name_of;
use serde::Serialize;

/// The force that a pin or slide exerts on one of its links.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct JointForce {
    /// Pin or slide.
    pub joint: String,
    /// The link that the force acts on.
    pub on: String,
    /// Force, N.
    pub force: [f64; 2],
    /// Of a slide, for the sliding link: moment about its point, N m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moment: Option<f64>,
}

/// All reactions: pins in the order of the points, then slides; each for every link that it joins.
pub fn joint_forces(linkage: &Linkage, reactions: &Reactions) -> Vec<JointForce> {
    let mechanism = &linkage.mechanism;
    let mut list = Vec::new();
    for joint in joints(&linkage.mechanism, &linkage.structure) {
        for (nth, link) in joint.links.iter().enumerate() {
            list.push(JointForce {
                joint: name_of(mechanism, joint.id).to_owned(),
                on: mechanism.links[*link].name.clone(),
                force: joint.force(nth, &reactions.pairs),
                moment: joint.moment(&reactions.pairs).filter(|_| nth == 0),
            });
        }
    }
    list
}
