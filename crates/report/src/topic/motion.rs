//! Positions, transfer functions, velocities and accelerations; nearness of the groups to singular positions.

use assur_analysis::results::{Owner, Part, Quantity};
use assur_book::{Digits, Document, Group, Table};
use assur_mechanism::GROUND;
use assur_words::{Text, count, text};

use super::{Source, Values};

/// The whole of a quantity.
const WHOLE: &[Part] = &[Part::Whole];
/// Both projections of a vector.
const PROJECTIONS: &[Part] = &[Part::X, Part::Y];
const RATES: &[Quantity] = &[Quantity::Velocity, Quantity::Acceleration];

/// Of how many positions the tables show some, where they don't show all.
pub(super) fn shown_positions(source: &Source<'_>, page: &mut Document) {
    let (shown, all) = (source.positions.len(), source.analysis.survey.rows);
    if shown > 0 && shown != all {
        page.heading(text!("report-shown-positions"));
        page.paragraph(text!("report-positions-shown", shown, all));
    }
}

/// 1 / determinant of the groups.
pub(super) fn condition(source: &Source<'_>, page: &mut Document) {
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
        Some(source.headed(head, values).with(Digits::Ratio))
    };
    let columns = owners.into_iter().filter_map(column).collect();
    page.table(Table::over(text!("head-groups"), source.keys(), columns));
}

impl Source<'_> {
    fn links(&self, quantity: Quantity) -> Vec<Owner> {
        self.owners(quantity, |owner| matches!(owner, Owner::Link(_)))
    }

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

    /// Adds a table over the positions with these parts of these quantities for each owner.
    fn groups(
        &self,
        page: &mut Document,
        [caption, kind]: [Text; 2],
        owners: Vec<Owner>,
        (quantities, parts): (&[Quantity], &[Part]),
    ) {
        let group = |owner| {
            let of = |quantity: &Quantity| Values::of(*quantity, owner);
            let all =
                quantities.iter().flat_map(|quantity| parts.iter().map(move |part| of(quantity).part(*part)));
            Group { owner: self.name(owner), columns: all.map(|values| self.column(values)).collect() }
        };
        page.table(self.table(caption, kind, owners.into_iter().map(group)));
    }

    /// Whether anything beside the input is placed.
    fn places(&self) -> bool {
        !self.positions.is_empty() && self.positions.schema().owners(Quantity::Transfer(0)).len() > 1
    }
}

/// Places of the points, angles of the links, displacements of the slides.
pub(super) fn positions(source: &Source<'_>, page: &mut Document) {
    if !source.places() {
        return;
    }
    let place = Quantity::Transfer(0);
    page.heading(text!("report-positions"));
    if source.kind.is_time() {
        drives(source, page);
    }
    let captions = [text!("head-points"), text!("head-point")];
    source.groups(page, captions, source.moving(place), (&[place], PROJECTIONS));
    let captions = [text!("report-angles"), text!("head-link")];
    source.groups(page, captions, source.links(place), (&[place], WHOLE));
    let captions = [text!("report-displacements"), text!("head-slide")];
    source.groups(page, captions, source.slides(place), (&[place], WHOLE));
}

/// Transfer functions of the first and the second order.
pub(super) fn transfer(source: &Source<'_>, page: &mut Document) {
    if !source.places() {
        return;
    }
    if source.kind.is_time() {
        return partials(source, page);
    }
    let orders = &[Quantity::Transfer(1), Quantity::Transfer(2)];
    page.heading(text!("report-transfer"));
    let captions = [text!("head-links"), text!("head-link")];
    source.groups(page, captions, source.links(orders[0]), (orders, WHOLE));
    let captions = [text!("head-points"), text!("head-point")];
    source.groups(page, captions, source.moving(orders[0]), (orders, PROJECTIONS));
    let captions = [text!("head-slides"), text!("head-slide")];
    source.groups(page, captions, source.slides(orders[0]), (orders, WHOLE));
}

/// Over time: transfer functions with respect to the coordinate of each drive, the others at rest.
fn partials(source: &Source<'_>, page: &mut Document) {
    page.heading(text!("report-partials"));
    let drives = source.positions.schema().drives.len();
    let orders: &[u8] = if source.mechanism.input.is_list { &[1] } else { &[1, 2] };
    for (drive, &order) in (0..drives).flat_map(|drive| orders.iter().map(move |order| (drive, order))) {
        let quantity = Quantity::Partial { drive, order };
        let of = |what: Text| text!("report-by-coordinate", what, drive = source.name(Owner::Drive(drive)));
        let [links, points, slides] =
            [text!("head-links"), text!("head-points"), text!("head-slides")].map(of);
        source.groups(page, [links, text!("head-link")], source.links(quantity), (&[quantity], WHOLE));
        source.groups(
            page,
            [points, text!("head-point")],
            source.moving(quantity),
            (&[quantity], PROJECTIONS),
        );
        source.groups(page, [slides, text!("head-slide")], source.slides(quantity), (&[quantity], WHOLE));
    }
}

/// Over time: coordinate, speed and acceleration of each drive.
fn drives(source: &Source<'_>, page: &mut Document) {
    let of = [Quantity::Transfer(0), RATES[0], RATES[1]];
    let drives = source.owners(of[0], |owner| matches!(owner, Owner::Drive(_)));
    let moves = !source.positions.schema().owners(RATES[0]).is_empty();
    let quantities = if moves { &of[..] } else { &of[..1] };
    source.groups(page, [text!("report-drives"), text!("head-input")], drives, (quantities, WHOLE));
}

/// Velocities and accelerations.
pub(super) fn rates(source: &Source<'_>, page: &mut Document) {
    if source.positions.is_empty() || source.positions.schema().owners(RATES[0]).is_empty() {
        return;
    }
    page.heading(text!("report-rates"));
    if !source.kind.is_time() {
        rates_of_input(source, page);
    }
    rates_of_links(source, page);
    rates_of_points(source, page);
    let captions = [text!("report-slides-rates"), text!("head-slide")];
    source.groups(page, captions, source.slides(RATES[0]), (RATES, WHOLE));
}

fn rates_of_input(source: &Source<'_>, page: &mut Document) {
    let of_input = vec![
        source.headed(text!("head-speed"), Values::of(RATES[0], Owner::Input)),
        source.headed(text!("head-acceleration"), Values::of(RATES[1], Owner::Input)),
    ];
    page.table(Table::over(text!("report-input"), source.keys(), of_input));
}

/// Angular velocities and accelerations of the links.
pub fn rates_of_links(source: &Source<'_>, page: &mut Document) {
    let captions = [text!("report-links-rates"), text!("head-link")];
    source.groups(page, captions, source.links(RATES[0]), (RATES, WHOLE));
}

/// Velocities and accelerations of the points.
pub fn rates_of_points(source: &Source<'_>, page: &mut Document) {
    let captions = [text!("report-points-rates"), text!("head-point")];
    let points = source.moving(RATES[0]);
    source.groups(page, captions, points, (RATES, &[Part::X, Part::Y, Part::Modulus]));
}
