//! The table of commands, used for dispatch, hints, help screen, `:` line and configuration.

use super::{act, jump, line, modes, picker, probe, whatif, write};
use crate::screen::state::{
    Command, Effect, Group, Help, PromptKind, State, View, ViewPart, Zoom, next_kind,
};

use Group::{Change, Choose, Look, Move, Program, Views};
use View::{
    Accuracy, Checks, Curves, Drive, Forces, Mechanism, Motion, Plans, Probe, Results, Structure, Table,
    Values, Working,
};

const SCENE: &[View] = &View::TABS;
const PAGES: &[View] = &View::WITHOUT_PAGES;
const DRAWN: &[View] = &[Mechanism, Structure];
const QUANTITY: &[View] = &[Mechanism, Curves];
const PARTS: &[View] = &[Forces, Plans, Motion, Drive];
const VALUED: &[View] = &[Mechanism, Curves, Forces, Motion, Table];
/// In the mechanism this key is that of the point that is moved.
const MATCHES: &[View] =
    &[Results, Curves, Forces, Plans, Motion, Drive, Checks, Accuracy, Structure, Table, Working, Values];
const TEXTS: &[View] = &[Accuracy, Working];
const PAGED: &[View] = &[Accuracy, Working, Values];
const LINES: &[View] = &[Accuracy, Working, Drive];

const fn command(
    text: &'static str,
    group: Group,
    keys: &'static str,
    views: &'static [View],
    run: fn(&mut State),
) -> Command {
    // Its name is behind `do-`.
    Command { name: text.split_at(3).1, text, group, keys, views, run, works: |_| true }
}

