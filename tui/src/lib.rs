//! The program `assur`: command line and terminal UI. Nothing here calculates.
//!
//! The command line ([`cli`]) is above the terminal UI (`screen`); both are above files, locale, clock, numbers and
//! progress.

pub mod cli;

mod explained;
mod files;
mod locale;
mod progress;
mod screen;
mod session;
mod still;
mod verdict;

use std::sync::{Mutex, MutexGuard, PoisonError};

use assur_figure::number;

assur_words::resources!();

/// Locks, also after a panic of whoever held the lock: what it protects is whole at any time.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
