use approx::assert_relative_eq;
use assur_words::name;

use super::{kloss, linear, motors};
use crate::{
    check_breakdown, check_rms, check_rotor_inertia, check_starting, rms_torque, rpm, starting_torque,
};

#[test]
fn beyond_breakdown_names_the_worst_point() {
    let c = kloss();
    let wk = c.breakdown_speed().unwrap();
    assert_eq!(check_breakdown(&c, [c.rated_speed, wk + 0.01]), None);
    let warning = check_breakdown(&c, [c.rated_speed, wk - 5.0, wk - 1.0]).unwrap();
    assert!(warning.unfit.is_some());
    let (speed, breakdown) = (rpm(wk - 5.0), c.breakdown_torque.unwrap());
    let text = warning.text.to_string();
    assert!(text.contains(&format!("works at {speed:.1} rpm")), "{text}");
    assert!(text.contains(&format!("breakdown torque of {breakdown:.3} N·m")), "{text}");
    // As a brake, too: above synchronous speed by more than the critical slip.
    assert!(check_breakdown(&c, [2.0 * c.synchronous_speed - wk + 1.0]).is_some());
    assert_eq!(check_breakdown(&c, []), None);
}

#[test]
fn the_straight_line_is_held_to_the_breakdown_torque() {
    let c = linear();
    // Torque 2.2 Mn is reached at 2.2 times the rated slip.
    let at = |slips: f64| c.synchronous_speed - slips * (c.synchronous_speed - c.rated_speed);
    assert_eq!(check_breakdown(&c, [at(2.19)]), None);
    assert!(check_breakdown(&c, [at(2.21)]).is_some());
}

#[test]
fn starting_torque_is_the_printed_one_if_there_is_one() {
    let c = kloss();
    let mn = c.rated_torque;
    assert_relative_eq!(starting_torque(&c, Some(2.0)).unwrap(), 2.0 * mn, max_relative = 1e-15);
    assert_eq!(starting_torque(&c, None), c.starting_torque());
    assert_eq!(starting_torque(&linear(), None), None);
    assert_eq!(check_starting(&c, Some(2.0), 1.9 * mn), None);
    let warning = check_starting(&c, None, 1.9 * mn).unwrap();
    let text = warning.text.to_string();
    assert!(text.contains(&format!("less than the {:.3} N·m of the load", 1.9 * mn)), "{text}");
    assert!(warning.unfit.unwrap().to_string().starts_with("cannot start, "));
    assert_eq!(check_starting(&linear(), None, 1e9), None, "not known");
}

#[test]
fn root_mean_square_of_a_shaping_cycle() {
    // 3 N m for 1 s, -4 N m for 1 s: sqrt((9 + 16)/2)
    assert_relative_eq!(rms_torque([(3.0, 1.0), (-4.0, 1.0)]), 12.5f64.sqrt(), max_relative = 1e-15);
    assert_relative_eq!(rms_torque([(6.0, 2.0), (0.0, 6.0)]), 3.0, max_relative = 1e-15);
    assert_eq!(rms_torque([]), 0.0);
    let c = kloss();
    assert_eq!(check_rms(&c, c.rated_torque), None);
    let text = check_rms(&c, 1.1 * c.rated_torque).unwrap().text.to_string();
    assert!(text.contains("by 10.0 %"), "{text}");
}

#[test]
fn a_rotor_without_inertia_is_said_to_be_left_out() {
    let row = &motors(&["x,4,1.1,1500,1410,2.2"])[0];
    let warning = check_rotor_inertia(row.rotor_inertia, name(row.designation.clone())).unwrap();
    assert_eq!(warning.text.to_string(), "the rotor inertia of x is not in its catalogue: it is neglected");
}
