//! What waits for the loop: reports of the worker, signals, and the input, of which more may come than anyone types.
//!
//! A key that ends the program is not behind the keys before it: it comes first, and they are discarded, as a terminal
//! does it for an interrupt. If the loop takes no notice, being busy or blocked by a terminal that takes no bytes, the
//! program is ended beside it.

#[cfg(test)]
mod tests;

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crossterm::event::{Event as Own, KeyEventKind};

use super::input::Input;
use super::state::{Effect, Key, Report};
use crate::lock;

/// Greatest number of inputs that wait: of a held key those of a quarter of a minute. Of more, the oldest are dropped,
/// so that the last one, which answers what is seen, is never far behind.
const MOST: usize = 500;
/// How long the loop may take to answer a key that ends the program. With what restoring the terminal may take, it stays
/// below the tenth of a second that is felt as a delay.
const PATIENCE: Duration = Duration::from_millis(30);

#[derive(Debug)]
pub(crate) enum Event {
    /// A key, the mouse, the focus, an answer of the terminal, the end of input.
    Input(Input),
    Resized,
    Work(Report),
    /// A signal asks for something.
    Effect(Effect),
}

impl Event {
    /// Whether there may be any number of it, so that some may be lost.
    fn is_typed(&self) -> bool {
        matches!(self, Self::Input(input) if !matches!(input, Input::End))
    }
}

#[derive(Debug, Default)]
struct Waiting {
    events: VecDeque<Event>,
    typed: usize,
    /// How many were dropped and not reported yet.
    dropped: usize,
}

impl Waiting {
    fn push(&mut self, event: Event) {
        if event.is_typed() {
            if self.typed == MOST {
                let oldest = self.events.iter().position(Event::is_typed);
                oldest.map(|oldest| self.events.remove(oldest));
                self.dropped += 1;
            } else {
                self.typed += 1;
            }
        }
        self.events.push_back(event);
    }

    /// Adds an input as the first one, and discards all others but those that came the same way.
    fn overtake(&mut self, event: Event, same: impl Fn(&Event) -> bool) {
        self.events.retain(|event| !event.is_typed() || same(event));
        self.dropped = 0;
        self.typed = self.events.iter().filter(|event| event.is_typed()).count();
        if self.typed < MOST {
            self.typed += 1;
            self.events.push_front(event);
        }
    }

    fn pop(&mut self) -> Option<Event> {
        let event = self.events.pop_front()?;
        self.typed -= usize::from(event.is_typed());
        Some(event)
    }
}

pub(crate) struct Inbox {
    waiting: Mutex<Waiting>,
    came: Condvar,
    ends: Vec<Key>,
    /// Ends the program beside the loop.
    end: Box<dyn Fn() + Send + Sync>,
    /// How often the end was asked for since the loop has last answered.
    asked: AtomicUsize,
    /// Whether the end needs no warning first.
    free: AtomicBool,
}

impl Inbox {
    /// An empty one; `ends`: the keys that end the program whatever is open, `end`: ends it beside the loop.
    pub(crate) fn new(ends: Vec<Key>, end: impl Fn() + Send + Sync + 'static) -> Arc<Self> {
        let (waiting, came) = (Mutex::default(), Condvar::new());
        let (asked, free) = (AtomicUsize::new(0), AtomicBool::new(true));
        Arc::new(Self { waiting, came, ends, end: Box::new(end), asked, free })
    }

    pub(crate) fn send(&self, event: Event) {
        lock(&self.waiting).push(event);
        self.came.notify_one();
    }

    pub(crate) fn take(self: &Arc<Self>, inputs: impl Iterator<Item = Input>) {
        let mut waiting = lock(&self.waiting);
        let mut asked = 0;
        for event in inputs.map(Event::Input) {
            if self.ends_program(&event) {
                asked += 1;
                waiting.overtake(event, |event| self.ends_program(event));
            } else {
                waiting.push(event);
            }
        }
        drop(waiting);
        self.came.notify_one();
        if asked > 0 && self.asked.fetch_add(asked, Ordering::SeqCst) == 0 {
            self.watch();
        }
    }

    /// The next event, waited for until a time; `None`: it has come.
    pub(crate) fn next(&self, until: Option<Instant>) -> Option<Event> {
        let mut waiting = lock(&self.waiting);
        loop {
            if let Some(event) = waiting.pop() {
                return Some(event);
            }
            waiting = match until.map(|until| until.saturating_duration_since(Instant::now())) {
                Some(Duration::ZERO) => return None,
                Some(rest) => self.came.wait_timeout(waiting, rest).unwrap_or_else(PoisonError::into_inner).0,
                None => self.came.wait(waiting).unwrap_or_else(PoisonError::into_inner),
            };
        }
    }

    pub(crate) fn try_next(&self) -> Option<Event> {
        lock(&self.waiting).pop()
    }

    pub(crate) fn is_empty(&self) -> bool {
        lock(&self.waiting).events.is_empty()
    }

    pub(crate) fn dropped(&self) -> usize {
        std::mem::take(&mut lock(&self.waiting).dropped)
    }

    /// The loop has shown what follows from all that it has taken.
    pub(crate) fn answered(&self) {
        let waiting = lock(&self.waiting);
        let open = waiting.events.iter().filter(|event| self.ends_program(event)).count();
        self.asked.store(open, Ordering::SeqCst);
    }

    pub(crate) fn set_free(&self, free: bool) {
        self.free.store(free, Ordering::SeqCst);
    }

    fn ends_program(&self, event: &Event) -> bool {
        let Event::Input(Input::Event(Own::Key(key))) = event else { return false };
        key.kind != KeyEventKind::Release && self.ends.contains(&Key::from(*key))
    }

    /// Ends the program if the loop does not answer: at once where no warning is due, else when asked once more.
    fn watch(self: &Arc<Self>) {
        let inbox = Arc::clone(self);
        let watch = move || {
            loop {
                thread::sleep(PATIENCE);
                let asked = inbox.asked.load(Ordering::SeqCst);
                if asked == 0 {
                    return;
                }
                if asked > 1 || inbox.free.load(Ordering::SeqCst) {
                    return (inbox.end)();
                }
            }
        };
        // Without a thread the loop answers alone.
        drop(thread::Builder::new().name("assur-watch".into()).spawn(watch));
    }
}
