//! One method at one distance from a singular position.

use serde::Serialize;

/// Distances at which a walk stops, dimensionless.
pub const DISTANCES: [f64; 15] =
    [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15];

/// A refusal is right where less than three digits could be left, or this close to the singular position.
pub(crate) const REFUSABLE: f64 = 1e-3;
const NEAR: f64 = 1e-4;

/// A number with a relative error above this is wrong, whatever the bound allows.
const WORTHLESS: f64 = 0.5;

/// What a walk is about, and what is expected of a method on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Law {
    /// Kind of walk: `groups`, `cycle`, `passing`, `differences`, `motion`, `scales`, `turns`.
    pub section: &'static str,
    /// What the distance is.
    pub along: &'static str,
    /// What the bound follows from.
    pub expected: &'static str,
}

/// One method, one quantity, one distance.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// What is expected.
    #[serde(flatten)]
    pub law: Law,
    /// The walk, as `group 1 (RRR rod, rocker), stretched`.
    #[serde(rename = "where")]
    pub place: String,
    /// The method.
    pub method: String,
    /// `pf0`, `pf1`, `pf2`, `reactions`, `balancing`, `motion`, ...
    pub quantity: &'static str,
    /// How far from failure, as the law says.
    pub distance: f64,
    /// Dimensionless determinant there; for walks without one, what takes its place.
    pub health: f64,
    /// Largest relative deviation from the reference; `None` where the method refuses.
    pub error: Option<f64>,
    /// What a backward-stable method may lose.
    pub bound: f64,
    /// Whether the method keeps the bound, or refuses where little or nothing could be left.
    pub ok: bool,
    /// Why there is no number, or why the row is not ok.
    pub reason: Option<String>,
}

/// What a row is about: all but the outcome.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Subject<'a> {
    pub(crate) law: &'static Law,
    pub(crate) place: &'a str,
    pub(crate) method: &'a str,
    pub(crate) quantity: &'static str,
    pub(crate) distance: f64,
    pub(crate) health: f64,
    pub(crate) bound: f64,
}

impl Subject<'_> {
    /// The row, judged; a method may refuse where little could be left, or close to a singular position.
    pub(crate) fn row(&self, outcome: Result<f64, String>) -> Row {
        self.row_or(outcome, self.bound > REFUSABLE || self.health < NEAR)
    }

    /// The row, judged; the caller knows whether a refusal is right. An answer where there is none is an infinite error: no
    /// bound and no right to refuse makes it ok.
    pub(crate) fn row_or(&self, outcome: Result<f64, String>, may_refuse: bool) -> Row {
        let (error, ok, reason) = match outcome {
            Ok(error) if error.is_nan() => (None, false, Some("the result is no number".to_owned())),
            Ok(error) if error.is_infinite() => {
                (None, false, Some("gives no finite number, or an answer where there is none".to_owned()))
            }
            Ok(error) if error > self.bound => {
                let factor = error / self.bound;
                (Some(error), false, Some(format!("loses {factor:.1} times more than the bound")))
            }
            Ok(error) if error > WORTHLESS => {
                (Some(error), false, Some("gives a number of which no digit is right".to_owned()))
            }
            Ok(error) => (Some(error), true, None),
            Err(reason) => (None, may_refuse, Some(reason)),
        };
        Row {
            law: *self.law,
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

/// A linear system can't know that its determinant is a root of what the lengths say: so close it has no digit right, within the
/// bound or where the bound says that all are lost, where the closed forms refuse, and with them the program.
pub(crate) fn unaware(row: &mut Row) {
    if row.error.is_some_and(|error| error <= row.bound || row.bound >= 1.0) && !row.ok {
        row.ok = true;
        row.reason = Some(
            "no digit is left, as the bound says; the linear system alone can't tell, the closed forms refuse here"
                .to_owned(),
        );
    }
}
