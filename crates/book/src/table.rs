//! Tables: columns of numbers in SI, each with its unit, and of texts.

use assur_mechanism::Name;
use assur_words::{Text, count, joined, name};

use crate::catalogue::Unit;
use crate::number::{DIGITS, Digits, NONE};

/// A table.
#[derive(Debug, Clone, Default)]
pub struct Table {
    /// What it shows; may be empty.
    pub caption: Text,
    /// What tells one row from another: number, coordinate, name.
    pub keys: Vec<Column>,
    /// What the owners of the groups are: links, points; may be empty.
    pub owners: Text,
    /// The other columns, those of one owner together.
    pub groups: Vec<Group>,
}

/// Columns that belong together.
#[derive(Debug, Clone)]
pub struct Group {
    /// Whose they are; empty where that needs no word.
    pub owner: Text,
    /// The columns.
    pub columns: Vec<Column>,
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its head without the unit.
    pub head: Text,
    /// Its unit; numbers are in SI and multiplied by its factor when they are written.
    pub unit: Unit,
    /// How its numbers are written.
    pub digits: Digits,
    /// A cell for each row.
    pub cells: Vec<Cell>,
}

/// One cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A number in SI.
    Number(f64),
    /// What is not determined, or has no meaning: a dash.
    None,
    /// A text.
    Text(Text),
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl<T: Into<Self>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::None, Into::into)
    }
}

impl From<Text> for Cell {
    fn from(text: Text) -> Self {
        Self::Text(text)
    }
}

impl From<usize> for Cell {
    /// A number of something, or a count.
    fn from(number: usize) -> Self {
        Self::Text(count(number))
    }
}

impl From<&String> for Cell {
    /// A name.
    fn from(letters: &String) -> Self {
        Self::Text(name(letters.clone()))
    }
}

impl From<&Name> for Cell {
    fn from(name: &Name) -> Self {
        Self::Text(name.into())
    }
}

/// The cells of a row: numbers, counts, names and texts.
#[macro_export]
macro_rules! row {
    ($($cell:expr),* $(,)?) => {
        [$($crate::Cell::from($cell)),*]
    };
}

impl Column {
    /// An empty column of texts.
    pub fn of(head: Text) -> Self {
        Self::short(head, Unit::NONE)
    }

    /// An empty column of numbers, of which each has its own digits.
    pub fn short(head: Text, unit: Unit) -> Self {
        Self { head, unit, digits: Digits::Short, cells: Vec::new() }
    }

    /// The same with other digits.
    #[must_use]
    pub fn with(self, digits: Digits) -> Self {
        Self { digits, ..self }
    }

    /// Numbers in SI that have one number of decimals.
    pub fn numbers(head: Text, unit: Unit, values: impl IntoIterator<Item = Option<f64>>) -> Self {
        let cells = values.into_iter().map(Cell::from).collect();
        Self { head, unit, digits: Digits::Even, cells }
    }

    /// Numbers of positions or samples.
    pub fn counted(head: Text, numbers: impl IntoIterator<Item = usize>) -> Self {
        Self { cells: numbers.into_iter().map(Cell::from).collect(), ..Self::of(head) }
    }

    /// The greatest magnitude of a number, in the unit of the column.
    fn greatest(&self) -> f64 {
        let sizes = self.cells.iter().filter_map(|cell| match cell {
            Cell::Number(value) if value.is_finite() => Some((value * self.unit.factor).abs()),
            _ => None,
        });
        sizes.fold(0.0, f64::max)
    }

    /// The cells as they are shown; `kind`: the greatest number of their unit.
    fn printed(&self, head: Text, kind: f64, significant: usize) -> Printed {
        let sizes = [self.greatest(), kind];
        let cell = |cell: &Cell| match cell {
            Cell::Number(value) => self.digits.write(value * self.unit.factor, sizes, significant),
            Cell::None => name(NONE),
            Cell::Text(text) => text.clone(),
        };
        let of_numbers = self.cells.iter().all(|cell| match cell {
            Cell::Number(_) | Cell::None => true,
            Cell::Text(text) => text.is_empty() || text.is_number(),
        });
        Printed { head, unit: self.unit.name, cells: self.cells.iter().map(cell).collect(), of_numbers }
    }
}

/// A column as it is shown.
#[derive(Debug, Clone)]
pub struct Printed {
    /// Its head, with the owner where it is the first of its group.
    pub head: Text,
    /// The symbol of its unit in English; may be empty.
    pub unit: &'static str,
    /// The cells.
    pub cells: Vec<Text>,
    /// Whether these are numbers, counts and dashes alone, so that it stands at the right.
    pub of_numbers: bool,
}

/// A table with a row for each of some things, of which every column says what it shows.
#[derive(Debug)]
pub struct Listing<T> {
    of: Vec<T>,
    table: Table,
}

impl<T> Listing<T> {
    /// Adds a column without a unit: texts, counts, ratios.
    #[must_use]
    pub fn column<C: Into<Cell>>(self, head: Text, value: impl Fn(&T) -> C) -> Self {
        self.add(Column::of(head), value)
    }

    /// Adds a column of numbers in SI, of which each has its own digits.
    #[must_use]
    pub fn measured<C: Into<Cell>>(self, head: Text, unit: Unit, value: impl Fn(&T) -> C) -> Self {
        self.add(Column::short(head, unit), value)
    }