/// All commands, in the order of the help screen; their texts are in the resources of `lang`.
#[rustfmt::skip]
pub(crate) const COMMANDS: &[Command] = &[
    command("do-next-position", Move, "Right l", SCENE, |s| s.step(1)),
    command("do-previous-position", Move, "Left h", SCENE, |s| s.step(-1)),
    command("do-first-position", Move, "Home", PAGES, |s| s.go_to(0)),
    command("do-last-position", Move, "End", PAGES, |s| s.go_to(s.positions() - 1)),
    command("do-forward", Move, "PgDn", PAGES, |s| act::jump(s, 1)),
    command("do-back", Move, "PgUp", PAGES, |s| act::jump(s, -1)),
    command("do-play", Move, "Space", SCENE, |s| s.playing = !s.playing),
    command("do-faster", Move, ".", SCENE, |s| act::pace(s, 1)),
    command("do-slower", Move, ",", SCENE, |s| act::pace(s, -1)),
    command("do-greatest", Move, "g", VALUED, jump::greatest),
    command("do-next-extreme", Move, "G", VALUED, jump::next_extreme),
    command("do-next-row", Move, "Down j", &[Table], |s| act::row(s, 1)),
    command("do-previous-row", Move, "Up k", &[Table], |s| act::row(s, -1)),
    command("do-go-back", Move, "C-o", &[], jump::go_back),
    command("do-pick", Choose, "p", SCENE, picker::pick),
    command("do-next-item", Choose, "Down j", QUANTITY, |s| act::quantity(s, 1)),
    command("do-previous-item", Choose, "Up k", QUANTITY, |s| act::quantity(s, -1)),
    command("do-probe", Choose, "n", &[Mechanism], probe::toggle),
    command("do-point-right", Choose, "Right", &[Probe], |s| probe::shift(s, 0, 1.0)),
    command("do-point-left", Choose, "Left", &[Probe], |s| probe::shift(s, 0, -1.0)),
    command("do-point-up", Choose, "Up", &[Probe], |s| probe::shift(s, 1, 1.0)),
    command("do-point-down", Choose, "Down", &[Probe], |s| probe::shift(s, 1, -1.0)),
    command("do-point-link", Choose, "Tab", &[Probe], probe::link),
    command("do-next-group", Choose, "Down j", &[Structure], |s| act::group(s, 1)),
    command("do-previous-group", Choose, "Up k", &[Structure], |s| act::group(s, -1)),
    command("do-nearest", Choose, "Enter", &[Structure], act::nearest),
    command("do-next-mode", Choose, "]", &[Structure], |s| modes::show(s, 1)).only(modes::are_several),
    command("do-previous-mode", Choose, "[", &[Structure], |s| modes::show(s, -1)).only(modes::are_several),
    command("do-take-mode", Change, "A", &[Structure], modes::take).only(|s| s.mode_of(s.chosen.group).is_some()),
    command("do-next-reaction", Choose, "Down j", &[Forces], |s| act::choose(s, Forces, 1)),
    command("do-previous-reaction", Choose, "Up k", &[Forces], |s| act::choose(s, Forces, -1)),
    command("do-analyzer", Choose, "f", &[Forces, Plans], act::analyzer),
    command("do-difference", Choose, "d", &[Forces], act::difference),
    command("do-causes", Choose, "b", &[Forces], |s| act::turn(s, ViewPart::Causes)).only(|s| s.has_part(ViewPart::Causes)),
    command("do-events", Choose, "b", &[Structure], |s| act::turn(s, ViewPart::Events)).only(|s| s.has_part(ViewPart::Events)),
    command("do-join", Choose, "Tab", &[Structure], act::join).only(|s| s.scene.as_ref().is_some_and(|scene| !scene.linkage.structure.groups.is_empty())),
    command("do-part", Choose, "Tab", PARTS, act::part).only(|s| s.available_parts(s.view).len() > 1),
    command("do-next-step", Choose, "Down j", &[Plans], |s| act::plan(s, 1)),
    command("do-previous-step", Choose, "Up k", &[Plans], |s| act::plan(s, -1)),
    command("do-beside", Choose, "s", &[Plans], act::beside),
    command("do-next-motion", Choose, "Down j", &[Motion], |s| act::motion(s, 1)),
    command("do-previous-motion", Choose, "Up k", &[Motion], |s| act::motion(s, -1)),
    command("do-next-check", Choose, "Down j", &[Checks], |s| act::choose(s, Checks, 1)),
    command("do-previous-check", Choose, "Up k", &[Checks], |s| act::choose(s, Checks, -1)),
    command("do-next-result", Choose, "Down j", &[Results], |s| act::choose(s, Results, 1)),
    command("do-previous-result", Choose, "Up k", &[Results], |s| act::choose(s, Results, -1)),
    command("do-result", Choose, "Enter", &[Results], jump::result),
    command("do-worst", Choose, "Enter", &[Checks], act::worst),
    command("do-measure", Choose, "b Enter", &[Accuracy], act::measure),
    command("do-next-line", Choose, "Down j", LINES, |s| act::scroll(s, 1)),
    command("do-previous-line", Choose, "Up k", LINES, |s| act::scroll(s, -1)),
    command("do-next-page", Choose, "PgDn", PAGED, |s| act::page(s, 1)),
    command("do-previous-page", Choose, "PgUp", PAGED, |s| act::page(s, -1)),
    command("do-first-line", Choose, "Home", TEXTS, |s| *s.line() = 0),
    command("do-last-line", Choose, "End", TEXTS, |s| act::scroll(s, isize::MAX)),
    command("do-next-column", Choose, "Tab >", &[Table], |s| act::choose(s, Table, 1)),
    command("do-previous-column", Choose, "S-Tab <", &[Table], |s| act::choose(s, Table, -1)),
    command("do-sort", Choose, "s", &[Table], act::sort),
    command("do-what-if", Change, "e", SCENE, whatif::toggle),
    command("do-next-value", Change, "Down j", &[Values], |s| act::choose(s, Values, 1)),
    command("do-previous-value", Change, "Up k", &[Values], |s| act::choose(s, Values, -1)),
    command("do-raise", Change, "+ =", &[Values], |s| whatif::shift(s, 1.0)),
    command("do-lower", Change, "-", &[Values], |s| whatif::shift(s, -1.0)),
    command("do-step-size", Change, "%", &[Values], whatif::step),
    command("do-exact-value", Change, "Enter", &[Values], whatif::exact),
    command("do-undo", Change, "u", SCENE, whatif::undo).only(|s| s.what_if.changes() > 0),
    command("do-save", Change, "S", SCENE, whatif::save).only(|s| s.what_if.changes() > 0),
    command("do-results", Views, "R", SCENE, |s| s.view = Results),
    command("do-mechanism", Views, "1", SCENE, |s| s.view = Mechanism),
    command("do-curves", Views, "2", SCENE, |s| s.view = Curves),
    command("do-forces", Views, "3", SCENE, |s| s.view = Forces),
    command("do-plans", Views, "4", SCENE, |s| s.view = Plans),
    command("do-motion", Views, "5", SCENE, |s| s.view = Motion),
    command("do-drive", Views, "6", SCENE, |s| s.view = Drive),
    command("do-checks", Views, "7", SCENE, |s| s.view = Checks),
    command("do-accuracy", Views, "8", SCENE, |s| s.view = Accuracy),
    command("do-structure", Views, "9", SCENE, |s| s.view = Structure),
    command("do-table", Views, "t", SCENE, |s| s.view = Table),
    command("do-working", Views, "W", SCENE, |s| s.view = Working),
    command("do-panels", Views, "P", SCENE, |s| s.panels.shown = !s.panels.shown),
    command("do-scenes", Views, "o", &[], picker::scenes),
    command("do-arrows", Look, "v", &[Mechanism], |s| s.arrows = next_kind(s.arrows)),
    command("do-trace", Look, "x", &[Mechanism], |s| s.traces = next_kind(s.traces)),
    command("do-zoom-in", Look, "+ =", DRAWN, |s| act::zoom(s, 1.25)),
    command("do-zoom-out", Look, "-", DRAWN, |s| act::zoom(s, 0.8)),
    command("do-whole", Look, "0", DRAWN, |s| s.zoom = Zoom::WHOLE),
    command("do-pan-left", Look, "H", DRAWN, |s| act::pan(s, 0, 1.0)),
    command("do-pan-right", Look, "L", DRAWN, |s| act::pan(s, 0, -1.0)),
    command("do-pan-up", Look, "K", DRAWN, |s| act::pan(s, 1, -1.0)),
    command("do-pan-down", Look, "J", DRAWN, |s| act::pan(s, 1, 1.0)),
    command("do-marker", Look, "m", &[], |s| s.look.marker = next_kind(s.look.marker)),
    command("do-pixels", Look, "I", &[], act::pixels),
    command("do-ascii", Look, "a", &[], |s| s.look.ascii = !s.look.ascii),
    command("do-theme", Look, "c", &[], act::theme),
    command("do-help", Program, "?", &[], |s| s.help = Some(Help::default())),
    command("do-command", Program, ":", &[], |s| s.open_prompt(PromptKind::Command, "")),
    command("do-search", Program, "/", SCENE, |s| s.open_prompt(PromptKind::Search, "")),
    command("do-next-match", Program, "n", MATCHES, line::search_again),
    command("do-note", Program, "N", SCENE, write::note),
    command("do-keep", Program, "", &[], |s| s.effects.push(Effect::Keep)),
    command("do-reload", Program, "r", SCENE, act::reload),
    command("do-write", Program, "w", SCENE, write::write),
    command("do-redraw", Program, "C-l", &[], |s| s.effects.push(Effect::Redraw)),
    command("do-suspend", Program, "C-z", &[], |s| s.effects.push(Effect::Suspend)),
    command("do-close", Program, "Esc C-g", &[], act::close),
    command("do-quit", Program, "q C-c", &[], whatif::quit),
];
