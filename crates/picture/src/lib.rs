//! Pictures of results: each is a function from what was calculated, and from what of it is shown, to panels of a
//! [`Figure`](assur_figure::Figure).
//!
//! * [`mechanism`], [`assembly`]: the mechanism to scale, with paths and arrows, its structure, many positions over each other.
//! * [`curves`]: quantities over the positions.
//! * [`plans`]: force polygons, plans of velocities and accelerations, constructions.
//! * [`forces`]: reactions over the cycle, beside the friction of their pairs, and by [`causes`].
//! * [`following`]: what follows while a point is moved.
//! * [`motion`], [`regime`]: the motion over the positions or over time, the steady regime with its motor and flywheel.
//!
//! A [`Picture`] is one of them by its name; [`find`] looks for what it shows.
//!
//! Knows no terminal, no file and no state of a screen.

mod acting;
mod arrows;
pub mod assembly;
pub mod causes;
mod compared;
pub mod curves;
mod events;
pub mod find;
pub mod following;
pub mod forces;
mod found;
mod friction;
pub mod mechanism;
pub mod motion;
mod outline;
mod over;
pub mod paper;
mod places;
mod planner;
pub mod plans;
pub mod plots;
pub mod polygons;
mod probe;
mod reduction;
pub mod regime;
mod results;
mod rubbing;
mod series;
mod view;

pub use arrows::missing;
pub use compared::Compared;
pub use found::{Found, Reaction};
pub use outline::Outline;
pub use over::Base;
pub use planner::{Planner, Plans};
pub use probe::{PathFigures, Probe};
pub use results::{Broken, Results};
pub use series::{Series, Transfer};
pub use view::Picture;

use assur_book::{Fact, Unit};
use assur_kinematics::Linkage;
use assur_words::{Text, joined};
use strum::{EnumString, IntoStaticStr, VariantArray, VariantNames};

assur_words::resources!();

/// What of the results is shown.
#[derive(Debug, Clone, Copy, Default)]
pub struct Look<'a> {
    /// Number of the position, from 0.
    pub position: usize,
    /// Part of the way to the next position that the motion has gone, 0 to 1.
    pub part: f64,
    /// Index in the transfer functions of the results.
    pub transfer: usize,
    /// A group of the structure.
    pub group: usize,
    /// Index of a mode of that group in the first position that is looked at.
    pub mode: Option<usize>,
    /// Index in the reactions found.
    pub reaction: usize,
    /// Group whose force polygon is drawn; the last is the input link.
    pub polygon: usize,
    /// Last step of the constructions that is drawn.
    pub step: usize,
    /// First quantity of the motion.
    pub motion: usize,
    /// Index of the event of the cycle that is highlighted.
    pub event: usize,
    /// Index in the columns of the results: the quantity that is looked for.
    pub column: usize,
    /// Short names of the quantities that lie over each other; none: PF0, PF1, PF2 of the chosen one.
    pub picked: &'a [String],
    /// Vectors on the mechanism.
    pub arrows: Arrows,
    /// Whether the position is drawn alone, so that no other one needs the same scales of vectors.
    pub alone: bool,
    /// Paths of the points.
    pub traces: Traces,
    /// How many groups are joined to the input link; `None`: all.
    pub joined: Option<usize>,
    /// The position whose plan stays beside that of the present one.
    pub held: Option<usize>,
    /// A point that is moved over the drawing.
    pub probe: Option<&'a Probe>,
    /// A second scene for comparison.
    pub compared: Option<&'a Compared>,
    /// Whether the results by another force analyzer are being calculated.
    pub calculating: bool,
}

impl Look<'_> {
    /// The place in the motion as a number of a position, with a fraction between two of them.
    pub fn at(&self) -> f64 {
        self.position as f64 + self.part
    }
}

/// Unit in which the coordinate is shown, and its factor from SI.
pub fn coordinate_unit(linkage: &Linkage) -> (&'static str, f64) {
    let unit = Unit::coordinate(linkage.kind());
    (unit.name, unit.factor)
}

/// The coordinate at a number of a position, also between two or after the last one, in the unit that is shown.
pub(crate) fn coordinate_at(linkage: &Linkage, at: f64) -> f64 {
    let [first, next] = [0, 1].map(|index| linkage.mechanism.input.coordinate(index));
    coordinate_unit(linkage).1 * (first + at * (next - first))
}

/// A part of a view that has several; its names are those of `--part`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
pub enum ViewPart {
    /// The numbers of the position, with a chart.
    Overview,
    /// The shares of the causes in a reaction.
    Causes,
    /// Curves over the positions.
    Curves,
    /// The path of the tip of a reaction.
    Hodograph,
    /// The course of the motion over time, or of the regime over the cycle.
    Course,
    /// How the regime was found.
    Iteration,
    /// The flywheel in its two places, and other motors.
    Places,
    /// Work over reduced inertia.
    EnergyMass,
    /// The shares of the reduced inertia.
    Inertia,
    /// The link of reduction with its force.
    Reduction,
    /// Force polygons.
    Forces,
    /// The plan of velocities.
    Velocities,
    /// The plan of accelerations.
    Accelerations,
    /// A construction on paper.
    Construction,
    /// What happens over the cycle.
    Events,
}

/// Which vectors are drawn on the mechanism; their names are those of `--arrows`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, VariantArray, EnumString, VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Arrows {
    /// None of them.
    None,
    /// First derivatives of the points.
    #[default]
    #[strum(serialize = "velocities")]
    Velocity,
    /// Second derivatives of the points.
    #[strum(serialize = "accelerations")]
    Acceleration,
    /// Both derivatives.
    Both,
    /// The loads of the scene: forces, moments, springs, contacts.
    Applied,
    /// What acts on the links from outside, with their weights and inertia loads.
    Loads,
    /// The forces of the pairs.
    Reactions,
}

/// Which paths of the points are drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, VariantArray)]
pub enum Traces {
    /// Those of all points.
    #[default]
    All,
    /// That of the chosen point.
    Chosen,
    /// The last part of the path of every point, up to the present position.
    Trail,
    /// None of them.
    None,
}

/// The facts of these identities in one line: `unevenness 0.05, mean speed 6.28319 rad/s`.
pub fn in_a_line(facts: &[Fact], ids: &[&str]) -> Text {
    let shown = ids.iter().filter_map(|id| facts.iter().find(|fact| fact.id == *id));
    joined(", ", shown.map(|fact| joined(" ", [fact.what().short(), fact.with_unit()])))
}
