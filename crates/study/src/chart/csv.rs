//! CSV: one row for each method and setting.

use super::{ChartData, Row, Value};

const HEADER: &str =
    "stage method setting value seconds_s unit evaluations error at_most ok front auto reason";

/// All rows, comma separated, full precision; an empty field where nothing is known.
///
/// # Errors
///
/// The error of the writer, which no value here causes.
pub fn csv(data: &ChartData) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER.split(' '))?;
    for row in &data.rows {
        writer.write_record(fields(row))?;
    }
    let bytes = writer.into_inner().map_err(csv::IntoInnerError::into_error)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn fields(row: &Row) -> [String; 13] {
    let (names, values): (Vec<&str>, Vec<String>) = row
        .setting
        .0
        .iter()
        .map(|(name, value)| match value {
            Value::Number(number) => (*name, format!("{number:e}")),
            Value::Word(word) => (*name, (*word).to_owned()),
        })
        .unzip();
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:e}"));
    [
        row.stage.name().to_owned(),
        row.method.clone(),
        names.join(" "),
        values.join(" "),
        number(row.seconds),
        row.unit.to_owned(),
        row.evaluations.map_or_else(String::new, |count| count.to_string()),
        number(row.error),
        row.at_most.to_string(),
        row.ok.to_string(),
        row.front.to_string(),
        row.auto.to_string(),
        row.reason.clone().unwrap_or_default(),
    ]
}
