//! Catalogue `4A`: asynchronous motors of the series 4А, closed design (IP44), 0.06 to 90 kW.
//!
//! Where the numbers are from and what was checked: `data/README.md`. The series prints no rotor inertia here,
//! and its breakdown torques are guaranteed minima.

use assur_motor::{CataloguePlugin, CatalogueTable};
use assur_words::text;

assur_words::resources!();

static TABLE: CatalogueTable = CatalogueTable::new(include_str!("../data/4a.csv"));

inventory::submit! {
    CataloguePlugin {
        name: "4A",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("motors-4a"),
        source: text!("motors-4a.source"),
        table: &TABLE,
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "whole kilowatts convert without rounding")]
mod tests;
