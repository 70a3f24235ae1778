//! Dependence between groups: which groups determine the motion of another.

use assur_structure::Structure;

/// For each group, the groups whose links its outer pairs join.
#[derive(Debug, Clone)]
pub(crate) struct Dependence {
    parents: Vec<Vec<usize>>,
}

impl Dependence {
    pub(crate) fn of(structure: &Structure) -> Self {
        let mut owner = vec![None; structure.links];
        for (index, group) in structure.groups.iter().enumerate() {
            group.frame.links.iter().for_each(|&link| owner[link] = Some(index));
        }
        let parents = structure.groups.iter().enumerate().map(|(index, group)| {
            let owners = group.frame.carriers().filter_map(|body| *owner.get(body)?);
            let mut found: Vec<_> = owners.filter(|&owner| owner != index).collect();
            found.sort_unstable();
            found.dedup();
            found
        });
        Self { parents: parents.collect() }
    }

    /// The groups that determine the motion of a group, in solving order, without the group itself. Groups for which
    /// `known` holds are left out, and with them the groups that only they depend on.
    pub(crate) fn ancestors(&self, group: usize, known: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut found = Vec::new();
        let mut is_found = vec![false; group];
        let mut open = vec![group];
        while let Some(next) = open.pop() {
            for &parent in &self.parents[next] {
                if !is_found[parent] && !known(parent) {
                    is_found[parent] = true;
                    found.push(parent);
                    open.push(parent);
                }
            }
        }
        found.sort_unstable();
        found
    }
}
