//! The drive: its characteristic and moments, the energy-mass diagram, the two places of the flywheel.

use assur_figure::Figure;
use assur_words::text;

use crate::{Look, Results, ViewPart, places, reduction, regime};

/// Characteristic and moments, the energy-mass diagram, or the shares of the reduced inertia, in so many columns.
pub fn figure(results: &Results, look: &Look<'_>, part: ViewPart, columns: usize) -> Figure {
    let Some(found) = &results.found else { return Figure::default() };
    let Some(dynamics) = &found.analysis.dynamics else { return Figure::default() };
    let panels = match part {
        ViewPart::EnergyMass => vec![regime::energy_mass(&dynamics.energy_mass)],
        ViewPart::Reduction => reduction::link(results, look, found).into_iter().collect(),
        ViewPart::Inertia => {
            let (panel, legend) = regime::shares(found, dynamics, look);
            return Figure { title: text!("drive-title"), panels: vec![panel], columns, legend };
        }
        // The two drives stand beside each other.
        ViewPart::Places => {
            let (panels, legend) =
                (places::panels(&results.linkage.mechanism, dynamics), places::legend(dynamics));
            return Figure { title: text!("places-heading"), columns: panels.len().max(1), panels, legend };
        }
        _ => {
            let moments = regime::moments(found, &dynamics.regime, look);
            let section = regime::working_section(dynamics).filter(|_| part == ViewPart::Curves);
            regime::characteristic(dynamics).into_iter().chain(section).chain([moments]).collect()
        }
    };
    Figure { title: text!("drive-title"), panels, columns, legend: Vec::new() }
}
