//! Reduction to a point of the input link (E eqs. 4-6).

use super::Source;
use super::layout::Page;
use super::motion::{column, keys};
use super::units::{FORCE, Unit};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let Some(point) = source.analysis.dynamics.as_ref().and_then(|found| found.reduction_point.as_ref())
    else {
        return;
    };
    if !source.analysis.positions.iter().any(|position| position.reduced.is_some()) {
        return;
    }
    let radius = point.radius;
    page.caption(&format!(
        "The same reduced to point {} of the input link: force F = Q/r along its motion, mass m = J/r², r = {} mm",
        point.name,
        super::number::short(1e3 * radius)
    ));
    let kilograms = Unit { name: "kg", factor: 1.0 };
    let columns = vec![
        column(source, "m", kilograms, move |p| Some(p.reduced?.inertia / (radius * radius))),
        column(source, "F", FORCE, move |p| Some(p.reduced?.moment / radius)),
    ];
    page.table(&keys(source), vec![columns]);
}
