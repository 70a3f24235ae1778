//! The help: every command by group, with its keys; typing searches.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Widget};

use crate::screen::draw::{put, short, wrapped};
use crate::screen::state::{Command, Group, Help, Role, State, View};

/// Columns of the keys, the name and the line of help.
const KEYS_AT: u16 = 2;
const NAME_AT: u16 = 17;
const HELP_AT: u16 = 36;

/// The pieces of one row: column, style and text of each.
type Pieces = Vec<(u16, Role, String)>;

/// Draws the help over the body.
pub(super) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let Some(help) = &state.help else { return };
    let theme = state.look.theme;
    Clear.render(area, buffer);
    let search =
        if help.filter.is_empty() { "type to search".to_owned() } else { format!("/{}", help.filter) };
    let block = Block::bordered().title("Help: every key, by what it does").title_bottom(search);
    let inner = block.inner(area);
    block.render(area, buffer);
    let rows = rows(state, help);
    for (line, row) in rows.iter().skip(help.scroll).take(usize::from(inner.height)).enumerate() {
        for (column, role, text) in row {
            put(buffer, inner, *column, short(line), text, theme.style(*role));
        }
    }
    let shown = help.scroll + usize::from(inner.height);
    if rows.len() > shown || help.scroll > 0 {
        let text = format!("{}-{} / {}", help.scroll + 1, shown.min(rows.len()), rows.len());
        let column = area.width.saturating_sub(short(text.len()) + 2);
        put(buffer, area, column, 0, &text, theme.style(Role::Plain));
    }
}

fn rows(state: &State, help: &Help) -> Vec<Pieces> {
    let wanted = help.filter.to_lowercase();
    let mut rows = Vec::new();
    for (group, title) in Group::ALL {
        let of_group = state.commands.iter().filter(|command| command.group == group);
        let commands: Vec<Pieces> = of_group.flat_map(|command| rows_of(state, command, &wanted)).collect();
        if !commands.is_empty() {
            rows.push(vec![(0, Role::Header, title.to_owned())]);
            rows.extend(commands);
            rows.push(Vec::new());
        }
    }
    let linear = "The same as plain lines: assur analyze, assur check, assur explain SCENE";
    rows.push(vec![(0, Role::Plain, linear.to_owned())]);
    rows
}

/// A command in as many rows as its line of help needs; none if it does not match the search.
fn rows_of(state: &State, command: &Command, wanted: &str) -> Vec<Pieces> {
    let keys = state.keys.keys(command.name).iter().map(|key| key.name()).collect::<Vec<_>>().join(" ");
    if ![command.name, command.help, &keys].iter().any(|text| text.to_lowercase().contains(wanted)) {
        return Vec::new();
    }
    // The border takes a column at each side.
    let width = usize::from(state.size.0.saturating_sub(HELP_AT + 2)).max(20);
    let text = format!("{}{}", command.help, where_it_works(state, command));
    let lines = wrapped(&text, width).into_iter();
    let mut rows: Vec<Pieces> = lines.map(|line| vec![(HELP_AT, Role::Plain, line)]).collect();
    let name = command.name.to_owned();
    rows[0].splice(0..0, [(KEYS_AT, Role::Key, keys), (NAME_AT, Role::Plain, name)]);
    rows
}

/// The views in which the keys of a command apply, if not every view with a scene: ` (view 3)`.
pub(crate) fn where_it_works(state: &State, command: &Command) -> String {
    let keys = |views: &[View]| {
        let keys: Vec<String> = views.iter().map(|view| state.keys.first(view.command())).collect();
        keys.join(" ")
    };
    match command.views {
        [] => String::new(),
        [one @ (View::Menu | View::Values)] => format!(" (view {})", one.name()),
        [one] => format!(" (view {})", keys(&[*one])),
        several if 2 * several.len() <= View::OF_SCENE.len() => format!(" (views {})", keys(several)),
        most => {
            let missing: Vec<View> = View::OF_SCENE.into_iter().filter(|view| !most.contains(view)).collect();
            if missing.is_empty() { String::new() } else { format!(" (not {})", keys(&missing)) }
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
