//! Means of the balancing load against closed forms and dense sums, extremes beside gaps, and loads that act between positions.
//!
//! Over a cycle at constant speed weights and inertia do no net work, so that the mean of the balancing load times the cycle is what
//! the other loads take.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::f64::consts::TAU;

use assur_all as _;
use assur_analysis::results::{Column, Means, Peaks};
use assur_analysis::{Calculation, Options, unwatched};
use assur_report::topic;
use assur_testkit::Rng;
use assur_tests::fuzz::corpus;

fn kept(name: &str) -> String {
    corpus().unwrap().into_iter().find(|(known, _)| known == name).unwrap().1
}

fn calculation(scene: &str) -> Calculation {
    let mechanism = assur_scene::read("scene.toml", scene).unwrap();
    Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap()
}

fn peaks(calculation: &Calculation) -> Peaks {
    let positions = calculation.analyze(&mut unwatched).unwrap().positions;
    assur_book::peaks(calculation, &positions, &calculation.edges(&positions))
}

fn means(scene: &str) -> Means {
    peaks(&calculation(scene)).balancing.unwrap()
}

/// Mean and root mean square by sums over very many positions, which is Simpson's rule with its first term for a periodic function.
fn dense(scene: &str, positions: &str) -> [f64; 2] {
    let dense = calculation(&scene.replace(positions, "positions = 3600\n"));
    let table = dense.analyze(&mut unwatched).unwrap().positions;
    let values: Vec<f64> = (0..table.len()).filter_map(|row| table.get(row, Column::BALANCING)).collect();
    // So many are kept whole.
    assert_eq!(values.len(), 3_600);
    let mean = |of: fn(f64) -> f64| values.iter().map(|value| of(*value)).sum::<f64>() / values.len() as f64;
    [mean(|value| value), mean(|value| value * value).sqrt()]
}

#[track_caller]
fn close(found: f64, wanted: f64, part: f64) {
    assert!((found - wanted).abs() <= part * wanted.abs(), "{found}, not {wanted}");
}

#[test]
fn the_mean_times_the_cycle_is_the_net_work_of_the_loads() {
    // The areas under the table over the stroke of 120 mm: 1330 N forward, 300 N back.
    let compressor = means(&kept("mean-slider-crank"));
    close(compressor.mean, (1330.0 - 300.0) * 0.12 / TAU, 1e-11);
    close(compressor.rms, 47.023_657_608, 1e-9);
    assert!(compressor.are_sure());
    // By an independent engine: 900 N over both ways of the trough, against a crank that turns clockwise.
    close(means(&kept("mean-conveyor")).mean, -66.955_920_731, 1e-10);
}

/// A triangle of the height h over a width w: h w/2 and h^2 w/3 over the cycle.
#[test]
fn a_narrow_peak_is_in_the_means() {
    for (scene, width) in [("mean-peak", 2.0), ("mean-narrow-peak", 1.0)] {
        let found = means(&kept(scene));
        close(found.mean, 500.0 * width / 360.0, 1e-11);
        close(found.rms, 1000.0 * (width / 3.0 / 360.0).sqrt(), 1e-11);
    }
}

/// A crank with a slider beside it, and loads of every kind, with a peak of at least `narrowest` degrees; the work that they take in a
/// cycle, J, and the sense of the crank.
fn machine(random: &mut Rng, narrowest: f64) -> (String, f64, f64) {
    let (crank, rod, offset) = (random.range(0.05, 0.1), random.range(0.25, 0.5), random.range(-0.08, 0.08));
    let stroke =
        ((rod + crank).powi(2) - offset * offset).sqrt() - ((rod - crank).powi(2) - offset * offset).sqrt();
    let sense = random.signed(1.0, 1.0 + f64::EPSILON).signum();
    let direction = if sense > 0.0 { "ccw" } else { "cw" };
    let from = random.range(0.0, 360.0);
    let [drag, forward, back] = [50.0, 200.0, 80.0].map(|most| random.range(0.0, most));
    let (knee, width, at) =
        (random.range(0.1, 0.9), random.range(narrowest, 12.0), random.range(20.0, 340.0));
    let [bend, dip, peak, late] = [3.0, 5.0, 300.0, 8.0].map(|most| random.range(0.1, most));
    let [waves, speed] = [1 + random.below(4), 5 + random.below(20)];
    let cycle = TAU / speed as f64;
    let [start, end] = [0.3 * cycle, random.range(0.4, 0.9) * cycle];
    let scene = format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0] }}\n\
         [link.crank]\npoints = {{ O = 0, A = {crank} }}\nmass = 2\ncenter = 0.03\n\
         [link.rod]\npoints = {{ A = 0, B = {rod} }}\nmass = 1.2\ncenter = 0.1\ninertia = 0.01\n\
         [link.slider]\npoints = {{ B = 0 }}\nmass = 0.8\n\
         [[slide]]\nlink = 'slider'\non = 'ground'\nthrough = [0, {offset}]\n[assembly]\nB = [{rod}, {offset}]\n\
         [[force]]\nlink = 'slider'\nat = 'B'\nagainst_motion = true\nvalue = {drag}\n\
         [[force]]\nlink = 'slider'\nat = 'B'\nangle = '180 deg'\n\
         value = {{ over = 'stroke', axis = 0, forward = [[0, 0], [{knee}, {forward}], [1, 0]], back = -{back} }}\n\
         [[moment]]\nlink = 'crank'\nvalue = {{ formula = '-({sense}) * ({bend} * abs(sin({waves}*q)) + {dip} * max(0, cos(q - 1)))' }}\n\
         [[moment]]\nlink = 'crank'\n\
         value = {{ over = 'angle', table = [[0, 0], ['{at} deg', 0], ['{} deg', {}], ['{} deg', 0], ['360 deg', 0]] }}\n\
         [[moment]]\nlink = 'crank'\n\
         value = {{ over = 'time', table = [[0, 0], [{start}, {}], [{end}, 0]] }}\n\
         [input]\nlink = 'crank'\nfrom = '{from} deg'\npositions = 12\ndirection = '{direction}'\n[motion]\nspeed = {speed}\n",
        at + 0.4 * width,
        -sense * peak,
        at + width,
        -sense * late,
    );
    let work = 2.0 * drag * stroke
        + stroke * (0.5 * forward + back)
        + 4.0 * bend
        + 2.0 * dip
        + 0.5 * peak * width.to_radians()
        + 0.5 * late * end * speed as f64;
    (scene, work, sense)
}

