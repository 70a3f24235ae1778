//! Names in a working.

use std::collections::BTreeSet;

use assur_kinematics::Linkage;
use assur_mechanism::{Balance, Mechanism, Place};
use assur_worksheet::{Names, symbol_of};

/// Names of all bodies, pairs and places in a working. The name of a pair in a joint of more than two links contains
/// its links, because its reaction is only a part of the joint's reaction.
pub(crate) fn of(linkage: &Linkage) -> Names {
    let mechanism = &linkage.mechanism;
    let mut places = Places { found: Vec::new(), used: BTreeSet::new() };
    for point in &mechanism.points {
        let name = places.unique(&point.name);
        for place in &point.places {
            places.found.push((place.link, place.at, name.clone()));
        }
    }
    for (link, found) in mechanism.links.iter().enumerate().skip(1) {
        if found.mass != 0.0 || found.inertia != 0.0 {
            places.add(Place { link, at: found.center }, &format!("S_{}", found.name));
        }
    }
    for slide in &mechanism.slides {
        places.add(Place { link: slide.link, at: slide.point }, &format!("K_{}", slide.name));
        places.add(Place { link: slide.on, at: slide.through }, &format!("T_{}", slide.name));
    }
    places.loads(mechanism);
    let mut used = BTreeSet::new();
    let bodies = mechanism.links.iter().map(|link| unique(&mut used, &link.name)).collect();
    let sources = linkage.structure.pairs.iter().enumerate();
    let pairs = sources.map(|(id, pair)| {
        let name = linkage.structure.pair_name(mechanism, id);
        if !linkage.structure.is_share(id) {
            return name.to_string();
        }
        let [a, b] = [pair.pair.a, pair.pair.b].map(|link| mechanism.links[link].name.as_str());
        format!("{name}_{a}_{b}")
    });
    Names { bodies, places: places.found, pairs: pairs.collect() }
}

struct Places {
    found: Vec<(usize, [f64; 2], String)>,
    used: BTreeSet<String>,
}

impl Places {
    fn unique(&mut self, name: &str) -> String {
        unique(&mut self.used, name)
    }

    fn add(&mut self, place: Place, name: &str) {
        let same = |at: [f64; 2]| at[0] - place.at[0] == 0.0 && at[1] - place.at[1] == 0.0;
        if !self.found.iter().any(|(link, at, _)| *link == place.link && same(*at)) {
            let name = self.unique(name);
            self.found.push((place.link, place.at, name));
        }
    }

    fn loads(&mut self, mechanism: &Mechanism) {
        for force in &mechanism.forces {
            self.add(force.at, &format!("K_{}", force.name));
        }
        for spring in &mechanism.springs {
            self.add(spring.ends[0], &format!("E1_{}", spring.name));
            self.add(spring.ends[1], &format!("E2_{}", spring.name));
        }
        for contact in &mechanism.contacts {
            self.add(contact.center, &format!("N_{}", contact.name));
        }
        if let Some(Balance::Force { at, .. }) = mechanism.balance {
            self.add(at, "K_balance");
        }
    }
}

fn unique(used: &mut BTreeSet<String>, name: &str) -> String {
    let mut name = symbol_of(name);
    while !used.insert(name.clone()) {
        name.push('_');
    }
    name
}
