//! The stability of a mechanism as text for a reader.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::margin;
use super::report::Stability;
use super::row::Row;
use super::walk;

/// Most failed rows that the conclusion lists.
const MOST_FAILED: usize = 10;

/// All distances of one method on one walk.
struct Walk<'a> {
    first: &'a Row,
    /// Largest error over bound.
    factor: f64,
    /// Greatest and least distance at which the method refuses.
    refuses: Option<[f64; 2]>,
    ok: bool,
}

impl Walk<'_> {
    fn take(&mut self, row: &Row) {
        self.ok &= row.ok;
        if let Some(error) = row.error {
            self.factor = self.factor.max(if error > 0.0 { error / row.bound } else { 0.0 });
        } else {
            let [least, most] = self.refuses.unwrap_or([row.distance; 2]);
            self.refuses = Some([least.min(row.distance), most.max(row.distance)]);
        }
    }

    fn line(&self) -> String {
        let Row { place, method, quantity, .. } = self.first;
        let verdict = if self.ok { "ok" } else { "FAILED" };
        let refuses = match self.refuses {
            Some([least, most]) if least < most => format!(", refuses from {most:.0e} to {least:.0e}"),
            Some([least, _]) => format!(", refuses at {least:.0e}"),
            None => String::new(),
        };
        format!("  {place}; {method}; {quantity}: {:.3}{refuses}: {verdict}\n", self.factor)
    }
}

impl Stability {
    /// Text for a reader: figures of the mechanism, one line for each approach and method, and conclusions.
    pub fn to_text(&self) -> String {
        let mut text = format!("{}\n", self.title);
        self.nearest(&mut text);
        if self.failure.is_none() && !self.groups.is_empty() {
            self.margins(&mut text);
        }
        if !self.rows.is_empty() {
            self.walks(&mut text);
        }
        self.conclusion(&mut text);
        text
    }

    /// The conclusions, with which [`Stability::to_text`] ends.
    pub fn conclusion_text(&self) -> String {
        let mut text = String::new();
        self.conclusion(&mut text);
        text.trim_start().to_owned()
    }

    fn nearest(&self, text: &mut String) {
        text.push_str("\nNearest to a singular position over the cycle\n");
        let unit = if self.angular { ("deg", 180.0 / std::f64::consts::PI) } else { ("mm", 1e3) };
        for group in &self.groups {
            let _ = writeln!(
                text,
                "  {}: health {:.6} at coordinate {:.4} {} (near position {}); {} there {:.3} deg",
                group.place,
                group.health,
                group.coordinate * unit.1,
                unit.0,
                group.position,
                group.angle_of,
                group.angle.to_degrees()
            );
        }
        if let Some(failure) = &self.failure {
            let _ = writeln!(text, "  not assembled all over: {failure}");
        }
    }

    fn margins(&self, text: &mut String) {
        if self.lengths.is_empty() {
            let most = margin::MOST_LENGTHS;
            let _ = writeln!(
                text,
                "\nMargins of lengths: not searched, the mechanism has more than {most} lengths"
            );
            return;
        }
        text.push_str("\nLeast change of one length after which it no longer assembles all over\n");
        for margin in &self.lengths {
            let show = |change: Option<f64>, searched: f64, sign: &str| match change {
                Some(change) => format!("{sign}{} mm", millimeters(change)),
                None => format!("{sign} none found up to {} mm", millimeters(searched)),
            };
            let more = show(margin.increase, margin.increase_searched, "+");
            let less = show(margin.decrease, margin.decrease_searched, "-");
            let _ = writeln!(text, "  {} ({} mm): {more}, {less}", margin.length, millimeters(margin.value));
        }
    }

    fn walks(&self, text: &mut String) {
        text.push_str("\nWalks: largest error over bound, and the distances at which a method refuses\n");
        let _ = writeln!(text, "\n  distance: {}\n  bound: {}", walk::ALONG, walk::EXPECTED);
        if self.places_left_out > 0 {
            let _ = writeln!(
                text,
                "  {} groups: only the places of least health are walked to, {} others are left out",
                self.groups.len(),
                self.places_left_out
            );
        }
        for walk in walks_of(self.rows.iter()) {
            text.push_str(&walk.line());
        }
    }

    fn conclusion(&self, text: &mut String) {
        text.push_str("\nConclusion\n");
        let failed = self.rows.iter().filter(|row| !row.ok).count();
        if let Some(worst) = self.groups.iter().min_by(|a, b| a.health.total_cmp(&b.health)) {
            let _ = writeln!(text, "  {}", worst.words());
        }
        if let Some(least) = self.lengths.first()
            && let Some(change) = least.least()
        {
            let _ = writeln!(
                text,
                "  The most critical length is {}: {} mm of change.",
                least.length,
                millimeters(change)
            );
        }
        let _ = match self.rows.len() {
            0 => writeln!(
                text,
                "  No walk was made: there is no reference in 32 digits, or no place to walk to."
            ),
            all => {
                writeln!(text, "  {} of {all} rows keep their bound or refuse with a reason.", all - failed)
            }
        };
        for row in self.rows.iter().filter(|row| !row.ok).take(MOST_FAILED) {
            let reason = row.reason.as_deref().unwrap_or("");
            let _ = writeln!(
                text,
                "  FAILED: {}, {}, {}, {:.0e}: {reason}",
                row.place, row.method, row.quantity, row.distance
            );
        }
    }
}

/// A length in mm with eight significant digits, without zeros at the end.
fn millimeters(length: f64) -> String {
    assur_figure::number::trimmed(length * 1e3, 8)
}

/// One entry for each method and quantity on each walk, by place.
fn walks_of<'a>(rows: impl Iterator<Item = &'a Row>) -> Vec<Walk<'a>> {
    let mut found: BTreeMap<(&str, &str, &str), Walk<'_>> = BTreeMap::new();
    for row in rows {
        let walk = found.entry((&row.place, &row.method, row.quantity));
        walk.or_insert(Walk { first: row, factor: 0.0, refuses: None, ok: true }).take(row);
    }
    found.into_values().collect()
}
