//! The result of a check, and how the residuals of all positions are combined.

use assur_number::greater;
use assur_words::{Text, text};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// How far a number is from what it must equal, and what that proves.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Pair, link, group or point.
    pub place: Text,
    /// The deviation, relative to what is compared; NaN where there is no number.
    pub error: f64,
    /// The greatest error that rounding, or the method, may make.
    pub bound: f64,
    /// Whether the error keeps its bound; `None` where that is not judged.
    pub holds: Option<bool>,
    /// Why it is not judged, or not everywhere; or more about a failure.
    pub why: Text,
}

impl Finding {
    /// Nothing is found yet.
    pub fn within(place: Text, bound: f64) -> Self {
        Self { place, error: f64::NAN, bound, holds: None, why: Text::default() }
    }

    /// One number. With a bound as large as what is compared only an error that exceeds it is conclusive.
    pub fn of(place: Text, error: f64, bound: f64) -> Self {
        // The comparison is written so that NaN fails.
        let holds = error <= bound;
        if holds && bound > JUDGES {
            return Self { error, why: LIMIT_TOO_WIDE, ..Self::within(place, bound) };
        }
        Self { error, holds: Some(holds), ..Self::within(place, bound) }
    }

    /// Whether the error exceeds its bound, or there is no number where there must be one.
    pub fn failed(&self) -> bool {
        self.holds == Some(false)
    }

    /// The error, where it is a number.
    pub fn number(&self) -> Option<f64> {
        Some(self.error).filter(|error| error.is_finite())
    }
}

/// What was found, in a word.
pub fn verdict(holds: Option<bool>) -> Text {
    match holds {
        Some(true) => text!("check-ok"),
        Some(false) => text!("check-failed"),
        None => text!("check-not-judged"),
    }
}

/// One check over all positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Name, by a stable identity.
    pub name: Text,
    /// What comes closest to its bound, or exceeds it most. It is judged if an error exceeds its bound, or if at least one position
    /// could be checked in full; its reason is that of the first position that could not.
    pub finding: Finding,
    /// Number of the position of the finding; absent where it belongs to none.
    pub at: Option<usize>,
    /// What is compared, and where the limit comes from.
    pub reason: Text,
    /// Where not all positions (samples of a motion) were checked: how many were, and out of how many.
    pub sample: Option<[usize; 2]>,
    /// Positions that could not be checked, or not in full (too close to the limit of assembly, or singular).
    pub left_out: usize,
}

impl Check {
    /// A check of one number that belongs to no position.
    pub fn of(name: Text, reason: Text, finding: Finding) -> Self {
        Self { name, finding, at: None, reason, sample: None, left_out: 0 }
    }
}

impl Serialize for Check {
    /// As results show it: a residual or limit that is not finite is null; `ok` is null where the check is not conclusive, and `why` says why it is not.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Finding { place, bound, holds, why, .. } = &self.finding;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", &self.name)?;
        // A residual that is not finite fails its check; the results are written all the same.
        map.serialize_entry("residual", &self.finding.number())?;
        map.serialize_entry("limit", &Some(*bound).filter(|bound| bound.is_finite()))?;
        if let Some(at) = self.at {
            map.serialize_entry("at", &at)?;
        }
        if !place.is_empty() {
            map.serialize_entry("place", place)?;
        }
        map.serialize_entry("reason", &self.reason)?;
        if let Some(sample) = self.sample {
            map.serialize_entry("sample", &sample)?;
        }
        map.serialize_entry("left_out", &self.left_out)?;
        if !why.is_empty() {
            map.serialize_entry("why_left_out", why)?;
        }
        map.serialize_entry("judged", &holds.is_some())?;
        map.serialize_entry("ok", holds)?;
        map.serialize_entry("why", &holds.is_none().then_some(why))?;
        map.end()
    }
}

/// The largest conclusive limit, relative to the size of the compared quantity: beyond, not even a wrong first digit
/// would be noticed, and a residual below such a limit proves nothing.
const JUDGES: f64 = 0.1;

const LIMIT_TOO_WIDE: Text = text!("check-limit-too-wide");

const TOO_WIDE: Text = text!("check-too-near");

/// Ratio of a residual to its limit; infinite where it is no number. Of residuals that are zero, the one with the larger
/// limit counts more, so that a report shows a meaningful limit.
fn share(residual: f64, limit: f64) -> f64 {
    let share = if residual == 0.0 { -1.0 / limit } else { residual / limit };
    if share.is_nan() { f64::INFINITY } else { share }
}

/// Collects the residuals of one check.
#[derive(Debug)]
pub(crate) struct Collector {
    check: Check,
    offers: usize,
    /// The last position, and the last skipped one, to count each once.
    last: [Option<usize>; 2],
    positions: usize,
    /// The position with the widest limit of all that could not be checked.
    widest: Option<(usize, Finding)>,
}

impl Collector {
    pub(crate) fn new(name: Text, reason: Text) -> Self {
        let check = Check::of(name, reason, Finding::of(Text::default(), 0.0, 0.0));
        Self { check, offers: 0, last: [None; 2], positions: 0, widest: None }
    }

