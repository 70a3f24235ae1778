//! The commands of the `:` line and of the `/` line.

use assur_fixtures::SCENES;
use assur_picture::{Look, Picture, find};
use assur_scene::edit::SceneValue;
use assur_scene::reference::words_of;
use assur_words::{self as words, Text, text};

use super::{act, build, draft, motors, picker, write};
use crate::screen::state::{
    Chosen, Group, Panels, Pictures, Role, SETTINGS, Scene, Source, State, View, Wanted,
};
use crate::screen::view::help::where_it_works;
use crate::still::suggestion;

/// Words of the line that take a value, and their values.
fn takers(state: &State) -> Vec<(String, Vec<String>)> {
    let of_scene = |kind: &str| {
        let owner = |scene: &Scene| -> Vec<String> {
            let owners = scene.transfers.iter().map(|transfer| scene.owner(&transfer.owner));
            owners.filter(|(of, _)| *of == kind).map(|(_, name)| name.to_owned()).collect()
        };
        let mut names = state.scene.as_ref().map(owner).unwrap_or_default();
        // A point has two quantities.
        names.dedup();
        names
    };
    let list = |values: &[&str]| values.iter().map(|value| (*value).to_owned()).collect::<Vec<_>>();
    let views = state.commands.iter().filter(|command| command.group == Group::Views);
    let scenes: Vec<_> = SCENES.iter().map(|(name, _)| format!("{name}.toml")).collect();
    // A setting is a word of the line by itself, too.
    let settings = ["set ", ""].into_iter().flat_map(|set| {
        SETTINGS.iter().map(move |setting| (format!("{set}{}", setting.name), list(setting.kind.words())))
    });
    let others = [
        ("point", of_scene("point")),
        ("link", of_scene("link")),
        ("slide", of_scene("slide")),
        ("view", views.map(|command| command.name.to_owned()).collect()),
        ("panels", View::TABS.map(|view| view.command().to_owned()).to_vec()),
        ("open", scenes.clone()),
        ("compare", scenes),
        ("value", state.draft.values.iter().map(|value| value.key.to_string()).collect()),
    ];
    others.map(|(word, values)| (word.to_owned(), values)).into_iter().chain(settings).collect()
}

/// Paths of scene files and folders that begin with what is typed of them; hidden ones are left out.
fn files(typed: &str) -> Vec<String> {
    let (folder, begun) = typed.rfind('/').map_or(("", typed), |at| typed.split_at(at + 1));
    let place = if folder.is_empty() { "./".into() } else { write::home(folder) };
    let entries = std::fs::read_dir(place).into_iter().flatten().flatten();
    let path = |entry: std::fs::DirEntry| {
        let name = entry.file_name().into_string().ok()?;
        let fits = name.starts_with(begun) && !name.starts_with('.');
        let is_folder = entry.path().is_dir();
        (fits && (is_folder || entry.path().extension().is_some_and(|ending| ending == "toml")))
            .then(|| format!("{folder}{name}{}", if is_folder { "/" } else { "" }))
    };
    let mut paths: Vec<String> = entries.filter_map(path).collect();
    paths.sort();
    paths
}

pub(super) fn completions(state: &State, typed: &str) -> Vec<String> {
    let mut all: Vec<String> = state.commands.iter().map(|command| command.name.to_owned()).collect();
    for (word, values) in takers(state) {
        all.extend(values.iter().map(|value| format!("{word} {value}")));
    }
    all.retain(|line| line.starts_with(typed));
    for word in ["open ", "compare "] {
        let typed = typed.strip_prefix(word).map(str::trim_start);
        let known = |line: &String| !all.contains(line);
        let paths = typed.map(files).unwrap_or_default().into_iter().map(|path| format!("{word}{path}"));
        let paths: Vec<String> = paths.filter(known).collect();
        all.extend(paths);
    }
    // Keys of values also match inside: their beginnings are hard to remember.
    if let Some(piece) = typed.strip_prefix("value ") {
        let keys = state.draft.values.iter().map(|value| value.key.to_string());
        let inside = keys.filter(|key| key.contains(piece) && !key.starts_with(piece));
        all.extend(inside.map(|key| format!("value {key}")));
    }
    all
}

