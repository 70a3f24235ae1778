//! Every curve that a view draws holds the numbers of the JSON at the same coordinates.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use assur_analysis::DRAWN;
use assur_analysis::results::{Column, Owner, Quantity};
use assur_book::Course;
use assur_figure::{AxisKind, Figure, Frame, Item};
use assur_fixtures::SCENES;
use serde_json::Value;

use super::{opened, press, text};
use crate::screen::state::{State, View, ViewPart, coordinate_unit};
use crate::screen::view;

/// Relative difference that the conversion of units makes.
const ROUNDING: f64 = 1e-12;

/// Points of the JSON: a coordinate or a time, and a number found there.
type Points = Vec<[f64; 2]>;

/// The numbers of an object by their paths; of a pair of numbers its modulus too.
fn numbers(value: &Value, path: &str, into: &mut BTreeMap<String, f64>) {
    match value {
        Value::Number(number) => drop(into.insert(path.to_owned(), number.as_f64().unwrap())),
        Value::Object(members) => {
            members.iter().for_each(|(key, value)| numbers(value, &format!("{path}.{key}"), into));
        }
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(at, value)| numbers(value, &format!("{path}[{at}]"), into));
            if let [Value::Number(x), Value::Number(y)] = items.as_slice() {
                let size = x.as_f64().unwrap().hypot(y.as_f64().unwrap());
                into.insert(format!("{path}|"), size);
            }
        }
        _ => {}
    }
}

/// Every number of the rows of an array over one of them.
fn over(rows: &Value, key: &str, into: &mut Vec<Points>) {
    let mut all: BTreeMap<String, Points> = BTreeMap::new();
    for row in rows.as_array().into_iter().flatten() {
        let mut found = BTreeMap::new();
        numbers(row, "", &mut found);
        let Some(at) = found.get(&format!(".{key}")).copied() else { continue };
        for (path, value) in found {
            all.entry(path).or_default().push([at, value]);
        }
    }
    into.extend(all.into_values());
}

/// The shares of the links in the reduced inertia above that of the drive, one more in each.
fn shares(json: &Value, links: &[&str], into: &mut Vec<Points>) {
    let drive = json["dynamics"]["regime"]["shaft_inertia"].as_f64().unwrap_or(0.0);
    let positions = json["positions"].as_array().unwrap();
    let known = |link: &&str| positions[0]["reduced"]["inertia_of_links"].get(*link).is_some();
    let links: Vec<&str> = links.iter().copied().filter(known).collect();
    for count in 0..=links.len() {
        // With a list of inputs there is no coordinate, and no reduced inertia.
        let point = |row: &Value| {
            let shares = &row["reduced"]["inertia_of_links"];
            let sum: f64 = links[..count].iter().map(|link| shares[*link].as_f64().unwrap()).sum();
            Some([row["coordinate"].as_f64()?, drive + sum])
        };
        into.push(positions.iter().filter_map(point).collect());
    }
}

/// All courses of the results.
fn courses(json: &Value, links: &[&str]) -> Vec<Points> {
    let mut all = Vec::new();
    over(&json["positions"], "coordinate", &mut all);
    over(&json["positions"], "time", &mut all);
    over(&json["trajectory"], "coordinate", &mut all);
    over(&json["trajectory"], "time", &mut all);
    let regime = &json["dynamics"]["regime"];
    over(&regime["course"], "coordinate", &mut all);
    if let Some(mean) = regime["mean_resistance"].as_f64() {
        let rows = regime["course"].as_array().unwrap();
        let of = |mean: f64| rows.iter().map(|row| [row["coordinate"].as_f64().unwrap(), mean]).collect();
        // Where the loads drive, it is the mean of their moment.
        all.extend([of(mean), of(-mean)]);
    }
    shares(json, links, &mut all);
    all
}

