//! Closed forms, and the equations of the whole mechanism on random friction.

use assur_all as _;
use assur_force::{ForceError, Kinetostatics, LoadState, Loads, find, power};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_mechanism::{Friction, Mechanism, Middle, PairId, Surfaces};

/// The mechanism of a scene.
pub(super) fn scene(text: &str) -> Linkage {
    Linkage::compile(assur_scene::read("scene.toml", text).unwrap()).unwrap()
}

/// Balancing load, forces of friction and number of solutions at a coordinate, by a method.
pub(super) fn solved(
    linkage: &Linkage,
    method: &str,
    coordinate: f64,
) -> Result<(f64, Vec<f64>, usize), ForceError> {
    let loads = Loads::compile(linkage).unwrap();
    let carrying = vec![true; linkage.groups().len()];
    let mut forces = Kinetostatics::new(linkage, &loads, find(method).unwrap().instance, &carrying);
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    forces.solve(&LoadState::prescribed(&linkage.mechanism, coordinate), &position)?;
    let friction = forces.reactions.friction.unwrap();
    let several = friction.doubts.first().map_or(1, |(_, doubt)| doubt.solutions.len());
    Ok((forces.reactions.balancing, friction.forces, several))
}

/// The greatest part of the coefficients with a solution.
pub(super) fn limit(linkage: &Linkage, coordinate: f64) -> f64 {
    let loads = Loads::compile(linkage).unwrap();
    let carrying = vec![true; linkage.groups().len()];
    let mut forces = Kinetostatics::new(linkage, &loads, find("coulomb").unwrap().instance, &carrying);
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    forces.jamming_limit(&LoadState::prescribed(&linkage.mechanism, coordinate), &position).unwrap()
}

fn drawer(coefficient: f64, extra: &str) -> Linkage {
    scene(&format!(
        r#"
        [ground]
        points = {{ O = 0 }}
        [link.drawer]
        points = {{ K = [0, 0.4] }}
        [[slide]]
        link = "drawer"
        on = "ground"
        point = "K"
        through = [0, 0.4]
        [input]
        link = "drawer"
        from = 0
        to = 0.2
        positions = 3
        [[force]]
        link = "drawer"
        at = [0, 0.4]
        angle = "180 deg"
        value = 100
        [balance]
        link = "drawer"
        at = [0, 0]
        angle = 0
        [[friction]]
        pair = "drawer/ground"
        coefficient = {coefficient}
        length = 0.3
        {extra}
        "#
    ))
}

#[test]
fn a_drawer_jams_at_length_over_twice_the_offset() {
    for part in [0.2, 0.7, 0.999] {
        let (balancing, forces, count) = solved(&drawer(part * 0.375, ""), "coulomb", 0.1).unwrap();
        assert!((balancing * (1.0 - part) / 100.0 - 1.0).abs() < 1e-12, "{balancing}");
        assert!((forces[0] + balancing * part).abs() < 1e-12 * balancing, "{forces:?}");
        assert_eq!(count, 1);
        // The normal forces are a couple: the faces offset from the guide line change nothing.
        let (beside, ..) = solved(&drawer(part * 0.375, "offset = 0.02"), "coulomb", 0.1).unwrap();
        assert!((beside / balancing - 1.0).abs() < 1e-12);
    }
    let jammed = solved(&drawer(0.4, ""), "coulomb", 0.1);
    assert!(matches!(jammed, Err(ForceError::Jammed { .. })), "{jammed:?}");
    assert!((limit(&drawer(0.4, ""), 0.1) - 0.375 / 0.4).abs() < 1e-10);
    assert!((limit(&drawer(37.5, ""), 0.1) - 0.01).abs() < 1e-11);
}

#[test]
fn a_block_on_an_incline_has_the_angle_of_friction() {
    let incline = |coefficient: f64, direction: &str| {
        scene(&format!(
            r#"
            gravity = 10
            [ground]
            points = {{ O = 0 }}
            [link.block]
            points = {{ S = 0 }}
            mass = 2
            [[slide]]
            link = "block"
            on = "ground"
            angle = "30 deg"
            [input]
            link = "block"
            from = 0
            to = 0.2
            positions = 3
            direction = "{direction}"
            [[friction]]
            pair = "block/ground"
            coefficient = {coefficient}
            "#
        ))
    };
    let (s, c) = (0.5, 0.75_f64.sqrt());
    for f in [0.0, 0.1, 0.5, 0.9] {
        let up = solved(&incline(f, "ccw"), "coulomb", 0.1).unwrap().0;
        let down = solved(&incline(f, "cw"), "coulomb", 0.1).unwrap().0;
        assert!((up - 20.0 * (s + f * c)).abs() < 1e-12, "{up}");
        assert!((down - 20.0 * (s - f * c)).abs() < 1e-12, "{down}");
    }
}

