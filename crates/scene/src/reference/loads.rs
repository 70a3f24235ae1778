//! Keys of the loads: forces, moments, springs, contacts, brakes, friction in pairs.

use super::Kind::{ByInput, Flag, Named, Place, Quantity, Rows, Table as Is, Text, Two, Word};
use super::{Key, Table, key};
use crate::units::Dimension::{Angle, Damping, Force, Length, Moment, Number, Stiffness};

/// The name of a load.
const NAME: Key = key("name", &[Text], "scene-key-load-name", "\"cutting\"");
/// The factor on the size of a load.
const SCALE: Key = key("scale", &[Quantity(Number)], "scene-key-scale", "1.5").or("1").also("factor");
/// The link of a load.
const ON: Key = key("link", &[Named("link")], "scene-key-load-link", "\"ram\"").needed().also("on, body");
const VALUES: &str = "value = { ... }";

pub(crate) const FORCE: Table = Table {
    header: "[[force]]",
    what: "scene-a-force",
    keys: &[
        NAME,
        ON,
        key("at", &[Place], "scene-key-force-at", "\"B\"").needed().also("point, position"),
        key("angle", &[Quantity(Angle)], "scene-key-force-angle", "\"180 deg\"").also("direction, axis"),
        key("frame", &[Word("ground"), Word("link")], "scene-key-force-frame", "\"link\"").or("\"ground\""),
        key("value", &[Quantity(Force), Is(VALUES)], "scene-key-value", "\"1500 N\"")
            .needed()
            .also("magnitude, size, f, force, amount"),
        SCALE,
        key("against_motion", &[Flag], "scene-key-against-motion", "true")
            .or("false")
            .also("resistance, against"),
    ],
};

pub(crate) const MOMENT: Table = Table {
    header: "[[moment]]",
    what: "scene-a-moment",
    keys: &[
        NAME,
        ON,
        key("value", &[Quantity(Moment), Is(VALUES)], "scene-key-value", "\"25 N*m\"")
            .needed()
            .also("magnitude, size, m, moment, torque, amount"),
        SCALE,
    ],
};

pub(crate) const SPRING: Table = Table {
    header: "[[spring]]",
    what: "scene-a-spring",
    keys: &[
        NAME,
        key("between", &[Two(&Named("point"))], "scene-key-spring-between", "[\"C\", \"D\"]")
            .needed()
            .also("points, ends, from, to"),
        key("stiffness", &[Quantity(Stiffness)], "scene-key-spring-stiffness", "\"4530 N/m\"")
            .or("0")
            .also("k, c, rate"),
        key("length", &[Quantity(Length)], "scene-key-spring-length", "\"80 mm\"")
            .or("0")
            .also("free_length, rest_length, l0"),
        key("damping", &[Quantity(Damping)], "scene-key-spring-damping", "\"12 N*s/m\"")
            .or("0")
            .also("damper, b"),
    ],
};

pub(crate) const CONTACT: Table = Table {
    header: "[[contact]]",
    what: "scene-a-contact",
    keys: &[
        NAME,
        ON,
        key("center", &[Place], "scene-key-contact-center", "\"N\"").needed(),
        key("radius", &[Quantity(Length)], "scene-key-contact-radius", "\"300 mm\"").needed(),
        key("angle", &[Quantity(Angle), Is(VALUES)], "scene-key-contact-angle", "\"4 deg\"").or("0"),
        key("force", &[Quantity(Force), Is(VALUES)], "scene-key-contact-force", "\"20 kN\"")
            .needed()
            .also("value"),
        SCALE,
        key(
            "friction",
            &[Quantity(Number), Is("friction = { ... }")],
            "scene-key-contact-friction",
            "{ against_sliding = 0.1 }",
        )
        .or("0"),
        key(
            "during",
            &[Two(&ByInput(Angle, Length))],
            "scene-key-contact-during",
            "[\"-30 deg\", \"30 deg\"]",
        ),
    ],
};

