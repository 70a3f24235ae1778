//! The result of a check, and how the residuals of all positions are combined.

use assur_number::greater;
use assur_words::{Text, text};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// One check over all positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Name, by a stable identity.
    pub name: Text,
    /// The residual that comes closest to its limit, or exceeds it most. Dimensionless.
    pub residual: f64,
    /// Its limit.
    pub limit: f64,
    /// Number of the position of this residual; absent where it belongs to none.
    pub at: Option<usize>,
    /// Pair, link or point of this residual.
    pub place: Text,
    /// What is compared, and where the limit comes from.
    pub reason: Text,
    /// Where not all positions (samples of a motion) were checked: how many were, and out of how many.
    pub sample: Option<[usize; 2]>,
    /// Positions that could not be checked, or not in full (too close to the limit of assembly, or singular).
    pub left_out: usize,
    /// The reason for the first of them; empty where all were checked.
    pub why_left_out: Text,
    /// Whether the check is conclusive: a residual exceeds its limit, or at least one position could be checked in
    /// full. Otherwise it is neither [`ok`](Self::ok) nor [`failed`](Self::failed).
    pub judged: bool,
    /// Whether the check is conclusive, and every residual that could be checked keeps its limit.
    pub ok: bool,
}

impl Check {
    /// A check of one number that belongs to no position; residual and limit relative to the compared quantity. With a
    /// limit as large as that quantity only a residual that exceeds it is conclusive.
    pub fn of(name: Text, residual: f64, limit: f64, place: Text, reason: Text) -> Self {
        let proves_nothing = residual <= limit && limit > JUDGES;
        Self {
            name,
            residual,
            limit,
            at: None,
            place,
            reason,
            sample: None,
            left_out: 0,
            why_left_out: if proves_nothing { LIMIT_TOO_WIDE } else { Text::default() },
            judged: !proves_nothing,
            ok: residual <= limit && !proves_nothing,
        }
    }

    fn show(&mut self, Residual { size, limit, at, place }: Residual) {
        (self.residual, self.limit, self.at, self.place) = (size, limit, Some(at), place);
    }

    /// Whether every residual keeps its limit; `None` where the check is not conclusive, and
    /// [`why_left_out`](Self::why_left_out) says why.
    pub fn verdict(&self) -> Option<bool> {
        self.judged.then_some(self.ok)
    }

    /// Whether a residual exceeds its limit. A check that could check no position does not fail.
    pub fn failed(&self) -> bool {
        self.judged && !self.ok
    }
}

impl Serialize for Check {
    /// As results show it: `ok` is null where the check is not conclusive, and `why` says why it is not.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", &self.name)?;
        map.serialize_entry("residual", &self.residual)?;
        map.serialize_entry("limit", &self.limit)?;
        if let Some(at) = self.at {
            map.serialize_entry("at", &at)?;
        }
        if !self.place.is_empty() {
            map.serialize_entry("place", &self.place)?;
        }
        map.serialize_entry("reason", &self.reason)?;
        if let Some(sample) = self.sample {
            map.serialize_entry("sample", &sample)?;
        }
        map.serialize_entry("left_out", &self.left_out)?;
        if !self.why_left_out.is_empty() {
            map.serialize_entry("why_left_out", &self.why_left_out)?;
        }
        map.serialize_entry("judged", &self.judged)?;
        map.serialize_entry("ok", &self.verdict())?;
        map.serialize_entry("why", &(!self.judged).then_some(&self.why_left_out))?;
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

/// One residual with its limit and its place.
#[derive(Debug)]
struct Residual {
    size: f64,
    limit: f64,
    at: usize,
    place: Text,
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
    widest: Option<Residual>,
}

impl Collector {
    pub(crate) fn new(name: Text, reason: Text) -> Self {
        let check = Check::of(name, 0.0, 0.0, Text::default(), reason);
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
            if self.widest.as_ref().is_none_or(|widest| limit > widest.limit) {
                self.widest = Some(Residual { size: residual, limit, at, place: place() });
            }
            return;
        }
        self.enter(at);
        if self.is_worse(residual, limit, holds) {
            self.set(Residual { size: residual, limit, at, place: place() }, holds);
        }
        self.offers += 1;
    }

    /// Whether a residual is nearer to its limit, or exceeds it more, than all that were offered.
    fn is_worse(&self, residual: f64, limit: f64, holds: bool) -> bool {
        match (self.check.ok, holds) {
            (true, false) => true,
            (false, true) => false,
            _ => self.offers == 0 || share(residual, limit) > share(self.check.residual, self.check.limit),
        }
    }

    fn set(&mut self, worst: Residual, holds: bool) {
        self.check.ok &= holds;
        self.check.show(worst);
    }

    /// Adds what was collected over the positions after these.
    pub(crate) fn append(&mut self, next: Self) {
        let Self { check, offers, positions, widest, .. } = next;
        self.check.left_out += check.left_out;
        if self.check.why_left_out.is_empty() {
            self.check.why_left_out = check.why_left_out;
        }
        let Check { residual, limit, at, place, ok, .. } = check;
        if let Some(at) = at.filter(|_| self.is_worse(residual, limit, ok)) {
            self.set(Residual { size: residual, limit, at, place }, ok);
        }
        self.offers += offers;
        self.positions += positions;
        let limit = |of: &Option<Residual>| of.as_ref().map(|residual| residual.limit);
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
        if self.check.why_left_out.is_empty() {
            self.check.why_left_out = why;
        }
    }

    /// The check, if it applied to any position.
    pub(crate) fn into_check(self) -> Option<Check> {
        let Self { mut check, positions, widest, .. } = self;
        if positions == 0 {
            return None;
        }
        check.judged = !check.ok || positions > check.left_out;
        check.ok &= check.judged;
        if let Some(widest) = widest.filter(|_| !check.judged) {
            check.show(widest);
        }
        Some(check)
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
