//! The terminal UI.

use std::path::PathBuf;

/// What the command line asks of the terminal UI.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Draw with ASCII characters only.
    pub ascii: bool,
    /// Capture the mouse.
    pub mouse: bool,
    /// Frames a second of the animation; `None`: the default.
    pub fps: Option<u8>,
    /// Force analyzer by name; `None`: the scene's.
    pub analyzer: Option<String>,
    /// Integrator by name; `None`: the scene's.
    pub integrator: Option<String>,
}

/// Why the terminal UI could not open.
#[derive(Debug, thiserror::Error)]
pub enum ScreenError {
    /// The terminal refused.
    #[error("the terminal can't be used: {0}")]
    Terminal(#[from] std::io::Error),
    /// The scene could not be read; the text is complete.
    #[error("{0}")]
    Scene(String),
}

/// Opens the terminal UI on a scene, or on the menu of shipped scenes; returns the exit status.
///
/// # Errors
///
/// [`ScreenError`] before the screen is taken: a bad scene, a terminal that refuses.
pub fn run(_path: Option<PathBuf>, _options: Options) -> Result<u8, ScreenError> {
    Ok(0)
}
