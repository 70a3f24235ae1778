//! Motors of the catalogues for the drive of the open scene.

use assur_mechanism::{Key, Torque};
use assur_motor::{Candidate, MotorFilter, SelectionRequest, catalogues, list_motors, rpm, select};
use assur_scene::{Dimension, edit, quantity};
use assur_words::{self as words, Describe, Text, name, number, text};

use super::draft;
use crate::number::digits;
use crate::screen::state::{Choice, Picker, PickerKind, Role, State};

pub(super) fn list(state: &mut State) {
    match suitable(state) {
        Ok((heading, rows)) => {
            let mut picker = Picker::new(PickerKind::Motors, heading, rows);
            picker.filter.typing = true;
            state.picker = Some(picker);
        }
        Err(text) => state.say(Role::Bad, text),
    }
}

/// `motors POWER, SPEED` of the `:` line: lists the motors of at least this power and at most this speed.
pub(super) fn limits(state: &mut State, rest: &str) {
    let read = |text: &str, dimension| quantity(text.trim(), dimension).map_err(|error| error.describe());
    let limits = match rest.split_once(',') {
        Some((power, speed)) => {
            read(power, Dimension::Power).and_then(|power| Ok([power, read(speed, Dimension::AngularSpeed)?]))
        }
        None => Err(text!("say-motors")),
    };
    match limits {
        Ok(limits) => {
            state.motor_limits = Some(limits);
            list(state);
        }
        Err(text) => state.say(Role::Bad, text),
    }
}

/// The motors that fit the drive of the scene under a heading that says what is asked of them; or why there are none.
fn suitable(state: &State) -> Result<(Text, Vec<Choice>), Text> {
    let drive = state.scene.as_ref().and_then(|scene| scene.linkage.mechanism.drive.as_ref());
    let Some(Torque::Motor { catalogue, max_speed, characteristic, .. }) = drive.map(|drive| &drive.torque)
    else {
        return Err(text!("say-no-motor-drive"));
    };
    let dynamics = state.found().and_then(|found| found.analysis.dynamics.as_ref());
    let dynamics = dynamics.ok_or_else(|| text!("say-no-regime"))?;
    let (required_power, max_motor_speed) = match state.motor_limits {
        Some([power, speed]) => (power, Some(speed)),
        None => (dynamics.figures.required_power, *max_speed),
    };
    let (input_speed, characteristic) = (dynamics.figures.mean_speed, *characteristic);
    let request = SelectionRequest { required_power, input_speed, max_motor_speed, characteristic };
    let filter = MotorFilter { catalogue: catalogue.clone(), ..MotorFilter::default() };
    let all = catalogues().and_then(|all| list_motors(&all, &filter)).map_err(|error| error.describe())?;
    let found = select(all, &request).map_err(|error| error.describe())?;
    // The load on the shaft of another motor, with the ratio that this one needs.
    let work = dynamics.motor.as_ref().map(|motor| &motor.work);
    let load = work.map(|work| work.starting_load * dynamics.figures.ratio.unwrap_or(1.0));
    let rows =
        std::iter::once(&found.chosen).chain(&found.runners_up).map(|candidate| row(state, candidate, load));
    let limit = max_motor_speed.map_or_else(Text::default, |speed| {
        text!("picker-motors-limit", speed = words::quantity(format_args!("{:.0}", rpm(speed)), "rpm"))
    });
    let power = words::quantity(digits(required_power / 1e3, 4), "kW");
    let heading = text!("picker-motors", power = power, limit = limit);
    Ok((heading, rows.collect()))
}

/// A row of the list; `load`: greatest torque of the load at rest, reduced to the input, N m.
fn row(state: &State, candidate: &Candidate<'_>, load: Option<f64>) -> Choice {
    let motor = candidate.motor;
    let told = |value: f64| state.told(number(digits(value, 4)));
    let or_dash = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), told);
    let torque = motor.max_torque_ratio.map(|ratio| ratio * motor.rated_power / motor.rated_speed);
    let reserve = torque.zip(load).filter(|(_, load)| *load > 0.0);
    let reserve = or_dash(reserve.map(|(torque, load)| torque * candidate.ratio / load));
    let text = format!(
        "{:<21} {:<12} {:>6} {:>9} {:>7} {:>7} {:>7}",
        motor.designation,
        motor.catalogue,
        told(motor.rated_power / 1e3),
        format!("{:.0}/{:.0}", rpm(motor.synchronous_speed), rpm(motor.rated_speed)),
        told(candidate.ratio),
        reserve,
        or_dash(motor.mass),
    );
    Choice { name: motor.designation.clone(), text }
}

pub(super) fn take(state: &mut State, designation: &str) {
    let (motor, key) = (name(designation.to_owned()), Key::of("drive").at("motor"));
    let is_by_data = !state.draft.values.iter().any(|value| value.key == key);
    // Data of a motor of the scene's own are replaced as a whole.
    let text = assur_draft::set(state.draft.text(), &key, &edit::quoted(designation));
    if draft::take(state, text) && is_by_data {
        let undo = name(state.keys.first("undo"));
        state.say(Role::Good, text!("say-motor-replaced", motor = motor, undo = undo));
    }
}
