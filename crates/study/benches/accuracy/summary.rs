//! The page on all scenes: the fastest method for each accuracy, the choice of `auto`, then a chapter on each.

use std::collections::BTreeSet;
use std::fmt::Write;

use assur_study::chart::{ChartData, Measurement, SettingValue, Stage};

use crate::chapter::{fastest, names};
use crate::units;

/// Errors for which the summary gives the fastest method.
const WANTED: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

const ABOUT: &str = "\
# Speed versus accuracy

Made by one command from the shipped scenes:

```text
cargo bench -p assur-study --bench accuracy
```

Every method of every stage did the same work; times are medians of runs that took turns in one process, on one machine:
compare them with one another, not with another machine. Errors are the largest deviation from a reference that is better than
what it judges, relative to the largest value of the same quantity. `≤` stands before the reference's own error estimate
where a method comes below it. Times that differ by no more than their noise (of each the median deviation of the runs from the median, at least 3 % for the
place in memory) are the same: such methods share the front. The tables here have the Pareto fronts; `assur chart SCENE` prints every row, and
`assur chart SCENE -o x.svg` draws error over time with the front of each stage, here of `fixtures/shaper.toml`:

![Error over time of the methods for the shaper](accuracy.svg)

## Which method when

The fastest method whose error is at most the one at the head of the column. What follows for the choice of a method is said in
[methods.md](../methods.md).
";

/// All chapters under one head.
pub(crate) fn summary(charts: &[ChartData], chapters: &str) -> String {
    let mut text = ABOUT.to_owned();
    for stage in Stage::ALL {
        let with: Vec<&ChartData> = charts.iter().filter(|data| data.of(stage).next().is_some()).collect();
        if with.is_empty() {
            continue;
        }
        let _ = write!(text, "\n### {}\n\n| scene |", stage.heading());
        for wanted in WANTED {
            let _ = write!(text, " {} |", units::short(wanted));
        }
        text += "\n| --- | --- | --- | --- | --- |\n";
        for data in with {
            text += &line(data, stage);
        }
    }
    text += &automatic(charts);
    text += &methods(charts);
    format!("{text}\n{chapters}")
}

/// Every method of every stage: in how many scenes it did the work, was on the front, could not.
fn methods(charts: &[ChartData]) -> String {
    let mut text = "\n### All methods\n\nIn how many scenes each does all of the work, is on the Pareto front, and can't.\n\n\
                    | stage | method | does | on the front | can't |\n| --- | --- | ---: | ---: | ---: |\n"
        .to_owned();
    for stage in Stage::ALL {
        let rows = charts.iter().flat_map(|data| data.of(stage));
        let all: BTreeSet<&str> = rows.map(|row| row.method.as_str()).collect();
        for method in all {
            let scenes = |is: fn(&Measurement) -> bool| {
                let has = |data: &&ChartData| data.of(stage).any(|row| row.method == method && is(row));
                charts.iter().filter(has).count()
            };
            let [there, does, front] = [scenes(|_| true), scenes(|row| row.ok), scenes(|row| row.front)];
            let _ =
                writeln!(text, "| {} | `{method}` | {does} | {front} | {} |", stage.heading(), there - does);
        }
    }
    text
}

/// The choice of `auto`, and its time against the fastest method that meets the tolerance.
fn automatic(charts: &[ChartData]) -> String {
    let with: Vec<_> = charts.iter().filter(|data| data.of(Stage::Motion).any(|row| row.auto)).collect();
    if with.is_empty() {
        return String::new();
    }
    let mut text = "\n### What `auto` takes for the motion\n\nAsked for the tolerance at the head of the column: its method, and its \
                    time over that of the fastest whose error is at most the tolerance.\n\n| scene |"
        .to_owned();
    for wanted in WANTED {
        let _ = write!(text, " {} |", units::short(wanted));
    }
    text += "\n| --- | --- | --- | --- | --- |\n";
    for data in with {
        let _ = write!(text, "| {} |", data.title);
        for wanted in WANTED {
            text += &against_best(data, wanted).map_or_else(
                || " none |".to_owned(),
                |(row, ratio)| format!(" `{}`: {ratio:.2} |", row.method),
            );
        }
        text.push('\n');
    }
    text
}

fn line(data: &ChartData, stage: Stage) -> String {
    let mut line = format!("| {} |", data.title);
    for wanted in WANTED {
        let all = fastest(data, stage, wanted);
        let time = all.first().and_then(|row| row.seconds).map(units::time);
        line += &time.map_or_else(|| " none |".to_owned(), |time| format!(" {}: {time} |", names(&all)));
    }
    line + "\n"
}

/// The choice of `auto` for this tolerance, and its time over that of the fastest row that meets it.
fn against_best(data: &ChartData, tolerance: f64) -> Option<(&Measurement, f64)> {
    let is_asked = |row: &&Measurement| match row.setting.get("tolerance") {
        Some(SettingValue::Number(set)) => (set / tolerance - 1.0).abs() < 1e-6,
        _ => true,
    };
    let own = data.of(Stage::Motion).filter(|row| row.auto).find(is_asked)?;
    let best = *fastest(data, Stage::Motion, tolerance).first()?;
    Some((own, own.seconds? / best.seconds?))
}
