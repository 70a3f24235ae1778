//! Joining the outer pairs of a group: what each is joined to is chosen in the picture, or typed.

use assur_draft::Part;
use assur_group::PairSort;
use assur_mechanism::GROUND;
use assur_sketch::{Names, Sketch, Target};
use assur_words::{Text, name, text};
use crossterm::event::KeyCode;

use super::{draft, fields, form};
use crate::screen::state::{Entry, FormSource, Join, Key, Role, State, Task, place, round};

/// Half of the opening of the sector in which a direction looks for things: the tangent of 60 degrees.
const SECTOR: f64 = 1.75;

/// Asks for the next pair, or adds the group where all are joined.
pub(super) fn go_on(state: &mut State) {
    let Task::Join(join) = &mut state.build.task else { return };
    (join.entry, join.chosen) = (Entry::default(), None);
    if join.pair().is_none() {
        let Task::Join(join) = std::mem::take(&mut state.build.task) else { return };
        finish(state, &join);
    }
}

pub(super) fn press(state: &mut State, key: Key) {
    let Task::Join(join) = &mut state.build.task else { return };
    let typed = !join.entry.is_empty();
    match key.code {
        KeyCode::Enter => take(state),
        KeyCode::Tab | KeyCode::BackTab => choose_next(state, if key.code == KeyCode::Tab { 1 } else { -1 }),
        KeyCode::Left if !typed => go(state, [-1.0, 0.0]),
        KeyCode::Right if !typed => go(state, [1.0, 0.0]),
        KeyCode::Up if !typed => go(state, [0.0, 1.0]),
        KeyCode::Down if !typed => go(state, [0.0, -1.0]),
        KeyCode::Backspace if !typed => drop(join.targets.pop()),
        _ => {
            join.entry.press(key);
        }
    }
}

fn choose_next(state: &mut State, by: isize) {
    let Some(sketch) = state.build.sketch() else { return };
    let Task::Join(join) = &state.build.task else { return };
    let all = join.candidates(sketch);
    let now = join.chosen.as_ref().and_then(|chosen| all.iter().position(|one| one == chosen));
    let next =
        now.map_or(if by > 0 { 0 } else { all.len().saturating_sub(1) }, |now| round(now, by, all.len()));
    let next = all.get(next).cloned();
    if let Task::Join(join) = &mut state.build.task {
        (join.chosen, join.entry) = (next, Entry::default());
    }
}

fn go(state: &mut State, direction: [f64; 2]) {
    let Some(sketch) = state.build.sketch() else { return };
    let Task::Join(join) = &state.build.task else { return };
    let all = join.candidates(sketch).into_iter();
    let places: Vec<_> = all.filter_map(|part| Some((place(sketch, &part)?, part))).collect();
    let from = join.chosen.as_ref().and_then(|part| place(sketch, part));
    let next = nearest_in(&places, from, direction).cloned();
    if let (Some(next), Task::Join(join)) = (next, &mut state.build.task) {
        join.chosen = Some(next);
    }
}

/// The thing that is nearest in a direction; without a place to begin from the first one.
pub(super) fn nearest_in<'a>(
    places: &'a [([f64; 2], Part)],
    from: Option<[f64; 2]>,
    [dx, dy]: [f64; 2],
) -> Option<&'a Part> {
    let Some([x, y]) = from else { return places.first().map(|(_, part)| part) };
    let rated = |(place, part): &'a ([f64; 2], Part)| {
        let [along, across] =
            [(place[0] - x) * dx + (place[1] - y) * dy, ((place[0] - x) * dy - (place[1] - y) * dx).abs()];
        (along > 0.0 && across <= SECTOR * along).then_some((along + across, part))
    };
    let rated = places.iter().filter_map(rated);
    rated.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, part)| part)
}

/// Takes what is typed or chosen for the pair in hand.
fn take(state: &mut State) {
    let Some(sketch) = state.build.sketch() else { return };
    let Task::Join(join) = &state.build.task else { return };
    let typed = join.entry.trim();
    let target = if typed.is_empty() {
        match &join.chosen {
            Some(Part::Point(point)) => of_words(sketch, join, point),
            Some(Part::Link(link)) => of_words(sketch, join, link),
            _ => Err(text!("build-join-what")),
        }
    } else {
        of_words(sketch, join, typed)
    };
    put(state, target);
}

fn put(state: &mut State, target: Result<Target, Text>) {
    match target {
        Ok(target) => {
            if let Task::Join(join) = &mut state.build.task {
                join.targets.push(target);
            }
            go_on(state);
        }
        Err(problem) => state.say(Role::Bad, problem),
    }
}

