//! The whole result.

use assur_check::Check;
use assur_diagram::{Enveloping, Hodograph, PlanSheet, ReactionExtreme, SignChange};
use assur_integrator::{Event, SolutionCost, State};
use assur_mechanism::{CoordinateKind, Key, LinkId, Name, Named, PairId, SlideId, Warning};
use assur_words::{Text, text};
use indexmap::IndexMap;
use serde::{Serialize, Serializer};

use super::Owner;
use crate::results::{Dynamics, Peaks, Starts, StructureReport, Survey, Table};
use crate::{friction::FrictionCycle, several::Several};

/// All results of one calculation of a scene. What doesn't apply is absent or empty.
///
/// They are the JSON of an analysis; into the empty lists of its tables a writer puts their rows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Analysis {
    /// Title of the scene; may be empty.
    pub title: Name,
    /// The input link and its coordinate.
    pub input: InputReport,
    /// Mobility, groups, formula.
    pub structure: StructureReport,
    /// Positions that exist, in order, each with its number: all, or of very many every so many.
    #[serde(serialize_with = "without_rows")]
    pub positions: Table,
    /// What is known about all positions.
    #[serde(skip)]
    pub survey: Survey,
    /// Values of greatest magnitude, between the positions too; without any where these were not looked for.
    #[serde(skip)]
    pub peaks: Peaks,
    /// What lets single blocks of positions be calculated again.
    #[serde(skip)]
    pub starts: Starts,
    /// Positions that have no solution.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub failures: Vec<Failure>,
    /// Transient and steady motion: samples over time.
    #[serde(skip_serializing_if = "Table::is_empty", serialize_with = "without_rows")]
    pub trajectory: Table,
    /// Periodic regime, drive, flywheel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dynamics: Option<Dynamics>,
    /// How a transient motion was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub integration: Option<Integration>,
    /// Why the requested motion is not found; results that do not depend on it are given nevertheless.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub no_motion: Option<Text>,
    /// Dry friction over the cycle; `None` without.
    #[serde(flatten)]
    pub friction: Option<FrictionCycle>,
    /// What in the scene is probably not meant, what had to be left out, and what was decided during the calculation.
    #[serde(rename = "notes", skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Warning>,
    /// Positions in which friction has several solutions, or may have others.
    #[serde(skip)]
    pub several: Vec<Several>,
    /// Reactions over the cycle, contacts, plans.
    #[serde(flatten)]
    pub cycle: Cycle,
    /// Checks of the numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<Check>,
    /// Residuals of the checked positions, which [`positions`](Self::positions) have as well.
    #[serde(skip)]
    pub residuals: Table,
}

/// An empty list in the place of the rows of a table.
fn without_rows<S: Serializer>(_: &Table, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq([(); 0])
}

impl Analysis {
    /// Whether all positions are kept.
    pub fn is_complete(&self) -> bool {
        self.positions.len() == self.survey.rows
    }

    /// Adds the checks to the results, and the residuals to the rows of the positions and samples that were checked.
    pub fn add_checks(&mut self, checks: Checks) {
        let Checks { all, of_positions, of_trajectory } = checks;
        self.checks = all;
        self.survey.join(&self.positions, &of_positions);
        self.positions.join(&of_positions);
        self.trajectory.join(&of_trajectory);
        self.residuals = of_positions;
    }
}

/// The input link and its coordinate.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct InputReport {
    /// The link that is driven.
    pub link: Named<LinkId>,
    /// The pair in which it is driven against another moving link; `None` where it is driven against the ground.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pair: Option<Named<PairId>>,
    /// Whether the coordinate of the drive is an angle (rad); otherwise a displacement (m), or, of several drives, the time (s).
    pub angular: bool,
    /// What the coordinate is.
    #[serde(skip)]
    pub kind: CoordinateKind,
    /// Whether the balancing load is a moment (N m), otherwise a force (N).
    pub balancing_is_moment: bool,
}

impl InputReport {
    /// What the coordinate is of: the link, or the pair between two moving links.
    pub fn name(&self) -> &Name {
        self.pair.as_ref().map_or(&self.link.name, |pair| &pair.name)
    }
}

