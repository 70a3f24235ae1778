//! The one table of commands: dispatch, last row, help screen, `:` line and configuration read it.

use crossterm::event::{KeyCode, KeyEvent};

use super::key::{Key, char, code, ctrl};
use super::state::{State, View};
use super::{accuracy, act, prompt, whatif};

/// Groups of the help screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Group {
    Move,
    Choose,
    Change,
    Views,
    Look,
    Program,
}

impl Group {
    /// In the order of the help screen.
    pub(crate) const ALL: [Self; 6] =
        [Self::Move, Self::Choose, Self::Change, Self::Views, Self::Look, Self::Program];
}

/// One thing that the user can do. Its texts are found by its name.
#[derive(Debug)]
pub(crate) struct Command {
    /// Name on the `:` line and in the configuration.
    pub(crate) name: &'static str,
    pub(crate) group: Group,
    pub(crate) keys: &'static [Key],
    /// Views in which the keys mean this; empty: all with a scene and the menu.
    pub(crate) views: &'static [View],
    /// Changes the state, draws nothing.
    pub(crate) run: fn(&mut State),
}

impl Command {
    /// Whether its keys mean this in a view.
    pub(crate) fn fits(&self, view: View) -> bool {
        self.views.is_empty() || self.views.contains(&view)
    }
}

const fn command(
    name: &'static str,
    group: Group,
    keys: &'static [Key],
    views: &'static [View],
    run: fn(&mut State),
) -> Command {
    Command { name, group, keys, views, run }
}

use Group::{Change, Choose, Look, Move, Program, Views};
use View::{
    Accuracy, Checks, Curves, Drive, Forces, Mechanism, Menu, Motion, Plans, Structure, Table, Values,
};

/// Every view of a scene.
pub(crate) const SCENE: &[View] =
    &[Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Accuracy, Structure, Table];
/// Where keys that scroll elsewhere go through the positions.
const PLACED: &[View] = &[Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Structure, Table];
const DRAWN: &[View] = &[Mechanism, Structure];

