//! Which of many positions, or of many states of a motion, are checked.

use assur_force::Reactions;
use assur_kinematics::{LanePosition, Linkage};
use assur_number::{Lanes, Real, Statistic};

/// Greatest number of members of a sample: a degree of a turn each.
pub const SAMPLE: usize = 360;

/// How many of the positions, and of the states of a motion, are checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Coverage {
    /// All, if there are at most [`SAMPLE`]; otherwise that number of them, spread evenly, with the notable ones among them.
    #[default]
    Sample,
    /// All, however many.
    All,
    /// None; no check is made.
    None,
}

/// Numbers chosen out of `0..of`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chosen {
    /// In increasing order; `None`: all of them.
    members: Option<Vec<usize>>,
    of: usize,
}

impl Coverage {
    /// Whether a sample is chosen out of the numbers below `of`: they are too many to choose all.
    pub fn is_sample(self, of: usize) -> bool {
        self == Self::Sample && of > SAMPLE
    }

    /// Chooses out of the numbers below `of`; a sample contains those that are `notable`.
    pub fn choose(self, of: usize, notable: &[usize]) -> Chosen {
        let members = match self {
            Self::None => Some(Vec::new()),
            _ => self.is_sample(of).then(|| sample(of, notable)),
        };
        Chosen { members, of }
    }
}

/// `SAMPLE` numbers below `of` at equal distances, of which each notable number replaces the nearest one.
fn sample(of: usize, notable: &[usize]) -> Vec<usize> {
    let mut members: Vec<usize> = (0..SAMPLE).map(|i| i * of / SAMPLE).collect();
    for &wanted in notable.iter().filter(|wanted| **wanted < of) {
        let others = (0..SAMPLE).filter(|&i| members[i] == wanted || !notable.contains(&members[i]));
        if let Some(nearest) = others.min_by_key(|&i| members[i].abs_diff(wanted)) {
            members[nearest] = wanted;
        }
    }
    members.sort_unstable();
    members
}

impl Chosen {
    /// All numbers below `of`.
    pub fn all(of: usize) -> Self {
        Self { members: None, of }
    }

    /// The chosen numbers in increasing order.
    pub fn iter(&self) -> impl Iterator<Item = usize> {
        let rest = if self.members.is_some() { 0 } else { self.of };
        self.members.iter().flatten().copied().chain(0..rest)
    }

    /// How many are chosen.
    pub fn count(&self) -> usize {
        self.members.as_ref().map_or(self.of, Vec::len)
    }

    /// How many are chosen and out of how many, unless all are.
    pub fn share(&self) -> Option<[usize; 2]> {
        self.members.as_ref().map(|members| [members.len(), self.of])
    }
}

/// What is known of the states that were added: of the condition (the sum of 1/determinant over the groups), of PF1 and PF2 of a
/// link, of the balancing load and of a reaction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Notable([Statistic; 5]);

impl Notable {
    /// Adds the states of some lanes of eight solved positions; their numbers follow `first`. `forces`: their balancing
    /// loads and reactions, and the lanes in which they are determined.
    pub fn add(
        &mut self,
        linkage: &Linkage,
        first: usize,
        (lanes, position): ([bool; Lanes::WIDTH], &LanePosition),
        forces: Option<([bool; Lanes::WIDTH], &Reactions<Lanes>)>,
    ) {
        let by = Lanes::from_f64(1.0 / linkage.structure.scale);
        let health = position.health.iter();
        let condition = health.fold(Lanes::ZERO, |sum, health| sum + Lanes::ONE / health.abs());
        let [mut pf1, mut pf2, mut reaction] = [Lanes::ZERO; 3];
        for body in position.bodies.iter().skip(1) {
            raise(&mut pf1, (body.x1.abs() + body.y1.abs()) * by + body.w1.abs());
            raise(&mut pf2, (body.x2.abs() + body.y2.abs()) * by + body.w2.abs() + body.w1 * body.w1);
        }
        for (statistic, values) in self.0.iter_mut().zip([condition, pf1, pf2]) {
            statistic.add(lanes, first, values);
        }
        let Some((determined, reactions)) = forces else { return };
        for wrench in &reactions.pairs {
            raise(&mut reaction, wrench.fx.abs() + wrench.fy.abs() + wrench.m.abs() * by);
        }
        let lanes = std::array::from_fn(|lane| lanes[lane] && determined[lane]);
        for (statistic, values) in self.0[3..].iter_mut().zip([reactions.balancing.abs(), reaction]) {
            statistic.add(lanes, first, values);
        }
    }

    /// Adds what was found in the states after these.
    pub fn append(&mut self, next: &Self) {
        self.0.iter_mut().zip(&next.0).for_each(|(statistic, next)| statistic.append(next));
    }

    /// The numbers of the states with the greatest values, increasing; what is zero throughout has none.
    pub fn numbers(&self) -> Vec<usize> {
        let greatest = self.0.iter().filter_map(Statistic::greatest).filter(|greatest| greatest.value > 0.0);
        let mut numbers: Vec<usize> = greatest.map(|greatest| greatest.number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    }
}

/// Replaces each number by the greater one of both.
fn raise(most: &mut Lanes, values: Lanes) {
    for (most, value) in most.0.iter_mut().zip(values.0) {
        *most = if value > *most { value } else { *most };
    }
}
