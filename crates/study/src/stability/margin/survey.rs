//! Whether a changed mechanism assembles at every coordinate, and how near it comes to failing.

use assur_group::{Body, GroupError, Order};
use assur_kinematics::{Chain, Linkage, Ways, iterated};
use assur_mechanism::Mechanism;
use assur_number::search::try_least;
use assur_structure::Structure;

use super::length::Length;
use crate::stability::nearest::Grid;

/// Number of coordinates of the cycle that are tried; minima are sought between them.
pub(super) const STRIDE: usize = 4;

/// Steps of the search for a minimum over the coordinate: its place to 1e-10 of the spacing, and so its value to
/// rounding.
const STEPS: usize = 48;

pub(super) struct Survey<'a> {
    linkage: &'a Linkage,
    length: &'a Length,
    grid: &'a Grid,
    /// By group: whether its iteration starts from an earlier position.
    iterates: Vec<bool>,
    /// For each coordinate the bodies of the last mechanism that assembled; one entry for all if no kind iterates.
    starts: Vec<Vec<Body<f64>>>,
    squares: Vec<Vec<f64>>,
    /// The coordinate that failed last: it is tried first.
    suspect: Option<(usize, f64)>,
}

impl<'a> Survey<'a> {
    pub(super) fn of(linkage: &'a Linkage, length: &'a Length, grid: &'a Grid) -> Self {
        let links = iterated(&linkage.structure);
        let iterates: Vec<bool> = linkage
            .structure
            .groups
            .iter()
            .map(|group| group.frame.links.iter().any(|link| links.contains(link)))
            .collect();
        let mut position = linkage.position();
        let starts = if links.is_empty() {
            vec![position.bodies]
        } else {
            let mut at = |&q: &f64| {
                // The unchanged mechanism assembles everywhere; at a singular position the previous one is kept, which
                // is near.
                let _ = linkage.solve(q, Order::Place, &mut position);
                position.bodies.clone()
            };
            grid.coordinates.iter().map(&mut at).collect()
        };
        let squares = vec![vec![0.0; iterates.len()]; grid.coordinates.len()];
        Self { linkage, length, grid, iterates, starts, squares, suspect: None }
    }

    /// Least squared determinant of all groups over the cycle with the length increased by `change` (m); `None` if the
    /// mechanism does not assemble everywhere.
    pub(super) fn clearance(&mut self, change: f64) -> Option<f64> {
        let mut trial = Trial::of(self.linkage, &self.length.changed(&self.linkage.mechanism, change))?;
        let mut bodies = self.starts[0].clone();
        if let Some((start, q)) = self.suspect {
            bodies.clone_from(&self.starts[start]);
            trial.place(q, &self.iterates, &mut bodies)?;
        }
        let mut placed = Vec::with_capacity(self.starts.len());
        for (i, &q) in self.grid.coordinates.iter().enumerate() {
            let start = i.min(self.starts.len() - 1);
            bodies.clone_from(&self.starts[start]);
            if trial.place(q, &self.iterates, &mut bodies).is_none() {
                self.suspect = Some((start, q));
                return None;
            }
            self.squares[i].copy_from_slice(&trial.squares);
            if self.starts.len() > 1 {
                placed.push(bodies.clone());
            }
        }
        let least = self.between(&mut trial, &placed)?;
        if self.starts.len() > 1 {
            self.starts = placed;
        }
        Some(least)
    }

    /// The least value, with the minima between the coordinates of the grid.
    fn between(&mut self, trial: &mut Trial, placed: &[Vec<Body<f64>>]) -> Option<f64> {
        let mut least = f64::INFINITY;
        let mut bodies = self.starts[0].clone();
        for group in 0..self.iterates.len() {
            for i in 0..self.squares.len() {
                let at = self.squares[i][group];
                least = least.min(at);
                let [(low, before), (high, after)] = self.grid.around(i, |k| self.squares[k][group]);
                if !may_touch(at, [before, after]) {
                    continue;
                }
                let found = try_least(low, high, STEPS, |q| {
                    if let Some(start) = placed.get(i) {
                        bodies.clone_from(start);
                    }
                    trial.place(q, &self.iterates, &mut bodies).ok_or(q)?;
                    Ok(trial.squares[group])
                });
                match found {
                    Ok((_, value)) => least = least.min(value),
                    Err(q) => {
                        self.suspect = Some((i.min(self.starts.len() - 1), q));
                        return None;
                    }
                }
            }
        }
        Some(least)
    }
}

