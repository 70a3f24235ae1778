//! The counted system: which equation determines which unknown.

/// Unknowns: moving links with 3 freedoms, pins with 2.
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

/// Two scalar equations of one membership or slide, on one or two unknown nodes.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    /// Indices of the nodes that it binds; never more than two.
    pub(crate) nodes: Vec<usize>,
    /// Index of the pin's point or of the slide, for messages.
    pub(crate) source: assur_mechanism::PairId,
}

/// Nodes and blocks, and the matching between them.
#[derive(Debug)]
pub(crate) struct Graph {
    pub(crate) nodes: Vec<Node>,
    pub(crate) blocks: Vec<Block>,
    /// For each scalar equation (two a block) the node that it determines.
    matched: Vec<Option<usize>>,
}

impl Graph {
    /// Matches as many equations as possible to unknowns (augmenting paths).
    pub(crate) fn matched(nodes: Vec<Node>, blocks: Vec<Block>) -> Self {
        let equations = 2 * blocks.len();
        let mut graph = Self { nodes, blocks, matched: vec![None; equations] };
        for equation in 0..equations {
            let mut visited = vec![false; graph.nodes.len()];
            graph.augment(equation, &mut visited);
        }
        graph
    }

    fn load(&self, node: usize) -> usize {
        self.matched.iter().filter(|&&found| found == Some(node)).count()
    }

    fn augment(&mut self, equation: usize, visited: &mut [bool]) -> bool {
        let candidates = self.blocks[equation / 2].nodes.clone();
        for node in candidates {
            if visited[node] {
                continue;
            }
            visited[node] = true;
            if self.load(node) < self.nodes[node].freedoms() {
                self.matched[equation] = Some(node);
                return true;
            }
            let holders: Vec<_> =
                (0..self.matched.len()).filter(|&e| self.matched[e] == Some(node)).collect();
            for holder in holders {
                if self.augment(holder, visited) {
                    self.matched[equation] = Some(node);
                    return true;
                }
            }
        }
        false
    }

    /// Blocks and nodes of the first over-determined part, if there is one: an unmatched equation and all that it
    /// could displace.
    pub(crate) fn surplus(&self) -> Option<(Vec<usize>, Vec<usize>)> {
        let first = self.matched.iter().position(Option::is_none)?;
        let (mut blocks, mut nodes) = (vec![first / 2], Vec::new());
        let mut next = 0;
        while next < blocks.len() {
            for &node in &self.blocks[blocks[next]].nodes {
                if nodes.contains(&node) {
                    continue;
                }
                nodes.push(node);
                for (equation, &found) in self.matched.iter().enumerate() {
                    if found == Some(node) && !blocks.contains(&(equation / 2)) {
                        blocks.push(equation / 2);
                    }
                }
            }
            next += 1;
        }
        Some((blocks, nodes))
    }

    /// Nodes that the equations leave undetermined.
    pub(crate) fn loose(&self) -> Vec<usize> {
        let mut found: Vec<usize> =
            (0..self.nodes.len()).filter(|&node| self.load(node) < self.nodes[node].freedoms()).collect();
        let mut next = 0;
        while next < found.len() {
            // A node bound to a loose one through an equation that determines this node floats with it.
            for (equation, &matched) in self.matched.iter().enumerate() {
                let Some(node) = matched else { continue };
                let binds = self.blocks[equation / 2].nodes.contains(&found[next]);
                if binds && !found.contains(&node) {
                    found.push(node);
                }
            }
            next += 1;
        }
        found.sort_unstable();
        found
    }

    /// Nodes that each node needs: the other ends of the equations that determine it.
    fn needs(&self) -> Vec<Vec<usize>> {
        let mut needs = vec![Vec::new(); self.nodes.len()];
        for (equation, &matched) in self.matched.iter().enumerate() {
            let Some(node) = matched else { continue };
            for &other in &self.blocks[equation / 2].nodes {
                if other != node && !needs[node].contains(&other) {
                    needs[node].push(other);
                }
            }
        }
        needs
    }

    /// The strongly connected parts of a perfectly matched system in solving order; of several that could be next, the
    /// one with the first link.
    pub(crate) fn parts(&self) -> Vec<Vec<usize>> {
        let needs = self.needs();
        let mut waiting = strongly_connected(&needs);
        let rank = |part: &Vec<usize>| {
            let first = part.iter().filter_map(|&node| match self.nodes[node] {
                Node::Link(link) => Some(link),
                Node::Pin(_) => None,
            });
            // Pins alone are free: they come as soon as they can.
            first.min().unwrap_or(0)
        };
        let mut solved = vec![false; self.nodes.len()];
        let mut ordered = Vec::new();
        while !waiting.is_empty() {
            let ready = |part: &Vec<usize>| {
                part.iter().all(|&node| needs[node].iter().all(|n| solved[*n] || part.contains(n)))
            };
            let next = (0..waiting.len()).filter(|&i| ready(&waiting[i])).min_by_key(|&i| rank(&waiting[i]));
            // There always is one: the condensation of a graph has no cycle.
            let part = waiting.swap_remove(next.unwrap_or(0));
            for &node in &part {
                solved[node] = true;
            }
            ordered.push(part);
        }
        ordered
    }
}

/// Strongly connected components: mutual reachability, by two sweeps of depth-first search (Kosaraju).
fn strongly_connected(needs: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut reverse = vec![Vec::new(); needs.len()];
    for (node, list) in needs.iter().enumerate() {
        for &other in list {
            reverse[other].push(node);
        }
    }
    let mut finished = Vec::new();
    let mut seen = vec![false; needs.len()];
    for start in 0..needs.len() {
        visit(start, needs, &mut seen, &mut finished);
    }
    let mut seen = vec![false; needs.len()];
    let mut parts = Vec::new();
    for &start in finished.iter().rev() {
        let mut part = Vec::new();
        visit(start, &reverse, &mut seen, &mut part);
        if !part.is_empty() {
            part.sort_unstable();
            parts.push(part);
        }
    }
    parts
}

/// Depth-first search without recursion; appends nodes as they finish.
fn visit(start: usize, edges: &[Vec<usize>], seen: &mut [bool], finished: &mut Vec<usize>) {
    if seen[start] {
        return;
    }
    seen[start] = true;
    let mut path = vec![(start, 0)];
    while let Some((node, next)) = path.last_mut() {
        if let Some(&other) = edges[*node].get(*next) {
            *next += 1;
            if !seen[other] {
                seen[other] = true;
                path.push((other, 0));
            }
        } else {
            finished.push(*node);
            path.pop();
        }
    }
}
