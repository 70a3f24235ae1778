//! Pair reactions summed to what each pin and slide of the scene exerts.

use assur_kinematics::Linkage;
use assur_mechanism::{LinkId, PairId};

use crate::Reactions;

/// What one pin or slide exerts.
#[derive(Debug, Clone, PartialEq)]
pub struct JointReaction {
    /// The pin or slide.
    pub joint: PairId,
    /// Force on each link that it joins, N, in the order of the scene; of a slide, the sliding link first. They sum to zero.
    pub forces: Vec<(LinkId, [f64; 2])>,
    /// Of a slide: moment on the sliding link about its point, N m; the force acts at that point.
    pub moment: Option<f64>,
}

/// The reactions of all joints: pins in the order of the points, then slides.
///
/// A multiple joint is several pairs; the force of the pin on a link is the sum over the pairs of that link.
pub fn joint_reactions(linkage: &Linkage, reactions: &Reactions) -> Vec<JointReaction> {
    let mechanism = &linkage.mechanism;
    let pins = mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin());
    let mut joints: Vec<_> = pins
        .map(|(id, point)| JointReaction {
            joint: PairId::Pin(id),
            forces: point.places.iter().map(|place| (place.link, [0.0; 2])).collect(),
            moment: None,
        })
        .collect();
    joints.extend(mechanism.slides.iter().enumerate().map(|(id, slide)| JointReaction {
        joint: PairId::Slide(id),
        forces: vec![(slide.link, [0.0; 2]), (slide.on, [0.0; 2])],
        moment: Some(0.0),
    }));
    for (named, reaction) in linkage.structure.pairs.iter().zip(&reactions.pairs) {
        let Some(joint) = joints.iter_mut().find(|joint| joint.joint == named.source) else { continue };
        for (link, force) in &mut joint.forces {
            let sign =
                f64::from(u8::from(*link == named.pair.a)) - f64::from(u8::from(*link == named.pair.b));
            force[0] += sign * reaction.fx;
            force[1] += sign * reaction.fy;
        }
        if let Some(moment) = &mut joint.moment {
            *moment += reaction.m;
        }
    }
    joints
}
