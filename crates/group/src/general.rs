//! The general solution: derivatives and reactions of any group from its pairs alone.
//!
//! The unknowns are the origins and angles of the links of the group; each pair gives two constraints Phi. The matrix
//! J = dPhi/du gives the derivatives from J u' and J u'', and its transpose gives the reactions. The rows of a pin
//! and the first row of a slide are lengths; they, and the columns of the angles, are divided by the scale of the
//! group, so J is dimensionless.

use assur_number::Real;

use crate::solver::{Solver, arms, driven_row, entries, rows};
use crate::{Body, Forces, GroupError, GroupFrame, Order, Pair, Wrench, plane::minus};

/// Calls a function with the solver for the number of links as its first type.
macro_rules! sized {
    ($frame:expr, $call:ident ( $($arg:expr),* ), $unfit:expr) => {
        match $crate::general::links_that_fit($frame) {
            Some(1 | 2) => $call::<T, assur_number::elimination::Lu<T, 6>>($($arg),*),
            Some(3 | 4) => $call::<T, assur_number::elimination::Lu<T, 12>>($($arg),*),
            Some(5 | 6) => $call::<T, assur_number::elimination::Lu<T, 18>>($($arg),*),
            Some(7 | 8) => $call::<T, assur_number::elimination::Lu<T, 24>>($($arg),*),
            Some(_) => $call::<T, assur_number::elimination::SparseLu<T>>($($arg),*),
            None => $unfit,
        }
    };
}

pub(crate) use sized;

/// Number of links, if the constraints are as many as the unknowns.
pub(crate) fn links_that_fit(frame: &GroupFrame) -> Option<usize> {
    let links = frame.links.len();
    let zero_mobility = 3 * links == frame.equations();
    (zero_mobility && links > 0).then_some(links)
}

pub(crate) fn unfit(frame: &GroupFrame) -> GroupError {
    GroupError::Unfit { links: frame.links.len(), pairs: frame.pairs().count() }
}

/// Right-hand sides: the motion of the outer bodies and, for the second order, minus the quadratic terms.
pub(crate) fn right_side<T: Real>(frame: &GroupFrame, bodies: &[Body<T>], second: bool, right: &mut [T]) {
    let mut row = 0;
    for pair in frame.pairs() {
        let (on_a, on_b) = arms(pair, bodies);
        for direction in rows(pair, bodies) {
            right[row] = match direction {
                Some(n) => point_side(frame, bodies, pair, [on_a, on_b], n, second),
                None => angle_side(frame, bodies, pair, second),
            };
            row += 1;
        }
    }
    for driven in &frame.driven {
        let coordinate = &bodies[driven.coordinate];
        let [along, turn] =
            if second { [coordinate.x2, coordinate.w2] } else { [coordinate.x1, coordinate.w1] };
        right[row] = if let Some(direction) = driven_row(driven, bodies) {
            // The relative acceleration of Coriolis is across the guide.
            let arms = arms(&driven.pair, bodies).into();
            (relative_side(frame, bodies, &driven.pair, arms, direction, second) + along)
                / T::from_f64(frame.scale)
        } else {
            angle_side(frame, bodies, &driven.pair, second) + turn
        };
        row += 1;
    }
}

/// The known side of a constraint of a pair in the direction n, with the acceleration of Coriolis.
fn point_side<T: Real>(
    frame: &GroupFrame,
    bodies: &[Body<T>],
    pair: &Pair,
    arms: [[T; 2]; 2],
    n: [T; 2],
    second: bool,
) -> T {
    let mut side = relative_side(frame, bodies, pair, arms, n, second);
    if second && pair.is_slide() {
        // Coriolis: n (a_a - a_b) = 2 w_b v_r, v_r along the guide; n is the guide turned by 90 degrees.
        let relative = minus(bodies[pair.a].first(arms[0]), bodies[pair.b].first(arms[1]));
        let along = n[1] * relative[0] - n[0] * relative[1];
        side += (bodies[pair.b].w1 * along).twice();
    }
    side * (T::ONE / T::from_f64(frame.scale))
}

