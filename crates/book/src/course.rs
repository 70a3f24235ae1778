//! A quantity over its own coordinates.

use assur_analysis::results::{Column, Edges, Statistic, Table, Turn};

/// A value this small compared with the greatest one of its course counts as zero.
const ROUNDING: f64 = 1e-14;
/// A zero crossing within this part of the greatest value is rounding around an identical zero.
const ZERO: f64 = 1e-9;
/// Places that differ by less than this part of them are one.
const ROUNDING_OF_PLACES: f64 = 1e-12;
/// A course closes where its end differs from its beginning by at most this part of its greatest value.
const CLOSED: f64 = 1e-9;

/// A value, and where it was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Number of the position or sample.
    pub number: usize,
    /// Coordinate (rad or m) or time (s) of the value.
    pub at: f64,
    /// The value, SI.
    pub value: f64,
}

/// A quantity over its own coordinates: there are no values without them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Course {
    /// In the order of their numbers; a position without a value has no node.
    nodes: Vec<Node>,
    /// The end of the cycle, which is no position of its own.
    end: Option<Node>,
    /// Coordinate and value of what is drawn, in their order: the nodes, what lies between them, and the end; NaN where the line is
    /// interrupted.
    line: Vec<[f64; 2]>,
}

/// Both sides of a place at which a value jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// Coordinate, rad or m.
    pub at: f64,
    /// The values just before and just after it, SI.
    pub values: [f64; 2],
}

impl Course {
    /// The numbers of a column in the rows of a table, over those of another column in the same rows, and those between and
    /// after them.
    pub fn of(table: &Table, edges: Option<&Edges>, over: Column, column: Column) -> Self {
        Self::read(table, edges, over, |table, row| table.get(row, column))
    }

    /// A course built by mapping each row of a table to a value, over the coordinate in column `over`, with the rows between the
    /// positions and at the end of the cycle.
    pub fn read(
        table: &Table,
        edges: Option<&Edges>,
        over: Column,
        value: impl Fn(&Table, usize) -> Option<f64>,
    ) -> Self {
        let node = |table: &Table, row: usize| {
            let value = value(table, row).unwrap_or(f64::NAN);
            Some(Node { number: table.numbers()[row], at: table.get(row, over)?, value })
        };
        let nodes: Vec<Node> = (0..table.len()).filter_map(|row| node(table, row)).collect();
        let Some(edges) = edges else { return Self::of_nodes(nodes, None, Vec::new()) };
        let end = if edges.ending.is_empty() { None } else { node(&edges.ending, 0) };
        let mut rows = (0..edges.between.len()).peekable();
        let between = edges.places.iter().enumerate().map(|(number, at)| {
            let row = rows.next_if(|row| edges.between.numbers()[*row] == number);
            [*at, row.and_then(|row| value(&edges.between, row)).unwrap_or(f64::NAN)]
        });
        Self::of_nodes(nodes, end, between.collect())
    }

    /// A node of NaN has no value and interrupts the line.
    fn of_nodes(mut nodes: Vec<Node>, end: Option<Node>, between: Vec<[f64; 2]>) -> Self {
        let line = line(&nodes, end, between);
        nodes.retain(|node| !node.value.is_nan());
        Self { nodes, end: end.filter(|end| !end.value.is_nan()), line }
    }

    /// The same with what lies between the nodes: coordinates in the order of the nodes with their values, NaN where there is none;
    /// a coordinate that is there twice is a jump.
    #[must_use]
    pub fn with_between(self, between: Vec<[f64; 2]>) -> Self {
        Self::of_nodes(self.nodes, self.end, between)
    }

    /// Both sides of the places at which the value jumps.
    pub fn jumps(&self) -> impl Iterator<Item = Jump> {
        let (pairs, least) = (self.line.windows(2), ZERO * self.size());
        let jumps = pairs.filter(move |two| {
            two[0][0].to_bits() == two[1][0].to_bits() && (two[0][1] - two[1][1]).abs() > least
        });
        jumps.map(|two| Jump { at: two[0][0], values: [two[0][1], two[1][1]] })
    }

