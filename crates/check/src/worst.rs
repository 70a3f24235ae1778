//! The largest residual of a check, measured by its limit.

/// One check over all positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// Name, stable.
    pub name: &'static str,
    /// The residual that comes closest to its limit, or exceeds it most. Dimensionless.
    pub residual: f64,
    /// Its limit.
    pub limit: f64,
    /// Number of the position of this residual.
    pub at: Option<usize>,
    /// Pair, link or point of this residual.
    pub place: String,
    /// What is compared, and where the limit comes from.
    pub reason: &'static str,
    /// Positions that the check had to leave out (too close to the end of assembly, or singular).
    pub left_out: usize,
    /// Whether every residual keeps its limit.
    pub ok: bool,
}

/// Part of its limit that a residual takes up; nothing of nothing is none.
fn share(residual: f64, limit: f64) -> f64 {
    // A larger limit goes before a smaller one where both residuals are zero, so that a report shows a limit that means
    // something.
    if residual == 0.0 { -1.0 / limit } else { residual / limit }
}

/// Collects the residuals of one check.
#[derive(Debug)]
pub(crate) struct Worst {
    check: Check,
    offers: usize,
}

impl Worst {
    pub(crate) fn new(name: &'static str, reason: &'static str) -> Self {
        let check = Check {
            name,
            residual: 0.0,
            limit: 0.0,
            at: None,
            place: String::new(),
            reason,
            left_out: 0,
            ok: true,
        };
        Self { check, offers: 0 }
    }

    /// Adds a residual with its own limit; `place` is called for the worst so far only.
    pub(crate) fn offer(&mut self, at: usize, residual: f64, limit: f64, place: impl FnOnce() -> String) {
        self.offers += 1;
        // NaN keeps no limit; the comparison is written so that it fails.
        let holds = residual <= limit;
        let worse = match (self.check.ok, holds) {
            (true, false) => true,
            (false, true) => false,
            _ => self.offers == 1 || share(residual, limit) > share(self.check.residual, self.check.limit),
        };
        if worse {
            self.check = Check {
                residual,
                limit,
                at: Some(at),
                place: place(),
                ok: self.check.ok && holds,
                ..self.check.clone()
            };
        }
    }

    /// Notes that a position had to be left out.
    pub(crate) fn leave_out(&mut self) {
        self.check.left_out += 1;
    }

    /// The check, if anything was compared.
    pub(crate) fn into_check(self) -> Option<Check> {
        (self.offers > 0).then_some(self.check)
    }
}
