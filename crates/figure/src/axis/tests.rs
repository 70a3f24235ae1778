//! Tests of `axis`.

use assur_words::{Text, name};

use super::{Axis, AxisKind, extent};

#[test]
#[expect(clippy::float_cmp, reason = "bounds are taken as they are, or doubled")]
fn an_axis_is_never_empty() {
    let range = |values: [f64; 2], floor| Axis::around(Text::default(), values, floor).range;
    assert_eq!(range([-2.0, 3.0], 0.0), [-2.0, 3.0]);
    assert_eq!(range([0.1, 0.1], 0.0), [0.0, 0.2]);
    assert_eq!(range([-4.0, -4.0], 0.0), [-8.0, 0.0]);
    assert_eq!(range([0.0, 0.0], 0.0), [-1.0, 1.0]);
    assert_eq!(range([-1e-17, 2e-17], 1e-15), [-1.0, 1.0]);
    assert_eq!(range([-1e-17, 2e-17], 0.0), [-1e-17, 2e-17]);
}

#[test]
fn the_extent_ignores_what_is_no_number() {
    assert_eq!(extent([f64::NAN, 2.0, -1.0]), Some([-1.0, 2.0]));
    assert_eq!(extent([f64::NAN]), None);
}

fn texts(kind: AxisKind, range: [f64; 2], most: usize) -> Vec<String> {
    Axis { label: Text::default(), range, kind, scale: None }
        .ticks(most)
        .into_iter()
        .map(|(_, text)| text.to_string())
        .collect()
}

#[test]
fn a_turn_has_its_quarters() {
    assert_eq!(texts(AxisKind::Degrees, [0.0, 360.0], 5), ["0", "90", "180", "270", "360"]);
    assert_eq!(texts(AxisKind::Degrees, [-90.0, 90.0], 2), ["-90", "0", "90"]);
    assert_eq!(texts(AxisKind::Degrees, [0.0, 720.0], 4), ["0", "180", "360", "540", "720"]);
    assert_eq!(texts(AxisKind::Degrees, [0.0, 0.4], 4), ["0", "0.1", "0.2", "0.3", "0.4"]);
}

#[test]
fn ticks_have_the_digits_of_their_step() {
    assert_eq!(texts(AxisKind::Linear, [104.4, 105.1], 3), ["104.50", "104.75", "105.00"]);
    assert_eq!(texts(AxisKind::Linear, [0.0, 100.0], 4), ["0", "25", "50", "75", "100"]);
    assert_eq!(
        texts(AxisKind::Linear, [123_450.0, 123_460.0], 5),
        ["123450", "123452", "123454", "123456", "123458", "123460"]
    );
    assert_eq!(
        texts(AxisKind::Linear, [1.0e-7, 1.2e-7], 4),
        ["1.00e-7", "1.05e-7", "1.10e-7", "1.15e-7", "1.20e-7"]
    );
    assert_eq!(texts(AxisKind::Linear, [1.0e7, 3.0e7], 2), ["1e7", "2e7", "3e7"]);
}

#[test]
fn powers_of_ten_have_numbers_at_every_fifth_at_least_and_all_are_written_alike() {
    let decades = |most| texts(AxisKind::Logarithmic, [1e-17, 1e6], most);
    assert_eq!(decades(100)[..3], ["1e-17", "1e-16", "1e-15"]);
    assert_eq!(decades(100)[16..19], ["1e-1", "1e0", "1e1"]);
    for most in [1, 2, 3, 5] {
        assert_eq!(decades(most), ["1e-15", "1e-10", "1e-5", "1e0", "1e5"], "{most}");
    }
}

#[test]
fn other_ticks_are_round() {
    assert_eq!(texts(AxisKind::Linear, [-0.13, 0.12], 5), ["-0.10", "-0.05", "0", "0.05", "0.10"]);
    assert_eq!(texts(AxisKind::Linear, [3.0, 3.0], 5), Vec::<String>::new());
    assert_eq!(texts(AxisKind::Whole, [1.0, 4.0], 9), ["1", "2", "3", "4"]);
    assert_eq!(texts(AxisKind::Whole, [0.0, 100.0], 5), ["0", "20", "40", "60", "80", "100"]);
    assert_eq!(texts(AxisKind::Logarithmic, [1e-9, 1e-3], 3), ["1e-8", "1e-6", "1e-4"]);
}

#[test]
fn a_place_on_an_axis_leads_back_to_its_value() {
    for kind in [AxisKind::Linear, AxisKind::Degrees, AxisKind::Logarithmic] {
        let axis = Axis { label: Text::default(), range: [0.5, 300.0], kind, scale: None };
        for value in [0.5, 2.0, 77.0, 300.0] {
            assert!((axis.value(axis.part(value)) - value).abs() < 1e-12 * value, "{kind:?} {value}");
        }
    }
}

#[test]
fn the_factor_of_the_coordinate_is_not_that_of_an_angle_over_it() {
    let axis = || Axis::around(name("q"), [0.0, 1.0], 0.0);
    let symbol = |axis: Axis| axis.scale.unwrap().symbol;
    assert_eq!([symbol(axis().of_coordinate("deg")), symbol(axis().measuring("deg"))], ["q", "φ"]);
    assert_eq!([symbol(axis().of_coordinate("mm")), symbol(axis().measuring("mm"))], ["q", "s"]);
    // Time has one factor, along which axis it may be.
    assert_eq!(symbol(axis().of_coordinate("s")), "t");
}
