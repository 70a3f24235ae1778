//! Digits and columns.

use super::line::wrap;
use super::{Style, told};
use assur_all as _;
use assur_analysis::results::{Check, Finding};
use assur_analysis::{Calculation, Options, unwatched};
use assur_book::{Column, Table, Unit, row};
use assur_diagram::{PlanSheet, PlanVector, VectorKind, VectorPlan};
use assur_words::{Language, Text, name, number};

fn ascii() -> Style {
    Style { ascii: true, ..Style::english() }
}

#[test]
fn columns_of_words_are_flush_left_and_of_numbers_flush_right() {
    let head = ["pair", "N"].map(name);
    let rows =
        [("A", "1.5"), ("größe", "-12.25")].map(|(word, digits)| row![name(word), number(digits)].to_vec());
    let table = Table::list(Text::default(), head.map(Column::of)).rows(rows);
    let columns = |style| told(style, |page| page.table(table.clone()));
    let plain = columns(Style::english());
    assert_eq!(plain, "pair        N\n-----  ------\nA         1.5\ngröße  -12.25\n");
    assert!(columns(ascii()).contains("groesse  -12.25\n"));
    let russian = Style { language: Language::find("ru").unwrap(), ascii: false };
    assert!(columns(russian).contains("größe  −12,25\n"));
}

#[test]
fn words_break_at_the_width_and_are_never_lost() {
    let words = "word ".repeat(60);
    let text = wrap(&words, 0, 2, 100).join("\n");
    assert!(
        text.lines().all(|line| line.len() <= 100) && text.lines().skip(1).all(|line| line.starts_with("  "))
    );
    assert_eq!(text.split_whitespace().count(), 60);
}

fn check(name: &'static str, left_out: usize, judged: bool, ok: bool) -> Check {
    Check {
        finding: Finding {
            error: 1e-12,
            holds: judged.then_some(ok),
            why: assur_words::name(if left_out > 0 { "too close" } else { "" }),
            ..Finding::within(assur_words::name("link rod"), 1e-9)
        },
        at: Some(3),
        left_out,
        ..Check::of(
            assur_words::name(name),
            assur_words::Text::default(),
            Finding::within(assur_words::Text::default(), 0.0),
        )
    }
}

#[test]
fn what_could_not_be_judged_is_neither_ok_nor_failed_and_is_counted() {
    let rows = [
        check("closure", 0, true, true),
        check("PF1", 2, true, true),
        check("PF2", 2, false, false),
        check("J", 1, true, false),
    ];
    let text = told(Style::english(), |page| crate::topic::checks(&rows, page));
    let words: Vec<_> = text.lines().skip(2).take(4).map(|line| line.rsplit("  ").next().unwrap()).collect();
    assert_eq!(words, ["ok", "ok", "not judged", "FAILED"]);
    let below: Vec<_> = text.lines().skip(6).collect();
    assert_eq!(
        below,
        ["not judged in 2 positions: PF1, PF2: too close", "not judged in 1 position: J: too close"]
    );
    assert_eq!(rows.map(|row| row.finding.failed()), [false, false, false, true]);
}

#[test]
fn a_check_in_json_is_ok_failed_or_null_with_the_reason() {
    let json =
        |row| serde_json::from_str::<serde_json::Value>(&crate::json::to_json(&row, false).unwrap()).unwrap();
    for (judged, ok, wanted, why) in [
        (true, true, serde_json::json!(true), serde_json::Value::Null),
        (true, false, serde_json::json!(false), serde_json::Value::Null),
        (false, false, serde_json::Value::Null, serde_json::json!("too close")),
    ] {
        let row = json(check("PF2", 2, judged, ok));
        assert_eq!((&row["ok"], &row["why"]), (&wanted, &why), "{row}");
        assert_eq!((&row["place"], &row["left_out"]), (&"link rod".into(), &2.into()), "{row}");
    }
}

#[test]
fn a_number_that_is_not_finite_is_found_behind_an_empty_one_and_never_printed() {
    let mut bad = check("PF2", 1, false, false);
    bad.finding.error = f64::NAN;
    let rows = vec![check("PF1", 1, false, false), bad];
    // What a check could not compare is null, and the rest is written.
    assert!(
        crate::json::finite(&rows).is_ok() && serde_json::to_value(&rows[1]).unwrap()["residual"].is_null()
    );
    let nested = std::collections::BTreeMap::from([("a", Some((1, [0.0, f64::INFINITY])))]);
    assert_eq!(crate::json::finite(&nested).unwrap_err().place, "a[1][1]");
    let text = told(Style::english(), |page| crate::topic::checks(&rows, page));
    let residual = text.lines().nth(3).and_then(|line| line.split_whitespace().nth(1));
    assert!(!text.contains("NaN") && residual == Some("-"), "{text}");
}

