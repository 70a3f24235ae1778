//! Numbers and lengths of the note, against the JSON of the same results.

use assur_report::json::analysis::to_json;
use serde_json::Value;

use super::{Form, of, results, written};

/// A table of the note: its caption, its head and its rows.
struct Table {
    caption: String,
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

fn between<'t>(text: &'t str, open: &str, close: &str) -> Vec<&'t str> {
    text.split(open).skip(1).filter_map(|rest| rest.split_once(close)).map(|(inner, _)| inner).collect()
}

/// A text of the note without its tags.
fn plain(html: &str) -> String {
    let parts = html.split('<').enumerate();
    parts
        .map(|(at, part)| if at == 0 { part } else { part.split_once('>').map_or("", |(_, text)| text) })
        .collect()
}

fn tables(html: &str) -> Vec<Table> {
    let table = |text: &str| {
        let cells = |row: &str, tag: &str| -> Vec<String> {
            let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
            between(row, &open, &close).into_iter().map(|cell| plain(&format!("<{cell}"))).collect()
        };
        let rows = between(text, "<tr>", "</tr>");
        Table {
            caption: plain(between(text, "<caption>", "</caption>")[0]),
            head: cells(rows[0], "th"),
            rows: rows[1..].iter().map(|row| cells(row, "td")).collect(),
        }
    };
    between(html, "<table", "</table>")
        .into_iter()
        .filter(|text| text.contains("<caption>"))
        .map(table)
        .collect()
}

/// The number of a cell, and half a unit of its last digit.
fn read(cell: &str) -> (f64, f64) {
    let text: String = cell.replace('−', "-").chars().filter(|c| "+-0123456789.".contains(*c)).collect();
    let decimals = text.split_once('.').map_or(0, |(_, part)| part.len());
    (text.parse().unwrap_or_else(|_| panic!("{cell}")), 0.5 * 10_f64.powi(-i32::try_from(decimals).unwrap()))
}

#[track_caller]
fn same(cell: &str, value: &Value) {
    // What is not there, or zero but for rounding.
    if cell == "–" {
        assert!(value.as_f64().is_none_or(|value| value.abs() < 1e-12), "{value}");
        return;
    }
    let ((found, half), value) = (read(cell), value.as_f64().unwrap());
    assert!((found - value).abs() <= half * (1.0 + 1e-6), "{cell} is not {value}");
}

/// The rows of a table whose caption has some words, each with the number of its position; none where there is no such table.
fn rows<'t>(tables: &'t [Table], words: &str) -> Vec<(usize, &'t [String])> {
    let Some(table) = tables.iter().find(|table| table.caption.contains(words)) else { return Vec::new() };
    let column = table.head.iter().position(|head| head == "No.").unwrap();
    table.rows.iter().map(|cells| (cells[column].parse().unwrap(), cells.as_slice())).collect()
}

/// Compares the tables over positions of a note with the JSON; returns how many numbers there were.
fn compare_positions(tables: &[Table], positions: &Value) -> usize {
    let mut compared = 0;
    let mut compare = |cell: &str, value: &Value| {
        same(cell, value);
        compared += 1;
    };
    for (position, cells) in rows(tables, "accelerations of the points") {
        let row = &positions[position];
        let [v, a] = ["velocities", "accelerations"].map(|key| &row[key]["points"][&cells[0]]);
        for (cell, value) in [(3, &v[0]), (4, &v[1]), (6, &a[0]), (7, &a[1])] {
            compare(&cells[cell], value);
        }
    }
    for (position, cells) in rows(tables, "accelerations (ε) of the links") {
        let row = &positions[position];
        compare(&cells[3], &row["velocities"]["links"][&cells[0]]);
        compare(&cells[4], &row["accelerations"]["links"][&cells[0]]);
    }
    for (position, cells) in rows(tables, "Reactions of the pairs") {
        let (pair, link) = cells[0].split_once(" on ").unwrap();
        let force = &positions[position]["reactions"][pair][link];
        compare(&cells[3], &force[0]);
        compare(&cells[4], &force[1]);
    }
    for (position, cells) in rows(tables, "maintains the motion of the mechanism") {
        compare(&cells[2], &positions[position]["balancing"]);
    }
    compared
}

