//! A table of results as columns of numbers.

use std::collections::HashMap;
use std::sync::Arc;

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema, Table};
use assur_book::catalogue;

use crate::{Error, Reaction};

/// A table of results: one row for each position or sample, one column for each quantity, in SI. NaN stands where a row has no number.
#[derive(Debug, Clone, Default)]
pub struct Columns {
    schema: Arc<Schema>,
    numbers: Vec<usize>,
    names: Vec<String>,
    values: Vec<Vec<f64>>,
    /// Of each column, its index in the schema.
    sources: Vec<usize>,
    /// The index among the columns that are kept, by the index in the schema.
    kept: HashMap<usize, usize>,
}

impl Columns {
    /// The columns of a table that have names in CSV, without rows.
    pub(crate) fn of(schema: &Arc<Schema>, named: Vec<(usize, String)>) -> Self {
        let (sources, names): (Vec<usize>, Vec<String>) = named.into_iter().unzip();
        let kept = sources.iter().enumerate().map(|(own, source)| (*source, own)).collect();
        let values = vec![Vec::new(); names.len()];
        Self { schema: Arc::clone(schema), numbers: Vec::new(), names, values, sources, kept }
    }

    /// Makes room for so many rows.
    pub(crate) fn reserve(&mut self, rows: usize) {
        self.numbers.reserve_exact(rows);
        self.values.iter_mut().for_each(|values| values.reserve_exact(rows));
    }

    /// The rows of a table in the form in which [`append`](Self::append) takes them.
    pub(crate) fn block(&self, table: &Table) -> (Vec<usize>, Vec<Vec<f64>>) {
        let filled = |column: &usize| table.each(*column).map(|value| value.unwrap_or(f64::NAN)).collect();
        (table.numbers().to_vec(), self.sources.iter().map(filled).collect())
    }

    /// Adds rows.
    pub(crate) fn append(&mut self, (numbers, values): (Vec<usize>, Vec<Vec<f64>>)) {
        if self.numbers.capacity() == 0 {
            (self.numbers, self.values) = (numbers, values);
            return;
        }
        self.numbers.extend(numbers);
        for (own, more) in self.values.iter_mut().zip(values) {
            own.extend(more);
        }
    }

    /// How many rows there are.
    pub fn len(&self) -> usize {
        self.numbers.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// The number of the position or sample of each row, from 0. A position without a solution has no row.
    pub fn numbers(&self) -> &[usize] {
        &self.numbers
    }

    /// The names of the columns: those of the CSV, with their units.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The numbers of a column by its name, such as `B_x_m`, `rocker_angle_pf1_rad_per_rad` or `balancing_Nm`.
    ///
    /// # Errors
    ///
    /// No column has the name; the error names the most similar.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        let found = self.names.iter().position(|own| own == name);
        found
            .map(|index| &*self.values[index])
            .ok_or_else(|| Error::unknown("column", name, self.names.iter().map(String::as_str)))
    }

    /// The force of a pair by its name, on the link on which tables show it: of two links the first that moves.
    ///
    /// # Errors
    ///
    /// No pair has the name, or nothing is known of its force.
    pub fn reaction(&self, pair: &str) -> Result<Reaction<'_>, Error> {
        self.reaction_of(pair, None)
    }

    /// The force of a pair on one of its links.
    ///
    /// # Errors
    ///
    /// No pair of the link has the name, or nothing is known of its force.
    pub fn reaction_on(&self, pair: &str, link: &str) -> Result<Reaction<'_>, Error> {
        self.reaction_of(pair, Some(link))
    }

    fn reaction_of(&self, pair: &str, link: Option<&str>) -> Result<Reaction<'_>, Error> {
        let name_of = |link: usize| self.schema.links[link].as_str();
        let mut all = if link.is_some() {
            self.schema.owners(Quantity::Force)
        } else {
            let shown = catalogue::reactions(&self.schema).into_iter();
            shown.map(|(pair, link)| Owner::PairOn(pair, link)).collect()
        };
        all.retain(|owner| self.force(*owner, Part::X).is_some());
        let found = all.iter().copied().find_map(|owner| match owner {
            Owner::PairOn(of, on) if self.schema.name(owner) == pair => {
                link.is_none_or(|link| name_of(on) == link).then_some((owner, of, on))
            }
            _ => None,
        });
        let Some((owner, of, on)) = found else {
            let names: Vec<String> = all.iter().map(|owner| self.schema.name(*owner).into_owned()).collect();
            return Err(Error::unknown("pair with a known force", pair, names.iter().map(String::as_str)));
        };
        let [x, y] = [Part::X, Part::Y].map(|part| self.force(owner, part).unwrap_or_default());
        let moment = self.values_of(Quantity::Moment, Owner::Pair(of), Part::Whole);
        Ok(Reaction { on: name_of(on), x, y, moment })
    }

    fn force(&self, owner: Owner, part: Part) -> Option<&[f64]> {
        self.values_of(Quantity::Force, owner, part)
    }

    fn values_of(&self, quantity: Quantity, owner: Owner, part: Part) -> Option<&[f64]> {
        let column = Column { quantity, owner, part, cause: None };
        let own = self.schema.find(column).and_then(|index| self.kept.get(&index));
        own.map(|own| &*self.values[*own])
    }
}
