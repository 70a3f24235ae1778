//! Taking the terminal, and restoring it on every exit.

use std::io::{self, BufWriter, Stdout, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

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

/// Name of the threads whose panics are caught and reported on the screen.
pub(crate) const WORKER: &str = "assur-work";

/// Greatest number of columns and rows that are used; the rest of a larger terminal stays empty, because a frame takes
/// memory.
const MOST: (u16, u16) = (1000, 500);

/// Size of the buffer: a whole frame fits, so a frame is one write.
const FRAME_BYTES: usize = 1 << 16;
/// How long an exit waits for the terminal.
const PATIENCE: Duration = Duration::from_millis(300);

static TAKEN: AtomicBool = AtomicBool::new(false);
static MOUSE: AtomicBool = AtomicBool::new(false);
static WRITING: Mutex<()> = Mutex::new(());

/// The terminal while the UI uses it.
pub(crate) struct Screen {
    terminal: Terminal<CrosstermBackend<BufWriter<Stdout>>>,
}

impl Screen {
    /// Takes the terminal: raw mode, alternate screen, and a panic hook that restores both.
    pub(crate) fn take(mouse: bool) -> io::Result<Self> {
        MOUSE.store(mouse, Ordering::SeqCst);
        hook_panics();
        enter()?;
        let terminal = terminal().inspect_err(|_| give_back())?;
        Ok(Self { terminal })
    }

    /// Captures the mouse, or leaves it to the terminal.
    pub(crate) fn capture_mouse(&self, mouse: bool) -> io::Result<()> {
        match (MOUSE.swap(mouse, Ordering::SeqCst), mouse) {
            (false, true) => execute!(io::stdout(), EnableMouseCapture),
            (true, false) => execute!(io::stdout(), DisableMouseCapture),
            _ => Ok(()),
        }
    }

    /// Draws one frame as one synchronized update.
    pub(crate) fn draw(&mut self, paint: impl FnOnce(&mut Frame<'_>)) -> io::Result<()> {
        let _writing = writing();
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
        let _writing = writing();
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

impl Drop for Screen {
    fn drop(&mut self) {
        give_back();
    }
}

fn terminal() -> io::Result<Terminal<CrosstermBackend<BufWriter<Stdout>>>> {
    let backend = CrosstermBackend::new(BufWriter::with_capacity(FRAME_BYTES, io::stdout()));
    Terminal::with_options(backend, TerminalOptions { viewport: Viewport::Fixed(area()?) })
}

/// Columns and rows of the terminal that are used.
pub(crate) fn size() -> io::Result<(u16, u16)> {
    let (columns, rows) = crossterm::terminal::size()?;
    Ok((columns.min(MOST.0), rows.min(MOST.1)))
}

fn area() -> io::Result<Rect> {
    size().map(|(columns, rows)| Rect::new(0, 0, columns, rows))
}

fn writing() -> MutexGuard<'static, ()> {
    WRITING.lock().unwrap_or_else(PoisonError::into_inner)
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
pub(crate) fn give_back_soon() {
    let (done, wait) = channel();
    let writer = std::thread::Builder::new().spawn(move || {
        let guard = writing();
        give_back();
        drop(guard);
        let _ = done.send(());
    });
    if writer.is_err() || wait.recv_timeout(PATIENCE).is_err() {
        // The modes of the terminal need no byte to be taken.
        let _ = disable_raw_mode();
    }
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
