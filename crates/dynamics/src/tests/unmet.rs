//! Wishes that a regime can't meet: they are reported or refused, and everything follows from the regime that was found.

use std::f64::consts::PI;

use approx::assert_relative_eq;

use super::compiled;
use crate::{DynamicsError, Steady, steady};

/// A slider-crank that is pressed over half of the cycle.
fn press(force: f64, drive: &str) -> Result<Steady, DynamicsError> {
    let text = format!(
        "gravity = [0.7, -9.6]\n[ground]\npoints = {{ O = [0, 0] }}\n\
         [link.crank]\npoints = {{ O = 0, A = 0.1 }}\nmass = 2\ncenter = [0.04, 0.01]\ninertia = 0.01\n\
         [link.rod]\npoints = {{ A = 0, B = 0.35 }}\nmass = 1.2\ncenter = [0.12, 0.01]\ninertia = 0.015\n\
         [link.slider]\npoints = {{ B = 0 }}\nmass = 1.5\n[[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = [0, 0.02]\n\
         [assembly]\nB = [0.4, 0.02]\n[[force]]\nlink = \"slider\"\nat = \"B\"\nangle = \"180 deg\"\n\
         value = {{ over = \"angle\", shape = \"step\", table = [[0, 0], [\"180 deg\", {force}], [\"360 deg\", 0]] }}\n\
         [input]\nlink = \"crank\"\n[motion]\nkind = \"steady\"\nmean_speed = \"120 rpm\"\nunevenness = 0.02\n\
         [drive]\nmotor = {{ power = \"1.1 kW\", synchronous_speed = \"1500 rpm\", rated_speed = \"1410 rpm\", \
         max_torque_ratio = 2.2, inertia = \"0.0045 kg*m^2\" }}\nefficiency = 0.8\nflywheel = \"solve\"\n{drive}"
    );
    let (linkage, loads) = compiled(&text);
    steady(&linkage, &loads, None)
}

#[test]
fn power_is_that_of_the_speed_that_a_given_ratio_gives() {
    let found = press(900.0, "ratio = 9\n").unwrap();
    let regime = &found.regime;
    // By an independent computation; 120 rpm would be 12.57 rad/s and 450 W.
    assert_relative_eq!(regime.figures.mean_speed, 16.91, max_relative = 2e-4);
    assert_relative_eq!(regime.figures.required_power, 606.0, max_relative = 2e-3);
    // It presses over about one stroke; the guide lies 20 mm beside the pin.
    let far = |arm: f64| (arm * arm - 0.02_f64 * 0.02).sqrt();
    let work = 900.0 * (far(0.45) - far(0.25));
    assert_relative_eq!(found.regime.resistance_work, work, max_relative = 0.02);
    let power = found.regime.resistance_work * regime.figures.mean_speed / (2.0 * PI * 0.8);
    assert_relative_eq!(regime.figures.required_power, power, max_relative = 1e-12);
    assert_relative_eq!(regime.figures.unevenness, 0.02, max_relative = 1e-9);
}

#[test]
fn a_motor_brakes_with_less_than_the_loads_drive() {
    // Pulled over that half of the cycle instead, the machine drives the motor through the reducer.
    let found = press(-900.0, "ratio = \"solve\"\n").unwrap();
    let regime = &found.regime;
    assert!(found.regime.resistance_work < 0.0);
    let power = found.regime.resistance_work * regime.figures.mean_speed / (2.0 * PI) * 0.8;
    assert_relative_eq!(regime.figures.required_power, power, max_relative = 1e-9);
    let motor = found.motor.unwrap();
    assert!(
        motor.work.torque[0] < 0.0 && regime.figures.mean_speed * regime.figures.ratio.unwrap() > 50.0 * PI
    );
}

/// A disc with a damper-like moment and a constant one.
fn disc(mean_speed: f64, drive: &str) -> Result<Steady, DynamicsError> {
    let text = format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.disc]\npoints = {{ O = 0 }}\nmass = 2\ninertia = 0.5\n\
         [[moment]]\nlink = \"disc\"\nvalue = {{ over = \"speed\", table = [[0, 6], [24, -6]] }}\n\
         [input]\nlink = \"disc\"\n[motion]\nkind = \"steady\"\nmean_speed = {mean_speed}\n{drive}"
    );
    let (linkage, loads) = compiled(&text);
    steady(&linkage, &loads, None)
}

