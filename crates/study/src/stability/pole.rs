//! The published form of longitudinal reactions has a singular position of its own: the pole at infinity.

use assur_group::{Body, PairGeometry, plane};
use assur_kinematics::Linkage;

/// The published form of longitudinal reactions.
const PUBLISHED: &str = "longitudinal-published";

/// How errors of a method grow by a singular position of its own, beside those of the groups: 1/sine.
pub(crate) fn growth(linkage: &Linkage, method: &str, bodies: &[Body<f64>]) -> f64 {
    let own = sine(linkage, bodies).filter(|_| method == PUBLISHED);
    own.map_or(1.0, |sine| 1.0 / sine.max(f64::MIN_POSITIVE))
}

/// Sine of the angle between the crank and line 3 (the normal of the guide, or the rocker): 0 with the pole at infinity.
/// `None` for a mechanism other than a crank with one group.
fn sine(linkage: &Linkage, bodies: &[Body<f64>]) -> Option<f64> {
    let [group] = linkage.structure.groups.as_slice() else { return None };
    let crank = linkage.mechanism.input.link;
    let pin = |pair: &assur_group::Pair| match pair.geometry {
        PairGeometry::Pin { at_a, .. } => Some(bodies[pair.a].point(at_a)),
        PairGeometry::Slide { .. } => None,
    };
    let o = pin(&linkage.structure.pairs.first()?.pair)?;
    let at = |body: usize| group.frame.outer.iter().find(|pair| pair.joins(body));
    let a = pin(at(crank)?)?;
    let last = at(0)?;
    let line = match last.geometry {
        PairGeometry::Slide { angle, .. } => plane::perp(bodies[last.b].turned(plane::direction(angle))),
        PairGeometry::Pin { .. } => plane::minus(pin(group.frame.inner.first()?)?, pin(last)?),
    };
    let arm = plane::minus(a, o);
    let lengths = arm[0].hypot(arm[1]) * line[0].hypot(line[1]);
    Some((plane::cross(arm, line) / lengths).abs())
}
