//! The plans of a position as tables.

use assur_book::{Cell, Column, Document, Table, Unit, row};
use assur_diagram::{JointForce, PlanSheet, PlanVector, Split, VectorPlan};
use assur_geometry::{Center, CenterAt};
use assur_words::{Text, name, number, text, unit};

use super::forces::force_heads;

/// All plans of a position, one table after the other.
pub fn plans(sheet: &PlanSheet, page: &mut Document) {
    plan(&sheet.velocities, page);
    plan(&sheet.accelerations, page);
    centers(&sheet.centers, page);
    sheet.polygons.iter().chain(&sheet.constructions).for_each(|one| plan(one, page));
    sheet.by_cause.iter().for_each(|split| causes(split, page));
}

/// A plan: name, size and direction of every vector, its start, its meaning; then the points.
fn plan(plan: &VectorPlan, page: &mut Document) {
    let title = plan.title.clone();
    let (own, residual) = (unit(plan.unit.clone()), number(format_args!("{:.1e}", plan.residual)));
    page.blocks.push(assur_book::Block::Subheading(if plan.scale > 0.0 {
        text!("plan-with-scale", title, unit = own, scale = number(plan.scale), residual)
    } else {
        text!("plan-without-scale", title, unit = own, residual)
    }));
    let ends = plan.items.iter().flat_map(|item| [item.start, item.end]);
    let places = without_rounding(ends.chain(plan.points.iter().map(|point| point.at)).flatten());
    let size = |item: &PlanVector| {
        without_rounding(plan.items.iter().filter(|one| one.unit == item.unit).map(|one| one.size))(item.size)
    };
    let angle = |item: &PlanVector| {
        let vector = [0, 1].map(|axis| item.end[axis] - item.start[axis]);
        if size(item) == 0.0 { Cell::None } else { degrees(vector) }
    };
    let vectors = Table::each(Text::default(), &plan.items)
        .column(text!("head-vector"), |item| item.name.clone())
        .column(text!("head-size"), |item| size(item))
        .column(text!("head-unit"), |item| unit(item.unit.clone()))
        .measured(text!("head-direction"), Unit::si("deg"), |item| angle(item))
        .column(text!("head-from-x"), |item| places(item.start[0]))
        .column(name("y"), |item| places(item.start[1]))
        .column(text!("head-meaning"), |item| item.note.clone());
    page.table(vectors.table());
    let points = Table::each(Text::default(), &plan.points)
        .column(text!("head-point"), |point| point.name.clone())
        .column(name("x"), |point| places(point.at[0]))
        .column(name("y"), |point| places(point.at[1]));
    page.table(points.table());
}

fn centers(centers: &[Center], page: &mut Document) {
    let places = centers.iter().filter_map(|center| center.at.point());
    let (place, direction) = (without_rounding(places.flatten()), without_rounding([1.0]));
    let at = |center: &Center, axis: usize| match center.at {
        CenterAt::Point(at) => Some(place(at[axis])),
        CenterAt::Direction(along) => Some(direction(along[axis])),
        CenterAt::Everywhere => None,
    };
    let remark = |center: &Center| match center.at {
        CenterAt::Point(_) => Text::default(),
        CenterAt::Direction(_) => text!("plan-at-infinity"),
        CenterAt::Everywhere => text!("plan-no-relative-motion"),
    };
    let meter = Unit::si("m");
    let table = Table::each(text!("plan-centers"), centers)
        .column(text!("head-link"), |center| Text::from(&center.link))
        .column(text!("head-against"), |center| Text::from(&center.against))
        .measured(name("x"), meter, |center| at(center, 0))
        .measured(name("y"), meter, |center| at(center, 1))
        .column(text!("head-remark"), |center| remark(center));
    page.table(table.table());
}

/// Reactions by cause: for each cause and for the whole a row of each joint and link, and the balancing load.
fn causes(split: &Split, page: &mut Document) {
    let shares = || split.shares.iter().chain([&split.whole]);
    let force =
        without_rounding(shares().flat_map(|share| &share.reactions).flat_map(|reaction| reaction.force));
    let balancing = without_rounding(shares().flat_map(|share| share.balancing_loads().iter().copied()));
    let heads = [text!("head-cause"), text!("head-pair"), text!("head-on")].map(Column::of);
    let heads = heads.into_iter().chain(force_heads());
    let residual = number(format_args!("{:.1e}", split.residual));
    let mut table = Table::list(text!("plan-causes", residual), heads);
    for share in shares() {
        let cause = || share.cause.clone();
        for JointForce { joint, on, force: [fx, fy], .. } in &share.reactions {
            let size = force(fx.hypot(*fy));
            table.row(row![cause(), Text::from(joint), Text::from(on), force(*fx), force(*fy), size]);
        }
        for (drive, load) in share.balancing_loads().iter().enumerate() {
            let (on, load) = (split.drives.get(drive).cloned(), balancing(*load));
            let on = on.map_or(Cell::None, Cell::Text);
            table.row(row![cause(), text!("plan-balancing"), on, Cell::None, Cell::None, load]);
        }
    }
    page.table(table);
}

/// Direction of a vector, degrees in (-180, 180], to four decimals; a dash for none.
fn degrees([x, y]: [f64; 2]) -> Cell {
    if x == 0.0 && y == 0.0 {
        return Cell::None;
    }
    Cell::Text(number(match format!("{:.4}", y.atan2(x).to_degrees()).as_str() {
        "-0.0000" => "0.0000",
        "-180.0000" => "180.0000",
        degrees => degrees,
    }))
}

/// Makes a number of one kind zero where it is only rounding of the greatest of them.
fn without_rounding(all: impl IntoIterator<Item = f64>) -> impl Fn(f64) -> f64 {
    let greatest = all.into_iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    move |value| assur_book::zero_if_rounding(value, greatest)
}
