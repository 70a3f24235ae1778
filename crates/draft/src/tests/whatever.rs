//! Sequences of changes of all shipped scenes, and of texts with slips.

use assur_fixtures::SCENES;
use assur_mechanism::{Key, Step};
use assur_scene::{read, reading};
use proptest::prelude::*;
use toml::de::DeTable;

use crate::known::Of;
use crate::layout::Layout;
use crate::names::Names;
use crate::{
    Part, append, delete, dependents, key_at, readable, remove, rename, rename_in_link, set, stands,
};

/// Keys of values in a text, and of tables.
fn keys(text: &str) -> Vec<Key> {
    let layout = Layout::of(text).unwrap();
    let mut keys = Vec::new();
    for section in &layout.sections {
        keys.extend((!section.path.is_empty()).then(|| layout.named(&section.path)));
        keys.extend(section.entries.iter().map(|entry| layout.named(&entry.path)));
        for entry in &section.entries {
            let within = (entry.value.start..entry.value.end).step_by(7).filter_map(|at| key_at(text, at));
            keys.extend(within);
        }
    }
    keys
}

/// Parts of a text.
fn parts(text: &str) -> Vec<Part> {
    let names = Names::of(Layout::of(text).unwrap());
    let links = names.definitions(Of::Link).map(|link| Part::Link(link.word.clone()));
    let points = names.definitions(Of::Point).map(|point| Part::Point(point.word.clone()));
    let slides = names.slides.iter().map(|slide| Part::Slide(slide.name.clone()));
    let tables = ["force", "moment", "spring", "contact", "brake", "friction", "input", "balance"];
    let loads = tables.into_iter().flat_map(|table| [0, 1].map(|index| Part::Load(table, index)));
    let loads = loads.filter(|load| !names.paths(load).is_empty());
    links.chain(points).chain(slides).chain(loads).collect()
}

fn pick<T: Clone>(of: &[T], at: usize) -> Option<T> {
    of.get(at % of.len().max(1)).cloned()
}

/// The comments of a text.
fn comments(text: &str) -> Vec<&str> {
    text.lines().filter_map(|line| line.split_once('#')).map(|(_, comment)| comment).collect()
}

/// The lines of comments in those tables of a text that another one has, too.
fn own_comments<'t>(text: &'t str, next: &str) -> Vec<&'t str> {
    let (before, after) = (Layout::of(text).unwrap(), Layout::of(next).unwrap());
    let stays = |index: &usize| {
        let path = &before.sections[*index].path;
        !path.iter().any(|step| matches!(step, Step::Index(_)))
            && (path.is_empty() || after.section(path).is_some())
    };
    let lines = |index: usize| {
        let start = if index == 0 { 0 } else { before.lead(index) };
        text[start..before.tail(index)].lines().filter(|line| line.trim_start().starts_with('#'))
    };
    (0..before.sections.len())
        .filter(stays)
        .flat_map(lines)
        .filter_map(|line| line.split_once('#'))
        .map(|line| line.1)
        .collect()
}

const VALUES: [&str; 8] = [
    "1",
    "\"100 mm\"",
    "[0, 1]",
    "{ a = 1 }",
    "\"crank\"",
    "{ over = \"time\", table = [[0, 1]] }",
    "[]",
    "true",
];
const NEW: [&str; 8] = [
    "link.new.points.B",
    "motion.speed",
    "assembly.A",
    "force[0].value",
    "output.points[0]",
    "gravity",
    "link.crank.points.Q1",
    "a.b.c",
];
const TABLES: [&str; 4] = [
    "[link.new]\n# new\npoints = { A = 0, N = 1 }\n[[slide]]\nlink = \"new\"\non = \"ground\"\n",
    "[ground]\npoints = { Z = [0, 1] }\n[assembly]\nN = [0, 0]\n",
    "[[force]] # a force\nlink = \"crank\"\nat = [0, 1]\nangle = 0\n[force.value]\nformula = \"1\"\n",
    "title = \"t\"\n[note]\nauthor = \"A\"\n",
];
const NAMES: [&str; 5] = ["fresh", "with space", "O", "crank", "\u{434}\u{440}\u{443}\u{433}\u{430}"];