/// A wedge that lifts a plunger by a block on its incline of 20 degrees.
fn wedge(coefficients: [f64; 3]) -> Linkage {
    let [incline, guide, base] = coefficients;
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
        angle = "180 deg"
        [[slide]]
        link = "block"
        on = "wedge"
        angle = "20 deg"
        [[slide]]
        link = "plunger"
        on = "ground"
        angle = "90 deg"
        [input]
        link = "wedge"
        from = 0.1
        to = 0.2
        positions = 3
        [[force]]
        link = "plunger"
        at = "B"
        angle = "-90 deg"
        value = 1000
        [[friction]]
        pair = "block/wedge"
        coefficient = {incline}
        [[friction]]
        pair = "plunger/ground"
        coefficient = {guide}
        [[friction]]
        pair = "wedge/ground"
        coefficient = {base}
        "#
    ))
}

#[test]
fn a_wedge_lifts_by_the_angles_of_friction() {
    for [incline, guide, base] in [[0.1, 0.2, 0.15], [0.3, 0.0, 0.4], [0.5, 0.6, 0.0]] {
        let angle = 20_f64.to_radians() + f64::atan(incline);
        let (s, c) = angle.sin_cos();
        let force = 1000.0 / (c - guide * s);
        let expected = force * (s + base * c);
        let (found, _, count) = solved(&wedge([incline, guide, base]), "coulomb", 0.15).unwrap();
        assert!((found.abs() / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        assert_eq!(count, 1);
    }
    // It jams where the line of force lies in the cone of the guide.
    let angle = |k: f64| 20_f64.to_radians() + f64::atan(k * 0.8);
    let found = limit(&wedge([0.8, 1.4, 0.1]), 0.15);
    assert!((angle(found).tan() * 1.4 * found - 1.0).abs() < 1e-9, "{found}");
}

/// A slider-crank with journals in all pins and a guide, under a force on the slider.
fn slider_crank(direction: &str, force: f64, coefficient: f64) -> Linkage {
    scene(&format!(
        r#"
        [ground]
        points = {{ O = 0 }}
        [link.crank]
        points = {{ O = 0, A = 0.1 }}
        [link.rod]
        points = {{ A = 0, B = 0.35 }}
        [link.piston]
        points = {{ B = 0 }}
        [[slide]]
        link = "piston"
        on = "ground"
        through = [0, 0.02]
        [assembly]
        B = [0.4, 0.02]
        [input]
        link = "crank"
        direction = "{direction}"
        [[force]]
        link = "piston"
        at = "B"
        angle = 0
        value = {force}
        [[friction]]
        pair = "O"
        coefficient = {coefficient}
        radius = 0.03
        [[friction]]
        pair = "A"
        coefficient = {coefficient}
        radius = 0.025
        [[friction]]
        pair = "B"
        coefficient = {coefficient}
        radius = 0.015
        [[friction]]
        pair = "piston/ground"
        coefficient = {coefficient}
        "#
    ))
}

/// The moment on the crank by the circles of friction: the force of the rod touches those of its two journals.
fn by_circles(linkage: &Linkage, coordinate: f64, force: f64, f: f64) -> Vec<f64> {
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::First, &mut position).unwrap();
    let [_, crank, rod, piston] = &position.bodies[..] else { return Vec::new() };
    let way = linkage.mechanism.input.sign();
    let (at_a, at_b) = ((rod.w1 - crank.w1) * way, rod.w1 * way);
    let sine = f * (0.025 * at_a.signum() + 0.015 * at_b.signum()) / 0.35;
    let angle = rod.s.atan2(rod.c);
    let mut all = Vec::new();
    // The rod is pulled or pushed: the force on it at B points away from A or to A.
    for pull in [1.0, -1.0] {
        let direction = if pull > 0.0 { angle + sine.asin() } else { angle - sine.asin() };
        let (s, c) = direction.sin_cos();
        let (x, y) = (pull * c, pull * s);
        // On the piston: force, minus that of the rod, normal force and friction.
        let guide = f * (piston.x1 * way).signum();
        let size = force / (x + guide * y.abs());
        if size < 0.0 {
            continue;
        }
        let (fx, fy) = (size * x, size * y);
        let (ax, ay) = (0.1 * crank.c, 0.1 * crank.s);
        // On the crank at A acts the force of the rod; the journals of A and of O turn against.
        let of_rod = f * 0.025 * at_a.signum() * size;
        let of_ground = -f * 0.03 * way * size;
        all.push(-(ax * fy - ay * fx + of_rod + of_ground));
    }
    all
}

#[test]
fn a_slider_crank_has_the_circles_of_friction() {
    let mut checked = 0;
    for direction in ["ccw", "cw"] {
        for force in [1000.0, -1000.0] {
            for i in 0..40 {
                let coordinate = 0.05 + f64::from(i) * 0.157;
                let linkage = slider_crank(direction, force, 0.15);
                let expected = by_circles(&linkage, coordinate, force, 0.15);
                let found = solved(&linkage, "coulomb", coordinate);
                match (found, &expected[..]) {
                    (Ok((moment, _, 1)), [one]) => {
                        assert!(
                            (moment - one).abs() < 1e-10 * 100.0,
                            "{direction} {force} {coordinate}: {moment} {one}"
                        );
                        checked += 1;
                    }
                    (Ok((_, _, count)), all) => assert_eq!(count, all.len(), "{coordinate}"),
                    (Err(error), all) => assert!(all.is_empty(), "{coordinate}: {error} {all:?}"),
                }
            }
        }
    }
    assert!(checked > 120, "{checked}");
}

/// Numbers in (-1, 1), one after the other.
pub(super) struct Dice(pub(super) u64);

impl Dice {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).unwrap()) / f64::from(1_u32 << 31) - 1.0
    }
}

