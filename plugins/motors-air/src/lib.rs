//! Catalogue `AIR`: asynchronous motors of the series АИР, 0.37 to 30 kW.
//!
//! Where the numbers are from and what was checked: `data/README.md`. The series prints no rotor inertia here.

use assur_motor::{CataloguePlugin, CatalogueTable};
use assur_words::text;

assur_words::resources!();

static TABLE: CatalogueTable = CatalogueTable::new(include_str!("../data/air.csv"));

inventory::submit! {
    CataloguePlugin {
        name: "AIR",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: text!("motors-air"),
        source: text!("motors-air.source"),
        table: &TABLE,
    }
}

#[cfg(test)]
mod tests;
