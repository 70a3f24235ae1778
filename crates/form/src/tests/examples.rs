//! Every key of the reference in a form, and every table made anew.

use std::collections::BTreeSet;

use assur_fixtures::{SCENES, scene};
use assur_scene::reference::{TABLES, ValueKind};

use super::{key, read, reads, shaper};
use crate::{Choice, Field, Offers, added, field, made, put, sections, table};

fn offers() -> Vec<(&'static str, Vec<Choice>)> {
    let words = |words: &[&str]| words.iter().map(|word| Choice::word(*word)).collect();
    vec![("motor", words(&["4A100L4"])), ("catalogue", words(&["4A"])), ("integrator", words(&["dopri5"]))]
}

/// The shipped scenes, one with a law of its input over time, one with points by all keys, and one with a sheet.
fn scenes() -> impl Iterator<Item = String> {
    let arm = include_str!("../../../scene/src/tests/arm.toml");
    let boom =
        include_str!("../../../scene/src/tests/boom.toml").replace("until = \"3.5 s\"", "until = \"2 s\"");
    SCENES.iter().map(|(_, text)| (*text).to_owned()).chain([
        arm.to_owned(),
        boom,
        include_str!("../../../scene/src/tests/places.toml").to_owned(),
        format!("{}\n[sheet]\nformat = \"A1\"\n", shaper()),
    ])
}

/// The tables of a scene and the tables in them, with their headers.
fn forms(text: &str, offers: Offers<'_>) -> Vec<(&'static str, crate::Form)> {
    let mut all = Vec::new();
    for section in sections(text) {
        for instance in section.instances {
            inner(text, section.header, &instance.key, offers, &mut all);
        }
    }
    all
}

