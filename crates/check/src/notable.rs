//! The states of a motion in which rounding is greatest.

use assur_force::{AnalyzerPlugin, Loads, Reactions, State};
use assur_group::{Order, Wrench};
use assur_kinematics::Linkage;

use crate::case::largest;

/// Condition, PF1, PF2, balancing load and reaction.
const QUANTITIES: usize = 5;

/// The numbers of the states with the greatest condition (the sum of 1/determinant over the groups), the greatest PF1
/// and PF2 of a link, and with `forces` the greatest balancing load and the greatest reaction. States that can't be
/// solved are left out.
pub fn notable(
    linkage: &Linkage,
    forces: Option<(&Loads, &AnalyzerPlugin)>,
    states: impl Iterator<Item = (usize, State)>,
) -> Vec<usize> {
    let mut greatest: [Option<(f64, usize)>; QUANTITIES] = [None; QUANTITIES];
    let mut position = linkage.position();
    let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
    let mut reactions = Reactions::new(linkage);
    let scale = linkage.structure.scale;
    for (number, state) in states {
        if linkage.solve(state.coordinate, Order::Second, &mut position).is_err() {
            continue;
        }
        let condition = position.health.iter().map(|health| 1.0 / health.abs()).sum();
        let mut found = [condition, 0.0, 0.0, 0.0, 0.0];
        for body in &position.bodies {
            let turn = body.w2.abs() + body.w1 * body.w1;
            found[1] = found[1].max(body.x1.hypot(body.y1) / scale + body.w1.abs());
            found[2] = found[2].max(body.x2.hypot(body.y2) / scale + turn);
        }
        if let Some((loads, method)) = forces {
            loads.evaluate(&state, &position.bodies, &mut wrenches);
            if method.instance.solve(linkage, &position, &mut wrenches, &mut reactions).is_ok() {
                found[3] = reactions.balancing.abs();
                found[4] = largest(&reactions.pairs, scale);
            }
        }
        for (most, value) in greatest.iter_mut().zip(found) {
            if value > most.map_or(0.0, |(value, _)| value) {
                *most = Some((value, number));
            }
        }
    }
    let mut numbers: Vec<usize> = greatest.into_iter().flatten().map(|(_, number)| number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}
