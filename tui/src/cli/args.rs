//! Commands and options.

use std::path::PathBuf;

use assur_fixtures::SCENES;
use assur_words::LANGUAGES;
use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand};

use super::options::{CheckedArgs, Format, MethodArgs, SceneArgs};

/// Planar linkages by Assur groups: positions, transfer functions, reactions, with checks.
#[derive(Debug, Parser)]
#[command(name = "assur", version, max_term_width = 100)]
#[command(
    after_help = "Exit status: 0 done; 1 no assembly, no solution, or a check that fails; 2 bad scene or usage."
)]
pub(crate) struct Cli {
    /// Scene to open in the terminal UI; without a terminal, prints what `analyze` prints
    pub(crate) scene: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) methods: MethodArgs,
    /// Print no character beyond ASCII (the default where the locale is not UTF-8)
    #[arg(long, global = true)]
    pub(crate) ascii: bool,
    /// Treat warnings about the scene as errors: status 2, nothing is written
    #[arg(long, global = true)]
    pub(crate) strict: bool,
    /// Language of texts and pictures: en, uk, ru (default: as configured; in the terminal UI else that of the scene's note)
    #[arg(long, global = true, value_name = "NAME", value_parser = LANGUAGES)]
    pub(crate) language: Option<String>,
    #[command(flatten)]
    pub(crate) look: crate::screen::LookArgs,
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
}

/// What is done.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Calculate everything that a scene asks for
    Analyze(AnalyzeArgs),
    /// Run every check on a scene, one line each
    Check(CheckedArgs),
    /// Explain what is modeled, what is left out and why, and which method each stage uses
    Explain(ExplainArgs),
    /// Measure speed versus accuracy of every method that can do a scene
    Chart(super::chart::ChartArgs),
    /// Walk towards the singular positions of a scene; how near it comes to them, and how much each length may change
    Stability(super::study::StudyArgs),
    /// Measure the motion: strokes, dead points, extremes, force angles, centrodes, curvature
    Geometry(super::study::GeometryArgs),
    /// Mobility, Assur groups and class; with another link as the input too
    Structure(super::study::StructureArgs),
    /// Shaking force and moment on the ground, harmonics, and the counterweights that make the force least
    Shaking(super::study::ShakingArgs),
    /// Write the explanatory note: task, structure, plans, forces, dynamics, working, checks, with all figures
    Report(super::draw::ReportArgs),
    /// Draw the sheet: the mechanism, diagrams, plans, polygons, dynamics and results in a frame with a title block
    Sheet(super::sheet::SheetArgs),
    /// Draw a view of the terminal UI to a file: the mechanism, curves, forces, plans
    Draw(super::draw::DrawArgs),
    /// Calculate a scene over a grid of parameters, in parallel, one row for each point
    Sweep(super::sweep::SweepArgs),
    /// Write a scene with other numbers, its comments kept: values by key, or a row of a sweep
    Set(super::set::SetArgs),
    /// Make a scene of a drawing of another program: a file, or a link in quotes
    Import(super::import::ImportArgs),
    /// Search and print the reference of the keys of a scene
    Keys(super::keys::KeysArgs),
    /// List every registered group, force analyzer, integrator, catalogue and importer
    Plugins,
    /// List motors of the catalogues
    Motors(MotorArgs),
    /// Write a commented starter scene that runs
    New {
        /// File to write; must not exist. Without it, the mechanism is built on the screen
        file: Option<PathBuf>,
        /// Mechanism of the scene (default: a slider-crank compressor)
        #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(SCENES.iter().map(|(name, _)| *name)))]
        kind: Option<String>,
    },
    /// Build a shaper on the screen, step by step, with what to press
    Tour,
    /// Print the default configuration of the terminal UI, commented
    #[command(display_order = 99)]
    Config,
    /// Print a completion script for a shell
    #[command(display_order = 100)]
    Completions {
        /// Which shell
        shell: clap_complete::Shell,
    },
    /// Print the manual page
    #[command(display_order = 101)]
    Man,
}

#[derive(Debug, Clone, Default, Args)]
pub(crate) struct AnalyzeArgs {
    #[command(flatten)]
    pub(crate) checked: CheckedArgs,
    #[command(flatten)]
    pub(crate) plans: super::plans::PlanArgs,
    /// Write the rows of these positions alone, for example 0,18,30..36
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = super::plans::interval)]
    pub(crate) positions: Vec<std::ops::RangeInclusive<usize>>,
    /// Form of the results
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub(crate) format: Format,
    /// Write to this file (csv: into this folder) instead of standard output
    #[arg(short, long, value_name = "FILE_OR_FOLDER")]
    pub(crate) output: Option<PathBuf>,
}

#[derive(Debug, Clone, Args)]
pub(crate) struct ExplainArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Write the working of this position instead (of a transient motion: of this sample): every equation with its numbers, to
    /// follow by hand
    #[arg(long, value_name = "N")]
    pub(crate) position: Option<usize>,
    /// Write the energy form of the motion instead, step by step: works of the loads, kinetic energy, and the speed at the end or
    /// the flywheel
    #[arg(long, conflicts_with = "position")]
    pub(crate) energy: bool,
}

#[derive(Debug, Clone, Args)]
pub(crate) struct MotorArgs {
    /// Only this catalogue
    #[arg(long, value_name = "NAME")]
    pub(crate) catalogue: Option<String>,
    /// Least rated power, for example "1.1 kW"
    #[arg(long, value_name = "POWER")]
    pub(crate) min_power: Option<String>,
    /// Greatest rated power
    #[arg(long, value_name = "POWER")]
    pub(crate) max_power: Option<String>,
    /// Greatest synchronous speed of the rotor, for example "1500 rpm"
    #[arg(long, value_name = "SPEED")]
    pub(crate) max_speed: Option<String>,
    /// Number of poles
    #[arg(long, value_name = "N")]
    pub(crate) poles: Option<u32>,
    /// Compare the motors that suit this scene by the unevenness that each allows
    #[arg(long, value_name = "SCENE", conflicts_with_all = ["catalogue", "min_power", "max_power", "max_speed", "poles", "designation"])]
    pub(crate) advise: Option<PathBuf>,
    /// Only designations that contain this
    pub(crate) designation: Option<String>,
}
