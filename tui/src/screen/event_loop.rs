//! The loop: applies what has come, a limited time long, then draws once.

#[cfg(test)]
mod tests;

use std::io::{self, IsTerminal};
use std::path::Path;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use assur_words::text;
use crossterm::event::{Event as Own, KeyEventKind};
use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGWINCH};
use signal_hook::iterator::Signals;

use super::inbox::{Event, Inbox};
use super::input::Input;
use super::pixels::{self, Answer};
use super::recovery::Recovery;
use super::state::{Effect, Pictures, Role, State};
use super::terminal::{self, Screen};
use super::workers::Workers;
use super::{command, config, input, view};

/// A terminal that has not answered after this time shows no pictures.
const ANSWER: Duration = Duration::from_secs(1);
/// While more events come, a frame is drawn after this time: it shows that something happens, and most of the time is
/// still left for the events.
const FRAME: Duration = Duration::from_millis(40);
/// The exit status of a program whose terminal has died: that of one that is ended by SIGHUP.
const DIED: u8 = 129;

/// Runs until the user leaves, and returns the exit status; `config`: where its configuration is kept.
pub(crate) fn run(state: State, config: Option<&Path>, recovery: Option<Recovery>) -> io::Result<u8> {
    let inbox = Inbox::new(state.keys.everywhere("quit"), || terminal::end(0));
    listen_to_signals(Arc::clone(&inbox))?;
    let mut screen = Screen::take(state.look.mouse)?;
    let keys = Arc::clone(&inbox);
    input::listen(move |inputs| keys.take(inputs))?;
    let ended = EventLoop { recovery, ..EventLoop::new(state, inbox) }.play(&mut screen, config);
    // Every call fails on a terminal that has died, and nothing can be said there.
    let died = !(io::stdin().is_terminal() && io::stdout().is_terminal());
    if ended.is_err() && died { Ok(DIED) } else { ended }
}

struct EventLoop {
    state: State,
    inbox: Arc<Inbox>,
    workers: Workers,
    next_tick: Instant,
    /// When the last frame was drawn, and whether the next one differs.
    drawn: Instant,
    stale: bool,
    /// Whether the input has ended: the terminal has died.
    ended: bool,
    /// Where unsaved changes are kept.
    recovery: Option<Recovery>,
}

impl EventLoop {
    fn new(state: State, inbox: Arc<Inbox>) -> Self {
        let reports = Arc::clone(&inbox);
        let workers = Workers::new(move |report| reports.send(Event::Work(report)));
        let now = Instant::now();
        Self { state, inbox, workers, next_tick: now, drawn: now, stale: true, ended: false, recovery: None }
    }

    fn play(&mut self, screen: &mut Screen, config: Option<&Path>) -> io::Result<u8> {
        let start = (self.state.look, self.state.panels.clone());
        loop {
            for effect in std::mem::take(&mut self.state.effects) {
                if matches!(effect, Effect::Keep) {
                    config::keep(&mut self.state, config, &start);
                } else {
                    self.grant(effect, screen)?;
                }
                // What an effect leads to is seen: a message, a question, another terminal.
                self.stale = true;
            }
            if self.ended {
                return Ok(DIED);
            }
            if self.state.leaving {
                self.recovery.iter_mut().for_each(Recovery::remove);
                return Ok(0);
            }
            self.ask_for_pictures(screen)?;
            if self.stale && (self.inbox.is_empty() || self.drawn.elapsed() >= FRAME) {
                self.draw(screen)?;
            }
            self.apply_what_waits();
        }
    }

    fn draw(&mut self, screen: &mut Screen) -> io::Result<()> {
        terminal::capture_mouse(self.state.look.mouse)?;
        let dropped = self.inbox.dropped();
        if dropped > 0 && self.state.message.is_none() {
            self.state.say(Role::Bad, text!("say-keys-dropped", count = dropped));
        }
        command::prepare(&mut self.state);
        self.recovery.iter_mut().for_each(|recovery| recovery.keep(&self.state.draft));
        let state = &self.state;
        screen.draw(|frame| view::draw(state, frame))?;
        screen.show(state)?;
        self.inbox.answered();
        (self.stale, self.drawn) = (false, Instant::now());
        Ok(())
    }

