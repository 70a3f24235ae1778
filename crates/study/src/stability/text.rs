//! The stability of a mechanism as a page for a reader.

use std::collections::BTreeMap;

use assur_book::{Block, Document, Table, Unit};
use assur_check::verdict;
use assur_words::{Text, joined, list, number, quantity, text};

use super::friction::MOST;
use super::margin;
use super::report::Stability;
use super::row::{Comparison, FRICTION};

/// Most failed rows that the conclusion lists.
const MOST_FAILED: usize = 10;

struct Walk<'a> {
    first: &'a Comparison,
    factor: f64,
    /// Least and greatest distance at which the method refuses.
    refuses: Option<[f64; 2]>,
    ok: bool,
}

impl Walk<'_> {
    fn take(&mut self, row: &Comparison) {
        let found = &row.finding;
        self.ok &= !found.failed();
        if let Some(error) = found.number() {
            self.factor = self.factor.max(if error > 0.0 { error / found.bound } else { 0.0 });
        } else {
            let [least, most] = self.refuses.unwrap_or([row.distance; 2]);
            self.refuses = Some([least.min(row.distance), most.max(row.distance)]);
        }
    }

    fn refuses(&self) -> Option<Text> {
        let [least, most] = self.refuses?;
        Some(if least < most {
            text!("stability-refuses-from", most = power(most), least = power(least))
        } else {
            text!("stability-refuses-at", distance = power(least))
        })
    }
}

impl Stability {
    /// Figures of the mechanism, a row for each approach and method, and conclusions.
    pub fn tell(&self, page: &mut Document) {
        page.scene(&self.title);
        let coordinate = Unit::coordinate(self.kind);
        let nearest = Table::each(text!("stability-nearest"), &self.groups)
            .column(text!("head-group"), |group| group.place.clone())
            .column(text!("stability-head-determinant"), |group| group.health)
            .measured(text!("head-coordinate"), coordinate, |group| group.coordinate)
            .column(text!("head-position"), |group| number(group.position))
            .measured(text!("head-angle"), Unit::ANGLE, |group| group.angle)
            .column(text!("stability-head-angle-of"), |group| group.angle_of.clone());
        page.table(nearest.table());
        if let Some(failure) = &self.failure {
            page.paragraph(text!("stability-no-assembly", failure));
        } else if !self.groups.is_empty() {
            self.margins(page);
        }
        let friction = Table::each(text!("stability-friction-nearest"), &self.friction)
            .column(text!("head-group"), |group| group.place.clone())
            .column(text!("stability-head-radius"), |group| group.radius)
            .measured(text!("head-coordinate"), coordinate, |group| group.coordinate)
            .column(text!("stability-head-jams"), |group| match group.jams_at {
                Some(factor) => Unit::NONE.number(factor),
                None => text!("stability-friction-free", most = number(MOST)),
            });
        page.table(friction.table());
        if !self.rows.is_empty() {
            self.walks(page);
        }
        self.conclude(page);
    }

    fn margins(&self, page: &mut Document) {
        if self.lengths.is_empty() {
            return page.paragraph(text!("stability-many-lengths", most = number(margin::MOST_LENGTHS)));
        }
        let show = |change: Option<f64>, searched: f64| match change {
            Some(change) => millimeters(change),
            None => text!("stability-no-margin", searched = millimeters(searched)),
        };
        let table = Table::each(text!("stability-margins"), &self.lengths)
            .column(text!("stability-head-length"), |margin| margin.length.clone())
            .column(text!("head-value"), |margin| millimeters(margin.value))
            .column(text!("stability-head-increase"), |margin| {
                show(margin.increase, margin.increase_searched)
            })
            .column(text!("stability-head-decrease"), |margin| {
                show(margin.decrease, margin.decrease_searched)
            });
        page.table(table.table());
    }

    fn walks(&self, page: &mut Document) {
        page.blocks.push(Block::Subheading(text!("stability-walks")));
        page.paragraph(text!("stability-distance", what = text!("stability-along")));
        page.paragraph(text!("stability-bound", what = text!("stability-expected")));
        if self.rows.iter().any(|row| row.quantity == FRICTION) {
            page.paragraph(text!("stability-friction-walk"));
        }
        if self.places_left_out > 0 {
            let [groups, places] = [self.groups.len(), self.places_left_out].map(number);
            page.paragraph(text!("stability-places-left-out", groups, places));
        }
        let walks = walks_of(&self.rows);
        let refused = walks.iter().any(|walk| walk.refuses.is_some());
        let table = Table::each(Text::default(), &walks)
            .column(text!("head-place"), |walk| walk.first.finding.place.clone())
            .column(text!("head-method"), |walk| walk.first.method.clone())
            .column(text!("head-quantity"), |walk| walk.first.quantity())
            .column(text!("stability-head-error"), |walk| number(format_args!("{:.3}", walk.factor)));
        let table = if refused {
            table.column(text!("stability-head-refuses"), |walk| walk.refuses())
        } else {
            table
        };
        page.table(table.column(text!("head-result"), |walk| verdict(Some(walk.ok))).table());
    }

    /// The conclusions.
    pub fn conclude(&self, page: &mut Document) {
        page.blocks.push(Block::Subheading(text!("stability-conclusion")));
        if let Some(worst) = self.groups.iter().min_by(|a, b| a.health.total_cmp(&b.health)) {
            page.paragraph(worst.words());
        }
        if let Some(least) = self.lengths.first()
            && let Some(change) = least.least()
        {
            let change = millimeters(change);
            page.paragraph(text!("stability-critical", length = &least.length, change));
        }
        let failed: Vec<&Comparison> = self.rows.iter().filter(|row| row.finding.failed()).collect();
        page.paragraph(match self.rows.len() {
            0 => text!("stability-no-walk"),
            all => text!("stability-kept", kept = number(all - failed.len()), all = number(all)),
        });
        for row in failed.into_iter().take(MOST_FAILED) {
            let Comparison { finding, method, distance, .. } = row;
            let what = list([finding.place.clone(), method.clone(), row.quantity(), power(*distance)]);
            page.paragraph(joined(": ", [verdict(finding.holds), what, finding.why.clone()]));
        }
    }
}

fn power(number: f64) -> Text {
    assur_words::number(format_args!("{number:.0e}"))
}

/// A length in mm with eight significant digits, without zeros at the end.
fn millimeters(length: f64) -> Text {
    quantity(assur_figure::number::trimmed(length * 1e3, 8), "mm")
}

/// One entry for each method and quantity on each walk, by place.
fn walks_of(rows: &[Comparison]) -> Vec<Walk<'_>> {
    let mut found: BTreeMap<(String, String, &str), Walk<'_>> = BTreeMap::new();
    for row in rows {
        let walk = found.entry((row.finding.place.to_string(), row.method.to_string(), row.quantity));
        walk.or_insert(Walk { first: row, factor: 0.0, refuses: None, ok: true }).take(row);
    }
    found.into_values().collect()
}
