//! What the `:` line and the `/` line understand.

use super::act;
use super::command::{self, COMMANDS};
use super::draw::raster::Marker;
use super::found::Reaction;
use super::series::Key;
use super::state::{Look, State, View, Wish};
use super::study::Source;
use super::text::fill;
use super::theme::{Role, Theme};
use super::view::help::where_it_works;
use super::whatif;
use super::work::Job;

/// Names farther than this from what was typed are no suggestion.
const FAR: usize = 3;
/// Letters of what was typed for each that may be wrong.
const LETTERS: usize = 3;

/// Words of the line that take a value, and their values.
fn words(state: &State) -> Vec<(&'static str, Vec<String>)> {
    let names = |wanted: fn(&Key) -> bool| -> Vec<String> {
        let Some(study) = &state.study else { return Vec::new() };
        let mut names: Vec<String> = study
            .transfers
            .iter()
            .filter(|transfer| wanted(&transfer.key))
            .map(|transfer| study.name_of(&transfer.key).to_owned())
            .collect();
        names.dedup();
        names
    };
    let views = COMMANDS.iter().filter(|c| c.group == command::Group::Views).map(|c| c.name.to_owned());
    vec![
        ("point", names(|key| matches!(key, Key::Point(_)))),
        ("link", names(|key| matches!(key, Key::Link(_)))),
        ("slide", names(|key| matches!(key, Key::Slide(_)))),
        ("view", views.collect()),
        ("open", scenes()),
        ("compare", scenes()),
        ("value", state.what_if.values.iter().map(|value| value.key.clone()).collect()),
    ]
}

fn scenes() -> Vec<String> {
    super::menu::SCENES.iter().map(|(name, _)| (*name).to_owned()).collect()
}

/// What `:set` takes.
fn settings() -> Vec<(&'static str, Vec<String>)> {
    let list = |values: &[&str]| values.iter().map(|value| (*value).to_owned()).collect();
    vec![
        ("theme", Theme::ALL.iter().map(|theme| theme.name().to_owned()).collect()),
        ("marker", Marker::ALL.iter().map(|marker| marker.name().to_owned()).collect()),
        ("ascii", list(&["on", "off"])),
        ("fps", list(&["1", "5", "10", "20", "30"])),
        ("cell", list(&["2.0"])),
    ]
}

/// Whole lines that what was typed may become.
pub(crate) fn completions(state: &State, typed: &str) -> Vec<String> {
    let mut all: Vec<String> = COMMANDS.iter().map(|command| command.name.to_owned()).collect();
    for (word, values) in words(state) {
        all.extend(values.iter().map(|value| format!("{word} {value}")));
    }
    for (setting, values) in settings() {
        all.extend(values.iter().map(|value| format!("set {setting} {value}")));
    }
    all.retain(|line| line.starts_with(typed));
    all.extend(values(state, typed));
    all
}

/// Keys of values with the typed piece inside: nobody remembers how they begin.
fn values(state: &State, typed: &str) -> Vec<String> {
    let Some(piece) = typed.strip_prefix("value ") else { return Vec::new() };
    let keys = state.what_if.values.iter().map(|value| &value.key);
    keys.filter(|key| key.contains(piece) && !key.starts_with(piece))
        .map(|key| format!("value {key}"))
        .collect()
}

/// Runs a line.
pub(crate) fn run(state: &mut State, line: &str) {
    if line.is_empty() {
        return;
    }
    if let Ok(position) = line.parse::<usize>() {
        state.go_to(position);
        return;
    }
    let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    match (word, rest.trim()) {
        ("set", rest) => set(state, rest),
        ("compare", file) => compare(state, file),
        ("open", "") => act::menu(state),
        ("open", file) => whatif::open(state, source(file)),
        ("position", number) if number.parse::<usize>().is_ok() => run(state, number),
        ("q", "") => run(state, "quit"),
        ("view", name) => view(state, name),
        ("save", name) => whatif::save_line(state, name),
        ("value", rest) => value(state, rest),
        ("point" | "link" | "slide", name) => quantity(state, word, name),
        (name, "") => match command::named(name) {
            Some(command) if state.takes(command) => (command.run)(state),
            Some(command) => {
                let place = where_it_works(state, command);
                state.say(Role::Bad, fill(state.texts.not_here, &[&name, &place]));
            }
            _ => unknown(state, name),
        },
        _ => unknown(state, word),
    }
}

/// Reads a second scene, a file or a shipped one, or ends the comparison.
fn compare(state: &mut State, file: &str) {
    match file {
        "" => state.say(Role::Bad, state.texts.compare_what),
        "off" => state.compared = None,
        _ if state.study.is_none() => state.say(Role::Bad, state.texts.compare_with_what),
        _ => state.wishes.push(Wish::Work(Job::Compare(source(file)))),
    }
}

/// A file, or else a shipped scene of this name.
fn source(file: &str) -> Source {
    let path = whatif::home(file);
    let is_asked = |name: &str| name == file || name.strip_suffix(".toml") == Some(file);
    let shipped = super::menu::SCENES.iter().find(|(name, _)| is_asked(name));
    match shipped {
        Some((name, _)) if !path.exists() => Source::Shipped(name),
        _ => Source::File(path),
    }
}

fn unknown(state: &mut State, name: &str) {
    let known: Vec<String> = completions(state, "");
    let offer = suggestion(state, name, &known);
    state.say(Role::Bad, fill(state.texts.unknown_command, &[&name, &offer]));
}