/// All commands, in the order of the help screen.
pub(crate) const COMMANDS: &[Command] = &[
    command("next-position", Move, &[code(KeyCode::Right), char('l')], SCENE, |s| s.step(1)),
    command("previous-position", Move, &[code(KeyCode::Left), char('h')], SCENE, |s| s.step(-1)),
    command("first-position", Move, &[code(KeyCode::Home)], PLACED, |s| s.position = 0),
    command("last-position", Move, &[code(KeyCode::End)], PLACED, |s| s.position = s.positions() - 1),
    command("forward", Move, &[code(KeyCode::PageDown)], PLACED, |s| act::jump(s, 1)),
    command("back", Move, &[code(KeyCode::PageUp)], PLACED, |s| act::jump(s, -1)),
    command("play", Move, &[char(' ')], SCENE, |s| s.playing = !s.playing),
    command("next-row", Move, &[code(KeyCode::Down), char('j')], &[Table], |s| act::row(s, 1)),
    command("previous-row", Move, &[code(KeyCode::Up), char('k')], &[Table], |s| act::row(s, -1)),
    command("next-item", Choose, &[code(KeyCode::Down), char('j')], &[Mechanism, Curves], |s| {
        act::item(s, 1);
    }),
    command("previous-item", Choose, &[code(KeyCode::Up), char('k')], &[Mechanism, Curves], |s| {
        act::item(s, -1);
    }),
    command("next-group", Choose, &[code(KeyCode::Down), char('j')], &[Structure], |s| act::group(s, 1)),
    command("previous-group", Choose, &[code(KeyCode::Up), char('k')], &[Structure], |s| act::group(s, -1)),
    command("nearest", Choose, &[code(KeyCode::Enter)], &[Structure], act::nearest),
    command("next-reaction", Choose, &[code(KeyCode::Down), char('j')], &[Forces], |s| act::reaction(s, 1)),
    command("previous-reaction", Choose, &[code(KeyCode::Up), char('k')], &[Forces], |s| {
        act::reaction(s, -1);
    }),
    command("analyzer", Choose, &[char('f')], &[Forces, Plans], act::analyzer),
    command("difference", Choose, &[char('d')], &[Forces], act::difference),
    command("causes", Choose, &[char('b')], &[Forces], act::causes),
    command("pane", Choose, &[code(KeyCode::Tab)], &[Forces, Motion, Drive], act::pane),
    command("next-step", Choose, &[code(KeyCode::Down), char('j')], &[Plans], |s| act::step(s, 1)),
    command("previous-step", Choose, &[code(KeyCode::Up), char('k')], &[Plans], |s| act::step(s, -1)),
    command("next-plan", Choose, &[code(KeyCode::Tab)], &[Plans], act::plan),
    command("next-motion", Choose, &[code(KeyCode::Down), char('j')], &[Motion], |s| act::motion(s, 1)),
    command("previous-motion", Choose, &[code(KeyCode::Up), char('k')], &[Motion], |s| act::motion(s, -1)),
    command("next-check", Choose, &[code(KeyCode::Down), char('j')], &[Checks], |s| act::check(s, 1)),
    command("previous-check", Choose, &[code(KeyCode::Up), char('k')], &[Checks], |s| act::check(s, -1)),
    command("worst", Choose, &[code(KeyCode::Enter)], &[Checks], act::worst),
    command("measure", Choose, &[char('b'), code(KeyCode::Enter)], &[Accuracy], accuracy::measure),
    command("next-line", Choose, &[code(KeyCode::Down), char('j')], &[Accuracy], |s| accuracy::scroll(s, 1)),
    command("previous-line", Choose, &[code(KeyCode::Up), char('k')], &[Accuracy], |s| {
        accuracy::scroll(s, -1);
    }),
    command("next-page", Choose, &[code(KeyCode::PageDown)], &[Accuracy], |s| accuracy::page(s, 1)),
    command("previous-page", Choose, &[code(KeyCode::PageUp)], &[Accuracy], |s| accuracy::page(s, -1)),
    command("first-line", Choose, &[code(KeyCode::Home)], &[Accuracy], |s| s.chosen.line = 0),
    command("last-line", Choose, &[code(KeyCode::End)], &[Accuracy], accuracy::end),
    command("next-column", Choose, &[code(KeyCode::Tab), char('>')], &[Table], |s| act::column(s, 1)),
    command("previous-column", Choose, &[code(KeyCode::BackTab), char('<')], &[Table], |s| {
        act::column(s, -1);
    }),
    command("sort", Choose, &[char('s')], &[Table], act::sort),
    command("next-scene", Choose, &[code(KeyCode::Down), char('j'), code(KeyCode::Right)], &[Menu], |s| {
        act::scene(s, 1);
    }),
    command("previous-scene", Choose, &[code(KeyCode::Up), char('k'), code(KeyCode::Left)], &[Menu], |s| {
        act::scene(s, -1);
    }),
    command("open-scene", Choose, &[code(KeyCode::Enter)], &[Menu], act::open_scene),
    command("what-if", Change, &[char('e')], SCENE, whatif::toggle),
    command("next-value", Change, &[code(KeyCode::Down), char('j')], &[Values], |s| whatif::choose(s, 1)),
    command("previous-value", Change, &[code(KeyCode::Up), char('k')], &[Values], |s| whatif::choose(s, -1)),
    command("raise", Change, &[char('+'), char('=')], &[Values], whatif::raise),
    command("lower", Change, &[char('-')], &[Values], whatif::lower),
    command("step-size", Change, &[char('%')], &[Values], whatif::step),
    command("exact-value", Change, &[code(KeyCode::Enter)], &[Values], whatif::exact),
    command("undo", Change, &[char('u')], SCENE, whatif::undo),
    command("save", Change, &[char('S')], SCENE, whatif::save),
    command("mechanism", Views, &[char('1')], SCENE, |s| s.show(Mechanism)),
    command("curves", Views, &[char('2')], SCENE, |s| s.show(Curves)),
    command("forces", Views, &[char('3')], SCENE, |s| s.show(Forces)),
    command("plans", Views, &[char('4')], SCENE, |s| s.show(Plans)),
    command("motion", Views, &[char('5')], SCENE, |s| s.show(Motion)),
    command("drive", Views, &[char('6')], SCENE, |s| s.show(Drive)),
    command("checks", Views, &[char('7')], SCENE, |s| s.show(Checks)),
    command("accuracy", Views, &[char('8')], SCENE, |s| s.show(Accuracy)),
    command("structure", Views, &[char('9')], SCENE, |s| s.show(Structure)),
    command("table", Views, &[char('t')], SCENE, |s| s.show(Table)),
    command("menu", Views, &[char('o')], SCENE, act::menu),
    command("arrows", Look, &[char('v')], &[Mechanism], act::arrows),
    command("trace", Look, &[char('x')], &[Mechanism], act::traces),
    command("zoom-in", Look, &[char('+'), char('=')], DRAWN, |s| act::zoom(s, 1.25)),
    command("zoom-out", Look, &[char('-')], DRAWN, |s| act::zoom(s, 0.8)),
    command("whole", Look, &[char('0')], DRAWN, act::whole),
    command("pan-left", Look, &[char('H')], DRAWN, |s| act::pan(s, 0, 1.0)),
    command("pan-right", Look, &[char('L')], DRAWN, |s| act::pan(s, 0, -1.0)),
    command("pan-up", Look, &[char('K')], DRAWN, |s| act::pan(s, 1, -1.0)),
    command("pan-down", Look, &[char('J')], DRAWN, |s| act::pan(s, 1, 1.0)),
    command("marker", Look, &[char('m')], &[], |s| s.look.marker = s.look.marker.next()),
    command("ascii", Look, &[char('a')], &[], |s| s.look.ascii = !s.look.ascii),
    command("theme", Look, &[char('c')], &[], act::theme),
    command("help", Program, &[char('?')], &[], act::help),
    command("command", Program, &[char(':')], &[], |s| prompt::open(s, prompt::Kind::Command)),
    command("search", Program, &[char('/')], SCENE, |s| prompt::open(s, prompt::Kind::Search)),
    command("reload", Program, &[char('r')], SCENE, act::reload),
    command("write", Program, &[char('w')], SCENE, super::writing::write),
    command("redraw", Program, &[ctrl('l')], &[], |s| s.wishes.push(super::state::Wish::Redraw)),
    command("suspend", Program, &[ctrl('z')], &[], |s| s.wishes.push(super::state::Wish::Suspend)),
    command("close", Program, &[code(KeyCode::Esc), ctrl('g')], &[], act::close),
    command("quit", Program, &[char('q'), ctrl('c')], &[], whatif::quit),
];

/// The command of a name.
pub(crate) fn named(name: &str) -> Option<&'static Command> {
    COMMANDS.iter().find(|command| command.name == name)
}

/// Gives a key to what is open: a question, the `:` line, the help, or else the view.
pub(crate) fn press(state: &mut State, event: KeyEvent) {
    let key = Key::from(event);
    let meant = state.command(key);
    let always = meant.filter(|command| key.control && command.group == Program);
    if let Some(command) = always {
        (command.run)(state);
        return;
    }
    if let Some(file) = state.question.take() {
        super::writing::answer(state, file, key);
        return;
    }
    if state.prompt.is_some() {
        prompt::press(state, key);
        return;
    }
    state.message = None;
    if state.help.is_some() {
        act::press_help(state, key);
        return;
    }
    state.fault = None;
    if let Some(command) = meant {
        (command.run)(state);
    }
}
