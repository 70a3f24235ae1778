use std::f64::consts::FRAC_PI_2;

use assur_group::{
    AssurGroup, Body, Closed, GroupError, GroupFrame, Order, Pair, PairGeometry, Wrench, plugin_for,
};

use crate::Rpp;

/// Scotch yoke: a stone (link 3) pinned to a crank (body 1) at the radius 2, on a yoke (link 2) with a guide across,
/// which slides along the x axis of the ground.
fn frame(angle: f64) -> GroupFrame {
    let slide = |id, a, b, angle| {
        let geometry = PairGeometry::Slide { point: [0.0, 0.0], through: [0.0, 0.0], angle, tilt: 0.0 };
        Pair { id, a, b, geometry }
    };
    let pin = PairGeometry::Pin { at_a: [2.0, 0.0], at_b: [0.0, 0.0] };
    GroupFrame {
        links: vec![2, 3],
        inner: vec![slide(1, 3, 2, angle)],
        outer: vec![slide(2, 2, 0, 0.0), Pair { id: 0, a: 1, b: 3, geometry: pin }],
        driven: vec![],
        scale: 1.0,
    }
}

fn bodies(q: f64) -> [Body<f64>; 4] {
    let mut bodies = [Body::ground(); 4];
    (bodies[1].s, bodies[1].c, bodies[1].w1) = (q.sin(), q.cos(), 1.0);
    bodies
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-14
}

#[test]
fn passes_the_conformance_suite() {
    assur_testkit::conformance("rpp");
}

#[test]
fn a_scotch_yoke_moves_as_the_cosine() {
    let group = Closed::<Rpp<f64>>::new(&frame(FRAC_PI_2)).unwrap();
    for step in 0..12 {
        let q = f64::from(step) * std::f64::consts::TAU / 12.0;
        let mut bodies = bodies(q);
        assert!(close(group.solve(&mut bodies, 0, Order::Second).unwrap(), 1.0));
        let yoke = &bodies[2];
        assert!(close(yoke.x, 2.0 * q.cos()) && close(yoke.y, 0.0) && close(yoke.w1, 0.0));
        assert!(close(yoke.x1, -2.0 * q.sin()) && close(yoke.x2, -2.0 * q.cos()));
        assert!(close(bodies[3].y, 2.0 * q.sin()) && close(bodies[3].y2, -2.0 * q.sin()));
    }
}

#[test]
fn a_push_on_the_yoke_reaches_the_crank_across_the_guide() {
    let group = Closed::<Rpp<f64>>::new(&frame(FRAC_PI_2)).unwrap();
    let mut bodies = bodies(FRAC_PI_2);
    group.place(&mut bodies, 0).unwrap();
    let (mut loads, mut reactions) = ([Wrench::ZERO; 4], [Wrench::ZERO; 3]);
    loads[2].fx = 7.0;
    group.reactions(&bodies, &mut loads, &mut reactions).unwrap();
    // 7 N to the crank's pin, 2 m above the ground's guide, which holds the moment of the couple.
    assert!(close(loads[1].fx, 7.0) && close(loads[1].fy, 0.0) && close(loads[1].m, -14.0));
    assert!(close(reactions[0].fx, 7.0) && close(reactions[1].fx, 7.0) && close(reactions[1].m, 0.0));
    assert!(close(reactions[2].fx, 0.0) && close(reactions[2].fy, 0.0) && close(reactions[2].m, -14.0));
}

#[test]
fn nearly_parallel_guides_keep_the_digits_of_their_angle() {
    // n1 (P - A) = 0 and P on the x axis: P = A - 2 sin q / tan(angle), exactly; d/dq = -2 sin q - 2 cos q / tan(angle).
    let q = 0.7;
    for angle in [1e-3, 1e-6, -1e-9, 1e-12] {
        // The link between the guides turned by -0.8 and its guide by 0.8 + angle: the same guides, seen otherwise.
        for tilt in [0.0, -0.8] {
            let mut frame = frame(angle - tilt);
            if let PairGeometry::Slide { tilt: turned, .. } = &mut frame.outer[0].geometry {
                *turned = tilt;
            }
            let between = (angle - tilt) + tilt;
            let group = Closed::<Rpp<f64>>::new(&frame).unwrap();
            let mut bodies = bodies(q);
            let health = group.solve(&mut bodies, 0, Order::Second).unwrap();
            let relative = |found: f64, wanted: f64| (found / wanted - 1.0).abs() < 4e-15;
            let cotangent = 1.0 / between.tan();
            assert!(relative(health, between.sin().abs()), "{angle}");
            assert!(relative(bodies[2].x, 2.0 * q.cos() - 2.0 * q.sin() * cotangent), "{angle}");
            assert!(relative(bodies[2].x1, -2.0 * q.sin() - 2.0 * q.cos() * cotangent), "{angle}");
            assert!(relative(bodies[2].x2, -2.0 * q.cos() + 2.0 * q.sin() * cotangent), "{angle}");
            // On the guide itself, however far away.
            assert!(bodies[2].y.abs() < 1e-15, "{angle}");
        }
    }
}

#[test]
fn parallel_guides_give_no_place() {
    let group = Closed::<Rpp<f64>>::new(&frame(0.0)).unwrap();
    assert_eq!(group.place(&mut bodies(1.0), 0), Err(GroupError::Singular { health: 0.0 }));
}

#[test]
fn is_found_in_the_registry() {
    let plugin = plugin_for(&frame(0.0)).unwrap().unwrap();
    assert_eq!((plugin.name, plugin.number), ("rpp", 5));
}

#[test]
fn the_moment_of_the_inner_slide_keeps_its_digits_near_parallel_guides() {
    // The stone is pinned where its slide has its point, away from its origin: the normal force has no lever, and the
    // moment is that of the load alone, however large the force.
    for power in 1..=13 {
        let mut frame = frame(0.1_f64.powi(power));
        let PairGeometry::Pin { at_b, .. } = &mut frame.outer[1].geometry else { panic!() };
        *at_b = [0.31, -0.17];
        let PairGeometry::Slide { point, .. } = &mut frame.inner[0].geometry else { panic!() };
        *point = [0.31, -0.17];
        let mut loads = [Wrench::ZERO; 4];
        loads[2] = Wrench { fx: 0.7 * 10.0_f64.powi(power), fy: -1.1, m: 0.4 };
        loads[3] = Wrench { fx: -0.3, fy: 0.9, m: 3.79 };
        let [found, exact] = assur_testkit::reactions("rpp", &frame, &bodies(0.7), &loads);
        for (found, exact) in found.iter().zip(&exact) {
            for (found, exact) in [(found.fx, exact.fx), (found.fy, exact.fy), (found.m, exact.m)] {
                let off = (found - exact).abs();
                assert!(off <= 16.0 * f64::EPSILON * exact.abs().max(1.0), "1e-{power}: {found} of {exact}");
            }
        }
        assert!((found[1].m.abs() - 3.79).abs() < 2.0, "1e-{power}: {}", found[1].m);
    }
}
