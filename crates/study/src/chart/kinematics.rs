//! Transfer functions: closed forms in several numbers, the general solution, numerical differentiation.

pub(crate) mod differences;
mod general;

use assur_group::Order;
use assur_words::{Describe, Text};

use super::{ChartError, ChartOptions, Measurement, Setting, Stage, data::STEP, race::Field, work::Work};

use differences::{Differentiator, Stencil};
use general::{How, solved};

pub(crate) fn field<'a>(work: &'a Work<'a>, options: ChartOptions) -> Result<Field<'a>, ChartError> {
    let number = |method: &str, name| row(method, Setting::word("number", name));
    let mut entries = vec![
        work.entry(number("closed-form", "f64"), 1, own(work)),
        work.entry(number("closed-form", "f32"), 1, solved::<f32>(work, How::Closed)?),
        general::entry(work, number("closed-form", "f64x8")),
    ];
    for (how, name) in [(How::General, "general-derivatives"), (How::Newton, "newton")] {
        entries.push(work.entry(number(name, "f64"), 1, solved::<f64>(work, how)?));
        entries.push(work.entry(number(name, "f32"), 1, solved::<f32>(work, how)?));
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
