//! Warnings: what in a scene is probably not meant, and what a reader of its results should know. Nothing is calculated here that
//! results need.

mod assembly;
mod friction;
mod loads;
mod mistakes;

use assur_dynamics::unknown_rotor;
use assur_integrator::Knob;
use assur_mechanism::{Driver, Mechanism, Motion, Range, Warning};
use assur_words::{Describe, Text, coordinate, joined, list, name, number, quantity, text};

use crate::{
    Calculation, InputMotion, Options, results::Survey, several::Several, trajectory::WithoutForces,
};

/// Most failures that are kept in full.
pub const MOST_FAILURES: usize = 1000;

/// What the calculated positions and samples show, as far as warnings need it.
pub(crate) struct Seen<'a> {
    /// Positions at a change point, where reactions are not determined.
    pub(crate) at_change_points: &'a Listed,
    pub(crate) survey: &'a Survey,
    pub(crate) several: &'a [Several],
    pub(crate) without_forces: &'a WithoutForces,
}

impl Calculation {
    /// All warnings in the order in which they are told: those of reading the scene, those that its motion gives, remarks on the results.
    pub(crate) fn warnings(&self, seen: &Seen<'_>) -> Vec<Warning> {
        let mut all = self.linkage.mechanism.warnings.clone();
        all.extend(self.mistakes());
        all.extend(self.remarks(seen).into_iter().map(Warning::from));
        all
    }

    fn remarks(&self, seen: &Seen<'_>) -> Vec<Text> {
        let mut notes = self.unused.clone();
        notes.extend(self.change_points());
        notes.extend(self.tells_poles.then(|| self.poles()).flatten());
        notes.extend(self.barriers());
        notes.extend(self.regime_notes());
        notes.extend(self.driving_loads());
        notes.extend(self.springs_without_direction());
        notes.extend(self.positions_out_of_time());
        notes.extend(self.listed_against_the_motion());
        notes.extend(self.laws_that_jump());
        notes.extend(self.friction_of_contacts());
        if let InputMotion::Transient(found) = &self.motion {
            notes.extend(found.unrest.as_ref().map(|why| text!("analysis-unrest", why)));
            notes.extend(unknown_rotor(&self.linkage.mechanism).map(|warning| warning.text));
        }
        if !self.linkage.structure.passive.is_empty()
            && self.analyzer.is_some_and(|method| method.gives_reactions)
        {
            notes.push(if self.least_norm {
                text!("analysis-least-norm")
            } else {
                text!("analysis-open-reactions", option = name("--indeterminate least-norm"))
            });
        }
        let (positions, samples) = (seen.at_change_points, seen.without_forces);
        notes.extend(positions.note(|positions| text!("analysis-no-reactions", positions)));
        if samples.at_change_points > 0 {
            notes.push(text!("analysis-no-reactions-of-samples", count = samples.at_change_points));
        }
        if let Some(reason) = &samples.reason {
            notes.push(text!("analysis-no-forces", count = samples.refused, reason));
        }
        notes.extend(self.nearly_singular(seen.survey));
        notes.extend(self.friction_of_pairs(seen.several));
        if let Some(more) = seen.survey.failures.checked_sub(MOST_FAILURES).filter(|more| *more > 0) {
            notes.push(text!("analysis-more-failures", more));
        }
        notes
    }

    /// The drives whose speed jumps, and when.
    fn laws_that_jump(&self) -> Vec<Text> {
        /// Most instants that are told.
        const MOST: usize = 8;
        let jumps = |driver: &Driver| {
            let times: Vec<f64> =
                driver.law.as_ref()?.breaks().map(|(time, _)| time).take(MOST + 1).collect();
            let more = (times.len() > MOST).then(|| name("..."));
            // Of a table that repeats, rounds of its length are added.
            let told =
                times.iter().take(MOST).map(|time| quantity((1e9 * time).round() / 1e9, "s")).chain(more);
            let drive = Text::from(&driver.label);
            (!times.is_empty()).then(|| text!("analysis-speed-jumps", drive, times = list(told)))
        };
        self.linkage.mechanism.input.drivers.iter().filter_map(jumps).collect()
    }

