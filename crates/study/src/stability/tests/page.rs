//! Writes `docs/measured/stability.md` from the rows of the bench.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use assur_check::Finding;
use assur_structure::Structure;
use assur_testkit::specimen::{Recipe, kinds};
use assur_words::text;

use super::bench::{MOST_TURNS, sections};
use super::{Section, shipped, walk_group};
use crate::stability::Comparison;

const ABOUT: &str = "\
# Where methods fail

Made by one command from mechanisms and motions that come close to failure:

```text
cargo test -p assur-study -- --ignored write_docs_stability
```

Each method is put at distances from a singular position and compared with a computation in about 32 digits from the same
numbers, or with a closed form. A figure in a table is the number of right decimal digits at the distance at the head of its
column, of the worst number (a shipped scene has all of its walks and numbers in one line); 16 are all that an f64 has. A dash stands where the method refuses: it says that it has no answer. The
*factor* is the largest error over the error that a backward-stable method may have there (the bound of the section): up to 1
the method loses no more than the data themselves lose by their rounding.
";

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/measured/stability.md");

/// Most columns of distances in a table.
const MOST_COLUMNS: usize = 8;

/// One method and quantity on one walk.
#[derive(Default)]
struct Line {
    factor: f64,
    /// By column: the fewest digits; `None` where the method refuses.
    digits: BTreeMap<usize, Option<u32>>,
}

/// Walks of one group of each kind alone towards its singular positions.
fn groups() -> Section {
    let first = |kind: &'static str| {
        let recipe = Recipe { groups: 1, only: Some(kind), loads: false };
        (0..100).find_map(|seed| recipe.specimen(seed))
    };
    let rows = kinds().into_iter().filter_map(first).flat_map(|specimen| {
        let structure = Structure::of(&specimen.mechanism).unwrap();
        let group = &structure.groups[0];
        walk_group::walk(&format!("{} alone", group.plugin.kind), group)
    });
    Section { law: &walk_group::LAW, rows: rows.collect() }
}

/// The distances of a section at the heads of the columns: all, or so many of them at equal steps.
fn columns(rows: &[Comparison]) -> Vec<f64> {
    let mut all: Vec<f64> = rows.iter().map(|row| row.distance).collect();
    all.sort_by(|a, b| b.total_cmp(a));
    all.dedup();
    let step = all.len().div_ceil(MOST_COLUMNS).max(1);
    all.into_iter().step_by(step).collect()
}

fn digits(error: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0 to 16")]
    let digits = (-error.log10()).clamp(0.0, 16.0) as u32;
    digits
}

fn table(section: &Section) -> String {
    let heads = columns(&section.rows);
    let mut lines: BTreeMap<(String, String, &str), Line> = BTreeMap::new();
    for row in &section.rows {
        let line =
            lines.entry((row.finding.place.to_string(), row.method.to_string(), row.quantity)).or_default();
        line.factor = line.factor.max(
            row.finding.number().filter(|error| *error > 0.0).map_or(0.0, |error| error / row.finding.bound),
        );
        let Some(column) = heads.iter().position(|head| head.total_cmp(&row.distance).is_eq()) else {
            continue;
        };
        let found = row.finding.number().map(digits);
        let kept = line.digits.entry(column).or_insert(found);
        *kept = (*kept).zip(found).map(|(a, b)| a.min(b));
    }
    let mut text = "| walk | method | quantity | factor |".to_owned();
    for head in &heads {
        write!(text, " {head:.0e} |").unwrap();
    }
    writeln!(text, "\n| --- | --- | --- | ---: |{}", " ---: |".repeat(heads.len())).unwrap();
    for ((place, method, quantity), line) in lines {
        write!(text, "| {place} | `{method}` | {quantity} | {:.3} |", line.factor).unwrap();
        for column in 0..heads.len() {
            let cell =
                line.digits.get(&column).map(|kept| kept.map_or("–".to_owned(), |kept| kept.to_string()));
            write!(text, " {} |", cell.unwrap_or_default()).unwrap();
        }
        text.push('\n');
    }
    text
}

/// The first refusal of each method, as it says it.
fn refusals(section: &Section) -> String {
    let mut first: BTreeMap<String, (usize, String)> = BTreeMap::new();
    for row in section.rows.iter().filter(|row| row.finding.number().is_none()) {
        let reason = || row.finding.why.to_string();
        first.entry(row.method.to_string()).or_insert_with(|| (0, reason())).0 += 1;
    }
    if first.is_empty() {
        return String::new();
    }
    let mut text = "\nRefusals, each with the first reason as the method says it:\n\n".to_owned();
    for (method, (count, reason)) in first {
        writeln!(text, "* `{method}`, {count} rows: {reason}").unwrap();
    }
    text
}

