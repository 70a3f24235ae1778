//! The core asks for no plugin by name: what it must know of one, the plugin declares.

use std::fs;
use std::path::{Path, PathBuf};

use assur_all as _;

/// Names that are ordinary words too: labels of other things may be called so, only asking for a plugin by them is a fault.
const ORDINARY: [&str; 4] = ["closed-form", "energy", "groups", "uniform"];

/// Whether a line holds a name as a literal; of an ordinary word, whether it asks for it.
fn names(line: &str, name: &str) -> bool {
    let literal = format!("\"{name}\"");
    if !ORDINARY.contains(&name) {
        return line.contains(&literal);
    }
    let asking = [
        format!("= {literal}"),
        format!("find({literal}"),
        format!("Some({literal}"),
        format!("{literal} =>"),
    ];
    asking.iter().any(|pattern| line.contains(pattern))
}

/// Names of every registry, and how code names the crates that register them.
fn plugins() -> (Vec<&'static str>, Vec<String>) {
    let groups = assur_group::groups().unwrap_or_else(|error| panic!("{error}"));
    let analyzers = assur_force::analyzers().unwrap_or_else(|error| panic!("{error}"));
    let integrators = assur_integrator::integrators().unwrap_or_else(|error| panic!("{error}"));
    let catalogues = assur_motor::catalogues().unwrap_or_else(|error| panic!("{error}"));
    let groups =
        groups.iter().flat_map(|plugin| [(plugin.name, plugin.crate_name), (plugin.kind, plugin.crate_name)]);
    let all: Vec<_> = groups
        .chain(analyzers.iter().map(|plugin| (plugin.name, plugin.crate_name)))
        .chain(integrators.iter().map(|plugin| (plugin.name, plugin.crate_name)))
        .chain(catalogues.iter().map(|plugin| (plugin.name, plugin.crate_name)))
        .collect();
    let names = all.iter().map(|(name, _)| *name).collect();
    (names, all.iter().map(|(_, crate_name)| crate_name.replace('-', "_")).collect())
}

/// Files of a folder that end so, outside its tests and benchmarks.
fn files(folder: &Path, end: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
        let path = entry.unwrap_or_else(|error| panic!("{error}")).path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && !["tests", "benches", "target"].contains(&name.as_str()) {
            files(&path, end, found);
        } else if path.extension().is_some_and(|own| own == end) && name != "tests.rs" {
            found.push(path);
        }
    }
}

/// All files that end so of some folders of the project.
fn all_files(folders: &[&str], end: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for folder in folders {
        files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder), end, &mut found);
    }
    found
}

/// Names that texts have as words in their ordinary sense, each with that sense; as a name such a word stands in quotes.
const SENSES: [(&str, &str); 6] = [
    ("any", "every one"),
    ("energy", "of a motion or a spring"),
    ("groups", "those of Assur"),
    ("longitudinal", "along a line, in the title of a paper among the sources"),
    ("quadrature", "an integral by sums"),
    ("uniform", "the same everywhere"),
];

/// Whether a text says the name of a plugin: as a word of its own, which is no value.
fn says(text: &str, name: &str) -> bool {
    let is_part = |letter: char| letter.is_alphanumeric() || "-_$".contains(letter);
    let is_quote = |letter: char| "`\"".contains(letter);
    let is_ordinary = SENSES.iter().any(|(word, _)| *word == name);
    text.match_indices(name).any(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + name.len()..]);
        let is_word = !before.ends_with(is_part) && !after.starts_with(is_part);
        is_word && (!is_ordinary || before.ends_with(is_quote) && after.starts_with(is_quote))
    })
}

/// The texts of a file with their identities, each with all of its lines.
fn texts(file: &Path) -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = Vec::new();
    let whole = fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    for line in whole.lines().filter(|line| !line.starts_with('#')) {
        match line.split_once(" =") {
            Some((id, said)) if !line.starts_with(' ') => all.push((id.to_owned(), said.to_owned())),
            _ => {
                if let Some((_, said)) = all.last_mut() {
                    said.push_str(line);
                }
            }
        }
    }
    all
}

/// A method, a kind of group or a catalogue is a value of a text, which its entry in the registry gives: so the text holds
/// whatever is linked. A plugin's own texts may name it.
#[test]
fn no_text_names_a_plugin() {
    let (registered, _) = plugins();
    let files = all_files(&["crates", "tui"], "ftl");
    assert!(files.len() > 60, "only {} files were found", files.len());
    let mut faults = Vec::new();
    for file in &files {
        for (id, text) in texts(file) {
            let named = registered.iter().find(|name| says(&text, name));
            faults.extend(named.map(|name| format!("{}: {name}: {id} ={text}", file.display())));
        }
    }
    assert!(faults.is_empty(), "texts name plugins:\n{}", faults.join("\n"));
}

#[test]
fn no_source_of_the_core_names_a_plugin() {
    let (registered, crates) = plugins();
    assert!(registered.len() > 15 && registered.contains(&"RRR"), "{registered:?}");
    let files = all_files(&["crates"], "rs");
    assert!(files.len() > 100, "only {} files were found", files.len());
    let mut faults = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        for (number, line) in
            text.lines().enumerate().filter(|(_, line)| !line.trim_start().starts_with("//"))
        {
            let literal = registered.iter().find(|name| names(line, name));
            let path = crates.iter().find(|name| line.contains(name.as_str()));
            if literal.is_some() || path.is_some() {
                faults.push(format!("{}:{}: {}", file.display(), number + 1, line.trim()));
            }
        }
    }
    assert!(faults.is_empty(), "the core names plugins:\n{}", faults.join("\n"));
}
