//! Tests of `set`.

use assur_scene::edit::TextPlace;
use assur_scene::{Dimension, quantity};
use proptest::prelude::*;

use super::in_unit_of;

fn written(number: f64, place: &str, dimension: Dimension) -> String {
    let place = TextPlace { span: 0..0, text: Some(place.to_owned()) };
    in_unit_of(&place, number, Some(dimension)).trim_matches('"').to_owned()
}

#[test]
fn a_number_keeps_the_unit_of_its_place_with_few_digits() {
    for (number, place, wanted) in [
        (0.28, "100 mm", "280 mm"),
        (0.289_422_431_671_991_94, "280 mm", "289.42243167199194 mm"),
        (std::f64::consts::PI / 6.0, "12 deg", "30 deg"),
        (std::f64::consts::TAU, "1 rpm", "60 rpm"),
    ] {
        let kind = match place.split(' ').nth(1) {
            Some("deg") => Dimension::Angle,
            Some("rpm") => Dimension::AngularSpeed,
            _ => Dimension::Length,
        };
        assert_eq!(written(number, place, kind), wanted);
    }
}

proptest! {
    #[test]
    fn what_is_written_is_read_as_the_same_number(number in 1e-3_f64..1e3, sign in any::<bool>()) {
        let number = if sign { -number } else { number };
        for (place, kind) in [
            ("1 mm", Dimension::Length),
            ("1 in", Dimension::Length),
            ("1 deg", Dimension::Angle),
            ("1 rpm", Dimension::AngularSpeed),
            ("1 lb*in^2", Dimension::Inertia),
            ("1 kN", Dimension::Force),
        ] {
            let text = written(number, place, kind);
            prop_assert_eq!(quantity(&text, kind).unwrap().to_bits(), number.to_bits(), "{}", text);
        }
    }
}
