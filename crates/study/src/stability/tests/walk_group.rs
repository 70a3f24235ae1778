//! Walks a single group towards each of its singular positions.

use assur_check::Finding;
use assur_group::{
    AssurGroup, Body, GroupError, GroupFrame, Number, Order, Wrench, derive_generally, reactions_generally,
};
use assur_number::{Dd, Real};
use assur_structure::Group;
use assur_words::{Text, name};

use super::Law;
use super::isolated::{Isolated, Side};
use crate::stability::exact::{ORDERS, reactions, size, transfer};
use crate::stability::row::{Comparison, DISTANCES, FACTOR, accept_without_digits};

const LINKS: [usize; 2] = [2, 3];

/// The bodies that the group is joined to.
const JOINED: [usize; 2] = [4, 1];

/// Of the linear system of two links.
const EQUATIONS: f64 = 6.0;

pub(super) static LAW: Law = Law {
    section: "Groups alone",
    along: "distance of the group alone from its singular position, in parts of its lengths",
    expected: "16 eps * (longest / shortest length) / determinant^k: k = 1 for places and where the determinant \
               is linear in the data, 2 for derivatives and reactions where it is the root of a difference \
               of lengths; where PF1 or PF2 is small against its terms (the motion of the bodies that the group is joined to, PF1^2 / determinant), times their quotient; six \
               times that for the linear system of six equations",
};

/// One distance: the group in both numbers, and how errors grow.
struct Place<'a> {
    words: String,
    distance: f64,
    frame: &'a GroupFrame,
    bodies: [Body<f64>; 5],
    powers: [i32; 2],
    disparity: f64,
    size: f64,
}

/// What the reference says.
struct Reference {
    health: f64,
    bodies: Vec<Body<Dd>>,
    pairs: [Wrench<Dd>; 3],
}

/// Walks a group towards each of its singular positions in each of its ways; nothing for a kind without a known walk.
pub(super) fn walk(title: &str, group: &Group) -> Vec<Comparison> {
    let mut rows = Vec::new();
    let Some(isolated) = Isolated::of(group) else { return rows };
    for side in isolated.sides() {
        for distance in DISTANCES {
            step(title, group, &isolated, side, distance, &mut rows);
        }
    }
    rows
}

fn step(
    title: &str,
    group: &Group,
    isolated: &Isolated,
    side: Side,
    distance: f64,
    rows: &mut Vec<Comparison>,
) {
    let Some((frame, bodies)) = isolated.posed(side, distance) else { return };
    let (Ok(double), Ok(extended)) =
        (f64::build(&group.plugin.builders, &frame), Dd::build(&group.plugin.builders, &frame))
    else {
        return;
    };
    for way in 0..double.ways() {
        let words = if double.ways() > 1 { format!(", way {way}") } else { String::new() };
        let place = Place {
            words: format!("{title}, {}{words}", side.words()),
            distance,
            frame: &frame,
            bodies,
            powers: isolated.powers(side),
            disparity: isolated.disparity(),
            size: isolated.size,
        };
        // Where rounding of the data has carried the group beyond the singular position there is nothing to compare.
        let Ok(reference) = place.reference(&*extended, way) else { continue };
        place.closed(group.plugin.name, &*double, way, &reference, rows);
        place.general(&*double, way, &reference, rows);
    }
}

/// Places are counted in units of the size, derivatives by the largest of them alone.
fn floor(order: usize) -> f64 {
    if order == 0 { 1.0 } else { f64::MIN_POSITIVE }
}

/// Loads on the two links.
fn loads(size: f64) -> [Wrench<f64>; 5] {
    let mut loads = [Wrench::ZERO; 5];
    loads[2] = Wrench { fx: 1.0, fy: -0.7, m: 0.3 * size };
    loads[3] = Wrench { fx: -0.4, fy: 0.9, m: -0.2 * size };
    loads
}

