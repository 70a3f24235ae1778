//! `auto` is held to the chart, by counts of evaluations.

use assur_kinematics::Linkage;

use super::scenes::{charted, charted_of};
use crate::chart::{ChartData, Measurement, SettingValue, Stage};

/// At most so many times more evaluations than the best method that meets the tolerance.
const MOST: u64 = 3;

#[test]
fn auto_is_never_far_from_the_best() {
    for scene in ["andrews", "n-four-bar-2", "shaper-drive", "run-up", "brake"] {
        assert_near_the_best(scene, &charted(scene));
    }
}

/// J constant, M(w): a motor with its breakdown point and a constant load; a table over the speed.
#[test]
fn nor_where_the_moment_depends_on_the_speed_alone() {
    let motor = "[drive]\nmotor = { power = \"1.1 kW\", synchronous_speed = \"1500 rpm\", rated_speed = \"1410 rpm\", \
        max_torque_ratio = 2.2, inertia = \"0.0045 kg*m^2\" }\ncharacteristic = \"kloss\"\nratio = 1\n";
    let table = "[[moment]]\nlink = \"rotor\"\n\
        value = { over = \"speed\", table = [[0, 9], [60, 12], [110, 5], [150, -6]] }\n";
    for (name, driven) in [("motor", motor), ("table over the speed", table)] {
        for end in ["2 s", "30 s"] {
            let text = format!(
                "[ground]\npoints = {{ O = 0 }}\n[link.rotor]\npoints = {{ O = 0 }}\nmass = 20\ninertia = 0.8\n\
                 [[moment]]\nlink = \"rotor\"\nvalue = -4\n{driven}[input]\nlink = \"rotor\"\n\
                 [motion]\nkind = \"transient\"\nspeed = 0\nuntil = \"{end}\"\n"
            );
            let data = charted_of(&Linkage::compile(assur_scene::read(name, &text).unwrap()).unwrap());
            let auto: Vec<_> = data.of(Stage::Motion).filter(|row| row.auto).collect();
            let is_right = |row: &Measurement| row.method == "quadrature" && row.ok;
            assert!(!auto.is_empty() && auto.iter().all(|row| is_right(row)), "{name} {end}: {auto:?}");
            assert_near_the_best(name, &data);
        }
    }
}

fn assert_near_the_best(scene: &str, data: &ChartData) {
    for exponent in 3..=12 {
        let tolerance = 10.0_f64.powi(-exponent);
        let is_asked = |value| match value {
            Some(SettingValue::Number(set)) => (set / tolerance - 1.0).abs() < 1e-6,
            _ => true,
        };
        let mut own = data.of(Stage::Motion).filter(|row| row.auto);
        let own = own.find(|row| is_asked(row.setting.get("tolerance"))).unwrap();
        let good =
            data.of(Stage::Motion).filter(|row| row.ok && row.error.is_some_and(|error| error <= tolerance));
        let Some(best) = good.min_by_key(|row| row.evaluations) else { continue };
        assert!(
            own.evaluations.unwrap() <= MOST * best.evaluations.unwrap(),
            "{scene} at {tolerance:e}: auto takes {own:?}, the best is {best:?}"
        );
    }
}
