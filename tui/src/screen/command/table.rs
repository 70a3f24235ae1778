//! The table of commands, used for dispatch, hints, help screen, `:` line and configuration.

use super::{act, picker, probe, report, whatif, write};
use crate::screen::state::{Command, Group, Help, PromptKind, State, View, Wish, Zoom, next_kind};

use Group::{Change, Choose, Look, Move, Program, Views};
use View::{
    Accuracy, Checks, Curves, Drive, Forces, Mechanism, Motion, Plans, Probe, Structure, Table, Values,
    Working,
};

const SCENE: &[View] = &View::TABS;
const PAGES: &[View] = &View::WITHOUT_PAGES;
const DRAWN: &[View] = &[Mechanism, Structure];
const QUANTITY: &[View] = &[Mechanism, Curves];
const PARTS: &[View] = &[Forces, Plans, Motion, Drive];
const VALUED: &[View] = &[Mechanism, Curves, Forces, Motion, Table];
const TEXTS: &[View] = &[Accuracy, Working];

const fn command(
    name: &'static str,
    group: Group,
    keys: &'static str,
    views: &'static [View],
    run: fn(&mut State),
) -> Command {
    Command { name, group, keys, views, run }
}

/// All commands, in the order of the help screen; their texts are in the resources of `lang`.
#[rustfmt::skip]
pub(crate) const COMMANDS: &[Command] = &[
    command("next-position", Move, "Right l", SCENE, |s| s.step(1)),
    command("previous-position", Move, "Left h", SCENE, |s| s.step(-1)),
    command("first-position", Move, "Home", PAGES, |s| s.go_to(0)),
    command("last-position", Move, "End", PAGES, |s| s.go_to(s.positions() - 1)),
    command("forward", Move, "PgDn", PAGES, |s| act::jump(s, 1)),
    command("back", Move, "PgUp", PAGES, |s| act::jump(s, -1)),
    command("play", Move, "Space", SCENE, |s| s.playing = !s.playing),
    command("faster", Move, ".", SCENE, |s| act::pace(s, 1)),
    command("slower", Move, ",", SCENE, |s| act::pace(s, -1)),
    command("greatest", Move, "g", VALUED, |s| act::extreme(s, 1)),
    command("least", Move, "G", VALUED, |s| act::extreme(s, -1)),
    command("next-row", Move, "Down j", &[Table], |s| act::row(s, 1)),
    command("previous-row", Move, "Up k", &[Table], |s| act::row(s, -1)),
    command("pick", Choose, "p", SCENE, picker::pick),
    command("next-item", Choose, "Down j", QUANTITY, |s| act::quantity(s, 1)),
    command("previous-item", Choose, "Up k", QUANTITY, |s| act::quantity(s, -1)),
    command("probe", Choose, "n", &[Mechanism], probe::toggle),
    command("point-right", Choose, "Right", &[Probe], |s| probe::shift(s, 0, 1.0)),
    command("point-left", Choose, "Left", &[Probe], |s| probe::shift(s, 0, -1.0)),
    command("point-up", Choose, "Up", &[Probe], |s| probe::shift(s, 1, 1.0)),
    command("point-down", Choose, "Down", &[Probe], |s| probe::shift(s, 1, -1.0)),
    command("point-link", Choose, "Tab", &[Probe], probe::link),
    command("next-group", Choose, "Down j", &[Structure], |s| act::choose(s, Structure, 1)),
    command("previous-group", Choose, "Up k", &[Structure], |s| act::choose(s, Structure, -1)),
    command("nearest", Choose, "Enter", &[Structure], act::nearest),
    command("next-reaction", Choose, "Down j", &[Forces], |s| act::choose(s, Forces, 1)),
    command("previous-reaction", Choose, "Up k", &[Forces], |s| act::choose(s, Forces, -1)),
    command("analyzer", Choose, "f", &[Forces, Plans], act::analyzer),
    command("difference", Choose, "d", &[Forces], act::difference),
    command("causes", Choose, "b", &[Forces], act::causes),
    command("join", Choose, "Tab", &[Structure], act::join),
    command("part", Choose, "Tab", PARTS, act::part),
    command("next-step", Choose, "Down j", &[Plans], |s| act::plan_step(s, 1)),
    command("previous-step", Choose, "Up k", &[Plans], |s| act::plan_step(s, -1)),
    command("beside", Choose, "s", &[Plans], act::beside),
    command("next-motion", Choose, "Down j", &[Motion], |s| act::choose(s, Motion, 1)),
    command("previous-motion", Choose, "Up k", &[Motion], |s| act::choose(s, Motion, -1)),
    command("next-check", Choose, "Down j", &[Checks], |s| act::choose(s, Checks, 1)),
    command("previous-check", Choose, "Up k", &[Checks], |s| act::choose(s, Checks, -1)),
    command("worst", Choose, "Enter", &[Checks], act::worst),
    command("measure", Choose, "b Enter", &[Accuracy], report::measure),
    command("next-line", Choose, "Down j", TEXTS, |s| report::scroll(s, 1)),
    command("previous-line", Choose, "Up k", TEXTS, |s| report::scroll(s, -1)),
    command("next-page", Choose, "PgDn", TEXTS, |s| report::page(s, 1)),
    command("previous-page", Choose, "PgUp", TEXTS, |s| report::page(s, -1)),
    command("first-line", Choose, "Home", TEXTS, |s| *s.line() = 0),
    command("last-line", Choose, "End", TEXTS, |s| report::scroll(s, isize::MAX)),
    command("next-column", Choose, "Tab >", &[Table], |s| act::choose(s, Table, 1)),
    command("previous-column", Choose, "S-Tab <", &[Table], |s| act::choose(s, Table, -1)),
    command("sort", Choose, "s", &[Table], act::sort),
    command("what-if", Change, "e", SCENE, whatif::toggle),
    command("next-value", Change, "Down j", &[Values], |s| act::choose(s, Values, 1)),
    command("previous-value", Change, "Up k", &[Values], |s| act::choose(s, Values, -1)),
    command("raise", Change, "+ =", &[Values], |s| whatif::shift(s, 1.0)),
    command("lower", Change, "-", &[Values], |s| whatif::shift(s, -1.0)),
    command("step-size", Change, "%", &[Values], whatif::step),
    command("exact-value", Change, "Enter", &[Values], whatif::exact),
    command("undo", Change, "u", SCENE, whatif::undo),
    command("save", Change, "S", SCENE, whatif::save),
    command("mechanism", Views, "1", SCENE, |s| s.view = Mechanism),
    command("curves", Views, "2", SCENE, |s| s.view = Curves),
    command("forces", Views, "3", SCENE, |s| s.view = Forces),
    command("plans", Views, "4", SCENE, |s| s.view = Plans),
    command("motion", Views, "5", SCENE, |s| s.view = Motion),
    command("drive", Views, "6", SCENE, |s| s.view = Drive),
    command("checks", Views, "7", SCENE, |s| s.view = Checks),
    command("accuracy", Views, "8", SCENE, |s| s.view = Accuracy),
    command("structure", Views, "9", SCENE, |s| s.view = Structure),
    command("table", Views, "t", SCENE, |s| s.view = Table),
    command("working", Views, "W", SCENE, |s| s.view = Working),
    command("panels", Views, "P", SCENE, |s| s.panels.shown = !s.panels.shown),
    command("scenes", Views, "o", &[], picker::scenes),
    command("arrows", Look, "v", &[Mechanism], |s| s.arrows = next_kind(s.arrows)),
    command("trace", Look, "x", &[Mechanism], |s| s.traces = next_kind(s.traces)),
    command("zoom-in", Look, "+ =", DRAWN, |s| act::zoom(s, 1.25)),
    command("zoom-out", Look, "-", DRAWN, |s| act::zoom(s, 0.8)),
    command("whole", Look, "0", DRAWN, |s| s.zoom = Zoom::WHOLE),
    command("pan-left", Look, "H", DRAWN, |s| act::pan(s, 0, 1.0)),
    command("pan-right", Look, "L", DRAWN, |s| act::pan(s, 0, -1.0)),
    command("pan-up", Look, "K", DRAWN, |s| act::pan(s, 1, -1.0)),
    command("pan-down", Look, "J", DRAWN, |s| act::pan(s, 1, 1.0)),
    command("marker", Look, "m", &[], |s| s.look.marker = next_kind(s.look.marker)),
    command("pixels", Look, "I", &[], act::pixels),
    command("ascii", Look, "a", &[], |s| s.look.ascii = !s.look.ascii),
    command("theme", Look, "c", &[], act::theme),
    command("help", Program, "?", &[], |s| s.help = Some(Help::default())),
    command("command", Program, ":", &[], |s| s.open_prompt(PromptKind::Command, "")),
    command("search", Program, "/", SCENE, |s| s.open_prompt(PromptKind::Search, "")),
    command("note", Program, "N", SCENE, write::note),
    command("keep", Program, "", &[], |s| s.wishes.push(Wish::Keep)),
    command("reload", Program, "r", SCENE, act::reload),
    command("write", Program, "w", SCENE, write::write),
    command("redraw", Program, "C-l", &[], |s| s.wishes.push(Wish::Redraw)),
    command("suspend", Program, "C-z", &[], |s| s.wishes.push(Wish::Suspend)),
    command("close", Program, "Esc C-g", &[], act::close),
    command("quit", Program, "q C-c", &[], whatif::quit),
];
