//! Shaking force over the cycle, before and after balancing.

use assur_force::{LoadState, Loads};
use assur_kinematics::{Linkage, PositionError};
use assur_mechanism::{Mechanism, Motion, Range};
use assur_number::elementary;

use crate::ShakingError;
use crate::balance::Fit;
use crate::course::ShakingCourse;
use crate::data::{AtPosition, Balanced, Counterweight, Criterion, Proof, Shaking, Size};
use crate::samples::{Carrier, Sample, Sampler, harmonics};

/// Version of the format of the JSON.
const FORMAT: u32 = 1;

/// Coordinates over the cycle: harmonics of the mechanism up to order 100 leave no trace in those that are given.
const SAMPLES: usize = 720;

/// Shaking force, harmonics and counterweights of a mechanism; `state` is its motion at a coordinate.
pub fn shaking(linkage: &Linkage, state: &dyn Fn(f64) -> LoadState) -> Result<Shaking, ShakingError> {
    let mechanism = &linkage.mechanism;
    let input = &mechanism.input;
    let period = period(mechanism)?;
    let loads = Loads::compile(linkage)?;
    let mut sampler = Sampler::new(linkage, &loads, state);
    let coordinate = |i: usize| input.from + input.sign() * period * i as f64 / SAMPLES as f64;
    let driven = (0..SAMPLES).map(|i| sampler.driven(coordinate(i))).collect::<Result<Vec<_>, _>>()?;
    let harmonics = harmonics(&driven, period);
    let mut samples: Vec<Sample> = driven.into_iter().map(|(sample, _)| sample).collect();
    samples.push(sampler.at(coordinate(SAMPLES))?);
    let mut course = ShakingCourse::of(&mut sampler, &samples)?;
    // Of a whole cycle, once around.
    samples.pop();
    let balances = balances(linkage, &samples, &mut course)?;
    let before = size(&samples, &mut course, &[])?;
    let positions = positions(&mut sampler, &balances)?;
    Ok(Shaking {
        format: FORMAT,
        title: mechanism.title.clone(),
        kind: input.kind(),
        before,
        harmonics,
        balances: balances.into_iter().map(|(balanced, _)| balanced).collect(),
        positions,
    })
}

/// How large shaking force and moment are over the cycle, without counterweights; `state` is the motion at a coordinate.
pub fn shaking_size(linkage: &Linkage, state: &dyn Fn(f64) -> LoadState) -> Result<Size, ShakingError> {
    let input = &linkage.mechanism.input;
    let step = input.sign() * period(&linkage.mechanism)? / SAMPLES as f64;
    let loads = Loads::compile(linkage)?;
    let mut sampler = Sampler::new(linkage, &loads, state);
    let samples = (0..=SAMPLES).map(|i| sampler.at(input.from + step * i as f64));
    let mut samples = samples.collect::<Result<Vec<_>, _>>()?;
    let mut course = ShakingCourse::of(&mut sampler, &samples)?;
    samples.pop();
    Ok(size(&samples, &mut course, &[])?)
}

/// The cycle over which masses shake, rad or m.
fn period(mechanism: &Mechanism) -> Result<f64, ShakingError> {
    if mechanism.input.kind().is_time() {
        return Err(ShakingError::OverTime);
    }
    let Range::Cycle(period) = mechanism.input.range else { return Err(ShakingError::NoCycle) };
    if !matches!(mechanism.motion, Some(Motion::Prescribed { .. } | Motion::Steady { .. })) {
        return Err(ShakingError::NoMotion);
    }
    if mechanism.heavy_links().next().is_none() {
        return Err(ShakingError::NoMass);
    }
    Ok(period)
}

/// What is found with counterweights, and their mass times radius, kg m, in the frames of the links.
type Products = (Balanced, Vec<[f64; 2]>);

/// The counterweights by each criterion: on the input link alone, then on all links that turn about the ground.
fn balances(
    linkage: &Linkage,
    samples: &[Sample],
    course: &mut ShakingCourse<'_, '_>,
) -> Result<Vec<Products>, PositionError> {
    let carriers = course.sampler.carriers.clone();
    let mut counts = vec![1, carriers.len()];
    counts.dedup();
    let mut all = Vec::new();
    for count in counts.into_iter().filter(|count| (1..=carriers.len()).contains(count)) {
        let fit = Fit::of(samples, count);
        for criterion in [Criterion::LeastSquares, Criterion::LeastMaximum] {
            let is_maximum = criterion == Criterion::LeastMaximum;
            let (products, proof) = match &fit {
                None => (vec![[0.0; 2]; count], Proof::default()),
                Some(fit) if is_maximum => fit.least_maximum(course)?,
                Some(fit) => (fit.least_squares(), Proof::default()),
            };
            let proof = is_maximum.then_some(proof);
            let each = products.iter().zip(&carriers);
            let counterweights =
                each.map(|(product, carrier)| described(linkage, carrier, *product)).collect();
            let after = size(samples, course, &products)?;
            all.push((Balanced { criterion, counterweights, after, proof }, products));
        }
    }
    Ok(all)
}

fn positions(sampler: &mut Sampler<'_>, balances: &[Products]) -> Result<Vec<AtPosition>, ShakingError> {
    let carriers = sampler.carriers.clone();
    let input = &sampler.linkage.mechanism.input;
    let mut positions = Vec::with_capacity(input.positions);
    for index in 0..input.positions {
        let (sample, torque) = sampler.driven(input.coordinate(index))?;
        positions.push(AtPosition {
            index,
            coordinate: sample.coordinate,
            force: sample.force,
            moment: sample.moment,
            torque,
            balanced: balances.iter().map(|(_, products)| sample.balanced(&carriers, products).0).collect(),
        });
    }
    Ok(positions)
}

/// The greatest values between samples, and the mean squares over samples that are equally spaced.
fn size(
    samples: &[Sample],
    course: &mut ShakingCourse<'_, '_>,
    products: &[[f64; 2]],
) -> Result<Size, PositionError> {
    let carriers = course.sampler.carriers.clone();
    let of = |sample: &Sample| sample.balanced(&carriers, products);
    let (mut force, mut moments) = (0.0, 0.0);
    for sample in samples {
        let ([x, y], moment) = of(sample);
        force += x * x + y * y;
        moments += moment * moment;
    }
    let mean = |sum: f64| (sum / samples.len() as f64).sqrt();
    Ok(Size {
        greatest_force: course.greatest(|sample| {
            let [x, y] = of(sample).0;
            elementary::hypot(x, y)
        })?,
        rms_force: mean(force),
        greatest_moment: course.greatest(|sample| of(sample).1.abs())?,
        rms_moment: mean(moments),
    })
}

fn described(linkage: &Linkage, carrier: &Carrier, [x, y]: [f64; 2]) -> Counterweight {
    let (product, angle, radius) = (elementary::hypot(x, y), elementary::atan2(y, x), carrier.radius);
    let link = linkage.mechanism.named_link(carrier.link);
    Counterweight { link, product, angle, radius, mass: product / radius }
}
