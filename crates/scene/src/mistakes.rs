//! What a scene says that is probably not meant, as far as its numbers and names tell by themselves.

mod task;

use std::collections::HashMap;

use assur_mechanism::{GROUND, Key, LinkId, Mechanism, Warning, appearance};
use assur_words::{name, quantity, text};

use crate::text::{codes, rounded, shown};

/// A link so many times as long as the middle one of the others has a wrong unit: mm for m gives a thousand times, and lengths that
/// are meant differ by less than a hundred.
const MOST_TIMES_LONGER: f64 = 200.0;
/// Links that are mostly longer than this, m, were given in another unit.
const LONGEST: f64 = 20.0;
/// A radius of gyration, or a distance of the center of mass from the points of its link, of so many sizes of the mechanism
/// belongs to no link; flywheels and counterweights are smaller.
const MOST_TIMES_THE_SIZE: f64 = 10.0;

/// A counterweight or a pendulum lies at most so many sizes of the mechanism from the points of its link.
const FARTHEST_COUNTERWEIGHT: f64 = 4.0;
/// A link that turns about no fixed pin can't carry a rotor or a flywheel: its mass lies within its mechanism.
const MOST_OF_A_COUPLER: f64 = 1.5;
/// A radius of gyration of less than this part of the length of its link is that of a needle: g*mm^2 for kg*mm^2.
const LEAST_OF_THE_LENGTH: f64 = 2e-3;
/// A link so many times as heavy, or as light, as the others has a wrong unit: g for kg gives a thousand times.
const MOST_TIMES_HEAVIER: f64 = 300.0;

/// Everything that is probably not meant; `units`: whether lengths of links have units, `gives_inertia`: whether a link of this name
/// has a moment of inertia, be it 0.
pub(crate) fn of(mechanism: &Mechanism, units: bool, gives_inertia: impl Fn(&str) -> bool) -> Vec<Warning> {
    let mut warnings = names(mechanism);
    warnings.extend(masses(mechanism));
    let extents: Vec<f64> = (0..mechanism.links.len()).map(|link| extent(mechanism, link)).collect();
    for link in 0..mechanism.links.len() {
        warnings.extend(length(mechanism, link, &extents));
    }
    // A boom of "30 m" is one.
    warnings.extend(all_lengths(mechanism, &extents).filter(|_| !units));
    let size = extents.iter().copied().fold(0.0, f64::max);
    if warnings.is_empty() && size > 0.0 {
        warnings.extend(task::of(mechanism, size));
        for (link, length) in extents.iter().enumerate().skip(GROUND + 1) {
            warnings.extend(inertia(mechanism, link, size, *length));
            warnings.extend(center(mechanism, link, size));
            warnings.extend(without_mass(mechanism, link));
            let missing = without_inertia(mechanism, link, &extents);
            warnings.extend(missing.filter(|_| !gives_inertia(&mechanism.links[link].name)));
        }
    }
    warnings
}

/// Points with names that look the same, but are written in different alphabets.
fn names(mechanism: &Mechanism) -> Vec<Warning> {
    let mut seen: HashMap<String, &str> = HashMap::new();
    let mut warnings = Vec::new();
    for point in &mechanism.points {
        let like = *seen.entry(appearance(&point.name)).or_insert(&point.name);
        if like != point.name.as_str() {
            let link = point.places.first().map_or(GROUND, |place| place.link);
            warnings.push(Warning::mistake(
                key(mechanism, link).at("points").at(&point.name),
                text!(
                    "scene-same-appearance",
                    name = shown(&point.name),
                    codes = name(codes(&point.name)),
                    other = name(codes(like))
                ),
            ));
        }
    }
    warnings
}

fn key(mechanism: &Mechanism, link: LinkId) -> Key {
    if link == GROUND { Key::of("ground") } else { Key::of("link").at(&mechanism.links[link].name) }
}

/// The greatest distance between two points of a link, m.
fn extent(mechanism: &Mechanism, link: LinkId) -> f64 {
    let places =
        || mechanism.points.iter().flat_map(|point| &point.places).filter(|place| place.link == link);
    let Some(first) = places().next() else { return 0.0 };
    // Half of the greatest distance, or more, is found from any point.
    places().map(|place| (place.at[0] - first.at[0]).hypot(place.at[1] - first.at[1])).fold(0.0, f64::max)
}

/// The middle one of some lengths, m, that are not 0; of two the smaller.
fn middle(lengths: impl Iterator<Item = f64>) -> Option<f64> {
    let mut lengths: Vec<f64> = lengths.filter(|length| *length > 0.0).collect();
    lengths.sort_by(f64::total_cmp);
    lengths.get(lengths.len().checked_sub(1)? / 2).copied()
}

/// Links that are mostly too long for a machine.
fn all_lengths(mechanism: &Mechanism, extents: &[f64]) -> Option<Warning> {
    let middle = middle(extents.iter().skip(1).copied()).filter(|middle| *middle > LONGEST)?;
    let link = (1..extents.len()).find(|link| extents[*link] >= middle)?;
    let text = text!("scene-long-links", length = quantity(rounded(middle), "m"));
    Some(Warning::mistake(key(mechanism, link).at("points"), text))
}

/// A link that is far longer than the others.
fn length(mechanism: &Mechanism, link: LinkId, extents: &[f64]) -> Option<Warning> {
    let others = extents.iter().enumerate().filter(|(other, _)| *other != link).map(|(_, extent)| *extent);
    let middle = middle(others)?;
    (extents[link] > MOST_TIMES_LONGER * middle).then(|| {
        let [own, middle] = [extents[link], middle].map(|length| quantity(rounded(length), "m"));
        let link_name = shown(&mechanism.links[link].name);
        let text = text!("scene-far-longer", link = link_name, length = own, others = middle);
        Warning::mistake(key(mechanism, link).at("points"), text)
    })
}

