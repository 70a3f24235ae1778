use proptest::prelude::*;

use crate::PairSort::{Any, Pin, Slide};
use crate::plane::{cross, direction, dot, minus, mirrored, perp, times};
use crate::{
    Body, GroupError, GroupFrame, Order, Pair, PairGeometry, Pattern, PinJoint, RegistryError, SeenPair,
    SlideJoint, Wrench, derive_generally, groups, health_generally, place_by_newton, reactions_generally,
};
use assur_number::elimination::Lu;

fn pin(id: usize, a: usize, b: usize, at_a: [f64; 2], at_b: [f64; 2]) -> Pair {
    Pair { id, a, b, geometry: PairGeometry::Pin { at_a, at_b } }
}

fn slide(id: usize, a: usize, b: usize) -> Pair {
    let geometry = PairGeometry::Slide { point: [0.1, 0.2], through: [0.3, 0.4], angle: 0.5, tilt: 0.7 };
    Pair { id, a, b, geometry }
}

/// The triangle 3-4-5 of links 1 and 2 on the ground, pins at (0, 0), (1.8, 2.4), (5, 0).
fn triangle() -> (GroupFrame, [Body<f64>; 3]) {
    let frame = GroupFrame {
        links: vec![1, 2],
        inner: vec![pin(1, 1, 2, [3.0, 0.0], [4.0, 0.0])],
        outer: vec![pin(0, 1, 0, [0.0, 0.0], [0.0, 0.0]), pin(2, 2, 0, [0.0, 0.0], [5.0, 0.0])],
        driven: vec![],
        scale: 2.0,
    };
    let mut bodies = [Body::ground(); 3];
    (bodies[1].c, bodies[1].s) = (0.6, 0.8);
    (bodies[2].x, bodies[2].c, bodies[2].s) = (5.0, -0.8, 0.6);
    (frame, bodies)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-13
}

#[test]
fn general_derivatives_of_a_moving_base() {
    // The ground as a body that moves at (1, 0) and turns at 1: everything moves with it, as one body.
    let (frame, mut bodies) = triangle();
    (bodies[0].x1, bodies[0].w1, bodies[0].w2) = (1.0, 1.0, 0.25);
    derive_generally(&frame, &mut bodies, Order::Second).unwrap();
    for body in &bodies[1..] {
        assert!(close(body.w1, 1.0) && close(body.w2, 0.25));
        assert!(close(body.x1, 1.0 - body.y) && close(body.y1, body.x));
        assert!(close(body.x2, -0.25 * body.y - body.x) && close(body.y2, 0.25 * body.x - body.y));
    }
}

#[test]
fn general_reactions_of_two_force_members() {
    // 12 N down at the inner pin: 9.6 N along the first link, 7.2 N along the second, both pressed.
    let (frame, bodies) = triangle();
    let (mut loads, mut reactions) = ([Wrench::ZERO; 3], [Wrench::ZERO; 3]);
    loads[2].add_at(bodies[2].arm([4.0, 0.0]), [0.0, -12.0], 0.0);
    reactions_generally(&frame, &bodies, &mut loads, &mut reactions, 1).unwrap();
    assert!(close(reactions[0].fx, 5.76) && close(reactions[0].fy, 7.68));
    assert!(close(reactions[2].fx, -5.76) && close(reactions[2].fy, 4.32));
    assert!(close(loads[0].fx, 0.0) && close(loads[0].fy, -12.0) && close(loads[0].m, -12.0 * 1.8));
}

#[test]
fn newton_finds_the_triangle_from_beside_it() {
    let (frame, known) = triangle();
    let mut bodies = known;
    bodies[1].x += 0.1;
    (bodies[2].c, bodies[2].s) = (-1.0, 0.0);
    let health = place_by_newton(&frame, &mut bodies).unwrap();
    assert!(health > 0.01 && close(bodies[1].s, 0.8) && close(bodies[2].s, 0.6) && close(bodies[2].x, 5.0));
}

