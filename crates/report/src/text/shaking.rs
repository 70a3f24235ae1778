//! Shaking force, its harmonics and counterweights as tables.

use assur_shaking::{AtPosition, Balanced, Criterion, Harmonic, Shaking, Size};

use super::layout::{Column, Page};
use super::number::short;
use super::units::{FORCE, MOMENT, Unit, Units};
use crate::json::{NotFinite, finite};

/// The tables; `ascii`: no character beyond ASCII.
///
/// # Errors
///
/// [`NotFinite`] for a number that is not finite.
pub fn shaking(found: &Shaking, ascii: bool) -> Result<String, NotFinite> {
    let found = finite(found)?;
    let mut page = Page::new(ascii);
    if !found.title.is_empty() {
        page.title(&found.title);
    }
    sizes(found, &mut page);
    counterweights(found, &mut page);
    harmonics(found, &mut page);
    positions(found, &mut page);
    Ok(page.finish())
}

/// `crank and rocker, least squares`.
fn name(balance: &Balanced) -> String {
    let links: Vec<_> = balance.counterweights.iter().map(|weight| weight.link.as_str()).collect();
    let criterion = match balance.criterion {
        Criterion::LeastSquares => "least squares",
        Criterion::LeastMaximum => "least maximum",
    };
    format!("on {}: {criterion}", links.join(" and "))
}

fn sizes(found: &Shaking, page: &mut Page) {
    page.section("Shaking force and shaking moment on the ground, before and after balancing");
    page.paragraph(
        "Of the inertia loads of all moving links; moments about the origin. What is greatest is found between \
         positions; the mean square is over the coordinate.",
    );
    let before = ("no counterweight".to_owned(), &found.before);
    let after = found.balances.iter().map(|balance| (name(balance), &balance.after));
    let greatest = [|size: &Size| size.greatest_force, |size: &Size| size.rms_force];
    let moments = [|size: &Size| size.greatest_moment, |size: &Size| size.rms_moment];
    let row = |(name, size): (String, &Size)| {
        let values = greatest.iter().chain(&moments).map(|value| beside(value(&found.before), value(size)));
        std::iter::once(name).chain(values).collect::<Vec<_>>()
    };
    let rows: Vec<_> = std::iter::once(before).chain(after).map(row).collect();
    let heads = ["counterweights", "greatest force, N", "rms, N", "greatest moment, N·m", "rms, N·m"];
    page.rows(&heads, &rows);
    proofs(found, page);
}

/// A size with that before balancing, beside which it may be rounding.
fn beside(before: f64, value: f64) -> String {
    short(if value < 1e-9 * before { 0.0 } else { value })
}

fn proofs(found: &Shaking, page: &mut Page) {
    let row = |balance: &Balanced| {
        let proof = balance.proof?;
        Some(vec![
            name(balance),
            beside(found.before.greatest_force, proof.bound),
            format!("{:.1e}", proof.gap),
        ])
    };
    let rows: Vec<_> = found.balances.iter().filter_map(row).collect();
    if rows.is_empty() {
        return;
    }
    page.paragraph(
        "The problem of the least maximum is convex: its dual proves that no counterweights on these links make the greatest \
         force less than the bound. The gap is what the greatest force is above the bound, as a part of it.",
    );
    page.rows(&["counterweights", "bound, N", "dual gap"], &rows);
}

fn counterweights(found: &Shaking, page: &mut Page) {
    page.section("Counterweights");
    if found.balances.is_empty() {
        page.paragraph("No link turns about a pin on the ground, so none can carry a counterweight.");
        return;
    }
    page.paragraph(
        "Mass times radius decides; the mass is for the radius of the farthest point of the link. The direction is from the pin on \
         the ground, in the frame of the link.",
    );
    let mut rows = Vec::new();
    for balance in &found.balances {
        for weight in &balance.counterweights {
            rows.push(vec![
                name(balance),
                weight.link.clone(),
                short(weight.product),
                short(weight.angle.to_degrees()),
                short(weight.radius * 1e3),
                short(weight.mass),
            ]);
        }
    }
    page.rows(
        &["counterweights", "link", "mass x radius, kg·m", "direction, deg", "radius, mm", "mass, kg"],
        &rows,
    );
}

/// A part of a harmonic.
type Part = (&'static str, Unit, fn(&Harmonic) -> f64);

fn harmonics(found: &Shaking, page: &mut Page) {
    page.section("Harmonics without counterweights");
    page.paragraph(
        "Factors of cos(k q) and sin(k q); order k makes k periods in a cycle, order 0 is the mean. The torque is what the input \
         needs for the motion under all loads.",
    );
    let input = if found.angular { MOMENT } else { FORCE };
    let parts: [Part; 8] = [
        ("Fx cos", FORCE, |at| at.x[0]),
        ("Fx sin", FORCE, |at| at.x[1]),
        ("Fy cos", FORCE, |at| at.y[0]),
        ("Fy sin", FORCE, |at| at.y[1]),
        ("M cos", MOMENT, |at| at.moment[0]),
        ("M sin", MOMENT, |at| at.moment[1]),
        ("torque cos", input, |at| at.torque[0]),
        ("torque sin", input, |at| at.torque[1]),
    ];
    let orders = found.harmonics.iter().map(|at| at.order.to_string()).collect();
    let columns =
        parts.map(|(head, unit, value)| vec![Column::of(&found.harmonics, head, unit, |at| Some(value(at)))]);
    page.table("", &[Column::texts("k", orders)], columns.into());
}

fn positions(found: &Shaking, page: &mut Page) {
    page.section("Shaking force over the cycle");
    let units = Units::of(found.angular);
    let input = if found.angular { MOMENT } else { FORCE };
    let column = |head: &str, unit: Unit, value: &dyn Fn(&AtPosition) -> f64| {
        vec![Column::of(&found.positions, head, unit, |at| Some(value(at)))]
    };
    let numbers = found.positions.iter().map(|at| at.index.to_string()).collect();
    let coordinate = Column::of(&found.positions, "coordinate", units.coordinate, |at| Some(at.coordinate));
    let mut groups = vec![
        column("Fx", FORCE, &|at| at.force[0]),
        column("Fy", FORCE, &|at| at.force[1]),
        column("F", FORCE, &|at| at.force[0].hypot(at.force[1])),
        column("M", MOMENT, &|at| at.moment),
        column("torque", input, &|at| at.torque),
    ];
    for i in 0..found.balances.len() {
        let size = |at: &AtPosition| at.balanced.get(i).map_or(0.0, |[x, y]| x.hypot(*y));
        groups.push(column(&format!("F balanced {}", i + 1), FORCE, &size));
    }
    page.table("", &[Column::texts("No.", numbers), coordinate], groups);
}
