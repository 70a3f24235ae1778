//! The program `assur`: command line and terminal UI. Nothing here calculates.

pub mod cli;
pub mod screen;

mod locale;
