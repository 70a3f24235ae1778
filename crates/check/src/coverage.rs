//! Which of many positions, or of many states of a motion, are checked.

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
