//! The system of counted equations: which equation determines which unknown.

use std::collections::VecDeque;

use assur_number::components;

/// Unknowns: moving links with 3 degrees of freedom, pins with 2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Node {
    /// A link, by its index in the mechanism.
    Link(usize),
    /// A pin, by the index of its point.
    Pin(usize),
}

impl Node {
    fn freedoms(self) -> usize {
        match self {
            Self::Link(_) => 3,
            Self::Pin(_) => 2,
        }
    }
}

/// The scalar equations of one membership or slide, or of a driven pair, which involve one or two unknown nodes.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    /// Two of a membership or slide, one by which a driven pair follows its coordinate.
    pub(crate) equations: usize,
    /// Indices of the nodes involved; never more than two.
    pub(crate) nodes: Vec<usize>,
    /// The pin or slide, for messages.
    pub(crate) source: assur_mechanism::PairId,
}

impl Block {
    /// Equations between one or two unknown nodes; `None` for what is known.
    pub(crate) fn of(equations: usize, ends: [Option<usize>; 2], source: assur_mechanism::PairId) -> Self {
        Self { equations, nodes: ends.into_iter().flatten().collect(), source }
    }
}

/// Nodes and blocks, and the matching between them.
#[derive(Debug)]
pub(crate) struct Graph {
    pub(crate) nodes: Vec<Node>,
    pub(crate) blocks: Vec<Block>,
    /// For each scalar equation its block.
    block_of: Vec<usize>,
    /// For each scalar equation the node that it determines.
    matched: Vec<Option<usize>>,
    /// For each node the equations that determine it, at most as many as its degrees of freedom.
    held: Vec<Vec<usize>>,
}

/// Marks of the search for an augmenting path: for each node the last search that visited it, and the equation it
/// came from.
struct Search {
    met: Vec<usize>,
    /// Whether a search that reached the node has failed: no path from there leads to a free node, now or later.
    closed: Vec<bool>,
    from: Vec<usize>,
    queue: VecDeque<usize>,
    /// The nodes that this search has visited.
    reached: Vec<usize>,
}

impl Graph {
    /// Matches as many equations as possible to unknowns, each equation by the shortest augmenting path.
    ///
    /// Earlier equations are preferred: an equation that can't be matched remains so. Most equations find a free
    /// unknown of their own, so the paths are short and the time is nearly linear for a scene in any order. What a failed
    /// search has reached is not searched again, so that any number of surplus equations takes linear time too.
    pub(crate) fn matched(nodes: Vec<Node>, blocks: Vec<Block>) -> Self {
        let of_block = |(index, block): (usize, &Block)| std::iter::repeat_n(index, block.equations);
        let block_of: Vec<usize> = blocks.iter().enumerate().flat_map(of_block).collect();
        let (equations, count) = (block_of.len(), nodes.len());
        let held = vec![Vec::with_capacity(3); count];
        let mut graph = Self { nodes, blocks, block_of, matched: vec![None; equations], held };
        let (met, closed, from) = (vec![0; count], vec![false; count], vec![0; count]);
        let mut search = Search { met, closed, from, queue: VecDeque::new(), reached: Vec::new() };
        for equation in 0..equations {
            graph.augment(equation, &mut search);
        }
        graph
    }

    /// The block of an equation.
    fn block(&self, equation: usize) -> &Block {
        &self.blocks[self.block_of[equation]]
    }

    fn is_free(&self, node: usize) -> bool {
        self.held[node].len() < self.nodes[node].freedoms()
    }

    /// Breadth-first search from an unmatched equation to a free node; shifts the matches along the path.
    fn augment(&mut self, equation: usize, search: &mut Search) {
        let stamp = equation + 1;
        search.queue.clear();
        search.reached.clear();
        search.queue.push_back(equation);
        while let Some(next) = search.queue.pop_front() {
            for k in 0..self.block(next).nodes.len() {
                let node = self.block(next).nodes[k];
                if search.met[node] == stamp || search.closed[node] {
                    continue;
                }
                (search.met[node], search.from[node]) = (stamp, next);
                if self.is_free(node) {
                    self.shift(node, &search.from);
                    return;
                }
                search.reached.push(node);
                search.queue.extend(&self.held[node]);
            }
        }
        for node in search.reached.drain(..) {
            search.closed[node] = true;
        }
    }

