//! Positions, transfer functions, velocities and accelerations; nearness of the groups to singular positions.

use assur_analysis::results::{Owner, Part, Quantity};
use assur_book::{Digits, Document, Group, Table, Unit};
use assur_mechanism::GROUND;
use assur_words::{Text, count, joined, name, text};

use super::units::{MOVING, TURNING};
use super::{Source, Values};

/// A column of a table: its head, its unit, and what it shows of the owner.
type Shown = (Text, Unit, Quantity, Part);

/// Of how many positions the tables show some, where they don't show all.
pub fn shown_positions(source: &Source<'_>, page: &mut Document) {
    let (shown, all) = (source.positions.len(), source.analysis.survey.rows);
    if shown > 0 && shown != all {
        page.heading(text!("report-shown-positions"));
        page.paragraph(text!("report-positions-shown", shown, all));
    }
}

/// 1 / determinant of the groups.
pub fn condition(source: &Source<'_>, page: &mut Document) {
    let owners = source.owners(Quantity::Condition, |_| true);
    if source.positions.is_empty() || owners.is_empty() {
        return;
    }
    page.heading(text!("report-condition"));
    page.paragraph(text!("report-condition-text"));
    let column = |owner| {
        let Owner::Group(group) = owner else { return None };
        let head = text!("report-group-number", number = count(group + 1));
        let values = Values::of(Quantity::Condition, owner);
        Some(source.column(head, Unit::NONE, values).with(Digits::Ratio))
    };
    let columns = owners.into_iter().filter_map(column).collect();
    page.table(Table::over(text!("head-groups"), source.keys(), columns));
}

impl Source<'_> {
    /// The owners of a quantity that are links.
    fn links(&self, quantity: Quantity) -> Vec<Owner> {
        self.owners(quantity, |owner| matches!(owner, Owner::Link(_)))
    }

    /// The owners of a quantity that are slides.
    fn slides(&self, quantity: Quantity) -> Vec<Owner> {
        self.owners(quantity, |owner| matches!(owner, Owner::Slide(_)))
    }

    /// The owners of a quantity that are points that move: those of the ground are listed among the dimensions.
    fn moving(&self, quantity: Quantity) -> Vec<Owner> {
        let fixed = |id: usize| self.mechanism.place_in(id, GROUND).is_some();
        self.owners(quantity, |owner| matches!(owner, Owner::Point(id) if !fixed(*id)))
    }

    /// A table over the positions with a group of columns for each owner.
    pub(super) fn table(
        &self,
        caption: Text,
        owners: Text,
        groups: impl IntoIterator<Item = Group>,
    ) -> Table {
        Table { caption, keys: self.keys(), owners, groups: groups.into_iter().collect() }
    }

    /// The columns of an owner.
    fn group(&self, owner: Owner, shown: &[Shown]) -> Group {
        let column = |(head, unit, quantity, part): &Shown| {
            self.column(head.clone(), *unit, Values::of(*quantity, owner).part(*part))
        };
        Group { owner: self.name(owner), columns: shown.iter().map(column).collect() }
    }

    /// Adds a table over the positions with these columns for each owner.
    fn groups(&self, page: &mut Document, caption: Text, kind: Text, owners: Vec<Owner>, shown: &[Shown]) {
        page.table(self.table(caption, kind, owners.into_iter().map(|owner| self.group(owner, shown))));
    }
}

/// Places of the points, angles of the links, displacements of the slides.
pub fn positions(source: &Source<'_>, page: &mut Document) {
    let place = Quantity::Transfer(0);
    // Besides the input.
    if source.positions.is_empty() || source.positions.schema().owners(place).len() <= 1 {
        return;
    }
    let (angle, length) = (source.units.angle[0], source.units.length[0]);
    page.heading(text!("report-positions"));
    let points = [(name("x"), length, place, Part::X), (name("y"), length, place, Part::Y)];
    source.groups(page, text!("head-points"), text!("head-point"), source.moving(place), &points);
    let angles = [(name(""), angle, place, Part::Whole)];
    source.groups(page, text!("report-angles"), text!("head-link"), source.links(place), &angles);
    let displacements = [(name(""), length, place, Part::Whole)];
    let slides = source.slides(place);
    source.groups(page, text!("report-displacements"), text!("head-slide"), slides, &displacements);
}

