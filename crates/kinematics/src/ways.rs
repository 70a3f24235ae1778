//! The assembly mode of each group as a function of the coordinate.

/// Tolerance for rounding at an end of a range, in units of the coordinate.
pub(crate) const END_ROUNDING: f64 = 1e-9;

/// The range around the first position in which a mechanism can be assembled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AssemblyRange {
    /// Least coordinate, rad or m.
    pub low: f64,
    /// Greatest coordinate, rad or m.
    pub high: f64,
    /// Whether it turns fully; `low` and `high` are then an arbitrary interval of one turn.
    pub full: bool,
}

/// A coordinate shifted by whole periods into the one that begins at `low`; one that equals `low` except for rounding stays
/// there.
pub(crate) fn shifted(coordinate: f64, low: f64, period: f64) -> f64 {
    let passed = (coordinate - low).rem_euclid(period);
    low + if passed > period - END_ROUNDING { passed - period } else { passed }
}

/// A coordinate at which a group passes from one of its modes to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// The coordinate, rad or m.
    pub coordinate: f64,
    /// Index of the group.
    pub group: usize,
    /// Its modes at smaller and at greater coordinates.
    pub ways: [u8; 2],
    /// Whether two modes meet there; otherwise the motion is smooth and only the kind's numbering of its modes changes.
    pub is_change_point: bool,
}

/// The mode of each group at every coordinate.
#[derive(Debug, Clone, PartialEq)]
pub struct Ways {
    /// Start of the interval that was followed.
    low: f64,
    /// The length after which the modes repeat: that of the interval if the motion is periodic, a turn if it is an angle
    /// and less than a turn; `None` where they don't.
    pub(crate) period: Option<f64>,
    /// In increasing order from `low`.
    transitions: Vec<Transition>,
    /// The modes of all groups before, between and after the transitions: one row more than transitions.
    rows: Vec<Vec<u8>>,
}

impl Ways {
    /// From the modes at the lower end and the transitions in increasing order.
    pub(crate) fn new(low: f64, period: Option<f64>, first: Vec<u8>, transitions: Vec<Transition>) -> Self {
        let mut rows = Vec::with_capacity(transitions.len() + 1);
        let mut row = first;
        for transition in &transitions {
            rows.push(row.clone());
            row[transition.group] = transition.ways[1];
        }
        rows.push(row);
        Self { low, period, transitions, rows }
    }

    /// The mode of each group at a coordinate; at a transition, the mode above it.
    #[inline]
    pub fn at(&self, coordinate: f64) -> &[u8] {
        if self.transitions.is_empty() {
            return &self.rows[0];
        }
        let found = match self.period {
            Some(period) => shifted(coordinate, self.low, period),
            None => coordinate,
        };
        &self.rows[self.transitions.partition_point(|transition| transition.coordinate <= found)]
    }

    /// Whether no group ever changes its mode.
    #[inline]
    pub(crate) fn are_constant(&self) -> bool {
        self.transitions.is_empty()
    }

    /// The transitions at which two modes meet.
    pub(crate) fn change_points(&self) -> impl Iterator<Item = &Transition> {
        self.transitions.iter().filter(|transition| transition.is_change_point)
    }

    /// Displacement from one coordinate to another, reduced by whole periods, rad or m.
    pub(crate) fn offset(&self, from: f64, to: f64) -> f64 {
        let apart = to - from;
        self.period.map_or(apart, |period| apart - period * (apart / period).round())
    }

    /// The modes of a mechanism with the same assembly at the coordinate `from`, in which the modes of some groups
    /// don't meet.
    #[must_use]
    pub fn without(&self, from: f64, gone: impl Fn(usize) -> bool) -> Self {
        let kept: Vec<_> = self.transitions.iter().copied().filter(|one| !gone(one.group)).collect();
        let mut row = self.at(from).to_vec();
        for transition in kept.iter().rev().filter(|transition| transition.coordinate <= from) {
            row[transition.group] = transition.ways[0];
        }
        Self::new(self.low, self.period, row, kept)
    }
}
