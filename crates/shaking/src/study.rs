//! Shaking force over the cycle, before and after balancing.

use assur_force::{Loads, State};
use assur_kinematics::Linkage;
use assur_mechanism::{Motion, Range};

use crate::ShakingError;
use crate::counterweight::counterweights;
use crate::data::{AtPosition, Balanced, Counterweight, Criterion, Shaking, Size};
use crate::samples::harmonics;
use crate::samples::{Carrier, Sample, Sampler};

/// Version of the format of the JSON.
const FORMAT: u32 = 1;

/// Coordinates over the cycle: harmonics of the mechanism up to order 100 leave no trace in those that are given.
const SAMPLES: usize = 720;

/// Shaking force, harmonics and counterweights of a mechanism; `state` is its motion at a coordinate.
///
/// # Errors
///
/// [`ShakingError`] where the scene has no mass, no cycle or no motion over it, or a position without solution.
pub fn shaking(linkage: &Linkage, state: &dyn Fn(f64) -> State) -> Result<Shaking, ShakingError> {
    let mechanism = &linkage.mechanism;
    let input = &mechanism.input;
    let Range::Cycle(period) = input.range else { return Err(ShakingError::NoCycle) };
    if !matches!(mechanism.motion, Some(Motion::Prescribed { .. } | Motion::Steady { .. })) {
        return Err(ShakingError::NoMotion);
    }
    if mechanism.links.iter().skip(1).all(|link| link.mass <= 0.0 && link.inertia <= 0.0) {
        return Err(ShakingError::NoMass);
    }
    let loads = Loads::compile(linkage)?;
    let mut sampler = Sampler::new(linkage, &loads, state);
    let coordinate = |i: usize| input.from + input.sign() * period * i as f64 / SAMPLES as f64;
    let samples = (0..SAMPLES).map(|i| sampler.at(coordinate(i))).collect::<Result<Vec<_>, _>>()?;
    let carriers = sampler.carriers.clone();
    let (balances, products) = balances(linkage, &samples, &carriers).into_iter().unzip::<_, _, _, Vec<_>>();
    let mut positions = Vec::with_capacity(input.positions);
    for index in 0..input.positions {
        let sample = sampler.at(input.coordinate(index))?;
        positions.push(AtPosition {
            index,
            coordinate: sample.coordinate,
            force: sample.force,
            moment: sample.moment,
            torque: sample.torque,
            balanced: products.iter().map(|products| balanced(&sample, &carriers, products).0).collect(),
        });
    }
    Ok(Shaking {
        format: FORMAT,
        title: mechanism.title.clone(),
        angular: input.is_angle(),
        before: size(&samples, &carriers, &[]),
        harmonics: harmonics(&samples, period),
        balances,
        positions,
    })
}

/// The counterweights by each criterion, with their products of mass and place: on the input link alone, then on all links
/// that turn about the ground.
fn balances(linkage: &Linkage, samples: &[Sample], carriers: &[Carrier]) -> Vec<(Balanced, Vec<[f64; 2]>)> {
    let mut counts = vec![1, carriers.len()];
    counts.dedup();
    let mut all = Vec::new();
    for count in counts.into_iter().filter(|count| (1..=carriers.len()).contains(count)) {
        for criterion in [Criterion::LeastSquares, Criterion::LeastMaximum] {
            let found = counterweights(samples, count, criterion);
            let each = found.iter().zip(carriers);
            let counterweights =
                each.map(|(product, carrier)| described(linkage, carrier, *product)).collect();
            all.push((Balanced { criterion, counterweights, after: size(samples, carriers, &found) }, found));
        }
    }
    all
}

/// Force and moment of a sample with counterweights.
fn balanced(sample: &Sample, carriers: &[Carrier], products: &[[f64; 2]]) -> ([f64; 2], f64) {
    let (mut force, mut moment) = (sample.force, sample.moment);
    for ((unit, product), carrier) in sample.units.iter().zip(products).zip(carriers) {
        let [x, y] = unit.force(*product);
        force = [force[0] + x, force[1] + y];
        moment += unit.moment(*product, carrier.radius);
    }
    (force, moment)
}

fn size(samples: &[Sample], carriers: &[Carrier], products: &[[f64; 2]]) -> Size {
    let mut size = Size::default();
    for sample in samples {
        let ([x, y], moment) = balanced(sample, carriers, products);
        size.greatest_force = size.greatest_force.max(x.hypot(y));
        size.greatest_moment = size.greatest_moment.max(moment.abs());
        size.rms_force += x * x + y * y;
        size.rms_moment += moment * moment;
    }
    let mean = |sum: f64| (sum / samples.len() as f64).sqrt();
    Size { rms_force: mean(size.rms_force), rms_moment: mean(size.rms_moment), ..size }
}

fn described(linkage: &Linkage, carrier: &Carrier, [x, y]: [f64; 2]) -> Counterweight {
    let product = x.hypot(y);
    Counterweight {
        link: linkage.mechanism.links[carrier.link].name.clone(),
        product,
        angle: y.atan2(x),
        radius: carrier.radius,
        mass: product / carrier.radius,
    }
}
