//! Checks of reactions.

use assur_group::{Body, PairGeometry, Wrench, reactions_generally};

use crate::Rng;
use crate::case::{Case, Fault};

/// Results of one call.
struct Answer {
    given: Vec<Wrench<f64>>,
    loads: Vec<Wrench<f64>>,
    reactions: Vec<Wrench<f64>>,
}

/// All checks of the reactions, with random loads.
pub(crate) fn all(case: &Case, way: usize, health: f64, rng: &mut Rng) -> Result<(), Fault> {
    let bodies = case.called("derive", case.solved(&*case.kernel, 0.0, way))?;
    let random = |_| Wrench { fx: rng.range(-1.0, 1.0), fy: rng.range(-1.0, 1.0), m: rng.range(-1.0, 1.0) };
    let given: Vec<_> = (0..bodies.len()).map(random).collect();
    let pairs = case.sample.frame.pairs().count();
    let mut answer = Answer { loads: given.clone(), given, reactions: vec![Wrench::ZERO; pairs] };
    case.called("reactions", case.kernel.reactions(&bodies, &mut answer.loads, &mut answer.reactions))?;
    equilibrium(case, &bodies, &answer, health)?;
    power(case, &bodies, &answer, health)?;
    general(case, &bodies, &answer, health)
}

fn parts(wrench: &Wrench<f64>) -> [f64; 3] {
    [wrench.fx, wrench.fy, wrench.m]
}

/// The closed forms agree with the transpose of J, in the reactions and in the loads passed to the outer bodies.
fn general(case: &Case, bodies: &[Body<f64>], answer: &Answer, health: f64) -> Result<(), Fault> {
    let mut loads = answer.given.clone();
    let mut reactions = vec![Wrench::ZERO; answer.reactions.len()];
    case.called("reactions", reactions_generally(&case.sample.frame, bodies, &mut loads, &mut reactions, 1))?;
    for (what, ours, theirs) in
        [("a reaction", &answer.reactions, &reactions), ("a load handed on", &answer.loads, &loads)]
    {
        for (ours, theirs) in ours.iter().zip(theirs) {
            for (a, b) in parts(ours).into_iter().zip(parts(theirs)) {
                case.within("reactions", what, a - b, 1e-13 / (health * health))?;
            }
        }
    }
    Ok(())
}

/// Each link is in equilibrium; each outer body gets the opposite of the reactions of its pairs; a guide exerts no
/// force along itself.
fn equilibrium(case: &Case, bodies: &[Body<f64>], answer: &Answer, health: f64) -> Result<(), Fault> {
    let limit = 1e-13 / (health * health);
    let mut sums = answer.given.clone();
    for pair in case.sample.frame.pairs() {
        let reaction = answer.reactions[pair.id];
        let a = &bodies[pair.a];
        let point = match pair.geometry {
            PairGeometry::Pin { at_a, .. } => {
                case.within("equilibrium", "the moment of a pin", reaction.m, 0.0)?;
                a.point(at_a)
            }
            PairGeometry::Slide { point, angle, .. } => {
                let t = bodies[pair.b].turned([angle.cos(), angle.sin()]);
                case.within(
                    "equilibrium",
                    "force along a guide",
                    t[0] * reaction.fx + t[1] * reaction.fy,
                    limit,
                )?;
                a.point(point)
            }
        };
        for (body, sign) in [(pair.a, 1.0), (pair.b, -1.0)] {
            let arm = [point[0] - bodies[body].x, point[1] - bodies[body].y];
            sums[body].add_at(arm, [sign * reaction.fx, sign * reaction.fy], sign * reaction.m);
        }
    }
    for (i, sum) in sums.iter().enumerate() {
        let (left, wanted) = match case.sample.frame.column(i) {
            Some(_) => (sum, &Wrench::ZERO),
            None => (&answer.loads[i], sum),
        };
        for (a, b) in parts(left).into_iter().zip(parts(wanted)) {
            case.within("equilibrium", "a body", a - b, limit)?;
        }
    }
    Ok(())
}

fn power_of(load: &Wrench<f64>, body: &Body<f64>) -> f64 {
    load.fx * body.x1 + load.fy * body.y1 + load.m * body.w1
}

/// Virtual power: that of the loads on the links equals that of the forces on the outer bodies. Relates derivatives
/// to reactions.
fn power(case: &Case, bodies: &[Body<f64>], answer: &Answer, health: f64) -> Result<(), Fault> {
    let (mut inside, mut handed_on, mut size) = (0.0, 0.0, 1.0);
    for (i, body) in bodies.iter().enumerate() {
        let before = power_of(&answer.given[i], body);
        if case.sample.frame.column(i).is_some() {
            inside += before;
        } else {
            handed_on += power_of(&answer.loads[i], body) - before;
        }
        size += before.abs();
    }
    case.within("power", "the power of the loads", (inside - handed_on) / size, 1e-13 / (health * health))
}