fn chapter(sections: &[&Section]) -> String {
    let law = sections[0].law;
    let rows = sections.iter().flat_map(|section| &section.rows);
    let (mut all, mut refused, mut worst) = (0, 0, 0.0_f64);
    for row in rows {
        all += 1;
        refused += usize::from(row.finding.number().is_none());
        worst = worst.max(
            row.finding.number().filter(|error| *error > 0.0).map_or(0.0, |error| error / row.finding.bound),
        );
    }
    let mut text = format!(
        "\n## {}\n\n{all} rows, {refused} of them refusals; largest factor {worst:.3}.\n",
        law.section
    );
    for section in sections {
        let law = section.law;
        write!(text, "\n* Distance: {}.\n* Bound: {}.\n\n", text!(law.along), text!(law.expected)).unwrap();
        text += &table(section);
        text += &refusals(section);
    }
    text
}

/// The whole page. Sections of one name make one chapter; `without`: the scenes that have no walk.
fn page(sections: &[Section], without: &[String]) -> String {
    let rows: Vec<&Comparison> = sections.iter().flat_map(|section| &section.rows).collect();
    let failed = rows.iter().filter(|row| row.finding.failed()).count();
    let mut text = ABOUT.to_owned();
    writeln!(
        text,
        "\n{} rows in all: {} keep their bound or refuse where few digits or none could be left, {failed} do not.",
        rows.len(),
        rows.len() - failed
    )
    .unwrap();
    for row in rows.iter().filter(|row| row.finding.failed()) {
        let Finding { place, why, .. } = &row.finding;
        writeln!(text, "\n* {place}, `{}`, {} at {:.0e}: {why}", row.method, row.quantity, row.distance)
            .unwrap();
    }
    let mut names: Vec<&str> = Vec::new();
    for section in sections {
        if !names.contains(&section.law.section) {
            names.push(section.law.section);
            let alike: Vec<_> =
                sections.iter().filter(|other| other.law.section == section.law.section).collect();
            text += &chapter(&alike);
        }
    }
    if !without.is_empty() {
        writeln!(text, "\nWithout a group, and so without a walk: {}.", without.join(", ")).unwrap();
    }
    text
}

#[test]
#[ignore = "writes docs/measured/stability.md"]
fn write_docs_stability() {
    let mut all = vec![groups()];
    all.extend(sections(MOST_TURNS));
    let (shipped, without) = shipped::sections();
    all.extend(shipped);
    std::fs::write(PAGE, page(&all, &without)).unwrap();
}

#[test]
fn digits_of_an_error() {
    assert_eq!([1.0, 0.5, 0.09, 1e-9, 3e-17, 0.0].map(digits), [0, 0, 1, 9, 16, 16]);
}

#[test]
fn the_page_has_a_line_for_each_walk_and_method() {
    let section = groups();
    let mut walks: Vec<_> = section
        .rows
        .iter()
        .map(|row| (row.finding.place.to_string(), row.method.to_string(), row.quantity))
        .collect();
    walks.sort();
    walks.dedup();
    let page = page(&[section], &[]);
    assert_eq!(page.lines().filter(|line| line.starts_with("| ") && line.contains('`')).count(), walks.len());
    assert!(page.contains("0 do not.") && page.contains("Refusals"), "{page}");
}

/// A new fixture or plugin needs a row: the page is written again then.
#[test]
fn the_page_names_the_shipped_scenes_and_the_registered_methods_and_no_others() {
    /// Methods of this crate and of crates without a registry.
    const OWN: [&str; 5] =
        ["closed forms", "differences-2", "differences-4", "general (linear system)", "shooting"];
    let page = std::fs::read_to_string(PAGE).unwrap();
    let quoted = |text: &str| text.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
    let all = quoted(&page.replace("```", "")).into_iter();
    let files: BTreeSet<String> = all.filter(|quoted| quoted.starts_with("fixtures/")).collect();
    let shipped = assur_fixtures::SCENES.iter().map(|(name, _)| format!("fixtures/{name}.toml")).collect();
    assert_eq!(files, shipped);
    let rows = page.lines().filter_map(|line| line.strip_prefix("| ")?.split(" | ").nth(1));
    let methods: BTreeSet<String> = rows.flat_map(quoted).collect();
    // A link that is driven against another one has a position for each coordinate.
    let solved = assur_group::groups().unwrap().into_iter().filter(|plugin| plugin.name != "driven-link");
    let groups = solved.map(|plugin| plugin.name);
    let analyzers = assur_force::analyzers().unwrap().into_iter();
    let analyzers = analyzers.filter(|plugin| plugin.gives_reactions).map(|plugin| plugin.name);
    let integrators = assur_integrator::integrators().unwrap().into_iter().map(|plugin| plugin.name);
    let registered = groups.chain(analyzers).chain(integrators).chain(OWN).map(str::to_owned).collect();
    assert_eq!(methods, registered);
}
