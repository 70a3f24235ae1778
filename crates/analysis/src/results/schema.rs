//! The columns of a table, with the names and units of what they hold.

use std::collections::HashMap;

use assur_mechanism::{CoordinateKind, Mechanism, Name, PairId};

use super::{Column, Owner, Quantity};

/// Columns that have numbers in the same rows, by a number of their own; see [`Table`](super::Table).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Section(pub(crate) usize);

impl Section {
    /// The section that has numbers in all rows.
    pub const ALWAYS: Self = Self(0);
}

/// The columns of a table, with the names of what they belong to.
///
/// It is made once for a scene; tables share it. Columns stand in the order of the results: motion of links, points and
/// slides, their derivatives with respect to time, reduction, reactions, condition.
#[derive(Debug, Clone, PartialEq)]
pub struct Schema {
    columns: Vec<Column>,
    section_of: Vec<Section>,
    /// How many there are.
    pub(crate) sections: usize,
    /// Sections of which a row says where it lacks them.
    nullable: Vec<Section>,
    places: HashMap<Column, usize>,
    /// Names of the links.
    pub links: Vec<Name>,
    points: Vec<Name>,
    slides: Vec<Name>,
    /// The loads of the scene: their names, and in which SI units they are.
    pub loads: Vec<(Name, &'static str)>,
    /// Names of the further forces of the analyzer.
    pub further: Vec<Name>,
    /// What the coordinate is.
    pub kind: CoordinateKind,
    /// Over time what is driven: its name, and whether its coordinate is an angle.
    pub drives: Vec<(Name, bool)>,
    /// Whether results name each drive.
    pub names_drives: bool,
    /// Whether the balancing load is a moment, otherwise a force.
    pub balances_by_moment: bool,
    /// Names of the causes of reactions: `weight`, `inertia`, then the loads.
    pub causes: Vec<Name>,
}

/// Over time what is driven.
fn drives(mechanism: &Mechanism) -> Vec<(Name, bool)> {
    let timed = mechanism.input.drivers.iter().filter(|driver| driver.law.is_some());
    timed.map(|driver| (driver.label.clone(), driver.is_angle())).collect()
}

impl Default for Schema {
    fn default() -> Self {
        Self::empty(CoordinateKind::Angle)
    }
}

impl Schema {
    /// No columns yet.
    pub fn new(mechanism: &Mechanism) -> Self {
        Self {
            sections: 1,
            links: mechanism.links.iter().map(|link| link.name.clone()).collect(),
            points: mechanism.points.iter().map(|point| point.name.clone()).collect(),
            slides: mechanism.slides.iter().map(|slide| slide.name.clone()).collect(),
            loads: mechanism.loads.iter().map(|load| (load.name.clone(), load.kind.unit())).collect(),
            drives: drives(mechanism),
            names_drives: mechanism.input.is_list,
            balances_by_moment: mechanism.balances_by_moment(),
            ..Self::empty(mechanism.input.kind())
        }
    }

    /// Without columns and names.
    fn empty(kind: CoordinateKind) -> Self {
        Self {
            columns: Vec::new(),
            section_of: Vec::new(),
            sections: 0,
            nullable: Vec::new(),
            places: HashMap::new(),
            links: Vec::new(),
            points: Vec::new(),
            slides: Vec::new(),
            loads: Vec::new(),
            further: Vec::new(),
            kind,
            drives: Vec::new(),
            names_drives: false,
            balances_by_moment: false,
            causes: Vec::new(),
        }
    }

    /// A new section for columns that some rows lack.
    pub fn section(&mut self) -> Section {
        self.sections += 1;
        Section(self.sections - 1)
    }

    /// A new section for one quantity: a row that lacks it says so (null in JSON).
    pub fn nullable(&mut self) -> Section {
        let section = self.section();
        self.nullable.push(section);
        section
    }

    /// Whether a row says that it lacks this column.
    pub fn is_nullable(&self, column: usize) -> bool {
        self.nullable.contains(&self.section_of[column])
    }

    /// Adds columns at the end.
    pub fn add(&mut self, section: Section, columns: impl IntoIterator<Item = Column>) {
        for column in columns {
            self.places.insert(column, self.columns.len());
            if column == Column::TIME && self.kind.is_time() {
                // The time is the coordinate.
                self.places.insert(Column::COORDINATE, self.columns.len());
            }
            self.columns.push(column);
            self.section_of.push(section);
        }
    }

    /// All columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// The index of a column; `None` where the results don't have it.
    pub fn find(&self, column: Column) -> Option<usize> {
        self.places.get(&column).copied()
    }

    /// The indices of columns that a condition selects, in order.
    pub fn select(&self, wanted: impl Fn(&Column) -> bool) -> Vec<usize> {
        let each = self.columns.iter().enumerate().filter(|(_, column)| wanted(column));
        each.map(|(index, _)| index).collect()
    }

    /// The owners of the columns of a quantity, each once, in order.
    pub fn owners(&self, quantity: Quantity) -> Vec<Owner> {
        let each = self.columns.iter().filter(|column| column.quantity == quantity && column.cause.is_none());
        let mut owners: Vec<_> = each.map(|column| column.owner).collect();
        owners.dedup();
        owners
    }

    /// The section of a column.
    pub fn section_of(&self, column: usize) -> Section {
        self.section_of[column]
    }

    /// The name of the owner of a column; of a force the name of the pair. The input and a group have none.
    pub fn named(&self, owner: Owner) -> Option<&Name> {
        match owner {
            Owner::Input | Owner::Group(_) => None,
            Owner::Link(link) => Some(&self.links[link]),
            Owner::Point(point) | Owner::Pair(PairId::Pin(point)) | Owner::PairOn(PairId::Pin(point), _) => {
                Some(&self.points[point])
            }
            Owner::Slide(slide)
            | Owner::Pair(PairId::Slide(slide))
            | Owner::PairOn(PairId::Slide(slide), _) => Some(&self.slides[slide]),
            Owner::Load(load) => Some(&self.loads[load].0),
            Owner::Method(force) => self.further.get(force),
            Owner::Drive(drive) => self.drives.get(drive).map(|(name, _)| name),
        }
    }

    /// By what the owner of a column is found in results: its name in English, of a group its index.
    pub fn name(&self, owner: Owner) -> std::borrow::Cow<'_, str> {
        match owner {
            Owner::Group(group) => group.to_string().into(),
            owner => self.named(owner).map_or("", Name::as_str).into(),
        }
    }
}
