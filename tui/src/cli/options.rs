//! Options that several commands have.

use std::path::PathBuf;

use assur_analysis::{Coverage, Options};
use clap::{Args, ValueEnum};

/// Methods by name.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct MethodArgs {
    /// Force analyzer (see `assur plugins`)
    #[arg(long, value_name = "NAME")]
    pub(crate) analyzer: Option<String>,
    /// Integrator (see `assur plugins`)
    #[arg(long, value_name = "NAME")]
    pub(crate) integrator: Option<String>,
}

impl From<MethodArgs> for Options {
    fn from(MethodArgs { analyzer, integrator }: MethodArgs) -> Self {
        Self { analyzer, integrator, whole: false, least_norm: false }
    }
}

/// A scene and methods.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct SceneArgs {
    /// Scene file; `-` is standard input
    pub(crate) scene: PathBuf,
    #[command(flatten)]
    pub(crate) methods: MethodArgs,
}

/// A scene, methods, and how much is checked.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct CheckedArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Which positions are checked
    #[arg(long, value_enum, default_value_t = Checks::Sample)]
    pub(crate) checks: Checks,
    /// Give the reactions that passive links leave undetermined too: those of least norm
    #[arg(long, value_enum, value_name = "HOW")]
    pub(crate) indeterminate: Option<Indeterminate>,
}

/// How undetermined reactions are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Indeterminate {
    /// With the least sum of squares of forces, and of moments divided by the size of the mechanism
    LeastNorm,
}

/// Which positions are checked.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Checks {
    /// All up to 360; of more, 360 spread over the cycle, with the greatest values and the worst condition among them
    #[default]
    Sample,
    /// All, however many
    All,
    /// None
    None,
}

impl From<Checks> for Coverage {
    fn from(checks: Checks) -> Self {
        match checks {
            Checks::Sample => Self::Sample,
            Checks::All => Self::All,
            Checks::None => Self::None,
        }
    }
}

/// Form of results.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Tables to read
    #[default]
    Text,
    /// One JSON object, SI units, all digits
    Json,
    /// Files positions.csv, reactions.csv, trajectory.csv (those that apply) in a folder
    Csv,
}
