//! Which link is the crank, the coupler, the slider or rocker; and why another mechanism has no such links.

use assur_group::plane::minus;
use assur_group::{Pair, PinJoint, SlideJoint};
use assur_kinematics::Linkage;
use assur_mechanism::{Balance, GROUND, InputPair, LinkId};
use assur_words::{Text, name, text};

/// The roles of links and pairs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Layout {
    pub(crate) crank: LinkId,
    pub(crate) coupler: LinkId,
    /// Slider or rocker.
    pub(crate) third: LinkId,
    /// Crank and ground, seen from the crank.
    pub(crate) o: PinJoint<f64>,
    /// Coupler and crank, seen from the coupler.
    pub(crate) a: PinJoint<f64>,
    /// Coupler and third link, seen from the coupler.
    pub(crate) b: PinJoint<f64>,
    /// Third link and ground, seen from the third link.
    pub(crate) end: End,
}

/// How the third link is joined to the ground.
#[derive(Debug, Clone, Copy)]
pub(crate) enum End {
    Guide(SlideJoint<f64>),
    Pin(PinJoint<f64>),
}

impl Layout {
    /// # Errors
    ///
    /// Why the mechanism has no such layout, as a clause.
    pub(crate) fn of(linkage: &Linkage) -> Result<Self, Text> {
        let (mechanism, structure) = (&linkage.mechanism, &linkage.structure);
        let crank = mechanism.input.link;
        let link = |id: LinkId| &mechanism.links[id].name;
        if matches!(mechanism.input.pair, InputPair::Slide(_)) {
            return Err(text!("force-longitudinal-no-crank", link = link(crank)));
        }
        if mechanism.balance.is_some_and(|balance| balance != Balance::Moment(crank)) {
            return Err(text!("force-longitudinal-balance", link = link(crank)));
        }
        let [group] = structure.groups.as_slice() else {
            return Err(text!("force-longitudinal-groups", groups = structure.groups.len()));
        };
        if !matches!(group.plugin.name, "rrp" | "rrr") {
            return Err(text!("force-longitudinal-kind", kind = name(group.plugin.kind)));
        }
        let frame = &group.frame;
        let (Some(inner), Some(first), Some(last)) =
            (frame.inner.first(), outer_at(&frame.outer, crank), outer_at(&frame.outer, GROUND))
        else {
            return Err(text!("force-longitudinal-bodies", link = link(crank)));
        };
        if first.is_slide() {
            return Err(text!("force-longitudinal-slide", link = link(crank)));
        }
        let coupler = first.other(crank);
        let third = last.other(GROUND);
        let input = &structure.pairs[0].pair;
        let end =
            if last.is_slide() { slide(last, third).map(End::Guide) } else { pin(last, third).map(End::Pin) };
        let layout = Self {
            crank,
            coupler,
            third,
            o: pin(input, crank)?,
            a: pin(first, coupler)?,
            b: pin(inner, coupler)?,
            end: end?,
        };
        let [x, y] = minus(layout.a.at, layout.o.own);
        if x == 0.0 && y == 0.0 {
            return Err(text!("force-longitudinal-no-length", link = link(crank)));
        }
        Ok(layout)
    }
}

fn outer_at(outer: &[Pair], body: LinkId) -> Option<&Pair> {
    outer.iter().find(|pair| pair.joins(body))
}

fn pin(pair: &Pair, link: LinkId) -> Result<PinJoint<f64>, Text> {
    PinJoint::new(&pair.seen_from(link)).map_err(|error| error.what)
}

fn slide(pair: &Pair, link: LinkId) -> Result<SlideJoint<f64>, Text> {
    SlideJoint::new(&pair.seen_from(link)).map_err(|error| error.what)
}