/// The position nearest to a coordinate, or the sample nearest to a time, with the unit of the horizontal axis: `90 deg`, `2.5 s`.
fn place(state: &State, line: &str) -> Option<usize> {
    let scene = state.scene.as_ref()?;
    let (unit, factor) = scene.axis_unit();
    let value: f64 = line.strip_suffix(unit)?.trim_end().parse().ok()?;
    Some(scene.nearest(value / factor))
}

pub(super) fn run(state: &mut State, line: &str) {
    if let Ok(position) = line.parse::<usize>() {
        return state.go_to(position);
    }
    if let Some(place) = place(state, line) {
        return state.go_to(place);
    }
    let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    match (word, rest.trim()) {
        ("", _) => {}
        ("set", rest) => set(state, rest),
        ("compare", file) => compare(state, file),
        ("open", "") => picker::scenes(state),
        ("open", file) => draft::open(state, source(file)),
        ("position", number) if number.parse::<usize>().is_ok() => run(state, number),
        ("q", "") => run(state, "quit"),
        ("view", name) => view(state, name),
        ("join", words) => build::rejoin_line(state, words),
        ("save", name) => draft::save_line(state, name),
        ("write", name) if !name.is_empty() => write::write_to(state, write::home(name)),
        ("motors", rest) if !rest.is_empty() => motors::limits(state, rest),
        ("panels", names) if !names.is_empty() => panels(state, names),
        ("value", rest) => {
            if !draft::set(state, rest) {
                unknown_name(state, word, rest.split_whitespace().next().unwrap_or_default());
            }
        }
        ("point" | "link" | "slide", name) => quantity(state, word, name),
        (name, "") => match state.named(name) {
            Some(command) if state.takes(command) => (command.run)(state),
            Some(command) => {
                let (place, command) = (where_it_works(state, command), words::name(command.name));
                state.say(Role::Bad, text!("say-no-meaning", command = command, views = place));
            }
            _ => unknown(state, name),
        },
        (word, _) if SETTINGS.iter().any(|setting| setting.name == word) => set(state, line),
        _ => unknown(state, word),
    }
}

fn compare(state: &mut State, file: &str) {
    match file {
        "" => state.say(Role::Bad, text!("say-compare")),
        "off" => state.compared = None,
        _ if state.scene.is_none() => state.say(Role::Bad, text!("say-nothing-to-compare")),
        _ => state.read(Wanted::Compare(source(file), state.positions())),
    }
}

/// A file, or else a shipped scene of this name, with or without the ending.
fn source(file: &str) -> Source {
    let path = write::home(file);
    let name = file.strip_suffix(".toml").unwrap_or(file);
    match SCENES.iter().find(|(known, _)| *known == name) {
        Some((name, _)) if !path.exists() => Source::Shipped(name),
        _ => Source::File(path),
    }
}

fn unknown(state: &mut State, name: &str) {
    let offer = suggestion(name, &completions(state, ""));
    state.say(Role::Bad, text!("say-no-command", command = words::name(name.to_owned()), offer = offer));
}

fn unknown_name(state: &mut State, word: &str, name: &str) {
    let taker = takers(state).into_iter().find(|(known, _)| *known == word);
    let offer = suggestion(name, &taker.map(|(_, values)| values).unwrap_or_default());
    state.say(Role::Bad, text!("say-no-such", words = words::name(format!("{word} {name}")), offer = offer));
}

fn view(state: &mut State, name: &str) {
    match state.named(name).filter(|command| command.group == Group::Views) {
        Some(command) if state.scene.is_some() => (command.run)(state),
        Some(_) => state.say(Role::Bad, text!("say-no-scene")),
        None => unknown_name(state, "view", name),
    }
}

fn panels(state: &mut State, names: &str) {
    let known = |name: &str| name.parse().ok().filter(|view| View::TABS.contains(view));
    match names.split_whitespace().map(|name| known(name).ok_or(name)).collect() {
        Ok(views) => state.panels = Panels { shown: true, views },
        Err(name) => unknown_name(state, "view", name),
    }
}

