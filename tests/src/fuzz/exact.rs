//! Whether the program's numbers are right, by the same formulas in about 32 digits.

use assur_group::{Body, Order};
use assur_kinematics::{Chain, Linkage};
use assur_number::{Dd, Real};

/// A relative error above this is wrong, whatever a check may allow.
const RIGHT: f64 = 1e-6;

/// Whether all links of a mechanism agree with 32 digits in places, PF1 and PF2 in every position that can be solved; `false` too
/// where nothing can be compared.
pub(super) fn places_are_right(linkage: &Linkage) -> bool {
    let Ok(chain) = Chain::<Dd>::compile(&linkage.mechanism, &linkage.structure) else { return false };
    let (mut bodies, mut health) = (chain.bodies(), vec![Dd::ZERO; chain.groups.len()]);
    let mut position = linkage.position();
    let mut compared = 0;
    for index in 0..linkage.mechanism.input.positions {
        if linkage.solve_index(index, Order::Second, &mut position).is_err() {
            continue;
        }
        let q = position.coordinate;
        // Kinds that iterate begin where the program's numbers are.
        for (exact, found) in bodies.iter_mut().zip(&position.bodies) {
            *exact = found.map(Dd::from_f64);
        }
        let ways = linkage.ways.at(q);
        if chain.solve(Dd::from_f64(q), ways, Order::Second, &mut bodies, &mut health).is_err() {
            return false;
        }
        if error(&position.bodies, &bodies, linkage.structure.scale) > RIGHT {
            return false;
        }
        compared += 1;
    }
    compared > 0
}

/// Largest deviation of a quantity over its largest size.
fn error(found: &[Body<f64>], exact: &[Body<Dd>], scale: f64) -> f64 {
    // Which quantity each number of a body belongs to, and its least size.
    const QUANTITY: [usize; 10] = [0, 0, 1, 1, 2, 2, 3, 4, 4, 5];
    let mut sizes = [scale, 1.0, scale, 1.0, scale, 1.0];
    let mut errors = [0.0_f64; 6];
    for (found, exact) in found.iter().zip(exact) {
        for ((found, exact), quantity) in found.numbers().into_iter().zip(exact.numbers()).zip(QUANTITY) {
            sizes[quantity] = sizes[quantity].max(exact.to_f64().abs());
            errors[quantity] = errors[quantity].max((Dd::from_f64(found) - exact).to_f64().abs());
        }
    }
    errors.iter().zip(sizes).map(|(error, size)| error / size).fold(0.0, f64::max)
}
