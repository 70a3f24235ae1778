//! Shaking force over the cycle, before and after balancing.

use assur_force::{Loads, State};
use assur_kinematics::Linkage;
use assur_mechanism::{Motion, Range};
use nalgebra::{DMatrix, DVector};

use crate::ShakingError;
use crate::barrier::{Row, least_maximum, solve};
use crate::data::{AtPosition, Balanced, Counterweight, Criterion, Shaking, Size};
use crate::samples::{Carrier, Sample, Sampler, harmonics};

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

/// Mass times radius (kg m, in the frames of the links) of the counterweights on the first `carriers` links that make the
/// shaking force least.
pub(crate) fn counterweights(samples: &[Sample], carriers: usize, criterion: Criterion) -> Vec<[f64; 2]> {
    let mut rows: Vec<Row> = samples
        .iter()
        .map(|sample| Row {
            force: sample.force,
            columns: sample.units[..carriers].iter().flat_map(|unit| unit.forces).collect(),
        })
        .collect();
    // Forces and columns of size 1, so that neither units nor lengths matter.
    let size = |value: [f64; 2]| value[0].hypot(value[1]);
    let force = rows.iter().map(|row| size(row.force)).fold(0.0, f64::max);
    let scales: Vec<f64> = (0..2 * carriers)
        .map(|i| rows.iter().map(|row| size(row.columns[i])).fold(0.0, f64::max))
        .map(|greatest| if greatest > 0.0 { force / greatest } else { 0.0 })
        .collect();
    if force == 0.0 {
        return vec![[0.0; 2]; carriers];
    }
    for row in &mut rows {
        row.force = row.force.map(|f| f / force);
        for (column, scale) in row.columns.iter_mut().zip(&scales) {
            *column = column.map(|f| f * scale / force);
        }
    }
    let least = least_squares(&rows, 2 * carriers);
    let found = match criterion {
        Criterion::LeastSquares => least,
        Criterion::LeastMaximum => least_maximum(&rows, least),
    };
    (0..carriers).map(|i| [found[2 * i] * scales[2 * i], found[2 * i + 1] * scales[2 * i + 1]]).collect()
}

fn least_squares(rows: &[Row], unknowns: usize) -> DVector<f64> {
    let mut matrix = DMatrix::zeros(2 * rows.len(), unknowns);
    let mut right = DVector::zeros(2 * rows.len());
    for (i, row) in rows.iter().enumerate() {
        for axis in 0..2 {
            right[2 * i + axis] = -row.force[axis];
            for (j, column) in row.columns.iter().enumerate() {
                matrix[(2 * i + axis, j)] = column[axis];
            }
        }
    }
    solve(matrix, &right)
}
