//! One method at one distance from a singular position, and its assessment.

use assur_check::Finding;
use assur_words::{Text, name, number, text};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// Distances of the stops of a walk, dimensionless.
pub const DISTANCES: [f64; 15] =
    [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15];

/// Largest error that a backward-stable method may have, in units of eps / health^k: the C of the bound.
pub const FACTOR: f64 = 16.0;

/// The reactions, as rows name them.
pub(crate) const REACTIONS: &str = "reactions";

/// The forces of friction and the balancing load, as rows name them.
pub(crate) const FRICTION: &str = "friction";

/// Where the bound is above this, a method may have no result: fewer than three digits could remain.
pub(crate) const FEW_DIGITS: f64 = 1e-3;

/// Below this health a method may have no result, whatever the bound is.
const NEARLY_SINGULAR: f64 = 1e-4;

/// A number with a relative error above this has no correct digit: a failure even where the bound allows it.
const NO_DIGIT: f64 = 0.5;

/// One method, one quantity, one distance.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The method.
    pub method: Text,
    /// `pf0`, `pf1`, `pf2`, `reactions` or `friction`.
    pub quantity: &'static str,
    /// Dimensionless distance from the singular position, or from the coefficients at which it jams.
    pub distance: f64,
    /// Dimensionless determinant there; with friction the distance.
    pub health: f64,
    /// Largest relative deviation from the reference against the largest error that a backward-stable method may have, with the
    /// group and the kind of singular position as `group 1 (RRR rod, rocker), change point`. It is not judged where a method may
    /// have no result, since few digits or none could remain.
    pub finding: Finding,
}

impl Comparison {
    /// The quantity for a reader.
    pub(crate) fn quantity(&self) -> Text {
        match self.quantity {
            REACTIONS => text!("stability-reactions"),
            FRICTION => text!("stability-friction"),
            other => name(other),
        }
    }

    /// The same with its outcome (the error, or why there is no number). The method may have no result where few digits
    /// could remain or the position is nearly singular.
    pub(crate) fn judged(self, outcome: Result<f64, Text>) -> Self {
        let may_refuse = self.finding.bound > FEW_DIGITS || self.health < NEARLY_SINGULAR;
        self.judged_or(outcome, may_refuse)
    }

    /// The same with its outcome, where the caller knows whether the method may have no result. An infinite error stands
    /// for a result where none exists.
    pub(crate) fn judged_or(mut self, outcome: Result<f64, Text>, may_refuse: bool) -> Self {
        let bound = self.finding.bound;
        let (error, holds, why) = match outcome {
            Ok(error) if error.is_nan() => (error, Some(false), text!("stability-not-a-number")),
            Ok(error) if error.is_infinite() => (error, Some(false), text!("stability-not-finite")),
            Ok(error) if error > bound => {
                let factor = number(format_args!("{:.1}", error / bound));
                (error, Some(false), text!("stability-times-bound", factor))
            }
            Ok(error) if error > NO_DIGIT => (error, Some(false), text!("stability-no-digit")),
            Ok(error) => (error, Some(true), Text::default()),
            Err(why) => (f64::NAN, (!may_refuse).then_some(false), why),
        };
        self.finding = Finding { error, holds, why, ..self.finding };
        self
    }
}

impl Serialize for Comparison {
    /// As results show it: what is not judged is `ok`.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Finding { place, bound, why, .. } = &self.finding;
        let mut row = serializer.serialize_struct("Comparison", 9)?;
        row.serialize_field("where", place)?;
        row.serialize_field("method", &self.method)?;
        row.serialize_field("quantity", self.quantity)?;
        row.serialize_field("distance", &self.distance)?;
        row.serialize_field("health", &self.health)?;
        row.serialize_field("error", &self.finding.number())?;
        row.serialize_field("bound", bound)?;
        row.serialize_field("ok", &!self.finding.failed())?;
        row.serialize_field("reason", &(!why.is_empty()).then_some(why))?;
        row.end()
    }
}

/// Accepts a result without a correct digit where the bound promises none: a linear system can't detect that its
/// determinant is the root of a difference of lengths, so it gives a result where the closed forms, and with them the
/// program, give an error.
pub(crate) fn accept_without_digits(row: &mut Comparison) {
    let found = &mut row.finding;
    if found.failed() && found.number().is_some_and(|error| error <= found.bound || found.bound >= 1.0) {
        (found.holds, found.why) = (None, text!("stability-no-digit-left"));
    }
}
