//! The pictures by name, their parts, and what there is to show.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::Figure;
use strum::{EnumString, IntoStaticStr, VariantNames};

use crate::{Look, Results, ViewPart, curves, drive, forces, mechanism, motion, plans};

/// A picture; its names are those of the views of the terminal UI.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumString, IntoStaticStr, VariantNames)]
#[strum(serialize_all = "kebab-case")]
pub enum Picture {
    /// The mechanism to scale.
    Mechanism,
    /// Quantities over the positions.
    Curves,
    /// Reactions.
    Forces,
    /// Plans and constructions of a position.
    Plans,
    /// The motion over the positions or over time.
    Motion,
    /// Motor and flywheel.
    Drive,
    /// The mechanism with one of its groups.
    Structure,
}

impl Picture {
    /// Its parts, the one that is shown first in front; none if it is one whole.
    pub fn parts(self) -> &'static [ViewPart] {
        use ViewPart::{
            Accelerations, Causes, Construction, Course, Curves, EnergyMass, Forces, Hodograph, Inertia,
            Iteration, Overview, Places, Reduction, Velocities,
        };
        match self {
            Self::Forces => &[Overview, Causes, Curves, Hodograph],
            Self::Plans => &[Forces, Velocities, Accelerations, Construction],
            Self::Motion => &[Overview, Course, Iteration, Reduction],
            Self::Drive => &[Overview, Curves, Places, EnergyMass, Inertia, Reduction],
            Self::Mechanism | Self::Curves | Self::Structure => &[],
        }
    }

    /// The parts in which there is something to show.
    pub fn parts_of(self, results: &Results, look: &Look<'_>) -> Vec<ViewPart> {
        let found = results.found.as_deref();
        let has_regime = found.is_some_and(|found| found.analysis.dynamics.is_some());
        let has = |part: &ViewPart| match (self, part) {
            // The balancing load has one number, no direction.
            (Self::Forces, ViewPart::Hodograph) => {
                let reaction = found.and_then(|found| found.reactions.get(look.reaction));
                reaction.is_some_and(|reaction| reaction.series.len() == 3)
            }
            (Self::Motion, ViewPart::Course) => {
                has_regime || found.is_some_and(|found| !found.analysis.trajectory.is_empty())
            }
            (Self::Motion, ViewPart::Iteration) => has_regime,
            (Self::Motion, ViewPart::Reduction) => found.is_some_and(|found| {
                let moment = Column::of(Quantity::ReducedMoment, Owner::Input);
                results.linkage.angular() && found.analysis.positions.schema().find(moment).is_some()
            }),
            _ => true,
        };
        self.parts().iter().copied().filter(has).collect()
    }

    /// The part that is shown: the wanted one if there is something to show in it.
    pub fn part(self, results: &Results, look: &Look<'_>, wanted: Option<ViewPart>) -> ViewPart {
        let parts = self.parts_of(results, look);
        let wanted = wanted.filter(|part| parts.contains(part));
        wanted.or(parts.first().copied()).unwrap_or(ViewPart::Overview)
    }

    /// Whether there is something to show.
    pub fn is_in(self, results: &Results) -> bool {
        let found = results.found.as_deref();
        match self {
            Self::Mechanism | Self::Curves | Self::Structure => true,
            Self::Forces => found.is_some_and(|found| !found.reactions.is_empty()),
            Self::Plans => found.is_some(),
            Self::Motion => {
                found.is_some_and(|found| !found.motion.is_empty() || !found.analysis.trajectory.is_empty())
            }
            Self::Drive => found.is_some_and(|found| found.analysis.dynamics.is_some()),
        }
    }

    /// The picture of a part; without panels where there is nothing to show.
    pub fn figure(self, results: &Results, look: &Look<'_>, part: ViewPart) -> Figure {
        match self {
            Self::Mechanism => mechanism::figure(results, look, &[]),
            Self::Curves => curves::figure(results, look),
            Self::Forces => forces::figure(results, look, part),
            Self::Plans => plans::figure(results, look, part),
            Self::Motion => motion::figure(results, look, part, usize::MAX),
            Self::Drive => drive::figure(results, look, part, 1),
            Self::Structure => mechanism::structure(results, look),
        }
    }
}
