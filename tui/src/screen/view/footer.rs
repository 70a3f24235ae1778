//! The last two rows: the keys of this view, and in the last row a message or typed text if there is one.

use assur_words::{Text, joined, name, text};
use crossterm::event::KeyCode;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Widget};
use unicode_width::UnicodeWidthStr;

use crate::screen::draw::{Pen, folded, short, wrapped};
use crate::screen::state::{
    Command, Key, PickerKind, PromptKind, Question, Role, Running, State, Task, View,
};

/// A command that applies in at most this many views belongs to them.
const OWN: usize = 4;

pub(super) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    if let Some(prompt) = &state.prompt {
        let sign = if prompt.kind == PromptKind::Command { ':' } else { '/' };
        let text = format!("{sign}{}", &*prompt.text);
        // The end of a long line is what is being written.
        let skip = text.chars().count().saturating_sub(usize::from(area.width).saturating_sub(2));
        let text: String = text.chars().skip(skip).collect();
        pen.put(area, 0, 1, &text, Role::Plain);
        pen.put(area, short(text.width()), 1, " ", Role::Cursor);
    } else if let Some(question) = &state.question {
        let question = match question {
            Question::Overwrite(file) => text!("overwrite", file = name(file.path.display().to_string())),
            Question::Recover(found) => text!("recover", scene = name(found.source.short_name())),
        };
        pen.tell(area, 1, 1, question, Role::Bad);
    } else if let Some((role, text)) = &state.message {
        let told = state.told(text);
        let lines = wrapped(&told, usize::from(area.width.saturating_sub(2)).max(1));
        // A long message takes the row of the keys too.
        if let ([one, other, ..], None) = (&lines[..], &state.picker) {
            pen.put(area, 1, 0, one, *role);
            pen.put(area, 1, 1, other, *role);
            return;
        }
        pen.put(area, 1, 1, &told, *role);
    } else if let Some(failure) = failure(state) {
        pen.tell(area, 1, 0, failure, Role::Bad);
    } else if let Some(running) = state.analyzing() {
        let text = calculating(state, running);
        pen.tell(area, 1, 0, text, Role::Dim);
    }
    if let Some(hint) = building(state).filter(|_| state.message.is_none()) {
        let lines = wrapped(&state.told(hint), usize::from(area.width.saturating_sub(2)).max(1));
        let lines: Vec<_> =
            lines.into_iter().take(area.height.into()).map(|line| (Role::Plain, line)).collect();
        return pen.put_lines(area, 1, &lines);
    }
    match (&state.help, &state.picker, &state.message) {
        // The line that is written stands below.
        (.., Some((role, text))) if state.prompt.is_some() => {
            pen.tell(area, 1, 0, text, *role);
        }
        (None, Some(picker), _) => {
            let mark =
                if picker.kind == PickerKind::Quantities { text!("list-mark") } else { Text::default() };
            let limits = if picker.kind == PickerKind::Motors { "  :motors 1.5 kW, 1500 rpm" } else { "" };
            let close = name(state.keys.first("close"));
            let text = state.told(text!("list-keys", mark = mark, close = close)) + limits;
            pen.put(area, 1, 0, &text, Role::Plain);
        }
        _ => match building(state) {
            // Below a message, in one row.
            Some(hint) => pen.tell(area, 1, 0, hint, Role::Plain),
            None => draw_hints(pen, area),
        },
    }
}

/// The keys of the task that building has in hand.
fn building(state: &State) -> Option<Text> {
    let close = name(state.keys.first("close"));
    match state.build.task {
        _ if !state.builds() => None,
        Task::Form(_) => Some(text!("build-form-keys", close)),
        Task::Join(_) => Some(text!("build-join-keys", close)),
        Task::Move => Some(text!("build-move-keys", close)),
        Task::Delete(_) | Task::Choose => None,
    }
}

/// The notice of an analysis in progress: its progress, and the key that stops it.
pub(super) fn calculating(state: &State, running: &Running) -> Text {
    let key = name(state.keys.first("close"));
    if running.count.is_empty() {
        text!("calculating", key = key)
    } else {
        text!("calculating-at", key = key, count = &running.count)
    }
}

/// Why this position can't be assembled, or else what the results lack or don't prove.
fn failure(state: &State) -> Option<Text> {
    let scene = state.scene.as_ref()?;
    let Some(lost) = scene.lost(state.position) else { return scene.verdict.messages().next().cloned() };
    let more = scene.fault.is_some() && state.view != View::Results;
    let more = more.then(|| text!("failure-more", key = name(state.keys.first("results"))));
    Some(joined("; ", std::iter::once(lost.why.clone()).chain(more)))
}