    /// The borders of gaps: the last coordinate that has a value and the first beside it that has none.
    pub fn ends(&self) -> Vec<[f64; 2]> {
        let end = |two: &[[f64; 2]]| match [two[0][1], two[1][1]].map(f64::is_nan) {
            [false, true] => Some([two[0][0], two[1][0]]),
            [true, false] => Some([two[1][0], two[0][0]]),
            _ => None,
        };
        let is_apart = |ends: &[f64; 2]| ends[0].to_bits() != ends[1].to_bits() && !ends[1].is_nan();
        self.line.windows(2).filter_map(end).filter(is_apart).collect()
    }

    /// Values with their places, in the order of their numbers, and the end of the cycle.
    pub fn from_nodes(nodes: impl IntoIterator<Item = Node>, end: Option<Node>) -> Self {
        Self::of_nodes(nodes.into_iter().collect(), end, Vec::new())
    }

    /// Values with their places, numbered from 0.
    pub fn from_points(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let node = |(number, [at, value]): (usize, [f64; 2])| Node { number, at, value };
        Self::from_nodes(points.into_iter().enumerate().map(node), None)
    }

    /// The values at the positions or samples that have one.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Whether no position has a value.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The value at a position or sample.
    pub fn get(&self, number: usize) -> Option<f64> {
        let at = self.nodes.binary_search_by_key(&number, |node| node.number).ok()?;
        Some(self.nodes[at].value)
    }

    /// Whether the end of the cycle is its beginning again; `None` where the course has no end of a cycle.
    pub fn closes(&self) -> Option<bool> {
        let (first, end) = (self.nodes.first()?, self.end?);
        Some((end.value - first.value).abs() <= CLOSED * self.size())
    }

    /// Coordinate and value of what is drawn, each multiplied by its factor: of the nodes, of what lies between them, and of the
    /// end of the cycle; NaN where the line is interrupted.
    pub fn points(&self, factors: [f64; 2]) -> Vec<[f64; 2]> {
        let point = |at: &[f64; 2]| {
            if at[1].is_nan() { [f64::NAN; 2] } else { [factors[0] * at[0], factors[1] * at[1]] }
        };
        self.line.iter().map(point).collect()
    }

    /// What is drawn of two projections of one vector, this one to the right and the other one up: the path of its tip.
    #[must_use]
    pub fn against(&self, up: &Self) -> Vec<[f64; 2]> {
        let tip = |(x, y): ([f64; 2], [f64; 2])| [x[1], y[1]];
        self.points([1.0; 2]).into_iter().zip(up.points([1.0; 2])).map(tip).collect()
    }

    /// The greatest magnitude of a value at a position or at the end; 0 where there is none.
    pub fn size(&self) -> f64 {
        self.nodes.iter().chain(&self.end).fold(0.0, |most: f64, node| most.max(node.value.abs()))
    }

    /// Below this a value is rounding, compared with the others.
    pub fn rounding(&self) -> f64 {
        ROUNDING * self.size()
    }

    /// Neighbors on the line.
    fn pairs(&self) -> impl Iterator<Item = [[f64; 2]; 2]> {
        self.line.windows(2).map(|two| [two[0], two[1]]).filter(|two| two.iter().all(|at| !at[1].is_nan()))
    }

    /// Where the course passes zero; between two places of the line, linear.
    pub fn zeros(&self) -> Vec<f64> {
        let least = ZERO * self.size();
        let mut found = Vec::new();
        for [a, b] in self.pairs() {
            if a[1].abs().max(b[1].abs()) <= least {
                continue;
            }
            if a[1].abs() <= least {
                found.push(a[0]);
            } else if b[1].abs() > least && a[1] * b[1] < 0.0 {
                found.push(a[0] + (b[0] - a[0]) * (a[1] / (a[1] - b[1])));
            }
        }
        found
    }

