//! Values of the loads, inertia loads of the links, and what these do to the ground.

use assur_analysis::results::{Base, Column as Values, Owner, Part, Quantity};

use super::Source;
use super::layout::{Column, Page};
use super::motion::{column, keys};
use super::units::{FORCE, MOMENT};

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let schema = source.analysis.positions.schema();
    let (loads, links) = (schema.owners(Quantity::Load), schema.owners(Quantity::InertiaForce));
    if source.analysis.positions.is_empty() || loads.is_empty() && links.is_empty() {
        return;
    }
    let keys = keys(source);
    page.section("Loads and inertia loads");
    let load = |owner: &Owner| {
        let values = Values::of(Quantity::Load, *owner);
        let unit = if schema.unit(values).base == Base::NewtonMeter { MOMENT } else { FORCE };
        vec![column(source, schema.name(*owner), unit, values)]
    };
    let caption = "Loads: a force along its direction, a moment counter-clockwise, the tension of a spring";
    page.table(caption, &keys, loads.iter().map(load).collect());
    let inertia = |owner: &Owner| {
        let name = schema.name(*owner);
        wrench(source, &format!("{name} "), Quantity::InertiaForce, Quantity::InertiaMoment, *owner)
    };
    let caption = "Inertia loads: principal vector -m a at the center of mass, principal moment -I e";
    page.table(caption, &keys, links.iter().map(inertia).collect());
    if !links.is_empty() {
        let shaking = wrench(source, "", Quantity::ShakingForce, Quantity::ShakingMoment, Owner::Input);
        page.table("Shaking force on the ground, and shaking moment about the origin", &keys, vec![shaking]);
    }
}

/// Projections of a force, and a moment.
fn wrench(source: &Source<'_>, name: &str, force: Quantity, moment: Quantity, owner: Owner) -> Vec<Column> {
    let force = Values::of(force, owner);
    vec![
        column(source, format!("{name}Fx"), FORCE, force.part(Part::X)),
        column(source, format!("{name}Fy"), FORCE, force.part(Part::Y)),
        column(source, format!("{name}M"), MOMENT, Values::of(moment, owner)),
    ]
}
