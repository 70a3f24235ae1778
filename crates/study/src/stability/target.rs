//! Where walks of a mechanism go.

use assur_group::Order;
use assur_kinematics::Linkage;

use super::cycle::{self, GroupHealth};
use super::row::Law;

pub(crate) static CYCLE: Law = Law {
    section: "cycle",
    along: "distance of the coordinate from where the group is least healthy, rad or parts of the size",
    expected: "16 eps (1 + |q|) (groups / product of healths)^k, q in rad or parts of the size: k = 1 for \
               places, 2 for PF1, PF2 and reactions; for all but reactions times (longest / shortest \
               length), and where PF2 is small against its terms PF1^2 / health times their quotient; \
               around a change point, where the motion is interpolated, k = 1, 2, 3 with the healths where \
               that begins; for the published longitudinal form also / sine^2 of the angle at the pole",
};

/// Where a walk goes.
#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) law: &'static Law,
    /// What takes the place of the group's name.
    pub(crate) name: Option<String>,
    pub(crate) coordinate: f64,
    /// From which sides, 1 or -1.
    pub(crate) sides: Vec<f64>,
    /// How far there is a way to walk, rad or m.
    pub(crate) reach: f64,
    /// The groups that are least healthy there.
    pub(crate) groups: Vec<usize>,
    /// What is there.
    pub(crate) words: &'static str,
}

impl Target {
    /// The walk, as rows name it.
    pub(crate) fn place(&self, linkage: &Linkage, group: usize, more: &str) -> String {
        let name = match &self.name {
            Some(name) => name.clone(),
            None => linkage.structure.group_name(&linkage.mechanism, group),
        };
        format!("{name}{more}, {}", self.words)
    }
}

/// Where each group is least healthy, and where the range ends; groups that are so at one place, as in a row of
/// parallelograms, are walked to together.
pub(crate) fn targets(linkage: &Linkage, groups: &[GroupHealth]) -> Vec<Target> {
    /// A search for the least health finds its place to so much, rad or parts of the scale.
    const SAME: f64 = 1e-6;
    let unit = linkage.coordinate_unit();
    let mut targets: Vec<Target> = Vec::new();
    for (index, least) in groups.iter().enumerate() {
        let change = linkage.interpolation(least.coordinate);
        let coordinate = change.map_or(least.coordinate, |across| across.center);
        let words = if change.is_some() { "change point" } else { "least health of the cycle" };
        let near = |target: &&mut Target| (target.coordinate - coordinate).abs() <= SAME * unit;
        match targets.iter_mut().find(near) {
            Some(target) => target.groups.push(index),
            None => targets.push(within(linkage, coordinate, index, words)),
        }
    }
    targets.extend(ends(linkage));
    targets
}

/// A place of the cycle, from the side on which there is more way.
fn within(linkage: &Linkage, coordinate: f64, group: usize, words: &'static str) -> Target {
    let grid = cycle::coordinates(linkage);
    let (down, up) = (grid[0] - coordinate, grid[grid.len() - 1] - coordinate);
    let longer = if down.abs() > up.abs() { down } else { up };
    Target {
        law: &CYCLE,
        name: None,
        coordinate,
        sides: vec![longer.signum()],
        reach: longer.abs(),
        groups: vec![group],
        words,
    }
}

/// The ends of the range in which it assembles, from inside, with the group that ends it.
fn ends(linkage: &Linkage) -> Vec<Target> {
    /// So near to an end a group that ends it has lost most of its health.
    const NEAR: f64 = 1e-6;
    const ENDING: f64 = 1e-2;
    let Some(range) = linkage.range.filter(|range| !range.full) else { return Vec::new() };
    let unit = linkage.coordinate_unit();
    let mut position = linkage.position();
    let mut end = |(coordinate, side): (f64, f64)| {
        linkage.solve(coordinate + side * NEAR * unit, Order::Place, &mut position).ok()?;
        let healths = position.health.iter().map(|health| health.abs()).enumerate();
        let (group, least) = healths.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let reach = range.high - range.low;
        (least < ENDING).then(|| Target {
            law: &CYCLE,
            name: None,
            coordinate,
            sides: vec![side],
            reach,
            groups: vec![group],
            words: if side > 0.0 { "low end of the range" } else { "high end of the range" },
        })
    };
    [(range.low, 1.0), (range.high, -1.0)].into_iter().filter_map(&mut end).collect()
}
