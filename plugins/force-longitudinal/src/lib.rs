//! Longitudinal reactions (source L) for a crank with one group RRP or RRR.
//!
//! ```text
//!            P   pole: crank line OA cut with line 3 through B
//!           / \            line 3: across the guide (slider), or the rocker itself (BC)
//!          /   \
//!         /     \    F through K: all that loads the coupler
//!        A---K---B       F + Fb + RP = 0,  RP = R1 + R3
//!       /        |       Fb at A, across the crank; R1 along the crank; R3 along line 3
//!      O       guide
//! ```
//!
//! Two analyzers find the same unknowns Fb, R1, R3:
//!
//! * `longitudinal-published`: equations (1) to (12) of L with the pole in plain coordinates. It has no solution where the
//!   crank is parallel to line 3 (a slider-crank with the crank across the guide), and loses digits around.
//! * `longitudinal`: R3 from moments about A, then the components of the force at A. As stable as the group itself.
//!
//! Other cases are first reduced to that of L. The component of a slider's load along the guide acts on the coupler at
//! B, the other component on the guide. A rocker's loads give the tangential reaction at B by moments about C. Loads on
//! the crank change the balancing moment and the reaction at O only. The tests contain the equations as printed, for
//! the press of L.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod drawing;
mod forms;
mod layout;
mod working;

use assur_force::{Acting, AnalyzerPlugin, Construction, ForceAnalyzer, ForceError, Reactions};
use assur_group::{GroupError, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_words::{Text, text};

use layout::{Layout, Setting, Unknowns};

assur_words::resources!();

assur_force::inventory::submit! { entry(Longitudinal::Stable.name(), &Longitudinal::Stable, text!("force-longitudinal"), 2) }

assur_force::inventory::submit! {
    entry(Longitudinal::Published.name(), &Longitudinal::Published, text!("force-longitudinal-published"), 3)
}

const fn entry(
    name: &'static str,
    instance: &'static dyn ForceAnalyzer,
    summary: Text,
    rank: u8,
) -> AnalyzerPlugin {
    AnalyzerPlugin {
        name,
        crate_name: env!("CARGO_PKG_NAME"),
        summary,
        wording: text!("force-longitudinal.wording"),
        source: text!("force-longitudinal.source"),
        instance,
        further: &["Fb", "R1", "R3"],
        gives_reactions: true,
        treats_friction: false,
        by_groups: false,
        rank,
    }
}

/// The method, by how the three unknowns are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Longitudinal {
    /// Moments about A, which is always finite.
    Stable,
    /// Moments about the pole P (L eqs. 5-11).
    Published,
}

impl Longitudinal {
    const fn name(self) -> &'static str {
        match self {
            Self::Stable => "longitudinal",
            Self::Published => "longitudinal-published",
        }
    }

    /// Geometry, loads and unknowns at a position.
    fn solved(
        self,
        linkage: &Linkage,
        position: &Position,
        loads: &[Wrench<f64>],
    ) -> Result<(Layout, Setting, Unknowns), ForceError> {
        let layout = Layout::of(linkage)
            .map_err(|reason| ForceError::Unsupported { analyzer: self.name(), reason })?;
        let setting = Setting::of(&layout, &position.bodies, loads);
        let unknowns = match self {
            Self::Stable => {
                forms::stable(&setting).map_err(|health| singular(linkage, position.coordinate, health))
            }
            Self::Published => forms::published(&setting)
                .map_err(|failure| failure.explain(linkage, &layout, position.coordinate)),
        }?;
        Ok((layout, setting, unknowns))
    }
}

/// The error of a position in which the group itself is singular.
fn singular(linkage: &Linkage, coordinate: f64, health: f64) -> ForceError {
    let group = linkage.structure.group_name(&linkage.mechanism, 0);
    ForceError::Group { group, coordinate, source: GroupError::Singular { health } }
}

impl ForceAnalyzer for Longitudinal {
    fn treats_time(&self) -> bool {
        false
    }

    fn supports(&self, linkage: &Linkage) -> Result<(), Text> {
        Layout::of(linkage).map(|_| ())
    }

    fn solve(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        let (layout, setting, unknowns) = self.solved(linkage, position, loads)?;
        layout::store(&layout, &setting, &unknowns, &position.bodies, loads, out);
        Ok(())
    }

    fn construction(
        &self,
        linkage: &Linkage,
        position: &Position,
        loads: &[Acting],
    ) -> Result<Option<Construction>, ForceError> {
        let wrenches = Acting::total(loads, linkage.structure.links);
        let (layout, setting, unknowns) = self.solved(linkage, position, &wrenches)?;
        let scene = drawing::Scene::of(&layout, linkage, &position.bodies, (loads, &wrenches));
        Ok(Some(drawing::draw(&scene, &setting, &unknowns)))
    }

    fn condition(&self, linkage: &Linkage, position: &Position) -> f64 {
        let Ok(layout) = Layout::of(linkage) else { return f64::INFINITY };
        if *self == Self::Stable {
            return 1.0;
        }
        let setting = Setting::of(&layout, &position.bodies, &vec![Wrench::ZERO; position.bodies.len()]);
        1.0 / drawing::Pole::of(&setting).weight.abs()
    }
}

#[cfg(test)]
mod tests;
