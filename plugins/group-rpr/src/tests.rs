use assur_group::{
    AssurGroup, Body, Closed, GroupError, GroupFrame, Order, Pair, PairGeometry, Wrench, plugin_for,
};

use crate::Rpr;

/// A stone (link 2) pinned to body 1, on a rocker (link 3) pinned to the ground at (0, 0), its guide along its x axis;
/// the stone's pin lies `offset` to the left of the guide.
fn frame(offset: f64) -> GroupFrame {
    let pin = |id, a, b| Pair { id, a, b, geometry: PairGeometry::Pin { at_a: [0.0; 2], at_b: [0.0; 2] } };
    let guide = PairGeometry::Slide { point: [0.0, -offset], through: [0.0, 0.0], angle: 0.0, tilt: 0.0 };
    GroupFrame {
        links: vec![2, 3],
        inner: vec![Pair { id: 1, a: 2, b: 3, geometry: guide }],
        outer: vec![pin(0, 2, 1), pin(2, 3, 0)],
        driven: vec![],
        scale: 12.0,
    }
}

/// The stone's pin there.
fn bodies(x: f64, y: f64) -> [Body<f64>; 4] {
    let mut bodies = [Body::ground(); 4];
    (bodies[1].x, bodies[1].y) = (x, y);
    bodies
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-14
}

#[test]
fn passes_the_conformance_suite() {
    assur_testkit::conformance("rpr");
}

#[test]
fn a_rocker_points_at_the_pin_or_away_from_it() {
    let group = Closed::<Rpr<f64>>::new(&frame(0.0)).unwrap();
    let mut bodies = bodies(3.0, 4.0);
    for (way, side) in [(0, 1.0), (1, -1.0)] {
        // Distance 5 against the scale 12: 5/13.
        assert!(close(group.place(&mut bodies, way).unwrap(), 5.0 / 13.0));
        for link in [2, 3] {
            assert!(close(bodies[link].c, 0.6 * side) && close(bodies[link].s, 0.8 * side));
        }
        assert!(close(bodies[2].x, 3.0) && close(bodies[3].x, 0.0));
    }
}

#[test]
fn an_offset_makes_a_right_triangle() {
    let group = Closed::<Rpr<f64>>::new(&frame(3.0)).unwrap();
    let mut bodies = bodies(4.0, 3.0);
    group.place(&mut bodies, 0).unwrap();
    assert!(close(bodies[3].c, 1.0) && close(bodies[3].s, 0.0));
}

#[test]
fn a_pin_on_a_line_turns_the_rocker_as_the_tangent_says() {
    // Pin at (3, 4 + q): tan(angle) = (4 + q)/3; angle' = 3/25, angle'' = -2 * 3 * 4/25².
    let group = Closed::<Rpr<f64>>::new(&frame(0.0)).unwrap();
    let mut bodies = bodies(3.0, 4.0);
    bodies[1].y1 = 1.0;
    for way in [0, 1] {
        group.solve(&mut bodies, way, Order::Second).unwrap();
        for link in [2, 3] {
            assert!(close(bodies[link].w1, 0.12) && close(bodies[link].w2, -24.0 / 625.0));
        }
        assert!(close(bodies[2].y1, 1.0) && close(bodies[3].y1, 0.0));
    }
}

#[test]
fn a_moment_on_the_rocker_presses_the_stone() {
    let group = Closed::<Rpr<f64>>::new(&frame(0.0)).unwrap();
    let mut bodies = bodies(3.0, 4.0);
    group.place(&mut bodies, 0).unwrap();
    let (mut loads, mut reactions) = ([Wrench::ZERO; 4], [Wrench::ZERO; 3]);
    loads[3].m = 10.0;
    group.reactions(&bodies, &mut loads, &mut reactions).unwrap();
    // 10 N m at 5 m: 2 N across the rocker, on the stone counter-clockwise, handed on to body 1.
    assert!(close(reactions[1].fx, -1.6) && close(reactions[1].fy, 1.2) && close(reactions[1].m, 0.0));
    assert!(close(loads[1].fx, -1.6) && close(loads[1].fy, 1.2));
    assert!(close(loads[0].fx, 1.6) && close(loads[0].fy, -1.2) && close(loads[0].m, 0.0));
}

#[test]
fn says_by_how_much_the_pin_is_too_near() {
    let group = Closed::<Rpr<f64>>::new(&frame(-6.0)).unwrap();
    let error = group.place(&mut bodies(3.0, 4.0), 0).unwrap_err();
    assert_eq!(error, GroupError::NoAssembly { gap_m: 1.0 });
}

#[test]
fn pins_at_the_distance_of_the_offset_are_singular() {
    let group = Closed::<Rpr<f64>>::new(&frame(5.0)).unwrap();
    let mut bodies = bodies(3.0, 4.0);
    assert!(close(group.place(&mut bodies, 0).unwrap(), 0.0));
    assert!(matches!(group.derive(&mut bodies, Order::First), Err(GroupError::Singular { .. })));
    let central = Closed::<Rpr<f64>>::new(&frame(0.0)).unwrap();
    (bodies[1].x, bodies[1].y) = (0.0, 0.0);
    assert_eq!(central.place(&mut bodies, 0), Err(GroupError::Singular { health: 0.0 }));
}

#[test]
fn is_found_in_the_registry() {
    let plugin = plugin_for(&frame(0.0)).unwrap().unwrap();
    assert_eq!((plugin.name, plugin.number), ("rpr", 3));
}
