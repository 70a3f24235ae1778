//! Catalogues of IEC motors, one for each series of a maker.
//!
//! Where the numbers are from and what was checked: `data/README.md`. `IE3-LSES`, `IE3-FLSES` and `DELPHI` print
//! speed, breakdown torque, rotor inertia, mass and size together; `IE1-BN` prints no breakdown torque.

use assur_motor::{CataloguePlugin, CatalogueTable};
use assur_words::text;

assur_words::resources!();

/// Registers the catalogue of one file.
macro_rules! catalogue {
    ($name:literal, $file:literal, $summary:expr, $source:expr) => {
        inventory::submit! {
            CataloguePlugin {
                name: $name,
                crate_name: env!("CARGO_PKG_NAME"),
                summary: $summary,
                source: $source,
                table: {
                    static TABLE: CatalogueTable = CatalogueTable::new(include_str!(concat!("../data/", $file)));
                    &TABLE
                },
            }
        }
    };
}

catalogue!(
    "IE3-LSES",
    "iec_ie3_leroy_somer_lses.csv",
    text!("motors-iec-lses"),
    text!("motors-iec-lses.source")
);
catalogue!(
    "IE3-FLSES",
    "iec_ie3_leroy_somer_flses.csv",
    text!("motors-iec-flses"),
    text!("motors-iec-flses.source")
);
catalogue!(
    "IE3-1LE1003",
    "iec_ie3_innomotics_1le1003.csv",
    text!("motors-iec-1le1003"),
    text!("motors-iec-1le1003.source")
);
catalogue!(
    "IE3-1LE1503",
    "iec_ie3_innomotics_1le1503.csv",
    text!("motors-iec-1le1503"),
    text!("motors-iec-1le1503.source")
);
catalogue!(
    "IE1-1LE1002",
    "iec_ie1_innomotics_1le1002.csv",
    text!("motors-iec-1le1002"),
    text!("motors-iec-1le1002.source")
);
catalogue!("DELPHI", "iec_motive_delphi.csv", text!("motors-iec-delphi"), text!("motors-iec-delphi.source"));
catalogue!("IE1-BN", "iec_ie1_bonfiglioli_bn.csv", text!("motors-iec-bn"), text!("motors-iec-bn.source"));

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "whole kilowatts convert without rounding")]
mod tests;