/// A click: the thing that is near, or a new place on the ground.
pub(super) fn click(state: &mut State, at: [f64; 2]) -> bool {
    let Some(sketch) = state.build.sketch() else { return false };
    let Task::Join(join) = &state.build.task else { return false };
    let near = sketch.size() / 20.0;
    let all = join.candidates(sketch).into_iter();
    let distance = |[x, y]: [f64; 2]| (x - at[0]).hypot(y - at[1]);
    let places = all.filter_map(|part| Some((distance(place(sketch, &part)?), part)));
    let nearest = places.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|(distance, _)| *distance <= near);
    let [x, y] = at.map(|x| (1e3 * x).round());
    let words = match nearest {
        Some((_, Part::Point(name) | Part::Link(name))) => name,
        _ => format!("{x}, {y}"),
    };
    let target = of_words(sketch, join, &words);
    put(state, target);
    true
}

/// What words mean for the pair in hand: `A`, a point; `0, -400`, a place of the ground, mm; `rocker 700`, a place on a link;
/// for a slide also a third number, the angle of its guide, degrees.
pub(super) fn of_words(sketch: &Sketch, join: &Join, words: &str) -> Result<Target, Text> {
    let mut pieces = words.split([' ', ',', ';']).filter(|piece| !piece.is_empty()).peekable();
    let number =
        |piece: &str| piece.replace('\u{2212}', "-").parse::<f64>().ok().filter(|value| value.is_finite());
    let named = pieces.next_if(|piece| number(piece).is_none());
    let mut numbers = Vec::new();
    for piece in pieces.filter(|piece| !["mm", "deg"].contains(piece)) {
        numbers.push(number(piece).ok_or_else(|| text!("build-no-number", word = name(piece.to_owned())))?);
    }
    let is_slide = join.pair() == Some(PairSort::Slide);
    let mechanism = &sketch.mechanism;
    let known =
        |find: &str| mechanism.points.iter().find(|point| point.name.as_str().eq_ignore_ascii_case(find));
    let angle = numbers.get(2).copied().unwrap_or_default().to_radians();
    if let (Some(point), true) = (named.and_then(known), numbers.is_empty()) {
        if !is_slide {
            return Ok(Target::Point(point.name.to_string()));
        }
        let of = point.places.iter().map(|place| place.link).min().unwrap_or(GROUND);
        let through =
            sketch.place(point.name.as_str()).ok_or_else(|| text!("build-no-place", name = &point.name))?;
        let link = mechanism.links[of].name.to_string();
        return Ok(Target::Guide {
            link,
            through,
            angle: sketch.bodies[of].map_or(0.0, |pose| pose.angle),
            point: Some(point.name.to_string()),
        });
    }
    let link = match named {
        Some(word) => mechanism.links.iter().position(|link| link.name.as_str().eq_ignore_ascii_case(word)),
        None => Some(GROUND),
    };
    let link = link.ok_or_else(|| text!("build-unknown", word = name(words.to_owned())))?;
    let [x, y] = [0, 1].map(|at| numbers.get(at).copied().unwrap_or_default() / 1e3);
    let own = mechanism.links[link].name.to_string();
    let pose = sketch.bodies[link].ok_or_else(|| text!("build-no-place", name = name(own.clone())))?;
    let at = pose.point([x, y]);
    if is_slide {
        return Ok(Target::Guide { link: own, through: at, angle: pose.angle + angle, point: None });
    }
    if numbers.is_empty() {
        return Err(text!("build-where-on-link", link = name(own)));
    }
    Ok(Target::New { link: own, at })
}

/// Adds the group whose pairs are joined now.
pub(super) fn finish(state: &mut State, join: &Join) {
    let Some(sketch) = state.build.sketch() else { return };
    let added =
        assur_sketch::add(state.draft.text(), sketch, &join.addition, &join.targets, &Names::default());
    match added {
        Ok(added) => {
            if draft::take(state, Ok(added.text)) {
                state.build.chosen = added.links.last().cloned().map(Part::Link);
                let links = added.links.into_iter().map(Part::Link);
                let parts = links.chain(added.points.into_iter().map(Part::Point)).collect();
                form::open(state, FormSource::Made(parts, fields::whole(added.fields)));
                if let Some(link) = added.rigid_with {
                    let undo = name(state.keys.first("undo"));
                    state.say(Role::Bad, text!("build-rigid", link = name(link), undo));
                }
            }
        }
        Err(problem) => state.say(Role::Bad, problem),
    }
}