/// Whether there may be a minimum of zero next to a value that is not above its neighbors: the parabola through the
/// three falls below it by at most an eighth of their difference.
pub(super) fn may_touch(value: f64, neighbors: [f64; 2]) -> bool {
    let [a, b] = neighbors;
    value <= a && value <= b && value <= a.max(b) - value
}

/// In a mechanism with change points a gap below this part of its size is ignored: after a group whose assembly modes
/// meet, positions are known only to the root of their rounding.
const BLURRED: f64 = 1e-12;

pub(super) struct Trial {
    chain: Chain<f64>,
    ways: Ways,
    /// Gaps up to this are ignored, m.
    closed: f64,
    /// By group: the squared determinant at the last position that was tried; infinite if the group was not reached.
    pub(super) squares: Vec<f64>,
}

impl Trial {
    /// Decomposes the changed mechanism without the passive parts; `None` if its lengths make no groups.
    pub(super) fn of(linkage: &Linkage, mechanism: &Mechanism) -> Option<Self> {
        let passive: Vec<_> = linkage.structure.passive.iter().map(|passive| passive.part).collect();
        let structure = Structure::without(mechanism, &passive).ok()?;
        let chain = Chain::<f64>::compile(mechanism, &structure).ok()?;
        let (ways, closed) = if linkage.change_points().next().is_none() {
            (linkage.ways.clone(), 0.0)
        } else {
            let moved = moved(linkage, &structure);
            let ways = linkage.ways.without(mechanism.input.from, |group| moved[group]);
            (ways, BLURRED * structure.scale)
        };
        let squares = vec![0.0; chain.groups.len()];
        Some(Self { chain, ways, closed, squares })
    }

    /// Solves all groups at a coordinate; `None` if one of them does not assemble. `bodies` hold the starting values
    /// for kinds that iterate; `iterates` says by group which do.
    pub(super) fn place(&mut self, q: f64, iterates: &[bool], bodies: &mut [Body<f64>]) -> Option<()> {
        self.squares.fill(f64::INFINITY);
        let solved = self.chain.solve(q, self.ways.at(q), Order::Place, bodies, &mut self.squares);
        let reached = solved.as_ref().err().map_or(self.squares.len(), |error| error.group);
        for square in &mut self.squares[..reached] {
            *square *= *square;
        }
        let Err(error) = solved else { return Some(()) };
        match error.source {
            // An iteration that ends without a place has found nothing, and knows no gap.
            _ if iterates[error.group] => return None,
            // With equal coincident links the direction is undetermined.
            GroupError::Singular { .. } => {}
            GroupError::NoAssembly { gap_m } if gap_m <= self.closed => {}
            _ => return None,
        }
        self.squares[error.group] = 0.0;
        Some(())
    }
}

/// By group: whether the change of a length affects it, in its own pairs or through the groups before.
fn moved(linkage: &Linkage, changed: &Structure) -> Vec<bool> {
    let before = &linkage.structure;
    let mut links = vec![false; before.links];
    for ((driver, old), new) in linkage.mechanism.input.drivers.iter().zip(&before.pairs).zip(&changed.pairs)
    {
        if !driver.is_relative() {
            links[driver.link] = old.pair.geometry != new.pair.geometry;
        }
    }
    let mut moved = Vec::with_capacity(before.groups.len());
    for (old, new) in before.groups.iter().zip(&changed.groups) {
        let reached = old.frame.outer.iter().any(|pair| links[pair.a] || links[pair.b]);
        let felt = reached || !old.frame.pairs().eq(new.frame.pairs());
        for &link in old.frame.links.iter().filter(|_| felt) {
            links[link] = true;
        }
        moved.push(felt);
    }
    moved
}
