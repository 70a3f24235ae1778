//! Keys of the mechanism: links, slides, the input, the assembly.

use super::Kind::{ByInput, Count, Named, Place, Points, Quantity, Table as Is, Text, Two, Word};
use super::{Table, key};
use crate::units::Dimension::{Acceleration, Angle, Inertia, Length, Mass};

pub(crate) const SCENE: Table = Table {
    header: "",
    what: "scene-a-scene",
    keys: &[
        key("title", &[Text], "scene-key-title", "\"Slider-crank\"").or("\"\"").also("description"),
        key(
            "gravity",
            &[Quantity(Acceleration), Two(&Quantity(Acceleration))],
            "scene-key-gravity",
            "\"9.81 m/s^2\"",
        )
        .also("weight"),
        key("ground", &[Is("[ground]")], "scene-key-ground", "{ points = { O = 0 } }")
            .also("frame, base, fixed"),
        key("link", &[Is("[link.NAME]")], "scene-key-link", "{ crank = { points = { O = 0, A = 0.1 } } }")
            .needed()
            .also("links, body, bodies"),
        key("slide", &[Is("[[slide]]")], "scene-key-slide", "[{ link = \"ram\", on = \"ground\" }]")
            .also("slider, prismatic, guide, slides"),
        key("input", &[Is("[input]")], "scene-key-input", "{ link = \"crank\" }").needed().also("driver"),
        key("assembly", &[Is("[assembly]")], "scene-key-assembly", "{ B = [0.4, 0.1] }")
            .also("initial, guess"),
        key("force", &[Is("[[force]]")], "scene-key-force", LOAD).also("load, forces"),
        key("moment", &[Is("[[moment]]")], "scene-key-moment", "[{ link = \"crank\", value = 25 }]")
            .also("torque, couple, moments"),
        key(
            "spring",
            &[Is("[[spring]]")],
            "scene-key-spring",
            "[{ between = [\"C\", \"D\"], stiffness = 4530 }]",
        )
        .also("damper, springs"),
        key("contact", &[Is("[[contact]]")], "scene-key-contact", CONTACT).also("roller"),
        key("friction", &[Is("[[friction]]")], "scene-key-friction", FRICTION).also("rubbing"),
        key("brake", &[Is("[[brake]]")], "scene-key-brake", BRAKE),
        key("balance", &[Is("[balance]")], "scene-key-balance", "{ link = \"rod\" }"),
        key("motion", &[Is("[motion]")], "scene-key-motion", "{ speed = \"60 rpm\" }").also("velocity"),
        key("drive", &[Is("[drive]")], "scene-key-drive", "{ torque = \"balance\" }").also("motor, flywheel"),
        key("output", &[Is("[output]")], "scene-key-output", "{ points = [\"E\"] }").also("results"),
        key("note", &[Is("[note]")], "scene-key-note", "{ author = \"A. Student\" }").also("author, report"),
    ],
};

const LOAD: &str = "[{ link = \"ram\", at = \"B\", angle = \"180 deg\", value = \"1 kN\" }]";
const CONTACT: &str = "[{ link = \"rod\", center = \"N\", radius = 0.3, force = \"20 kN\" }]";
const FRICTION: &str = "[{ pair = \"A\", coefficient = 0.1, radius = 0.015 }]";
const BRAKE: &str = "[{ link = \"disc\", radius = 0.1, force = 80, friction = 0.1 }]";

pub(crate) const GROUND: Table = Table {
    header: "[ground]",
    what: "scene-the-ground",
    keys: &[key("points", &[Points], "scene-key-points-of-ground", "{ O = [0, 0], C = [\"-400 mm\", 0] }")
        .also("pins, joints, pivots")],
};

pub(crate) const LINK: Table = Table {
    header: "[link.NAME]",
    what: "scene-a-link",
    keys: &[
        key("points", &[Points], "scene-key-points", "{ O = 0, A = \"100 mm\" }")
            .needed()
            .also("pins, joints, length, l"),
        key("mass", &[Quantity(Mass)], "scene-key-mass", "\"4 kg\"").or("0").also("m, weight"),
        key("center", &[Place], "scene-key-center", "[\"50 mm\", 0]")
            .also("com, centroid, cog, center_of_mass, centre_of_mass, s"),
        key("inertia", &[Quantity(Inertia), Is("inertia = { ... }")], "scene-key-inertia", "\"0.04 kg*m^2\"")
            .or("0")
            .also("j, i, moment_of_inertia, js"),
    ],
};

pub(crate) const SLIDE: Table = Table {
    header: "[[slide]]",
    what: "scene-a-slide",
    keys: &[
        key("link", &[Named("link")], "scene-key-slide-link", "\"ram\"").needed().also("slider, body"),
        key("on", &[Named("link"), Word("ground")], "scene-key-slide-on", "\"ground\"")
            .needed()
            .also("guide, along"),
        key("through", &[Place], "scene-key-slide-through", "[0, \"20 mm\"]")
            .or("[0, 0]")
            .also("at, origin, offset, eccentricity"),
        key("angle", &[Quantity(Angle)], "scene-key-slide-angle", "\"90 deg\"")
            .or("0")
            .also("direction, axis"),
        key("point", &[Place], "scene-key-slide-point", "\"B\""),
        key("tilt", &[Quantity(Angle)], "scene-key-slide-tilt", "\"90 deg\"").or("0").also("rotation"),
        key("name", &[Text], "scene-key-slide-name", "\"guide\""),
    ],
};

pub(crate) const INPUT: Table = Table {
    header: "[input]",
    what: "scene-the-input",
    keys: &[
        key("link", &[Named("link")], "scene-key-input-link", "\"crank\"").needed(),
        key("from", &[ByInput(Angle, Length)], "scene-key-input-from", "\"30 deg\"")
            .or("0")
            .also("angle, start, begin, initial"),
        key("positions", &[Count], "scene-key-input-positions", "48").or("12").also("steps, step, count, n"),
        key("cycle", &[ByInput(Angle, Length)], "scene-key-input-cycle", "\"720 deg\"")
            .also("period, turn, stroke"),
        key("direction", &[Word("ccw"), Word("cw")], "scene-key-input-direction", "\"cw\"")
            .or("\"ccw\"")
            .also("sense, rotation"),
        key("to", &[ByInput(Angle, Length)], "scene-key-input-to", "\"120 deg\"").also("end, until"),
    ],
};

pub(crate) const ASSEMBLY: Table = Table {
    header: "[assembly]",
    what: "scene-the-assembly",
    keys: &[key("POINT", &[Two(&Quantity(Length))], "scene-key-assembly-point", "[\"170 mm\", \"280 mm\"]")],
};
