//! Options that several commands have.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Methods by name.
#[derive(Debug, Clone, Args)]
pub(crate) struct MethodArgs {
    /// Force analyzer (see `assur plugins`)
    #[arg(long, value_name = "NAME")]
    pub(crate) analyzer: Option<String>,
    /// Integrator (see `assur plugins`)
    #[arg(long, value_name = "NAME")]
    pub(crate) integrator: Option<String>,
}

/// A scene and methods.
#[derive(Debug, Clone, Args)]
pub(crate) struct SceneArgs {
    /// Scene file
    pub(crate) scene: PathBuf,
    #[command(flatten)]
    pub(crate) methods: MethodArgs,
}

/// Form of results.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Tables to read
    Text,
    /// One JSON object, SI units, all digits
    Json,
    /// Files positions.csv, reactions.csv, trajectory.csv (those that apply) in a folder
    Csv,
}
