//! The working of a force analyzer, beside that of the groups: a registry of its own, and the proof of one against the other.

use assur_group::Body;
use assur_kinematics::Linkage;
use assur_mechanism::LinkId;
use assur_plugin::RegistryError;
use assur_words::{Text, name, text};
use assur_worksheet::{Expr, Sheet, Symbol};

use crate::{Work, WorkingError, balancing};

/// What the working of a force analyzer finds.
#[derive(Debug, Clone)]
pub struct FoundForces {
    /// Forces of pairs (by their number in the chain), each on one of their links, N.
    pub reactions: Vec<(usize, LinkId, [Expr; 2])>,
    /// The balancing moment on the input link, N m (a force, N, on a sliding one).
    pub balancing: Expr,
}

/// Writes the forces of one position by a method, section by section; the sheet has the positions, PF1 and PF2 of all bodies and
/// the loads on all links.
///
/// # Errors
///
/// Why the method has no working in this position, as a sentence.
pub type WriteForces = fn(&mut Sheet, &Linkage, &[Body<f64>]) -> Result<FoundForces, Text>;

/// Entry of an analyzer's working in the registry: `inventory::submit! { AnalyzerWorking { ... } }`.
#[derive(Debug, Clone, Copy)]
pub struct AnalyzerWorking {
    /// Name of the force analyzer.
    pub analyzer: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// Writes its forces.
    pub forces: WriteForces,
}

assur_plugin::registry!(AnalyzerWorking, text!("working-of-analyzer"), analyzer);

impl Work<'_> {
    /// Writes the forces by the method of an analyzer, if it has a working, and compares them with those by the groups.
    pub(crate) fn by_method(&mut self, analyzer: &str) -> Result<(), WorkingError> {
        let plugin: &AnalyzerWorking = match assur_plugin::find(analyzer) {
            Ok(plugin) => plugin,
            Err(RegistryError::Empty(_) | RegistryError::Unknown { .. }) => return Ok(()),
            Err(fault) => return Err(fault.into()),
        };
        let before = self.sheet.clone();
        match (plugin.forces)(&mut self.sheet, self.linkage, self.bodies) {
            Ok(found) if !self.sheet.is_unfit() => self.proof(plugin.analyzer, &found),
            found => {
                self.sheet = before;
                self.sheet.section(text!("working-by-method", method = wording(plugin.analyzer)));
                self.sheet.note(found.err().unwrap_or_else(|| text!("working-no-method")));
            }
        }
        Ok(())
    }

    /// What the method found, less what the groups gave: zero but for rounding.
    fn proof(&mut self, analyzer: &'static str, found: &FoundForces) {
        self.sheet.section(text!("working-method-and-groups", method = wording(analyzer)));
        self.sheet.note(text!("working-differences"));
        for (pair, on, force) in &found.reactions {
            let known = self.sheet.reactions().iter().find(|known| known.pair == *pair).cloned();
            let Some(known) = known else { continue };
            // On the other link the pair exerts the opposite.
            let known = if known.on == *on { known.force } else { known.force.map(|part| -part) };
            let of = self.sheet.acting(*pair, *on);
            for ((own, known), axis) in force.iter().zip(&known).zip(["x", "y"]) {
                self.sheet.work(Symbol::from("ΔR").of(axis).of(&of), &(own - known), "N");
            }
        }
        let Some(known) = self.sheet.find(self.balancing_at_input()) else { return };
        let symbol = balancing(if self.linkage.kind().is_angle() { "ΔM" } else { "ΔF" });
        self.sheet.work(symbol, &(&found.balancing - known), self.sheet.units.moment);
    }
}

/// How an analyzer finds forces, in words; its name where it is not registered.
fn wording(analyzer: &'static str) -> Text {
    let all = assur_force::analyzers().unwrap_or_default();
    all.iter()
        .find(|plugin| plugin.name == analyzer)
        .map_or_else(|| name(analyzer), |own| own.wording.clone())
}