#[test]
fn the_numbers_of_the_note_are_those_of_the_json() {
    for (scene, least) in
        [("shaper-drive", 80), ("press", 30), ("shaper-friction", 40), ("triad", 40), ("brake", 3)]
    {
        let results = results(scene);
        let tables = tables(&written(&results, "en", Form::Html).text);
        let json = to_json(&results.found.as_ref().unwrap().analysis, false).unwrap();
        let json: Value = serde_json::from_str(&json).unwrap();
        let positions = if results.samples().is_some() { "trajectory" } else { "positions" };
        let mut compared = compare_positions(&tables, &json[positions]);
        let regime = tables.iter().find(|table| table.caption.ends_with("The regime"));
        for (what, key) in [
            ("mean speed", "mean_speed"),
            ("unevenness", "unevenness"),
            ("required power", "required_power"),
            ("gear ratio", "ratio"),
            ("moment of inertia of the flywheel", "flywheel"),
        ] {
            let Some(regime) = regime else { continue };
            assert_eq!(regime.head, ["Quantity", "Value", "Unit", "At"]);
            let row = regime.rows.iter().find(|row| row[0] == what).unwrap();
            same(&row[1], &json["dynamics"][key]);
            compared += 1;
        }
        assert_eq!(regime.is_some(), scene == "shaper-drive", "{scene}");
        let first = tables.iter().find(|table| table.caption.ends_with("Main results")).unwrap();
        let last = json[positions].as_array().and_then(|rows| rows.last()).unwrap();
        for (what, key) in
            [("time of the end of the motion", "time"), ("speed at the end of the motion", "speed")]
        {
            let row = first.rows.iter().find(|row| row[0] == what);
            if let Some(row) = row {
                same(&row[1], &last[key]);
                compared += 1;
            }
            assert_eq!(row.is_some(), scene == "brake", "{scene}: {what}");
        }
        assert!(compared >= least, "{scene}: {compared}");
    }
}

/// Lengths of the straight lines of a drawing, mm.
fn lengths(svg: &str) -> Vec<f64> {
    let ends = between(svg, "<polyline points=\"", "\"").into_iter().filter_map(|points| {
        let numbers: Vec<f64> = points.split([' ', ',']).map(|number| number.parse().unwrap()).collect();
        <[f64; 4]>::try_from(numbers).ok()
    });
    ends.map(|[a, b, c, d]| (c - a).hypot(d - b)).collect()
}

#[test]
fn a_length_on_paper_times_its_scale_is_the_true_one() {
    let html = of("shaper-drive", "en", Form::Html).text;
    let tables = tables(&html);
    let mut measured = 0;
    for figure in between(&html, "<figure>", "</figure>") {
        let caption = plain(between(figure, "<figcaption>", "</figcaption>")[0]);
        let Some((title, _)) = caption.split_once(". ").unwrap().1.split_once(": position") else { continue };
        let Some(table) = tables.iter().find(|table| table.caption.ends_with(&format!("{title}: vectors")))
        else {
            continue;
        };
        let texts = plain(figure);
        let scales: Vec<f64> = texts
            .split("μ")
            .skip(1)
            .map(|text| text.split(" = ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap())
            .collect();
        assert_eq!(scales.len(), 2, "{texts}");
        let drawn = lengths(figure);
        for row in &table.rows {
            let scale = scales[usize::from(row[0] == "27")];
            let (force, half) = read(&row[4]);
            // Places are written to a hundredth of a millimeter.
            let matches =
                drawn.iter().filter(|length| (*length * scale - force).abs() <= 0.015 * scale + half);
            assert!(matches.count() > 0, "{caption}: {row:?}, scale {scale}");
            measured += 1;
        }
    }
    assert!(measured > 20, "{measured}");
}

#[test]
fn the_mass_of_the_link_of_reduction_is_that_of_links_flywheel_and_rotor() {
    let html = of("shaper-drive", "en", Form::Html).text;
    let results = results("shaper-drive");
    let json: Value =
        serde_json::from_str(&to_json(&results.found.as_ref().unwrap().analysis, false).unwrap()).unwrap();
    let figures = between(&html, "<figure>", "</figure>");
    let figure = figures.into_iter().find(|figure| figure.contains("The reduction link")).unwrap();
    let text = plain(figure);
    let masses: Vec<f64> =
        text.split(", m ").skip(1).filter_map(|rest| rest.split_once(" kg")?.0.parse().ok()).collect();
    assert!(!masses.is_empty(), "{text}");
    // J/r² with the crank's r = 100 mm.
    let positions = json["positions"].as_array().unwrap();
    let of_drive = |key: &str| json["dynamics"][key].as_f64().unwrap();
    let rotor = json["dynamics"]["motor"]["inertia"].as_f64().unwrap();
    let shaft = of_drive("flywheel") + of_drive("ratio") * of_drive("ratio") * rotor;
    let wanted = |row: &Value| (row["reduced"]["inertia"].as_f64().unwrap() + shaft) / 0.01;
    for mass in masses {
        let is_one = positions.iter().any(|row| (mass / wanted(row) - 1.0).abs() < 1e-4);
        assert!(is_one, "{mass}");
    }
}

#[test]
fn the_values_of_a_legend_say_their_position() {
    let html = of("shaper-drive", "en", Form::Html).text;
    let figures = between(&html, "<figure>", "</figure>");
    let captions: Vec<String> =
        figures.iter().map(|figure| plain(between(figure, "<figcaption>", "</figcaption>")[0])).collect();
    let of = |words: &str| captions.iter().filter(|caption| caption.contains(words)).collect::<Vec<_>>();
    let reactions = of("Reactions of the pairs over the cycle");
    // Seven pairs, four in a figure.
    assert_eq!(reactions.len(), 2, "{captions:?}");
    assert!(
        reactions.iter().all(|caption| caption.contains("values in the legend: position ")),
        "{reactions:?}"
    );
    assert!(of("Balancing load over the cycle, N·m").len() == 1, "{captions:?}");
}
