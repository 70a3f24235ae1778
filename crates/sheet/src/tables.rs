//! The tables of a sheet: the forces and the lever with their numbers in all positions that have plans, and the results.

use std::collections::BTreeSet;

use assur_book::Fact;
use assur_mechanism::LinkId;
use assur_picture::{plans, plans::LeverForce, polygons};
use assur_report::topic::{self, About};
use assur_scene::SheetField;
use assur_words::{Language, Text, joined, measured, name, text};

use crate::drawn::{Content, Drawn, Table};
use crate::fields::Source;

/// Digits of numbers before those of the note.
const DIGITS: usize = 5;

/// A row of a table: its words, and its values in the positions that it has been found in.
struct Row {
    words: Vec<Text>,
    values: Vec<Option<Vec<Text>>>,
}

/// Puts the values of a position into the row with this symbol, or into a new one: what acts on two links has one size on both.
fn put(rows: &mut Vec<Row>, words: Vec<Text>, at: usize, values: Vec<Text>) {
    let known = rows.iter().position(|row| row.words[0] == words[0]).unwrap_or_else(|| {
        rows.push(Row { words, values: Vec::new() });
        rows.len() - 1
    });
    let row = &mut rows[known];
    row.values.resize(row.values.len().max(at + 1), None);
    row.values[at].get_or_insert(values);
}

impl Source<'_> {
    /// A table of these rows with so many values in each position; none without rows.
    fn table(&self, field: SheetField, title: &Text, rows: &[Row], count: usize) -> Option<Drawn> {
        let words = rows.first()?.words.len();
        let mut head = vec![Text::default(); words];
        for position in &self.plans {
            let place = self.place(*position);
            head.extend(match count {
                1 => vec![place],
                _ => ["F", "h"].map(|symbol| joined(", ", [name(symbol), place.clone()])).into(),
            });
        }
        let line = |text: &Text, language: &Language| text.typeset(language).replace('`', "");
        let none = || vec![name("–"); count];
        let cells = |row: &Row| {
            let values = (0..self.plans.len())
                .flat_map(|at| row.values.get(at).cloned().flatten().unwrap_or_else(none));
            let values: Vec<Text> = values.collect();
            // A symbol has the numbers of links, what it is has their names.
            let words = row.words.iter().enumerate();
            let words = words.map(|(at, own)| line(own, if at == 0 { self.numbered } else { self.language }));
            words.chain(values.iter().map(|own| line(own, self.language))).collect()
        };
        let table = Table {
            title: title.typeset(self.language),
            head: head.iter().map(|own| line(own, self.language)).collect(),
            rows: rows.iter().map(cells).collect(),
            words,
        };
        Some(drawn(field, table))
    }

    /// What the symbols of loads and reactions stand for, with their sizes in all positions.
    pub(crate) fn table_of_forces(&self, bodies: &[Vec<LinkId>]) -> Option<Drawn> {
        let mut rows = Vec::new();
        // From the input link to the last group, as positions are found.
        for (polygon, links) in bodies.iter().enumerate().rev() {
            for (at, position) in self.plans.iter().enumerate() {
                for own in polygons::acting(self.results, *position, polygon, links) {
                    let size = measured(own.size, DIGITS, own.unit);
                    put(&mut rows, vec![own.symbol, own.told], at, vec![size]);
                }
            }
        }
        self.table(SheetField::Forces, &text!("sheet-symbols"), &rows, 1)
    }

    /// The symbols of the loads on the links in the positions of the plans.
    fn symbols_of_forces(&self) -> BTreeSet<String> {
        let bodies = polygons::bodies(self.results);
        let of = |position: &usize| {
            let acting = |(polygon, links): (usize, &Vec<LinkId>)| {
                polygons::acting(self.results, *position, polygon, links)
            };
            bodies.iter().enumerate().flat_map(acting).collect::<Vec<_>>()
        };
        self.plans.iter().flat_map(of).map(|own| own.symbol.to_string()).collect()
    }

    /// The forces on Zhukovsky's lever with their arms in all positions; and what they are, where the table of forces has not all of them.
    pub(crate) fn table_of_lever(&self) -> Option<Drawn> {
        let mut rows = Vec::new();
        let symbols = self.symbols_of_forces();
        let is_known = |own: &LeverForce| {
            let symbol = own.symbol.to_string();
            own.is_balancing || symbols.contains(symbol.trim_end_matches('′'))
        };
        let mut all = self.plans.iter().flat_map(|position| plans::on_lever(self.results, *position));
        let are_known = all.all(|own| is_known(&own));
        for (at, position) in self.plans.iter().enumerate() {
            for own in plans::on_lever(self.results, *position) {
                let (arm, unit) = own.arm;
                let values = vec![measured(own.size, DIGITS, "N"), measured(arm, DIGITS, unit)];
                let of = (!are_known).then_some(own.of);
                put(&mut rows, std::iter::once(own.symbol).chain(of).collect(), at, values);
            }
        }
        self.table(SheetField::Lever, &text!("sheet-lever-forces"), &rows, 2)
    }

    /// The results that are asked for first.
    pub(crate) fn table_of_results(&self) -> Drawn {
        /// Rows that a sheet has beside those of the regime, to which flywheel and motor belong.
        const MOST: usize = 24;
        let facts = topic::results(&self.found.analysis, &self.results.linkage);
        let (regime, others): (Vec<_>, Vec<_>) =
            facts.into_iter().partition(|(about, _)| *about == About::Regime);
        let facts = others.into_iter().take(MOST).chain(regime).map(|(_, fact)| fact);
        let line = |text: &Text, language: &Language| text.typeset(language).replace('`', "");
        // The formula of the structure has the numbers of the links.
        let row =
            |fact: &Fact| vec![line(&fact.what(), self.language), line(&fact.with_unit(), self.numbered)];
        let rows = facts.map(|fact| row(&fact)).collect();
        let title = text!("sheet-results").typeset(self.language);
        drawn(SheetField::Results, Table { title, head: Vec::new(), rows, words: 1 })
    }
}

fn drawn(field: SheetField, table: Table) -> Drawn {
    Drawn { field, content: Content::Table(table), weight: 1.0, least: 0.0, has_numbers: true }
}