    /// Adds a column; the first one tells one row from another.
    #[must_use]
    pub fn add<C: Into<Cell>>(mut self, column: Column, value: impl Fn(&T) -> C) -> Self {
        let cells = self.of.iter().map(|one| value(one).into()).collect();
        let keys = &mut self.table.keys;
        let columns = if keys.is_empty() { keys } else { &mut self.table.groups[0].columns };
        columns.push(Column { cells, ..column });
        self
    }

    /// The table of these columns.
    pub fn table(self) -> Table {
        self.table
    }
}

impl Table {
    /// A table of these things, whose columns are added one after another.
    pub fn each<T>(caption: Text, of: impl IntoIterator<Item = T>) -> Listing<T> {
        Listing { of: of.into_iter().collect(), table: Self::list(caption, []) }
    }

    /// A table whose rows follow; the first column tells one row from another.
    pub fn list(caption: Text, columns: impl IntoIterator<Item = Column>) -> Self {
        let mut columns = columns.into_iter();
        let keys = columns.next().into_iter().collect();
        Self::over(caption, keys, columns.collect())
    }

    /// A table over positions or samples, of columns that have no owner.
    pub fn over(caption: Text, keys: Vec<Column>, columns: Vec<Column>) -> Self {
        let groups = vec![Group { owner: Text::default(), columns }];
        Self { caption, keys, owners: Text::default(), groups }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        let columns = self.keys.iter_mut().chain(self.groups.iter_mut().flat_map(|group| &mut group.columns));
        columns.zip(cells).for_each(|(column, cell)| column.cells.push(cell));
    }

    /// The same with these rows.
    #[must_use]
    pub fn rows<C: IntoIterator<Item = Cell>>(mut self, rows: impl IntoIterator<Item = C>) -> Self {
        rows.into_iter().for_each(|cells| self.row(cells));
        self
    }

    /// All columns.
    pub fn columns(&self) -> impl Iterator<Item = &Column> {
        self.keys.iter().chain(self.groups.iter().flat_map(|group| &group.columns))
    }

    /// How many rows it has.
    pub fn height(&self) -> usize {
        self.columns().map(|column| column.cells.len()).max().unwrap_or(0)
    }

    /// Whether it has nothing to show.
    pub fn is_empty(&self) -> bool {
        self.groups.is_empty() || self.height() == 0
    }

    /// The key columns, and the others group by group.
    pub fn printed(&self) -> (Vec<Printed>, Vec<Vec<Printed>>) {
        self.printed_with(DIGITS)
    }

    /// The same with so many significant digits.
    pub fn printed_with(&self, digits: usize) -> (Vec<Printed>, Vec<Vec<Printed>>) {
        let key = |column: &Column| column.printed(column.head.clone(), column.greatest(), digits);
        let keys = self.keys.iter().map(key);
        let mut greatest: Vec<(&str, f64)> = Vec::new();
        for column in self.groups.iter().flat_map(|group| &group.columns) {
            match greatest.iter_mut().find(|(unit, _)| *unit == column.unit.name) {
                Some((_, most)) => *most = most.max(column.greatest()),
                None => greatest.push((column.unit.name, column.greatest())),
            }
        }
        let of_unit = |column: &Column| match column.digits {
            Digits::Even => {
                greatest.iter().find(|(unit, _)| *unit == column.unit.name).map_or(0.0, |of| of.1)
            }
            _ => column.greatest(),
        };
        let group = |group: &Group| {
            let columns = group.columns.iter().enumerate().map(|(index, column)| {
                let owner = if index == 0 { group.owner.clone() } else { Text::default() };
                let parts = [owner, column.head.clone()].into_iter().filter(|part| !part.is_empty());
                column.printed(joined(" ", parts), of_unit(column), digits)
            });
            columns.collect()
        };
        (keys.collect(), self.groups.iter().map(group).collect())
    }

    /// The same with a row for each owner: for few rows and many owners. A table whose groups have no owners stays.
    #[must_use]
    pub fn by_owner(&self) -> Self {
        if self.groups.iter().all(|group| group.owner.is_empty()) {
            return self.clone();
        }
        let mut columns: Vec<Column> = Vec::new();
        for column in self.groups.iter().flat_map(|group| &group.columns) {
            if !columns.iter().any(|known| known.head == column.head) {
                columns.push(Column { cells: Vec::new(), ..column.clone() });
            }
        }
        let keys = self.keys.iter().map(|key| Column { cells: Vec::new(), ..key.clone() });
        let mut table = Self::list(
            self.caption.clone(),
            std::iter::once(Column::of(self.owners.clone())).chain(keys).chain(columns.iter().cloned()),
        );
        for (group, row) in
            self.groups.iter().flat_map(|group| (0..self.height()).map(move |row| (group, row)))
        {
            let cell = |column: &Column| column.cells.get(row).cloned().unwrap_or(Cell::None);
            let of = |wanted: &Column| {
                group.columns.iter().find(|column| column.head == wanted.head).map_or(Cell::None, cell)
            };
            let cells = std::iter::once(Cell::Text(group.owner.clone()));
            table.row(cells.chain(self.keys.iter().map(cell)).chain(columns.iter().map(of)));
        }
        table
    }
}
