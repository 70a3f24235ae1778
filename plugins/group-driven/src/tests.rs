use assur_group::{Body, Driven, GroupFrame, Order, Pair, PairGeometry, groups};
use assur_number::elementary;

/// A forearm that turns by 0.7 rad, at 2 rad/s and -3 rad/s², in the end of an upper arm of 0.5 m, which stands at 0.4 rad and turns
/// at 1 rad/s.
#[test]
fn a_forearm_turns_with_the_arm_and_against_it() {
    let pin = PairGeometry::Pin { at_a: [0.0, 0.0], at_b: [0.5, 0.0] };
    let pair = Pair { id: 0, a: 2, b: 1, geometry: pin };
    let driven = vec![Driven { pair, coordinate: 3 }];
    let frame = GroupFrame { links: vec![2], driven, scale: 1.0, ..GroupFrame::default() };
    let turned = |angle: f64| {
        let (s, c) = elementary::sin_cos(angle);
        Body { c, s, ..Body::ground() }
    };
    let plugin = groups().unwrap().into_iter().find(|plugin| plugin.name == "driven-link").unwrap();
    let kernel = <f64 as assur_group::Number>::build(&plugin.builders, &frame).unwrap();
    let mut bodies = vec![
        Body::ground(),
        Body { w1: 1.0, ..turned(0.4) },
        Body::ground(),
        Body { w1: 2.0, w2: -3.0, ..turned(0.7) },
    ];
    let health = kernel.solve(&mut bodies, 0, Order::Second).unwrap();
    let (forearm, (s, c)) = (bodies[2], elementary::sin_cos(0.4));
    let expected = [
        (forearm.x, 0.5 * c),
        (forearm.y, 0.5 * s),
        (elementary::atan2(forearm.s, forearm.c), 1.1),
        (forearm.x1, -0.5 * s),
        (forearm.y1, 0.5 * c),
        (forearm.w1, 3.0),
        (forearm.x2, -0.5 * c),
        (forearm.y2, -0.5 * s),
        (forearm.w2, -3.0),
        (health, 1.0),
    ];
    assert!(expected.iter().all(|(found, wanted)| (found - wanted).abs() < 1e-14), "{expected:?}");
}
