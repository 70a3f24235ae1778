//! The results of one point.

use std::collections::BTreeSet;
use std::sync::{Arc, Mutex, PoisonError};

use crate::Status;

/// The results of one point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    /// The parameters, SI.
    pub(crate) parameters: Vec<f64>,
    pub(crate) status: Status,
    /// The first failure in words, one line; empty where there is none.
    pub(crate) message: String,
    /// Positions without a solution; `None` where none was tried.
    pub(crate) failed: Option<usize>,
    /// Names of the values.
    pub(crate) names: Arc<[String]>,
    pub(crate) values: Vec<f64>,
    /// Designation of the motor.
    pub(crate) motor: Option<String>,
}

impl Row {
    /// A row without results.
    pub(crate) fn without(status: Status, message: &str, failed: Option<usize>) -> Self {
        let message = message.split_whitespace().collect::<Vec<_>>().join(" ");
        Self {
            parameters: Vec::new(),
            status,
            message,
            failed,
            names: Arc::new([]),
            values: Vec::new(),
            motor: None,
        }
    }
}

/// Numbers with the names of their columns.
#[derive(Debug, Default)]
pub(crate) struct Cells {
    pub(crate) names: Vec<String>,
    pub(crate) values: Vec<f64>,
}

impl Cells {
    pub(crate) fn add(&mut self, name: impl Into<String>, value: f64) {
        self.names.push(name.into());
        self.values.push(value);
    }

    pub(crate) fn add_some(&mut self, name: impl Into<String>, value: Option<f64>) {
        if let Some(value) = value {
            self.add(name, value);
        }
    }

    /// The column of the first number that is not finite.
    pub(crate) fn not_finite(&self) -> Option<&str> {
        let at = self.values.iter().position(|value| !value.is_finite())?;
        self.names.get(at).map(String::as_str)
    }
}

/// Lists of names, stored once: nearly always all rows share one list.
#[derive(Debug, Default)]
pub(crate) struct SharedNames(Mutex<BTreeSet<Arc<[String]>>>);

impl SharedNames {
    /// The one copy of these names.
    pub(crate) fn shared(&self, names: Vec<String>) -> Arc<[String]> {
        // The set is consistent even if another thread panicked.
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known.get(&*names) {
            return Arc::clone(found);
        }
        let names: Arc<[String]> = names.into();
        known.insert(Arc::clone(&names));
        names
    }
}
