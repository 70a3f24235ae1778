//! The stability of a scene's mechanism, as data, JSON and text.

use std::collections::BTreeMap;
use std::fmt::Write;

use assur_kinematics::{CompileError, Linkage};
use assur_mechanism::Mechanism;
use serde::Serialize;

use super::cycle::{self, GroupHealth};
use super::margin::{self, Margin};
use super::row::Row;
use super::walk_cycle::Walk;
use super::walk_group;

/// What was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stability {
    /// Title of the scene.
    pub title: String,
    /// Whether coordinates are angles, rad; otherwise m.
    pub angular: bool,
    /// By group: how near it comes to a singular position.
    pub groups: Vec<GroupHealth>,
    /// By length: the least change that breaks the mechanism, the smallest first.
    pub lengths: Vec<Margin>,
    /// The walks.
    pub rows: Vec<Row>,
    /// Why the mechanism can't be assembled all over its cycle; `groups` and `lengths` are then empty.
    pub failure: Option<String>,
}

/// Place, method, quantity.
type WalkKey<'a> = (&'a str, &'a str, &'a str);
/// Largest error over bound, greatest distance at which the method refuses, whether all rows are ok.
type WalkWorst = (f64, Option<f64>, bool);

/// Studies a mechanism: its own cycle, and walks towards each singular position that its groups have.
///
/// # Errors
///
/// [`CompileError`] if it can't be taken apart into registered groups.
pub fn stability(mut mechanism: Mechanism) -> Result<Stability, CompileError> {
    // The walks load every link themselves, with the balancing load on the input link.
    mechanism.balance = None;
    let linkage = Linkage::compile(mechanism)?;
    let mut rows = Vec::new();
    for (index, group) in linkage.structure.groups.iter().enumerate() {
        rows.extend(walk_group::walk(&linkage.structure.group_name(&linkage.mechanism, index), group));
    }
    let (groups, failure) = match cycle::healths(&linkage) {
        Ok(groups) => (groups, None),
        Err(failure) => (Vec::new(), Some(failure)),
    };
    if let Some(walk) = Walk::new(&linkage) {
        for (index, least) in groups.iter().enumerate() {
            walk.to(index, least, &mut rows);
        }
    }
    let critical: Vec<f64> = groups.iter().map(|group| group.coordinate).collect();
    let lengths = if failure.is_none() { margin::margins(&linkage, &critical) } else { Vec::new() };
    let (title, angular) = (linkage.mechanism.title.clone(), linkage.angular());
    Ok(Stability { title, angular, groups, lengths, rows, failure })
}

impl Stability {
    /// Whether the mechanism assembles and every row keeps its bound or has a right to refuse.
    pub fn is_ok(&self) -> bool {
        self.failure.is_none() && self.rows.iter().all(|row| row.ok)
    }

    /// As one JSON object in one line.
    ///
    /// # Errors
    ///
    /// From the writer of JSON.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self).map(|text| text + "\n")
    }

    /// All rows as a table with commas, one header row.
    pub fn to_csv(&self) -> String {
        let mut text = "where,method,quantity,distance,health,error,bound,ok,reason\n".to_owned();
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        for row in &self.rows {
            let error = row.error.map_or_else(String::new, |error| format!("{error:e}"));
            let _ = writeln!(
                text,
                "{},{},{},{:e},{:e},{error},{:e},{},{}",
                quoted(&row.place),
                quoted(&row.method),
                row.quantity,
                row.distance,
                row.health,
                row.bound,
                row.ok,
                quoted(row.reason.as_deref().unwrap_or(""))
            );
        }
        text
    }

    /// For a reader: the mechanism's own figures, one line a walk and method, and what follows.
    pub fn to_text(&self) -> String {
        let mut text = format!("{}\n\nNearest to a singular position over the cycle\n", self.title);
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
        self.margins(&mut text);
        self.walks(&mut text);
        self.conclusion(&mut text);
        text
    }

    fn margins(&self, text: &mut String) {
        if self.lengths.is_empty() {
            if self.failure.is_none() {
                let most = margin::MOST_LENGTHS;
                let _ = writeln!(
                    text,
                    "\nMargins of lengths: not searched, the mechanism has more than {most} lengths"
                );
            }
            return;
        }
        text.push_str("\nLeast change of one length after which it no longer assembles all over\n");
        for margin in &self.lengths {
            let show = |change: Option<f64>, sign: &str| match change {
                Some(change) => format!("{sign}{:.6} mm", change * 1e3),
                None => format!("{sign}any"),
            };
            let (more, less) = (show(margin.increase, "+"), show(margin.decrease, "-"));
            let _ = writeln!(text, "  {} ({:.6} mm): {more}, {less}", margin.length, margin.value * 1e3);
        }
    }

    fn walks(&self, text: &mut String) {
        text.push_str("\nWalks: largest error over bound, and from which distance on a method refuses\n");
        let mut walks: BTreeMap<WalkKey<'_>, WalkWorst> = BTreeMap::new();
        for row in &self.rows {
            let walk = walks.entry((&row.place, &row.method, row.quantity)).or_insert((0.0, None, true));
            walk.2 &= row.ok;
            match row.error {
                Some(error) => walk.0 = walk.0.max(error / row.bound),
                None => walk.1 = Some(walk.1.unwrap_or(0.0_f64).max(row.distance)),
            }
        }
        for ((place, method, quantity), (factor, refuses, ok)) in walks {
            let refuses = refuses.map_or_else(String::new, |d| format!(", refuses at {d:.0e}"));
            let verdict = if ok { "ok" } else { "FAILED" };
            let _ = writeln!(text, "  {place}; {method}; {quantity}: {factor:.3}{refuses}: {verdict}");
        }
    }

    fn conclusion(&self, text: &mut String) {
        text.push_str("\nConclusion\n");
        let failed = self.rows.iter().filter(|row| !row.ok).count();
        if let Some(worst) = self.groups.iter().min_by(|a, b| a.health.total_cmp(&b.health)) {
            let digits = (-(f64::EPSILON / worst.health.max(1e-8).powi(2)).log10()).clamp(0.0, 16.0);
            let _ = writeln!(
                text,
                "  {} comes closest to a singular position (health {:.3e}): about {digits:.0} digits are left there \
                 of velocities and reactions.",
                worst.place, worst.health
            );
        }
        if let Some(least) = self.lengths.first()
            && let Some(change) = least.least()
        {
            let _ = writeln!(
                text,
                "  The most critical length is {}: {:.6} mm of change.",
                least.length,
                change * 1e3
            );
        }
        let _ = writeln!(
            text,
            "  {} of {} rows keep their bound or refuse with a reason.",
            self.rows.len() - failed,
            self.rows.len()
        );
        for row in self.rows.iter().filter(|row| !row.ok).take(10) {
            let reason = row.reason.as_deref().unwrap_or("");
            let _ = writeln!(
                text,
                "  FAILED: {}, {}, {}, {:.0e}: {reason}",
                row.place, row.method, row.quantity, row.distance
            );
        }
    }
}
