//! The pictures by name, their parts, and what there is to show or is lacking.

use assur_analysis::results::{Column, Owner, Quantity};
use assur_figure::Figure;
use assur_words::{Text, joined, text};
use strum::{EnumString, IntoStaticStr, VariantNames};

use crate::{Look, Results, ViewPart, curves, events, forces, mechanism, motion, plans, regime};

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
            Accelerations, Causes, Construction, Course, Curves, EnergyMass, Events, Forces, Hodograph,
            Inertia, Iteration, Overview, Places, Reduction, Velocities,
        };
        match self {
            Self::Forces => &[Overview, Causes, Curves, Hodograph],
            Self::Plans => &[Forces, Velocities, Accelerations, Construction],
            Self::Motion => &[Overview, Course, Iteration, Reduction],
            Self::Drive => &[Overview, Curves, Places, EnergyMass, Inertia, Reduction],
            Self::Structure => &[Overview, Events],
            Self::Mechanism | Self::Curves => &[],
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
            (Self::Structure, ViewPart::Events) => found.is_some_and(|found| !found.events.is_empty()),
            (Self::Motion, ViewPart::Reduction) => found.is_some_and(|found| {
                let moment = Column::of(Quantity::ReducedMoment, Owner::Input);
                results.linkage.kind().is_angle() && found.rows().0.schema().find(moment).is_some()
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

    /// Why a part of it has nothing to show, with an example of what to add to the scene where something can be added; and whether
    /// something can be.
    pub fn missing(self, results: &Results, look: &Look<'_>, part: ViewPart) -> (Text, bool) {
        let Some(found) = &results.found else { return (text!("nothing-here"), false) };
        let has_loads = found.plans.calculation().plan.forces;
        let not_determined = || text!("forces-not-determined");
        let why = match (self, &found.analysis.no_motion) {
            (Self::Motion | Self::Drive, Some(reason)) => motion::not_found(reason, "\n"),
            (Self::Forces | Self::Plans, Some(reason)) => {
                joined("\n", [text!("no-forces-found"), reason.clone()])
            }
            (Self::Motion, None) => return (text!("add-motion"), true),
            (Self::Drive, None) if found.analysis.dynamics.is_some() => text!("drive-no-motor"),
            (Self::Drive, None) if results.linkage.kind().is_time() => text!("drive-over-time"),
            (Self::Drive, None) => return (text!("add-drive"), true),
            (Self::Forces, None) if has_loads => not_determined(),
            (Self::Plans, None) if has_loads => {
                match plans::shown(found, look, part, &found.plans.at(look.position)) {
                    plans::Shown::Nothing(why) => why,
                    _ => not_determined(),
                }
            }
            (Self::Forces | Self::Plans, None) => return (add_loads(results), true),
            _ => text!("nothing-here"),
        };
        (why, false)
    }

    /// The picture of a part; without panels where there is nothing to show.
    pub fn figure(self, results: &Results, look: &Look<'_>, part: ViewPart) -> Figure {
        match self {
            Self::Mechanism => mechanism::figure(results, look, &[]),
            Self::Curves => curves::figure(results, look),
            Self::Forces => forces::figure(results, look, part),
            Self::Plans => plans::figure(results, look, part),
            Self::Motion => motion::figure(results, look, part, usize::MAX),
            Self::Drive => regime::drive(results, look, part, 1),
            Self::Structure if part == ViewPart::Events => events::figure(results, look),
            Self::Structure => mechanism::structure(results, look),
        }
    }
}

/// An example of a force that can be added: on the last link, at the last of its points.
fn add_loads(results: &Results) -> Text {
    let mechanism = &results.linkage.mechanism;
    let point_on = |link: usize| mechanism.points.iter().rfind(|point| point.on(link).is_some());
    let last = (1..mechanism.links.len()).rev().find_map(|link| Some((link, point_on(link)?)));
    let [link, point] = last.map_or([Text::default(), Text::default()], |(link, point)| {
        [(&mechanism.links[link].name).into(), (&point.name).into()]
    });
    text!("add-loads", link, point)
}
