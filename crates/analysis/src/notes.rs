//! Notes: what had to be left out, and which parts of a request have no use.

mod assembly;
mod contact;
mod loads;

use assur_integrator::Knob;
use assur_mechanism::{Mechanism, Motion, Range};

use crate::trajectory::WithoutForces;
use crate::{Calculation, InputMotion, Options};

/// Why no reactions are given at a change point.
const LOST: &str = "the mechanism stands at a change point (determinant of a group below 1e-5): constraints of a group \
                    coincide there and its reactions are not determined";

impl Calculation {
    /// Notes for the results; `positions` at which forces are not determined, and `samples` of a motion without them.
    pub(crate) fn notes(&self, positions: &Listed, samples: &WithoutForces) -> Vec<String> {
        let mut notes = self.unused.clone();
        notes.extend(self.change_points());
        notes.extend(self.poles());
        notes.extend(self.barriers());
        notes.extend(self.regime_notes());
        notes.extend(self.springs_without_direction());
        notes.extend(self.positions_out_of_time());
        notes.extend(self.listed_against_the_motion());
        notes.extend(self.friction_of_contacts());
        if let InputMotion::Transient(found) = &self.motion {
            let unrest = found.unrest.as_ref();
            notes.extend(unrest.map(|why| {
                format!(
                    "The motion does not come to rest for good ({why}); it ends at its first turning point, as with \
                     `until = \"turn\"`."
                )
            }));
        }
        if !positions.is_empty() {
            notes.push(format!("No reactions in {}: {LOST}.", positions.words()));
        }
        if samples.at_change_points > 0 {
            let count = counted("sample", samples.at_change_points);
            notes.push(format!("No reactions at {count} of the motion: {LOST}."));
        }
        if let Some(reason) = &samples.reason {
            notes.push(format!(
                "No forces at {} of the motion; at the first: {reason}.",
                counted("sample", samples.refused)
            ));
        }
        notes
    }

    /// A list of places that the prescribed motion passes in the opposite order.
    fn listed_against_the_motion(&self) -> Option<String> {
        let input = &self.linkage.mechanism.input;
        let (Range::To(to), Some(Motion::Prescribed { speed, .. })) =
            (input.range, &self.linkage.mechanism.motion)
        else {
            return None;
        };
        let [from, to] = [input.from, to].map(|at| {
            if self.linkage.angular() {
                format!("{:.6} deg", at.to_degrees())
            } else {
                format!("{:.6} mm", 1e3 * at)
            }
        });
        let other = if input.sign() > 0.0 { "cw" } else { "ccw" };
        (speed * (input.coordinate(input.positions.saturating_sub(1)) - input.from) < 0.0).then(|| {
            format!(
                "The positions are listed from {from} to {to}, and the input moves the other way: arrows of velocities point \
                 against the order of the positions. With `direction = \"{other}\"` in [input] the motion follows the list."
            )
        })
    }

    /// Requirements on a regime that are not met, and whether its loads drive.
    fn regime_notes(&self) -> Vec<String> {
        /// Mean speeds are computed to 1e-10.
        const MET: f64 = 1e-9;
        let InputMotion::Steady(found) = &self.motion else { return Vec::new() };
        let (mechanism, regime) = (&self.linkage.mechanism, &found.regime);
        let Some(Motion::Steady { mean_speed: wanted, .. }) = mechanism.motion else { return Vec::new() };
        let mut notes = Vec::new();
        let unit = if self.linkage.angular() { "rad/s" } else { "m/s" };
        if ((regime.figures.mean_speed - wanted) / wanted).abs() > MET {
            let given = if regime.figures.ratio.is_some() { "ratio" } else { "moment" };
            notes.push(format!(
                "The requested mean speed of {wanted:.6} {unit} is not met: with the given {given} it is {:.6} {unit}. Power, \
                 flywheel and the course are those of the regime found.",
                regime.figures.mean_speed
            ));
        }
        if regime.figures.required_power < 0.0 {
            notes.push(format!(
                "The loads drive: over a cycle they do {:.6} J of work, and the motor has to brake with {:.6} W.",
                -found.resistance_work, -regime.figures.required_power
            ));
        }
        notes
    }
}

/// A number of things: "1 sample", "3 samples".
fn counted(thing: &str, count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}

/// Positions by their numbers, of which the first ones are listed.
#[derive(Debug, Default)]
pub(crate) struct Listed {
    first: Vec<usize>,
    count: usize,
}

impl Listed {
    /// Most numbers that are listed.
    const MOST: usize = 100;

    pub(crate) fn add(&mut self, number: usize) {
        self.count += 1;
        if self.first.len() < Self::MOST {
            self.first.push(number);
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.count
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// "position 3", "positions 3, 11".
    pub(crate) fn words(&self) -> String {
        let plural = if self.count == 1 { "" } else { "s" };
        let numbers: Vec<_> = self.first.iter().map(ToString::to_string).collect();
        let more = match self.count - self.first.len() {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        format!("position{plural} {}{more}", numbers.join(", "))
    }
}

impl FromIterator<usize> for Listed {
    fn from_iter<I: IntoIterator<Item = usize>>(numbers: I) -> Self {
        let mut listed = Self::default();
        numbers.into_iter().for_each(|number| listed.add(number));
        listed
    }
}

/// Parts of the scene and of the choice of methods that are not used.
pub(crate) fn unused(mechanism: &Mechanism, options: &Options) -> Vec<String> {
    let transient = matches!(mechanism.motion, Some(Motion::Transient { .. }));
    let steady = matches!(mechanism.motion, Some(Motion::Steady { .. }));
    let mut notes = Vec::new();
    if mechanism.drive.is_some() && !transient && !steady {
        notes.push(
            "`[drive]` is not used: the motion is prescribed or absent; take `kind = \"steady\"` or \"transient\"."
                .to_owned(),
        );
    }
    if let Some(name) = options.integrator.as_ref().filter(|_| !transient) {
        let why = if steady {
            "the steady regime is found by collocation over the cycle, not by steps in time"
        } else {
            "the scene asks for no motion from an initial state"
        };
        notes.push(format!("Integrator `{name}` is not used: {why}."));
    }
    if let Some(Motion::Transient { step: Some(_), integrator, .. }) = &mechanism.motion {
        let named = options.integrator.as_deref().unwrap_or(integrator);
        let all = assur_integrator::integrators().unwrap_or_default();
        let fixed: Vec<_> =
            all.iter().filter(|plugin| plugin.knob == Knob::Step).map(|plugin| plugin.name).collect();
        if !fixed.contains(&named) {
            notes.push(format!(
                "`step` of [motion] is not used: integrator `{named}` chooses its steps by the tolerance; methods with a fixed \
                 step: {}.",
                fixed.join(", ")
            ));
        }
    }
    notes
}
