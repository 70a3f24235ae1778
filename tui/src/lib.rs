//! The program `assur`: command line and terminal UI. Nothing here calculates.
//!
//! The command line ([`cli`]) lies above the terminal UI ([`screen`]); both lie above files, locale, clock, numbers and progress.

pub mod cli;
pub mod screen;

mod clock;
mod files;
mod locale;
mod number;
mod progress;
