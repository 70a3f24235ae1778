//! Frames, keys and sizes, without a terminal.

mod compare;
mod forces;
mod frames;
mod keys;
mod language;
mod reading;
mod running;
mod sizes;
mod whatif;
mod words;

use assur_all as _;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;

use super::state::{Look, State, View, Wish};
use super::study::{Source, Study};
use super::{command, view, work, writing};

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
fn opened(name: &'static str) -> State {
    let text = super::menu::SCENES.iter().find(|scene| scene.0 == name).unwrap().1;
    state_of(Study::read(Source::Shipped(name), text).unwrap())
}

/// The state of a scene given as text, its analysis done.
fn scene(text: &str) -> State {
    state_of(Study::read(Source::File("scene.toml".into()), text).unwrap())
}

fn state_of(study: Study) -> State {
    let mut state = State::new(Some(study), Look::default());
    state.analyze(false);
    settle(&mut state);
    state.message = None;
    state
}

/// Does a job and takes all its reports.
fn run(state: &mut State, job: &work::Job) {
    let told = std::cell::RefCell::new(Vec::new());
    let last = work::run(job, &|report| told.borrow_mut().push(report));
    told.into_inner().into_iter().chain([last]).for_each(|report| {
        state.take_report(report);
    });
}

/// Does at once what the session would have done beside.
fn settle(state: &mut State) {
    while !state.wishes.is_empty() {
        for wish in std::mem::take(&mut state.wishes) {
            match wish {
                Wish::Work(job) => run(state, &job),
                Wish::Write(file) => writing::grant(state, file),
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
fn text(state: &State, width: u16, height: u16) -> String {
    let buffer = frame(state, width, height);
    let rows = buffer.content.chunks(usize::from(width.max(1)));
    rows.map(|row| {
        row.iter().map(ratatui::buffer::Cell::symbol).collect::<String>().trim_end().to_owned() + "\n"
    })
    .collect()
}

fn press(state: &mut State, keys: &str) {
    for name in keys.split(' ') {
        let code = super::key::Key::parse(name).unwrap();
        let modifiers = if code.control { KeyModifiers::CONTROL } else { KeyModifiers::NONE };
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