/// Transfer functions of the first and the second order.
pub fn transfer(source: &Source<'_>, page: &mut Document) {
    if source.positions.is_empty() || source.positions.schema().owners(Quantity::Transfer(0)).len() <= 1 {
        return;
    }
    let (angle, length) = (source.units.angle, source.units.length);
    let [first, second] = [Quantity::Transfer(1), Quantity::Transfer(2)];
    let of = |order: &'static str, axis: &'static str| joined(" ", [text!(order), name(axis)]);
    page.heading(text!("report-transfer"));
    let whole = |units: [Unit; 3]| {
        [
            (text!("quantity-pf1"), units[1], first, Part::Whole),
            (text!("quantity-pf2"), units[2], second, Part::Whole),
        ]
    };
    source.groups(page, text!("head-links"), text!("head-link"), source.links(first), &whole(angle));
    let shown = [
        (of("quantity-pf1", "x"), length[1], first, Part::X),
        (of("quantity-pf1", "y"), length[1], first, Part::Y),
        (of("quantity-pf2", "x"), length[2], second, Part::X),
        (of("quantity-pf2", "y"), length[2], second, Part::Y),
    ];
    source.groups(page, text!("head-points"), text!("head-point"), source.moving(first), &shown);
    source.groups(page, text!("head-slides"), text!("head-slide"), source.slides(first), &whole(length));
}

/// Velocities and accelerations.
pub fn rates(source: &Source<'_>, page: &mut Document) {
    let [v, a] = [Quantity::Velocity, Quantity::Acceleration];
    if source.positions.is_empty() || source.positions.schema().owners(v).is_empty() {
        return;
    }
    page.heading(text!("report-rates"));
    let of_input = vec![
        source.column(text!("head-speed"), source.units.rates[0], Values::of(v, Owner::Input)),
        source.column(text!("head-acceleration"), source.units.rates[1], Values::of(a, Owner::Input)),
    ];
    page.table(Table::over(text!("report-input"), source.keys(), of_input));
    rates_of_links(source, page);
    rates_of_points(source, page);
    let shown = [(name("v"), MOVING[0], v, Part::Whole), (name("a"), MOVING[1], a, Part::Whole)];
    source.groups(page, text!("report-slides-rates"), text!("head-slide"), source.slides(v), &shown);
}

/// Angular velocities and accelerations of the links.
pub fn rates_of_links(source: &Source<'_>, page: &mut Document) {
    let [v, a] = [Quantity::Velocity, Quantity::Acceleration];
    let shown = [(name("ω"), TURNING[0], v, Part::Whole), (name("ε"), TURNING[1], a, Part::Whole)];
    source.groups(page, text!("report-links-rates"), text!("head-link"), source.links(v), &shown);
}

/// Velocities and accelerations of the points.
pub fn rates_of_points(source: &Source<'_>, page: &mut Document) {
    let [v, a] = [(Quantity::Velocity, MOVING[0]), (Quantity::Acceleration, MOVING[1])];
    let shown = [
        ("v_{x}", v, Part::X),
        ("v_{y}", v, Part::Y),
        ("v", v, Part::Modulus),
        ("a_{x}", a, Part::X),
        ("a_{y}", a, Part::Y),
        ("a", a, Part::Modulus),
    ]
    .map(|(head, (quantity, unit), part)| (name(head), unit, quantity, part));
    let points = source.moving(Quantity::Velocity);
    source.groups(page, text!("report-points-rates"), text!("head-point"), points, &shown);
}
