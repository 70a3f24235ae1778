//! Positions, transfer functions, velocities and accelerations; nearness of the groups to singular positions.

use assur_analysis::results::{Column as Values, Owner, Part, Quantity, Table};
use assur_mechanism::GROUND;

use super::Source;
use super::layout::{Column, Page};
use super::units::{MOVING, TURNING, Unit};

/// A column of a table: its head (`*` stands for the name of the owner), its unit, and what it shows of the owner.
type Shown = (&'static str, Unit, Quantity, Part);

/// A column of one quantity over the positions; a dash where a position has none.
pub(super) fn column(source: &Source<'_>, head: impl Into<String>, unit: Unit, values: Values) -> Column {
    Column::numbers(head, unit, each(&source.analysis.positions, values))
}

/// The numbers of a column in all rows.
pub(super) fn each(table: &Table, values: Values) -> Vec<Option<f64>> {
    let found = table.schema().find(values);
    found.map_or_else(|| vec![None; table.len()], |column| table.each(column).collect())
}

/// Modulus of a vector in all rows.
pub(super) fn modulus(table: &Table, values: Values) -> Vec<Option<f64>> {
    let [x, y] = [Part::X, Part::Y].map(|part| each(table, values.part(part)));
    x.into_iter().zip(y).map(|(x, y)| Some(x?.hypot(y?))).collect()
}

/// Number and coordinate of the positions.
pub(super) fn keys(source: &Source<'_>) -> [Column; 2] {
    let numbers = source.analysis.positions.numbers().iter().map(ToString::to_string);
    let coordinate = column(source, &source.analysis.input.link, source.units.coordinate, Values::COORDINATE);
    [Column::texts("No.", numbers.collect()), coordinate]
}

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let analysis = source.analysis;
    if analysis.positions.is_empty() {
        return;
    }
    if !analysis.is_complete() {
        page.section("Shown positions");
        page.paragraph(&format!(
            "The tables show {} of {} positions; greatest values are those of all. All positions are written by `-o FILE.parquet`, `--format csv -o FOLDER` or `--format json`.",
            analysis.positions.len(),
            analysis.survey.rows
        ));
    }
    // Besides the input.
    if source.analysis.positions.schema().owners(Quantity::Transfer(0)).len() > 1 {
        positions(source, page);
        transfer(source, page);
    }
    rates(source, page);
}

/// 1 / determinant of the groups.
pub(super) fn condition(source: &Source<'_>, page: &mut Page) {
    let table = &source.analysis.positions;
    let owners = table.schema().owners(Quantity::Condition);
    if table.is_empty() || owners.is_empty() {
        return;
    }
    page.section("Condition of the groups");
    page.paragraph(
        "1 / (dimensionless determinant): 1 is the best there is; errors of PF1 grow with it, those of PF2 with its square; \
         infinite at a singular position.",
    );
    let unit = Unit { name: "", factor: 1.0 };
    let groups = owners.into_iter().filter_map(|owner| match owner {
        Owner::Group(group) => {
            let head = format!("group {}", group + 1);
            Some(vec![column(source, head, unit, Values::of(Quantity::Condition, owner))])
        }
        _ => None,
    });
    page.table("Groups", &keys(source), groups.collect());
}

/// The owners of a quantity that are links.
fn links(source: &Source<'_>, quantity: Quantity) -> Vec<Owner> {
    owners(source, quantity, |owner| matches!(owner, Owner::Link(_)))
}

/// The owners of a quantity that are slides.
fn slides(source: &Source<'_>, quantity: Quantity) -> Vec<Owner> {
    owners(source, quantity, |owner| matches!(owner, Owner::Slide(_)))
}

/// The owners of a quantity that are points that move: those of the ground are listed among the dimensions.
fn moving(source: &Source<'_>, quantity: Quantity) -> Vec<Owner> {
    let fixed = |id: usize| source.mechanism.place_in(id, GROUND).is_some();
    owners(source, quantity, |owner| matches!(owner, Owner::Point(id) if !fixed(*id)))
}

fn owners(source: &Source<'_>, quantity: Quantity, wanted: impl Fn(&Owner) -> bool) -> Vec<Owner> {
    source.analysis.positions.schema().owners(quantity).into_iter().filter(wanted).collect()
}

