use assur_group::{
    AssurGroup, Body, Closed, GroupError, GroupFrame, Order, Pair, PairGeometry, Wrench, plugin_for,
};

use crate::Rrr;

/// Links 2 and 3 of lengths l1 and l2, with x axes towards the inner pin, on the bodies 0 at (0, 0) and 1 at (5, 0).
fn frame(l1: f64, l2: f64) -> GroupFrame {
    let pin = |id, a, b, at_a, at_b| Pair { id, a, b, geometry: PairGeometry::Pin { at_a, at_b } };
    GroupFrame {
        links: vec![2, 3],
        inner: vec![pin(1, 2, 3, [l1, 0.0], [l2, 0.0])],
        outer: vec![pin(0, 2, 0, [0.0, 0.0], [0.0, 0.0]), pin(2, 1, 3, [0.0, 0.0], [0.0, 0.0])],
        driven: vec![],
        scale: 1.0,
    }
}

fn bodies() -> [Body<f64>; 4] {
    let mut bodies = [Body::ground(); 4];
    bodies[1].x = 5.0;
    bodies
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-14
}

#[test]
fn passes_the_conformance_suite() {
    assur_testkit::conformance("rrr");
}

#[test]
fn triangle_3_4_5() {
    let group = Closed::<Rrr<f64>>::new(&frame(3.0, 4.0)).unwrap();
    let mut bodies = bodies();
    for (way, side) in [(0, 1.0), (1, -1.0)] {
        let health = group.place(&mut bodies, way).unwrap();
        assert!(close(health, 1.0));
        assert!(close(bodies[2].c, 0.6) && close(bodies[2].s, 0.8 * side));
        assert!(close(bodies[3].c, -0.8) && close(bodies[3].s, 0.6 * side));
        assert!(close(bodies[3].x, 5.0) && close(bodies[3].y, 0.0));
    }
}

#[test]
fn derivatives_of_triangle_3_4_5() {
    let group = Closed::<Rrr<f64>>::new(&frame(3.0, 4.0)).unwrap();
    let mut bodies = bodies();
    // Relative to B, A moves along x.
    bodies[1].x1 = -1.0;
    group.solve(&mut bodies, 0, Order::Second).unwrap();
    // C' = (0.36, 0.48): the part of A' along link 1, because link 2 moves C across itself.
    assert!(close(bodies[2].w1, 0.8 / 3.0) && close(bodies[3].w1, -0.6 / 4.0));
    // With the right angle at C the direction across link 1 is along link 2, and the other way round:
    // w1' l1 = -w2² l2, w2' l2 = +w1² l1.
    assert!(close(bodies[2].w2, -(0.15 * 0.15) * 4.0 / 3.0));
    assert!(close(bodies[3].w2, (0.8 / 3.0) * (0.8 / 3.0) * 3.0 / 4.0));
}

#[test]
fn two_force_members_carry_along_themselves() {
    let group = Closed::<Rrr<f64>>::new(&frame(3.0, 4.0)).unwrap();
    let mut bodies = bodies();
    group.place(&mut bodies, 0).unwrap();
    let (mut loads, mut reactions) = ([Wrench::ZERO; 4], [Wrench::ZERO; 3]);
    // 12 N down at C, applied to link 1: 9.6 N along link 1 and 7.2 N along link 2.
    loads[2].add_at(bodies[2].arm([3.0, 0.0]), [0.0, -12.0], 0.0);
    group.reactions(&bodies, &mut loads, &mut reactions).unwrap();
    assert!(close(reactions[0].fx, 5.76) && close(reactions[0].fy, 7.68));
    // Pair 2 names body 1 first: the reaction on that, along link 2 and pressing.
    assert!(close(reactions[2].fx, 5.76) && close(reactions[2].fy, -4.32));
    assert!(close(loads[1].fx, 5.76) && close(loads[1].fy, -4.32));
}

#[test]
fn says_by_how_much_it_misses() {
    for (l1, l2, gap) in [(2.0, 2.5, 0.5), (1.0, 6.25, 0.25), (7.0, 1.5, 0.5)] {
        let group = Closed::<Rrr<f64>>::new(&frame(l1, l2)).unwrap();
        let GroupError::NoAssembly { gap_m } = group.place(&mut bodies(), 0).unwrap_err() else {
            panic!("must say that there is no assembly");
        };
        assert!(close(gap_m, gap));
    }
}

#[test]
fn stretched_is_placed_but_not_differentiated() {
    let group = Closed::<Rrr<f64>>::new(&frame(2.0, 3.0)).unwrap();
    let mut bodies = bodies();
    assert!(close(group.place(&mut bodies, 0).unwrap(), 0.0));
    assert_eq!(group.derive(&mut bodies, Order::First), Err(GroupError::Singular { health: 0.0 }));
}

#[test]
fn equal_links_upon_each_other_point_anywhere() {
    let group = Closed::<Rrr<f64>>::new(&frame(2.0, 2.0)).unwrap();
    let mut bodies = [Body::ground(); 4];
    assert_eq!(group.place(&mut bodies, 0), Err(GroupError::Singular { health: 0.0 }));
    bodies[1].x = f64::NAN;
    assert!(matches!(group.place(&mut bodies, 0), Err(GroupError::Singular { health }) if health.is_nan()));
}

#[test]
fn a_link_needs_its_pins_apart() {
    let error = Closed::<Rrr<f64>>::new(&frame(0.0, 2.0)).unwrap_err();
    assert_eq!(error.to_string(), "link 1 of a group RRR needs its two pins apart; their distance is 0");
}

#[test]
fn is_found_in_the_registry() {
    let plugin = plugin_for(&frame(3.0, 4.0)).unwrap().unwrap();
    assert_eq!((plugin.name, plugin.number), ("rrr", 1));
}
