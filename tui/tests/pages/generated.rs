//! Pages that are written by the program: the glossary and the gallery. `INSTA_UPDATE=always` writes them anew.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use assur_all as _;
use assur_book::glossary::ENTRIES;
use assur_fixtures::SCENES;
use assur_words::Language;

use super::root;

/// Compares a file of docs with what it ought to be, or writes it.
pub(super) fn holds(name: &str, text: &str) {
    let path = root().join("docs").join(name);
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    } else {
        let own = fs::read_to_string(path).unwrap_or_default();
        assert!(
            own == text,
            "docs/{name} is not what the program makes of it: INSTA_UPDATE=always writes it"
        );
    }
}

#[test]
fn the_glossary_is_that_of_the_help() {
    let languages = ["uk", "ru"].map(|code| Language::find(code).unwrap());
    let mut page = "# Glossary\n\nThe words of the field as the program uses them, with formula and source. The same is told by `?` on the \
                    screen, and by `assur keys WORD`.\n"
        .to_owned();
    let english = Language::english();
    let mut entries: Vec<_> = ENTRIES.iter().map(|entry| (entry.word.render(english), entry)).collect();
    entries.sort_by_key(|(word, _)| word.to_lowercase());
    for (word, entry) in entries {
        let _ = write!(page, "\n## {word}\n\n{}.\n", entry.meaning.render(english));
        if !entry.formula.is_empty() {
            let _ = write!(page, "\n* formula: `{}`\n", entry.formula);
        }
        if let Some(source) = entry.source {
            let begin = if entry.formula.is_empty() { "\n" } else { "" };
            let _ = writeln!(page, "{begin}* source: {}", source.text().render(english));
        }
        let bare = entry.formula.is_empty() && entry.source.is_none();
        for (number, (code, language)) in ["uk", "ru"].iter().zip(languages).enumerate() {
            let begin = if bare && number == 0 { "\n" } else { "" };
            let [word, meaning] = [&entry.word, &entry.meaning].map(|text| text.render(language));
            let _ = writeln!(page, "{begin}* {code}: **{word}**: {meaning}.");
        }
    }
    holds("glossary.md", &page);
}

#[test]
fn the_gallery_has_every_shipped_scene() {
    let mut page = "# Gallery\n\nThe scenes that come with the program, drawn by it in their first position (`assur draw SCENE`); each by \
                    `assur new FILE --kind NAME`.\n"
        .to_owned();
    let mut files = BTreeSet::new();
    for (name, text) in SCENES {
        let scene = root().join("fixtures").join(format!("{name}.toml"));
        let folder = tempfile::tempdir().unwrap();
        let picture = folder.path().join("a.svg");
        let drawn = Command::new(env!("CARGO_BIN_EXE_assur"))
            .args(["draw".as_ref(), scene.as_os_str(), "-o".as_ref(), picture.as_os_str()])
            .args(["--view", "mechanism", "--arrows", "none"])
            .env("LC_ALL", "C.UTF-8")
            .output()
            .unwrap();
        assert!(drawn.status.code() != Some(2), "{name}: {}", String::from_utf8_lossy(&drawn.stderr));
        holds(&format!("gallery/{name}.svg"), &fs::read_to_string(&picture).unwrap());
        files.insert(format!("{name}.svg"));
        let mechanism = assur_scene::read(name, text).unwrap();
        let structure = assur_kinematics::decompose(&mechanism).unwrap();
        let title = assur_words::Text::from(&mechanism.title).render(Language::english());
        let _ = write!(
            page,
            "\n## {name}\n\n{title}. Structure: `{}`.\n\n![{name}](gallery/{name}.svg)\n",
            structure.formula
        );
    }
    holds("gallery.md", &page);
    let there = fs::read_dir(root().join("docs/gallery")).unwrap();
    let there: BTreeSet<_> = there.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(there, files, "pictures of docs/gallery");
}
