//! Errors in places and transfer functions.

use assur_group::Body;
use assur_kinematics::Position;

use super::{Trial, Width, named};
use crate::check::Check;
use crate::closure::Closure;
use crate::kinetics;
use crate::subject::{Solved, Subject};
use crate::test_pf::TestPf;

/// The components of a place, or of its transfer function of an order.
fn of_order(body: &mut Body<f64>, order: usize) -> [&mut f64; 2] {
    match order {
        0 => [&mut body.x, &mut body.y],
        1 => [&mut body.x1, &mut body.y1],
        _ => [&mut body.x2, &mut body.y2],
    }
}

fn closure(subject: &Subject<'_>, one: &Solved, name: &str) -> Option<Check> {
    let mut closure = Closure::new(subject);
    closure.add(subject, one);
    named(closure.collectors(), name)
}

fn test_pf(subject: &Subject<'_>, one: &Solved, name: &str) -> Option<Check> {
    let mut test_pf = TestPf::new(subject);
    test_pf.add(one);
    named(test_pf.finish().0, name)
}

/// Plants an error in one link of a solved position of each mechanism.
fn planted(
    name: &str,
    check: fn(&Subject<'_>, &Solved, &str) -> Option<Check>,
    plant: impl Fn(&Subject<'_>, &mut Solved, usize, f64),
) -> Width {
    let mut width = Width::default();
    for trial in Trial::all() {
        if width.is_complete() {
            break;
        }
        let subject = trial.subject(&|_| None, None);
        let sound = subject.solve(trial.index, trial.mechanism().input.coordinate(trial.index)).unwrap();
        let link = 1 + trial.index % (sound.position.bodies.len() - 1);
        width.add(&format!("{name}, seed {}, link {link}", trial.seed), |error| {
            let mut wrong = sound.clone();
            plant(&subject, &mut wrong, link, error);
            check(&subject, &wrong, name)
        });
    }
    width
}

/// Moves a link, or changes its transfer function, by a part of a typical length.
fn moved(order: usize) -> impl Fn(&Subject<'_>, &mut Solved, usize, f64) {
    move |subject, one, link, error| {
        let by = error * subject.unit(order, true);
        let [x, y] = of_order(&mut one.position.bodies[link], order);
        (*x, *y) = (*x + 0.6 * by, *y + 0.8 * by);
    }
}

#[test]
fn a_gap_of_twice_the_limit_is_caught() {
    for (order, name) in ["closure PF0", "closure PF1", "closure PF2"].into_iter().enumerate() {
        planted(name, closure, moved(order)).judge(name, 1e-9, 1e-3);
    }
}

#[test]
fn a_direction_that_is_longer_by_twice_the_limit_is_caught() {
    let longer = |_: &Subject<'_>, one: &mut Solved, link: usize, error: f64| {
        let body = &mut one.position.bodies[link];
        (body.c, body.s) = ((1.0 + error) * body.c, (1.0 + error) * body.s);
    };
    planted("closure PF0", closure, longer).judge("closure PF0, direction", 1e-9, 1e-3);
}

/// Differences in 16 digits may judge with a limit of up to 1e-9 of what is compared; finer ones would take 32 digits everywhere.
#[test]
fn a_transfer_function_that_is_wrong_by_twice_the_limit_is_caught() {
    for (order, name) in [(1, "TestPf PF1"), (2, "TestPf PF2")] {
        planted(name, test_pf, moved(order)).judge(name, 1e-8, 5e-4);
    }
}

#[test]
fn a_turn_that_is_wrong_by_twice_the_limit_is_caught() {
    let first = |subject: &Subject<'_>, one: &mut Solved, link: usize, error: f64| {
        one.position.bodies[link].w1 += error * subject.unit(1, false);
    };
    planted("TestPf PF1", test_pf, first).judge("TestPf PF1, turn", 1e-8, 5e-4);
    let second = |subject: &Subject<'_>, one: &mut Solved, link: usize, error: f64| {
        one.position.bodies[link].w2 += error * subject.unit(2, false);
    };
    planted("TestPf PF2", test_pf, second).judge("TestPf PF2, turn", 1e-8, 5e-4);
}

#[test]
fn a_derivative_of_the_inertia_that_is_wrong_by_twice_the_limit_is_caught() {
    // The link with the greatest momentum is accelerated along its velocity: J' grows by 2 m v a.
    let along = |subject: &Subject<'_>, one: &mut Solved, _: usize, error: f64| {
        let links = &subject.linkage.mechanism.links;
        let Position { coordinate, ref bodies, .. } = one.position;
        let [inertia, _] = kinetics::reduced(&subject.linkage.mechanism, coordinate, bodies);
        let momentum = |(link, body): (usize, &Body<f64>)| {
            let v = body.first(body.arm(links[link].center)).map(|v| links[link].mass * v);
            (v[0].hypot(v[1]), link, v)
        };
        let all = one.position.bodies.iter().enumerate().skip(1).map(momentum);
        let Some((most, link, v)) = all.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|most| most.0 > 0.0) else {
            return;
        };
        let by = error * inertia / subject.linkage.coordinate_unit() / (2.0 * most * most);
        let body = &mut one.position.bodies[link];
        (body.x2, body.y2) = (body.x2 + by * v[0], body.y2 + by * v[1]);
    };
    planted("TestPf J'", test_pf, along).judge("TestPf J'", 1e-8, 5e-4);
}
