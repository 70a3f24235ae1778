//! How far a mechanism is from not assembling: the least change of each length that breaks it.

use std::ops::ControlFlow;

use assur_group::Order;
use assur_kinematics::{Chain, Linkage};
use assur_mechanism::{LinkId, Mechanism};
use assur_structure::Structure;
use serde::Serialize;

/// Every so many coordinates of the cycle are tried while lengths are varied.
const STRIDE: usize = 4;

/// The least change of one length that breaks the mechanism.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Margin {
    /// The length in words.
    pub length: String,
    /// Its value, m.
    pub value: f64,
    /// Least increase that breaks the mechanism, m; `None`: it may grow to twice itself.
    pub increase: Option<f64>,
    /// Least decrease, m; `None`: it may shrink to nothing.
    pub decrease: Option<f64>,
}

impl Margin {
    /// The smaller of the two changes, m.
    pub fn least(&self) -> Option<f64> {
        match (self.increase, self.decrease) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }
}

/// One length and how it is changed.
enum Length {
    /// From one joint of a link to another one, which moves.
    Joints { link: LinkId, from: usize, to: usize },
    /// Offset of a slide across its guide.
    Offset { slide: usize },
}

/// Each trial takes the mechanism apart anew: beyond so many lengths the search would take minutes.
pub(crate) const MOST_LENGTHS: usize = 60;

/// How many lengths [`margins`] searches.
pub(crate) fn count(linkage: &Linkage) -> usize {
    let count = lengths(&linkage.mechanism).len();
    if count > MOST_LENGTHS { 0 } else { count }
}

/// The margins, the smallest first; none for a mechanism of more than [`MOST_LENGTHS`] lengths. `step` is called before each
/// length, and may stop the search.
pub(crate) fn margins<B>(
    linkage: &Linkage,
    critical: &[f64],
    step: &mut impl FnMut() -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Margin>> {
    let mut grid: Vec<f64> = super::cycle::coordinates(linkage).into_iter().step_by(STRIDE).collect();
    grid.extend(critical);
    let lengths = lengths(&linkage.mechanism);
    if lengths.len() > MOST_LENGTHS {
        return ControlFlow::Continue(Vec::new());
    }
    let mut found = Vec::with_capacity(lengths.len());
    for length in &lengths {
        step()?;
        found.push(margin(linkage, length, &grid));
    }
    let key = |margin: &Margin| margin.least().unwrap_or(f64::INFINITY);
    found.sort_by(|a, b| key(a).total_cmp(&key(b)));
    ControlFlow::Continue(found)
}

fn lengths(mechanism: &Mechanism) -> Vec<Length> {
    let mut lengths = Vec::new();
    let pins: Vec<usize> = (0..mechanism.points.len()).filter(|&p| mechanism.points[p].is_pin()).collect();
    for link in 0..mechanism.links.len() {
        let joints: Vec<_> =
            pins.iter().copied().filter(|&p| mechanism.place_in(p, link).is_some()).collect();
        for (i, &from) in joints.iter().enumerate() {
            for &to in &joints[i + 1..] {
                if distance(mechanism, link, from, to) > 0.0 {
                    lengths.push(Length::Joints { link, from, to });
                }
            }
        }
    }
    lengths.extend((0..mechanism.slides.len()).map(|slide| Length::Offset { slide }));
    lengths
}

fn ends(mechanism: &Mechanism, link: LinkId, from: usize, to: usize) -> [[f64; 2]; 2] {
    [from, to].map(|point| mechanism.place_in(point, link).unwrap_or_default())
}

fn distance(mechanism: &Mechanism, link: LinkId, from: usize, to: usize) -> f64 {
    let [a, b] = ends(mechanism, link, from, to);
    (b[0] - a[0]).hypot(b[1] - a[1])
}

fn margin(linkage: &Linkage, length: &Length, grid: &[f64]) -> Margin {
    let mechanism = &linkage.mechanism;
    let (words, value, most) = match *length {
        Length::Joints { link, from, to } => {
            let value = distance(mechanism, link, from, to);
            let name = |point: usize| &mechanism.points[point].name;
            (format!("{}: {} to {}", mechanism.links[link].name, name(from), name(to)), value, value)
        }
        Length::Offset { slide } => {
            let found = &mechanism.slides[slide];
            let (s, c) = found.angle.sin_cos();
            let value = c * found.through[1] - s * found.through[0];
            let most = linkage.structure.scale.max(value.abs());
            (format!("{}: offset of the guide", found.name), value, most)
        }
    };
    let breaks = |change: f64| !assembles(linkage, &changed(mechanism, length, change), grid);
    let decrease = if matches!(length, Length::Joints { .. }) { 0.999 * most } else { most };
    Margin {
        length: words,
        value,
        increase: least(most, breaks),
        decrease: least(decrease, |change| breaks(-change)),
    }
}

/// The smallest change up to `most` that breaks: ever larger ones until one does, then bisection.
fn least(most: f64, breaks: impl Fn(f64) -> bool) -> Option<f64> {
    let mut good = 0.0;
    let mut bad = most * 1e-12;
    while !breaks(bad) {
        good = bad;
        if bad >= most {
            return None;
        }
        bad = (bad * 2.0).min(most);
    }
    for _ in 0..30 {
        let middle = 0.5 * (good + bad);
        if breaks(middle) { bad = middle } else { good = middle }
    }
    Some(bad)
}

fn changed(mechanism: &Mechanism, length: &Length, change: f64) -> Mechanism {
    let mut mechanism = mechanism.clone();
    match *length {
        Length::Joints { link, from, to } => {
            let [a, b] = ends(&mechanism, link, from, to);
            let part = change / distance(&mechanism, link, from, to);
            let places = mechanism.points[to].places.iter_mut().filter(|place| place.link == link);
            for place in places {
                place.at = [b[0] + part * (b[0] - a[0]), b[1] + part * (b[1] - a[1])];
            }
        }
        Length::Offset { slide } => {
            let found = &mut mechanism.slides[slide];
            let (s, c) = found.angle.sin_cos();
            found.through = [found.through[0] - s * change, found.through[1] + c * change];
        }
    }
    mechanism
}

/// Whether it assembles at every coordinate of the grid, in the ways of the mechanism as it is.
fn assembles(linkage: &Linkage, mechanism: &Mechanism, grid: &[f64]) -> bool {
    let Ok(structure) = Structure::of(mechanism) else { return false };
    let Ok(chain) = Chain::<f64>::compile(mechanism, &structure) else { return false };
    let (mut bodies, mut health) = (chain.bodies(), vec![0.0; chain.groups.len()]);
    grid.iter().all(|&q| {
        let ways = linkage.ways.at(q);
        !matches!(
            chain.solve(q, ways, Order::Place, &mut bodies, &mut health),
            Err(error) if !matches!(error.source, assur_group::GroupError::Singular { .. })
        )
    })
}
