//! Taking the terminal, and restoring it on every exit.

use std::io::{self, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::time::Duration;

use assur_figure::Figure;
use crossterm::cursor::Show;
use crossterm::event::{
    DisableBracketedPaste, DisableFocusChange, DisableMouseCapture, EnableBracketedPaste, EnableFocusChange,
    EnableMouseCapture,
};
use crossterm::style::ResetColor;
use crossterm::terminal::{
    BeginSynchronizedUpdate, Clear, ClearType, EndSynchronizedUpdate, EnterAlternateScreen,
    LeaveAlternateScreen, disable_raw_mode, enable_raw_mode,
};
use crossterm::{execute, queue};
use ratatui::backend::CrosstermBackend;
use ratatui::layout::Rect;
use ratatui::{Frame, Terminal, TerminalOptions, Viewport};

use super::state::State;
use super::{pixels, view};
use crate::lock;

/// Name of the threads whose panics are caught and reported on the screen.
pub(crate) const WORKER: &str = "assur-work";

/// Greatest number of columns and rows that are used; the rest of a larger terminal stays empty, because a frame takes
/// memory.
const MOST: (u16, u16) = (1000, 500);

/// Width and height of a cell, pixels, where the terminal doesn't say them.
const CELL: [f64; 2] = [10.0, 20.0];
/// How long an exit waits for the frame that is being written: long for a terminal that takes bytes, and not felt.
const PATIENCE: Duration = Duration::from_millis(40);
/// How long an exit waits for a busy machine.
const DELAY: Duration = Duration::from_millis(300);

static TAKEN: AtomicBool = AtomicBool::new(false);
/// Whether a write has failed: the terminal takes nothing more.
static LOST: AtomicBool = AtomicBool::new(false);
static MOUSE: AtomicBool = AtomicBool::new(false);
static WRITING: Mutex<()> = Mutex::new(());

/// The bytes of a frame. They go to the terminal all at once, and the lock is held for no longer: an exit does not wait
/// until a frame is painted. After the terminal was given back or has failed they are discarded, so that the libraries,
/// which print their errors where nobody can read them, see none.
#[derive(Debug, Default)]
struct FrameBuffer(Vec<u8>);

impl Write for FrameBuffer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        let bytes = std::mem::take(&mut self.0);
        let _writing = lock(&WRITING);
        if !TAKEN.load(Ordering::SeqCst) || LOST.load(Ordering::SeqCst) {
            return Ok(());
        }
        let mut out = io::stdout().lock();
        let written = out.write_all(&bytes).and_then(|()| out.flush());
        written.inspect_err(|_| LOST.store(true, Ordering::SeqCst))
    }
}

pub(crate) struct Screen {
    terminal: Terminal<CrosstermBackend<FrameBuffer>>,
    shown: Vec<(Figure, Rect)>,
}

impl Screen {
    /// Takes the terminal: raw mode, alternate screen, and a panic hook that restores both.
    pub(crate) fn take(mouse: bool) -> io::Result<Self> {
        MOUSE.store(mouse, Ordering::SeqCst);
        hook_panics();
        enter()?;
        let terminal = terminal().inspect_err(|_| give_back())?;
        Ok(Self { terminal, shown: Vec::new() })
    }

    pub(crate) fn write(&mut self, text: &str) -> io::Result<()> {
        let out = self.terminal.backend_mut();
        out.write_all(text.as_bytes())?;
        io::Write::flush(out)
    }

    /// Shows the pictures of the last frame, if they are others than before.
    pub(crate) fn show(&mut self, state: &State) -> io::Result<()> {
        if *state.shown.borrow() == self.shown {
            return Ok(());
        }
        let places = |all: &[(Figure, Rect)]| all.iter().map(|(_, area)| *area).collect::<Vec<_>>();
        if places(&state.shown.borrow()) != places(&self.shown) {
            // What was below a picture, and the picture itself.
            self.forget()?;
            self.draw(|frame| view::draw(state, frame))?;
        }
        let size = crossterm::terminal::window_size()?;
        let pixels = |pixels: u16, cells: u16, usual: f64| match (pixels, cells) {
            (0, _) | (_, 0) => usual,
            _ => f64::from(pixels) / f64::from(cells),
        };
        let cell = [pixels(size.width, size.columns, CELL[0]), pixels(size.height, size.rows, CELL[1])];
        self.shown.clone_from(&state.shown.borrow());
        self.write(&pixels::bytes(&self.shown, state.pictures, cell, state.language()))
    }

