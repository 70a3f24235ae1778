//! Shaking force, its harmonics and counterweights as tables.

use assur_book::{Column, Digits, Document, Table, Unit, zero_if_rounding};
use assur_shaking::{AtPosition, Balanced, Criterion, Harmonic, Shaking, Size};
use assur_words::{Text, list, name, number, text};

/// What the inertia loads do to the ground, and counterweights against it.
pub fn shaking(found: &Shaking, page: &mut Document) {
    page.scene(&found.title);
    sizes(found, page);
    counterweights(found, page);
    harmonics(found, page);
    positions(found, page);
}

/// `on crank, rocker: least squares`.
fn balance_name(balance: &Balanced) -> Text {
    let links = list(balance.counterweights.iter().map(|weight| Text::from(&weight.link)));
    match balance.criterion {
        Criterion::LeastSquares => text!("shaking-least-squares", links),
        Criterion::LeastMaximum => text!("shaking-least-maximum", links),
    }
}

fn sizes(found: &Shaking, page: &mut Document) {
    page.heading(text!("shaking-sizes"));
    page.paragraph(text!("shaking-sizes-text"));
    let before = (text!("shaking-no-counterweight"), &found.before);
    let after = found.balances.iter().map(|balance| (balance_name(balance), &balance.after));
    let of = |value: fn(&Size) -> f64| {
        let before = value(&found.before);
        move |(_, size): &(Text, &Size)| zero_if_rounding(value(size), before)
    };
    let table = Table::each(Text::default(), std::iter::once(before).chain(after))
        .column(text!("head-counterweights"), |(what, _)| what.clone())
        .measured(text!("head-greatest-force"), Unit::FORCE, of(|size| size.greatest_force))
        .measured(text!("head-rms-force"), Unit::FORCE, of(|size| size.rms_force))
        .measured(text!("head-greatest-moment"), Unit::MOMENT, of(|size| size.greatest_moment))
        .measured(text!("head-rms-moment"), Unit::MOMENT, of(|size| size.rms_moment));
    page.table(table.table());
    proofs(found, page);
}

fn proofs(found: &Shaking, page: &mut Document) {
    let proved = found.balances.iter().filter_map(|balance| Some((balance, balance.proof?)));
    let bound = |bound| zero_if_rounding(bound, found.before.greatest_force);
    let table = Table::each(Text::default(), proved)
        .column(text!("head-counterweights"), |(balance, _)| balance_name(balance))
        .measured(text!("head-bound"), Unit::FORCE, |(_, proof)| bound(proof.bound))
        .add(Column::of(text!("head-gap")).with(Digits::Exponent), |(_, proof)| proof.gap)
        .table();
    if !table.is_empty() {
        page.paragraph(text!("shaking-proof"));
    }
    page.table(table);
}

fn counterweights(found: &Shaking, page: &mut Document) {
    page.heading(text!("shaking-counterweights"));
    if found.balances.is_empty() {
        return page.paragraph(text!("shaking-no-pivot"));
    }
    page.paragraph(text!("shaking-counterweights-text"));
    let weights = found.balances.iter().flat_map(|of| of.counterweights.iter().map(move |one| (of, one)));
    let table = Table::each(Text::default(), weights)
        .column(text!("head-counterweights"), |(balance, _)| balance_name(balance))
        .column(text!("head-link"), |(_, one)| Text::from(&one.link))
        .measured(text!("head-mass-radius"), Unit::si("kg m"), |(_, one)| one.product)
        .measured(text!("head-direction"), Unit::ANGLE, |(_, one)| one.angle)
        .measured(text!("head-radius"), Unit::LENGTH, |(_, one)| one.radius)
        .measured(text!("head-mass"), Unit::KILOGRAM, |(_, one)| one.mass);
    page.table(table.table());
}

/// A part of a harmonic.
type Component = (Text, Unit, fn(&Harmonic) -> f64);

fn harmonics(found: &Shaking, page: &mut Document) {
    page.heading(text!("shaking-harmonics"));
    page.paragraph(text!("shaking-harmonics-text"));
    let input = Unit::load_of(found.kind);
    let parts: [Component; 8] = [
        (name("Fx cos"), Unit::FORCE, |at| at.x[0]),
        (name("Fx sin"), Unit::FORCE, |at| at.x[1]),
        (name("Fy cos"), Unit::FORCE, |at| at.y[0]),
        (name("Fy sin"), Unit::FORCE, |at| at.y[1]),
        (name("M cos"), Unit::MOMENT, |at| at.moment[0]),
        (name("M sin"), Unit::MOMENT, |at| at.moment[1]),
        (text!("head-input-load-cos"), input, |at| at.torque[0]),
        (text!("head-input-load-sin"), input, |at| at.torque[1]),
    ];
    let orders = found.harmonics.iter().map(|at| number(at.order).into()).collect();
    let column = |(head, unit, value): Component| {
        Column::numbers(head, unit, found.harmonics.iter().map(|at| Some(value(at))))
    };
    let columns = parts.map(column);
    let key = Column { cells: orders, ..Column::of(name("k")) };
    page.table(Table::over(Text::default(), vec![key], columns.into()));
}

fn positions(found: &Shaking, page: &mut Document) {
    page.heading(text!("shaking-positions"));
    let input = Unit::load_of(found.kind);
    let column = |head: Text, unit: Unit, value: &dyn Fn(&AtPosition) -> f64| {
        Column::numbers(head, unit, found.positions.iter().map(|at| Some(value(at))))
    };
    let numbers = Column::counted(text!("head-number"), found.positions.iter().map(|at| at.index));
    let coordinate = column(text!("head-coordinate"), Unit::coordinate(found.kind), &|at| at.coordinate);
    let mut columns = vec![
        column(name("Fx"), Unit::FORCE, &|at| at.force[0]),
        column(name("Fy"), Unit::FORCE, &|at| at.force[1]),
        column(name("F"), Unit::FORCE, &|at| at.force[0].hypot(at.force[1])),
        column(name("M"), Unit::MOMENT, &|at| at.moment),
        column(text!("head-input-load"), input, &|at| at.torque),
    ];
    for i in 0..found.balances.len() {
        let size = |at: &AtPosition| at.balanced.get(i).map_or(0.0, |[x, y]| x.hypot(*y));
        columns.push(column(text!("head-balanced", number = i + 1), Unit::FORCE, &size));
    }
    page.table(Table::over(Text::default(), vec![numbers, coordinate], columns));
}