/// Friction in all pairs.
pub(super) fn with_friction(mut mechanism: Mechanism, strength: f64, dice: &mut Dice) -> Mechanism {
    let size = 0.1;
    for (id, point) in mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin()) {
        let owner = point.places[if dice.next() > 0.0 { 0 } else { point.places.len() - 1 }].link;
        let surfaces = Surfaces::Journal { radius: size * (0.6 + 0.5 * dice.next()), owner };
        let coefficient = strength * (1.0 + dice.next());
        mechanism.frictions.push(Friction { pair: PairId::Pin(id), coefficient, surfaces });
    }
    for id in 0..mechanism.slides.len() {
        let surfaces = if dice.next() > 0.0 {
            Surfaces::Place
        } else {
            let middle = if dice.next() > 0.0 { Middle::Point } else { Middle::Through };
            let offset = if dice.next() > 0.0 { 0.3 * size * (1.0 + dice.next()) } else { 0.0 };
            Surfaces::Faces { length: size * (1.5 + dice.next()), middle, offset }
        };
        let coefficient = strength * (1.0 + dice.next());
        mechanism.frictions.push(Friction { pair: PairId::Slide(id), coefficient, surfaces });
    }
    mechanism
}

pub(super) const SCENES: [&str; 5] = ["shaper", "guide-shaper", "conveyor", "stephenson3", "andrews"];

