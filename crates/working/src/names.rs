//! Names in a working.

use std::collections::BTreeSet;

use assur_kinematics::Linkage;
use assur_mechanism::{Balance, LoadKind, Mechanism, Name, Place};
use assur_words::{Language, Text, joined, name, text};
use assur_worksheet::{Names, Symbol};

/// Names of all bodies, pairs and places in a working. The name of a pair in a joint of more than two links contains
/// its links, because its reaction is only a part of the joint's reaction.
pub(crate) fn of(linkage: &Linkage) -> Names {
    let mechanism = &linkage.mechanism;
    let mut places = Places { found: Vec::new(), used: BTreeSet::new() };
    for point in &mechanism.points {
        let name = places.unique(letters(&point.name).into());
        for place in &point.places {
            places.found.push((place.link, place.at, name.clone()));
        }
    }
    for (link, found) in mechanism.links.iter().enumerate().skip(1) {
        if found.is_heavy() {
            places.add(Place { link, at: found.center }, Symbol::from("S").of(letters(&found.name)));
        }
    }
    for slide in &mechanism.slides {
        places.add(Place { link: slide.link, at: slide.point }, Symbol::from("K").of(letters(&slide.name)));
        places.add(Place { link: slide.on, at: slide.through }, Symbol::from("T").of(letters(&slide.name)));
    }
    places.loads(mechanism);
    let mut used = BTreeSet::new();
    let bodies = mechanism.links.iter().map(|link| {
        let mut body = letters(&link.name);
        while !used.insert(Symbol::from(&body).of(0).plain(Language::english())) {
            body = joined("", [body, name("_")]);
        }
        body
    });
    let bodies = bodies.collect();
    let sources = linkage.structure.pairs.iter().enumerate();
    let pairs = sources.map(|(id, pair)| {
        let name = letters(linkage.structure.pair_name(mechanism, id));
        if !linkage.structure.is_share(id) {
            return name;
        }
        let [a, b] = [pair.pair.a, pair.pair.b].map(|link| letters(&mechanism.links[link].name));
        assur_words::list([name, a, b])
    });
    Names { bodies, places: places.found, pairs: pairs.collect() }
}

struct Places {
    found: Vec<(usize, [f64; 2], Symbol)>,
    used: BTreeSet<String>,
}

impl Places {
    fn unique(&mut self, mut symbol: Symbol) -> Symbol {
        while !self.used.insert(symbol.plain(Language::english())) {
            symbol = symbol.of("_");
        }
        symbol
    }

    fn add(&mut self, place: Place, symbol: Symbol) {
        let same = |at: [f64; 2]| at[0] - place.at[0] == 0.0 && at[1] - place.at[1] == 0.0;
        if !self.found.iter().any(|(link, at, _)| *link == place.link && same(*at)) {
            let symbol = self.unique(symbol);
            self.found.push((place.link, place.at, symbol));
        }
    }

    fn loads(&mut self, mechanism: &Mechanism) {
        for load in &mechanism.loads {
            let name = || letters(&load.name);
            match &load.kind {
                LoadKind::Force(force) => self.add(force.at, Symbol::from("K").of(name())),
                LoadKind::Spring(spring) => {
                    for (number, end) in spring.ends.into_iter().enumerate() {
                        self.add(end, Symbol::from("E").of(number + 1).of(name()));
                    }
                }
                LoadKind::Contact(contact) => self.add(contact.center, Symbol::from("N").of(name())),
                LoadKind::Moment(_) | LoadKind::Brake(_) => {}
            }
        }
        if let Some(Balance::Force { at, .. }) = mechanism.balance {
            self.add(at, Symbol::from("K").of(text!("working-balancing")));
        }
    }
}

/// A name in which no letter ends a subscript.
fn letters(of: &Name) -> Text {
    if of.contains(['{', '}']) { name(of.replace(['{', '}'], "_")) } else { of.into() }
}
