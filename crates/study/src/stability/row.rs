//! One method at one distance from a singular position, and its assessment.

use assur_words::{Text, name, number, text};
use serde::Serialize;

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
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The group and the kind of singular position, as `group 1 (RRR rod, rocker), change point`.
    #[serde(rename = "where")]
    pub place: Text,
    /// The method.
    pub method: Text,
    /// `pf0`, `pf1`, `pf2`, `reactions` or `friction`.
    pub quantity: &'static str,
    /// Dimensionless distance from the singular position, or from the coefficients at which it jams.
    pub distance: f64,
    /// Dimensionless determinant there; with friction the distance.
    pub health: f64,
    /// Largest relative deviation from the reference; `None` if the method has no result.
    pub error: Option<f64>,
    /// Largest error that a backward-stable method may have.
    pub bound: f64,
    /// Whether the method keeps the bound, or has no result where few digits or none could remain.
    pub ok: bool,
    /// Why there is no number, or why the row failed.
    pub reason: Option<Text>,
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
}

/// The subject of a row: everything but the outcome.
#[derive(Debug, Clone)]
pub(crate) struct Subject {
    pub(crate) place: Text,
    pub(crate) method: Text,
    pub(crate) quantity: &'static str,
    pub(crate) distance: f64,
    pub(crate) health: f64,
    pub(crate) bound: f64,
}

impl Subject {
    /// The row of an outcome (the error, or why there is no number). The method may have no result where few digits
    /// could remain or the position is nearly singular.
    pub(crate) fn row(self, outcome: Result<f64, Text>) -> Comparison {
        let may_refuse = self.bound > FEW_DIGITS || self.health < NEARLY_SINGULAR;
        self.row_or(outcome, may_refuse)
    }

    /// The row of an outcome, where the caller knows whether the method may have no result. An infinite error stands
    /// for a result where none exists.
    pub(crate) fn row_or(self, outcome: Result<f64, Text>, may_refuse: bool) -> Comparison {
        let (error, ok, reason) = match outcome {
            Ok(error) if error.is_nan() => (None, false, Some(text!("stability-not-a-number"))),
            Ok(error) if error.is_infinite() => (None, false, Some(text!("stability-not-finite"))),
            Ok(error) if error > self.bound => {
                let factor = number(format_args!("{:.1}", error / self.bound));
                (Some(error), false, Some(text!("stability-times-bound", factor)))
            }
            Ok(error) if error > NO_DIGIT => (Some(error), false, Some(text!("stability-no-digit"))),
            Ok(error) => (Some(error), true, None),
            Err(reason) => (None, may_refuse, Some(reason)),
        };
        Comparison {
            place: self.place,
            method: self.method,
            quantity: self.quantity,
            distance: self.distance,
            health: self.health,
            error,
            bound: self.bound,
            ok,
            reason,
        }
    }
}

/// Accepts a result without a correct digit where the bound promises none: a linear system can't detect that its
/// determinant is the root of a difference of lengths, so it gives a result where the closed forms, and with them the
/// program, give an error.
pub(crate) fn accept_without_digits(row: &mut Comparison) {
    if !row.ok && row.error.is_some_and(|error| error <= row.bound || row.bound >= 1.0) {
        row.ok = true;
        row.reason = Some(text!("stability-no-digit-left"));
    }
}
