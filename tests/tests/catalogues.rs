//! Every row of every registered motor catalogue.

#[path = "catalogues/doubts.rs"]
mod doubts;
#[path = "catalogues/plausibility.rs"]
mod plausibility;

use assur_all as _;
use assur_motor::catalogues;

#[test]
fn every_row_is_plausible_or_carries_a_flag() {
    for catalogue in catalogues().expect("a sound registry") {
        for motor in catalogue.rows().expect("a sound table") {
            assert_eq!(plausibility::doubts(motor), [], "{} {}", catalogue.name, motor.designation);
        }
    }
}
