//! Catalogues of IEC motors, one for each series of a maker.
//!
//! Where the numbers are from and what was checked: `data/README.md`. `IE3-LSES`, `IE3-FLSES` and `DELPHI` print
//! speed, breakdown torque, rotor inertia, mass and size together; `IE1-BN` prints no breakdown torque.

use assur_motor::{CataloguePlugin, CatalogueTable};

/// Registers the catalogue of one file.
macro_rules! catalogue {
    ($name:literal, $file:literal, $summary:literal, $source:literal) => {
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
    "Leroy-Somer LSES, aluminum, 0.12-55 kW, 2-6 poles; IE3, below 0.75 kW IE2; complete",
    "Leroy-Somer IMfinity catalogue 5147 fr - 2023.08/j"
);
catalogue!(
    "IE3-FLSES",
    "iec_ie3_leroy_somer_flses.csv",
    "Leroy-Somer FLSES, cast iron, 0.75-110 kW, 2-6 poles; IE3; complete",
    "Leroy-Somer IMfinity catalogue 5147 fr - 2023.08/j"
);
catalogue!(
    "IE3-1LE1003",
    "iec_ie3_innomotics_1le1003.csv",
    "Innomotics 1LE1003, aluminum, 0.12-45 kW, 2-8 poles; IE3; no length, no diameter",
    "Innomotics Catalog D 81.1, edition 02/2026"
);
catalogue!(
    "IE3-1LE1503",
    "iec_ie3_innomotics_1le1503.csv",
    "Innomotics 1LE1503, cast iron, 0.09-110 kW, 2-8 poles; IE3; no length, no diameter",
    "Innomotics Catalog D 81.1, edition 02/2026"
);
catalogue!(
    "IE1-1LE1002",
    "iec_ie1_innomotics_1le1002.csv",
    "Innomotics 1LE1002, aluminum, 0.09-37 kW, 2-8 poles; IE1; no length, no diameter",
    "Innomotics Catalog D 81.1, edition 02/2026"
);
catalogue!(
    "DELPHI",
    "iec_motive_delphi.csv",
    "Motive Delphi, 0.06-110 kW, 2-8 poles; older classes eff1 and eff2; complete",
    "Motive s.r.l., general catalogue Delphi series, 07-04 rev. 03"
);
catalogue!(
    "IE1-BN",
    "iec_ie1_bonfiglioli_bn.csv",
    "Bonfiglioli BN, 0.06-30 kW, 2-6 poles; IE1; no breakdown torque: linear characteristic only",
    "Bonfiglioli motor catalogue BN, R07 EN"
);

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "whole kilowatts convert without rounding")]
mod tests;
