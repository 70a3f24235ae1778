use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use assur_group::{
    AssurGroup, Body, Closed, GroupError, GroupFrame, Order, Pair, PairGeometry, Wrench, plugin_for,
};

use crate::Prp;

/// A slider (link 2) on the x axis of the ground, pinned to one (link 3) on a line of body 1 through its origin.
fn frame(angle: f64) -> GroupFrame {
    let guide = |id, a, b, angle| {
        let geometry = PairGeometry::Slide { point: [0.0, 0.0], through: [0.0, 0.0], angle, tilt: 0.0 };
        Pair { id, a, b, geometry }
    };
    let pin = PairGeometry::Pin { at_a: [0.0, 0.0], at_b: [0.0, 0.0] };
    GroupFrame {
        links: vec![2, 3],
        inner: vec![Pair { id: 1, a: 2, b: 3, geometry: pin }],
        outer: vec![guide(0, 2, 0, 0.0), guide(2, 3, 1, angle)],
        driven: vec![],
        scale: 1.0,
    }
}

/// Body 1 at (0, -1).
fn bodies() -> [Body<f64>; 4] {
    let mut bodies = [Body::ground(); 4];
    bodies[1].y = -1.0;
    bodies
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-14
}

#[test]
fn passes_the_conformance_suite() {
    assur_testkit::conformance("prp");
}

#[test]
fn two_lines_at_45_degrees() {
    let group = Closed::<Prp<f64>>::new(&frame(FRAC_PI_4)).unwrap();
    let mut bodies = bodies();
    assert!(close(group.place(&mut bodies, 0).unwrap(), FRAC_1_SQRT_2));
    assert!(close(bodies[2].x, 1.0) && close(bodies[2].y, 0.0) && close(bodies[2].c, 1.0));
    assert!(close(bodies[3].x, 1.0) && close(bodies[3].y, 0.0) && close(bodies[3].c, FRAC_1_SQRT_2));
}

#[test]
fn a_line_that_turns_moves_the_crossing_as_the_cotangent() {
    // x = cot(45 degrees + q): x' = -2, x'' = 2 * 2 * cot = 4.
    let group = Closed::<Prp<f64>>::new(&frame(FRAC_PI_4)).unwrap();
    let mut bodies = bodies();
    bodies[1].w1 = 1.0;
    group.solve(&mut bodies, 0, Order::Second).unwrap();
    assert!(close(bodies[2].x1, -2.0) && close(bodies[2].y1, 0.0) && close(bodies[2].w1, 0.0));
    assert!(close(bodies[2].x2, 4.0) && close(bodies[2].y2, 0.0));
    assert!(close(bodies[3].w1, 1.0) && close(bodies[3].w2, 0.0) && close(bodies[3].x1, -2.0));
}

#[test]
fn a_wedge_holds_a_push() {
    let group = Closed::<Prp<f64>>::new(&frame(FRAC_PI_4)).unwrap();
    let mut bodies = bodies();
    group.place(&mut bodies, 0).unwrap();
    let (mut loads, mut reactions) = ([Wrench::ZERO; 4], [Wrench::ZERO; 3]);
    loads[2].fx = 5.0;
    group.reactions(&bodies, &mut loads, &mut reactions).unwrap();
    // The line at 45 degrees pushes back and up alike; the ground holds what goes up.
    assert!(close(reactions[1].fx, -5.0) && close(reactions[1].fy, 5.0));
    assert!(close(reactions[0].fx, 0.0) && close(reactions[0].fy, -5.0));
    assert!(close(loads[1].fx, 5.0) && close(loads[1].fy, -5.0) && close(loads[1].m, -10.0));
}

#[test]
fn parallel_guides_give_no_place() {
    let group = Closed::<Prp<f64>>::new(&frame(0.0)).unwrap();
    assert_eq!(group.place(&mut bodies(), 0), Err(GroupError::Singular { health: 0.0 }));
}

#[test]
fn is_found_in_the_registry() {
    let plugin = plugin_for(&frame(0.0)).unwrap().unwrap();
    assert_eq!((plugin.name, plugin.number), ("prp", 4));
}

#[test]
fn the_moments_of_the_slides_keep_their_digits_near_parallel_guides() {
    // Both slides have their points in the inner pin, away from the origins of the links: the large normal forces have no
    // lever, and the moments are those of the loads alone.
    for power in 1..=13 {
        let mut frame = frame(0.1_f64.powi(power));
        let places = [[0.31, -0.17], [-0.23, 0.11]];
        frame.inner[0].geometry = PairGeometry::Pin { at_a: places[0], at_b: places[1] };
        for (pair, place) in frame.outer.iter_mut().zip(places) {
            if let PairGeometry::Slide { point, .. } = &mut pair.geometry {
                *point = place;
            }
        }
        let mut loads = [Wrench::ZERO; 4];
        loads[2] = Wrench { fx: 0.7, fy: -1.1, m: 3.79 };
        loads[3] = Wrench { fx: -0.3, fy: 0.9, m: 0.4 };
        let [found, exact] = assur_testkit::reactions("prp", &frame, &bodies(), &loads);
        for pair in [0, 2] {
            let (found, exact) = (found[pair].m, exact[pair].m);
            assert!(
                (found - exact).abs() <= 16.0 * f64::EPSILON * exact.abs(),
                "1e-{power}: {found} of {exact}"
            );
        }
    }
}
