//! One method at one distance from a singular position, and how it is judged.

use serde::Serialize;

/// Distances at which a walk stops, dimensionless.
pub const DISTANCES: [f64; 15] =
    [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15];

/// Largest error that a backward-stable method may have, in units of eps / health^k: the C of the bound.
pub const FACTOR: f64 = 16.0;

/// Where the bound is above this, a method may refuse: fewer than three digits could be left.
pub(crate) const FEW_DIGITS: f64 = 1e-3;

/// Below this health a method may refuse, whatever the bound says.
const NEARLY_SINGULAR: f64 = 1e-4;

/// A number with a relative error above this has no right digit: it is a failure even where the bound allows it.
const NO_DIGIT: f64 = 0.5;

/// One method, one quantity, one distance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// The group and what it approaches, as `group 1 (RRR rod, rocker), change point`.
    #[serde(rename = "where")]
    pub place: String,
    /// The method.
    pub method: String,
    /// `pf0`, `pf1`, `pf2` or `reactions`.
    pub quantity: &'static str,
    /// Dimensionless distance from the singular position.
    pub distance: f64,
    /// Dimensionless determinant there.
    pub health: f64,
    /// Largest relative deviation from the reference; `None` where the method refuses.
    pub error: Option<f64>,
    /// Largest error that a backward-stable method may have.
    pub bound: f64,
    /// Whether the method keeps the bound, or refuses where few digits or none could be left.
    pub ok: bool,
    /// Why there is no number, or why the row is not ok.
    pub reason: Option<String>,
}

/// What a row is about: all but the outcome.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Subject<'a> {
    pub(crate) place: &'a str,
    pub(crate) method: &'a str,
    pub(crate) quantity: &'static str,
    pub(crate) distance: f64,
    pub(crate) health: f64,
    pub(crate) bound: f64,
}

impl Subject<'_> {
    /// The row of an outcome (the error, or why there is no number), of a method that may refuse where few digits could be
    /// left or the position is nearly singular.
    pub(crate) fn row(&self, outcome: Result<f64, String>) -> Row {
        self.row_or(outcome, self.bound > FEW_DIGITS || self.health < NEARLY_SINGULAR)
    }

    /// The row of an outcome where the caller knows whether the method may refuse. An infinite error stands for an answer
    /// where there is none.
    pub(crate) fn row_or(&self, outcome: Result<f64, String>, may_refuse: bool) -> Row {
        let (error, ok, reason) = match outcome {
            Ok(error) if error.is_nan() => (None, false, Some("the result is not a number".to_owned())),
            Ok(error) if error.is_infinite() => {
                let reason = "the result is not finite, or there should be none";
                (None, false, Some(reason.to_owned()))
            }
            Ok(error) if error > self.bound => {
                let factor = error / self.bound;
                (Some(error), false, Some(format!("the error is {factor:.1} times the bound")))
            }
            Ok(error) if error > NO_DIGIT => {
                (Some(error), false, Some("no digit of the result is right".to_owned()))
            }
            Ok(error) => (Some(error), true, None),
            Err(reason) => (None, may_refuse, Some(reason)),
        };
        Row {
            place: self.place.to_owned(),
            method: self.method.to_owned(),
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

/// Accepts a result without a right digit where the bound promises none: a linear system can't see that its determinant is
/// the root of a difference of lengths, so it answers where the closed forms, and with them the program, refuse.
pub(crate) fn accept_without_digits(row: &mut Row) {
    if !row.ok && row.error.is_some_and(|error| error <= row.bound || row.bound >= 1.0) {
        row.ok = true;
        row.reason = Some(
            "no digit is left, as the bound says; the linear system can't see it, the closed forms refuse here"
                .to_owned(),
        );
    }
}
