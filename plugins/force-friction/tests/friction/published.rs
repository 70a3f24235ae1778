//! Worked problems of textbooks, within their printed digits.

use assur_kinematics::Linkage;

use super::cases::{scene, solved};

/// N of a pound.
const LBF: f64 = 4.448_221_615_260_5;

/// The size of the balancing load in the middle of the range.
fn effort(linkage: &Linkage, coordinate: f64) -> f64 {
    let (found, _, count) = solved(linkage, "coulomb", coordinate).unwrap();
    assert_eq!(count, 1);
    found.abs()
}

/// A wedge that moves along a floor and drives a plunger along its own guide; all angles in degrees, that of the face against the
/// path of the wedge.
fn wedge([face, guide]: [f64; 2], [on_face, on_guides]: [f64; 2], direction: &str, load: &str) -> Linkage {
    scene(&format!(
        r#"
        [ground]
        points = {{ O = 0 }}
        [link.wedge]
        points = {{ W = 0 }}
        [link.block]
        points = {{ B = 0 }}
        [link.plunger]
        points = {{ B = 0 }}
        [[slide]]
        link = "wedge"
        on = "ground"
        [[slide]]
        link = "block"
        on = "wedge"
        angle = "{face} deg"
        [[slide]]
        link = "plunger"
        on = "ground"
        angle = "{guide} deg"
        [input]
        link = "wedge"
        from = 0.1
        to = 0.2
        positions = 3
        direction = "{direction}"
        [[force]]
        link = "plunger"
        at = "B"
        angle = "{} deg"
        value = "{load}"
        [[friction]]
        pair = "block/wedge"
        coefficient = {on_face}
        [[friction]]
        pair = "plunger/ground"
        coefficient = {on_guides}
        [[friction]]
        pair = "wedge/ground"
        coefficient = {on_guides}
        "#,
        guide - 180.0
    ))
}

/// F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, sample problem on wedges: a block of 400 lb beside a wall on a
/// wedge of 8 degrees, 0.35 on all surfaces, is raised by 423 lb and lowered by 206 lb, with angles that are rounded to tenths of a degree.
#[test]
fn a_block_is_raised_and_lowered_by_a_wedge() {
    for (direction, printed) in [("ccw", 423.0), ("cw", 206.0)] {
        let found = effort(&wedge([172.0, 90.0], [0.35; 2], direction, "400 lbf"), 0.15) / LBF;
        assert!((found - printed).abs() < 1.0, "{direction}: {found}");
    }
}

/// The greatest efficiency with which a block drives another one along a guide at 60 degrees to its own is 74.90 % (0.15 between the
/// blocks, 0.10 on the guides), with a common normal at 37.12 degrees: a worked example of textbooks on the theory of machines (chapter
/// on friction), from (cos(t + p + q) + 1) / (cos(t - p - q) + 1).
#[test]
fn blocks_on_crossing_guides_have_their_greatest_efficiency() {
    let efficiency = |normal: f64| {
        let effort = effort(&wedge([normal + 90.0, 60.0], [0.15, 0.10], "ccw", "1000 N"), 0.15);
        let [own, other] = [normal, 60.0 - normal].map(|angle| angle.to_radians().cos());
        1000.0 * own / (other * effort)
    };
    let greatest = efficiency(37.12);
    assert!((greatest - 0.7490).abs() < 5e-5, "{greatest}");
    assert!(efficiency(36.0) < greatest && efficiency(38.2) < greatest);
}

/// The same book on journals: a pulley of 4 in on a fixed shaft of 2 in, 0.20 between them, with 500 lb on one side. A vertical force of
/// 611 lb on the other raises it, 409 lb hold it.
#[test]
fn a_pulley_on_a_shaft_raises_and_holds() {
    for (direction, printed) in [("cw", 611.0), ("ccw", 409.0)] {
        let linkage = scene(&format!(
            r#"
            [ground]
            points = {{ O = 0 }}
            [link.pulley]
            points = {{ O = 0, L = [ "-2 in", 0 ], R = [ "2 in", 0 ] }}
            [input]
            link = "pulley"
            from = 0
            to = {}
            positions = 3
            direction = "{direction}"
            [[force]]
            link = "pulley"
            at = "L"
            angle = "-90 deg"
            value = "500 lbf"
            [balance]
            link = "pulley"
            at = "R"
            angle = "-90 deg"
            [[friction]]
            pair = "O"
            coefficient = 0.20
            radius = "1 in"
            "#,
            if direction == "cw" { -0.1 } else { 0.1 }
        ));
        let found = effort(&linkage, 0.0) / LBF;
        assert!((found - printed).abs() < 0.5, "{direction}: {found}");
    }
}

/// The same book: a bracket on a pipe of 3 in, in contact along 6 in, 0.25, bears a load by friction alone if this hangs at 12 in from
/// the axis of the pipe or farther.
#[test]
fn a_bracket_on_a_pipe_bears_a_load_far_enough_from_it() {
    let bracket = |arm: f64| {
        let linkage = scene(&format!(
            r#"
            [ground]
            points = {{ O = 0 }}
            [link.bracket]
            points = {{ K = 0, W = [0, "-{arm} in"] }}
            [[slide]]
            link = "bracket"
            on = "ground"
            angle = "90 deg"
            [input]
            link = "bracket"
            from = 0.2
            to = 0.1
            positions = 3
            direction = "cw"
            [[force]]
            link = "bracket"
            at = "W"
            angle = "-90 deg"
            value = 100
            [[friction]]
            pair = "bracket/ground"
            coefficient = 0.25
            length = "6 in"
            offset = "1.5 in"
            "#
        ));
        solved(&linkage, "coulomb", 0.15).unwrap().0
    };
    assert!(bracket(12.0).abs() < 1e-12, "{}", bracket(12.0));
    assert!(bracket(11.9) > 0.5 && bracket(12.1) < -0.5, "{} {}", bracket(11.9), bracket(12.1));
}

/// The uniform ladder between a wall and a floor of one coefficient, in every textbook of statics: it slips at an angle to the wall
/// above twice the angle of friction.
#[test]
fn a_ladder_slips_at_twice_the_angle_of_friction() {
    let (f, length) = (0.4_f64, 4.0);
    let ladder = |angle: f64| {
        let [x, y] = [length * angle.sin(), length * angle.cos()];
        let linkage = scene(&format!(
            r#"
            gravity = 10
            [ground]
            points = {{ O = 0 }}
            [link.foot]
            points = {{ A = 0 }}
            [link.ladder]
            points = {{ A = 0, B = {length}, S = {} }}
            mass = 20
            center = "S"
            [link.head]
            points = {{ B = 0 }}
            [[slide]]
            link = "foot"
            on = "ground"
            [[slide]]
            link = "head"
            on = "ground"
            angle = "90 deg"
            [assembly]
            B = [0, {y}]
            [input]
            link = "foot"
            from = {x}
            to = {}
            positions = 2
            [[friction]]
            pair = "foot/ground"
            coefficient = {f}
            [[friction]]
            pair = "head/ground"
            coefficient = {f}
            "#,
            length / 2.0,
            x + 0.1
        ));
        solved(&linkage, "coulomb", x).unwrap().0
    };
    let limit = 2.0 * f.atan();
    // What holds it, against the slipping, vanishes at the limit.
    assert!(ladder(limit).abs() < 1e-12 * 200.0, "{}", ladder(limit));
    assert!(ladder(limit + 0.01) < -0.1 && ladder(limit - 0.01) > 0.1, "{}", ladder(limit + 0.01));
}