fn inner(
    text: &str,
    header: &'static str,
    at: &assur_mechanism::Key,
    offers: Offers<'_>,
    all: &mut Vec<(&'static str, crate::Form)>,
) {
    let form = table(text, at, offers);
    for field in form.fields.iter().filter(|field| field.is_table()) {
        if let Some(opening) = field.opens.iter().find(|opening| opening.stands) {
            inner(text, opening.header, &field.key, offers, all);
        }
    }
    all.push((header, form));
}

/// What is put into a field: something to choose, or the example.
fn values(field: &Field, example: &str) -> Vec<String> {
    let mut values: Vec<String> = field.choices.iter().map(|choice| choice.toml.clone()).collect();
    let list = |choice: &Choice| format!("[{}]", choice.toml);
    match field.kinds.first() {
        Some(ValueKind::List(_)) => values.push("[]".to_owned()),
        _ => values.push(example.to_owned()),
    }
    values.extend(field.choices.first().map(list));
    // Of a point, whose example is a table of them.
    values.push("0".to_owned());
    values
}

/// A value of each key of the reference reads in some shipped scene, with all that its field says.
#[test]
fn every_key_has_a_field_that_takes_a_value() {
    let offers = offers();
    let all: BTreeSet<String> = TABLES
        .iter()
        .flat_map(|table| table.keys.iter().map(|key| format!("{} {}", table.header, key.name)))
        .collect();
    let (mut seen, mut taken) = (BTreeSet::new(), BTreeSet::new());
    for scene in scenes() {
        for (header, form) in forms(&scene, &offers) {
            let known = TABLES.iter().find(|table| table.header == header).unwrap();
            for field in &form.fields {
                let chosen = || known.keys.iter().find(|key| key.name == "POINT");
                // Each point of a link has a field of its own.
                let around = || known.keys.iter().find(|key| field.key.steps().contains(&key.name.into()));
                let own = known.keys.iter().find(|key| key.name == field.label);
                let of = own.or_else(around).or_else(chosen).unwrap();
                let name = format!("{header} {}", of.name);
                seen.insert(name.clone());
                assert!(!field.about.is_empty() && !field.values.is_empty(), "{name}");
                if taken.contains(&name) {
                    continue;
                }
                for value in values(field, of.example) {
                    let change = put(&scene, field, &value);
                    if change.here.is_none() && change.elsewhere.is_empty() {
                        read(&change.text);
                        taken.insert(name.clone());
                        break;
                    }
                }
            }
        }
    }
    // The tables of the scene as a whole have forms of their own.
    let tables = all
        .iter()
        .filter(|name| name.starts_with(' ') && !name.ends_with("title") && !name.ends_with("gravity"));
    let tables: BTreeSet<String> = tables.cloned().collect();
    let wanted: BTreeSet<String> = all.difference(&tables).cloned().collect();
    let unseen: Vec<_> = wanted.difference(&seen).collect();
    let refused: Vec<_> = wanted.difference(&taken).collect();
    assert!(unseen.is_empty() && refused.is_empty(), "no field: {unseen:#?}, no value: {refused:#?}");
}

/// Every kind of table, added to the shaper or to a scene in which it has a place, reads with the keys that it needs.
#[test]
fn every_table_can_be_added() {
    let still = shaper().replace("[motion]\nspeed = \"60 rpm\"", "");
    let steady = scene("shaper-drive");
    let without_drive = &steady[..steady.find("[drive]").unwrap()];
    let without_input = shaper().replace("[input]\nlink = \"crank\"\npositions = 48", "");
    let bare = shaper().replace("[assembly]\nD = [0.17, 0.28]", "");
    for section in sections(shaper())
        .into_iter()
        .filter(|section| !["", "[link.NAME]", "[ground]"].contains(&section.header))
    {
        let text = match section.header {
            "[motion]" => &still,
            "[drive]" => without_drive,
            "[input]" => &without_input,
            "[[input]]" => scene("five-bar"),
            "[assembly]" => &bare,
            _ => shaper(),
        };
        let before = sections(text).into_iter().find(|own| own.header == section.header).unwrap();
        assert!(before.can_add, "{}", section.header);
        let change = added(text, section.header);
        // What is added to a list of inputs may have more inputs than the mechanism needs, which its structure says.
        let text = reads(change.clone());
        let name = section.header.trim_matches(['[', ']']);
        let index = format!("[{}]", before.instances.len());
        assert_eq!(
            change.at.to_string(),
            format!("{name}{}", if section.header.starts_with("[[") { &index } else { "" })
        );
        let after = sections(&text).into_iter().find(|own| own.header == section.header).unwrap();
        assert_eq!(after.instances.len(), before.instances.len() + 1, "{}", section.header);
        assert!(!table(&text, &change.at, &[]).fields.is_empty());
    }
    // A friction goes to a pair that has none, a slide to links that have none between them.
    let friction = added(shaper(), "[[friction]]");
    let again = added(&reads(friction.clone()), "[[friction]]");
    assert_ne!(
        field(&friction.text, &key("friction[0].pair"), &[]).unwrap().value,
        field(&reads(again.clone()), &key("friction[1].pair"), &[]).unwrap().value
    );
    // Where the scene allows none, the change says why.
    let drive = added(shaper(), "[drive]");
    assert!(drive.here.unwrap().message.to_string().contains("[drive] needs a motion"));
}

/// Whatever a text is cut to, forms are made of it and steps go on.
#[test]
fn a_text_in_the_making_has_forms() {
    for name in ["rolling-press", "shaper-drive", "five-bar"] {
        let whole = scene(name);
        for end in (0..whole.len()).filter(|end| end % 97 == 0 && whole.is_char_boundary(*end)) {
            let text = &whole[..end];
            let listed: Vec<_> = forms(text, &[]).into_iter().collect();
            for (_, form) in listed.iter().take(4) {
                for field in form.fields.iter().take(3) {
                    put(text, field, "1");
                    field.opens.iter().for_each(|opening| drop(made(text, &field.key, opening)));
                }
            }
            crate::masses(text);
            added(text, "[[force]]");
        }
    }
}