#[test]
fn newton_says_that_links_too_short_do_not_meet() {
    let (mut frame, mut bodies) = triangle();
    frame.outer[1] = pin(2, 2, 0, [0.0, 0.0], [8.0, 0.0]);
    assert!(place_by_newton(&frame, &mut bodies).is_err());
}

#[test]
fn a_singular_triangle_is_refused() {
    let (frame, mut bodies) = triangle();
    (bodies[1].c, bodies[1].s) = (1.0, 0.0);
    (bodies[2].c, bodies[2].s) = (-1.0, 0.0);
    assert!(health_generally(&frame, &bodies) < 1e-15);
    assert!(matches!(derive_generally(&frame, &mut bodies, Order::First), Err(GroupError::Singular { .. })));
    let (mut loads, mut reactions) = ([Wrench::ZERO; 3], [Wrench::ZERO; 3]);
    let answer = reactions_generally(&frame, &bodies, &mut loads, &mut reactions, 1);
    assert!(matches!(answer, Err(GroupError::Singular { .. })));
}

#[test]
fn groups_that_do_not_fit_are_errors_not_panics() {
    for (links, pairs) in [(10, 14), (2, 2), (2, 4), (0, 0), (3, 4)] {
        let frame = GroupFrame {
            links: (1..=links).collect(),
            inner: (0..pairs).map(|id| pin(id, 1, 0, [0.0, 0.0], [0.0, 0.0])).collect(),
            outer: vec![],
            driven: vec![],
            scale: 1.0,
        };
        let mut bodies = vec![Body::<f64>::ground(); links + 1];
        let error = derive_generally(&frame, &mut bodies, Order::First).unwrap_err();
        assert_eq!(error, GroupError::Unfit { links, pairs });
        let (mut loads, mut reactions) = (vec![Wrench::ZERO; links + 1], vec![Wrench::ZERO; pairs]);
        assert_eq!(reactions_generally(&frame, &bodies, &mut loads, &mut reactions, 1), Err(error));
        assert_eq!(place_by_newton(&frame, &mut bodies), Err(error));
        assert!(health_generally(&frame, &bodies) <= 0.0);
    }
}

#[test]
fn errors_read_as_sentences() {
    for (error, text) in [
        (GroupError::NoAssembly { gap_m: 0.012_345 }, "no assembly: it misses by 12.345000 mm"),
        (GroupError::Singular { health: 0.0 }, "singular position (dimensionless determinant 0.000e0)"),
        (
            GroupError::Singular { health: f64::NAN },
            "singular position (its determinant has no finite value)",
        ),
        (GroupError::Unfit { links: 10, pairs: 14 }, "10 links need 15 pairs, the group has 14"),
        (GroupError::Unfit { links: 4, pairs: 5 }, "4 links need 6 pairs, the group has 5"),
        (
            GroupError::SingularStart { health: 0.0 },
            "the starting guess is singular (dimensionless determinant 0.000e0): give `[assembly]` more points",
        ),
    ] {
        assert_eq!(error.to_string(), text);
    }
}

#[test]
fn no_number_is_no_health() {
    assert!(GroupError::if_singular(f64::NAN).is_err() && GroupError::if_nan(f64::NAN).is_err());
    assert!(GroupError::if_singular(1e-16).is_err() && GroupError::if_singular(1e-14).is_ok());
}

#[test]
fn a_program_without_plugins_is_told_so() {
    assert_eq!(groups().unwrap_err(), RegistryError::Empty(assur_words::text!("group-sort")));
}