/// One step of any kind.
fn changed(text: &str, kind: u8, at: usize, with: usize) -> Option<String> {
    let (keys, parts) = (keys(text), parts(text));
    let value = VALUES[with % VALUES.len()];
    let name = NAMES[with % NAMES.len()];
    Some(match kind {
        0 => set(text, &pick(&keys, at)?, value).ok()?,
        1 => set(text, &Key::parse(NEW[at % NEW.len()]).unwrap(), value).ok()?,
        2 => remove(text, &pick(&keys, at)?),
        3 => append(text, TABLES[with % TABLES.len()]).ok()?,
        4 => rename(text, &pick(&parts, at)?, name).ok()?,
        5 => delete(text, &[pick(&parts, at)?]).ok()?,
        _ => {
            let names = Names::of(Layout::of(text).unwrap());
            let points: Vec<_> = names.points.iter().cloned().collect();
            let point = pick(&points, at)?;
            rename_in_link(text, crate::names::link_of(&point), crate::names::point_of(&point), name).ok()?
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn steps_leave_a_text_that_is_toml(
        scene in 0..SCENES.len(),
        steps in proptest::collection::vec((0..7_u8, any::<usize>(), any::<usize>()), 1..12),
    ) {
        let mut text = SCENES[scene].1.to_owned();
        for (kind, at, with) in steps {
            let Some(next) = changed(&text, kind, at, with) else { continue };
            prop_assert!(DeTable::parse(&next).is_ok(), "{kind} {at} {with}\n{text}\n---\n{next}");
            let after = comments(&next);
            let stays = |comment: &&str| after.contains(comment);
            if matches!(kind, 1 | 3 | 4 | 6) {
                prop_assert!(comments(&text).iter().all(stays), "{kind}\n{text}\n---\n{next}");
            } else if kind != 0 {
                prop_assert!(own_comments(&text, &next).iter().all(stays), "{kind}\n{text}\n---\n{next}");
            }
            let found = readable("", &next);
            prop_assert_eq!(found.text.is_empty(), read("", &found.text).is_err());
            if let Some(part) = pick(&parts(&next), at) {
                dependents(&next, &part);
            }
            text = next;
        }
    }

    #[test]
    fn any_text_has_an_answer(scene in 0..SCENES.len(), slips in proptest::collection::vec((0.0..1.0_f64, 0..30_usize, "[\\[\\]{}=,\"'.#\\n a-z0-9-]{0,8}"), 1..6)) {
        let mut text: Vec<char> = SCENES[scene].1.chars().collect();
        for (place, length, piece) in slips {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in a text of some kilobytes")]
            let start = (place * text.len() as f64) as usize;
            let end = (start + length).min(text.len());
            text.splice(start..end, piece.chars());
        }
        let text: String = text.into_iter().collect();
        for at in (0..text.len() + 9).step_by(5) {
            key_at(&text, at);
        }
        let found = readable("", &text);
        prop_assert_eq!(found.text.is_empty(), read("", &found.text).is_err());
        let is_toml = DeTable::parse(&text).is_ok();
        prop_assert_eq!(set(&text, &Key::of("title"), "1").is_ok(), is_toml);
        prop_assert!(is_toml || remove(&text, &Key::of("title")) == text);
        if is_toml {
            for part in parts(&text) {
                if let Ok(rest) = delete(&text, &[part]) {
                    prop_assert!(DeTable::parse(&rest).is_ok());
                }
            }
        }
    }
}

#[test]
fn a_number_that_is_set_is_read() {
    for (name, text) in SCENES {
        for number in reading("", text).unwrap().numbers.iter().step_by(5) {
            let written = &text[number.span.clone()];
            assert_eq!(set(text, &number.key, written).unwrap(), *text, "{name} {}", number.key);
            let other = set(text, &number.key, "17.5").unwrap();
            assert_eq!(other, [&text[..number.span.start], "17.5", &text[number.span.end..]].concat());
            assert!(
                stands(&other, &number.key) && !stands(&remove(text, &Key::of("link")), &Key::of("link"))
            );
            assert_eq!(key_at(text, number.span.start).as_ref(), Some(&number.key));
        }
    }
}

#[test]
fn a_name_there_and_back_is_the_first_text() {
    for (scene, text) in SCENES.iter().filter(|(scene, _)| *scene != "n-four-bar-40") {
        let mechanism = read("", text).unwrap();
        let slides = mechanism.slides.iter().map(|slide| Part::Slide(slide.name.to_string()));
        let links = mechanism.links[1..].iter().map(|link| Part::Link(link.name.to_string()));
        let points = mechanism.points.iter().map(|point| Part::Point(point.name.to_string()));
        for part in slides.chain(links).chain(points) {
            let renamed = rename(text, &part, "a new one").unwrap();
            assert_ne!(renamed, *text);
            let other = read("", &renamed).unwrap();
            assert_eq!(other.points.len(), mechanism.points.len());
            let (new, old) = match part {
                Part::Slide(old) => (Part::Slide("a new one".to_owned()), old),
                Part::Link(old) => (Part::Link("a new one".to_owned()), old),
                Part::Point(old) => (Part::Point("a new one".to_owned()), old),
                Part::Load(..) => unreachable!(),
            };
            assert_eq!(rename(&renamed, &new, &old).unwrap(), *text, "{scene} {old}");
        }
    }
}

#[test]
fn without_a_part_the_rest_is_read() {
    // What a mechanism that has lost a part may lack: links, an input, a pair that keeps a link from turning freely.
    let allowed = ["a scene needs `input`", "a scene needs `link`", "has no length", "no pin joins"];
    for (scene, text) in SCENES.iter().filter(|(scene, _)| *scene != "n-four-bar-40") {
        for part in parts(text) {
            let rest = delete(text, std::slice::from_ref(&part)).unwrap();
            let faults = read("", &rest).err().map(|errors| errors.errors).unwrap_or_default();
            // The center of mass may have been at a point that goes.
            let center = matches!(part, Part::Point(_)).then_some("a link needs `center`");
            for fault in faults {
                let message = fault.message.to_string();
                let mut allowed = allowed.iter().copied().chain(center);
                assert!(allowed.any(|words| message.contains(words)), "{scene} {part:?}: {message}\n{rest}");
            }
            let mut all = dependents(text, &part);
            all.push(part);
            assert_eq!(delete(text, &all).unwrap(), rest);
            let gone = Names::of(Layout::of(&rest).unwrap());
            assert!(
                all.iter()
                    .filter(|part| !matches!(part, Part::Load(..)))
                    .all(|part| gone.paths(part).is_empty())
            );
        }
    }
}

#[test]
fn places_of_elements_are_numbers_or_names() {
    let text = "[[force]]\nlink = \"a\"\nname = \"x\"\n[[force]]\nlink = \"a\"\nname = \"x\"\n[[input]]\npin = \"K\"\nof = \"b\"\n[[input]]\npin = \"K\"\nof = \"c\"\n";
    let layout = Layout::of(text).unwrap();
    let named = |list: &str, index: usize| layout.named(&[list.into(), Step::Index(index)]).to_string();
    assert_eq!([named("force", 0), named("force", 1)], ["force.x", "force[1]"]);
    assert_eq!([named("input", 0), named("input", 1)], ["input.K:b", "input.K:c"]);
    assert_eq!(
        remove(text, &Key::of("input").at("K:c")),
        text.replace("[[input]]\npin = \"K\"\nof = \"c\"\n", "")
    );
}
