//! The help: what is chosen, every command by group, with its keys, and the words of the field; typing searches.

mod built;
mod chosen;
mod subject;

use assur_book::glossary::{ENTRIES, Entry};
use assur_words::{Text, joined, name, text};
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Widget};
use unicode_width::UnicodeWidthStr;

use crate::explained;
use crate::screen::draw::{Pen, short, wrapped};
use crate::screen::state::{Command, Group, Help, Role, State, View};

/// Columns of the keys, the name and the line of help.
const KEYS_AT: u16 = 2;
const NAME_AT: u16 = 17;
const HELP_AT: u16 = 36;

/// The pieces of one row: column, style and text of each.
type Pieces = Vec<(u16, Role, String)>;

pub(super) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    let Some(help) = &state.help else { return };
    Clear.render(area, pen.buffer);
    let search = if help.filter.typing {
        format!("/{}", &*help.filter.text)
    } else {
        state.told(text!("help-search"))
    };
    let block = Block::bordered().title(state.told(text!("help-title"))).title_bottom(search);
    let inner = block.inner(area);
    block.render(area, pen.buffer);
    let rows = rows(state, help);
    for (line, row) in rows.iter().skip(help.scroll).take(usize::from(inner.height)).enumerate() {
        for (column, role, text) in row {
            pen.put(inner, *column, short(line), text, *role);
        }
    }
    let shown = rows.len().min(help.scroll + usize::from(inner.height));
    pen.mark_rows(Rect { width: inner.width + 1, ..inner }, help.scroll..shown, rows.len());
}

fn rows(state: &State, help: &Help) -> Vec<Pieces> {
    let wanted = help.filter.text.to_lowercase();
    let mut rows = if wanted.is_empty() { rows_of_chosen(state) } else { Vec::new() };
    let languages = state.told(text!("help-language"));
    if languages.to_lowercase().contains(&wanted) {
        rows.push(vec![(0, Role::Plain, languages)]);
    }
    if wanted.is_empty() {
        rows.push(vec![(NAME_AT, Role::Dim, state.told(text!("help-names")))]);
    }
    let of_group = |(group, id): (Group, &'static str)| {
        let commands = state.commands.iter().filter(|command| command.group == group);
        (id, commands.flat_map(|command| rows_of(state, command, &wanted)).collect())
    };
    let found = ENTRIES.iter().filter(|word| explained::speaks_of(word, &wanted, state.language()));
    let words: Vec<_> = found.flat_map(|word| rows_of_word(state, word)).collect();
    let sections = Group::ALL.into_iter().map(of_group).chain([("group-words", words)]);
    for (title, found) in sections.filter(|(_, found)| !found.is_empty()) {
        rows.push(vec![(0, Role::Header, state.told(text!(title)))]);
        rows.extend(found);
        rows.push(Vec::new());
    }
    if rows.is_empty() && !wanted.is_empty() {
        let sought = name((*help.filter.text).to_owned());
        rows.push(vec![(
            0,
            Role::Bad,
            state.told(text!("say-not-found", text = sought, offer = Text::default())),
        )]);
    }
    rows.push(vec![(0, Role::Plain, state.told(text!("help-linear")))]);
    rows
}

/// What is chosen, with the words of the field that it is about; none where no scene is open.
fn rows_of_chosen(state: &State) -> Vec<Pieces> {
    let Some(chosen) = chosen::chosen(state) else { return Vec::new() };
    let title = state.told(text!("help-chosen", what = chosen.title));
    let told =
        chosen.lines.into_iter().flat_map(|line| folded(state, Vec::new(), KEYS_AT, &state.told(line)));
    let mut rows: Vec<Pieces> = wrapped(&title, usize::from(state.size.0.saturating_sub(2)).max(20))
        .into_iter()
        .map(|line| vec![(0, Role::Header, line)])
        .chain(told)
        .collect();
    rows.extend(chosen.words.into_iter().flat_map(|word| rows_of_word(state, word)));
    rows.push(Vec::new());
    rows
}

/// A word with its meaning, its formula, its source, and its place in the note.
fn rows_of_word(state: &State, entry: &Entry) -> Vec<Pieces> {
    let word = state.told(&entry.word);
    // A long word moves what is told of it to the right, a very long one to the next row.
    let end = u16::try_from(word.width()).unwrap_or(u16::MAX).saturating_add(KEYS_AT + 2);
    let (column, beside) = if end <= HELP_AT { (NAME_AT.max(end), true) } else { (NAME_AT, false) };
    let word = vec![(KEYS_AT, Role::Key, word)];
    let (mut rows, first) = if beside { (Vec::new(), word) } else { (vec![word], Vec::new()) };
    rows.extend(folded(state, first, column, &state.told(&entry.meaning)));
    let further = explained::beside(entry, state.look.ascii);
    rows.extend(further.into_iter().flat_map(|line| folded(state, Vec::new(), column, &state.told(line))));
    rows
}

/// A command and what it does; none if it does not match the search.
fn rows_of(state: &State, command: &Command, wanted: &str) -> Vec<Pieces> {
    let keys = state.keys.keys(command.name).iter().map(|key| key.name()).collect::<Vec<_>>().join(" ");
    let language = state.language();
    let (help, also) = (command.help(language), command.text(language, "also"));
    if ![command.name, &help, &keys, &also].iter().any(|text| text.to_lowercase().contains(wanted)) {
        return Vec::new();
    }
    let names = vec![(KEYS_AT, Role::Key, keys), (NAME_AT, Role::Plain, command.name.to_owned())];
    folded(state, names, HELP_AT, &(help + &state.told(where_it_works(state, command))))
}

/// A text from a column on, in as many rows as it needs, behind other pieces in the first row.
fn folded(state: &State, mut first: Pieces, column: u16, text: &str) -> Vec<Pieces> {
    // The border takes a column at each side.
    let width = usize::from(state.size.0.saturating_sub(column + 2)).max(20);
    let lines = wrapped(text, width).into_iter().map(|line| (column, Role::Plain, line));
    lines.map(|line| std::mem::take(&mut first).into_iter().chain([line]).collect()).collect()
}

/// The views in which the keys of a command apply, if not every view with a scene: ` (view 3)`.
pub(crate) fn where_it_works(state: &State, command: &Command) -> Text {
    let told = |id: &'static str, views: &[View]| {
        let keys = views.iter().map(|view| name(state.keys.first(view.command())));
        text!(id, views = joined(" ", keys))
    };
    match command.views {
        [] => Text::default(),
        [one @ (View::Values | View::Probe)] => text!("works-in-view", views = one.name()),
        [_] => told("works-in-view", command.views),
        several if 2 * several.len() <= View::TABS.len() => told("works-in-views", several),
        most => {
            let missing: Vec<View> = View::TABS.into_iter().filter(|view| !most.contains(view)).collect();
            if missing.is_empty() { Text::default() } else { told("works-not-in", &missing) }
        }
    }
}

/// Rows that a page key scrolls: one row less than are visible.
pub(crate) fn page(state: &State) -> usize {
    height(state).saturating_sub(1).max(1)
}

/// Visible rows of the help: without two of header, two of footer and two of border.
fn height(state: &State) -> usize {
    usize::from(state.size.1.saturating_sub(6))
}

/// Greatest scroll position of the help.
pub(crate) fn last_scroll(state: &State) -> usize {
    state.help.as_ref().map_or(0, |help| rows(state, help).len().saturating_sub(height(state)))
}