#[test]
fn a_group_is_read_in_the_order_of_its_pattern() {
    let frame = |one: usize, two: usize, swap: bool| {
        let mut outer = vec![pin(0, 7, 3, [1.0, 0.0], [2.0, 0.0]), slide(2, 4, 8)];
        if swap {
            outer.reverse();
        }
        GroupFrame {
            links: vec![one, two],
            inner: vec![pin(1, 4, 3, [3.0, 0.0], [4.0, 0.0])],
            outer,
            driven: vec![],
            scale: 1.0,
        }
    };
    let pattern = Pattern { links: 2, inner: &[([0, 1], Pin)], outer: &[(0, Pin), (1, Slide)] };
    let other = Pattern { inner: &[([0, 1], Slide)], outer: &[(0, Pin), (1, Pin)], ..pattern };
    for frame in [frame(3, 4, false), frame(4, 3, false), frame(3, 4, true), frame(4, 3, true)] {
        let found = pattern.read(&frame).unwrap();
        assert_eq!(found.links, [3, 4]);
        let turned = [found.outer[0], found.inner[0], found.outer[1]].map(|seen| seen.turned);
        assert_eq!(turned, [true, true, false]);
        let end = PinJoint::<f64>::new(&found.outer[0]).unwrap();
        assert!(end.body == 7 && close(end.own[0], 2.0) && close(end.at[0], 1.0));
        assert_eq!(SlideJoint::<f64>::new(&found.outer[1]).unwrap().body, 8);
        let wrong = other.read(&frame).unwrap_err();
        assert_eq!(wrong.to_string(), "links and pairs of the group are not those of the kind");
        assert!(SlideJoint::<f64>::new(&found.outer[0]).is_err());
        assert!(PinJoint::<f64>::new(&found.outer[1]).is_err());
    }
}

#[test]
fn a_chain_of_two_links_on_one_outer_pair_is_no_dyad() {
    let outer = vec![pin(0, 1, 0, [0.0; 2], [0.0; 2]), pin(2, 1, 0, [1.0, 0.0], [1.0, 0.0])];
    let frame = GroupFrame {
        links: vec![1, 2],
        inner: vec![pin(1, 1, 2, [0.0; 2], [0.0; 2])],
        outer,
        driven: vec![],
        scale: 1.0,
    };
    let pattern = Pattern { links: 2, inner: &[([0, 1], Any)], outer: &[(0, Any), (1, Any)] };
    assert_eq!(pattern.find(&frame), None);
}

#[test]
fn a_pair_of_any_sort_takes_what_the_others_leave() {
    // Links 1 to 3 in a chain: both ends have one pair outside, the middle link two, of which only one may slide.
    let frame = GroupFrame {
        links: vec![2, 1, 3],
        inner: vec![pin(0, 2, 1, [0.0; 2], [0.0; 2]), slide(1, 3, 2)],
        outer: vec![
            pin(2, 1, 0, [0.0; 2], [0.0; 2]),
            pin(3, 2, 0, [0.0; 2], [0.0; 2]),
            slide(4, 9, 2),
            pin(5, 0, 3, [0.0; 2], [0.0; 2]),
        ],
        driven: vec![],
        scale: 1.0,
    };
    let inner = &[([0, 1], Any), ([1, 2], Any)];
    let outer = &[(0, Pin), (1, Any), (1, Pin), (2, Any)];
    let found = Pattern { links: 3, inner, outer }.find(&frame).unwrap();
    assert_eq!(found.links, [1, 2, 3]);
    let ids = |seen: &[SeenPair]| seen.iter().map(|seen| seen.pair.id).collect::<Vec<_>>();
    assert_eq!((ids(&found.inner), ids(&found.outer)), (vec![0, 1], vec![2, 4, 3, 5]));
    // With the slide of the chain at its other end only, the links are read the other way round.
    let found = Pattern { links: 3, inner: &[([0, 1], Slide), ([1, 2], Pin)], outer }.find(&frame).unwrap();
    assert_eq!(found.links, [3, 2, 1]);
    let all_pins = &[(0, Pin), (1, Pin), (1, Pin), (2, Pin)];
    assert_eq!(Pattern { links: 3, inner, outer: all_pins }.find(&frame), None);
}