/// Whether the points are those of a course, in its order, of all of it, each number multiplied by the factors. What else is
/// drawn lies between them, or one above the other, or is the end of the cycle.
fn is_drawn(points: &[[f64; 2]], course: &Points, most: [f64; 2], [across, up]: [f64; 2]) -> bool {
    let [wide, high] = [most[0] * across.abs(), most[1] * up.abs()];
    let same = |drawn: &[f64; 2], found: &[f64; 2]| {
        (drawn[0] - across * found[0]).abs() <= ROUNDING * wide
            && (drawn[1] - up * found[1]).abs() <= ROUNDING * high
    };
    // Most of the courses of the results differ in their beginning.
    let begins = |first: &[f64; 2]| points.iter().take(64).any(|drawn| same(drawn, first));
    if !course.first().is_some_and(begins) {
        return false;
    }
    let mut left = course.iter().peekable();
    for drawn in points {
        left.next_if(|found| same(drawn, found));
    }
    let (first, last) = (points.first(), points.last());
    let sense = first.zip(last).map_or(1.0, |(first, last)| (last[0] - first[0]).signum());
    let onward = |two: &[[f64; 2]]| sense * (two[1][0] - two[0][0]) >= -ROUNDING * wide;
    left.next().is_none() && points.windows(2).all(onward)
}

/// The lines over a coordinate or a time in figures, with the names of their panels.
pub(crate) fn lines(figure: &Figure, of: &str) -> Vec<(String, Points)> {
    let mut lines = Vec::new();
    for panel in &figure.panels {
        let Frame::Axes { x, y, .. } = &panel.frame else { continue };
        // Bands are no curves.
        if y.kind == AxisKind::Unmarked
            || !(["coordinate", "time"].iter().any(|axis| x.label.to_string().starts_with(axis)))
        {
            continue;
        }
        for item in &panel.items {
            let Item::Line { points, .. } = item else { continue };
            let points: Points = points.iter().copied().filter(|at| at[0].is_finite()).collect();
            lines.push((format!("{of} {}", panel.title), points));
        }
    }
    lines
}

/// The lines that the views of a state draw, and those in the pictures of its quantities.
fn drawn(state: &mut State) -> Vec<(String, Points)> {
    let mut found = Vec::new();
    for shown in View::TABS {
        state.view = shown;
        let parts = match state.available_parts(shown) {
            none if none.is_empty() => vec![ViewPart::Overview],
            some => some,
        };
        for part in parts {
            state.parts.insert(shown, part);
            let figure = view::figure(state, shown).unwrap_or_default();
            found.extend(lines(&figure, &format!("{shown:?} {part:?}")));
        }
    }
    let scene = state.scene.as_ref().unwrap();
    found.extend(lines(&assur_picture::curves::residuals(scene, &state.pictured()), "checks"));
    for series in (0..scene.column_count()).map(|index| scene.column(index).unwrap()) {
        found.extend(lines(&view::picker::figure(state, scene, series), &series.short));
    }
    found
}

fn json(state: &State) -> Value {
    let analysis = &state.found().unwrap().analysis;
    serde_json::from_str(&assur_report::json::analysis::to_json(analysis, false).unwrap()).unwrap()
}

/// Fails where one of the lines is not one of the courses of the results of a state.
pub(crate) fn assert_found(name: &str, state: &State, lines: &[(String, Points)]) {
    let linkage = &state.scene.as_ref().unwrap().linkage;
    let links: Vec<&str> = linkage.mechanism.links.iter().map(|link| link.name.as_str()).collect();
    let (all, (_, factor)) = (courses(&json(state), &links), coordinate_unit(linkage));
    // Lengths in mm, angles in degrees, moments against the motion.
    let ups = [1.0, -1.0, 1e3, 1.0_f64.to_degrees()];
    let most = |course: &Points, axis: usize| {
        course.iter().fold(0.0_f64, |most, point: &[f64; 2]| most.max(point[axis].abs()))
    };
    let all: Vec<(Points, [f64; 2])> = all
        .into_iter()
        .map(|course| {
            let most = [0, 1].map(|axis| most(&course, axis));
            (course, most)
        })
        .collect();
    for (title, points) in lines {
        let found = all.iter().any(|(course, most)| {
            let drawn = |factors| is_drawn(points, course, *most, factors);
            ups.iter().any(|up| drawn([factor, *up]) || drawn([1.0, *up]))
        });
        assert!(found, "{name}: {title} draws what no column of the JSON has: {points:?}");
    }
}

