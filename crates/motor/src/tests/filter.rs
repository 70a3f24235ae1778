use super::motors;
use crate::{MotorFilter, rad_per_s, rpm};

fn admitted(filter: &MotorFilter) -> Vec<String> {
    let rows = motors(&[
        "4А100L2У3,2,5.5,3000,2880,2.2",
        "4А100L4У3,4,4,1500,1430,2.2",
        "АИР100L4,4,4,1500,1410,2.2",
        "4А71В8У3,8,0.25,750,680,1.7",
    ]);
    rows.iter().filter(|m| filter.accepts(m)).map(crate::Motor::latin_designation).collect()
}

#[test]
fn every_field_narrows_the_list() {
    assert_eq!(admitted(&MotorFilter::default()).len(), 4);
    let four = MotorFilter { poles: Some(4), ..Default::default() };
    assert_eq!(admitted(&four), ["4A100L4U3", "AIR100L4"]);
    let power = MotorFilter { min_power: Some(4000.0), max_power: Some(4000.0), ..Default::default() };
    assert_eq!(admitted(&power), ["4A100L4U3", "AIR100L4"]);
    let slow = MotorFilter { max_speed: Some(rad_per_s(1500.0)), ..Default::default() };
    assert_eq!(admitted(&slow), ["4A100L4U3", "AIR100L4", "4A71B8U3"]);
    let slower = MotorFilter { max_speed: Some(rad_per_s(1499.0)), ..Default::default() };
    assert_eq!(admitted(&slower), ["4A71B8U3"]);
    let part = |text: &str| MotorFilter { designation: Some(text.to_owned()), ..Default::default() };
    assert_eq!(admitted(&part("100 l")), ["4A100L2U3", "4A100L4U3", "AIR100L4"]);
    assert_eq!(admitted(&part("air")), ["AIR100L4"]);
    assert_eq!(admitted(&part("71b")), ["4A71B8U3"], "Latin for Cyrillic");
    assert_eq!(admitted(&MotorFilter { poles: Some(4), ..part("4а") }), ["4A100L4U3"]);
    assert!(admitted(&part("xyz")).is_empty());
}

#[test]
fn revolutions_there_and_back() {
    assert!((rpm(rad_per_s(1410.0)) - 1410.0).abs() < 1e-10);
}
