//! The report on several scenes: what follows from all of them, then a chapter on each.

use std::fmt::Write;

use super::markdown::fastest;
use super::{ChartData, Row, Stage, units};

/// Errors that the summary asks for.
const WANTED: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

const ABOUT: &str = "\
# Speed against accuracy

Made by one command from the shipped scenes:

```text
cargo run --release -p assur -- chart fixtures/*.toml --format markdown -o docs/accuracy.md
```

Every method of every stage did the same work; times are medians of runs that took turns in one process, on one machine:
compare them with one another, not with another machine. Errors are the largest deviation from a reference that is better than
what it judges, relative to the largest value of the same quantity. `≤` stands before the reference's own error estimate
where a method comes below it. The tables here have the Pareto fronts; `assur chart SCENE` prints every row.

## Which method when

The fastest method whose error is at most the one at the head of the column.
";

const CHOICE: &str = "
What follows, and what the program does by default:

* **Transfer functions:** the closed forms in f64: as exact as any form in f64, and the fastest for one position; four positions
  side by side (f64x4) cost a good third less for each. Single precision saves nothing here and loses half of the digits.
  Newton's method gives the same digits at some thirty times the cost: it is for groups without closed forms. Numerical
  differentiation is a check and no method: at its best step it keeps 6 or 7 digits (three points) or 8 or 9 (five points), at
  several times the cost.
* **Forces:** `groups`. `newton-euler` builds one system for the whole mechanism: as exact, slower, and independent, so it is the
  check. `virtual-power` is the cheapest where the balancing load alone is wanted.
* **Motion:** `auto` takes `closed-form` where J and M are constant; `quadrature` where J is constant and M depends on
  time alone or on the speed alone; `energy` where the moment depends on the coordinate alone, since it needs the fewest
  evaluations and drifts least (where a position costs next to nothing, as of a crank alone, its own
  quadrature takes up to four times as long as steps in time would); `dopri5` for tolerances looser than 1e-4, `dop853` for
  tighter ones. `radau5` pays where a motor is steep. `uniform` and `rk4` at a fixed step are there to be compared. A
  test holds `auto` to at most three times the evaluations of the best method that meets the tolerance; the table above has
  its times.
* **Flywheel:** the formulas of the textbooks cost one look at the cycle and neglect something (variable inertia, the
  motor's reaction to the speed); the exact flywheel costs the search for the regime, still below a millisecond.
* **Steady regime:** running until it settles is quick where the motor restores the speed within a few cycles, and its
  error is then far below its tolerance; where the motor is weak or the flywheel heavy, what is left can be many times the last change, and
  where nothing restores the speed it never settles. Shooting costs the same everywhere and is exact: the program shoots.
";

/// All chapters under one head.
pub fn report(charts: &[&ChartData], chapters: &str) -> String {
    let mut text = ABOUT.to_owned();
    for stage in Stage::ALL {
        let with: Vec<&&ChartData> = charts.iter().filter(|data| data.of(stage).next().is_some()).collect();
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
    format!("{text}{CHOICE}\n{chapters}")
}

/// What `auto` takes, and its time against the fastest method that meets the tolerance.
fn automatic(charts: &[&ChartData]) -> String {
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
            text += &super::auto::against_best(data, wanted).map_or_else(
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
        line += &fastest(data, stage, wanted)
            .map_or_else(|| " none |".to_owned(), |row| format!(" {} |", cell(row)));
    }
    line + "\n"
}

fn cell(row: &Row) -> String {
    let time = row.seconds.map_or_else(String::new, |seconds| units::time(seconds, false));
    let setting = row.setting.to_string();
    let between = if setting.is_empty() { "" } else { " " };
    format!("`{}`{between}{setting}: {time}", row.method)
}