#[test]
fn a_sample_of_the_positions_is_named() {
    let sampled = |name, sample| Check { sample, ..check(name, 0, true, true) };
    let rows = [
        sampled("closure", Some([360, 1_000_000])),
        sampled("PF1", Some([360, 1_000_000])),
        sampled("loads", Some([360, 1200])),
        sampled("energy", None),
    ];
    let text = told(Style::english(), |page| crate::topic::checks(&rows, page));
    let below: Vec<_> = text.lines().skip(6).collect();
    assert_eq!(below, ["checked in 360 of 1,000,000: closure, PF1", "checked in 360 of 1,200: loads"]);
}

/// The plans of the press, whose velocities are replaced by two vectors.
fn sheet_of(vectors: [[f64; 2]; 2]) -> PlanSheet {
    let mechanism = assur_scene::read("press", assur_fixtures::scene("press")).unwrap();
    let calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    let sheet = calculation.sheet(3).unwrap();
    let item = |(name, end): (&str, [f64; 2])| PlanVector {
        name: assur_words::name(name.to_owned()),
        symbol: assur_words::name(name.to_owned()),
        image: String::new(),
        kind: VectorKind::Load,
        start: [0.0; 2],
        end,
        size: end[0].hypot(end[1]),
        unit: "N".to_owned(),
        note: assur_words::name("load on `arm`"),
    };
    let items = ["one", "other"].into_iter().zip(vectors).map(item).collect();
    let velocities = VectorPlan {
        title: assur_words::name("Two"),
        unit: "N".to_owned(),
        scale: 0.2,
        items,
        ..sheet.velocities
    };
    PlanSheet { velocities, ..sheet }
}

#[test]
fn plans_are_tables_with_directions_that_rounding_does_not_change() {
    let text = told(ascii(), |page| crate::topic::plans(&sheet_of([[1.0, -1e-17], [-1.0, -0.0]]), page));
    let two = &text[..text.find("Plan of accelerations").unwrap()];
    assert!(two.starts_with("Two: unit N, 1 mm = 0.2 N; relative residual "), "{two}");
    assert!(two.contains(" 0.0000 ") && two.contains(" 180.0000 ") && !two.contains("-180"), "{two}");
    assert!(two.contains("  1  N ") && two.contains("load on `arm`"), "{two}");
    let text = told(ascii(), |page| crate::topic::plans(&sheet_of([[0.0, -20.0], [0.0, 20.0]]), page));
    assert!(text.contains("  20  N ") && text.contains(" -90.0000 ") && text.contains(" 90.0000 "), "{text}");
}

#[test]
fn the_plans_of_a_position_have_every_table() {
    let text = told(ascii(), |page| crate::topic::plans(&sheet_of([[1.0, 0.0], [0.0, 1.0]]), page));
    assert!(text.is_ascii());
    for title in [
        "Plan of accelerations: ",
        "Instant centers\n",
        "Force polygon of group 1 (RRP rod, slider): ",
        "Longitudinal reactions: pole of `rod`, balancing force at A: force polygon: ",
        "Zhukovsky's lever",
        "Reactions by cause; ",
    ] {
        assert!(text.contains(title), "{title}\n{text}");
    }
}

#[test]
fn long_lists_and_wide_tables_are_shortened_and_say_so() {
    let list = Table::list(Text::default(), [Column::of(name("pair"))]);
    let text = told(Style::english(), |page| page.table(list.rows(vec![row![name("A")]; 5000])));
    assert!(text.ends_with("\nA\n... 4096 of 5000 rows shown; all are in the other forms (`--format`)\n"));
    assert_eq!(text.lines().count(), 2 + 4096 + 1);
    // Each block of 100 characters has seven columns of these, and a table sixteen blocks.
    let rows = 4096;
    let key = Column::counted(name("No."), vec![1; rows]);
    let wide = Column::numbers(name("a long head"), Unit::JOULE, vec![Some(1.0); rows]);
    let table = Table::over(Text::default(), vec![key], vec![wide; 200]);
    let text = told(Style::english(), |page| page.table(table));
    assert!(
        text.ends_with("... 112 of 200 columns shown; all are in the other forms (`--format`)\n"),
        "{}",
        &text[text.len() - 200..]
    );
}
