//! The help: every command by group, with its keys, and the words of the field; typing searches.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Widget};

use crate::screen::draw::{put, short, wrapped};
use crate::screen::state::{Command, Group, Help, Role, State, View};

/// Columns of the keys, the name and the line of help.
const KEYS_AT: u16 = 2;
const NAME_AT: u16 = 17;
const HELP_AT: u16 = 36;

/// Other words under which a command is looked for.
const ALSO: &[(&str, &str)] = &[
    ("greatest", "maximum max extreme peak highest"),
    ("least", "minimum min extreme lowest"),
    ("write", "export save image print png svg csv file figure"),
    ("pick", "plot graph diagram choose select overlay mean rms fuzzy"),
    ("what-if", "change edit modify parameter length mass"),
    ("save", "export scene file store"),
    ("undo", "revert back"),
    ("play", "animate animation movie run start stop"),
    ("probe", "coupler curve"),
    ("working", "steps equations explain solution formula"),
    ("checks", "residual error verify proof"),
    ("quit", "exit leave close end"),
    ("scenes", "load file examples new"),
    ("panels", "split layout windows side"),
    ("join", "assembly assemble dyad"),
];

/// Words of the field that the views use.
const GLOSSARY: &[(&str, &str)] = &[
    ("PF0", "position function: a place, angle or displacement as a function of the coordinate of the input"),
    (
        "PF1, PF2",
        "transfer functions: first and second derivative of PF0 with respect to the coordinate; \
                  v = PF1 w, a = PF2 w^2 + PF1 e",
    ),
    ("q, w, e", "coordinate of the input (angle or displacement), its speed and its acceleration"),
    (
        "J, J'",
        "moment of inertia (mass) of all links, reduced to the input, and its derivative by the coordinate",
    ),
    ("Q", "moment (force) of all loads, reduced to the input link"),
    (
        "balance",
        "balancing load: the moment or force on the input that keeps the motion; its power balances all others",
    ),
    ("group", "Assur group: links that can be joined to a mechanism without changing its mobility"),
    (
        "class, order",
        "class: by the most complex closed contour of a group, II for two links with three pairs; order: \
                      number of outer pairs",
    ),
    ("dyad", "Assur group of class II: two links, three pairs"),
    ("formula", "the groups in the order in which they are joined to the input link I"),
    ("mobility W", "number of independent motions: 3 n - 2 p for n links and p pairs with one freedom each"),
    (
        "determinant",
        "of the equations of a group, without dimension: 0 in a singular position, where it is indeterminate",
    ),
    ("way", "one of the assemblies that a group has with the same lengths"),
    ("residual", "what is left of an equation with the numbers found; it should be rounding"),
    ("unevenness", "(greatest - least) / mean speed of the input in a steady regime"),
    ("hodograph", "path of the tip of a vector that is drawn from one point"),
    ("plan", "vectors of all velocities or accelerations, or of the forces on a group, drawn from one pole"),
    ("condition", "1 / |determinant| of a group: how much errors grow"),
];

/// The pieces of one row: column, style and text of each.
type Pieces = Vec<(u16, Role, String)>;

/// Draws the help over the body.
pub(super) fn draw(state: &State, area: Rect, buffer: &mut Buffer) {
    let Some(help) = &state.help else { return };
    let theme = state.look.theme;
    Clear.render(area, buffer);
    let search = if help.filter.typing {
        format!("/{}", help.filter.text)
    } else {
        "type, or / and type, to search".to_owned()
    };
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
    let wanted = help.filter.text.to_lowercase();
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
    let words: Vec<Pieces> = GLOSSARY.iter().flat_map(|word| rows_of_word(state, *word, &wanted)).collect();
    if !words.is_empty() {
        rows.push(vec![(0, Role::Header, "Words".to_owned())]);
        rows.extend(words);
        rows.push(Vec::new());
    }
    let linear = "The same as plain lines: assur analyze, assur check, assur explain SCENE";
    rows.push(vec![(0, Role::Plain, linear.to_owned())]);
    rows
}

/// A word and its meaning, in as many rows as it needs; none if it does not match the search.
fn rows_of_word(state: &State, (word, meaning): (&str, &str), wanted: &str) -> Vec<Pieces> {
    if ![word, meaning].iter().any(|text| text.to_lowercase().contains(wanted)) {
        return Vec::new();
    }
    let width = usize::from(state.size.0.saturating_sub(NAME_AT + 2)).max(20);
    let mut rows: Vec<Pieces> =
        wrapped(meaning, width).into_iter().map(|line| vec![(NAME_AT, Role::Plain, line)]).collect();
    rows[0].insert(0, (KEYS_AT, Role::Key, word.to_owned()));
    rows
}

/// A command in as many rows as its line of help needs; none if it does not match the search.
fn rows_of(state: &State, command: &Command, wanted: &str) -> Vec<Pieces> {
    let keys = state.keys.keys(command.name).iter().map(|key| key.name()).collect::<Vec<_>>().join(" ");
    let also = ALSO.iter().find(|(name, _)| *name == command.name).map_or("", |(_, words)| words);
    if ![command.name, command.help, &keys, also].iter().any(|text| text.to_lowercase().contains(wanted)) {
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
        [one @ (View::Values | View::Probe)] => format!(" (view {})", one.name()),
        [one] => format!(" (view {})", keys(&[*one])),
        several if 2 * several.len() <= View::TABS.len() => format!(" (views {})", keys(several)),
        most => {
            let missing: Vec<View> = View::TABS.into_iter().filter(|view| !most.contains(view)).collect();
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