    /// Applies what has come until something is to be done outside the state, or a frame is due; waits for the first
    /// event only if the present frame is shown.
    fn apply_what_waits(&mut self) {
        let start = Instant::now();
        let mut next = if self.stale || !self.state.effects.is_empty() {
            self.inbox.try_next()
        } else {
            let until = self.state.animates().then_some(self.next_tick);
            let event = self.inbox.next(until);
            if event.is_none() {
                self.next_tick =
                    Instant::now() + Duration::from_secs(1) / u32::from(self.state.look.fps.max(1));
                self.state.advance();
                self.stale = true;
            }
            event
        };
        while let Some(event) = next {
            self.stale |= self.apply(event);
            self.inbox.set_free(self.state.draft.may_drop());
            let is_due = start.elapsed() >= FRAME;
            if is_due || self.state.leaving || !self.state.effects.is_empty() {
                return;
            }
            next = self.inbox.try_next();
        }
    }

    fn ask_for_pictures(&mut self, screen: &mut Screen) -> io::Result<()> {
        if self.state.look.pixels && self.state.pictures == Pictures::Unknown {
            self.state.pictures = Pictures::Asked;
            screen.write(pixels::QUESTION)?;
            let inbox = Arc::clone(&self.inbox);
            thread::spawn(move || {
                thread::sleep(ANSWER);
                inbox.send(Event::Input(Input::Answer(Answer::End)));
            });
        }
        Ok(())
    }

    /// Applies an event; returns whether the frame may differ.
    fn apply(&mut self, event: Event) -> bool {
        let state = &mut self.state;
        match event {
            Event::Input(Input::Event(Own::Key(key))) if key.kind != KeyEventKind::Release => {
                #[cfg(debug_assertions)]
                assert!(
                    std::env::var_os("ASSUR_PANIC_ON_KEY").is_none(),
                    "a panic on request (ASSUR_PANIC_ON_KEY)"
                );
                command::press(state, key);
            }
            Event::Input(Input::Event(Own::Paste(text))) => command::paste(state, &text),
            Event::Input(Input::Event(Own::Mouse(mouse))) => return command::click(state, mouse),
            Event::Resized => state.size = terminal::size().unwrap_or(state.size),
            Event::Input(Input::Event(Own::FocusGained)) => {
                return !std::mem::replace(&mut state.focused, true);
            }
            Event::Input(Input::Event(Own::FocusLost)) => {
                state.focused = false;
                return false;
            }
            Event::Input(Input::Event(_)) => return false,
            Event::Input(Input::Answer(answer)) => return take_answer(state, answer),
            Event::Input(Input::End) => (state.leaving, self.ended) = (true, true),
            Event::Work(report) => return command::take(state, report),
            Event::Effect(effect) => state.effects.push(effect),
        }
        true
    }

    /// Performs the actions that a command requested because the state can't do them.
    fn grant(&mut self, effect: Effect, screen: &mut Screen) -> io::Result<()> {
        match effect {
            Effect::Quit => self.state.leaving = true,
            Effect::Redraw => screen.forget()?,
            Effect::Retake => screen.retake()?,
            Effect::Suspend => {
                terminal::give_back();
                signal_hook::low_level::emulate_default_handler(SIGTSTP)?;
                screen.retake()?;
            }
            Effect::Work(job) => self.workers.start(job),
            Effect::Write(file) => command::grant(&mut self.state, file),
            Effect::Keep => {}
        }
        Ok(())
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
        state.say(Role::Bad, text!("say-no-pixels"));
    }
    true
}

/// A thread that ends the program when a signal says so, and passes the other signals on.
fn listen_to_signals(inbox: Arc<Inbox>) -> io::Result<()> {
    let mut signals = Signals::new([SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGTSTP, SIGCONT, SIGWINCH])?;
    thread::Builder::new().name("assur-signals".into()).spawn(move || {
        for signal in signals.forever() {
            match signal {
                SIGTSTP => inbox.send(Event::Effect(Effect::Suspend)),
                SIGCONT => inbox.send(Event::Effect(Effect::Retake)),
                SIGWINCH => inbox.send(Event::Resized),
                _ => terminal::end(128 + signal),
            }
        }
    })?;
    Ok(())
}
