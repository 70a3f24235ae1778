//! Motors compared by the unevenness that they allow, beside the usual unevenness of machines (S stage 5).

use assur_analysis::results::MotorAdvice;
use assur_motor::{USUAL_SOURCE, USUAL_UNEVENNESS, rpm};

use super::layout::Page;
use super::number::{short, single};

/// The motors that suit a scene, the best first, out of `count`; `ascii`: no character beyond ASCII.
pub fn advice(motors: &[MotorAdvice], count: usize, ascii: bool) -> String {
    let mut page = Page::new(ascii);
    page.paragraph(&format!(
        "The first {} of {count} motors that have the power and keep the limit of speed",
        motors.len()
    ));
    write(motors, &mut page);
    page.finish()
}

/// The table of the motors, and the usual values.
pub(super) fn write(motors: &[MotorAdvice], page: &mut Page) {
    let row = |motor: &MotorAdvice| {
        let optional = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), short);
        let of = |value: fn(&assur_analysis::results::AdvisedRegime) -> f64| {
            motor.regime.as_ref().map_or_else(|| "-".to_owned(), |regime| single(value(regime)))
        };
        vec![
            motor.designation.clone(),
            motor.catalogue.clone(),
            short(motor.power / 1e3),
            short(rpm(motor.rated_speed)),
            of(|regime| regime.unevenness),
            of(|regime| regime.ratio),
            of(|regime| regime.flywheel),
            optional(motor.regime.as_ref().and_then(|regime| regime.torque_reserve)),
            optional(motor.mass),
        ]
    };
    let head =
        ["motor", "catalogue", "kW", "rpm", "unevenness", "ratio", "flywheel, kg·m²", "reserve", "mass, kg"];
    page.caption(
        "Greatest unevenness for which each motor stays on the stable section of its characteristic, with the flywheel for it; \
         reserve: breakdown torque over the greatest torque of the cycle",
    );
    page.rows(&head, &motors.iter().map(row).collect::<Vec<_>>());
    page.caption(&format!("Usual unevenness of machines ({USUAL_SOURCE})"));
    let usual: Vec<_> = USUAL_UNEVENNESS
        .iter()
        .map(|usual| {
            let [least, most] = usual.range.map(short);
            vec![usual.machine.to_owned(), if least == most { least } else { format!("{least} to {most}") }]
        })
        .collect();
    page.rows(&["machine", "unevenness"], &usual);
}
