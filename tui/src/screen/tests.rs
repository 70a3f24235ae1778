//! Frames, keys and sizes, without a terminal.

mod build;
mod compare;
pub(crate) mod courses;
mod cut;
mod drawings;
mod forces;
mod frames;
mod glossary;
#[cfg(all(target_os = "linux", target_arch = "x86_64", target_env = "gnu"))]
mod guard;
mod keys;
mod labels;
mod language;
mod lists;
mod moving;
mod note;
mod page;
mod pictures;
mod random;
mod reading;
mod running;
mod sheet;
mod sizes;
mod tasks;
mod told;
mod vectors;
mod whatif;
mod words;

use assur_all as _;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;

use super::command::{self, COMMANDS};
use super::state::{Effect, Job, Key, Keymap, Look, Scene, Source, State, View};
use super::{view, work};
use crate::session::Session;

const VIEWS: [View; 9] = [
    View::Mechanism,
    View::Curves,
    View::Forces,
    View::Plans,
    View::Motion,
    View::Drive,
    View::Checks,
    View::Structure,
    View::Table,
];

/// The state of a shipped scene, its analysis done.
pub(super) fn opened(name: &'static str) -> State {
    state_of(read(Source::Shipped(name), assur_fixtures::scene(name)).unwrap())
}

/// The state of a scene given as text, its analysis done.
fn scene(text: &str) -> State {
    state_of(read(Source::File("scene.toml".into()), text).unwrap())
}

fn read(source: Source, text: &str) -> Result<Scene, assur_words::Text> {
    Session::read(source, text.to_owned()).and_then(Scene::of)
}

fn empty(scene: Option<Scene>) -> State {
    State::new(scene, Look::default(), COMMANDS, Keymap::of(COMMANDS))
}

fn state_of(scene: Scene) -> State {
    let mut state = empty(Some(scene));
    command::start(&mut state);
    settle(&mut state);
    state.message = None;
    state
}

/// Does a job and takes all its reports.
fn run(state: &mut State, job: &Job) {
    let told = std::cell::RefCell::new(Vec::new());
    let last = work::run(job, &|report| told.borrow_mut().push(report));
    told.into_inner().into_iter().chain([last]).for_each(|report| {
        command::take(state, report);
    });
}

/// Does at once what the session would have done beside.
fn settle(state: &mut State) {
    command::prepare(state);
    while !state.effects.is_empty() {
        for effect in std::mem::take(&mut state.effects) {
            match effect {
                Effect::Work(job) => run(state, &job),
                Effect::Write(file) => command::grant(state, file),
                _ => {}
            }
        }
    }
}

fn frame(state: &State, width: u16, height: u16) -> Buffer {
    let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
    terminal.draw(|frame| view::draw(state, frame)).unwrap();
    terminal.backend().buffer().clone()
}

/// The characters of a frame, a row a line.
pub(super) fn text(state: &State, width: u16, height: u16) -> String {
    let buffer = frame(state, width, height);
    let rows = buffer.content.chunks(usize::from(width.max(1)));
    rows.map(|row| {
        row.iter().map(ratatui::buffer::Cell::symbol).collect::<String>().trim_end().to_owned() + "\n"
    })
    .collect()
}

pub(super) fn press(state: &mut State, keys: &str) {
    for name in keys.split(' ') {
        let code = Key::parse(name).unwrap();
        let mut modifiers = KeyModifiers::NONE;
        modifiers.set(KeyModifiers::CONTROL, code.control);
        modifiers.set(KeyModifiers::SHIFT, code.shift);
        command::press(state, KeyEvent::new(code.code, modifiers));
        settle(state);
    }
}

fn write(state: &mut State, line: &str) {
    for letter in line.chars() {
        command::press(state, KeyEvent::new(KeyCode::Char(letter), KeyModifiers::NONE));
    }
    command::press(state, KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
    settle(state);
}
