//! The table of commands, used for dispatch, hints, help screen, `:` line and configuration.

use super::{act, begin, build, draft, found, jump, line, modes, picker, probe, sheet, tour, write};
use crate::screen::state::{
    Command, Effect, Group, Help, PromptKind, State, View, ViewPart, Zoom, next_kind,
};

use Group::{Change, Choose, Look, Move, Program, Views};
use View::{
    Accuracy, Build, Checks, Curves, Drive, Forces, Mechanism, Motion, Plans, Probe, Results, Sheet,
    Structure, Table, Values, Working,
};

const SCENE: &[View] = &View::TABS;
/// Views in which a scene is shown or built.
const OPEN: &[View] = &View::OPEN;
const BUILD: &[View] = &[Build];
const PAGES: &[View] = &View::WITHOUT_PAGES;
const WITH_PAGES: &[View] =
    &[Results, Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Structure, Table, Build];
const DRAWN: &[View] = &[Mechanism, Structure, Build];
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
    command("do-first-position", Move, "Home", WITH_PAGES, |s| s.go_to(0)),
    command("do-last-position", Move, "End", PAGES, |s| s.go_to(s.positions() - 1)),
    command("do-forward", Move, "PgDn", PAGES, |s| act::jump(s, 1)),
    command("do-back", Move, "PgUp", PAGES, |s| act::jump(s, -1)),
    command("do-play", Move, "Space", OPEN, |s| s.playing = !s.playing),
    command("do-faster", Move, ".", OPEN, |s| act::pace(s, 1)),
    command("do-slower", Move, ",", OPEN, |s| act::pace(s, -1)),
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
    command("do-next-mode", Choose, "]", &[Structure, Build], |s| modes::show(s, 1)).only(modes::are_several),
    command("do-previous-mode", Choose, "[", &[Structure, Build], |s| modes::show(s, -1)).only(modes::are_several),
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
    command("do-next-field", Choose, "Down j", &[Sheet], |s| sheet::choose(s, 1)),
    command("do-previous-field", Choose, "Up k", &[Sheet], |s| sheet::choose(s, -1)),
    command("do-switch-field", Change, "Enter", &[Sheet], sheet::switch),
    command("do-field-down", Change, "S-Down >", &[Sheet], |s| sheet::shift(s, 1)),
    command("do-field-up", Change, "S-Up <", &[Sheet], |s| sheet::shift(s, -1)),
    command("do-next-sheet", Choose, "Tab", &[Sheet], sheet::turn),
    command("do-what-if", Change, "e", SCENE, draft::toggle),
    command("do-next-value", Change, "Down j", &[Values], |s| act::choose(s, Values, 1)),
    command("do-previous-value", Change, "Up k", &[Values], |s| act::choose(s, Values, -1)),
    command("do-raise", Change, "+ =", &[Values], |s| draft::shift(s, 1.0)),
    command("do-lower", Change, "-", &[Values], |s| draft::shift(s, -1.0)),
    command("do-step-size", Change, "%", &[Values], draft::step),
    command("do-exact-value", Change, "Enter", &[Values], draft::exact),
    command("do-undo", Change, "u", OPEN, draft::undo).only(|s| s.draft.has_steps()[0]),
    command("do-redo", Change, "C-r", OPEN, draft::redo).only(|s| s.view == Build && s.draft.has_steps()[1]),
    command("do-save", Change, "S", OPEN, draft::save).only(|s| s.draft.is_changed()),
    command("do-add-group", Change, "A", BUILD, begin::add),
    command("do-thing", Choose, "Enter", BUILD, build::enter).only(|s| s.build.chosen.is_some()),
    command("do-next-thing", Choose, "Tab", BUILD, |s| build::next(s, 1)),
    command("do-previous-thing", Choose, "S-Tab", BUILD, |s| build::next(s, -1)),
    command("do-go-right", Choose, "Right l", BUILD, |s| build::go(s, [1.0, 0.0])),
    command("do-go-left", Choose, "Left h", BUILD, |s| build::go(s, [-1.0, 0.0])),
    command("do-go-up", Choose, "Up k", BUILD, |s| build::go(s, [0.0, 1.0])),
    command("do-go-down", Choose, "Down j", BUILD, |s| build::go(s, [0.0, -1.0])),
    command("do-shift-right", Change, "S-Right", BUILD, |s| build::shift(s, [1.0, 0.0])),
    command("do-shift-left", Change, "S-Left", BUILD, |s| build::shift(s, [-1.0, 0.0])),
    command("do-shift-up", Change, "S-Up", BUILD, |s| build::shift(s, [0.0, 1.0])),
    command("do-shift-down", Change, "S-Down", BUILD, |s| build::shift(s, [0.0, -1.0])),
    command("do-grab", Change, "g", BUILD, build::grab).only(|s| s.build.chosen.is_some()),
    command("do-move-step", Change, "%", BUILD, build::step),
    command("do-turn-left", Change, "<", BUILD, |s| build::turn(s, 1.0)),
    command("do-turn-right", Change, ">", BUILD, |s| build::turn(s, -1.0)),
    command("do-rename", Change, "N", BUILD, build::rename).only(|s| s.build.chosen.is_some()),
    command("do-delete", Change, "D Del", BUILD, build::ask_delete).only(|s| s.build.chosen.is_some()),
    command("do-add-point", Change, "P", BUILD, build::add_point),
    command("do-join-elsewhere", Change, "&", BUILD, build::rejoin).only(|s| s.build.chosen.is_some()),
    command("do-tables", Change, "T", BUILD, build::tables),
    command("do-masses", Change, "b", BUILD, build::masses),
    command("do-drives", Change, "i", BUILD, begin::input),
    command("do-close-gap", Change, "C", BUILD, found::close).only(|s| s.scene.as_ref().is_some_and(|scene| !scene.broken.is_empty())),
    command("do-next-fault", Choose, "E", BUILD, found::fault).only(|s| s.build.read.as_ref().is_some_and(|read| !read.faults.is_empty() && !read.text.is_empty())),
    command("do-file-down", Choose, "PgDn", BUILD, |s| build::scroll(s, 1)),
    command("do-file-up", Choose, "PgUp", BUILD, |s| build::scroll(s, -1)),
    command("do-results", Views, "R", OPEN, |s| s.view = Results),
    command("do-mechanism", Views, "1", OPEN, |s| s.view = Mechanism),
    command("do-curves", Views, "2", OPEN, |s| s.view = Curves),
    command("do-forces", Views, "3", OPEN, |s| s.view = Forces),
    command("do-plans", Views, "4", OPEN, |s| s.view = Plans),
    command("do-motion", Views, "5", OPEN, |s| s.view = Motion),
    command("do-drive", Views, "6", OPEN, |s| s.view = Drive),
    command("do-checks", Views, "7", OPEN, |s| s.view = Checks),
    command("do-accuracy", Views, "8", OPEN, |s| s.view = Accuracy),
    command("do-structure", Views, "9", OPEN, |s| s.view = Structure),
    command("do-table", Views, "t", OPEN, |s| s.view = Table),
    command("do-working", Views, "W", OPEN, |s| s.view = Working),
    command("do-sheet", Views, "Z", OPEN, |s| s.view = Sheet),
    command("do-panels", Views, "P", SCENE, |s| s.panels.shown = !s.panels.shown),
    command("do-build", Views, "B", &[], begin::toggle),
    command("do-new", Views, "", &[], begin::new),
    command("do-tour", Views, "", &[], tour::begin),
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
    command("do-mouse", Look, "M", &[], |s| s.look.mouse = !s.look.mouse),
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
    command("do-quit", Program, "q C-c", &[], draft::quit),
];
