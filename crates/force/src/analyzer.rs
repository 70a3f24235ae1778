//! The contract of a force analyzer.

use assur_group::Wrench;
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::Lanes;
use assur_plugin::{Registered, RegistryError};
use assur_words::{Text, text};

use crate::{Accelerations, Acting, Construction, ForceError, FreeMotion, FrictionIteration, Reactions};

/// Finds the balancing load and, where it can, the reactions in all pairs.
pub trait ForceAnalyzer: std::fmt::Debug + Send + Sync {
    /// Whether the method supports passive parts, whose reactions the equilibrium leaves undetermined: it gives those of least norm and
    /// marks what is [open](Reactions::open).
    fn treats_passive(&self) -> bool {
        false
    }

    /// Whether the method supports mechanisms whose coordinate is the time, of which each drive has a load.
    fn treats_time(&self) -> bool {
        true
    }

    /// Whether the method supports this mechanism.
    ///
    /// # Errors
    ///
    /// Why not, as a clause: `it has 7 links; the method needs 3`.
    fn supports(&self, _linkage: &Linkage) -> Result<(), Text> {
        Ok(())
    }

    /// Solves one position.
    ///
    /// `loads`: all loads with the inertia loads, one wrench for each body about the origin of its frame; the method may
    /// change them. `position` needs PF1. Call [`supports`](Self::supports) once before.
    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError>;

    /// Solves eight positions at once, if the method can: whether it has. Where it has not (also where one of the lanes
    /// has no solution), the positions are solved one at a time.
    ///
    /// Arguments as for [`solve`](Self::solve), of which every lane must get the bits.
    fn solve_lanes(
        &self,
        _linkage: &Linkage,
        _position: &LanePosition,
        _loads: &mut [Wrench<Lanes>],
        _out: &mut Reactions<Lanes>,
    ) -> bool {
        false
    }

    /// The construction on paper that corresponds to the method, at one position; `None` for a method without one.
    ///
    /// `loads`: all loads with the inertia loads, each where it acts.
    fn construction(
        &self,
        _linkage: &Linkage,
        _position: &Position,
        _loads: &[Acting],
    ) -> Result<Option<Construction>, ForceError> {
        Ok(None)
    }

    /// The accelerations that are possible with dry friction in the senses of `out`, whose other
    /// numbers are overwritten; the position needs PF2. `None` for a method that does not support friction, and where all pairs are ideal.
    ///
    /// # Errors
    ///
    /// Those of [`Self::solve`], without [`ForceError::Jammed`]: where none is possible there is none among the solutions.
    fn accelerations(
        &self,
        _linkage: &Linkage,
        _position: &Position,
        _motion: &FreeMotion<'_>,
        _out: &mut Reactions,
    ) -> Option<Result<Accelerations, ForceError>> {
        None
    }

    /// What the method finds of dry friction in the senses of `out` beyond the reactions; `None` for a method that does not support
    /// it, and where all pairs are ideal.
    fn friction<'a>(
        &self,
        _linkage: &'a Linkage,
        _position: &'a Position,
        _out: &'a Reactions,
    ) -> Option<Box<dyn FrictionAnalysis + 'a>> {
        None
    }

    /// The factor by which the method magnifies rounding in this position beyond the groups themselves (1 /
    /// determinant); 1 for a method without singular positions of its own. Infinite where it has no solution.
    fn condition(&self, _linkage: &Linkage, _position: &Position) -> f64 {
        1.0
    }
}

/// Dry friction at one position; `loads` as for [`ForceAnalyzer::solve`].
pub trait FrictionAnalysis {
    /// Where it leaves no solution: the upper end of the interval from 0 of the factors k for which there is one with all
    /// coefficients times k.
    fn jamming_limit(&self, loads: &[Wrench<f64>]) -> f64;

    /// How it is found, in solving order.
    fn iteration(&self, loads: &[Wrench<f64>]) -> Vec<FrictionIteration>;
}

impl AnalyzerPlugin {
    /// Whether the method supports this mechanism, with its friction.
    ///
    /// # Errors
    ///
    /// Why not, as a clause.
    pub fn supports(&self, linkage: &Linkage) -> Result<(), Text> {
        if !linkage.mechanism.frictions.is_empty() && !self.treats_friction {
            return Err(text!("force-without-friction"));
        }
        if !linkage.structure.passive.is_empty() && !self.instance.treats_passive() {
            return Err(text!("force-without-passive"));
        }
        if linkage.kind().is_time() && !self.instance.treats_time() {
            return Err(text!("force-without-time"));
        }
        self.instance.supports(linkage)
    }
}

/// Entry of a method in the registry: `inventory::submit! { AnalyzerPlugin { ... } }`.
#[derive(Debug, Clone)]
pub struct AnalyzerPlugin {
    /// Stable identifier, lower case: `newton-euler`.
    pub name: &'static str,
    /// The crate that registers it.
    pub crate_name: &'static str,
    /// One line.
    pub summary: Text,
    /// How a note says it, the end of "Reactions are found ...": `by one linear system of all links`.
    pub wording: Text,
    /// Source of the formulas.
    pub source: Text,
    /// The method.
    pub instance: &'static dyn ForceAnalyzer,
    /// Names of further forces that it finds, N: [`Reactions::further`](crate::Reactions::further).
    pub further: &'static [&'static str],
    /// Whether it finds reactions; otherwise the balancing load alone.
    pub gives_reactions: bool,
    /// Whether it finds the dry friction of pairs ([`Reactions::friction`](crate::Reactions::friction)).
    pub treats_friction: bool,
    /// Whether the method solves group by group, so that a group which is not placed or carries no load can be left out
    /// ([`Reactions::solved`](crate::Reactions::solved)). Other methods need all groups placed.
    pub by_groups: bool,
    /// Order of preference: of the methods that give what is wanted (reactions, the balancing load alone, forces group by
    /// group), the one of the lowest rank is used where the user names none. Methods of equal rank go by name.
    pub rank: u8,
}

assur_plugin::registry!(AnalyzerPlugin, text!("force-sort"), name);

/// All registered methods, sorted by name.
pub fn analyzers() -> Result<Vec<&'static AnalyzerPlugin>, RegistryError> {
    assur_plugin::all()
}

/// The registered methods that support a mechanism, sorted by name; none where the registry is faulty.
pub fn applicable(linkage: &Linkage) -> Vec<&'static AnalyzerPlugin> {
    let all = analyzers().unwrap_or_default().into_iter();
    all.filter(|plugin| plugin.supports(linkage).is_ok()).collect()
}

/// The method of this name.
pub fn find(name: &str) -> Result<&'static AnalyzerPlugin, RegistryError> {
    assur_plugin::find(name)
}

/// The method of this name; without a name the preferred one of those that give reactions, and support the friction of pairs
/// and passive parts where there are any.
pub fn choose(
    name: Option<&str>,
    friction: bool,
    passive: bool,
) -> Result<&'static AnalyzerPlugin, RegistryError> {
    if let Some(name) = name {
        return find(name);
    }
    let all = analyzers()?
        .into_iter()
        .filter(|plugin| plugin.gives_reactions && plugin.treats_friction >= friction)
        .filter(|plugin| plugin.instance.treats_passive() >= passive);
    all.min_by_key(|plugin| plugin.rank).ok_or(RegistryError::Empty(AnalyzerPlugin::WHAT))
}
