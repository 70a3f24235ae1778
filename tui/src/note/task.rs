//! The task: the mechanism as it is given.

use assur_mechanism::GROUND;

use super::Context;
use super::document::Block;
use crate::number::plain;
use crate::screen::state::View;

/// Page of a mechanism, mm.
pub(super) const MECHANISM: [f64; 2] = [160.0, 110.0];

/// Heading, data of links, pairs and loads, and the mechanism drawn, moving.
pub(super) fn blocks(context: &mut Context<'_>) -> Vec<Block> {
    let words = context.words;
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let mechanism = scene.linkage.mechanism.clone();
    let number = |value: f64| words.number(&plain(value));
    let mm = |at: [f64; 2]| at.map(|x| number(1e3 * x)).join("; ");
    let input = &mechanism.links[mechanism.input.link].name;
    let values = [("positions", mechanism.input.positions.to_string()), ("link", input.clone())];
    let mut blocks = vec![Block::Heading(words.get("task")), Block::Text(words.with("task-text", &values))];
    let mut points = Vec::new();
    for (link, of) in mechanism.links.iter().enumerate() {
        for (id, point) in mechanism.points.iter().enumerate() {
            if let Some([x, y]) = mechanism.place_in(id, link) {
                points.push(vec![of.name.clone(), point.name.clone(), number(1e3 * x), number(1e3 * y)]);
            }
        }
    }
    let head = [words.get("link"), words.get("point"), "x".to_owned(), "y".to_owned()];
    blocks.push(Block::table(words, "points-of-links", head, points));
    let slides = mechanism.slides.iter().map(|slide| {
        let [link, on] = [slide.link, slide.on].map(|link| mechanism.links[link].name.clone());
        vec![slide.name.clone(), link, on, mm(slide.through), number(slide.angle.to_degrees())]
    });
    let slides: Vec<_> = slides.collect();
    if !slides.is_empty() {
        let head = ["pair", "link", "guide"].map(|id| words.get(id));
        let head = head.into_iter().chain(["x; y".to_owned(), words.get("direction")]);
        blocks.push(Block::table(words, "slides", head, slides));
    }
    let masses = mechanism.links.iter().filter(|link| link.mass > 0.0 || link.inertia > 0.0);
    let masses: Vec<_> = masses
        .map(|link| vec![link.name.clone(), number(link.mass), mm(link.center), number(link.inertia)])
        .collect();
    if !masses.is_empty() {
        let head = ["link", "mass", "center", "inertia"].map(|id| words.get(id));
        blocks.push(Block::table(words, "masses", head, masses));
    }
    let loads = loads(context);
    if !loads.is_empty() {
        let head = [context.words.get("load"), String::new()];
        blocks.push(Block::table(context.words, "loads", head, loads));
    }
    blocks.extend(moving(context));
    blocks
}

fn loads(context: &Context<'_>) -> Vec<Vec<String>> {
    let words = context.words;
    let Some(scene) = &context.state.scene else { return Vec::new() };
    let mechanism = &scene.linkage.mechanism;
    let number = |value: f64| words.number(&plain(value));
    let name = |link: usize| ("link", mechanism.links[link].name.clone());
    let mut rows = Vec::new();
    if let Some([x, y]) = mechanism.gravity {
        rows.push(vec!["G".to_owned(), words.with("gravity", &[("g", number(x.hypot(y)))])]);
    }
    for force in &mechanism.forces {
        let [x, y] = force.at.at.map(|value| number(1e3 * value));
        let values = [("x", x), ("y", y), name(force.at.link)];
        rows.push(vec![force.name.clone(), words.with("force-at", &values)]);
    }
    for moment in &mechanism.moments {
        rows.push(vec![moment.name.clone(), words.with("moment-on", &[name(moment.link)])]);
    }
    for spring in &mechanism.springs {
        let [one, two] = spring.ends.map(|end| mechanism.links[end.link].name.clone());
        let values = [
            ("one", one),
            ("other", two),
            ("stiffness", number(spring.stiffness)),
            ("damping", number(spring.damping)),
        ];
        rows.push(vec![spring.name.clone(), words.with("spring-between", &values)]);
    }
    for contact in &mechanism.contacts {
        rows.push(vec![contact.name.clone(), words.with("contact-of", &[name(contact.center.link)])]);
    }
    rows
}

/// The mechanism over one cycle.
fn moving(context: &mut Context<'_>) -> Option<Block> {
    let count = context.state.positions();
    let exists = |context: &Context<'_>, position: usize| {
        context.state.scene.as_ref().is_some_and(|scene| {
            scene.poses[position].is_some() && scene.linkage.mechanism.links.len() > GROUND
        })
    };
    let mut frames = Vec::new();
    for position in 0..count {
        if exists(context, position) {
            frames.push(context.figure(View::Mechanism, position, |_| {})?.0);
        }
    }
    let caption = context.words.get("mechanism-moving");
    (!frames.is_empty()).then_some(Block::Picture { frames, size: MECHANISM, caption })
}
