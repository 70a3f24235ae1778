//! CSV: one row for each method and setting.

use super::{ChartData, Row, Value};

const HEADER: &str =
    "stage,method,setting,value,seconds_s,unit,evaluations,error,at_most,ok,front,auto,reason";

/// All rows, comma separated, full precision; an empty field where nothing is known.
pub fn csv(data: &ChartData) -> String {
    let mut text = String::from(HEADER);
    text.push('\n');
    for row in &data.rows {
        text += &line(row);
        text.push('\n');
    }
    text
}

fn line(row: &Row) -> String {
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
        quoted(&row.method),
        names.join(" "),
        values.join(" "),
        number(row.seconds),
        row.unit.name().to_owned(),
        row.evaluations.map_or_else(String::new, |count| count.to_string()),
        number(row.error),
        row.at_most.to_string(),
        row.ok.to_string(),
        row.front.to_string(),
        row.auto.to_string(),
        quoted(row.reason.as_deref().unwrap_or_default()),
    ]
    .join(",")
}

/// A field as RFC 4180 wants it.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
