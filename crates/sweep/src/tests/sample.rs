//! Samples: their values and their forms.

use super::{SLIDER, numbers, requested, rows};
use crate::{Points, SweepRequest};

fn sample(count: usize, seed: u32) -> SweepRequest {
    SweepRequest { points: Points::Sample { count, seed }, ..SweepRequest::default() }
}

#[test]
fn values_are_within_their_ranges_and_fill_them() {
    let vary = ["link.crank.points.A=100 mm..140 mm", "link.piston.mass=3..1 kg"];
    let table = rows(&requested(SLIDER, &vary, sample(256, 3)).unwrap(), 2);
    assert_eq!(table.len(), 256);
    for (name, [low, high]) in [("link.crank.points.A_m", [0.1, 0.14]), ("link.piston.mass_kg", [1.0, 3.0])] {
        let mut found = numbers(&table, name);
        found.sort_by(f64::total_cmp);
        // One value in each of 256 equal parts of the range.
        for (index, value) in found.into_iter().enumerate() {
            let part = |index: usize| low + (high - low) * index as f64 / 256.0;
            let rounding = 1e-12;
            assert!(value >= part(index) - rounding && value <= part(index + 1) + rounding, "{name} {index}");
        }
    }
}

#[test]
fn a_longer_sample_goes_on_from_a_shorter_one() {
    let vary = ["link.crank.points.A=100 mm..140 mm"];
    let values = |count, seed| {
        numbers(&rows(&requested(SLIDER, &vary, sample(count, seed)).unwrap(), 2), "link.crank.points.A_m")
    };
    assert_eq!(values(40, 1)[..], values(100, 1)[..40]);
    assert_ne!(values(40, 1), values(40, 2));
}

#[test]
fn a_range_of_a_sample_has_no_number_of_values() {
    let error = requested(SLIDER, &["link.piston.mass=1..2:3"], sample(9, 0)).unwrap_err();
    let form = "for a sample write it as KEY=FROM..TO, such as \"link.crank.mass=1 kg..5 kg\"";
    assert_eq!(error.to_string(), format!("`link.piston.mass=1..2:3`: {form}"));
}
