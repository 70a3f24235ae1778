//! Force polygons of the groups and of the input link (S figs. 15, 17).

use assur_force::{Acting, Cause, Reactions, UnitBalance, VectorKind, drive_direction};
use assur_group::Body;
use assur_group::plane::{opposite, scaled};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Driver, GROUND, LinkId};
use assur_words::{Text, joined, name, text};

use crate::plan::{VectorPlan, length};

/// Forces below this part of the greatest reaction of the mechanism count as zero.
const UNLOADED: f64 = 1e-6;

/// The polygons of the groups from the last to the first, as they are analyzed, then that of the input link.
///
/// Sides are the loads of the group's links and the reactions of the pairs that join it to other bodies, link after
/// link, head to tail; they close. Where a group has two links, the reaction of the inner pair is the diagonal between
/// them. Moments are not part of a polygon. Unit N; the first corner is the origin.
pub fn force_polygons(
    linkage: &Linkage,
    position: &Position,
    loads: &[Acting],
    reactions: &Reactions,
) -> Vec<VectorPlan> {
    let (mechanism, structure) = (&linkage.mechanism, &linkage.structure);
    let greatest = reactions.pairs.iter().map(|pair| length(pair.force())).fold(0.0, f64::max);
    let balance = balance(linkage, position, reactions);
    let bodies = &position.bodies;
    let drawer = Drawer { linkage, bodies, loads, reactions, balance, floor: UNLOADED * greatest };
    let groups = structure.groups.iter().enumerate().rev().map(|(index, group)| {
        let title = text!("plan-forces-of", group = structure.group_name(mechanism, index));
        drawer.polygon(title, &group.frame.links)
    });
    let inputs = mechanism.input.placed().map(|input| {
        let title = text!("plan-forces-of-input", link = &mechanism.links[input].name);
        drawer.polygon(title, &[input])
    });
    groups.chain(inputs).collect()
}

/// The balancing force on each link on which it acts; none of a moment.
fn balance(linkage: &Linkage, position: &Position, reactions: &Reactions) -> Vec<(LinkId, [f64; 2])> {
    let mechanism = &linkage.mechanism;
    let elsewhere = UnitBalance::of(mechanism).map(|unit| {
        let along = unit.wrench(&position.bodies).force();
        (unit.link, scaled(reactions.balancing, along))
    });
    let of_drive = |(driver, size): (&Driver, f64)| {
        let along = drive_direction(mechanism, driver, &position.bodies)?;
        Some([(driver.link, scaled(size, along)), (driver.on, scaled(-size, along))])
    };
    let drives = reactions.of_drives(mechanism).filter_map(of_drive).flatten();
    let all = elsewhere.into_iter().chain(drives);
    all.filter(|(link, force)| *link != GROUND && *force != [0.0, 0.0]).collect()
}

struct Drawer<'a> {
    linkage: &'a Linkage,
    bodies: &'a [Body<f64>],
    loads: &'a [Acting],
    reactions: &'a Reactions,
    balance: Vec<(LinkId, [f64; 2])>,
    /// Forces below this are rounding, N; a group with no greater force is unloaded.
    floor: f64,
}

impl Drawer<'_> {
    fn polygon(&self, title: Text, links: &[LinkId]) -> VectorPlan {
        let mut plan = VectorPlan::new(title, "N");
        let mut corner = [0.0; 2];
        for (nth, &link) in links.iter().enumerate() {
            corner = self.sides(&mut plan, link, links, corner);
            // In a group of two links the inner reactions close the polygon of the first link.
            let inner = if nth == 0 { self.pairs(link, |other| links.contains(&other)) } else { Vec::new() };
            let mut start = corner;
            for (joint, force, note) in inner.into_iter().filter(|_| links.len() == 2) {
                start = plan.push(start, (VectorKind::Inner, joint, force, note));
            }
        }
        plan.point(text!("plan-start"), [0.0; 2]);
        let mut plan = plan.finish(length(corner));
        plan.residual = length(corner) / plan.greatest().max(self.floor).max(f64::MIN_POSITIVE);
        plan
    }

    /// Draws the loads of a link, then the reactions from other bodies; returns the last corner.
    fn sides(&self, plan: &mut VectorPlan, link: LinkId, links: &[LinkId], mut corner: [f64; 2]) -> [f64; 2] {
        let mechanism = &self.linkage.mechanism;
        let own = |load: &Acting| load.link == link && load.wrench.force() != [0.0, 0.0];
        for (number, load) in self.loads.iter().enumerate().filter(|(_, load)| own(load)) {
            // The number that the load has on the links and in every other polygon.
            let symbol = |after: &str| name(format!("F{}{after}", number + 1));
            let kind = match load.cause {
                Cause::Weight(_) => VectorKind::Weight,
                Cause::Inertia(_) => VectorKind::Inertia,
                Cause::Load(_) => VectorKind::Load,
            };
            let note = || text!("plan-load-on", link = &mechanism.links[link].name);
            let told = Text::from(load.cause.name(mechanism));
            if let Some([normal, friction]) = load.parts(mechanism, self.bodies) {
                let normal_of = text!("plan-normal-of-contact", contact = &told);
                corner = plan.push_as(symbol(""), corner, (kind, normal_of, normal, note()));
                let friction_of = text!("plan-friction-of-contact", contact = told);
                corner = plan.push_as(symbol("′"), corner, (kind, friction_of, friction, note()));
                continue;
            }
            corner = plan.push_as(symbol(""), corner, (kind, told, load.wrench.force(), note()));
        }
        for (_, force) in self.balance.iter().filter(|(loaded, _)| *loaded == link) {
            let note = text!("plan-balancing-on", link = &mechanism.links[link].name);
            let balancing = (VectorKind::Balancing, name("Fb"), *force, note);
            corner = plan.push_as(name("Fb"), corner, balancing);
        }
        let outside = |other: LinkId| other == GROUND || !links.contains(&other);
        for (joint, force, note) in self.pairs(link, outside) {
            corner = plan.push(corner, (VectorKind::Reaction, joint, force, note));
        }
        corner
    }

    /// Reactions on a link in its pairs with the selected bodies: name, force, meaning.
    fn pairs(&self, link: LinkId, wanted: impl Fn(LinkId) -> bool) -> Vec<(Text, [f64; 2], Text)> {
        let (mechanism, structure) = (&self.linkage.mechanism, &self.linkage.structure);
        let mut list = Vec::new();
        for (id, named) in structure.pairs.iter().enumerate() {
            let pair = &named.pair;
            if !pair.joins(link) || !wanted(pair.other(link)) {
                continue;
            }
            let on_a = self.reactions.pairs[id].force();
            let force = if pair.a == link { on_a } else { opposite(on_a) };
            let joint = Text::from(structure.pair_name(mechanism, id));
            let other = pair.other(link);
            let [on, from] = [link, other].map(|link| Text::from(&mechanism.links[link].name));
            let symbol = if structure.is_share(id) {
                text!("plan-share-of-reaction", pair = &joint, link = &from)
            } else {
                joined("", [name("R("), joint.clone(), name(")")])
            };
            let note = match (pair.is_slide(), other == GROUND) {
                (true, true) => text!("plan-guide-from-ground", pair = joint, on = on),
                (true, false) => text!("plan-guide-on", pair = joint, on = on, from = from),
                (false, true) => text!("plan-pin-from-ground", pair = joint, on = on),
                (false, false) => text!("plan-pin-on", pair = joint, on = on, from = from),
            };
            list.push((symbol, force, note));
        }
        list
    }
}