/// Projection on n of the known motion of b minus that of a, at the point of a pair.
fn relative_side<T: Real>(
    frame: &GroupFrame,
    bodies: &[Body<T>],
    pair: &Pair,
    arms: [[T; 2]; 2],
    n: [T; 2],
    second: bool,
) -> T {
    let known = |body: usize, arm: [T; 2]| {
        let motion = &bodies[body];
        match (frame.column(body).is_some(), second) {
            (true, false) => [T::ZERO, T::ZERO],
            // For a link of the group only the centripetal part is known.
            (true, true) => {
                let square = motion.w1 * motion.w1;
                [-(square * arm[0]), -(square * arm[1])]
            }
            (false, false) => motion.first(arm),
            (false, true) => motion.second(arm),
        }
    };
    let difference = minus(known(pair.b, arms[1]), known(pair.a, arms[0]));
    n[0] * difference[0] + n[1] * difference[1]
}

fn angle_side<T: Real>(frame: &GroupFrame, bodies: &[Body<T>], pair: &Pair, second: bool) -> T {
    let known = |body: usize| match (frame.column(body), second) {
        (Some(_), _) => T::ZERO,
        (None, false) => bodies[body].w1,
        (None, true) => bodies[body].w2,
    };
    known(pair.b) - known(pair.a)
}

/// Computes PF1 and PF2 of the placed links of any group from its pairs.
///
/// # Errors
///
/// [`GroupError::Singular`] if J is singular, [`GroupError::Unfit`] for a wrong count of pairs.
pub fn derive_generally<T: Real>(
    frame: &GroupFrame,
    bodies: &mut [Body<T>],
    order: Order,
) -> Result<(), GroupError> {
    sized!(frame, derive_sized(frame, bodies, order), Err(unfit(frame)))
}

fn derive_sized<T: Real, S: Solver<T>>(
    frame: &GroupFrame,
    bodies: &mut [Body<T>],
    order: Order,
) -> Result<(), GroupError> {
    derive_by(&S::factor(frame, bodies, false), frame, bodies, order)
}

/// As [`derive_generally`] with the factored J.
pub(crate) fn derive_by<T: Real, S: Solver<T>>(
    lu: &S,
    frame: &GroupFrame,
    bodies: &mut [Body<T>],
    order: Order,
) -> Result<(), GroupError> {
    lu.determined()?;
    let scale = T::from_f64(frame.scale);
    let mut right = S::zeros(frame);
    // Both orders use the same J, which is factored once.
    for second in [false, true].into_iter().take(if order < Order::Second { 1 } else { 2 }) {
        right_side(frame, bodies, second, right.as_mut());
        let mut found = lu.solve(&right);
        refine(lu, frame, bodies, &mut right, &mut found);
        for (rates, &link) in found.as_ref().chunks_exact(3).zip(&frame.links) {
            let (x, y, w, body) = (rates[0] * scale, rates[1] * scale, rates[2], &mut bodies[link]);
            if second {
                (body.x2, body.y2, body.w2) = (x, y, w);
            } else {
                (body.x1, body.y1, body.w1) = (x, y, w);
            }
        }
        GroupError::if_nan(found.as_ref().iter().fold(T::ZERO, |sum, &entry| sum + entry))?;
    }
    Ok(())
}

/// Makes each unknown as accurate as the rounding of its own equations allows: elimination alone leaves in all of them the rounding of
/// the greatest, as of a link that turns fast in the accelerations of one that hardly moves. One step of refinement makes the
/// residual of each equation a rounding of its own terms (Skeel). `right`: the right-hand sides, of which the residuals are left.
fn refine<T: Real, S: Solver<T>>(
    lu: &S,
    frame: &GroupFrame,
    bodies: &[Body<T>],
    right: &mut S::Vector,
    found: &mut S::Vector,
) {
    let residual = right.as_mut();
    entries(frame, bodies, |row, column, entry| residual[row] -= entry * found.as_ref()[column]);
    let step = lu.solve(right);
    found.as_mut().iter_mut().zip(step.as_ref()).for_each(|(unknown, step)| *unknown += *step);
}