impl Place<'_> {
    fn reference(&self, kernel: &dyn AssurGroup<Dd>, way: usize) -> Result<Reference, GroupError> {
        let mut bodies: Vec<_> = self.bodies.iter().map(|one| one.map(Dd::from_f64)).collect();
        let health = kernel.solve(&mut bodies, way, Order::Second)?.to_f64().abs();
        let mut loads = loads(self.size).each_ref().map(|load| load.map(Dd::from_f64));
        let mut pairs = [Wrench::ZERO; 3];
        kernel.reactions(&bodies, &mut loads, &mut pairs)?;
        Ok(Reference { health, bodies, pairs })
    }

    fn subject(&self, method: &str, quantity: &'static str, reference: &Reference) -> Comparison {
        let power = self.powers[usize::from(quantity != "pf0")];
        let lost = match quantity {
            "pf1" => self.given(reference, 1),
            "pf2" => self.cancelled(reference).max(self.given(reference, 2)),
            _ => 1.0,
        };
        let bound = FACTOR * self.disparity * lost * f64::EPSILON / reference.health.powi(power);
        Comparison {
            method: name(method.to_owned()),
            quantity,
            distance: self.distance,
            health: reference.health,
            finding: Finding::within(name(self.words.clone()), bound),
        }
    }

    /// How much greater the motion of the bodies that the group is joined to is than its own, which is their difference.
    fn given(&self, reference: &Reference, order: usize) -> f64 {
        let size = |links: &[usize]| size(&reference.bodies, links, order, self.size, f64::MIN_POSITIVE);
        (size(&JOINED) / size(&LINKS)).max(1.0)
    }

    /// How much greater the terms of PF2, PF1²/health, are than their sum.
    fn cancelled(&self, reference: &Reference) -> f64 {
        let size = |order| size(&reference.bodies, &LINKS, order, self.size, f64::MIN_POSITIVE);
        (size(1).powi(2) / reference.health / size(2)).max(1.0)
    }

    /// A refusal in words, with the distance and the place.
    fn refused(&self, error: GroupError) -> Text {
        name(format!("{error}, {:.0e} from: {}", self.distance, self.words))
    }

    /// The closed forms of the kind.
    fn closed(
        &self,
        method: &str,
        kernel: &dyn AssurGroup<f64>,
        way: usize,
        reference: &Reference,
        rows: &mut Vec<Comparison>,
    ) {
        let mut bodies = self.bodies;
        let placed = kernel.place(&mut bodies, way).map(|_| ());
        let mut order_done = placed;
        for (order, quantity) in ORDERS.into_iter().enumerate() {
            if order == 1 && placed.is_ok() {
                order_done = kernel.solve(&mut bodies, way, Order::Second).map(|_| ());
            }
            let outcome = order_done
                .map(|()| transfer(&bodies, &reference.bodies, &LINKS, order, self.size, floor(order)))
                .map_err(|error| self.refused(error));
            rows.push(self.subject(method, quantity, reference).judged(outcome));
        }
        let mut pairs = [Wrench::ZERO; 3];
        let outcome = placed
            .and_then(|()| kernel.reactions(&bodies, &mut loads(self.size), &mut pairs))
            .map(|()| reactions(&pairs, &reference.pairs, self.size))
            .map_err(|error| self.refused(error));
        rows.push(self.subject(method, "reactions", reference).judged(outcome));
    }

    /// A row of a linear system, in which each of its equations adds its roundings, and which can't know when to refuse.
    fn unaware(
        &self,
        method: &str,
        quantity: &'static str,
        reference: &Reference,
        outcome: Result<f64, Text>,
    ) -> Comparison {
        let subject = self.subject(method, quantity, reference);
        let bound = EQUATIONS * subject.finding.bound;
        let finding = Finding { bound, ..subject.finding };
        let mut row = Comparison { finding, ..subject }.judged(outcome);
        accept_without_digits(&mut row);
        row
    }

    /// Derivatives and reactions from the one linear system of the group, at the places of the closed form.
    fn general(
        &self,
        kernel: &dyn AssurGroup<f64>,
        way: usize,
        reference: &Reference,
        rows: &mut Vec<Comparison>,
    ) {
        const METHOD: &str = "general (linear system)";
        let mut bodies = self.bodies;
        let Ok(_) = kernel.place(&mut bodies, way) else { return };
        let mut pairs = [Wrench::ZERO; 3];
        let forces = reactions_generally(self.frame, &bodies, &mut loads(self.size), &mut pairs, 1)
            .map(|()| reactions(&pairs, &reference.pairs, self.size))
            .map_err(|error| self.refused(error));
        let derived = derive_generally(self.frame, &mut bodies, Order::Second);
        for (order, quantity) in ORDERS.into_iter().enumerate().skip(1) {
            let outcome = derived
                .map(|()| transfer(&bodies, &reference.bodies, &LINKS, order, self.size, floor(order)))
                .map_err(|error| self.refused(error));
            rows.push(self.unaware(METHOD, quantity, reference, outcome));
        }
        rows.push(self.unaware(METHOD, "reactions", reference, forces));
    }
}
