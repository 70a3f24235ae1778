use assur_force::{Acting, LoadState, Loads};
use assur_geometry::{CenterAt, instant_centers};
use assur_group::plane::{minus, plus};
use assur_kinematics::Linkage;
use assur_words::Text;

use super::{all, reactions, solved, state};
use crate::plan::length;
use crate::{VectorKind, VectorPlan, acceleration_plan, force_polygons, velocity_plan};

/// Sum of the sides of a polygon, over the greatest of them.
fn left_open(plan: &VectorPlan) -> f64 {
    let sides = || plan.items.iter().filter(|item| item.kind != VectorKind::Inner);
    let sum = sides().fold([0.0; 2], |sum, side| plus(sum, minus(side.end, side.start)));
    let greatest = sides().map(|side| side.size).fold(0.0, f64::max);
    if greatest == 0.0 { 0.0 } else { length(sum) / greatest }
}

#[test]
fn polygons_close() {
    let mut polygons = 0;
    for (name, linkage) in all() {
        let loads = Loads::compile(&linkage).unwrap();
        for index in 0..linkage.mechanism.input.positions {
            let coordinate = linkage.mechanism.input.coordinate(index);
            let (position, state) = (solved(&linkage, coordinate), state(&linkage, coordinate));
            let Some(found) = reactions(&linkage, &loads, &state, &position) else { continue };
            let list = loads.acting(&state, &position.bodies);
            let plans = force_polygons(&linkage, &position, &list, &found);
            assert_eq!(plans.len(), linkage.structure.groups.len() + 1);
            for plan in plans {
                numbers_are_those_of_the_loads(&plan, &linkage, &list);
                assert!(left_open(&plan) < 1e-10, "{name} {index} {}: {}", plan.title, left_open(&plan));
                assert!(plan.residual < 1e-10);
                ends_meet(&plan);
                polygons += 1;
            }
        }
    }
    assert!(polygons > 500, "{polygons}");
}

/// A force with a number is that of the load with this number, in every polygon.
fn numbers_are_those_of_the_loads(plan: &VectorPlan, linkage: &Linkage, loads: &[Acting]) {
    for item in plan.items.iter().filter(|item| item.kind != VectorKind::Balancing) {
        let symbol = item.symbol.to_string();
        let Some(number) = symbol.strip_prefix('F').filter(|_| item.symbol != item.name) else { continue };
        let load = &loads[number.trim_end_matches('\u{2032}').parse::<usize>().unwrap() - 1];
        let name = Text::from(load.cause.name(&linkage.mechanism)).to_string();
        assert!(item.name.to_string().contains(&name), "{}: {symbol} is not {name}", plan.title);
    }
}

/// Each side begins where the one before ends, and the diagonal ends in the first corner.
fn ends_meet(plan: &VectorPlan) {
    let sides: Vec<_> = plan.items.iter().filter(|item| item.kind != VectorKind::Inner).collect();
    assert!(sides.windows(2).all(|two| length(minus(two[0].end, two[1].start)) == 0.0), "{}", plan.title);
    let diagonals: Vec<_> = plan.items.iter().filter(|item| item.kind == VectorKind::Inner).collect();
    if let [only] = diagonals.as_slice() {
        assert!(length(only.end) <= 1e-10 * plan.greatest(), "{plan:#?}");
    }
}

#[test]
fn parts_of_velocities_and_accelerations_reach_the_images() {
    for (name, linkage) in all() {
        for index in 0..linkage.mechanism.input.positions {
            let coordinate = linkage.mechanism.input.coordinate(index);
            let (position, state) = (solved(&linkage, coordinate), state(&linkage, coordinate));
            for motion in [None, Some(&state)] {
                let (v, a) = (
                    velocity_plan(&linkage, &position, motion),
                    acceleration_plan(&linkage, &position, motion),
                );
                assert!(v.residual < 1e-11, "{name} {index} {}", v.residual);
                assert!(a.residual < 1e-10, "{name} {index} {}", a.residual);
            }
        }
    }
}

#[test]
fn acceleration_parts_add_up_to_pf2_w2_and_pf1_e() {
    // Coriolis: A slides on the rocker of the shaper. Sum of the three parts against the point's own derivatives.
    let linkage = super::compile(&super::fixture("guide-shaper"));
    let state = LoadState { speed: 3.0, acceleration: -4.0, ..LoadState::default() };
    for index in 0..linkage.mechanism.input.positions {
        let position = solved(&linkage, linkage.mechanism.input.coordinate(index));
        let plan = acceleration_plan(&linkage, &position, Some(&state));
        let coriolis: Vec<_> = plan.items.iter().filter(|item| item.kind == VectorKind::Coriolis).collect();
        assert!(!coriolis.is_empty());
        for part in coriolis {
            let relative = plan
                .items
                .iter()
                .find(|item| length(minus(item.start, part.end)) == 0.0 && item.kind == VectorKind::Relative);
            let symbol = part.name.to_string();
            let point = symbol.trim_start_matches("ac(").split('/').next().unwrap();
            let Some(id) = linkage.mechanism.point(point) else { continue };
            let motion = linkage.point_motion(id, &position);
            let wanted = [0, 1].map(|k| motion.pf2[k] * 9.0 - motion.pf1[k] * 4.0);
            assert!(length(minus(relative.unwrap().end, wanted)) < 1e-11 * plan.greatest());
        }
    }
}

#[test]
fn normal_and_tangential_parts_are_square() {
    for (_, linkage) in all() {
        let coordinate = linkage.mechanism.input.coordinate(0);
        let plan =
            acceleration_plan(&linkage, &solved(&linkage, coordinate), Some(&state(&linkage, coordinate)));
        for two in plan.items.windows(2).filter(|two| two[0].kind == VectorKind::Normal) {
            let [n, t] = [0, 1].map(|k| minus(two[k].end, two[k].start));
            assert!((n[0] * t[0] + n[1] * t[1]).abs() <= 1e-12 * (1.0 + plan.greatest().powi(2)));
            assert_eq!(two[1].kind, VectorKind::Tangential);
        }
    }
}

#[test]
fn three_centers_lie_on_one_line() {
    // Aronhold and Kennedy, in homogeneous coordinates: a center at infinity is a direction.
    let mut triples = 0;
    for (name, linkage) in all() {
        let position = solved(&linkage, linkage.mechanism.input.coordinate(0));
        let centers = instant_centers(&linkage, &position);
        let at = |one: &str, two: &str| {
            let found = centers.iter().find(|center| {
                (center.link == one && center.against == two) || (center.link == two && center.against == one)
            });
            match found.unwrap().at {
                CenterAt::Point([x, y]) => {
                    let size = (x * x + y * y + 1.0).sqrt();
                    Some([x / size, y / size, 1.0 / size])
                }
                CenterAt::Direction([x, y]) => Some([x, y, 0.0]),
                CenterAt::Everywhere => None,
            }
        };
        let names: Vec<&str> = linkage.mechanism.links.iter().map(|link| link.name.as_str()).collect();
        for k in 2..names.len() {
            let three = [at("ground", names[1]), at("ground", names[k]), at(names[1], names[k])];
            let [Some(a), Some(b), Some(c)] = three else { continue };
            let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
            assert!(volume.abs() < 1e-9, "{name} {k} {volume}");
            triples += 1;
        }
    }
    assert!(triples > 50, "{triples}");
}
