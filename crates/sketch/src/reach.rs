//! In which positions a mechanism can be assembled.

use assur_kinematics::Linkage;
use assur_mechanism::Input;

use crate::frame::Frame;
use crate::group::Plan;
use crate::pose::{distance, reduced};
use crate::{Fit, sketch};

/// A link is where it was drawn if it differs by less than this, in parts of the size and in rad: rounding moves it less, and other modes
/// are farther.
pub(crate) const SAME: f64 = 0.15;

/// How far a mechanism can be assembled, and whether no modes meet in its motion.
pub(crate) type Quality = (Fit, bool);

/// The best quality.
pub(crate) const BEST: Quality = (Fit::Everywhere, true);

/// Whether the links of a scene are as they were drawn, and whether the mechanism can be assembled in all positions.
pub(crate) fn quality(scene: &str, frames: &[Frame], plan: &Plan<'_>) -> Quality {
    let Ok(reading) = assur_scene::reading("", scene) else { return (Fit::Nowhere, false) };
    let found = sketch(&reading.mechanism);
    let is_drawn = plan.links.iter().zip(frames).all(|(link, frame)| {
        let pose = found.pose(link);
        pose.is_some_and(|pose| {
            distance(pose.at, frame.pose.at) < SAME * plan.size
                && reduced(pose.angle - frame.pose.angle).abs() < SAME
        })
    });
    let same_position = found.coordinate.to_bits() == plan.sketch.coordinate.to_bits();
    if !(is_drawn && same_position) {
        return (Fit::Nowhere, false);
    }
    let linkage = found.is_assembled().then(|| Linkage::compile(reading.mechanism).ok()).flatten();
    match linkage.filter(reaches_all) {
        Some(linkage) => (Fit::Everywhere, linkage.change_points().next().is_none()),
        None => (Fit::Here, false),
    }
}

/// Most positions that are asked whether they are reached.
pub(crate) const MOST_POSITIONS: usize = 100;

/// The numbers of positions of an input, of many only some, the first and the last among them.
pub(crate) fn some_positions(input: &Input, most: usize) -> impl Iterator<Item = usize> {
    let (count, step) = (input.positions, input.positions.div_ceil(most).max(1));
    (0..count).step_by(step).chain(count.checked_sub(1).filter(|_| step > 1))
}

/// Whether the motion from the first position reaches all others.
pub(crate) fn reaches_all(linkage: &Linkage) -> bool {
    let input = &linkage.mechanism.input;
    let reaches = |index: usize| linkage.reaches(input.coordinate(index));
    linkage.range.is_some_and(|range| range.full) || some_positions(input, MOST_POSITIONS).all(reaches)
}
