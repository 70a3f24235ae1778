//! The forms of a chart: JSON, CSV, text; rows of methods that can't.

use super::scenes::charted;
use crate::chart::run::front;
use crate::chart::{ChartData, Stage, csv, figure, time};
use assur_figure::{Frame, Item};
use assur_report::json::to_json;
use assur_report::text::{Style, told};
use assur_words::Describe;
use proptest::prelude::*;

fn json(data: &ChartData) -> serde_json::Value {
    serde_json::from_str(&to_json(data, false).unwrap()).unwrap()
}

#[test]
fn json_has_the_shape_of_the_contract() {
    let value = json(&charted("slider-crank"));
    let rows = value["rows"].as_array().unwrap();
    for row in rows {
        assert!(["kinematics", "forces"].contains(&row["stage"].as_str().unwrap()));
        assert!(row["setting"].is_object() && row["ok"].is_boolean());
        assert!(["position", "run"].contains(&row["unit"].as_str().unwrap()));
        if row["ok"] == true {
            assert!(row["seconds"].as_f64().unwrap() > 0.0 && row["error"].as_f64().unwrap() >= 0.0, "{row}");
            assert!(row["evaluations"].is_u64() && row["reason"].is_null());
        } else {
            assert!(!row["reason"].as_str().unwrap().is_empty());
        }
    }
    assert!(value["reference"]["kinematics"].as_str().unwrap().contains("double-double"));
    assert!(value["reference_error"]["forces"].as_f64().unwrap() < 1e-15);
    let named = |method: &str| rows.iter().filter(|row| row["method"] == method && row["ok"] == true).count();
    for method in ["closed-form", "newton", "differences-2", "groups", "newton-euler", "longitudinal"] {
        assert!(named(method) > 0, "{method}");
    }
}

#[test]
fn a_method_that_cannot_keeps_its_row_and_says_why() {
    let data = charted("shaper-drive");
    let of = |stage, method: &str| data.of(stage).find(|row| row.method == method).unwrap();
    let longitudinal = of(Stage::Forces, "longitudinal");
    assert!(!longitudinal.ok && longitudinal.error.is_none() && longitudinal.seconds.is_none());
    assert!(longitudinal.reason.as_ref().unwrap().to_string().contains("2 groups"), "{longitudinal:?}");
    let energy = of(Stage::Motion, "energy");
    assert!(energy.reason.as_ref().unwrap().to_string().contains("M(q, w)"), "{energy:?}");
    // The smallest steps need more than are allowed here.
    let many = data.of(Stage::Motion).filter(|row| row.method == "rk4").last().unwrap();
    assert!(
        many.reason.as_ref().unwrap().to_string().contains("steps, the most that are allowed"),
        "{many:?}"
    );
}

#[test]
fn every_stage_of_a_scene_is_there() {
    let stages = |name: &str| {
        let data = charted(name);
        Stage::ALL.into_iter().filter(|stage| data.of(*stage).next().is_some()).collect::<Vec<_>>()
    };
    assert_eq!(
        stages("shaper-drive"),
        Stage::ALL.into_iter().filter(|stage| *stage != Stage::Friction).collect::<Vec<_>>()
    );
    assert_eq!(stages("shaper-friction"), [Stage::Kinematics, Stage::Forces, Stage::Friction]);
    assert_eq!(stages("press"), [Stage::Kinematics, Stage::Forces]);
    assert_eq!(stages("andrews"), [Stage::Kinematics, Stage::Forces, Stage::Motion]);
    assert_eq!(stages("flywheel"), [Stage::Forces, Stage::Motion, Stage::Flywheel, Stage::Steady]);
}

#[test]
fn the_exact_flywheel_is_exact_and_the_textbooks_are_not() {
    let data = charted("shaper-drive");
    for row in data.of(Stage::Flywheel) {
        let error = row.error.unwrap();
        assert!(if row.method == "exact" { error < 1e-8 } else { error > 1e-3 }, "{row:?}");
    }
    // E example 2 is what the textbooks are made for.
    for row in charted("flywheel").of(Stage::Flywheel) {
        assert!(row.error.unwrap() < 1e-9, "{row:?}");
    }
}

#[test]
fn a_time_has_three_digits_and_the_unit_that_suits_it() {
    let told = [215e-9, 3.456e-5, 1.2e-3, 0.0999, 12.34].map(|seconds| time(seconds).to_string());
    assert_eq!(told, ["215 ns", "34.6 µs", "1.20 ms", "99.9 ms", "12.3 s"]);
}