fn assert_drawn_as_found(name: &str, state: &mut State) {
    let lines = drawn(state);
    assert_found(name, state, &lines);
}

#[test]
fn every_curve_is_a_column_of_the_json() {
    for (name, text) in SCENES {
        // What a scene does not ask for is drawn, but not written.
        let asks_for_all: Vec<_> = text.split("\n[").filter(|table| !table.starts_with("output]")).collect();
        assert_drawn_as_found(name, &mut super::scene(&asks_for_all.join("\n[")));
    }
}

/// What is drawn between the positions are the numbers of the JSON of the same scene with more positions.
#[test]
fn curves_between_the_positions_are_those_of_more_positions() {
    for (name, positions) in [("shaper", 48), ("shaper-drive", 48), ("slider-crank", 24)] {
        // The positions that a note shows may be none of fewer.
        let text = assur_fixtures::scene(name).split("[note]").next().unwrap();
        let line = text.lines().find(|line| line.starts_with("positions")).unwrap();
        let with = |count: usize| super::scene(&text.replace(line, &format!("positions = {count}")));
        let (mut few, many) = (with(positions / 2), with(DRAWN));
        let json = json(&many);
        let mut all = Vec::new();
        over(&json["positions"], "coordinate", &mut all);
        let scene = few.scene.as_ref().unwrap();
        let mut compared = 0;
        for series in (0..scene.column_count()).map(|index| scene.column(index).unwrap()) {
            // Residuals are known where positions were checked; the coordinate is a straight line.
            if matches!(series.column.quantity, Quantity::Residual(_)) || series.column == Column::COORDINATE
            {
                continue;
            }
            let points = series.course.points([1.0; 2]);
            assert!(
                points.len() > DRAWN && points.iter().all(|at| !at[1].is_nan()),
                "{name} {}",
                series.short
            );
            let most = points.iter().fold(0.0_f64, |most, at| most.max(at[1].abs())).max(1e-6);
            let same = |found: &Points| {
                found.len() == DRAWN
                    && found.iter().all(|found| {
                        points.iter().any(|at| {
                            (at[0] - found[0]).abs() < 1e-9 && (at[1] - found[1]).abs() <= 1e-6 * most
                        })
                    })
            };
            assert!(
                all.iter().any(same),
                "{name}: {} draws between the positions what is not found there",
                series.short
            );
            compared += 1;
        }
        assert!(compared > 20, "{name}: {compared}");
        assert_drawn_as_found(name, &mut few);
    }
}

#[test]
fn every_reaction_and_transfer_function_is_drawn_as_found() {
    let mut state = opened("shaper-drive");
    let reactions = state.found().unwrap().reactions.len();
    let transfers = state.scene.as_ref().unwrap().transfers.len();
    for chosen in 0..reactions.max(transfers) {
        state.chosen.reaction = chosen.min(reactions - 1);
        state.chosen.transfer = chosen.min(transfers - 1);
        assert_drawn_as_found("shaper-drive", &mut state);
    }
}

/// The energies were once drawn from 0 to 360 degrees with the values of 0 to 144 degrees.
#[test]
fn energies_of_a_cycle_end_with_the_works_of_the_cycle() {
    for name in ["shaper-drive", "flywheel"] {
        let mut state = opened(name);
        let json = json(&state);
        let last = json["trajectory"].as_array().unwrap().last().unwrap();
        state.parts.insert(View::Motion, ViewPart::Course);
        let figure = view::figure(&state, View::Motion).unwrap();
        let energies =
            figure.panels.iter().find(|panel| panel.title.to_string().starts_with("energies")).unwrap();
        let lines: Vec<Points> = energies
            .items
            .iter()
            .filter_map(|item| match item {
                Item::Line { points, .. } => Some(points.clone()),
                _ => None,
            })
            .collect();
        for (line, key) in lines.iter().zip(["work_driving", "work_resisting", "kinetic_energy"]) {
            let end = line.last().unwrap();
            assert!(
                (end[0] - last["coordinate"].as_f64().unwrap().to_degrees()).abs() < 1e-9,
                "{name} {key}"
            );
            assert!((end[1] - last[key].as_f64().unwrap()).abs() < 1e-9, "{name} {key}: {end:?}");
        }
        // The kinetic energy of a periodic cycle ends as it began.
        let kinetic = &lines[2];
        let [first, end] = [kinetic[0][1], kinetic.last().unwrap()[1]];
        assert!((end - first).abs() <= 1e-8 * first, "{name}: {first} {end}");
    }
}