pub(super) fn fixture(name: &str) -> Mechanism {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    assur_scene::read(name, &std::fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
fn both_methods_agree_on_random_friction() {
    let mut dice = Dice(11);
    let (mut same, mut jammed) = (0, 0);
    for round in 0..6 {
        for name in SCENES {
            let mut mechanism = fixture(name);
            if matches!(
                mechanism.motion,
                Some(assur_mechanism::Motion::Transient { .. } | assur_mechanism::Motion::Steady { .. })
            ) {
                mechanism.motion =
                    Some(assur_mechanism::Motion::Prescribed { speed: 6.0, acceleration: 3.0 });
            }
            let strength = if round % 2 == 0 { 0.02 } else { 0.15 };
            let linkage = Linkage::compile(with_friction(mechanism, strength, &mut dice)).unwrap();
            let coordinate = linkage.mechanism.input.coordinate(round % linkage.mechanism.input.positions);
            let [one, two] = ["coulomb", "newton-euler"].map(|method| solved(&linkage, method, coordinate));
            match (one, two) {
                (Ok((one, forces, 1)), Ok((two, others, _))) => {
                    same += 1;
                    let size = forces.iter().fold(one.abs(), |most, force| most.max(force.abs()));
                    assert!((one - two).abs() <= 1e-10 * size, "{name} {round}: {one} {two}");
                    for (a, b) in forces.iter().zip(&others) {
                        assert!((a - b).abs() <= 1e-10 * size, "{name} {round}: {forces:?} {others:?}");
                    }
                }
                (Err(ForceError::Jammed { .. }), Err(_)) => jammed += 1,
                (Ok(_), _) | (Err(_), Err(_)) => {}
                (Err(error), Ok(other)) => panic!("{name} {round}: {error}, but {other:?}"),
            }
        }
    }
    assert!(same > 15, "{same} agree, {jammed} jam");
}

#[test]
fn little_friction_costs_the_powers_of_the_ideal_reactions() {
    let mut dice = Dice(3);
    for name in SCENES {
        let mechanism = fixture(name);
        if mechanism.motion.is_some()
            && !matches!(mechanism.motion, Some(assur_mechanism::Motion::Prescribed { .. }))
        {
            continue;
        }
        let linkage = Linkage::compile(with_friction(mechanism, 1e-7, &mut dice)).unwrap();
        let loads = Loads::compile(&linkage).unwrap();
        let frictions = loads.frictions().unwrap();
        let carrying = vec![true; linkage.groups().len()];
        let mut ideal = Kinetostatics::new(&linkage, &loads, find("groups").unwrap().instance, &carrying);
        let coordinate = linkage.mechanism.input.coordinate(2);
        let mut position = linkage.position();
        linkage.solve(coordinate, Order::Second, &mut position).unwrap();
        let state = LoadState::prescribed(&linkage.mechanism, coordinate);
        ideal.solve(&state, &position).unwrap();
        let mut senses = vec![0.0; frictions.bearings.len()];
        loads.senses(&state, &position.bodies, &mut senses);
        let mut sum = ideal.reactions.balancing;
        for unknown in &frictions.unknowns {
            let bearing = &frictions.bearings[unknown.bearing];
            let [x, y] = unknown.vector(bearing, &position.bodies, &ideal.reactions.pairs);
            let factor = senses[unknown.bearing] * bearing.coefficient * x.hypot(y);
            let mut own = vec![assur_group::Wrench::ZERO; position.bodies.len()];
            let factor = if unknown.is_modulus() { factor } else { 0.0 };
            unknown.kind.load(bearing, &position.bodies, factor, &mut own);
            sum -= own.iter().zip(&position.bodies).map(|(load, body)| power(load, body)).sum::<f64>();
        }
        let (found, ..) = solved(&linkage, "coulomb", coordinate).unwrap();
        let loss = sum - ideal.reactions.balancing;
        assert!((found - sum).abs() <= 1e-4 * loss.abs() + 1e-13 * sum.abs(), "{name}: {found} {sum} {loss}");
        assert!(loss.abs() > 1e-11 * sum.abs(), "{name}");
    }
}

/// A parallelogram that drives a slider, whose pairs rub; a third crank is passive.
fn parallelogram(third: &str) -> Linkage {
    scene(&format!(
        r#"
        [ground]
        points = {{ O1 = [0, 0], O2 = [0.3, 0], O3 = [0.15, 0.1] }}
        [link.crank]
        points = {{ O1 = 0, A = 0.1 }}
        [link.coupler]
        points = {{ A = [0, 0], B = [0.3, 0], C = [0.15, 0.1], D = [0.2, 0.05] }}
        [link.crank2]
        points = {{ O2 = 0, B = 0.1 }}
        {third}
        [link.rod]
        points = {{ D = 0, E = 0.5 }}
        [link.piston]
        points = {{ E = 0 }}
        [[slide]]
        link = "piston"
        on = "ground"
        through = [0, 0.15]
        [assembly]
        B = [0.398, 0.017]
        E = [0.7, 0.15]
        [input]
        link = "crank"
        from = "10 deg"
        positions = 24
        [[force]]
        link = "rod"
        at = [0.2, 0]
        angle = "-80 deg"
        value = 200
        [[force]]
        link = "piston"
        at = "E"
        angle = 0
        value = 300
        [[friction]]
        pair = "D"
        coefficient = 2.5
        radius = 0.03
        [[friction]]
        pair = "E"
        coefficient = 2.5
        radius = 0.03
        [[friction]]
        pair = "piston/ground"
        coefficient = 2.5
        "#
    ))
}

#[test]
fn a_passive_link_leaves_all_solutions_as_they_are() {
    let [without, with] = ["", "[link.crank3]\npoints = { O3 = 0, C = 0.1 }"].map(parallelogram);
    assert_eq!(with.structure.passive.len(), 1);
    let mut counts = [0; 3];
    for index in 0..24 {
        let coordinate = without.mechanism.input.coordinate(index);
        match (solved(&without, "coulomb", coordinate), solved(&with, "newton-euler", coordinate)) {
            (Ok((one, forces, count)), Ok((other, others, too))) => {
                assert_eq!(count, too, "{index}");
                let all = std::iter::zip([&[one], &forces[..]].concat(), [&[other], &others[..]].concat());
                for (a, b) in all {
                    assert!((a - b).abs() < 1e-9 * 500.0, "{index}: {a} {b}");
                }
                counts[count.min(2)] += 1;
            }
            (Err(ForceError::Jammed { .. }), Err(ForceError::Jammed { .. })) => counts[0] += 1,
            (one, other) => panic!("{index}: {one:?} {other:?}"),
        }
    }
    assert!(counts.iter().all(|count| *count > 1), "{counts:?}");
}
