//! Pair reactions summed to the reactions of each pin and slide of the scene.

use assur_kinematics::Linkage;
use assur_mechanism::{LinkId, PairId};

use crate::Reactions;

/// The reactions of one pin or slide.
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
    let mut joints = Vec::with_capacity(mechanism.points.len() + mechanism.slides.len());
    let mut of_point = vec![usize::MAX; mechanism.points.len()];
    for (id, point) in mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin()) {
        of_point[id] = joints.len();
        let forces = point.places.iter().map(|place| (place.link, [0.0; 2])).collect();
        joints.push(JointReaction { joint: PairId::Pin(id), forces, moment: None });
    }
    let pins = joints.len();
    joints.extend(mechanism.slides.iter().enumerate().map(|(id, slide)| JointReaction {
        joint: PairId::Slide(id),
        forces: vec![(slide.link, [0.0; 2]), (slide.on, [0.0; 2])],
        moment: Some(0.0),
    }));
    for (named, reaction) in linkage.structure.pairs.iter().zip(&reactions.pairs) {
        let index = match named.source {
            PairId::Pin(point) => of_point[point],
            PairId::Slide(slide) => pins + slide,
        };
        let Some(joint) = joints.get_mut(index) else { continue };
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
