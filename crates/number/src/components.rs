//! What depends on each other, in an order in which everything comes after what it depends on.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

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
mod tests {
    use super::components;

    #[test]
    fn parts_are_those_of_reachability_and_in_order() {
        // Dependences of 12 items by a generator of random numbers, sparse to dense.
        let mut seed = 7_u64;
        let mut random = move |most: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(seed >> 33).unwrap() % most
        };
        for trial in 0..300 {
            let mut needs = vec![Vec::new(); 12];
            (0..trial % 40).for_each(|_| needs[random(12)].push(random(12)));
            let mut reaches: Vec<Vec<bool>> =
                needs.iter().map(|of| (0..12).map(|other| of.contains(&other)).collect()).collect();
            for through in 0..12 {
                for from in 0..12 {
                    for to in 0..12 {
                        reaches[from][to] |= reaches[from][through] && reaches[through][to];
                    }
                }
            }
            // The greatest item first, as far as what it needs allows.
            let found = components(&needs, |part| std::cmp::Reverse(part[part.len() - 1]));
            let mut left: Vec<usize> = (0..12).rev().collect();
            for part in found {
                let ready =
                    |item: usize| left.iter().all(|o| !reaches[item][*o] || reaches[*o][item] || *o == item);
                let first = left.iter().copied().find(|item| ready(*item)).unwrap();
                let own = |item: &usize| *item == first || reaches[first][*item] && reaches[*item][first];
                let mut wanted: Vec<usize> = left.iter().copied().filter(own).collect();
                wanted.reverse();
                assert_eq!(part, wanted);
                left.retain(|item| !own(item));
            }
            assert!(left.is_empty());
        }
    }

    #[test]
    fn a_long_chain_takes_no_recursion() {
        let count = 200_000;
        let needs: Vec<Vec<usize>> = (0..count).map(|item| vec![(item + 1) % count]).collect();
        assert_eq!(components(&needs, |_| 0).len(), 1);
    }
}