/// E example 1: the driving moment has fallen by a fifth after a turn, so Q is 24 - 10 N m there and not 30 - 10.
#[test]
fn what_is_not_periodic_does_not_close() {
    let state = opened("run-up");
    let found = state.found().unwrap();
    let (table, moment) = (&found.analysis.positions, Column::of(Quantity::ReducedMoment, Owner::Input));
    let edges = found.plans.calculation().edges(table);
    let moment = Course::of(table, Some(&edges), Column::COORDINATE, moment);
    assert_eq!(moment.closes(), Some(false));
    let end = *moment.points([1.0; 2]).last().unwrap();
    assert!((end[0] - TAU).abs() < 1e-12 && (end[1] - 14.0).abs() < 1e-12, "{end:?}");
}

/// Transfer functions close, and the angle of a crank is a turn greater at the end.
#[test]
fn what_is_periodic_closes() {
    let state = opened("slider-crank");
    let scene = state.scene.as_ref().unwrap();
    for series in &scene.series[1..] {
        let crank = series.short == "crank";
        assert_eq!(series.course.closes(), Some(!crank), "{}", series.short);
    }
    let crank = scene.series.iter().find(|series| series.short == "crank").unwrap();
    let points = crank.course.points([1.0; 2]);
    assert!((points.last().unwrap()[1] - points[0][1] - TAU).abs() < 1e-12);
}

#[test]
fn what_is_written_of_the_working_is_the_working() {
    let folder = tempfile::tempdir().unwrap();
    let mut state = opened("slider-crank");
    press(&mut state, "W");
    let path = folder.path().join("working.txt");
    press(&mut state, ":");
    super::write(&mut state, &format!("write {}", path.display()));
    let text = std::fs::read_to_string(path).unwrap();
    assert!(text.contains('=') && text.lines().count() > 30, "{text}");
    let other = folder.path().join("working.csv");
    press(&mut state, ":");
    super::write(&mut state, &format!("write {}", other.display()));
    assert!(!other.exists());
}

/// Every load, and every force that hangs on one, has both its values where a load jumps, one above the other.
#[test]
fn a_jump_of_a_load_is_a_vertical_step() {
    for (name, load, height) in [("shaper", "cutting", 1500.0), ("shaper-drive", "cutting", 1500.0)] {
        let state = opened(name);
        let found = state.found().unwrap();
        let series = |short: &str| found.series.iter().find(|series| series.short == short).unwrap();
        let own = &series(&format!("load {load}")).course;
        let jumps: Vec<_> =
            own.jumps().filter(|step| (step.values[1] - step.values[0]).abs() > 1.0).collect();
        // At the beginning and at the end of the cut the whole force comes and goes.
        assert_eq!(jumps.len(), 2, "{name}: {jumps:?}");
        for jump in &jumps {
            let size = (jump.values[1] - jump.values[0]).abs();
            assert!((size - height).abs() < 1e-9 * height, "{name}: {jump:?}");
            let points = own.points([1.0; 2]);
            let here =
                points.windows(2).filter(|two| two.iter().all(|at| at[0].to_bits() == jump.at.to_bits()));
            assert_eq!(here.count(), 1, "{name}: {points:?}");
        }
        // The balancing load jumps by the power of the force over the speed: F ds/dq of the ram.
        let balancing = &found.balancing().unwrap().course;
        let scene = state.scene.as_ref().unwrap();
        let ram = scene.series.iter().find(|series| series.short == "ram/ground'").unwrap();
        for jump in &jumps {
            let step = balancing.jumps().find(|step| step.at.to_bits() == jump.at.to_bits()).unwrap();
            let size = (step.values[1] - step.values[0]).abs();
            let wanted = height * ram.course.between(jump.at).unwrap().abs();
            assert!((size - wanted).abs() < 0.02 * wanted, "{name}: {size} {wanted}");
        }
    }
}

