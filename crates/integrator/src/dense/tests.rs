use super::*;

fn node(t: f64) -> Node {
    // q = t^5 - 2 t^3 + t, its derivatives w and a.
    let state = State {
        time: t,
        coordinate: t.powi(5) - 2.0 * t.powi(3) + t,
        speed: 5.0 * t.powi(4) - 6.0 * t * t + 1.0,
    };
    Node { state, acceleration: 20.0 * t.powi(3) - 12.0 * t }
}

#[test]
fn hermite_reproduces_a_coordinate_of_degree_five() {
    let dense = Dense::hermite(&node(0.3), &node(1.1));
    for k in 0..=8 {
        let t = 0.3 + 0.1 * f64::from(k);
        let found = dense.at((t - 0.3) / 0.8);
        assert!((found.coordinate - node(t).state.coordinate).abs() < 1e-14, "{found:?}");
    }
    // The speed is a cubic: exact at the ends, not between.
    assert!((dense.at(1.0).speed - node(1.1).state.speed).abs() < 1e-14);
    assert!((dense.at(0.5).speed - node(0.7).state.speed).abs() > 1e-3);
}

#[test]
fn parabola_is_uniformly_accelerated() {
    let from = Node { state: State { time: 1.0, coordinate: 2.0, speed: 3.0 }, acceleration: -4.0 };
    let dense = Dense::parabola(&from, 2.0);
    for theta in [0.0, 0.25, 0.5, 1.0] {
        let (found, dt) = (dense.at(theta), 2.0 * theta);
        assert!((found.coordinate - (2.0 + 3.0 * dt - 2.0 * dt * dt)).abs() < 1e-14);
        assert!((found.speed - (3.0 - 4.0 * dt)).abs() < 1e-14);
    }
}

#[test]
fn cubics_reproduce_a_motion_of_degree_three() {
    // q = 2 - t + t³.
    let node = |t: f64| {
        let state = State { time: t, coordinate: 2.0 - t + t * t * t, speed: 3.0 * t * t - 1.0 };
        Node { state, acceleration: 6.0 * t }
    };
    let dense = Dense::cubic(&node(0.3), &node(1.1), 0.8);
    for theta in [0.0, 0.1, 0.5, 0.7, 1.0] {
        let (found, wanted) = (dense.at(theta), node(0.3 + 0.8 * theta).state);
        assert!((found.coordinate - wanted.coordinate).abs() < 1e-14, "{theta}: {found:?}");
        assert!((found.speed - wanted.speed).abs() < 1e-14, "{theta}: {found:?}");
    }
}