/// A group of columns for each owner.
fn groups(source: &Source<'_>, owners: Vec<Owner>, shown: &[Shown]) -> Vec<Vec<Column>> {
    let of = |owner: Owner| {
        let name = source.analysis.positions.schema().name(owner);
        let column = |(head, unit, quantity, part): &Shown| {
            column(source, head.replace('*', &name), *unit, Values::of(*quantity, owner).part(*part))
        };
        shown.iter().map(column).collect()
    };
    owners.into_iter().map(of).collect()
}

fn positions(source: &Source<'_>, page: &mut Page) {
    let (keys, angle, length) = (keys(source), source.units.angle[0], source.units.length[0]);
    let place = Quantity::Transfer(0);
    page.section("Positions");
    let points = [("* x", length, place, Part::X), ("* y", length, place, Part::Y)];
    page.table("Points", &keys, groups(source, moving(source, place), &points));
    let angles = [("*", angle, place, Part::Whole)];
    page.table("Angles of the links", &keys, groups(source, links(source, place), &angles));
    let displacements = [("*", length, place, Part::Whole)];
    page.table("Displacements of the slides", &keys, groups(source, slides(source, place), &displacements));
}

fn transfer(source: &Source<'_>, page: &mut Page) {
    let (keys, angle, length) = (keys(source), source.units.angle, source.units.length);
    let [first, second] = [Quantity::Transfer(1), Quantity::Transfer(2)];
    page.section("Transfer functions (derivatives by the input coordinate)");
    let shown = [("* PF1", angle[1], first, Part::Whole), ("PF2", angle[2], second, Part::Whole)];
    page.table("Links", &keys, groups(source, links(source, first), &shown));
    let shown = [
        ("* PF1 x", length[1], first, Part::X),
        ("PF1 y", length[1], first, Part::Y),
        ("PF2 x", length[2], second, Part::X),
        ("PF2 y", length[2], second, Part::Y),
    ];
    page.table("Points", &keys, groups(source, moving(source, first), &shown));
    let shown = [("* PF1", length[1], first, Part::Whole), ("PF2", length[2], second, Part::Whole)];
    page.table("Slides", &keys, groups(source, slides(source, first), &shown));
}

fn rates(source: &Source<'_>, page: &mut Page) {
    let [v, a] = [Quantity::Velocity, Quantity::Acceleration];
    let owners = source.analysis.positions.schema().owners(v);
    if owners.is_empty() {
        return;
    }
    let keys = keys(source);
    page.section("Velocities and accelerations");
    let of_input = vec![
        column(source, "speed", source.units.rates[0], Values::of(v, Owner::Input)),
        column(source, "acceleration", source.units.rates[1], Values::of(a, Owner::Input)),
    ];
    page.table("Input", &keys, vec![of_input]);
    let shown = [("* w", TURNING[0], v, Part::Whole), ("e", TURNING[1], a, Part::Whole)];
    let caption = "Angular velocities (w) and accelerations (e) of the links";
    page.table(caption, &keys, groups(source, links(source, v), &shown));
    let points = moving(source, v).into_iter().map(|owner| of_point(source, owner));
    page.table("Points", &keys, points.collect());
    let shown = [("* v", MOVING[0], v, Part::Whole), ("a", MOVING[1], a, Part::Whole)];
    page.table("Slides, relative", &keys, groups(source, slides(source, v), &shown));
}

/// Velocity and acceleration of a point, each with its modulus.
fn of_point(source: &Source<'_>, owner: Owner) -> Vec<Column> {
    let table = &source.analysis.positions;
    let name = table.schema().name(owner);
    let columns = [("v", Quantity::Velocity, MOVING[0]), ("a", Quantity::Acceleration, MOVING[1])].map(
        |(letter, quantity, unit)| {
            let values = Values::of(quantity, owner);
            let head = if letter == "v" { format!("{name} v") } else { letter.to_owned() };
            [
                column(source, format!("{head}x"), unit, values.part(Part::X)),
                column(source, format!("{letter}y"), unit, values.part(Part::Y)),
                Column::numbers(letter, unit, modulus(table, values)),
            ]
        },
    );
    columns.into_iter().flatten().collect()
}
