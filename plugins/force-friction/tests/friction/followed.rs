//! The solution that is followed from one evaluation of a motion to the next is one that a search from nothing finds.

use assur_force::{Followed, FreeMotion, LoadState, Loads, Piece, Reactions, find};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;

use super::cases::{Dice, SCENES, fixture, with_friction};

/// Places beside each other, as the evaluations of a step of an integrator are.
const PLACES: usize = 30;

/// The accelerations that are possible at a state without a drive.
fn accelerations(linkage: &Linkage, loads: &Loads, state: &LoadState, out: &mut Reactions) -> Vec<f64> {
    let mut position = linkage.position();
    linkage.solve(state.coordinate, Order::Second, &mut position).unwrap();
    let friction = out.friction.as_mut().unwrap();
    loads.enter_friction(state, &mut friction.senses, &mut Piece::UNBOUNDED.clone());
    let mut inertia = vec![Wrench::ZERO; position.bodies.len()];
    let unit = LoadState { coordinate: state.coordinate, acceleration: 1.0, ..LoadState::default() };
    loads.inertia(&unit, &position.bodies, &mut inertia);
    let wrenches = loads.total(state, &position.bodies);
    let motion = FreeMotion { loads: &wrenches, inertia: &inertia, drive: 0.0, drive_inertia: 0.0 };
    let found = find("coulomb").unwrap().instance.accelerations(linkage, &position, &motion, out);
    found.unwrap().unwrap().solutions.iter().map(|one| one.balancing).collect()
}

#[test]
fn a_followed_solution_is_one_that_a_search_finds() {
    let mut dice = Dice(17);
    let mut followed = 0;
    for round in 0..24 {
        for name in SCENES {
            let strength = 0.1 + 0.015 * f64::from(round);
            let linkage = Linkage::compile(with_friction(fixture(name), strength, &mut dice)).unwrap();
            let loads = Loads::compile(&linkage).unwrap();
            let new = || Reactions { unit: None, ..Reactions::new(&linkage).with_friction(&loads, &linkage) };
            let mut out = new();
            let input = &linkage.mechanism.input;
            let start = input.coordinate(2 * usize::try_from(round).unwrap() % input.positions);
            for place in 0..PLACES {
                let coordinate = start + 1e-4 * place as f64;
                let state = LoadState { coordinate, speed: 3.0, ..LoadState::default() };
                let before = out.friction.as_ref().unwrap().followed.left;
                let found = accelerations(&linkage, &loads, &state, &mut out);
                let Followed { left, .. } = out.friction.as_ref().unwrap().followed;
                if before == 0 || left + 1 != before {
                    continue;
                }
                let all = accelerations(&linkage, &loads, &state, &mut new());
                let near = |other: &&f64| (*other - found[0]).abs() <= 1e-9 * found[0].abs();
                assert!(
                    found.len() == 1 && all.iter().any(|other| near(&other)),
                    "{name}: {found:?} {all:?}"
                );
                followed += 1;
            }
        }
    }
    assert!(followed > 100, "{followed}");
}
