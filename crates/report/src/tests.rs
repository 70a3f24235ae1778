//! Forms of the results: what is written reads back, and nothing wrong is written silently.

use std::sync::Arc;

use crate::csv::{Cell, CsvError, to_csv, write};
use crate::json::to_json;
use crate::to_ascii;
use assur_analysis::results::{
    Analysis, InputReport, Named, PairReaction, PointMotion, PositionResult, ScalarMotion, StructureReport,
};

fn named<T>(name: &str, value: T) -> Named<T> {
    [(Arc::from(name), value)].into_iter().collect()
}

fn analysis(angle: f64) -> Analysis {
    let reaction = PairReaction {
        forces: vec![(Arc::from("ram"), [1.0, -2.0]), (Arc::from("ground"), [-1.0, 2.0])],
        moment: Some(0.5),
        offset: Some(0.25),
    };
    let position = PositionResult {
        index: 0,
        coordinate: 0.1 + 0.2,
        speed: None,
        acceleration: None,
        links: named("größe", ScalarMotion { pf0: angle, pf1: 1.0, pf2: 0.0 }),
        points: named("A", PointMotion { pf0: [1e-300, 2.0 / 3.0], ..PointMotion::default() }),
        slides: Named::default(),
        velocities: None,
        accelerations: None,
        reduced: None,
        reactions: Some(named("ram/ground", reaction)),
        balancing: Some(3.0),
        by_cause: None,
        condition: named("0", 2.0),
    };
    Analysis {
        format: Analysis::FORMAT,
        title: "a \"title\", with Ж and 🦀".to_owned(),
        input: InputReport { link: "crank".to_owned(), angular: true, balancing_is_moment: true },
        structure: StructureReport {
            mobility: 1,
            mobility_by_rank: None,
            note: None,
            class: 2,
            formula: String::new(),
            moving_links: 1,
            pairs: 1,
            groups: Vec::new(),
        },
        positions: vec![position],
        failures: Vec::new(),
        trajectory: Vec::new(),
        dynamics: None,
        integration: None,
        no_motion: None,
        notes: Vec::new(),
        cycle: assur_analysis::results::Cycle::default(),
        checks: Vec::new(),
    }
}

#[test]
fn json_has_the_shapes_of_the_contract_and_all_digits() {
    let text = to_json(&analysis(1.5), false).unwrap();
    let read: serde_json::Value = serde_json::from_str(&text).unwrap();
    let position = &read["positions"][0];
    assert_eq!(position["coordinate"].as_f64().map(f64::to_bits), Some((0.1_f64 + 0.2).to_bits()));
    assert_eq!(position["points"]["A"]["pf0"], serde_json::json!([1e-300, 2.0 / 3.0]));
    let reaction = serde_json::json!({ "ram": [1.0, -2.0], "ground": [-1.0, 2.0], "moment": 0.5 });
    assert_eq!(position["reactions"]["ram/ground"], reaction);
    let absent = ["speed", "acceleration", "velocities", "accelerations", "reduced"];
    assert!(absent.iter().all(|key| position.get(key).is_none()));
    assert!(["failures", "trajectory", "dynamics", "checks"].iter().all(|key| read.get(key).is_none()));
}

#[test]
fn ascii_json_reads_back_the_same() {
    let (plain, ascii) = (to_json(&analysis(1.5), false).unwrap(), to_json(&analysis(1.5), true).unwrap());
    assert!(ascii.is_ascii() && !plain.is_ascii());
    let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    assert_eq!(read(&plain), read(&ascii));
}

#[test]
fn numbers_that_are_not_finite_are_never_written() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let fault = to_json(&analysis(bad), false).unwrap_err().to_string();
        assert!(fault.contains("`positions[0].links.größe.pf0` is not finite"), "{fault}");
        let fault = to_csv(&analysis(bad), false).unwrap_err().to_string();
        assert!(fault.contains("`positions[0].links.größe.pf0` is not finite"), "{fault}");
        let fault = write(&["a", "b"], [[Cell::Empty, Cell::Number(bad)]], false).unwrap_err();
        assert!(matches!(&fault, CsvError::NotFinite { column, row: 1 } if column == "b"), "{fault}");
        let scene = assur_scene::read("shaper", assur_fixtures::scene("shaper")).unwrap();
        let fault = crate::text::report(&analysis(bad), &scene, false).unwrap_err();
        assert_eq!(fault.place, "positions[0].links.größe.pf0");
    }
}

#[test]
fn csv_reads_back() {
    let files = to_csv(&analysis(1.5), false).unwrap();
    assert_eq!(files.iter().map(|file| file.name).collect::<Vec<_>>(), ["positions.csv", "reactions.csv"]);
    let mut reader = ::csv::Reader::from_reader(files[0].text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let row = reader.records().next().unwrap().unwrap();
    let cell =
        |name: &str| row[header.iter().position(|found| found == name).unwrap()].parse::<f64>().unwrap();
    assert_eq!(cell("coordinate_rad").to_bits(), (0.1_f64 + 0.2).to_bits());
    assert_eq!(cell("A_x_m").to_bits(), 1e-300_f64.to_bits());
    assert_eq!(cell("A_y_m").to_bits(), (2.0_f64 / 3.0).to_bits());
    assert!(files[1].text.starts_with("index,coordinate_rad,balancing_Nm,ram/ground_ram_fx_N,"));
}

#[test]
fn ascii_spells_signs_and_letters() {
    assert_eq!(to_ascii("kg·m², 5°"), "kg*m^2, 5 deg");
    assert_eq!(to_ascii("Жёлтый Щит"), "Zheltyy Shchit");
    assert_eq!(to_ascii("漢 crank"), "? crank");
}

#[test]
fn columns_are_harmless_and_have_one_name_each() {
    let cells = [Cell::Number(1.0), Cell::Text("-sum(A1)"), Cell::Number(3.0), Cell::Empty];
    let text = write(&["=a", "b", "ä", "ae"], [cells], true).unwrap();
    assert_eq!(text, "_=a,b,ae,ae_2\n1,_-sum(A1),3,\n");
}
