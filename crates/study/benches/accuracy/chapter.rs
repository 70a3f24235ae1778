//! The chart of a scene as a chapter in Markdown, with what follows from it in words.

use std::fmt::Write;

use assur_report::text::{Style, told};
use assur_study::chart::{ChartData, Measurement, Stage};
use assur_words::Describe;

use crate::units;

/// Errors for which the fastest method is reported.
const WANTED: [f64; 5] = [1e-2, 1e-4, 1e-6, 1e-9, 1e-12];

/// A chapter on one scene; its tables have the Pareto front only.
pub(crate) fn chapter(data: &ChartData, file: &str) -> String {
    let mut text = format!("## {} (`{file}`)\n", data.title);
    for stage in Stage::ALL {
        if data.of(stage).next().is_none() {
            continue;
        }
        let _ = write!(text, "\n### {}\n\n", stage.heading());
        for sentence in words(data, stage) {
            let _ = writeln!(text, "* {sentence}");
        }
        let drawn = told(Style::english(), |page| data.tell_stage(stage, |row| row.front, page));
        let _ = write!(text, "\n```text\n{drawn}```\n");
    }
    text
}

/// Conclusions on a stage, in sentences: the fastest method for each accuracy, and the failures.
fn words(data: &ChartData, stage: Stage) -> Vec<String> {
    let mut said: Vec<String> = Vec::new();
    let mut last: Option<&Measurement> = None;
    for wanted in WANTED {
        let all = fastest(data, stage, wanted);
        let best = all.first().copied();
        match best {
            Some(row) if last.is_some_and(|last| std::ptr::eq(last, row)) => {
                if let Some(line) = said.last_mut() {
                    *line = sentence(&all, wanted, stage);
                }
            }
            Some(_) => said.push(sentence(&all, wanted, stage)),
            None => {
                said.push(format!("No method has an error below {}.", units::short(wanted)));
                break;
            }
        }
        last = best;
    }
    said.extend(failures(data, stage));
    said
}

/// The fastest row of a stage with an error of at most `wanted`, and behind it those that are as fast within the noise of the times.
pub(crate) fn fastest(data: &ChartData, stage: Stage, wanted: f64) -> Vec<&Measurement> {
    let good = |row: &&Measurement| row.whole() && row.point().is_some_and(|(_, error)| error <= wanted);
    let time = |row: &Measurement| row.seconds.unwrap_or(f64::INFINITY);
    let noise = |row: &Measurement| row.noise.unwrap_or_default();
    let mut all: Vec<&Measurement> = data.of(stage).filter(good).collect();
    all.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let Some(&best) = all.first() else { return all };
    all.retain(|row| time(row) - time(best) <= noise(row) + noise(best));
    all
}

/// The methods of rows that are equally fast, each with its setting.
pub(crate) fn names(rows: &[&Measurement]) -> String {
    let name = |row: &&Measurement| {
        let setting = row.setting.describe().to_string();
        let between = if setting.is_empty() { "" } else { " " };
        format!("`{}`{between}{setting}", row.method)
    };
    rows.iter().map(name).collect::<Vec<_>>().join(" or ")
}

fn sentence(rows: &[&Measurement], wanted: f64, stage: Stage) -> String {
    let (row, [is, name]) = (rows[0], [if rows.len() > 1 { "are" } else { "is" }, &names(rows)]);
    let (seconds, error) = row.point().unwrap_or_default();
    format!(
        "Error of {} or less: {name} {is} the fastest, {} for {}, error {}.",
        units::short(wanted),
        units::time(seconds),
        stage.work(),
        units::error(error, row.at_most),
    )
}

/// Methods without any row that did all of the work, each with its first reason.
fn failures(data: &ChartData, stage: Stage) -> Vec<String> {
    let mut names: Vec<&str> = Vec::new();
    let mut said = Vec::new();
    for row in data.of(stage) {
        if names.contains(&row.method.as_str()) {
            continue;
        }
        names.push(&row.method);
        if data.of(stage).any(|other| other.method == row.method && other.ok) {
            continue;
        }
        said.push(format!(
            "`{}` can't: {}.",
            row.method,
            row.reason.as_ref().map_or_else(|| "it gives no result".to_owned(), ToString::to_string)
        ));
    }
    said
}