/// Whether a pin joins a link to the ground.
fn is_pinned(mechanism: &Mechanism, link: LinkId) -> bool {
    mechanism.points.iter().any(|point| point.on(GROUND).and(point.on(link)).is_some())
}

/// A moment of inertia that belongs to a far greater body.
fn inertia(mechanism: &Mechanism, link: LinkId, size: f64, length: f64) -> Option<Warning> {
    let body = &mechanism.links[link];
    let radius = (body.inertia.constant() / body.mass).sqrt();
    let most = if is_pinned(mechanism, link) { MOST_TIMES_THE_SIZE } else { MOST_OF_A_COUPLER };
    if !radius.is_finite() || radius <= 0.0 {
        return None;
    }
    let id = if radius > most * size {
        "scene-great-inertia"
    } else if radius < LEAST_OF_THE_LENGTH * length {
        "scene-small-inertia"
    } else {
        return None;
    };
    let [radius, size] =
        [radius, if radius > size { size } else { length }].map(|length| quantity(rounded(length), "m"));
    let text = text!(id, link = shown(&body.name), radius, size);
    Some(Warning::mistake(key(mechanism, link).at("inertia"), text))
}

/// Links whose mass has another unit than those of the others: far from every other one, or else far above the middle one.
fn masses(mechanism: &Mechanism) -> Vec<Warning> {
    let links = || mechanism.links.iter().enumerate().skip(GROUND + 1).filter(|(_, body)| body.mass > 0.0);
    let doubt = |link: LinkId, alone: bool| {
        let mass = mechanism.links[link].mass;
        let others = || links().filter(move |(other, _)| *other != link).map(|(_, body)| body.mass);
        // Of one other link it is not known which of both is wrong.
        let middle = middle(others()).filter(|_| others().count() > 1)?;
        let heavy = mass > MOST_TIMES_HEAVIER * middle;
        let light = mass * MOST_TIMES_HEAVIER < middle;
        let is_odd = if alone {
            others().all(|other| (mass / other).ln().abs() > MOST_TIMES_HEAVIER.ln()) && (heavy || light)
        } else {
            heavy
        };
        is_odd.then(|| {
            let [own, others] = [mass, middle].map(|mass| quantity(rounded(mass), "kg"));
            let id = if heavy { "scene-far-heavier" } else { "scene-far-lighter" };
            let link_name = shown(&mechanism.links[link].name);
            let text = text!(id, link = link_name, mass = own, others);
            Warning::mistake(key(mechanism, link).at("mass"), text)
        })
    };
    let found = |alone: bool| links().filter_map(|(link, _)| doubt(link, alone)).collect::<Vec<_>>();
    let alone = found(true);
    if alone.is_empty() { found(false) } else { alone }
}

/// A link that is pinned to nothing fixed moves as a whole: what has a moment of inertia has a mass there.
fn without_mass(mechanism: &Mechanism, link: LinkId) -> Option<Warning> {
    let body = &mechanism.links[link];
    (body.mass == 0.0 && !is_pinned(mechanism, link) && body.inertia.constant() > 0.0).then(|| {
        let text = text!("scene-inertia-without-mass", link = shown(&body.name));
        Warning::mistake(key(mechanism, link).at("inertia"), text)
    })
}

/// A link whose moment of inertia is missing: others that turn have one. Of the input link it is often left out, since it does nothing
/// at a constant speed; a link that is guided on the ground does not turn.
fn without_inertia(mechanism: &Mechanism, link: LinkId, extents: &[f64]) -> Option<Warning> {
    let is_guided = |link: LinkId| {
        mechanism
            .slides
            .iter()
            .any(|slide| [slide.link, slide.on] == [link, GROUND] || [slide.on, slide.link] == [link, GROUND])
    };
    let turns = |link: LinkId| {
        link != GROUND
            && !mechanism.input.places(link)
            && extents[link] > 0.0
            && mechanism.links[link].mass > 0.0
            && !is_guided(link)
    };
    let has = |link: LinkId| {
        let inertia = &mechanism.links[link].inertia;
        inertia.constant() > 0.0 || inertia.varying().is_some()
    };
    let mut others = (0..extents.len()).filter(|other| *other != link && turns(*other)).peekable();
    (turns(link) && !has(link) && others.peek().is_some() && others.all(has)).then(|| {
        let text = text!("scene-mass-without-inertia", link = shown(&mechanism.links[link].name));
        Warning::mistake(key(mechanism, link).at("mass"), text)
    })
}

/// A center of mass far outside of its link.
fn center(mechanism: &Mechanism, link: LinkId, size: f64) -> Option<Warning> {
    let body = &mechanism.links[link];
    let places = mechanism.points.iter().flat_map(|point| &point.places).filter(|place| place.link == link);
    let away = places.map(|place| (place.at[0] - body.center[0]).hypot(place.at[1] - body.center[1]));
    let away = away.fold(f64::INFINITY, f64::min);
    let most = if is_pinned(mechanism, link) { FARTHEST_COUNTERWEIGHT } else { MOST_OF_A_COUPLER };
    (body.mass > 0.0 && away.is_finite() && away > most * size).then(|| {
        let [away, size] = [away, size].map(|length| quantity(rounded(length), "m"));
        let text = text!("scene-far-center", link = shown(&body.name), distance = away, size);
        Warning::mistake(key(mechanism, link).at("center"), text)
    })
}
