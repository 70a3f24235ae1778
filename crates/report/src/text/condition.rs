//! How near the groups come to singular positions.

use super::Source;
use super::layout::Page;
use super::motion::{column, keys};
use super::units::Unit;

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    let Some(first) = source.analysis.positions.first().filter(|first| !first.condition.is_empty()) else {
        return;
    };
    page.section("Condition of the groups");
    page.paragraph(
        "1 / (dimensionless determinant): 1 is the best there is; errors of PF1 grow with it, those of PF2 with its square; \
         infinite at a singular position.",
    );
    let unit = Unit { name: "", factor: 1.0 };
    let groups = first.condition.iter().map(|(name, _)| {
        let index = name.parse::<usize>().unwrap_or_default();
        let name = name.to_owned();
        vec![column(source, format!("group {}", index + 1), unit, move |p| p.condition.get(&name).copied())]
    });
    let groups = groups.collect();
    page.caption("Groups");
    page.table(&keys(source), groups);
}