    /// A list of places that the prescribed motion passes in the opposite order.
    fn listed_against_the_motion(&self) -> Option<Text> {
        let input = &self.linkage.mechanism.input;
        let (Range::To(to), Some(Motion::Prescribed { speed, .. })) =
            (input.range, &self.linkage.mechanism.motion)
        else {
            return None;
        };
        let last = input.coordinate(input.positions.saturating_sub(1));
        let place = |at: f64| coordinate(at, self.linkage.kind(), 6);
        let other = name(if input.sign() > 0.0 { "cw" } else { "ccw" });
        (speed * (last - input.from) < 0.0).then(|| {
            text!("analysis-listed-backwards", from = place(input.from), to = place(to), direction = other)
        })
    }

    /// Requirements on a regime that are not met, and whether its loads drive.
    fn regime_notes(&self) -> Vec<Text> {
        /// A ratio is written with four digits.
        const MET: f64 = 1e-3;
        let InputMotion::Steady(found) = &self.motion else { return Vec::new() };
        let (mechanism, regime) = (&self.linkage.mechanism, &found.regime);
        let Some(Motion::Steady { mean_speed: wanted, .. }) = mechanism.motion else { return Vec::new() };
        let mut notes = Vec::new();
        let unit = if self.linkage.kind().is_angle() { "rad/s" } else { "m/s" };
        if ((regime.figures.mean_speed - wanted) / wanted).abs() > MET {
            let speed = |speed: f64| quantity(format_args!("{speed:.6}"), unit);
            let [wanted, found] = [wanted, regime.figures.mean_speed].map(speed);
            notes.push(if regime.figures.ratio.is_some() {
                text!("analysis-other-mean-speed", wanted, found)
            } else {
                text!("analysis-other-mean-speed-by-moment", wanted, found)
            });
        }
        if let Some(motor) = &found.motor
            && !motor.passed_over.is_empty()
        {
            let passed = joined("; ", motor.passed_over.iter().map(Describe::describe));
            let motor = name(motor.motor.designation.clone());
            notes.push(text!("analysis-motors-passed-over", motor, passed));
        }
        if regime.figures.are_loads_driving(-regime.resistance_work) {
            let size = |value: f64, unit| quantity(format_args!("{value:.6}"), unit);
            let brakes =
                if found.motor.is_some() { "analysis-motor-brakes" } else { "analysis-drive-brakes" };
            notes.push(text!(
                "analysis-loads-drive",
                brakes = text!(brakes),
                work = size(-regime.resistance_work, "J"),
                power = size(-regime.figures.required_power, "W")
            ));
        }
        notes
    }
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

    /// What is said of "position 3" or "positions 3, 11", if there are any.
    pub(crate) fn note(&self, said: impl FnOnce(Text) -> Text) -> Option<Text> {
        (self.count > 0).then(|| said(self.words()))
    }

    fn words(&self) -> Text {
        let more = match self.count - self.first.len() {
            0 => Text::default(),
            more => text!("analysis-and-more", more),
        };
        let numbers = list(self.first.iter().map(number));
        text!("analysis-positions", count = self.count, numbers, more)
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
pub(crate) fn unused(mechanism: &Mechanism, options: &Options) -> Vec<Text> {
    let transient = matches!(mechanism.motion, Some(Motion::Transient { .. }));
    let steady = matches!(mechanism.motion, Some(Motion::Steady { .. }));
    let mut notes = Vec::new();
    if mechanism.drive.is_some() && !transient && !steady {
        notes.push(text!("analysis-drive-unused"));
    }
    if let Some(method) = options.integrator.as_ref().filter(|_| !transient) {
        let method = name(method.clone());
        notes.push(if steady {
            text!("analysis-integrator-unused-steady", method)
        } else {
            text!("analysis-integrator-unused", method)
        });
    }
    if let Some(Motion::Transient { step: Some(_), integrator, .. }) = &mechanism.motion {
        let named = options.integrator.as_deref().unwrap_or(integrator);
        let all = assur_integrator::integrators().unwrap_or_default();
        let fixed: Vec<_> =
            all.iter().filter(|plugin| plugin.knob == Knob::Step).map(|plugin| plugin.name).collect();
        if !fixed.contains(&named) {
            notes.push(text!(
                "analysis-step-unused",
                method = name(named.to_owned()),
                fixed = list(fixed.into_iter().map(name))
            ));
        }
    }
    notes
}