    /// The value at a coordinate or time; between two places of the line, linear.
    pub fn between(&self, at: f64) -> Option<f64> {
        let met = self.line.iter().find(|met| met[0].to_bits() == at.to_bits() && !met[1].is_nan());
        met.map(|met| met[1]).or_else(|| {
            let within = |[a, b]: &[[f64; 2]; 2]| (a[0]..=b[0]).contains(&at) || (b[0]..=a[0]).contains(&at);
            let [a, b] = self.pairs().find(within)?;
            let part = (at - a[0]) / (b[0] - a[0]);
            Some(if part > 0.0 { a[1] + part * (b[1] - a[1]) } else { a[1] })
        })
    }

    /// The local extremes of the line, each between the places beside it.
    pub fn turns(&self) -> Vec<Turn> {
        let (line, wraps) = (&self.line, self.closes() == Some(true));
        let same = ZERO * self.line.iter().fold(0.0, |most: f64, at| most.max(at[1].abs()));
        let known = |at: &&[f64; 2]| !at[1].is_nan();
        let last = line.len().saturating_sub(1);
        let mut turns = Vec::new();
        for (index, here) in line.iter().enumerate().filter(|(_, at)| !at[1].is_nan()) {
            let beside = |at: Option<&[f64; 2]>| {
                at.filter(known).filter(|at| at[0].to_bits() != here[0].to_bits()).copied()
            };
            let before = beside(index.checked_sub(1).map(|before| &line[before]));
            let after = beside(line.get(index + 1));
            // The first place of a closed course is its last one again.
            let [before_it, after_it] = if wraps && index == 0 {
                [beside(line.get(last.saturating_sub(1))), after]
            } else if wraps && index == last {
                [before, beside(line.get(1))]
            } else {
                [before, after]
            };
            for (is_greatest, sign) in [(true, 1.0), (false, -1.0)] {
                let over = |at: Option<[f64; 2]>| at.map(|at| sign * (here[1] - at[1]));
                let (behind, ahead) = (over(before_it), over(after_it));
                let turns_here = behind.is_none_or(|by| by > same) && ahead.is_none_or(|by| by >= -same);
                // The first and the last place of a closed course are one: its extreme counts once, at the side of the nearer neighbor.
                let elsewhere = wraps && (index == 0 && behind < ahead || index == last && ahead <= behind);
                if turns_here && !elsewhere && (before_it.is_some() || after_it.is_some()) {
                    let within = [before.unwrap_or(*here)[0], after.unwrap_or(*here)[0]];
                    turns.push(Turn { at: here[0], value: here[1], is_greatest, within });
                }
            }
        }
        if turns.iter().all(|turn| (turn.value - turns[0].value).abs() <= same) { Vec::new() } else { turns }
    }

    /// The highest and the lowest point of the line, coordinate and value, the first of equal ones; `None` where nothing is drawn.
    pub fn highest_and_lowest(&self) -> Option<[[f64; 2]; 2]> {
        let known = self.line.iter().enumerate().filter(|(_, at)| !at[1].is_nan());
        let found: Statistic = known.map(|(place, at)| (place, at[1])).collect();
        Some([found.greatest()?, found.least()?].map(|extreme| self.line[extreme.number]))
    }
}

/// Nodes, what lies between them, and the end, in their order; NaN where a node is missing between two others.
fn line(nodes: &[Node], end: Option<Node>, between: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let sense = nodes.first().zip(end.or(nodes.last().copied()));
    let sense = sense.map_or(1.0, |(first, last)| (last.at - first.at).signum());
    let mut line = Vec::with_capacity(nodes.len() + between.len() + 1);
    let (mut between, mut before) = (between.into_iter().peekable(), None);
    for node in nodes.iter().copied().chain(end) {
        let (near, count) = (ROUNDING_OF_PLACES * node.at.abs(), line.len());
        while let Some(at) = between.next_if(|at| sense * (node.at - at[0]) >= -near) {
            line.push(at);
        }
        if line.len() == count && before.is_some_and(|before| node.number > before + 1) {
            line.push([f64::NAN; 2]);
        }
        line.push([node.at, node.value]);
        before = Some(node.number);
    }
    line.extend(between);
    line
}
