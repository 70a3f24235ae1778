//! The plans of a position as tables.

use assur_diagram::{JointForce, Plan, Sheet, Split};
use assur_geometry::{Center, CenterAt};

use super::layout::columns;
use super::number;

/// All plans of a position, one table after the other; `ascii`: no character beyond ASCII.
pub fn plans(sheet: &Sheet, ascii: bool) -> String {
    let mut tables = vec![plan(&sheet.velocities, ascii), plan(&sheet.accelerations, ascii)];
    tables.push(centers(&sheet.centers, ascii));
    tables.extend(sheet.polygons.iter().chain(&sheet.constructions).map(|one| plan(one, ascii)));
    tables.extend(sheet.by_cause.as_ref().map(|split| causes(split, ascii)));
    tables.join("\n")
}

/// A plan: name, size and direction of every vector, its start, its meaning; then the points.
fn plan(plan: &Plan, ascii: bool) -> String {
    let scale =
        if plan.scale > 0.0 { format!(", 1 mm = {} {}", plan.scale, plan.unit) } else { String::new() };
    let head = format!("{}\nunit {}{scale}; residual {:.1e}\n", plan.title, plan.unit, plan.residual);
    let ends = plan.items.iter().flat_map(|item| [item.start, item.end]);
    let places = beside(ends.chain(plan.points.iter().map(|point| point.at)).flatten());
    let rows = plan.items.iter().map(|item| {
        let vector = [0, 1].map(|axis| item.end[axis] - item.start[axis]);
        let sizes = beside(plan.items.iter().filter(|one| one.unit == item.unit).map(|one| one.size));
        let size = sizes(item.size);
        let angle = if size == "0" { "-".to_owned() } else { degrees(vector) };
        let [x, y] = item.start.map(&places);
        vec![item.name.to_string(), size, item.unit.clone(), angle, x, y, item.note.to_string()]
    });
    let vectors = ["vector", "size", "unit", "deg", "from x", "from y", "meaning"];
    let points = plan.points.iter().map(|point| {
        let [x, y] = point.at.map(&places);
        vec![point.name.to_string(), x, y]
    });
    head + &table(&vectors, rows, ascii) + &table(&["point", "x", "y"], points, ascii)
}

fn centers(centers: &[Center], ascii: bool) -> String {
    let places = centers.iter().filter_map(|center| match center.at {
        CenterAt::Point(place) => Some(place),
        _ => None,
    });
    let (place, direction) = (beside(places.flatten()), beside([1.0]));
    let rows = centers.iter().map(|center| {
        let ([x, y], note) = match center.at {
            CenterAt::Point(at) => (at.map(&place), ""),
            CenterAt::Direction(along) => (along.map(&direction), "at infinity, in this direction"),
            CenterAt::Everywhere => (["-", "-"].map(str::to_owned), "no motion against each other"),
        };
        vec![center.link.clone(), center.against.clone(), x, y, note.to_owned()]
    });
    "Instant centers (m)\n".to_owned() + &table(&["link", "against", "x", "y", ""], rows, ascii)
}

/// Reactions by cause: for each cause and for the whole a row of each joint and link, and the balancing load.
fn causes(split: &Split, ascii: bool) -> String {
    let shares = || split.shares.iter().chain([&split.whole]);
    let force = beside(shares().flat_map(|share| &share.reactions).flat_map(|reaction| reaction.force));
    let balancing = beside(shares().map(|share| share.balancing));
    let row = |cause: &str, reaction: &JointForce| {
        let [fx, fy] = reaction.force;
        let size = force(fx.hypot(fy));
        vec![cause.to_owned(), reaction.joint.clone(), reaction.on.clone(), force(fx), force(fy), size]
    };
    let rows = shares().flat_map(|share| {
        let dash = || "-".to_owned();
        let load = balancing(share.balancing);
        let load = vec![share.cause.to_string(), "balancing".to_owned(), dash(), dash(), dash(), load];
        share.reactions.iter().map(|reaction| row(&share.cause.to_string(), reaction)).chain([load])
    });
    let head = format!("Reactions by cause (N); the shares sum to the whole up to {:.1e}\n", split.residual);
    head + &table(&["cause", "joint", "on", "fx", "fy", "size"], rows, ascii)
}

/// No table without rows.
fn table(head: &[&str], rows: impl Iterator<Item = Vec<String>>, ascii: bool) -> String {
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() { String::new() } else { columns(head, &rows, ascii) }
}

/// Direction of a vector, degrees in (-180, 180]; a dash for none.
fn degrees([x, y]: [f64; 2]) -> String {
    if x == 0.0 && y == 0.0 {
        return "-".to_owned();
    }
    match format!("{:.4}", y.atan2(x).to_degrees()).as_str() {
        "-0.0000" => "0.0000".to_owned(),
        "-180.0000" => "180.0000".to_owned(),
        degrees => degrees.to_owned(),
    }
}

/// Shows numbers of one kind: one that is rounding compared to the greatest is zero.
fn beside(all: impl IntoIterator<Item = f64>) -> impl Fn(f64) -> String {
    let greatest = all.into_iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    move |value| if number::is_rounding(value, greatest) { "0".to_owned() } else { number::single(value) }
}
