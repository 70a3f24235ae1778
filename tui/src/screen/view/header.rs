//! The first two rows: scene and position, and the views.

use assur_words::{Text, name, number, quantity, text};
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::values;
use crate::number::{digits, trimmed};
use crate::screen::draw::{Pen, short};
use crate::screen::state::{Reading, Role, Scene, State, View, coordinate_unit};

/// Columns that the key of a changed value can spare.
const KEY_ROOM: usize = 20;
/// Digits of a number in the header.
const DIGITS: usize = 6;

pub(super) fn draw(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    if state.view == View::Build {
        draw_built(pen, area);
        return draw_tabs(pen, area);
    }
    let Some(scene) = &state.scene else {
        pen.put(area, 0, 0, concat!("assur ", env!("CARGO_PKG_VERSION")), Role::Header);
        return;
    };
    let position = position(state, scene);
    pen.put(area, 1, 0, &position, Role::Header);
    let column = short(position.width() + 4);
    let room = usize::from(area.width.saturating_sub(column));
    let (role, text) = match changed(state, room) {
        Some(text) if state.draft.reading == Reading::Refused => (Role::Bad, text),
        Some(text) => (Role::Header, text),
        None => (Role::Plain, state.told(title(state, scene))),
    };
    pen.put(area, column, 0, &text, role);
    draw_tabs(pen, area);
}

/// The file that is built, marked where it has changes that no file has, and what it has become.
fn draw_built(pen: &mut Pen<'_>, area: Rect) {
    let state = pen.state;
    let mark = if state.draft.is_kept() { "" } else { "* " };
    let file = format!("{mark}{}", state.draft.source.short_name());
    pen.put(area, 1, 0, &file, Role::Header);
    if let Some(scene) = &state.scene {
        let column = short(file.width() + 4);
        pen.put(area, column, 0, &position(state, scene), Role::Plain);
    }
}

fn title(state: &State, scene: &Scene) -> Text {
    let own = || name(scene.session.source.short_name());
    match state.second() {
        Some(compared) => text!("header-compared", own = own(), other = &compared.name),
        None => Text::from(&scene.linkage.mechanism.title),
    }
}

/// `* link.crank.points.A 100 mm -> 101 mm`: the last change of a value, the number of other changes, and whether they are valid; where
/// values were only added, the title in place of the value.
fn changed(state: &State, room: usize) -> Option<String> {
    let what = &state.draft;
    if !what.is_changed() {
        return None;
    }
    let refused = if what.reading == Reading::Refused {
        " ".to_owned() + &state.told(text!("header-not-taken"))
    } else {
        String::new()
    };
    let Some(last) = what.last() else {
        let title = state.scene.as_ref().map(|scene| state.told(title(state, scene)));
        return Some(format!("* {}{refused}", title.unwrap_or_default()));
    };
    let more = match what.changes() - 1 {
        0 => String::new(),
        others => " ".to_owned() + &state.told(text!("header-more-changes", others = number(others))),
    };
    // A table of values, such as a motor's, has no room beside its key.
    let shown = Some(format!(" {}", brief(&what.shown_value(last))))
        .filter(|shown| 2 * shown.width() <= room + KEY_ROOM);
    let value = format!("{}{more}{refused}", shown.unwrap_or_default());
    let key = values::tail(&what.values[last].key.to_string(), room.saturating_sub(value.width() + 2).max(6));
    Some(format!("* {key}{value}"))
}

/// A value with its numbers in few digits; the list of values has them in full.
fn brief(value: &str) -> String {
    let short = |word: &str| match word.parse() {
        Ok(number) if word.len() > DIGITS + 1 => trimmed(number, DIGITS),
        _ => word.to_owned(),
    };
    value.split(' ').map(short).collect::<Vec<_>>().join(" ")
}

/// `position 12 (0 to 47)  90.0000 deg`.
fn position(state: &State, scene: &Scene) -> String {
    let (unit, factor) = coordinate_unit(&scene.linkage);
    let coordinate = digits(factor * scene.coordinate(state.position), 6);
    let playing = if state.playing { " >" } else { "" };
    let [position, last] = [state.position, scene.positions().saturating_sub(1)].map(number);
    let position = state.told(match scene.time(state.position) {
        Some(time) => text!("header-instant", number = position, last = last, time),
        None => text!("header-position", number = position, last = last),
    });
    format!("{position}  {}{playing}", state.told(quantity(coordinate, unit)))
}

fn draw_tabs(pen: &mut Pen<'_>, area: Rect) {
    let language = pen.state.language();
    let tabs = View::TABS.map(|view| (pen.state.keys.first(view.command()), view));
    let whole: usize =
        tabs.iter().map(|(key, view)| key.width() + view.name().render(language).width() + 2).sum();
    // If not all fit, the names are short and there is no space between key and name.
    let fit = whole <= usize::from(area.width) + 1;
    let mut column = 0;
    for (key, view) in tabs {
        let [key_role, role] = if view == pen.state.view { [Role::Tab; 2] } else { [Role::Key, Role::Dim] };
        let key = format!("{key}{}", if fit || key.width() > 1 { " " } else { "" });
        pen.put(area, column, 1, &key, key_role);
        column += short(key.width());
        let name = if fit { view.name().render(language) } else { view.short_name(language) };
        pen.put(area, column, 1, &name, role);
        column += short(name.width()) + 1;
    }
}