/// The keys of this view, in both rows where nothing else is said; the keys of the program stand at the right.
fn draw_hints(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    let language = state.language();
    let below = state.prompt.is_some() || state.question.is_some() || state.message.is_some();
    let above = !below && (failure(state).is_some() || state.analyzing().is_some());
    let fixed = ["command", "quit", "help"]
        .map(|name| {
            let told = state.named(name).map(|command| command.text(language, "end"));
            format!("{} {}", state.keys.first(name), told.unwrap_or_default())
        })
        .join("  ");
    let rows: &[u16] = match (below, above) {
        (true, _) => &[0],
        (_, true) => &[1],
        _ => &[0, 1],
    };
    let hints = hinted(state).into_iter().map(|command| {
        let name = if command.name == "search" && state.view == View::Forces { "pair" } else { "hint" };
        (command, command.text(language, name))
    });
    let mut hints = hints.filter(|(_, hint)| !hint.is_empty()).peekable();
    for row in rows {
        let kept = if *row == rows[rows.len() - 1] { short(fixed.width()) + 2 } else { 1 };
        let room = area.width.saturating_sub(kept);
        let mut column = 1;
        while let Some((command, hint)) = hints.peek() {
            let key = keys_of_hint(state, command);
            let width = short(key.width() + hint.width() + 3);
            if column + width > room {
                break;
            }
            pen.put(area, column, *row, &key, Role::Key);
            pen.put(area, column + short(key.width()) + 1, *row, hint, Role::Plain);
            column += width;
            hints.next();
        }
    }
    let column = area.width.saturating_sub(short(fixed.width()) + 1);
    pen.put(area, column, rows[rows.len() - 1], &fixed, Role::Plain);
}

/// Commands that have a key now: first stepping, then the list of values, the commands of the view alone, and the
/// others.
fn hinted(state: &State) -> Vec<&'static Command> {
    let has_key = |command: &&'static Command| {
        let meant = state.keys.keys(command.name).first().and_then(|key| state.command(*key));
        meant.is_some_and(|meant| meant.name == command.name)
    };
    let own = |command: &Command| !command.views.is_empty() && command.views.len() <= OWN;
    let mut fit: Vec<_> = state
        .commands
        .iter()
        .filter(|command| state.takes(command) && (command.works)(state))
        .filter(has_key)
        .collect();
    fit.sort_by_key(|command| match command.name {
        "next-position" => 0,
        "undo" | "save" => 2,
        "exact-value" => 3,
        "search" if [View::Forces, View::Table].contains(&state.view) => 5,
        "pick" | "greatest" | "what-if" | "write" => 5,
        "analyzer" | "difference" => 6,
        _ if command.views == [View::Values] => 1,
        _ if own(command) => 4,
        _ => 7,
    });
    fit
}

/// Pairs of opposite keys share an entry: `←/→ step`.
fn keys_of_hint(state: &State, command: &'static Command) -> String {
    let shown = |key: &Key| match key.code {
        KeyCode::Left if !state.look.ascii => "←".to_owned(),
        KeyCode::Right if !state.look.ascii => "→".to_owned(),
        KeyCode::Up if !state.look.ascii => "↑".to_owned(),
        KeyCode::Down if !state.look.ascii => "↓".to_owned(),
        _ => key.name(),
    };
    let key = state.keys.keys(command.name).first().map(shown).unwrap_or_default();
    if command.name == "raise" {
        return format!("{key}/{}", state.keys.first("lower"));
    }
    if command.name == "forward" {
        return format!("{}/{key}", state.keys.first("back"));
    }
    let opposite = command.name.strip_prefix("next-").map(|what| format!("previous-{what}"));
    let opposite = opposite.and_then(|opposite| state.keys.keys(&opposite).first());
    // Shift+Tab is the opposite of Tab everywhere and needs no mention.
    match opposite.filter(|key| key.code != KeyCode::BackTab) {
        Some(opposite) => format!("{}/{key}", shown(opposite)),
        None => key,
    }
}

pub(crate) fn draw_fault(pen: &mut Pen<'_>, [title, fault]: [&Text; 2], area: Rect) {
    let state = pen.state;
    let (title, fault) = (state.told(title), state.told(fault));
    let width = usize::from(area.width.saturating_sub(2));
    // A line of the file stays one row, because the next row marks a place in it.
    let quoted = |line: &str| {
        line.split_once('|').is_some_and(|(number, _)| number.trim().chars().all(|c| c.is_ascii_digit()))
    };
    let rows = |line| if quoted(line) { vec![line.to_owned()] } else { folded(line, width) };
    let room = usize::from(area.height.saturating_sub(2));
    let mut shown: Vec<String> = fault.lines().flat_map(rows).collect();
    if shown.len() > room {
        // The message and place of every error, before the lines of the file.
        let told = |line: &&str| !quoted(line) && !line.is_empty() && !line.starts_with("  =");
        shown = fault.lines().filter(told).flat_map(rows).collect();
    }
    if shown.len() > room {
        let more = shown.len() - room.saturating_sub(1);
        shown.truncate(room.saturating_sub(1));
        shown.push(state.told(text!("fault-more-lines", count = more)));
    }
    let fault = shown;
    let lines = short(fault.len());
    let height = (lines + 2).min(area.height);
    let place = Rect::new(area.x, area.y + (area.height - height) / 2, area.width, height);
    Clear.render(place, pen.buffer);
    let block = Block::bordered().title(title).style(state.look.theme.style(Role::Plain));
    let inner = block.inner(place);
    block.render(place, pen.buffer);
    for (row, line) in fault.iter().enumerate() {
        pen.put(inner, 0, short(row), line, Role::Plain);
    }
}
