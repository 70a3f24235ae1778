use std::f64::consts::FRAC_PI_2;

use assur_group::{
    AssurGroup, Body, Closed, GroupError, GroupFrame, Order, Pair, PairGeometry, Wrench, plugin_for,
};

use crate::Rrp;

/// A rod (link 3) of length 5 on body 1, and a slider (link 2) on the x axis of the ground.
fn frame(rod: f64) -> GroupFrame {
    let pin = |id, a, b, at_a, at_b| Pair { id, a, b, geometry: PairGeometry::Pin { at_a, at_b } };
    let guide = PairGeometry::Slide { point: [0.0, 0.0], through: [-9.0, 0.0], angle: 0.0, tilt: 0.0 };
    GroupFrame {
        links: vec![2, 3],
        inner: vec![pin(1, 2, 3, [0.0, 0.0], [rod, 0.0])],
        outer: vec![Pair { id: 2, a: 2, b: 0, geometry: guide }, pin(0, 3, 1, [0.0, 0.0], [0.0, 0.0])],
        driven: vec![],
        scale: 1.0,
    }
}

/// The outer pin at (0, y).
fn bodies(y: f64) -> [Body<f64>; 4] {
    let mut bodies = [Body::ground(); 4];
    bodies[1].y = y;
    bodies
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-14
}

#[test]
fn passes_the_conformance_suite() {
    assur_testkit::conformance("rrp");
}

#[test]
fn ladder_3_4_5() {
    let group = Closed::<Rrp<f64>>::new(&frame(5.0)).unwrap();
    let mut bodies = bodies(3.0);
    for (way, side) in [(0, 1.0), (1, -1.0)] {
        assert!(close(group.place(&mut bodies, way).unwrap(), 0.8));
        assert!(close(bodies[2].x, 4.0 * side) && close(bodies[2].y, 0.0) && close(bodies[2].c, 1.0));
        assert!(close(bodies[3].c, 0.8 * side) && close(bodies[3].s, -0.6));
    }
}

#[test]
fn the_foot_of_a_ladder_that_is_lifted() {
    // x² + (3 + q)² = 25: x' = -3/x, x'' = -(1 + x'²)/x.
    let group = Closed::<Rrp<f64>>::new(&frame(5.0)).unwrap();
    let mut bodies = bodies(3.0);
    bodies[1].y1 = 1.0;
    group.solve(&mut bodies, 0, Order::Second).unwrap();
    assert!(close(bodies[2].x1, -0.75) && close(bodies[2].y1, 0.0) && close(bodies[2].w1, 0.0));
    assert!(close(bodies[2].x2, -(1.0 + 0.5625) / 4.0) && close(bodies[2].y2, 0.0));
    assert!(close(bodies[3].w1, -0.25));
}

#[test]
fn a_push_on_the_slider_goes_along_the_rod() {
    let group = Closed::<Rrp<f64>>::new(&frame(5.0)).unwrap();
    let mut bodies = bodies(3.0);
    group.place(&mut bodies, 0).unwrap();
    let (mut loads, mut reactions) = ([Wrench::ZERO; 4], [Wrench::ZERO; 3]);
    loads[2].fx = -8.0;
    group.reactions(&bodies, &mut loads, &mut reactions).unwrap();
    // The rod pushes back with 8 N and, at 3 : 4, down with 6 N; the guide holds up.
    assert!(close(reactions[2].fx, 0.0) && close(reactions[2].fy, 6.0) && close(reactions[2].m, 0.0));
    assert!(close(reactions[1].fx, 8.0) && close(reactions[1].fy, -6.0));
    assert!(close(reactions[0].fx, 8.0) && close(reactions[0].fy, -6.0));
    assert!(close(loads[1].fx, -8.0) && close(loads[1].fy, 6.0));
    assert!(close(loads[0].fy, -6.0) && close(loads[0].m, -24.0));
}

#[test]
fn says_by_how_much_the_rod_is_too_short() {
    let group = Closed::<Rrp<f64>>::new(&frame(5.0)).unwrap();
    for y in [5.25, -5.25] {
        let error = group.place(&mut bodies(y), 0).unwrap_err();
        assert_eq!(error, GroupError::NoAssembly { gap_m: 0.25 });
    }
}

#[test]
fn an_upright_rod_is_placed_but_not_differentiated() {
    let group = Closed::<Rrp<f64>>::new(&frame(5.0)).unwrap();
    let mut bodies = bodies(5.0);
    assert!(close(group.place(&mut bodies, 0).unwrap(), 0.0));
    assert!(close(bodies[3].s, -1.0) && close(bodies[2].x, 0.0));
    assert!(matches!(group.derive(&mut bodies, Order::First), Err(GroupError::Singular { .. })));
    // The same guide on a body that is turned by a right angle is far from singular.
    let mut frame = frame(5.0);
    frame.outer[0].b = 4;
    let turned = Body { c: FRAC_PI_2.cos(), s: 1.0, ..Body::ground() };
    let [ground, end, ..] = bodies;
    let mut bodies = [ground, end, ground, ground, turned];
    assert!(close(Closed::<Rrp<f64>>::new(&frame).unwrap().place(&mut bodies, 0).unwrap(), 1.0));
}

#[test]
fn a_rod_needs_its_pins_apart() {
    let error = Closed::<Rrp<f64>>::new(&frame(0.0)).unwrap_err();
    assert_eq!(error.to_string(), "the rod of a group RRP needs its two pins apart; their distance is 0");
}

#[test]
fn is_found_in_the_registry() {
    let plugin = plugin_for(&frame(5.0)).unwrap().unwrap();
    assert_eq!((plugin.name, plugin.number), ("rrp", 2));
}

#[test]
fn the_moment_of_the_slide_keeps_its_digits_near_the_upright_rod() {
    // The slide has its point in the inner pin, away from the origin of the slider: the force across the guide, which
    // grows without bound, has no lever.
    for power in 2..=12 {
        let mut frame = frame(5.0);
        for at in [[0.31, -0.17], [0.0, 0.0]] {
            let (PairGeometry::Pin { at_a, .. }, PairGeometry::Slide { point, .. }) =
                (&mut frame.inner[0].geometry, &mut frame.outer[0].geometry)
            else {
                panic!("the frame has other pairs");
            };
            (*at_a, *point) = (at, [0.31, -0.17]);
            let mut loads = [Wrench::ZERO; 4];
            loads[2] = Wrench { fx: 0.7, fy: -1.1, m: 3.79 };
            loads[3] = Wrench { fx: -0.3, fy: 0.9, m: 0.4 };
            // With the pin in the origin it runs 0.17 m over the guide.
            let height = 5.0 * (1.0 - 0.1_f64.powi(power)) + (at[1] + 0.17);
            let [found, exact] = assur_testkit::reactions("rrp", &frame, &bodies(height), &loads);
            let (found, exact) = (found[2], exact[2]);
            // What the lever of the pin makes of the force is as sure as the force; without a lever all digits are.
            let lever = (at[0] - 0.31).abs();
            let unsure = 64.0 * f64::EPSILON * 10.0_f64.powi(power) * lever * exact.fy.abs();
            let off = (found.m - exact.m).abs();
            assert!(
                off <= 16.0 * f64::EPSILON * exact.m.abs().max(1.0) + unsure,
                "1e-{power}: {found:?} of {exact:?}"
            );
        }
    }
}
