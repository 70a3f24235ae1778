//! Catalogue `AIR`: asynchronous motors of the series АИР, 0.37 to 30 kW.
//!
//! Where the numbers are from and what was checked: `data/README.md`. The series prints no rotor inertia here.

use assur_motor::{CataloguePlugin, CatalogueTable};

static TABLE: CatalogueTable = CatalogueTable::new(include_str!("../data/air.csv"));

inventory::submit! {
    CataloguePlugin {
        name: "AIR",
        crate_name: env!("CARGO_PKG_NAME"),
        summary: "series AIR, 0.37-30 kW, 2-8 poles; no rotor inertia",
        source: "textbook table of the series; list of the maker Polesyeelectromash",
        table: &TABLE,
    }
}

#[cfg(test)]
mod tests;
