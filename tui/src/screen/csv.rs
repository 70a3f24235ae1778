//! Columns as comma separated values.

use super::study::Study;

/// The chosen columns: position, then each with its unit in the name; a missing number is an empty field.
pub(crate) fn of_columns(study: &Study, columns: &[usize]) -> String {
    let mut text = String::from("position");
    for &column in columns {
        let Some(series) = study.column(column) else { continue };
        text.push(',');
        text.push_str(&field(&format!("{}_{}", series.short, series.unit)));
    }
    text.push('\n');
    for position in 0..study.positions() {
        text.push_str(&position.to_string());
        for &column in columns {
            let value = study
                .column(column)
                .and_then(|series| series.values.get(position))
                .copied()
                .unwrap_or(f64::NAN);
            text.push(',');
            if value.is_finite() {
                text.push_str(&value.to_string());
            }
        }
        text.push('\n');
    }
    text
}

fn field(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
