use std::f64::consts::FRAC_PI_2;

use assur_force::{LoadState, Loads};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_mechanism::Contact;

use super::{analyzer, compile, fixture};
use crate::{Solver, enveloping, sign_changes};

fn solver<'a>(linkage: &'a Linkage, loads: &'a Loads, name: &str) -> Solver<'a> {
    Solver { linkage, loads, analyzer: analyzer(name), order: Order::Second, carrying: &[true] }
}

/// Its only contact.
fn contact(linkage: &Linkage) -> &Contact {
    linkage.mechanism.loads.iter().find_map(|load| load.kind.contact()).expect("a contact")
}

#[test]
fn the_arc_envelopes_a_straight_line() {
    let linkage = compile(&fixture("press"));
    let found = enveloping(&linkage, &"".into(), contact(&linkage), 81).unwrap();
    // N lies r2 cos psi - r1 cos f1 above O, the lowest point R under it; lowest in the middle, highest at both ends.
    let f1 = 20.0_f64.to_radians();
    let lean = 0.04 * f1.sin() / 0.16;
    let high = 0.64 * (1.0 - lean * lean).sqrt() - 0.04 * f1.cos() - 0.75;
    let low = 0.64 - 0.04 - 0.75;
    assert!((found.level - f64::midpoint(low, high)).abs() < 1e-15);
    assert!((found.greatest - 0.5 * (high - low)).abs() < 1e-15);
    assert!(found.greatest < 3.5e-5, "a line within 0.07 mm: {}", found.greatest);
    assert_eq!(found.path.len(), 81);
    assert!(found.path.windows(2).take(40).all(|two| two[0].deviation > two[1].deviation));
    // x of N: r1 sin f1 (1 + r2 / b), to both sides; the working way goes to the left.
    assert!((found.way + 2.0 * 0.04 * f1.sin() * (1.0 + 0.64 / 0.16)).abs() < 1e-14);
    // In the middle the rod turns with -r1 / b and N goes with r1 (1 + r2 / b): the arc slides by their difference.
    let middle = found.path[40];
    assert!((middle.sliding - (0.04 * (1.0 + 4.0) - 0.25 * 0.75)).abs() < 1e-12, "{}", middle.sliding);
}

#[test]
fn the_interval_of_the_contact_counts() {
    let during = "friction = 0.1\nduring = [\"-100 deg\", \"-80 deg\"]";
    let linkage = compile(&fixture("press").replace("friction = 0.1", during));
    let found = enveloping(&linkage, &"".into(), contact(&linkage), 11).unwrap();
    assert!((found.interval[0] + 100.0_f64.to_radians()).abs() < 1e-15);
    assert!((found.interval[1] + 80.0_f64.to_radians()).abs() < 1e-15);
}

/// Of the scenes of the press, one of which has f1 itself as its coordinate. F passes through A where the rod leans by a + atan f - asin(R sin(atan f) / r2) from the guide.
#[test]
fn the_guide_changes_its_side_where_the_force_passes_through_a() {
    let friction_angle = 0.1_f64.atan();
    let f1_at =
        |a: f64| (4.0 * (a + friction_angle - (0.75 * friction_angle.sin() / 0.64).asin()).sin()).asin();
    // The angle of the second scene is (20 degrees - f1) / 5: a contraction.
    let grown = (0..300).fold(0.1, |f1, _| f1_at((20.0_f64.to_radians() - f1) / 5.0));
    let constant = f1_at(4.0_f64.to_radians());
    for (scene, f1, rounded, from) in [
        ("press", constant, 12.14, FRAC_PI_2),
        ("press-f1", constant, 12.14, 0.0),
        ("press-compression", grown, 6.71, FRAC_PI_2),
    ] {
        let linkage = compile(&fixture(scene));
        let loads = Loads::compile(&linkage).unwrap();
        let at = |q| LoadState::prescribed(&linkage.mechanism, q);
        assert!((f1.to_degrees() - rounded).abs() < 5e-3, "{scene} {}", f1.to_degrees());
        for name in ["groups", "longitudinal", "newton-euler"] {
            let found = sign_changes(&solver(&linkage, &loads, name), &[0], &at).unwrap().remove(0);
            assert_eq!(found.len(), 1, "{name} {found:?}");
            let wanted = f1 - from;
            assert!((found[0].coordinate - wanted).abs() < 1e-12, "{scene} {name} {}", found[0].coordinate);
            assert!(!found[0].jump && found[0].before * found[0].after < 0.0);
        }
    }
}

/// A slider pushed across its guide by a table over the crank's angle: the guide answers with the opposite, wherever it stands.
fn pushed(table: &str, positions: usize) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 1 }}\n[link.rod]\npoints = {{ A = 0, B = 3 }}\n\
         [link.slider]\npoints = {{ B = 0 }}\n[[slide]]\nlink = \"slider\"\non = \"ground\"\n\
         [[force]]\nlink = \"slider\"\nat = \"B\"\nangle = \"90 deg\"\nvalue = {{ over = \"angle\", table = {table} }}\n\
         [input]\nlink = \"crank\"\npositions = {positions}\n"
    )
}

#[test]
fn changes_between_two_positions_are_found_however_few_there_are() {
    let ramps = r#"[["0 deg", 1], ["100 deg", 1], ["100.2 deg", -1], ["100.8 deg", -1], ["101 deg", 1], ["360 deg", 1]]"#;
    let jumps = r#"[["0 deg", 1], ["100.1 deg", 1], ["100.1 deg", -1], ["100.9 deg", -1], ["100.9 deg", 1], ["360 deg", 1]]"#;
    for (table, jump) in [(ramps, false), (jumps, true)] {
        for positions in [1, 2, 7, 12, 48, 360] {
            let linkage = compile(&pushed(table, positions));
            let loads = Loads::compile(&linkage).unwrap();
            let at = |q| LoadState::prescribed(&linkage.mechanism, q);
            let found = sign_changes(&solver(&linkage, &loads, "groups"), &[0], &at).unwrap().remove(0);
            let places: Vec<f64> = found.iter().map(|change| change.coordinate.to_degrees()).collect();
            assert_eq!(places.len(), 2, "{positions} {found:?}");
            assert!((places[0] - 100.1).abs() < 1e-9 && (places[1] - 100.9).abs() < 1e-9, "{places:?}");
            assert!(found.iter().all(|change| change.jump == jump), "{positions} {found:?}");
        }
    }
}

/// A force P along the guide presses the slider against it with P tan(b), sin(b) = sin(q)/3; a force across the guide that is
/// smaller than the greatest of these by 1e-5 leaves two changes less than a degree apart.
#[test]
fn a_dip_through_zero_between_samples_is_two_changes() {
    let across = 1.0 / 8.0_f64.sqrt() - 1e-5;
    let wanted = 3.0 * across / (1.0 + across * across).sqrt();
    for positions in [3, 7, 12, 90] {
        let along = "[[force]]\nlink = \"slider\"\nat = \"B\"\nangle = 0\nvalue = 1\n[input]";
        let table = format!("[[0, {across}], [\"360 deg\", {across}]]");
        let linkage = compile(&pushed(&table, positions).replace("[input]", along));
        let loads = Loads::compile(&linkage).unwrap();
        let at = |q| LoadState::prescribed(&linkage.mechanism, q);
        let found = sign_changes(&solver(&linkage, &loads, "groups"), &[0], &at).unwrap().remove(0);
        assert_eq!(found.len(), 2, "{positions} {found:?}");
        for change in &found {
            assert!((change.coordinate.sin().abs() - wanted).abs() < 1e-12 && !change.jump, "{found:?}");
        }
    }
}
