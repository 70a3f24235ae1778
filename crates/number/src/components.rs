//! What depends on each other, in an order in which everything comes after what it depends on.

use std::{cmp::Reverse, collections::BinaryHeap};

/// Stands for no number yet.
const NONE: usize = usize::MAX;

/// The strongly connected parts of a dependence, each after those on which it depends; of several that could be next the one of
/// least rank comes first, then the one with the least item. `needs[item]` lists what an item depends on, in any order and any
/// number of times; the items of a part are in ascending order.
///
/// # Examples
///
/// ```
/// use assur_number::components;
///
/// // 1 and 2 need each other, and 1 needs 3.
/// let needs = [vec![1], vec![2, 3], vec![1], vec![]];
/// assert_eq!(components(&needs, |_| 0), [vec![3], vec![1, 2], vec![0]]);
/// ```
pub fn components<R: Ord>(needs: &[Vec<usize>], rank: impl Fn(&[usize]) -> R) -> Vec<Vec<usize>> {
    let (part_of, count) = parts(needs);
    let mut parts = vec![Vec::new(); count];
    for (item, part) in part_of.iter().enumerate() {
        parts[*part].push(item);
    }
    let mut dependents = vec![Vec::new(); count];
    let mut open = vec![0; count];
    for (part, items) in parts.iter().enumerate() {
        let others = items.iter().flat_map(|item| &needs[*item]).map(|other| part_of[*other]);
        let mut others: Vec<usize> = others.filter(|other| *other != part).collect();
        others.sort_unstable();
        others.dedup();
        open[part] = others.len();
        for other in others {
            dependents[other].push(part);
        }
    }
    let entry = |part: usize| Reverse((rank(&parts[part]), parts[part][0], part));
    let mut ready: BinaryHeap<_> = (0..count).filter(|part| open[*part] == 0).map(entry).collect();
    let mut order = Vec::with_capacity(count);
    while let Some(Reverse((.., part))) = ready.pop() {
        order.push(part);
        for &next in &dependents[part] {
            open[next] -= 1;
            if open[next] == 0 {
                ready.push(entry(next));
            }
        }
    }
    order.into_iter().map(|part| std::mem::take(&mut parts[part])).collect()
}

/// The number of the part of each item, and how many parts there are (Tarjan, 1972, without recursion).
fn parts(needs: &[Vec<usize>]) -> (Vec<usize>, usize) {
    let [mut index, mut low, mut part] = [(); 3].map(|()| vec![NONE; needs.len()]);
    let (mut visited, mut count) = (0, 0);
    let mut open = Vec::new();
    for root in 0..needs.len() {
        let mut path = if index[root] == NONE { vec![(root, 0)] } else { Vec::new() };
        while let Some((item, next)) = path.last_mut() {
            let item = *item;
            if index[item] == NONE {
                (index[item], low[item]) = (visited, visited);
                visited += 1;
                open.push(item);
            }
            if let Some(&other) = needs[item].get(*next) {
                *next += 1;
                if index[other] == NONE {
                    path.push((other, 0));
                } else if part[other] == NONE {
                    low[item] = low[item].min(index[other]);
                }
                continue;
            }
            path.pop();
            if low[item] == index[item] {
                let first = open.iter().rposition(|own| *own == item).unwrap_or_default();
                open.drain(first..).for_each(|own| part[own] = count);
                count += 1;
            }
            if let Some((above, _)) = path.last() {
                low[*above] = low[*above].min(low[item]);
            }
        }
    }
    (part, count)
}

#[cfg(test)]
mod tests;
