//! `assur keys`: the reference of the keys of a scene.

use std::fmt::Write;

use assur_scene::reference::{KeyDefault, KeyTable, SceneKey, TABLES, near, search};
use assur_words::{Language, Text, name, text};
use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::{Args, ValueEnum};
use textwrap::Options;

use super::fault::{Fault, Status};
use super::output;
use super::style::Style;

const WIDTH: usize = 100;

#[derive(Debug, Clone, Args)]
pub(crate) struct KeysArgs {
    /// A key, a table, or a word of their descriptions; without it, all
    #[arg(value_parser = Word)]
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
    if found.is_empty() {
        let offer = near(word).map(|near| text!("cli-keys-near", near = name(near))).unwrap_or_default();
        return Err(Fault::Other(text!("cli-no-key", word = name(word.to_owned()), offer = offer)));
    }
    let page = match args.format {
        Form::Text => text(&found, style.language),
        Form::Markdown => markdown(&found, style.language),
    };
    output::print(&style.text(&page))?;
    Ok(Status::Done)
}

type Matches = (&'static KeyTable, Vec<&'static SceneKey>);

fn line(key: &SceneKey) -> String {
    format!("{} = {}", key.name, key.example)
}

/// What holds without a key.
fn default(key: &SceneKey) -> Text {
    let of = name(key.sorts);
    match (key.default, key.sorts.is_empty()) {
        (KeyDefault::Needed, true) => text!("cli-key-needed"),
        (KeyDefault::Needed, false) => text!("cli-key-needed-of", sorts = of),
        (KeyDefault::Absent, true) => Text::default(),
        (KeyDefault::Absent, false) => text!("cli-key-of", sorts = of),
        (KeyDefault::Is(value), true) => text!("cli-key-default", value = name(value)),
        (KeyDefault::Is(value), false) => text!("cli-key-default-of", value = name(value), sorts = of),
    }
}

pub(crate) fn manual() -> String {
    let english = Language::english();
    let lines = text(&search("", english).collect::<Vec<_>>(), english);
    let escaped = lines.replace('\\', "\\e").replace('-', "\\-");
    // A line that begins with a point or a quote would be a request.
    let plain = escaped
        .lines()
        .map(|line| if line.starts_with(['.', '\'']) { format!("\\&{line}") } else { line.to_owned() });
    format!(".SH KEYS OF A SCENE\n.nf\n{}\n.fi\n", plain.collect::<Vec<_>>().join("\n"))
}

/// The reference as text, each key with its value, its meaning and an example.
fn text(found: &[Matches], language: &Language) -> String {
    let say = |text: &Text| text.render(language);
    let mut page = String::new();
    for (table, keys) in found {
        let what = text!(table.what).render(language);
        let head = if table.header.is_empty() { what } else { format!("{}  {what}", table.header) };
        let _ = writeln!(page, "{}{head}", if page.is_empty() { "" } else { "\n" });
        for key in keys {
            let _ = writeln!(page, "  {}", line(key));
            let about = text!(key.about).render(language);
            let kinds = [say(&key.values()), say(&default(key))];
            let kinds = kinds.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("; ");
            for part in [about, kinds] {
                let indent = Options::new(WIDTH).initial_indent("      ").subsequent_indent("      ");
                for row in textwrap::wrap(&part, indent.break_words(false)) {
                    let _ = writeln!(page, "{row}");
                }
            }
        }
    }
    page
}

fn markdown(found: &[Matches], language: &Language) -> String {
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
            let values = [key.values(), default(key)].map(|text| text.render(language));
            let values = values.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join("; ");
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
    page
}

#[cfg(test)]
mod tests;
