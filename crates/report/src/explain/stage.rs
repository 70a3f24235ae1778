//! One stage of the calculation in words.

/// One stage of the calculation.
pub(super) struct Stage {
    /// The result of the stage.
    pub(super) name: &'static str,
    /// Why it is run; or why not, and what would make it run.
    pub(super) reason: String,
    /// The method; `None` for a stage that is not run.
    pub(super) method: Option<String>,
}

pub(super) fn run(name: &'static str, reason: impl Into<String>, method: impl Into<String>) -> Stage {
    Stage { name, reason: reason.into(), method: Some(method.into()) }
}

pub(super) fn left_out(name: &'static str, reason: impl Into<String>) -> Stage {
    Stage { name, reason: reason.into(), method: None }
}