/// `; did you mean ...?` or nothing; of a short word few letters can be wrong.
fn suggestion(state: &State, name: &str, known: &[String]) -> String {
    let far = (name.chars().count() / LETTERS).clamp(1, FAR);
    let near = known.iter().map(|candidate| (strsim::damerau_levenshtein(name, candidate), candidate)).min();
    match near {
        Some((distance, candidate)) if distance <= far => fill(state.texts.did_you_mean, &[candidate]),
        _ => String::new(),
    }
}

fn value(state: &mut State, rest: &str) {
    if whatif::set(state, rest) {
        return;
    }
    let name = rest.split_whitespace().next().unwrap_or_default();
    let known: Vec<String> = state.what_if.values.iter().map(|value| value.key.clone()).collect();
    let offer = suggestion(state, name, &known);
    state.say(Role::Bad, fill(state.texts.unknown_name, &[&format!("value {name}"), &offer]));
}

fn view(state: &mut State, name: &str) {
    let command = command::named(name).filter(|c| c.group == command::Group::Views && c.fits(state.view));
    match command {
        Some(command) => (command.run)(state),
        None => unknown(state, name),
    }
}

fn quantity(state: &mut State, word: &str, name: &str) {
    let Some(study) = &state.study else { return };
    let found = study.transfers.iter().position(|transfer| {
        let kind = match transfer.key {
            Key::Point(_) => "point",
            Key::Link(_) => "link",
            Key::Slide(_) => "slide",
        };
        kind == word && study.name_of(&transfer.key).eq_ignore_ascii_case(name)
    });
    if let Some(transfer) = found {
        state.chosen.transfer = transfer;
        return;
    }
    let known = words(state).into_iter().find(|(known, _)| *known == word).map(|(_, names)| names);
    let offer = suggestion(state, name, &known.unwrap_or_default());
    state.say(Role::Bad, fill(state.texts.unknown_name, &[&format!("{word} {name}"), &offer]));
}

fn set(state: &mut State, rest: &str) {
    let (name, value) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
    let value = value.trim();
    let done = match name {
        "theme" => {
            Theme::ALL.iter().find(|theme| theme.name() == value).map(|theme| state.look.theme = *theme)
        }
        "marker" => {
            Marker::ALL.iter().find(|marker| marker.name() == value).map(|marker| state.look.marker = *marker)
        }
        "ascii" => switch(value).map(|ascii| state.look.ascii = ascii),
        "fps" => value.parse().ok().filter(|fps| Look::FPS.contains(fps)).map(|fps| state.look.fps = fps),
        "cell" => {
            value.parse().ok().filter(|r| Look::RATIO.contains(r)).map(|ratio| state.look.ratio = ratio)
        }
        _ => None,
    };
    if done.is_none() {
        match settings().into_iter().find(|(known, _)| *known == name) {
            Some((_, values)) => {
                let taken = values.join(", ");
                state.say(Role::Bad, fill(state.texts.unknown_value, &[&name, &taken, &value]));
            }
            None => unknown(state, &format!("set {name}")),
        }
    }
}

fn switch(value: &str) -> Option<bool> {
    match value {
        "on" => Some(true),
        "off" => Some(false),
        _ => None,
    }
}

/// Chooses the next reaction of a pair of this name, else one whose pair or link begins so; tells whether there is one.
fn reaction(state: &mut State, wanted: &str) -> bool {
    let Some(found) = state.study.as_ref().and_then(|study| study.found.as_ref()) else { return false };
    let count = found.reactions.len();
    let next = |fits: &dyn Fn(&Reaction) -> bool| {
        let after = (1..=count).map(|step| (state.chosen.reaction + step) % count);
        after.into_iter().find(|index| fits(&found.reactions[*index]))
    };
    let name = |reaction: &Reaction| reaction.pair.to_lowercase();
    let same = next(&|reaction| name(reaction) == wanted);
    let begins = || {
        next(&|reaction| {
            name(reaction).starts_with(wanted) || reaction.link.to_lowercase().starts_with(wanted)
        })
    };
    let Some(index) = same.or_else(begins) else { return false };
    state.chosen.reaction = index;
    true
}

/// A number is a position; a word is looked for in the columns and quantities, from the present one on.
pub(crate) fn search(state: &mut State, text: &str) {
    if text.is_empty() {
        return;
    }
    if let Ok(position) = text.parse::<usize>() {
        state.go_to(position);
        return;
    }
    if state.values_open() {
        whatif::search(state, text);
        return;
    }
    let wanted = text.to_lowercase();
    if state.view == View::Forces && reaction(state, &wanted) {
        return;
    }
    let Some(study) = &state.study else { return };
    let count = study.column_count();
    let fits = |column: &usize| {
        let Some(series) = study.column(*column) else { return false };
        series.of.to_lowercase().contains(&wanted) || series.short.to_lowercase().contains(&wanted)
    };
    let found = (1..=count).map(|step| (state.chosen.column + step) % count).find(fits);
    let Some(column) = found else {
        state.say(Role::Bad, fill(state.texts.not_found, &[&text]));
        return;
    };
    let transfer = study.transfers.iter().position(|transfer| transfer.orders.contains(&column));
    state.chosen.column = column;
    state.chosen.transfer = transfer.unwrap_or(state.chosen.transfer);
}