/// Dimensionless determinant of any placed group: smallest over greatest pivot of its J; 0 if the general solution
/// does not apply.
pub fn health_generally<T: Real>(frame: &GroupFrame, bodies: &[Body<T>]) -> f64 {
    fn sized<T: Real, S: Solver<T>>(frame: &GroupFrame, bodies: &[Body<T>]) -> f64 {
        S::factor(frame, bodies, false).factored().health
    }
    sized!(frame, sized(frame, bodies), 0.0)
}

/// Computes the reactions in the pairs of any group from the equilibrium of each link, with the transpose of J, under several sets
/// of loads, set after set: the matrix is factored once.
///
/// # Errors
///
/// [`GroupError::Singular`] where the equations of equilibrium cannot be solved, [`GroupError::Unfit`] for a wrong count of
/// pairs.
pub fn reactions_generally<T: Real>(
    frame: &GroupFrame,
    bodies: &[Body<T>],
    loads: &mut [Wrench<T>],
    reactions: &mut [Wrench<T>],
    sets: usize,
) -> Result<(), GroupError> {
    sized!(frame, reactions_sized(frame, bodies, loads, reactions, sets), Err(unfit(frame)))
}

fn reactions_sized<T: Real, S: Solver<T>>(
    frame: &GroupFrame,
    bodies: &[Body<T>],
    loads: &mut [Wrench<T>],
    reactions: &mut [Wrench<T>],
    sets: usize,
) -> Result<(), GroupError> {
    let lu = S::factor(frame, bodies, true);
    lu.determined()?;
    for Forces { loads, reactions } in Forces::sets(loads, reactions, sets) {
        balance(frame, bodies, &lu, loads, reactions);
    }
    Ok(())
}

fn balance<T: Real, S: Solver<T>>(
    frame: &GroupFrame,
    bodies: &[Body<T>],
    transposed: &S,
    loads: &mut [Wrench<T>],
    reactions: &mut [Wrench<T>],
) {
    let scale = T::from_f64(frame.scale);
    let inverse_scale = T::ONE / scale;
    let mut right = S::zeros(frame);
    for (part, &link) in right.as_mut().chunks_exact_mut(3).zip(&frame.links) {
        let load = &loads[link];
        part.copy_from_slice(&[-load.fx, -load.fy, -(load.m * inverse_scale)]);
    }
    let lambda = transposed.solve(&right);
    let (lambda, pairs) = (lambda.as_ref(), frame.pairs().count());
    for (k, pair) in frame.pairs().enumerate() {
        let (one, two) = (lambda[2 * k], lambda[2 * k + 1]);
        let mut reaction = match rows(pair, bodies) {
            [Some(n), None] => Wrench { fx: n[0] * one, fy: n[1] * one, m: two * scale },
            _ => Wrench { fx: one, fy: two, m: T::ZERO },
        };
        if let Some(at) = (k + frame.driven.len()).checked_sub(pairs) {
            let load = lambda[2 * pairs + at];
            match driven_row(&frame.driven[at], bodies) {
                Some(along) => {
                    reaction.fx += along[0] * load;
                    reaction.fy += along[1] * load;
                }
                None => reaction.m += load * scale,
            }
        }
        reactions[pair.id] = reaction;
        // An outer pair loads the body outside the group.
        let (on_a, on_b) = arms(pair, bodies);
        if frame.column(pair.b).is_none() {
            loads[pair.b].add_at(on_b, [-reaction.fx, -reaction.fy], -reaction.m);
        }
        if frame.column(pair.a).is_none() {
            loads[pair.a].add_at(on_a, reaction.force(), reaction.m);
        }
    }
}
