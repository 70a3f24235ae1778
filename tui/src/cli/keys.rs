//! `assur keys`: the reference of the keys of a scene, and the words of the field.

use std::fmt::Write;

use assur_book::glossary::{ENTRIES, Entry};
use assur_scene::reference::{KeyTable, SceneKey, TABLES, near, search};
use assur_words::{Language, Text, name, text};
use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Args, ValueEnum};
use textwrap::Options;

use super::fault::{Fault, Status};
use super::output;
use super::style::Style;
use crate::explained;

const WIDTH: usize = 100;

#[derive(Debug, Clone, Args)]
pub(crate) struct KeysArgs {
    /// A key, a table, a word of their descriptions, or a word of the field; without it, all keys
    #[arg(value_parser = Word, hide_possible_values = true)]
    word: Option<String>,
    /// Form of the reference
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
}

/// Form of the reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Form {
    /// To read
    Text,
    /// A page of the documentation
    Markdown,
}

/// Any word; the names of keys and tables complete.
#[derive(Debug, Clone, Copy)]
struct Word;

impl TypedValueParser for Word {
    type Value = String;

    fn parse_ref(
        &self,
        command: &clap::Command,
        arg: Option<&clap::Arg>,
        value: &std::ffi::OsStr,
    ) -> Result<String, clap::Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let names =
            TABLES.iter().flat_map(|table| table.keys.iter().map(|key| key.name).chain([table.name()]));
        let mut names: Vec<_> = names.filter(|name| !name.is_empty()).collect();
        names.sort_unstable();
        names.dedup();
        // Completed, but not listed in the help.
        Some(Box::new(names.into_iter().map(|name| PossibleValue::new(name).hide(true))))
    }
}

pub(crate) fn run(args: &KeysArgs, style: Style) -> Result<Status, Fault> {
    let word = args.word.as_deref().unwrap_or_default();
    let found: Vec<_> = search(word, style.language).collect();
    let words = words(word, found.is_empty(), style.language);
    if found.is_empty() && words.is_empty() {
        let offer = near(word).map(|near| text!("cli-keys-near", near = name(near))).unwrap_or_default();
        return Err(Fault::Other(text!("cli-no-key", word = name(word.to_owned()), offer = offer)));
    }
    let page = match args.format {
        Form::Text => text(&found, &words, style.language),
        Form::Markdown => markdown(&found, &words, style.language),
    };
    output::print(&style.text(&page))?;
    Ok(Status::Done)
}

/// The words of the field that have these letters; `all`: also those of which something that is told has them. None without
/// letters.
fn words(wanted: &str, all: bool, language: &Language) -> Vec<&'static Entry> {
    let wanted = wanted.trim().to_lowercase();
    let found = |entry: &&Entry| {
        explained::is_called(entry, &wanted, language)
            || all && explained::speaks_of(entry, &wanted, language)
    };
    if wanted.is_empty() { Vec::new() } else { ENTRIES.iter().filter(found).collect() }
}

type Matches = (&'static KeyTable, Vec<&'static SceneKey>);

fn line(key: &SceneKey) -> String {
    format!("{} = {}", key.name, key.example)
}

pub(crate) fn manual() -> String {
    let english = Language::english();
    let lines = text(&search("", english).collect::<Vec<_>>(), &[], english);
    let escaped = lines.replace('\\', "\\e").replace('-', "\\-");
    // A line that begins with a point or a quote would be a request.
    let plain = escaped
        .lines()
        .map(|line| if line.starts_with(['.', '\'']) { format!("\\&{line}") } else { line.to_owned() });
    format!(".SH KEYS OF A SCENE\n.nf\n{}\n.fi\n", plain.collect::<Vec<_>>().join("\n"))
}

/// The reference as text, each key with its value, its meaning and an example; then words of the field.
fn text(found: &[Matches], words: &[&Entry], language: &Language) -> String {
    let mut page = String::new();
    for (table, keys) in found {
        let what = text!(table.what).render(language);
        let head = if table.header.is_empty() { what } else { format!("{}  {what}", table.header) };
        let _ = writeln!(page, "{}{head}", if page.is_empty() { "" } else { "\n" });
        for key in keys {
            let _ = writeln!(page, "  {}", line(key));
            write_within(&mut page, [text!(key.about), explained::values(key)], language);
        }
    }
    if !words.is_empty() {
        let head = text!("group-words").render(language);
        let _ = writeln!(page, "{}{head}", if page.is_empty() { "" } else { "\n" });
    }
    for word in words {
        let _ = writeln!(page, "  {}", word.word.render(language));
        let told = [word.meaning.clone()].into_iter().chain(explained::beside(word, false));
        write_within(&mut page, told, language);
    }
    page
}

/// Writes texts below what they are about, each on lines of its own.
fn write_within(page: &mut String, texts: impl IntoIterator<Item = Text>, language: &Language) {
    for part in texts {
        let indent = Options::new(WIDTH).initial_indent("      ").subsequent_indent("      ");
        for row in textwrap::wrap(&part.render(language), indent.break_words(false)) {
            let _ = writeln!(page, "{row}");
        }
    }
}

fn markdown(found: &[Matches], words: &[&Entry], language: &Language) -> String {
    let cell = |text: String| text.replace('|', "\\|");
    let mut page = format!("{}\n", text!("cli-keys-page").render(language));
    for (table, keys) in found {
        let what = text!(table.what).render(language);
        let header = if table.header.is_empty() { what.clone() } else { format!("`{}`", table.header) };
        let about = if table.header.is_empty() { String::new() } else { format!("{what}.\n\n") };
        let heads = ["cli-key", "cli-key-value", "cli-key-meaning", "cli-key-example"];
        let heads = heads.map(|id| text!(id).render(language)).join(" | ");
        let _ = writeln!(page, "\n## {header}\n\n{about}| {heads} |\n| --- | --- | --- | --- |");
        for key in keys {
            let values = explained::values(key).render(language);
            let about = text!(key.about).render(language);
            let _ = writeln!(
                page,
                "| `{}` | {} | {} | `{}` |",
                key.name,
                cell(values),
                cell(about),
                cell(line(key))
            );
        }
    }
    if !words.is_empty() {
        let _ = writeln!(page, "\n## {}\n", text!("group-words").render(language));
    }
    for word in words {
        let told = [word.meaning.clone()].into_iter().chain(explained::beside(word, false));
        let told: Vec<_> = told.map(|text| text.render(language)).collect();
        let _ = writeln!(page, "* **{}**: {}", word.word.render(language), told.join("; "));
    }
    page
}

#[cfg(test)]
mod tests;
