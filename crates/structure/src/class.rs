//! Class and order of a group.

use assur_group::GroupFrame;

/// Class and order of a group according to Assur and Artobolevsky.
///
/// A group of two links has class II. Otherwise the class is the greatest number of pairs in one contour: a link with
/// k pairs is a contour of k, and so is a closed chain of k links in the group. The order is the number of outer
/// pairs.
pub fn class_and_order(frame: &GroupFrame) -> (u8, u8) {
    let order = u8::try_from(frame.outer.len()).unwrap_or(u8::MAX);
    if frame.links.len() <= 2 {
        return (2, order);
    }
    let elements = |link: usize| frame.pairs().filter(|pair| pair.joins(link)).count();
    let widest = frame.links.iter().map(|&link| elements(link)).max().unwrap_or(0);
    let class = widest.max(longest_contour(frame));
    (u8::try_from(class).unwrap_or(u8::MAX), order)
}

/// Number of links in the longest contour, where each inner pair counts with its shortest closed chain; 0 if there is
/// none.
fn longest_contour(frame: &GroupFrame) -> usize {
    let mut longest = 0;
    for (skipped, pair) in frame.inner.iter().enumerate() {
        longest = longest.max(path_without(frame, skipped, pair.a, pair.b).unwrap_or(0));
    }
    longest
}

/// Number of links on the shortest path between two links over inner pairs, without the given pair.
fn path_without(frame: &GroupFrame, skipped: usize, from: usize, to: usize) -> Option<usize> {
    let mut distance = vec![(from, 1)];
    let mut next = 0;
    while next < distance.len() {
        let (link, steps) = distance[next];
        if link == to {
            return Some(steps);
        }
        for (i, pair) in frame.inner.iter().enumerate() {
            if i != skipped && pair.joins(link) && !distance.iter().any(|(seen, _)| *seen == pair.other(link))
            {
                distance.push((pair.other(link), steps + 1));
            }
        }
        next += 1;
    }
    None
}
