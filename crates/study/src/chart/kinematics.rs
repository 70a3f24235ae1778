//! Transfer functions: closed forms in several numbers, the general solution, numerical differentiation.

pub(crate) mod differences;
mod general;

use assur_group::{Body, Number, Order};
use assur_kinematics::{Chain, Linkage};
use assur_words::{Describe, Text, number, text};

use super::data::STEP;
use super::race::Field;
use super::work::Work;
use super::{ChartError, ChartOptions, Measurement, Setting, Stage};

use differences::{Differentiator, Stencil};
use general::general;

pub(crate) fn field<'a>(work: &'a Work<'a>, options: ChartOptions) -> Result<Field<'a>, ChartError> {
    let number = |method: &str, name| row(method, Setting::word("number", name));
    let mut entries = vec![
        work.entry(number("closed-form", "f64"), 1, own(work)),
        work.entry(number("closed-form", "f32"), 1, closed::<f32>(work)?),
        general::entry(work, number("closed-form", "f64x8")),
    ];
    for (by_newton, name) in [(false, "general-derivatives"), (true, "newton")] {
        entries.push(work.entry(number(name, "f64"), 1, general::<f64>(work, by_newton)?));
        entries.push(work.entry(number(name, "f32"), 1, general::<f32>(work, by_newton)?));
    }
    for stencil in Stencil::ALL {
        for step in options.decades(-1, -10) {
            let mut differentiator = Differentiator::new(work.linkage, stencil, step);
            let points = differentiator.points();
            let solve = move |index: usize, judged: bool| {
                let middle = differentiator.solve(work.coordinates[index])?;
                Ok(if judged { work.deviation(index, &middle.bodies) } else { 0.0 })
            };
            let row = row(stencil.name, Setting::number(STEP, step));
            entries.push(work.entry(row, points, solve));
        }
    }
    Ok(Field { reference: work.reference.clone(), entries })
}

fn row(method: &str, setting: Setting) -> Measurement {
    Measurement::new(Stage::Kinematics, method, setting)
}

fn own<'a>(work: &'a Work<'a>) -> impl FnMut(usize, bool) -> Result<f64, Text> + 'a {
    let mut position = work.linkage.position();
    move |index, judged| {
        let solved = work.linkage.solve(work.coordinates[index], Order::Second, &mut position);
        solved.map_err(|error| error.describe())?;
        Ok(if judged { work.deviation(index, &position.bodies) } else { 0.0 })
    }
}

/// The closed forms in another number type.
fn closed<'a, T: Number>(
    work: &'a Work<'a>,
) -> Result<impl FnMut(usize, bool) -> Result<f64, Text> + 'a, ChartError> {
    let chain = Chain::<T>::compile(&work.linkage.mechanism, &work.linkage.structure)?;
    let (mut bodies, mut health) = (chain.bodies(), vec![T::ZERO; chain.groups.len()]);
    let kept = kept(work);
    Ok(move |index: usize, judged| {
        let q = work.coordinates[index];
        if let Some(kept) = &kept {
            bodies.clone_from_slice(&kept[index]);
        }
        let ways = work.linkage.ways.at(q);
        let solved = chain.solve(T::from_f64(q), ways, Order::Second, &mut bodies, &mut health);
        solved.map_err(|error| failure(work.linkage, q, &error))?;
        Ok(if judged { work.deviation(index, &bodies) } else { 0.0 })
    })
}

/// Where groups that iterate begin at each position; `None` where there are none.
fn kept<T: Number>(work: &Work<'_>) -> Option<Vec<Vec<Body<T>>>> {
    let iterates = work.linkage.structure.groups.iter().any(|group| group.plugin.iterates);
    iterates.then(|| work.coordinates.iter().map(|&q| work.linkage.starting_bodies(q)).collect())
}

fn failure(linkage: &Linkage, q: f64, error: &assur_kinematics::ChainError) -> Text {
    let group = linkage.structure.group_name(&linkage.mechanism, error.group);
    let coordinate = number(format_args!("{q:.9}"));
    text!("chart-group-at", group, coordinate, problem = error.source.describe())
}
