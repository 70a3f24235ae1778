//! The help: every command by group, with its keys; typing searches.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Widget};

use super::footer::texts_of;
use super::panel::wrapped;
use super::{header, put};
use crate::screen::command::{COMMANDS, Command, Group, SCENE};
use crate::screen::draw::raster::short;
use crate::screen::state::{Help, State, View};
use crate::screen::text::{Texts, fill};
use crate::screen::theme::Role;

const KEYS_AT: u16 = 2;
const NAME_AT: u16 = 17;
const HELP_AT: u16 = 36;

/// One row of the help.
enum Row {
    Title(&'static str),
    Command(&'static Command, String),
    /// What a line of help has more than fits.
    More(String),
    Text(&'static str),
    Empty,
}

/// Draws the help over the body.
pub(crate) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let Some(help) = &state.help else { return };
    let theme = state.look.theme;
    Clear.render(area, buffer);
    let search =
        if help.filter.is_empty() { state.texts.help_filter.to_owned() } else { format!("/{}", help.filter) };
    let block = Block::bordered().title(state.texts.help_title).title_bottom(search);
    let inner = block.inner(area);
    block.render(area, buffer);
    let rows = rows(state, help);
    for (line, row) in rows.iter().skip(help.scroll).take(usize::from(inner.height)).enumerate() {
        let line = short(line);
        match row {
            Row::Title(title) => put(buffer, inner, 0, line, title, theme.style(Role::Header)),
            Row::Text(text) => put(buffer, inner, 0, line, text, theme.style(Role::Plain)),
            Row::Empty => {}
            Row::More(text) => put(buffer, inner, HELP_AT, line, text, theme.style(Role::Plain)),
            Row::Command(command, text) => {
                put(buffer, inner, KEYS_AT, line, &keys(state, command), theme.style(Role::Key));
                put(buffer, inner, NAME_AT, line, command.name, theme.style(Role::Plain));
                put(buffer, inner, HELP_AT, line, text, theme.style(Role::Plain));
            }
        }
    }
    let shown = help.scroll + usize::from(inner.height);
    if rows.len() > shown || help.scroll > 0 {
        let text = format!("{}-{} / {}", help.scroll + 1, shown.min(rows.len()), rows.len());
        put(
            buffer,
            area,
            area.width.saturating_sub(short(text.len()) + 2),
            0,
            &text,
            theme.style(Role::Plain),
        );
    }
}

/// Keys of a command: `Right l`.
fn keys(state: &State, command: &'static Command) -> String {
    state.keys.of(command).iter().map(|key| key.name()).collect::<Vec<_>>().join(" ")
}

fn rows(state: &State, help: &Help) -> Vec<Row> {
    let wanted = help.filter.to_lowercase();
    let fits = |command: &&'static Command| {
        let (text, _) = texts_of(state.texts, command.name);
        wanted.is_empty()
            || command.name.contains(&wanted)
            || text.to_lowercase().contains(&wanted)
            || keys(state, command).to_lowercase().contains(&wanted)
    };
    let mut rows = Vec::new();
    for group in Group::ALL {
        let of_group: Vec<_> =
            COMMANDS.iter().filter(|command| command.group == group).filter(fits).collect();
        if of_group.is_empty() {
            continue;
        }
        rows.push(Row::Title(title(state.texts, group)));
        rows.extend(of_group.into_iter().flat_map(|command| rows_of(state, command)));
        rows.push(Row::Empty);
    }
    rows.push(Row::Text(state.texts.help_linear));
    rows
}

/// The keys of the views in which the keys of a command mean it, where it is not every view with a scene: ` (view 3)`.
pub(crate) fn where_it_works(state: &State, command: &Command) -> String {
    let names = |views: &[View]| {
        let names: Vec<String> = views.iter().map(|view| header::key(state, *view)).collect();
        names.join(" ")
    };
    let texts = state.texts;
    match command.views {
        [] => String::new(),
        [View::Menu] => fill(texts.in_view, &[&texts.menu]),
        [View::Values] => fill(texts.in_view, &[&texts.group_change]),
        [one] => fill(texts.in_view, &[&names(&[*one])]),
        several if 2 * several.len() <= SCENE.len() => fill(texts.in_views, &[&names(several)]),
        most => {
            let missing: Vec<View> = SCENE.iter().copied().filter(|view| !most.contains(view)).collect();
            if missing.is_empty() { String::new() } else { fill(texts.not_in_view, &[&names(&missing)]) }
        }
    }
}

/// A command in as many rows as its line of help needs.
fn rows_of(state: &State, command: &'static Command) -> Vec<Row> {
    // The border takes a column at each side.
    let width = usize::from(state.size.0.saturating_sub(HELP_AT + 2)).max(20);
    let text = format!("{}{}", texts_of(state.texts, command.name).0, where_it_works(state, command));
    let mut lines = wrapped(&text, width).into_iter();
    let first = Row::Command(command, lines.next().unwrap_or_default());
    std::iter::once(first).chain(lines.map(Row::More)).collect()
}

/// Title of a group of commands.
pub(crate) fn title(texts: &Texts, group: Group) -> &'static str {
    match group {
        Group::Move => texts.group_move,
        Group::Choose => texts.group_choose,
        Group::Change => texts.group_change,
        Group::Views => texts.group_view,
        Group::Look => texts.group_look,
        Group::Program => texts.group_program,
    }
}

/// Rows that a page key scrolls: a row stays, to read on from.
pub(crate) fn page(state: &State) -> usize {
    height(state).saturating_sub(1).max(1)
}

/// Rows of the help that are seen at once: two of header, two of footer and two of border are not.
fn height(state: &State) -> usize {
    usize::from(state.size.1.saturating_sub(6))
}

/// The farthest that the help can be scrolled.
pub(crate) fn last_scroll(state: &State) -> usize {
    let Some(help) = &state.help else { return 0 };
    rows(state, help).len().saturating_sub(height(state))
}
