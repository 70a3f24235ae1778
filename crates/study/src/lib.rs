//! Cost, accuracy and failures of methods.
//!
//! * [`chart`]: speed versus accuracy of every registered method on one scene.
//! * [`stability`]: errors of methods near singular positions, and how near a mechanism comes to its own.
//!
//! Reads no clock of its own: a caller that wants times passes one to [`chart::chart`].

pub mod chart;
pub mod stability;

assur_words::resources!();
