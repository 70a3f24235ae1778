//! The loop: waits for an event, applies it and all that are queued, draws once.

use std::io;
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::{Duration, Instant};

use crossterm::event::{Event as Own, KeyEventKind};
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH};
use signal_hook::iterator::Signals;

use super::input::Input;
use super::pixels::{self, Answer};
use super::state::{Pictures, Report, Role, State, Wish};
use super::terminal::{self, Screen};
use super::{command, config, input, view, work};

/// A terminal that has not answered after this time shows no pictures.
const ANSWER: Duration = Duration::from_secs(1);

/// The events that wake the loop.
#[derive(Debug)]
pub(crate) enum Event {
    /// A key, the mouse, the focus, an answer of the terminal, the end of input.
    Input(Input),
    /// The terminal has changed its size.
    Resized,
    /// The worker has a report.
    Work(Report),
    /// A signal asks for something.
    Wish(Wish),
}

/// Runs until the user leaves; `config`: where its configuration is kept.
pub(crate) fn run(mut state: State, config: Option<&Path>) -> io::Result<()> {
    let start = (state.look, state.panels.clone());
    let (sender, events) = channel();
    listen_to_signals(sender.clone())?;
    let mut screen = Screen::take(state.look.mouse)?;
    let keys = sender.clone();
    input::listen(move |input| keys.send(Event::Input(input)).is_ok())?;
    let mut next_tick = Instant::now();
    loop {
        for wish in std::mem::take(&mut state.wishes) {
            if matches!(wish, Wish::Keep) {
                config::keep(&mut state, config, &start);
            } else {
                grant(wish, &mut state, &mut screen, &sender)?;
            }
        }
        if state.leaving {
            return Ok(());
        }
        terminal::capture_mouse(state.look.mouse)?;
        if state.look.pixels && state.pictures == Pictures::Unknown {
            state.pictures = Pictures::Asked;
            screen.write(pixels::QUESTION)?;
            let sender = sender.clone();
            thread::spawn(move || {
                thread::sleep(ANSWER);
                // If the receiver is gone, the program is ending.
                drop(sender.send(Event::Input(Input::Answer(Answer::End))));
            });
        }
        if state.wishes.is_empty() {
            screen.draw(|frame| view::draw(&state, frame))?;
            screen.show(&state)?;
        }
        if !wait(&mut state, &events, &mut next_tick) {
            return Ok(());
        }
    }
}

/// Blocks until an event has changed the state; `false` when no more events can come.
fn wait(state: &mut State, events: &Receiver<Event>, next_tick: &mut Instant) -> bool {
    loop {
        if !state.wishes.is_empty() {
            return true;
        }
        let first = if state.animates() {
            match events.recv_timeout(next_tick.saturating_duration_since(Instant::now())) {
                Ok(event) => event,
                Err(RecvTimeoutError::Timeout) => {
                    *next_tick = Instant::now() + Duration::from_secs(1) / u32::from(state.look.fps.max(1));
                    state.advance();
                    return true;
                }
                Err(RecvTimeoutError::Disconnected) => return false,
            }
        } else {
            match events.recv() {
                Ok(event) => event,
                Err(_) => return false,
            }
        };
        let mut changed = apply(state, first);
        while let Ok(event) = events.try_recv() {
            changed |= apply(state, event);
        }
        if changed || state.leaving {
            return true;
        }
    }
}

/// Applies one event; returns whether the frame may differ.
fn apply(state: &mut State, event: Event) -> bool {
    match event {
        Event::Input(Input::Event(Own::Key(key))) if key.kind != KeyEventKind::Release => {
            #[cfg(debug_assertions)]
            assert!(
                std::env::var_os("ASSUR_PANIC_ON_KEY").is_none(),
                "a panic on request (ASSUR_PANIC_ON_KEY)"
            );
            command::press(state, key);
            true
        }
        Event::Input(Input::Event(Own::Paste(text))) => {
            command::paste(state, &text);
            true
        }
        Event::Input(Input::Event(Own::Mouse(mouse))) => command::click(state, mouse),
        Event::Resized => {
            state.size = terminal::size().unwrap_or(state.size);
            true
        }
        Event::Input(Input::Event(Own::FocusGained)) => {
            std::mem::replace(&mut state.focused, true) != state.focused
        }
        Event::Input(Input::Event(Own::FocusLost)) => {
            state.focused = false;
            false
        }
        Event::Input(Input::Event(_)) => false,
        Event::Input(Input::Answer(answer)) => take_answer(state, answer),
        Event::Input(Input::End) => {
            state.leaving = true;
            true
        }
        Event::Work(report) => command::take(state, report),
        Event::Wish(wish) => {
            state.wishes.push(wish);
            true
        }
    }
}

/// Takes an answer to the question for pictures; the first one that says how counts.
fn take_answer(state: &mut State, answer: Answer) -> bool {
    if state.pictures != Pictures::Asked {
        return false;
    }
    if let Answer::Takes(way) = answer {
        state.pictures = way;
    } else {
        (state.pictures, state.look.pixels) = (Pictures::None, false);
        state.say(Role::Bad, "this terminal does not say that it shows pictures (kitty, iTerm2): no pixels");
    }
    true
}

/// Performs the actions that a command requested because the state can't do them.
fn grant(wish: Wish, state: &mut State, screen: &mut Screen, sender: &Sender<Event>) -> io::Result<()> {
    match wish {
        Wish::Quit => state.leaving = true,
        Wish::Redraw => screen.forget()?,
        Wish::Retake => screen.retake()?,
        Wish::Suspend => {
            terminal::give_back();
            signal_hook::low_level::emulate_default_handler(SIGTSTP)?;
            screen.retake()?;
        }
        Wish::Work(job) => {
            let sender = sender.clone();
            // If the receiver is gone, the program is ending.
            work::start(job, move |report| drop(sender.send(Event::Work(report))));
        }
        Wish::Write(file) => command::grant(state, file),
        Wish::Keep => {}
    }
    Ok(())
}

/// A thread that ends the program when a signal says so, and passes the other signals on.
fn listen_to_signals(sender: Sender<Event>) -> io::Result<()> {
    let mut signals = Signals::new([SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGCONT, SIGWINCH])?;
    thread::Builder::new().name("assur-signals".into()).spawn(move || {
        for signal in signals.forever() {
            let sent = match signal {
                SIGTSTP => sender.send(Event::Wish(Wish::Suspend)),
                SIGCONT => sender.send(Event::Wish(Wish::Retake)),
                SIGWINCH => sender.send(Event::Resized),
                _ => {
                    terminal::give_back_soon();
                    crate::files::remove_temporaries();
                    std::process::exit(128 + signal);
                }
            };
            if sent.is_err() {
                return;
            }
        }
    })?;
    Ok(())
}