#[test]
fn means_of_random_machines_are_those_of_their_works() {
    let mut random = Rng::new(32);
    for _ in 0..24 {
        let (scene, work, sense) = machine(&mut random, 0.3);
        let found = means(&scene);
        let error = (found.mean - sense * work / TAU).abs();
        assert!(error <= 1e-9 * found.rms && found.are_sure(), "{error:e} {found:?}\n{scene}");
    }
}

/// A sum over n positions is off by the jumps of the slope times (2 pi/n)^2/12: of the square of a triangle w wide, by up to
/// 2 (2 pi/n)^2/w^2 of its integral, 2e-4 for a width of 10 deg, of which the root has half. So there is no narrower peak here.
#[test]
fn root_mean_squares_are_those_of_dense_sums() {
    let mut random = Rng::new(33);
    for _ in 0..3 {
        let (scene, ..) = machine(&mut random, 10.0);
        let (found, [mean, rms]) = (means(&scene), dense(&scene, "positions = 12\n"));
        assert!(
            (found.rms - rms).abs() <= 1e-4 * rms && (found.mean - mean).abs() <= 1e-4 * rms,
            "{found:?}: {mean} {rms}\n{scene}"
        );
    }
    let conveyor = kept("mean-conveyor");
    close(means(&conveyor).rms, dense(&conveyor, "positions = 24\n")[1], 1e-4);
}

/// The same mean whatever the positions are, with dry friction in all pairs.
#[test]
fn a_mean_with_dry_friction_is_that_of_dense_positions() {
    let scene = assur_fixtures::scene("shaper-friction");
    let positions = scene.lines().find(|line| line.starts_with("positions")).unwrap().to_owned();
    let (found, [mean, rms]) = (means(scene), dense(scene, &positions));
    close(found.mean, mean, 1e-4);
    close(found.rms, rms, 1e-4);
}

/// What has more changes than are looked for is told as not sure.
#[test]
fn means_that_are_not_resolved_say_so() {
    let scene = kept("mean-peak");
    let (before, _) = scene.split_once("value =").unwrap();
    let found = means(&format!("{before}value = {{ formula = 'sin(1e7*q^2)' }}\n"));
    assert!(!found.are_sure(), "{found:?}");
}

#[test]
fn what_grows_without_limit_is_no_maximum() {
    let calculation = calculation(&kept("grows-towards-a-gap"));
    let found = peaks(&calculation);
    let turn = found.of(Column::BALANCING).unwrap();
    assert!(turn.value.is_infinite() && (turn.at.to_degrees() - 160.7483).abs() < 1e-4, "{turn:?}");
    let mut analysis = calculation.analyze(&mut unwatched).unwrap();
    analysis.peaks = found;
    let facts = topic::summary(&analysis, &calculation.linkage);
    let told = facts.iter().find(|fact| fact.id == "fact-greatest-balancing-moment").unwrap();
    assert_eq!(told.value().to_string(), "grows without limit towards 160.748 deg");
}

/// A range that ends where the mechanism can go on has a greatest value there.
#[test]
fn the_end_of_a_range_that_is_bounded_is_an_extreme() {
    let scene = kept("grows-towards-a-gap").replace("positions = 36", "positions = 10\nto = '90 deg'");
    let found = peaks(&calculation(&scene));
    assert!(found.farthest.iter().all(|(_, turn)| turn.value.is_finite()), "{found:?}");
}

#[test]
fn a_load_that_acts_between_the_positions_acts() {
    for scene in ["mean-peak", "mean-narrow-peak"] {
        let calculation = calculation(&kept(scene));
        assert!(calculation.mistakes().is_empty(), "{:?}", calculation.mistakes());
    }
    let (before, _) =
        kept("mean-peak").split_once("value =").map(|(a, b)| (a.to_owned(), b.to_owned())).unwrap();
    let told = |value: &str| {
        let warnings = calculation(&format!("{before}value = {value}\n")).mistakes();
        warnings.iter().filter_map(|one| one.text.identity()).collect::<Vec<_>>()
    };
    assert!(told("{ formula = 'sin(12*q)' }").is_empty());
    assert_eq!(told("{ over = 'angle', table = [[0, 0], [1, 0]] }"), ["analysis-load-idle"]);
}
