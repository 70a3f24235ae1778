//! The text report.

use assur_mechanism::Mechanism;

use crate::Analysis;

/// The report.
pub fn report(_analysis: &Analysis, _mechanism: &Mechanism, _ascii: bool) -> String {
    String::new()
}

/// Rows in aligned columns.
pub fn columns(rows: &[Vec<String>], _right_from: usize, _ascii: bool) -> String {
    rows.iter().map(|row| row.join("  ") + "\n").collect()
}