    /// Draws one frame as one synchronized update.
    pub(crate) fn draw(&mut self, paint: impl FnOnce(&mut Frame<'_>)) -> io::Result<()> {
        queue!(self.terminal.backend_mut(), BeginSynchronizedUpdate)?;
        let area = area()?;
        if self.terminal.get_frame().area() != area {
            self.terminal.resize(area)?;
        }
        self.terminal.draw(paint)?;
        queue!(self.terminal.backend_mut(), EndSynchronizedUpdate)?;
        io::Write::flush(self.terminal.backend_mut())
    }

    /// Forgets the content of the terminal, so that the next frame is written completely.
    pub(crate) fn forget(&mut self) -> io::Result<()> {
        // `Terminal::clear` queries the position of the cursor, and the answer would go to the thread that reads input.
        queue!(self.terminal.backend_mut(), Clear(ClearType::All))?;
        io::Write::flush(self.terminal.backend_mut())?;
        self.terminal = terminal()?;
        Ok(())
    }

    /// Takes the terminal again after [`give_back`], or after the process was suspended without notice.
    pub(crate) fn retake(&mut self) -> io::Result<()> {
        // Crossterm remembers that raw mode is on; leaving it first makes crossterm set it again.
        if TAKEN.load(Ordering::SeqCst) {
            disable_raw_mode()?;
        }
        enter()?;
        self.forget()
    }
}

/// Captures the mouse, or leaves it to the terminal.
pub(crate) fn capture_mouse(mouse: bool) -> io::Result<()> {
    match (MOUSE.swap(mouse, Ordering::SeqCst), mouse) {
        (false, true) => execute!(io::stdout(), EnableMouseCapture),
        (true, false) => execute!(io::stdout(), DisableMouseCapture),
        _ => Ok(()),
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        give_back();
    }
}

fn terminal() -> io::Result<Terminal<CrosstermBackend<FrameBuffer>>> {
    let backend = CrosstermBackend::new(FrameBuffer::default());
    Terminal::with_options(backend, TerminalOptions { viewport: Viewport::Fixed(area()?) })
}

pub(crate) fn size() -> io::Result<(u16, u16)> {
    let (columns, rows) = crossterm::terminal::size()?;
    Ok((columns.min(MOST.0), rows.min(MOST.1)))
}

fn area() -> io::Result<Rect> {
    size().map(|(columns, rows)| Rect::new(0, 0, columns, rows))
}

fn enter() -> io::Result<()> {
    enable_raw_mode()?;
    TAKEN.store(true, Ordering::SeqCst);
    execute!(io::stdout(), EnterAlternateScreen, EnableFocusChange, EnableBracketedPaste)?;
    if MOUSE.load(Ordering::SeqCst) {
        execute!(io::stdout(), EnableMouseCapture)?;
    }
    Ok(())
}

/// Restores the terminal; does nothing if it is not taken. Errors are ignored on exit.
pub(crate) fn give_back() {
    if !TAKEN.swap(false, Ordering::SeqCst) {
        return;
    }
    let mut out = io::stdout();
    if MOUSE.load(Ordering::SeqCst) {
        let _ = queue!(out, DisableMouseCapture);
    }
    let _ = queue!(out, EndSynchronizedUpdate, ResetColor, DisableBracketedPaste, DisableFocusChange);
    let _ = queue!(out, LeaveAlternateScreen, Show);
    let _ = out.flush();
    let _ = disable_raw_mode();
}

/// [`give_back`] from another thread: lets a frame end first, but waits for a limited time only, in case the terminal
/// takes no more bytes.
fn give_back_soon() {
    let (tell, step) = channel();
    let writer = std::thread::Builder::new().spawn(move || {
        let _ = tell.send(());
        let guard = lock(&WRITING);
        let _ = tell.send(());
        give_back();
        drop(guard);
        let _ = tell.send(());
    });
    // The thread runs, no frame is being written, all is written.
    let mut waits = [DELAY, PATIENCE, DELAY].into_iter();
    if writer.is_err() || !waits.all(|wait| step.recv_timeout(wait).is_ok()) {
        // The modes of the terminal need no byte to be taken.
        let _ = disable_raw_mode();
    }
}

/// Ends the program from another thread than that of the loop, which may be busy or blocked.
pub(crate) fn end(status: i32) -> ! {
    give_back_soon();
    crate::files::remove_temporaries();
    std::process::exit(status)
}

/// A panic restores the terminal before its message is printed; a panic of a worker is caught and shown by the UI
/// instead.
fn hook_panics() {
    let before = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        if std::thread::current().name() == Some(WORKER) {
            return;
        }
        give_back();
        before(info);
    }));
}