pub(crate) const CONTACT_FRICTION: Table = Table {
    header: "friction = { ... }",
    what: "scene-friction-against-sliding",
    keys: &[key("against_sliding", &[Quantity(Number)], "scene-key-against-sliding", "0.1").needed()],
};

pub(crate) const BRAKE: Table = Table {
    header: "[[brake]]",
    what: "scene-a-brake",
    keys: &[
        NAME,
        ON,
        key("radius", &[Quantity(Length)], "scene-key-brake-radius", "\"100 mm\"").needed(),
        key("force", &[Quantity(Force), Is(VALUES)], "scene-key-brake-force", "\"80 N\"")
            .needed()
            .also("value"),
        key("lever", &[Quantity(Number)], "scene-key-brake-lever", "2").or("1"),
        SCALE,
        key("friction", &[Quantity(Number)], "scene-key-brake-friction", "0.1").needed().also("coefficient"),
    ],
};

/// The value of a load that is not one number; its sorts are those of tables, and a formula.
pub(crate) const VALUE: Table = Table {
    header: VALUES,
    what: "scene-table-of-a-load",
    keys: &[
        key(
            "over",
            &[Word("angle"), Word("time"), Word("speed"), Word("stroke")],
            "scene-key-over",
            "\"angle\"",
        )
        .needed()
        .of("angle, time, speed, stroke")
        .also("argument, variable"),
        key("table", &[Rows], "scene-key-table", "[[0, 0], [\"180 deg\", 40]]")
            .needed()
            .of("angle, time, speed")
            .also("rows, values, points, data"),
        key("shape", &[Word("linear"), Word("step")], "scene-key-shape", "\"step\"")
            .or("\"linear\"")
            .of("angle, time, speed, stroke")
            .also("interpolation"),
        key("repeat", &[Flag], "scene-key-repeat", "false").of("angle").also("periodic"),
        key("axis", &[Quantity(Angle)], "scene-key-axis", "\"180 deg\"").of("stroke, formula").also("angle"),
        key("forward", &[Quantity(Force), Rows], "scene-key-forward", "[[0.05, 0], [0.05, 1500]]")
            .or("0")
            .of("stroke"),
        key("back", &[Quantity(Force), Rows], "scene-key-back", "0").or("0").of("stroke").also("return"),
        FORMULA.of("formula"),
        UNIT.of("formula"),
    ],
};

const FORMULA: Key = key("formula", &[Text], "scene-key-formula", "\"5000 + 600*sin(2*q)\"")
    .needed()
    .also("expression, function");
const UNIT: Key = key("unit", &[Text], "scene-key-unit", "\"N*m\"");

pub(crate) const INERTIA: Table = Table {
    header: "inertia = { ... }",
    what: "scene-a-formula",
    keys: &[
        Key { about: "scene-key-inertia-formula", example: "\"0.02 + 0.01*cos(q)\"", ..FORMULA },
        Key { example: "\"kg*m^2\"", ..UNIT },
    ],
};

pub(crate) const FRICTION: Table = Table {
    header: "[[friction]]",
    what: "scene-a-friction",
    keys: &[
        key("pair", &[Named("pair")], "scene-key-friction-pair", "\"ram/ground\"")
            .needed()
            .also("joint, pin, slide, at, point"),
        key("coefficient", &[Quantity(Number)], "scene-key-friction-coefficient", "0.1")
            .needed()
            .also("f, mu, value, friction"),
        key("radius", &[Quantity(Length)], "scene-key-friction-radius", "\"15 mm\"")
            .needed()
            .of(PIN)
            .also("diameter, r"),
        key("owner", &[Named("link")], "scene-key-friction-owner", "\"crank\"").of(PIN).also("journal"),
        key("length", &[Quantity(Length)], "scene-key-friction-length", "\"120 mm\"").of(SLIDE),
        key("middle", &[Word("point"), Word("through")], "scene-key-friction-middle", "\"through\"")
            .or("\"point\"")
            .of(SLIDE),
        key("offset", &[Quantity(Length)], "scene-key-friction-offset", "\"10 mm\"").or("0").of(SLIDE),
    ],
};

const PIN: &str = "pin";
const SLIDE: &str = "slide";
