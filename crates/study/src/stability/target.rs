//! The targets of the walks of a mechanism.

use assur_group::Order;
use assur_kinematics::Linkage;
use assur_words::{Text, number, text};

use super::nearest::{Grid, GroupHealth, SAMPLES};

/// Accuracy of the place of the least health, rad or parts of the scale.
const SAME: f64 = 1e-6;

/// Most targets: of more, those where the health is least.
const MOST_PLACES: usize = 24;

/// Most solutions of a group for all walks; a mechanism of very many groups has fewer targets.
const MOST_GROUPS: usize = 1200;

#[derive(Debug)]
pub(crate) struct Target {
    pub(crate) coordinate: f64,
    /// The sides of approach, 1 or -1.
    pub(crate) sides: Vec<f64>,
    /// Greatest distance at which the walk may begin, rad or m.
    pub(crate) reach: f64,
    pub(crate) groups: Vec<usize>,
    pub(crate) words: Text,
}

impl Target {
    /// The name of the place in rows: that of a group, and how many `more` have their least health there.
    pub(crate) fn place(&self, linkage: &Linkage, group: usize, more: usize) -> Text {
        let group = linkage.structure.group_name(&linkage.mechanism, group);
        match more {
            0 => text!("stability-place", group, kind = &self.words),
            more => text!("stability-places", group, more = number(more), kind = &self.words),
        }
    }
}

/// Where the health of each group is least, and where the range ends, and how many such places are left out. Groups
/// with the least health at one place, as in a row of parallelograms, share a walk.
pub(crate) fn targets(linkage: &Linkage, groups: &[GroupHealth]) -> (Vec<Target>, usize) {
    let mut worst: Vec<usize> = (0..groups.len()).collect();
    worst.sort_by(|&a, &b| groups[a].health.total_cmp(&groups[b].health));
    let mut targets: Vec<Target> = Vec::new();
    for index in worst {
        let change = linkage.interpolation(groups[index].coordinate);
        let coordinate = change.map_or(groups[index].coordinate, |across| across.center);
        let words = match change {
            Some(_) => text!("stability-change-point"),
            None => text!("stability-least-health"),
        };
        let near =
            |target: &&mut Target| (target.coordinate - coordinate).abs() <= SAME * linkage.coordinate_unit();
        match targets.iter_mut().find(near) {
            Some(target) => target.groups.push(index),
            None => targets.push(within(linkage, coordinate, index, words)),
        }
    }
    let most = (MOST_GROUPS / groups.len().max(1)).clamp(2, MOST_PLACES);
    let left_out = targets.len().saturating_sub(most);
    targets.truncate(most);
    for target in &mut targets {
        target.groups.sort_unstable();
    }
    targets.sort_by_key(|target| target.groups.first().copied());
    targets.extend(ends(linkage));
    (targets, left_out)
}

/// A place of the cycle, from the side that has more of the cycle.
fn within(linkage: &Linkage, coordinate: f64, group: usize, words: Text) -> Target {
    let grid = Grid::of(linkage, SAMPLES).coordinates;
    let (down, up) = (grid[0] - coordinate, grid[grid.len() - 1] - coordinate);
    let longer = if down.abs() > up.abs() { down } else { up };
    Target { coordinate, sides: vec![longer.signum()], reach: longer.abs(), groups: vec![group], words }
}

/// The ends of the range in which it assembles, from inside, with the group that ends it.
fn ends(linkage: &Linkage) -> Vec<Target> {
    /// Within this distance of a limit, the group that causes it has lost most of its health.
    const NEAR: f64 = 1e-6;
    const ENDING: f64 = 1e-2;
    let Some(range) = linkage.range.filter(|range| !range.full) else { return Vec::new() };
    let mut position = linkage.position();
    let mut end = |(coordinate, side, words): (f64, f64, Text)| {
        linkage
            .solve(coordinate + side * NEAR * linkage.coordinate_unit(), Order::Place, &mut position)
            .ok()?;
        let healths = position.health.iter().map(|health| health.abs()).enumerate();
        let (group, least) = healths.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let reach = range.high - range.low;
        (least < ENDING).then(|| Target { coordinate, sides: vec![side], reach, groups: vec![group], words })
    };
    let both =
        [(range.low, 1.0, text!("stability-low-end")), (range.high, -1.0, text!("stability-high-end"))];
    both.into_iter().filter_map(&mut end).collect()
}