/// All links of the chain of parallelograms turn alike or not at all, so J is constant.
#[test]
fn a_derivative_that_is_rounding_is_zero() {
    let state = opened("n-four-bar-40");
    let found = state.found().unwrap();
    let derivative = found.series.iter().find(|series| series.short == "J'").unwrap();
    assert!(derivative.course.size() > 0.0);
    for position in 0..state.positions() {
        assert_eq!(derivative.bare(position), "0");
    }
    let state = opened("shaper");
    let series = &state.found().unwrap().series;
    let derivative = series.iter().find(|series| series.short == "J'").unwrap();
    assert!((0..48).filter(|position| derivative.bare(*position) == "0").count() < 4);
}

#[test]
fn an_angle_and_its_derivatives_have_one_unit() {
    let mut state = opened("four-bar");
    let transfers = &state.scene.as_ref().unwrap().transfers;
    state.chosen.transfer = transfers.iter().position(|one| one.name.to_string().contains("rocker")).unwrap();
    for keys in ["1", "2"] {
        press(&mut state, keys);
        let frame = text(&state, 80, 24);
        let units = ["PF0", "PF1", "PF2"].map(|order| {
            let line = frame.lines().find(|line| line.contains(order)).unwrap();
            line.split(order).nth(1).unwrap().split_whitespace().nth(1).unwrap().to_owned()
        });
        assert_eq!(units, ["rad", "rad/rad", "rad/rad²"], "{frame}");
    }
}

/// D 3.22, case 1: the brake holds 0.8 N m against the motion at every instant until the disc rests.
#[test]
fn a_motion_over_time_is_shown_at_its_instants() {
    let mut state = opened("brake");
    assert_eq!((state.positions(), state.position), (101, 0));
    let shown = |keys: &str| {
        let mut state = opened("brake");
        state.position = 20;
        press(&mut state, keys);
        text(&state, 80, 24)
    };
    state.position = 20;
    // After 10 s of 50 s: 100 - 2 t rad/s, and 100 t - t^2 = 900 rad.
    let header = shown("1");
    let degrees = crate::number::digits(900_f64.to_degrees(), 6);
    for part in ["instant 20 (0 to 100)", "10 s", &degrees, "speed 80.0000 rad/s"] {
        assert!(header.contains(part), "{part}: {header}");
    }
    let found = state.found().unwrap();
    let of = |short: &str| found.series.iter().find(|series| series.short == short).unwrap();
    for sample in 0..100 {
        let time = sample as f64 / 2.0;
        assert!((of("Q").course.get(sample).unwrap() + 0.8).abs() < 1e-9, "{sample}");
        let place = state.scene.as_ref().unwrap().coordinate(sample);
        assert!((place - (100.0 * time - time * time)).abs() < 1e-6, "{sample}: {place}");
    }
    assert!(shown("5 Tab Tab").contains("-0.8"), "{}", shown("5 Tab Tab"));
    assert!(shown("W").contains("working of sample 20"), "{}", shown("W"));
}

#[test]
fn a_time_or_a_coordinate_leads_to_what_is_nearest() {
    let mut state = opened("brake");
    super::write(&mut state, ":10 s");
    assert_eq!(state.position, 20);
    // Half a second between two samples.
    super::write(&mut state, ":0.4s");
    assert_eq!(state.position, 1);
    let mut state = opened("shaper");
    super::write(&mut state, ":91 deg");
    assert_eq!(state.position, 12);
    super::write(&mut state, ":91 s");
    assert!(text(&state, 80, 24).contains("there is no command"));
}