#[test]
fn without_a_drive_another_speed_than_that_of_the_loads_is_refused() {
    // 6 - w/2 = 0.
    assert_relative_eq!(disc(12.0, "").unwrap().regime.figures.mean_speed, 12.0, max_relative = 1e-10);
    let error = disc(1.0, "").unwrap_err();
    let DynamicsError::OtherSpeed { wanted, found } = error else { panic!("{error}") };
    assert_relative_eq!(wanted, 1.0);
    assert_relative_eq!(found, 12.0, max_relative = 1e-10);
    // A moment that balances the loads makes any speed the mean one.
    let balanced = disc(4.0, "[drive]\ntorque = \"balance\"\n").unwrap();
    assert_relative_eq!(balanced.regime.figures.mean_speed, 4.0, max_relative = 1e-10);
    assert_relative_eq!(balanced.regime.figures.torque.unwrap(), -4.0, max_relative = 1e-10);
}

#[test]
fn an_inertia_that_vanishes_between_the_nodes_is_refused() {
    for from in ["0", "\"30 deg\"", "1.234"] {
        let text = format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\n\
             [link.rod]\npoints = {{ A = 0, B = 0.4 }}\n[link.piston]\npoints = {{ B = 0 }}\nmass = 1\n\
             [[slide]]\nlink = \"piston\"\non = \"ground\"\n[input]\nlink = \"crank\"\nfrom = {from}\n\
             [motion]\nkind = \"steady\"\nmean_speed = 10\n"
        );
        let (linkage, loads) = compiled(&text);
        let error = steady(&linkage, &loads, None).unwrap_err();
        let DynamicsError::NoInertia { coordinate, inertia } = error else { panic!("{from}: {error}") };
        assert!(inertia.abs() < 1e-300);
        // The piston stands in both dead points.
        assert!((coordinate / PI - (coordinate / PI).round()).abs() < 1e-6, "{coordinate}");
    }
}

/// A cycle of less than a turn ends in another position than it began in.
#[test]
fn a_cycle_after_which_the_machine_is_another_is_refused() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\nmass = 1\ncenter = \"O\"\ninertia = 0.1\n\
        [link.rod]\npoints = { A = 0, B = 0.4 }\n[link.piston]\npoints = { B = 0 }\nmass = 1\n\
        [[slide]]\nlink = \"piston\"\non = \"ground\"\n[input]\nlink = \"crank\"\ncycle = \"CYCLE\"\n\
        [motion]\nkind = \"steady\"\nmean_speed = 10\n[drive]\ntorque = \"balance\"\n";
    let found = |cycle: &str| {
        let (linkage, loads) = compiled(&scene.replace("CYCLE", cycle));
        steady(&linkage, &loads, None)
    };
    for whole in ["360 deg", "720 deg"] {
        assert!(found(whole).is_ok(), "{whole}");
    }
    for part in ["100 deg", "500 deg"] {
        let error = found(part).unwrap_err();
        assert!(
            matches!(&error, DynamicsError::NotRepeating { what, .. } if ["inertia", "inertia's derivative"].contains(&what.to_string().as_str())),
            "{part}: {error}"
        );
    }
    let loaded = |formula: &str| {
        let load =
            format!("[[moment]]\nlink = \"crank\"\nvalue = {{ formula = \"{formula}\", unit = \"N*m\" }}\n");
        let (linkage, loads) =
            compiled(&scene.replace("CYCLE", "360 deg").replace("[motion]", &format!("{load}[motion]")));
        steady(&linkage, &loads, None)
    };
    for repeating in ["5*sin(q)", "-5*step(cos(q))"] {
        assert!(loaded(repeating).is_ok(), "{repeating}");
    }
    for once in ["5*step(q - 7)", "-q"] {
        let error = loaded(once).unwrap_err();
        assert!(
            matches!(&error, DynamicsError::NotRepeating { what, .. } if what.to_string() == "moment"),
            "{once}: {error}"
        );
    }
}