fn body() -> impl Strategy<Value = Body<f64>> {
    (prop::array::uniform9(-2.0..2.0f64)).prop_map(|[x, y, angle, x1, y1, w1, x2, y2, w2]| {
        let [c, s] = direction(angle);
        Body { x, y, c, s, x1, y1, w1, x2, y2, w2 }
    })
}

proptest! {
    #[test]
    fn a_pair_turned_round_twice_is_the_pair(id in 0..9_usize, a in 0..9_usize, b in 0..9_usize) {
        for pair in [slide(id, a, b), pin(id, a, b, [1.0, 2.0], [3.0, 4.0])] {
            prop_assert_eq!(pair.turned_round().turned_round(), pair);
        }
    }

    #[test]
    fn hanging_a_link_by_a_point_gives_the_point_its_motion(
        mut body in body(), at in prop::array::uniform2(-1.0..1.0f64), pf in prop::array::uniform6(-3.0..3.0f64),
    ) {
        let arm = body.arm(at);
        body.hang_place(arm, [pf[0], pf[1]]);
        body.hang_first(arm, [pf[2], pf[3]]);
        body.hang_second(arm, [pf[4], pf[5]]);
        let found = [body.point(at), body.first(arm), body.second(arm)];
        for (found, wanted) in found.into_iter().flatten().zip(pf) {
            prop_assert!(close(found, wanted));
        }
    }

    #[test]
    fn second_is_the_derivative_of_first(body in body(), at in prop::array::uniform2(-1.0..1.0f64)) {
        // One small step along the motion: the arm turns by w h, its rates by the second derivatives.
        let h = 1e-6;
        let moved = |h: f64| {
            let [c, s] = body.turned(direction(body.w1 * h + body.w2 * h * h / 2.0));
            let (x1, y1, w1) = (body.x1 + body.x2 * h, body.y1 + body.y2 * h, body.w1 + body.w2 * h);
            let later = Body { c, s, x1, y1, w1, ..body };
            later.first(later.arm(at))
        };
        let (after, before) = (moved(h), moved(-h));
        let second = body.second(body.arm(at));
        for k in 0..2 {
            prop_assert!(((after[k] - before[k]) / (2.0 * h) - second[k]).abs() < 1e-7);
        }
    }

    #[test]
    fn a_wrench_has_one_moment_about_each_point(
        force in prop::array::uniform2(-3.0..3.0f64), arm in prop::array::uniform2(-3.0..3.0f64), m in -3.0..3.0f64,
    ) {
        let mut load = Wrench::ZERO;
        load.add_at(arm, force, m);
        prop_assert!(close(load.about(arm), m));
        prop_assert!(close(load.about([0.0, 0.0]), m + cross(arm, force)));
    }

    #[test]
    fn a_linear_system_is_solved(entries in prop::array::uniform32(-1.0..1.0f64), x in prop::array::uniform4(-1.0..1.0f64)) {
        let mut matrix = [[0.0; 4]; 4];
        for (i, row) in matrix.iter_mut().enumerate() {
            row.copy_from_slice(&entries[4 * i..4 * i + 4]);
        }
        let right = matrix.map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum());
        let lu = Lu::new(matrix);
        prop_assume!(lu.factored.health > 1e-3);
        for (found, known) in lu.solve(&right).into_iter().zip(x) {
            prop_assert!((found - known).abs() < 1e-10);
        }
    }

    #[test]
    fn vectors_turn_as_complex_numbers(angle in -3.0..3.0f64, a in prop::array::uniform2(-1.0..1.0f64)) {
        let turned = times(a, direction(angle));
        let back = times(turned, mirrored(direction(angle)));
        prop_assert!(close(dot(turned, turned), dot(a, a)));
        prop_assert!(close(back[0], a[0]) && close(back[1], a[1]));
        prop_assert!(close(cross(a, perp(a)), dot(a, a)) && close(minus(perp(perp(a)), a)[0], -2.0 * a[0]));
    }
}
