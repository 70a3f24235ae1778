//! A quantity over its own coordinates.

use assur_analysis::results::{Column, Edges, Quantity, Table};

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
    /// Between them: both sides of the places where the formula of a load changes, in the order of the nodes.
    steps: Vec<Step>,
}

/// Both sides of a place between two nodes, or at the second of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Coordinate, rad or m.
    pub at: f64,
    /// The values just before and just after it, SI.
    pub values: [f64; 2],
}

/// The value of greatest or least size, and the number of its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// The value with its sign.
    pub value: f64,
    /// Number of the position or sample; the first of equal ones.
    pub number: usize,
}

/// The values at the positions in a few numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// The greatest value.
    pub greatest: Extreme,
    /// The least value.
    pub least: Extreme,
    /// The value of greatest modulus.
    pub farthest: Extreme,
    /// Mean over the positions.
    pub mean: f64,
    /// Root of the mean square over the positions.
    pub rms: f64,
}

impl Course {
    /// The numbers of a column in the rows of a table, over those of another column in the same rows, and those between and
    /// after them.
    pub fn of(table: &Table, edges: Option<&Edges>, over: Column, column: Column) -> Self {
        let node = |table: &Table, row: usize| {
            let (at, value) = (table.get(row, over)?, table.get(row, column)?);
            Some(Node { number: table.numbers()[row], at, value })
        };
        let nodes = (0..table.len()).filter_map(|row| node(table, row)).collect();
        let ending = edges.map(|edges| &edges.ending).filter(|ending| !ending.is_empty());
        let end = ending.and_then(|ending| node(ending, 0));
        // What depends on the coordinate alone has no sides.
        let sides =
            edges.map(|edges| &edges.sides).filter(|_| !matches!(column.quantity, Quantity::Transfer(_)));
        let sides =
            sides.into_iter().flat_map(|sides| (0..sides.len() / 2).map(move |pair| (sides, 2 * pair)));
        let step = |(sides, row): (&Table, usize)| {
            let [before, after] = [node(sides, row)?, node(sides, row + 1)?];
            Some(Step { at: before.at, values: [before.value, after.value] })
        };
        Self { nodes, end, steps: sides.filter_map(step).collect() }
    }

    /// The same with these steps, in the order of the nodes.
    #[must_use]
    pub fn with_steps(self, steps: impl IntoIterator<Item = Step>) -> Self {
        Self { steps: steps.into_iter().collect(), ..self }
    }

    /// Both sides of the places where the formula of a load changes.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Values with their places, in the order of their numbers, and the end of the cycle.
    pub fn from_nodes(nodes: impl IntoIterator<Item = Node>, end: Option<Node>) -> Self {
        Self { nodes: nodes.into_iter().collect(), end, steps: Vec::new() }
    }

    /// Values with their places, numbered from 0.
    pub fn from_points(points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let node = |(number, [at, value]): (usize, [f64; 2])| Node { number, at, value };
        Self { nodes: points.into_iter().enumerate().map(node).collect(), end: None, steps: Vec::new() }
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

    /// All nodes with the end of the cycle; between them both sides of the steps, each with the number of the node that follows.
    fn all(&self) -> impl Iterator<Item = Node> {
        let sense = self.nodes.first().zip(self.end.or(self.nodes.last().copied()));
        let sense = sense.map_or(1.0, |(first, last)| (last.at - first.at).signum());
        let mut steps = self.steps.iter().peekable();
        self.nodes.iter().copied().chain(self.end).flat_map(move |node| {
            let near = ROUNDING_OF_PLACES * node.at.abs();
            let mut met = Vec::new();
            while let Some(step) = steps.next_if(|step| sense * (node.at - step.at) >= -near) {
                met.extend(step.values.map(|value| Node { at: step.at, value, ..node }));
            }
            met.push(node);
            met
        })
    }

    /// What is drawn: coordinate and value of each node, of both sides of each step and of the end of the cycle, each multiplied
    /// by its factor. A point of NaN interrupts the line where positions between two nodes have no value.
    pub fn points(&self, factors: [f64; 2]) -> Vec<[f64; 2]> {
        let mut points = Vec::with_capacity(self.nodes.len() + 1);
        let mut before: Option<usize> = None;
        for Node { number, at, value } in self.all() {
            if before.is_some_and(|before| number > before + 1) {
                points.push([f64::NAN; 2]);
            }
            points.push([factors[0] * at, factors[1] * value]);
            before = Some(number);
        }
        points
    }

    /// What is drawn of two projections of one vector, this one to the right and the other one up: the path of its tip.
    #[must_use]
    pub fn against(&self, up: &Self) -> Vec<[f64; 2]> {
        let tip = |(x, y): ([f64; 2], [f64; 2])| [x[1], y[1]];
        self.points([1.0; 2]).into_iter().zip(up.points([1.0; 2])).map(tip).collect()
    }

    /// The greatest modulus of a value at a position or at the end; 0 where there is none.
    pub fn size(&self) -> f64 {
        self.nodes.iter().chain(&self.end).fold(0.0, |most: f64, node| most.max(node.value.abs()))
    }

    /// Below this a value is rounding, compared with the others.
    pub fn rounding(&self) -> f64 {
        ROUNDING * self.size()
    }

    /// Pairs of neighbors: positions that follow each other, and what is between them.
    fn pairs(&self) -> impl Iterator<Item = [Node; 2]> {
        let pairs = self.all().zip(self.all().skip(1));
        pairs.filter(|(one, next)| next.number <= one.number + 1).map(|(one, next)| [one, next])
    }

    /// Where the course passes zero; between two positions, linear.
    pub fn zeros(&self) -> Vec<f64> {
        let least = ZERO * self.size();
        let mut found = Vec::new();
        for [a, b] in self.pairs() {
            if a.value.abs().max(b.value.abs()) <= least {
                continue;
            }
            if a.value.abs() <= least {
                found.push(a.at);
            } else if b.value.abs() > least && a.value * b.value < 0.0 {
                found.push(a.at + (b.at - a.at) * (a.value / (a.value - b.value)));
            }
        }
        found
    }

    /// The value at a coordinate or time; between two positions, linear.
    pub fn between(&self, at: f64) -> Option<f64> {
        let met = self.all().find(|node| node.at.to_bits() == at.to_bits()).map(|node| node.value);
        met.or_else(|| {
            let within = |[a, b]: &[Node; 2]| (a.at..=b.at).contains(&at) || (b.at..=a.at).contains(&at);
            let [a, b] = self.pairs().find(within)?;
            let part = (at - a.at) / (b.at - a.at);
            Some(if part > 0.0 { a.value + part * (b.value - a.value) } else { a.value })
        })
    }

    /// Extremes and means over the positions; `None` where no position has a value.
    pub fn summary(&self) -> Option<Summary> {
        let extreme = |better: &dyn Fn(f64, f64) -> bool| {
            let take = |best: Node, next: &Node| if better(next.value, best.value) { *next } else { best };
            let best = self.nodes.iter().skip(1).fold(*self.nodes.first()?, take);
            Some(Extreme { value: best.value, number: best.number })
        };
        let count = self.nodes.len() as f64;
        let sum = |of: fn(f64) -> f64| self.nodes.iter().map(|node| of(node.value)).sum::<f64>() / count;
        Some(Summary {
            greatest: extreme(&|next, best| next > best)?,
            least: extreme(&|next, best| next < best)?,
            farthest: extreme(&|next, best| next.abs() > best.abs())?,
            mean: sum(|value| value),
            rms: sum(|value| value * value).sqrt(),
        })
    }
}
