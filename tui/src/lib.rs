//! The program `assur`: command line and terminal UI. Nothing here calculates.
//!
//! The command line ([`cli`]) is above the terminal UI (`screen`); both are above files, locale, clock, numbers and
//! progress.

pub mod cli;

mod files;
mod locale;
mod progress;
mod screen;
mod session;
mod still;
mod verdict;

use assur_figure::number;

assur_words::resources!();