    /// Assigns a free node to the equation through which it was reached, that equation's former node to the previous
    /// one, and so on.
    fn shift(&mut self, free: usize, from: &[usize]) {
        let mut node = free;
        loop {
            let equation = from[node];
            self.held[node].push(equation);
            let Some(former) = self.matched[equation].replace(node) else { return };
            self.held[former].retain(|&other| other != equation);
            node = former;
        }
    }

    /// Blocks and nodes of the first over-determined part, if there is one: an unmatched equation with all equations
    /// that it could displace.
    pub(crate) fn surplus(&self) -> Option<(Vec<usize>, Vec<usize>)> {
        let first = self.block_of[self.matched.iter().position(Option::is_none)?];
        let nodes_of = |block: usize| self.blocks[block].nodes.iter().copied();
        let mut blocks = reached(self.blocks.len(), vec![first], |block| {
            nodes_of(block).flat_map(|node| self.held[node].iter().map(|equation| self.block_of[*equation]))
        });
        blocks.sort_unstable();
        let mut nodes: Vec<usize> = blocks.iter().flat_map(|&block| nodes_of(block)).collect();
        nodes.sort_unstable();
        nodes.dedup();
        Some((blocks, nodes))
    }

    /// Number of equations that determine nothing.
    pub(crate) fn unmatched(&self) -> usize {
        self.matched.iter().filter(|matched| matched.is_none()).count()
    }

    /// Whether an unknown is left undetermined.
    pub(crate) fn is_loose(&self) -> bool {
        (0..self.nodes.len()).any(|node| self.is_free(node))
    }

    /// Nodes that the equations leave undetermined.
    pub(crate) fn loose(&self) -> Vec<usize> {
        let mut dependents = vec![Vec::new(); self.nodes.len()];
        for (node, needs) in self.needs().into_iter().enumerate() {
            for other in needs {
                dependents[other].push(node);
            }
        }
        let free = (0..self.nodes.len()).filter(|&node| self.is_free(node)).collect();
        // A node that shares an equation with a loose node, by which it is determined, is itself loose.
        let mut found = reached(self.nodes.len(), free, |node| dependents[node].iter().copied());
        found.sort_unstable();
        found
    }

    /// For each node the nodes it depends on: the other ends of the equations that determine it.
    fn needs(&self) -> Vec<Vec<usize>> {
        let others = |node: usize| {
            let ends = self.held[node].iter().flat_map(|equation| &self.block(*equation).nodes);
            let mut others: Vec<usize> = ends.copied().filter(|&other| other != node).collect();
            others.sort_unstable();
            others.dedup();
            others
        };
        (0..self.nodes.len()).map(others).collect()
    }

    /// The strongly connected parts of a perfectly matched system in solving order; if several could be next, the one
    /// with the first link.
    pub(crate) fn parts(&self) -> Vec<Vec<usize>> {
        let rank = |part: &[usize]| {
            let links = part.iter().filter_map(|&node| match self.nodes[node] {
                Node::Link(link) => Some(link),
                Node::Pin(_) => None,
            });
            // Parts that are a single pin are taken as soon as possible.
            links.min().unwrap_or(0)
        };
        components(&self.needs(), rank)
    }
}

/// The first items with everything that is reached from them over `next`; there are `count` items in all.
fn reached<I: IntoIterator<Item = usize>>(
    count: usize,
    first: Vec<usize>,
    next: impl Fn(usize) -> I,
) -> Vec<usize> {
    let mut seen = vec![false; count];
    for &item in &first {
        seen[item] = true;
    }
    let (mut found, mut at) = (first, 0);
    while at < found.len() {
        for other in next(found[at]) {
            if !std::mem::replace(&mut seen[other], true) {
                found.push(other);
            }
        }
        at += 1;
    }
    found
}
