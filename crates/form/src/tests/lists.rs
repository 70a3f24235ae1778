//! Rows and grids.

use assur_fixtures::scene;

use super::{key, of, read, reads, shaper, typing};
use crate::{deleted, inserted, masses, rod, rows};

const FORWARD: &str = "force[0].value.forward";

#[test]
fn rows_of_the_cutting_force_are_its_curve() {
    let found = rows(shaper(), &key("force.cutting.value.forward")).unwrap();
    assert_eq!(found.at, key(FORWARD));
    assert_eq!(found.curve, [[0.05, 0.0], [0.05, 1500.0], [0.95, 1500.0], [0.95, 0.0]]);
    assert_eq!(found.columns.each_ref().map(|column| column.unit), ["", "N"]);
    assert_eq!(found.columns[1].what.to_string(), "a force");
    assert_eq!((found.rows.len(), found.rows[2][0].shown().as_str()), (4, "0.95"));
    // A number holds over the whole stroke.
    let back = rows(shaper(), &key("force[0].value.back")).unwrap();
    assert!(back.rows.is_empty());
    assert_eq!(back.curve, [[0.0, 0.0], [1.0, 0.0]]);
    assert!(rows(shaper(), &key("force[0].at")).is_none());
}

#[test]
fn a_number_of_a_row_is_put_like_any_other() {
    let text = reads(typing(shaper(), "force[0].value.forward[1][1]", "1.2 kN"));
    assert!(text.contains("forward = [[0.05, 0], [0.05, \"1.2 kN\"], [0.95, 1500], [0.95, 0]]"));
    let curve = rows(&text, &key(FORWARD)).unwrap().curve;
    assert_eq!(curve[1..2], [[0.05, 1200.0]]);
    // A column over the angle is in degrees here.
    let field = of(scene("flywheel"), "moment[0].value.table[1][0]");
    assert_eq!((field.unit, field.own_unit().as_str()), ("rad", "deg"));
}

#[test]
fn rows_are_inserted_and_deleted() {
    let written = |text: &str| {
        let line = text.lines().find(|line| line.contains("forward")).unwrap();
        line.split_once("forward = ").unwrap().1.split(", back").next().unwrap().to_owned()
    };
    let text = reads(inserted(shaper(), &key(FORWARD), 2));
    assert_eq!(written(&text), "[[0.05, 0], [0.05, 1500], [0.5, 1500], [0.95, 1500], [0.95, 0]]");
    let text = reads(deleted(&text, &key(FORWARD), 0));
    assert_eq!(written(&text), "[[0.05, 1500], [0.5, 1500], [0.95, 1500], [0.95, 0]]");
    let text = reads(inserted(&text, &key(FORWARD), 9));
    assert_eq!(written(&text), "[[0.05, 1500], [0.5, 1500], [0.95, 1500], [0.95, 0], [0.95, 0]]");
    // A number becomes two rows with it.
    let text = reads(inserted(shaper(), &key("force[0].value.back"), 0));
    assert!(text.contains("back = [[0, 0], [1, 0]]"));
    // Halfway in the unit of the rows, and one more step behind the last.
    let text = reads(inserted(scene("flywheel"), &key("moment[0].value.table"), 1));
    assert!(text.contains("[[0, 0], [\"90 deg\", 0], [\"180 deg\", 40], [\"360 deg\", 0]]"), "{text}");
    let text = inserted(scene("excavator"), &key("input[0].over_time.table"), 5).text;
    assert!(text.contains("[\"6 s\", \"1701 mm\"], [\"7.5 s\", \"1701 mm\"]]"), "{text}");
    // The last row goes with its key, which the table needs.
    let mut text = scene("flywheel").to_owned();
    for _ in 0..2 {
        text = reads(deleted(&text, &key("moment[0].value.table"), 0));
    }
    let last = deleted(&text, &key("moment[0].value.table"), 0);
    assert!(last.here.unwrap().message.to_string().contains("`table`"));
}

#[test]
fn a_curve_has_the_shape_of_its_rows() {
    let steps = rows(scene("rolling-press"), &key("moment[0].value.table")).unwrap().curve;
    let [first, corner, last] = steps[..] else { panic!("{steps:?}") };
    assert_eq!([first[1], corner[1], last[1]].map(|y| y.to_string()), ["0", "0", "-20"]);
    assert_eq!(corner[0].to_bits(), last[0].to_bits());
    // A spline passes through its rows, 0.25 s apart.
    let spline = rows(scene("five-bar"), &key("input[0].over_time.table")).unwrap();
    assert!(spline.curve.len() > 4 * spline.rows.len());
    let at = |time: f64| {
        spline.curve.iter().find(|point| (point[0] - time).abs() < 1e-12).unwrap()[1].to_degrees()
    };
    assert!((at(0.75) - 129.82).abs() < 1e-9 && (at(2.0) - 110.94).abs() < 1e-9);
}

#[test]
fn the_masses_of_all_links_are_one_table() {
    let grid = masses(shaper());
    assert_eq!(grid.columns.iter().map(|column| column.0).collect::<Vec<_>>(), ["mass", "center", "inertia"]);
    let shown: Vec<_> = grid
        .rows
        .iter()
        .map(|row| {
            (row.link.as_str(), row.fields.iter().map(crate::Field::shown).collect::<Vec<_>>().join("; "))
        })
        .collect();
    assert_eq!(
        shown,
        [
            ("crank", "4 kg; O; 0.04 kg*m^2".to_owned()),
            ("stone2", "1.5 kg; ; 0.002 kg*m^2".to_owned()),
            ("rocker", "12 kg; S3; 0.6 kg*m^2".to_owned()),
            ("stone4", "1.2 kg; ; 0.0015 kg*m^2".to_owned()),
            ("ram", "30 kg; [0.1, 0.02]; 0.9 kg*m^2".to_owned()),
        ]
    );
    let text = reads(crate::put(shaper(), &grid.rows[4].fields[1], "E"));
    assert_eq!(read(&text).links[5].center.map(f64::to_bits), [0, 0]);
}

#[test]
fn a_rod_has_its_inertia_from_its_length() {
    // 0.7 m of 7.8 kg/m: 5.46 kg, and 5.46 * 0.49 / 12 = 0.22295 kg m^2.
    let text = reads(rod(shaper(), "rocker", 7.8));
    assert!(text.contains("mass = \"5.46 kg\"\ncenter = [0.35, 0]\ninertia = \"0.22295 kg*m^2\""), "{text}");
    // Between E (0, 0) and K (0.25, -0.05): a length of sqrt(0.065), a mass of 2 sqrt(0.065), J = m 0.065 / 12.
    let link = &read(&reads(rod(shaper(), "ram", 2.0))).links[5];
    let mass = 2.0 * 0.065_f64.sqrt();
    assert!(
        (link.mass - mass).abs() < 1e-14 && (link.inertia.constant() - mass * 0.065 / 12.0).abs() < 1e-15
    );
    assert_eq!(link.center.map(|at| at.to_string()), ["0.125", "-0.025"]);
    // It does not need the rest of the scene to be right.
    let faulty = shaper().replace("[input]", "[output]");
    assert!(rod(&faulty, "crank", 10.0).text.contains("mass = \"1 kg\""));
    let refused = rod(shaper(), "stone2", 7.8);
    assert_eq!(refused.text, shaper());
    assert!(refused.here.unwrap().message.to_string().contains("`stone2`"));
}
