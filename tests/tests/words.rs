//! The texts of all crates: every language has each of them with the same values, none is there twice, and none is unused.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use assur_words::LANGUAGES;

/// A text: the values that stand in it, with those of its attributes.
type Texts = BTreeMap<String, BTreeSet<String>>;

/// What is in a folder of the project.
fn listed(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    entries.map(|entry| entry.unwrap_or_else(|error| panic!("{error}")).path()).collect()
}

fn content(file: &Path) -> String {
    fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// The folder of the project.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Folders of the crates that bring texts along.
fn speaking() -> Vec<PathBuf> {
    let root = root();
    let members = ["crates", "plugins"].into_iter().flat_map(|of| listed(&root.join(of)));
    let members = members.chain([root.join("tui")]);
    members
        .filter(|path| {
            fs::read_to_string(path.join("src/lib.rs")).is_ok_and(|lib| lib.contains("resources!();"))
        })
        .collect()
}

/// The texts of a file.
fn texts(file: &Path) -> Texts {
    let mut found = Texts::new();
    let mut current = String::new();
    let whole = content(file);
    for line in whole.lines().filter(|line| !line.starts_with('#')) {
        if !line.starts_with([' ', '}', '\t']) && line.contains(" =") {
            line.split(" =").next().unwrap_or_default().clone_into(&mut current);
            assert!(!found.contains_key(&current), "{}: `{current}` is there twice", file.display());
            found.insert(current.clone(), BTreeSet::new());
        }
        let values = line.split('$').skip(1);
        let values = values
            .map(|rest| rest.split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or_default());
        found.entry(current.clone()).or_default().extend(values.map(str::to_owned));
    }
    found.remove("");
    found
}

#[test]
fn every_language_has_every_text_with_its_values() {
    let mut owners: BTreeMap<String, PathBuf> = BTreeMap::new();
    for member in speaking() {
        let [english, others @ ..] = LANGUAGES.map(|code| texts(&member.join(format!("lang/{code}.ftl"))));
        for other in others {
            let differ: Vec<_> =
                english.iter().filter(|(id, values)| other.get(*id) != Some(values)).collect();
            assert!(differ.is_empty(), "{}: other values in a translation: {differ:?}", member.display());
            assert!(other.len() == english.len(), "{}: texts that English lacks", member.display());
        }
        for id in english.into_keys() {
            if let Some(first) = owners.insert(id.clone(), member.clone()) {
                panic!("`{id}` is a text of {} and of {}", first.display(), member.display());
            }
        }
    }
}

/// All sources of a folder without comments, one after another.
fn sources(folder: &Path) -> String {
    let mut all = String::new();
    for path in listed(folder) {
        if path.is_dir() {
            all += &sources(&path);
        } else if path.ends_with("reference/keys.txt") {
            // The identities that a table has in its columns.
            all.extend(content(&path).split([' ', '\n']).map(|word| format!("\"{word}\"\n")));
        } else if path.extension().is_some_and(|end| end == "rs") {
            let whole = content(&path);
            let code = whole.lines().filter(|line| !line.trim_start().starts_with("//"));
            all.extend(code.flat_map(|line| [line, "\n"]));
        }
    }
    all
}

#[test]
fn every_text_is_used_and_every_identity_has_its_text() {
    let root = root();
    let code: String = ["crates", "plugins", "tui"].iter().map(|of| sources(&root.join(of))).collect();
    let files = speaking().into_iter().map(|member| member.join("lang/en.ftl"));
    let resources: String = files.clone().map(|file| content(&file)).collect();
    let all: BTreeSet<String> = files.flat_map(|file| texts(&file).into_keys()).collect();
    let used = |id: &str| {
        [format!("\"{id}\""), format!("\"{id}.")].iter().any(|literal| code.contains(literal))
            || resources.contains(&format!("{{ {id} }}"))
    };
    // The language itself asks for its units and its decimal sign.
    let unused: Vec<_> = all.iter().filter(|id| !id.starts_with("unit-") && !used(id)).collect();
    assert!(unused.is_empty(), "texts that nothing shows: {unused:?}");
    let asked = code.split("text!(\"").skip(1).map(|rest| rest.split(['"', '.']).next().unwrap());
    let unknown: BTreeSet<_> = asked.filter(|id| *id != "no-such-text" && !all.contains(*id)).collect();
    assert!(unknown.is_empty(), "identities without a text: {unknown:?}");
}

/// A name is in no language, so a sentence may not be one: neither a literal nor the English of an error of ours.
#[test]
fn no_sentence_is_a_name() {
    let code: String = ["crates", "plugins", "tui"].iter().map(|of| sources(&root().join(of))).collect();
    let calls = code.split("name(").skip(1);
    let literals = calls.filter_map(|call| call.strip_prefix("format!(").unwrap_or(call).strip_prefix('"'));
    let is_word = |word: &&str| word.len() > 2 && word.chars().all(|letter| letter.is_ascii_lowercase());
    let sentences: BTreeSet<_> = literals
        .filter_map(|rest| rest.split('"').next())
        .filter(|letters| letters.split(' ').filter(is_word).count() > 2)
        .collect();
    // Tests plant some, in rows that only they read.
    let planted = [
        "no digit is left, as the bound says: the step is too small, or too great",
        "the scene does not compile",
        "The configuration could not be used",
    ];
    let found: Vec<_> = sentences.into_iter().filter(|sentence| !planted.contains(sentence)).collect();
    assert!(found.is_empty(), "{found:#?}");
}
