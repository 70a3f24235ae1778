//! What methods cost, how exact they are, and where they fail.
//!
//! * [`chart`]: speed against accuracy of every registered method on one scene.
//! * [`stability`]: walks towards singular positions, and how near a mechanism comes to its own.
//!
//! Reads no clock of its own: whoever asks for times hands in a [`chart::Clock`].

pub mod chart;
pub mod stability;
