//! All words of the interface stand in `text.rs`, so that another language touches nothing else.

use std::path::{Path, PathBuf};

/// Words in quotes that are no language: commands, names in scenes, units, file types, settings.
const NAMES: &[&str] = &[
    "ground", "position", "point", "link", "slide", "view", "menu", "braille", "half", "block", "ascii",
    "cell", "compare", "open", "part", "value", "toml",
];
/// Files without words of the interface: names of commands, keys, themes and scenes; drawings; errors before there is a screen.
const OTHER: &[&str] = &[
    "text.rs",
    "command.rs",
    "key.rs",
    "theme.rs",
    "menu.rs",
    "svg.rs",
    "mod.rs",
    "terminal.rs",
    "session.rs",
];

/// Source files of the terminal UI, without its tests and without the names of the configuration.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if path.is_dir() && !["tests", "config", "text"].contains(&name) {
            sources(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs")
            && name != "tests.rs"
            && !(OTHER.contains(&name) && path.parent() == Some(&root()))
        {
            found.push(path);
        }
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/screen")
}

/// The texts in quotes of a line of code, without what is filled in.
fn quoted(line: &str) -> Vec<String> {
    let line = line.replace("\\\"", "");
    let parts: Vec<&str> = line.split('"').collect();
    let inside = parts.iter().skip(1).step_by(2).take(parts.len() / 2);
    inside
        .map(|text| {
            let mut depth = 0;
            let outside = text.chars().filter(|letter| {
                depth += i32::from(*letter == '{') - i32::from(*letter == '}');
                depth == 0 && *letter != '}'
            });
            outside.collect()
        })
        .collect()
}

/// Words of a language in a text: four letters and more that are no name.
fn words(text: &str) -> Vec<String> {
    let is_command =
        |word: &str| crate::screen::command::COMMANDS.iter().any(|command| command.name.contains(word));
    let words =
        text.split(|letter: char| !letter.is_alphabetic()).filter(|word| word.is_ascii() && word.len() >= 4);
    words.filter(|word| !NAMES.contains(word) && !is_command(word)).map(str::to_owned).collect()
}

#[test]
fn no_view_has_words_of_its_own() {
    let mut files = Vec::new();
    sources(&root(), &mut files);
    assert!(files.len() > 30);
    let strays: Vec<String> = files.iter().flat_map(|file| strays(file)).collect();
    assert!(strays.is_empty(), "these belong to text.rs:\n{}", strays.join("\n"));
}

/// Texts of a file that have words.
fn strays(file: &Path) -> Vec<String> {
    let code = std::fs::read_to_string(file).unwrap();
    let code = code.split("#[cfg(test)]").next().unwrap();
    let excused =
        |line: &&str| ["reason = ", "env!", "assert!", "var_os"].iter().all(|word| !line.contains(word));
    let lines = code.lines().filter(excused).map(|line| line.split("//").next().unwrap());
    let texts = lines.flat_map(quoted).filter(|text| !words(text).is_empty());
    texts.map(|text| format!("{}: `{text}`", file.display())).collect()
}

#[test]
fn the_guard_sees_words_and_only_words() {
    assert_eq!(quoted("put(\"least speed {value:.3} rad/s\")"), ["least speed  rad/s"]);
    assert_eq!(words("least speed rad/s"), ["least", "speed"]);
    assert!(words("N m, mm, deg, rad/s2, PF0").is_empty());
    assert!(words("next-position").is_empty());
}
