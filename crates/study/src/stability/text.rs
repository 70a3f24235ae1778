//! The stability of a mechanism as text for a reader.

use std::collections::BTreeMap;

use assur_check::verdict;
use assur_words::{Language, Text, joined, list, name, number, quantity, text};

use super::report::Stability;
use super::row::{Comparison, FRICTION};
use super::{margin, walk};

const MOST_FAILED: usize = 10;

/// All distances of one method on one walk.
struct Walk<'a> {
    first: &'a Comparison,
    /// Largest error over bound.
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

    fn line(&self) -> Text {
        let refuses = self.refuses.map(|[least, most]| {
            if least < most {
                text!("stability-refuses-from", most = power(most), least = power(least))
            } else {
                text!("stability-refuses-at", distance = power(least))
            }
        });
        let factor = number(format_args!("{:.3}", self.factor));
        let Comparison { finding, method, .. } = self.first;
        let subject = joined("; ", [finding.place.clone(), method.clone(), self.first.quantity()]);
        joined(": ", [subject, list(std::iter::once(factor).chain(refuses)), verdict(Some(self.ok))])
    }
}

struct Lines<'l> {
    language: &'l Language,
    text: String,
}

impl Lines<'_> {
    /// A line that begins a section, behind an empty one.
    fn heading(&mut self, heading: &Text) {
        self.text.extend(["\n", &heading.render(self.language), "\n"]);
    }

    fn line(&mut self, line: &Text) {
        self.text.extend(["  ", &line.render(self.language), "\n"]);
    }
}

impl Stability {
    /// Text for a reader in a language: figures of the mechanism, one line for each approach and method, and conclusions.
    pub fn text(&self, language: &Language) -> String {
        let mut lines = Lines { language, text: format!("{}\n", self.title) };
        self.nearest(&mut lines);
        if self.failure.is_none() && !self.groups.is_empty() {
            self.margins(&mut lines);
        }
        if !self.friction.is_empty() {
            self.frictions(&mut lines);
        }
        if !self.rows.is_empty() {
            self.walks(&mut lines);
        }
        self.conclude(&mut lines);
        lines.text
    }

    /// The conclusions, with which [`Stability::text`] ends.
    pub fn conclusion(&self, language: &Language) -> String {
        let mut lines = Lines { language, text: String::new() };
        self.conclude(&mut lines);
        lines.text.trim_start().to_owned()
    }

    fn nearest(&self, lines: &mut Lines<'_>) {
        lines.heading(&text!("stability-nearest"));
        for group in &self.groups {
            lines.line(&text!(
                "stability-group",
                group = &group.place,
                health = number(format_args!("{:.6}", group.health)),
                coordinate = self.coordinate(group.coordinate),
                position = number(group.position),
                what = &group.angle_of,
                angle = quantity(format_args!("{:.3}", group.angle.to_degrees()), "deg"),
            ));
        }
        if let Some(failure) = &self.failure {
            lines.line(&text!("stability-no-assembly", failure));
        }
    }

    fn coordinate(&self, coordinate: f64) -> Text {
        let (unit, size) = if self.angular { ("deg", 180.0 / std::f64::consts::PI) } else { ("mm", 1e3) };
        quantity(format_args!("{:.4}", coordinate * size), unit)
    }

    fn frictions(&self, lines: &mut Lines<'_>) {
        lines.heading(&text!("stability-friction-nearest"));
        for group in &self.friction {
            lines.line(&group.words(self.coordinate(group.coordinate)));
        }
    }

    fn margins(&self, lines: &mut Lines<'_>) {
        if self.lengths.is_empty() {
            lines.heading(&text!("stability-many-lengths", most = number(margin::MOST_LENGTHS)));
            return;
        }
        lines.heading(&text!("stability-margins"));
        let show = |change: Option<f64>, searched: f64, sign: &'static str| match change {
            Some(change) => joined("", [name(sign), millimeters(change)]),
            None => text!("stability-no-margin", sign = name(sign), searched = millimeters(searched)),
        };
        for margin in &self.lengths {
            lines.line(&text!(
                "stability-margin",
                length = &margin.length,
                value = millimeters(margin.value),
                more = show(margin.increase, margin.increase_searched, "+"),
                less = show(margin.decrease, margin.decrease_searched, "-"),
            ));
        }
    }

    fn walks(&self, lines: &mut Lines<'_>) {
        lines.heading(&text!("stability-walks"));
        lines.text.push('\n');
        lines.line(&text!("stability-distance", what = text!(walk::ALONG)));
        lines.line(&text!("stability-bound", what = text!(walk::EXPECTED)));
        if self.rows.iter().any(|row| row.quantity == FRICTION) {
            lines.line(&text!("stability-friction-walk"));
        }
        if self.places_left_out > 0 {
            let [groups, places] = [self.groups.len(), self.places_left_out].map(number);
            lines.line(&text!("stability-places-left-out", groups, places));
        }
        for walk in walks_of(&self.rows) {
            lines.line(&walk.line());
        }
    }

    fn conclude(&self, lines: &mut Lines<'_>) {
        lines.heading(&text!("stability-conclusion"));
        if let Some(worst) = self.groups.iter().min_by(|a, b| a.health.total_cmp(&b.health)) {
            lines.line(&worst.words());
        }
        if let Some(least) = self.lengths.first()
            && let Some(change) = least.least()
        {
            let change = millimeters(change);
            lines.line(&text!("stability-critical", length = &least.length, change));
        }
        let failed: Vec<&Comparison> = self.rows.iter().filter(|row| row.finding.failed()).collect();
        lines.line(&match self.rows.len() {
            0 => text!("stability-no-walk"),
            all => text!("stability-kept", kept = number(all - failed.len()), all = number(all)),
        });
        for row in failed.into_iter().take(MOST_FAILED) {
            let Comparison { finding, method, distance, .. } = row;
            let what = list([finding.place.clone(), method.clone(), row.quantity(), power(*distance)]);
            lines.line(&joined(": ", [verdict(finding.holds), what, finding.why.clone()]));
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
