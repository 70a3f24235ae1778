//! Keys of the task: balance, motion, drive, what is calculated, the note.

use super::Kind::{ByInput, Count, List, Named, Place, Quantity, Table as Is, Text, Word};
use super::{Table, key};
use crate::units::Dimension::{
    Acceleration, Angle, AngularAcceleration, AngularSpeed, Force, Inertia, Length, Moment, Number, Power,
    Speed, Time,
};

pub(crate) const BALANCE: Table = Table {
    header: "[balance]",
    what: "scene-the-balance",
    keys: &[
        key("link", &[Named("link")], "scene-key-balance-link", "\"ram\"").needed(),
        key("at", &[Place], "scene-key-balance-at", "\"K\"").also("point"),
        key("angle", &[Quantity(Angle)], "scene-key-balance-angle", "\"180 deg\"").also("direction"),
    ],
};

const PRESCRIBED: &str = "prescribed";
const TRANSIENT: &str = "transient";
const STEADY: &str = "steady";

pub(crate) const MOTION: Table = Table {
    header: "[motion]",
    what: "scene-the-motion",
    keys: &[
        key(
            "kind",
            &[Word("prescribed"), Word("transient"), Word("steady")],
            "scene-key-motion-kind",
            "\"steady\"",
        )
        .or("\"prescribed\"")
        .also("type"),
        key("speed", &[ByInput(AngularSpeed, Speed)], "scene-key-motion-speed", "\"60 rpm\"")
            .of("prescribed, transient")
            .also("omega, rpm, n, w, velocity, angular_velocity, w1"),
        key(
            "acceleration",
            &[ByInput(AngularAcceleration, Acceleration)],
            "scene-key-motion-acceleration",
            "\"4 rad/s^2\"",
        )
        .or("0")
        .of(PRESCRIBED)
        .also("epsilon, alpha"),
        key(
            "until",
            &[Quantity(Time), ByInput(Angle, Length), Word("rest"), Word("turn")],
            "scene-key-motion-until",
            "\"5 rev\"",
        )
        .needed()
        .of(TRANSIENT)
        .also("end, time, duration"),
        key("samples", &[Count], "scene-key-motion-samples", "200")
            .or("100")
            .of(TRANSIENT)
            .also("steps, output"),
        key("integrator", &[Named("plugin"), Word("auto")], "scene-key-motion-integrator", "\"dopri5\"")
            .or("\"auto\"")
            .of(TRANSIENT)
            .also("method, solver"),
        key("tolerance", &[Quantity(Number)], "scene-key-motion-tolerance", "1e-9")
            .or("1e-9")
            .of(TRANSIENT)
            .also("accuracy, rtol"),
        key("step", &[Quantity(Time), ByInput(Angle, Length)], "scene-key-motion-step", "\"1 ms\"")
            .of(TRANSIENT)
            .also("dt"),
        key("max_steps", &[Count], "scene-key-motion-max-steps", "1000000").of(TRANSIENT),
        key("mean_speed", &[ByInput(AngularSpeed, Speed)], "scene-key-motion-mean-speed", "\"60 rpm\"")
            .needed()
            .of(STEADY)
            .also("average_speed"),
        key("unevenness", &[Quantity(Number), Word("motor")], "scene-key-motion-unevenness", "0.05")
            .of(STEADY)
            .also("fluctuation, delta, irregularity"),
    ],
};

pub(crate) const DRIVE: Table = Table {
    header: "[drive]",
    what: "scene-the-drive",
    keys: &[
        key(
            "motor",
            &[Named("motor"), Word("auto"), Is("motor = { ... }")],
            "scene-key-drive-motor",
            "\"4A100L4\"",
        ),
        key("catalogue", &[Named("plugin")], "scene-key-drive-catalogue", "\"4A\"").also("catalog"),
        key("max_motor_speed", &[Quantity(AngularSpeed)], "scene-key-drive-max-motor-speed", "\"1500 rpm\""),
        key(
            "characteristic",
            &[Word("kloss"), Word("linear")],
            "scene-key-drive-characteristic",
            "\"linear\"",
        )
        .or("\"kloss\""),
        key("ratio", &[Quantity(Number), Word("solve")], "scene-key-drive-ratio", "\"solve\"")
            .or("1")
            .also("gear, reducer"),
        key("efficiency", &[Quantity(Number)], "scene-key-drive-efficiency", "0.95").or("1").also("eta"),
        key("torque", &[Word("balance"), ByInput(Moment, Force)], "scene-key-drive-torque", "\"balance\"")
            .also("moment"),
        key("flywheel", &[Quantity(Inertia), Word("solve")], "scene-key-drive-flywheel", "\"solve\"")
            .also("inertia"),
        key("flywheel_on", &[Word("crank"), Word("motor")], "scene-key-drive-flywheel-on", "\"motor\"")
            .or("\"crank\""),
    ],
};

pub(crate) const MOTOR: Table = Table {
    header: "motor = { ... }",
    what: "scene-a-motor",
    keys: &[
        key("power", &[Quantity(Power)], "scene-key-motor-power", "\"1.1 kW\"").needed(),
        key(
            "synchronous_speed",
            &[Quantity(AngularSpeed)],
            "scene-key-motor-synchronous-speed",
            "\"1500 rpm\"",
        )
        .needed(),
        key("rated_speed", &[Quantity(AngularSpeed)], "scene-key-motor-rated-speed", "\"1410 rpm\"")
            .needed()
            .also("speed"),
        key("max_torque_ratio", &[Quantity(Number)], "scene-key-motor-max-torque-ratio", "2.2"),
        key("inertia", &[Quantity(Inertia)], "scene-key-motor-inertia", "\"0.0045 kg*m^2\"").also("j"),
    ],
};

pub(crate) const OUTPUT: Table = Table {
    header: "[output]",
    what: "scene-the-output",
    keys: &[
        key("points", &[List(&Named("point"))], "scene-key-output-names", "[\"E\"]").or("[]"),
        key("links", &[List(&Named("link"))], "scene-key-output-names", "[\"ram\"]").or("[]"),
        key("slides", &[List(&Named("slide"))], "scene-key-output-names", "[\"ram/ground\"]").or("[]"),
        key("reactions", &[List(&Named("pair"))], "scene-key-output-names", "[\"A\"]").or("[]"),
    ],
};

pub(crate) const NOTE: Table = Table {
    header: "[note]",
    what: "scene-the-note",
    keys: &[
        key("author", &[Text], "scene-key-note-author", "\"A. Student\"").also("name"),
        key("group", &[Text], "scene-key-note-group", "\"ME-21\""),
        key("variant", &[Text], "scene-key-note-variant", "\"12\""),
        key("language", &[Word("en"), Word("uk"), Word("ru")], "scene-key-note-language", "\"uk\"")
            .or("\"en\""),
        key("positions", &[List(&Count)], "scene-key-note-positions", "[3, 27]").or("[]"),
    ],
};
