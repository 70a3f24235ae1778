//! The greatest unevenness that a motor allows.

use approx::assert_relative_eq;

use assur_fixtures::scene;

use super::compiled;
use crate::{AdvisedRegime, DynamicsError, Steady, advise, section_margin, steady};

fn solved(unevenness: &str, characteristic: &str) -> Result<Steady, DynamicsError> {
    let text = scene("shaper-drive")
        .replace("unevenness = 0.05", &format!("unevenness = {unevenness}"))
        .replace("\"kloss\"", &format!("\"{characteristic}\""));
    let (linkage, loads) = compiled(&text);
    steady(&linkage, &loads, None)
}

fn margin(found: &Steady) -> f64 {
    section_margin(&found.regime, &found.motor.as_ref().unwrap().work.characteristic)
}

/// A little more leaves the section, a little less stays on it; the motor reaches an end of the section.
#[test]
fn no_greater_unevenness_keeps_the_motor_on_its_section() {
    for characteristic in ["kloss", "linear"] {
        let greatest = solved("\"motor\"", characteristic).unwrap();
        let found = greatest.regime.figures.unevenness;
        assert!((0.0..1e-9).contains(&margin(&greatest)), "{characteristic} {found}: {}", margin(&greatest));
        assert!(greatest.regime.flywheel > 0.0);
        let less = solved(&(0.99 * found).to_string(), characteristic).unwrap();
        assert!(margin(&less) > 0.0);
        let more = solved(&(1.01 * found).to_string(), characteristic);
        assert!(more.is_ok_and(|more| margin(&more) < 0.0), "{characteristic}");
    }
}

/// By the straight line the section ends where the line reaches the breakdown torque.
#[test]
fn the_section_of_a_straight_line_ends_at_the_breakdown_torque() {
    let found = solved("\"motor\"", "linear").unwrap();
    let characteristic = found.motor.unwrap().work.characteristic;
    let [low, high] = characteristic.stable_section();
    assert_relative_eq!(
        characteristic.torque(low),
        characteristic.breakdown_torque.unwrap(),
        max_relative = 1e-12
    );
    assert!(characteristic.torque(high).abs() < 1e-12);
}

/// Advice is what the scene gives with that motor.
#[test]
fn advice_is_the_regime_with_that_motor() {
    let (linkage, loads) = compiled(scene("shaper-drive"));
    let (advice, count) = advise(&linkage, &loads, 2).unwrap();
    assert!(advice.len() == 2 && count > 2);
    for one in &advice {
        let (text, _) = scene("shaper-drive").split_once("[drive]").unwrap();
        let drive = format!(
            "[drive]\nmotor = \"{}\"\ncatalogue = \"{}\"\nratio = \"solve\"\nefficiency = 0.95\nflywheel = \"solve\"\n",
            one.motor.designation, one.motor.catalogue
        );
        let text = text.replace("unevenness = 0.05", "unevenness = \"motor\"") + &drive;
        let (linkage, loads) = compiled(&text);
        let own = steady(&linkage, &loads, None).unwrap();
        let advised = one.regime.unwrap();
        assert_relative_eq!(advised.unevenness, own.regime.figures.unevenness);
        // Its torque at rest is that of its characteristic, and it is told to start where its warnings don't deny it.
        let work = &own.motor.as_ref().unwrap().work;
        assert_relative_eq!(advised.starting_load, work.starting_load, max_relative = 1e-9);
        let ratio = one.motor.starting_torque_ratio;
        let torque = ratio.map(|ratio| ratio * work.characteristic.rated_torque);
        assert_eq!(advised.starting_torque, torque.or_else(|| work.characteristic.starting_torque()));
        let warnings = &own.motor.as_ref().unwrap().warnings;
        let denied = warnings.iter().any(|warning| warning.text.to_string().starts_with("starting torque"));
        assert_eq!(advised.starts(), Some(!denied));
        let weak = AdvisedRegime { starting_torque: Some(0.5 * advised.starting_load), ..advised };
        assert_eq!(weak.starts(), Some(false));
    }
}