/// A position that has no solution, or only a part of one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Failure {
    /// Number of the position.
    pub index: usize,
    /// Its coordinate, rad or m.
    pub coordinate: f64,
    /// What is missing, where and by how much.
    pub message: Text,
    /// The key of the scene that is at fault, where there is one.
    #[serde(skip)]
    pub key: Option<Key>,
    /// Where it jams by friction: the upper end of the interval from 0 of the factors of all coefficients for which there is a
    /// solution.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<f64>,
}

/// Reactions over the cycle, geometry of the contacts, plans of the requested positions. Sections that don't apply are
/// absent.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Cycle {
    /// Greatest magnitude and root mean square of each reaction.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reaction_extremes: Vec<ReactionExtreme>,
    /// By slide that carries a force: where the force changes the side of the guide. A slide without a change has an
    /// empty list.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub sign_changes: IndexMap<Named<SlideId>, Vec<SignChange>>,
    /// The straight line that the arc of each contact envelopes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub enveloping: Vec<Enveloping>,
    /// Polar diagrams of the reactions, if requested.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hodographs: Vec<Hodograph>,
    /// The plans of the requested positions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub plans: Vec<PositionPlans>,
}

/// The plans of one position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PositionPlans {
    /// Number of the position.
    pub index: usize,
    /// All plans.
    #[serde(flatten)]
    pub sheet: PlanSheet,
}

/// How a transient motion was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Integration {
    /// Name of the integrator.
    pub method: String,
    /// D's case of the equation, 1 to 5 (D 3.21).
    pub case: u8,
    /// What inertia and moment depend on: `J(q), M(q, w)`.
    pub equation: Text,
    /// Why this integrator.
    pub reason: Text,
    /// Requested relative tolerance.
    pub tolerance: f64,
    /// Cost of the solution.
    #[serde(flatten)]
    pub statistics: SolutionCost,
    /// The state in which the motion ended.
    pub end: State,
    /// Turns of the input from the start to the end, positive along the growing coordinate; absent where it slides.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turns: Option<f64>,
    /// What happened between, in order of time.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<Event>,
    /// Energies at both ends.
    pub energy: Energy,
}

/// The balance of energy over a motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Energy {
    /// Whether nothing but weights and springs acts, so that the sum of energies must be constant.
    pub conservative: bool,
    /// Kinetic energy at the start, flywheel and rotor included, J.
    pub kinetic_start: f64,
    /// Kinetic energy at the end, flywheel and rotor included, J.
    pub kinetic_end: f64,
    /// Potential energy of weights and springs at the start, J.
    pub potential_start: f64,
    /// Potential energy of weights and springs at the end, J.
    pub potential_end: f64,
    /// Largest change of the sum of kinetic and potential energy, divided by the largest kinetic energy: the drift of
    /// the solution where the machine is conservative, else the work of the other loads.
    pub change: f64,
}

/// What a residual of one position compares; but for the remainder relative to the size of what is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Residual {
    /// PF1, PF2 and J' against numerical differentiation: the largest deviation.
    TestPf,
    /// Sums of forces and moments on the links of a group: the largest.
    Equilibrium,
    /// The equation of motion of the input, written out over every load.
    Dynamics,
    /// What is left of the equation of motion (S "Pogr1"), N m, for a sliding input N.
    Remainder,
    /// The power of the balancing load against that of all loads and inertia loads.
    Global,
}

impl Residual {
    /// Its name: `group 0`, `global`.
    pub fn name(self, owner: Owner) -> Name {
        match (self, owner) {
            (Self::Equilibrium, Owner::Group(group)) => {
                text!("analysis-residual-group", number = group).into()
            }
            (Self::Equilibrium, _) => text!("analysis-residual-equilibrium").into(),
            (Self::TestPf, _) => "TestPf".into(),
            (Self::Remainder, _) => "Pogr1".into(),
            (Self::Dynamics, _) => text!("analysis-residual-dynamics").into(),
            (Self::Global, _) => text!("analysis-residual-global").into(),
        }
    }
}

/// Checks, and the residuals of the positions and samples that they went through.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Checks {
    /// The checks.
    pub all: Vec<Check>,
    /// Residuals of the checked positions; of very many positions a sample is checked.
    pub(crate) of_positions: Table,
    /// Residuals of the checked samples of a transient motion.
    pub(crate) of_trajectory: Table,
}