fn quantity(state: &mut State, kind: &str, name: &str) {
    let Some(scene) = &state.scene else { return };
    let found = scene.transfers.iter().position(|transfer| {
        let (of, known) = scene.owner(&transfer.owner);
        of == kind && known.eq_ignore_ascii_case(name)
    });
    match found {
        Some(transfer) => state.chosen.transfer = transfer,
        None => unknown_name(state, kind, name),
    }
}

fn set(state: &mut State, rest: &str) {
    let (name, value) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
    let value = value.trim();
    let Some(setting) = SETTINGS.iter().find(|setting| setting.name.starts_with(name) && !name.is_empty())
    else {
        return unknown(state, &format!("set {name}"));
    };
    if state.pictures == Pictures::None {
        state.pictures = Pictures::Unknown;
    }
    if setting.take(&mut state.look, value).is_none() {
        let (own, value) = (words::name(setting.name), words::name(value.to_owned()));
        let allowed = setting.kind.told();
        state.say(Role::Bad, text!("say-setting", setting = own, allowed = allowed, value = value));
    }
}

pub(super) fn search_again(state: &mut State) {
    let text = std::mem::take(&mut state.searched);
    if text.is_empty() {
        return state
            .say(Role::Plain, text!("say-nothing-searched", key = words::name(state.keys.first("search"))));
    }
    search(state, &text);
}

/// A number is a position; a word is searched for in what the view lists, else in the columns and quantities, from the present one
/// on.
pub(super) fn search(state: &mut State, text: &str) {
    if text.is_empty() {
        return;
    }
    text.clone_into(&mut state.searched);
    if let Ok(position) = text.parse::<usize>() {
        return state.go_to(position);
    }
    let wanted = text.to_lowercase();
    let found = match if state.values_open() { View::Values } else { state.view } {
        View::Working | View::Accuracy => act::find_line(state, &wanted).ok_or_else(Vec::new),
        view @ (View::Values | View::Results | View::Checks) => row(state, view, text),
        _ => pictured(state, text),
    };
    if let Err(known) = found {
        let offer = suggestion(text, &known.concat());
        state.say(Role::Bad, text!("say-not-found", text = words::name(text.to_owned()), offer));
    }
}

/// Chooses the next row of the list of a view in which a text occurs.
fn row(state: &mut State, view: View, wanted: &str) -> Result<(), Vec<Vec<String>>> {
    let of_value =
        |value: &SceneValue| std::iter::once((&value.key).into()).chain(words_of(&value.key)).collect();
    let rows: Vec<Vec<Text>> = match (view, state.found()) {
        (View::Values, _) => state.draft.values.iter().map(of_value).collect(),
        (View::Results, Some(found)) => found.results.iter().map(|(_, fact)| vec![fact.what()]).collect(),
        (_, Some(found)) => found.analysis.checks.iter().map(|check| vec![check.name.clone()]).collect(),
        _ => Vec::new(),
    };
    let told = |row: Vec<Text>| row.into_iter().map(|text| state.told(text)).collect::<Vec<_>>();
    let rows: Vec<_> = rows.into_iter().map(told).collect();
    let (chosen, _) = act::list(state, view);
    let found = find::by_name(&rows, *chosen, wanted);
    *chosen = found.ok_or(rows)?;
    Ok(())
}

/// Chooses what the picture of the view shows, or a quantity.
fn pictured(state: &mut State, wanted: &str) -> Result<(), Vec<Vec<String>>> {
    let Some(scene) = &state.scene else { return Ok(()) };
    let shown = (state.view.picture().unwrap_or(Picture::Curves), state.part(state.view));
    let mut look = state.pictured();
    look.choose(scene, shown, wanted, |text| state.told(text))?;
    let Look { transfer, group, reaction, polygon, step, column, .. } = look;
    if state.view == View::Curves {
        let alone = scene.column(column).filter(|_| scene.transfer_of(column).is_none());
        state.picked = alone.map(|series| series.short.clone()).into_iter().collect();
    }
    state.chosen = Chosen { transfer, group, reaction, polygon, step, column, ..state.chosen };
    Ok(())
}