    /// Adds a residual with its limit, both relative to the compared quantity; `place` is called only for the worst
    /// residual up to now.
    pub(crate) fn offer(&mut self, at: usize, residual: f64, limit: f64, place: impl FnOnce() -> Text) {
        self.offer_of(at, residual, limit, 1.0, place);
    }

    /// Adds a residual with its limit where the compared quantity has another `size` than 1. If the limit is too wide
    /// for that size, only a residual that exceeds it counts.
    pub(crate) fn offer_of(
        &mut self,
        at: usize,
        residual: f64,
        limit: f64,
        size: f64,
        place: impl FnOnce() -> Text,
    ) {
        // The comparison is written so that NaN fails.
        let holds = residual <= limit;
        if holds && limit > JUDGES * size {
            self.leave_out(at, TOO_WIDE);
            if self.widest.as_ref().is_none_or(|(_, widest)| limit > widest.bound) {
                self.widest = Some((at, Finding { error: residual, ..Finding::within(place(), limit) }));
            }
            return;
        }
        self.enter(at);
        if self.is_worse(residual, limit, holds) {
            self.set(at, Finding { error: residual, holds: Some(holds), ..Finding::within(place(), limit) });
        }
        self.offers += 1;
    }

    /// Whether a residual is nearer to its limit, or exceeds it more, than all that were offered.
    fn is_worse(&self, residual: f64, limit: f64, holds: bool) -> bool {
        let worst = &self.check.finding;
        match (worst.failed(), holds) {
            (false, false) => true,
            (true, true) => false,
            _ => self.offers == 0 || share(residual, limit) > share(worst.error, worst.bound),
        }
    }

    /// Shows another finding; the reason of the first position that could not be checked stays.
    fn set(&mut self, at: usize, worst: Finding) {
        let why = std::mem::take(&mut self.check.finding.why);
        (self.check.at, self.check.finding) = (Some(at), Finding { why, ..worst });
    }

    /// Adds what was collected over the positions after these.
    pub(crate) fn append(&mut self, next: Self) {
        let Self { check, offers, positions, widest, .. } = next;
        self.check.left_out += check.left_out;
        if self.check.finding.why.is_empty() {
            self.check.finding.why.clone_from(&check.finding.why);
        }
        let Finding { error, bound, .. } = check.finding;
        if let Some(at) = check.at.filter(|_| self.is_worse(error, bound, !check.finding.failed())) {
            self.set(at, check.finding);
        }
        self.offers += offers;
        self.positions += positions;
        let limit = |of: &Option<(usize, Finding)>| of.as_ref().map(|(_, widest)| widest.bound);
        if limit(&widest) > limit(&self.widest) {
            self.widest = widest;
        }
    }

    /// Counts positions; each check goes through them in order.
    fn enter(&mut self, at: usize) {
        if self.last[0] != Some(at) {
            self.last[0] = Some(at);
            self.positions += 1;
        }
    }

    /// Notes that a position could not be checked, and why.
    pub(crate) fn leave_out(&mut self, at: usize, why: Text) {
        self.enter(at);
        if self.last[1] == Some(at) {
            return;
        }
        self.last[1] = Some(at);
        self.check.left_out += 1;
        if self.check.finding.why.is_empty() {
            self.check.finding.why = why;
        }
    }

    /// The check, if it applied to any position.
    pub(crate) fn into_check(mut self) -> Option<Check> {
        if self.positions == 0 {
            return None;
        }
        let is_judged = self.check.finding.failed() || self.positions > self.check.left_out;
        if !is_judged {
            self.check.finding.holds = None;
            if let Some((at, widest)) = self.widest.take() {
                self.set(at, widest);
            }
        }
        Some(self.check)
    }
}

/// Residuals of the positions and states that were checked. A position that can't be checked is left out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Residuals {
    /// By the number of the position, the largest deviation of PF1, PF2 and J' from numerical differentiation, relative to
    /// what is compared.
    pub test_pf: Vec<(usize, f64)>,
    /// Residuals of the forces, by the number of the state.
    pub forces: Vec<ForceResiduals>,
}

/// How exactly the forces of one state are found.
#[derive(Debug, Clone, PartialEq)]
pub struct ForceResiduals {
    /// Number of the state.
    pub number: usize,
    /// By group in solving order, the largest sum of forces and moments on one of its links, relative to all loads and the
    /// largest reaction.
    pub groups: Vec<f64>,
    /// Sum of the equation of motion M + Q - J e - J' w^2/2, relative to its terms; M is the load of the drive, where the motion is
    /// prescribed the balancing load.
    pub dynamics: f64,
    /// The same sum itself (S "Pogr1"), N m, for a sliding input N.
    pub remainder: f64,
    /// Difference of the balancing load and the load of the drive; where the motion is prescribed, sum of the powers of all loads
    /// and inertia loads and of the balancing load. Relative to the terms.
    pub global: f64,
}

/// The greatest of some residuals; NaN if any is, because a residual without a value must not be hidden by others.
pub(crate) fn greatest(residuals: impl IntoIterator<Item = f64>) -> f64 {
    residuals.into_iter().fold(0.0, greater)
}

#[cfg(test)]
mod tests;