#[test]
fn text_and_csv() {
    let data = charted("press");
    let plain = told(Style { ascii: true, ..Style::english() }, |page| data.tell(page));
    assert!(plain.is_ascii(), "{plain}");
    for word in ["relative error", "time of one position", "closed-form", "Pareto front", "Reference:"] {
        assert!(plain.contains(word), "{word}\n{plain}");
    }
    assert!(
        plain.lines().filter(|line| line.contains(" |")).all(|line| line.chars().count() <= 100),
        "{plain}"
    );
    // Numbers of the error stand at powers of ten, at every fifth at least.
    for drawn in plain.split("relative error over time").skip(1) {
        let rows = drawn
            .lines()
            .filter_map(|line| Some(line.split_once('|')?.0.trim()))
            .filter(|told| !told.is_empty());
        let decades: Vec<i32> = rows.map(|told| told.strip_prefix("1e").unwrap().parse().unwrap()).collect();
        assert!(
            decades.len() >= 2 && decades.windows(2).all(|two| (1..=5).contains(&(two[0] - two[1]))),
            "{plain}"
        );
    }
    let table = csv(&data).unwrap();
    assert_eq!(table.lines().count(), data.rows.len() + 1);
}

#[test]
fn who_does_a_part_of_the_work_is_not_on_the_front() {
    let data = charted("press");
    let row = data.of(Stage::Forces).find(|row| row.method == "virtual-power").unwrap();
    assert!(row.ok && row.error.unwrap() < 1e-12 && !row.whole() && !row.front, "{row:?}");
    assert_eq!(row.setting.describe().to_string(), "f64, balancing load only");
    assert!(data.of(Stage::Forces).any(|row| row.front));
}

#[test]
fn a_figure_holds_every_point() {
    let data = charted("press");
    let panels = figure(&data).panels;
    assert_eq!(panels.len(), 2, "kinematics and forces");
    for (panel, stage) in panels.iter().zip([Stage::Kinematics, Stage::Forces]) {
        let Frame::Axes { x, y, .. } = &panel.frame else { panic!("{:?}", panel.frame) };
        let signs = panel.items.iter().filter_map(|item| match item {
            Item::Sign { at, .. } => Some(*at),
            _ => None,
        });
        let mut count = 0;
        for at in signs {
            assert!(x.range[0] <= at[0] && at[0] <= x.range[1] && y.range[0] <= at[1] && at[1] <= y.range[1]);
            count += 1;
        }
        assert_eq!(count, data.of(stage).filter(|row| row.point().is_some()).count());
    }
}

#[test]
fn the_front_of_known_points() {
    // Fast and rough, middling, beaten by the middling one, slow and exact, equal to the first, beaten by the exact one.
    let points = [(1.0, 9.0), (3.0, 4.0), (4.0, 4.0), (8.0, 1.0), (1.0, 9.0), (9.0, 2.0)];
    let of = |noise: f64| points.map(|(time, error)| [time, noise, error]);
    assert_eq!(front(&of(0.0)), [0, 1, 3, 4]);
    assert_eq!(front(&[]), [0_usize; 0]);
    // Where times of 3 and 4 are the same within their noise, both are on the front.
    assert_eq!(front(&of(0.49)), [0, 1, 3, 4]);
    assert_eq!(front(&of(0.51)), [0, 1, 2, 3, 4]);
    // Of equally fast ones the more exact one is better.
    assert_eq!(front(&[[1.0, 0.1, 3.0], [1.1, 0.1, 2.0], [1.05, 0.1, 2.0]]), [1, 2]);
}

proptest! {
    #[test]
    fn what_is_beaten_beyond_the_noise_is_beaten_by_the_front(
        points in prop::collection::vec((0.0..10.0, 0.0..1.0, 0_u8..6), 1..40)
    ) {
        let points: Vec<[f64; 3]> = points.into_iter().map(|(t, noise, e)| [t, noise, f64::from(e)]).collect();
        let found = front(&points);
        prop_assert!(!found.is_empty());
        for (index, [time, noise, error]) in points.iter().enumerate() {
            // Anything that is slower than one of the front beyond doubt and no more exact is left out, and nothing is left out
            // but by one of no greater error.
            let beaten = found.iter().any(|own| points[*own][0] + points[*own][1] + noise < *time && points[*own][2] <= *error);
            prop_assert!(!(beaten && found.contains(&index)));
            let better = points.iter().enumerate().any(|(own, other)| {
                own != index && other[2] <= *error && other[0] - other[1] <= time + noise
            });
            prop_assert!(better || found.contains(&index));
        }
    }
}
