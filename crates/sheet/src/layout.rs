//! Where the fields of a sheet stand, and how large they are.
//!
//! Each block has sizes from the least one that is readable; all begin with the least, and the one that is smallest for what it
//! counts grows as long as all still have room, until none can. A block stands as far left, then as high, as those before it leave
//! room for; the free places are the greatest rectangles that nothing covers.

use crate::format::Area;

/// Free space between two blocks and along the frame, mm.
const GAP: f64 = 4.0;
const SAME: f64 = 1e-6;

/// What is laid out.
#[derive(Debug, Clone)]
pub(crate) struct Block {
    /// Widths and heights in which it can be drawn, mm, from the least; at least one.
    pub(crate) sizes: Vec<[f64; 2]>,
    /// How large it should be beside others.
    pub(crate) weight: f64,
}

/// How free places are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Way {
    /// In rows from the top, else in columns from the left.
    in_rows: bool,
    /// For the largest block first, after the first one, else in the order of the blocks.
    largest_first: bool,
}

/// The ways that keep the order of the blocks, and those that are tried where none of them has room.
const WAYS: [[Way; 2]; 2] = [ways(false), ways(true)];

const fn ways(largest_first: bool) -> [Way; 2] {
    [Way { in_rows: false, largest_first }, Way { in_rows: true, largest_first }]
}

/// Index of the size and the place of a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Placed {
    pub(crate) level: usize,
    pub(crate) corner: [f64; 2],
}

/// The places of all blocks of one sheet, as large as they can be; `None` where they have no room in their least sizes.
pub(crate) fn arrange(blocks: &[Block], frame: Area, title: Area) -> Option<Vec<Placed>> {
    let grown = |ways: [Way; 2]| ways.into_iter().filter_map(|way| grown(blocks, frame, title, way));
    let covered = |placed: &Vec<Placed>| -> f64 {
        blocks.iter().zip(placed).map(|(block, own)| block.sizes[own.level].iter().product::<f64>()).sum()
    };
    WAYS.into_iter().find_map(|ways| grown(ways).max_by(|one, other| covered(one).total_cmp(&covered(other))))
}

/// Whether all blocks have room on one sheet in their least sizes, in their order or not.
pub(crate) fn fits(blocks: &[Block], frame: Area, title: Area) -> bool {
    let levels = vec![0; blocks.len()];
    WAYS.into_iter().flatten().any(|way| places(blocks, &levels, frame, title, way).is_some())
}

/// How many of the first blocks have room on one sheet in their least sizes and their order.
pub(crate) fn fitting(blocks: &[Block], frame: Area, title: Area) -> usize {
    let fits = |count: &usize| {
        let levels = vec![0; *count];
        let placed = |way| places(&blocks[..*count], &levels, frame, title, way).is_some();
        WAYS[0].into_iter().any(placed)
    };
    (1..=blocks.len()).take_while(fits).last().unwrap_or(0)
}

fn grown(blocks: &[Block], frame: Area, title: Area, way: Way) -> Option<Vec<Placed>> {
    let mut levels = vec![0; blocks.len()];
    let mut best = places(blocks, &levels, frame, title, way)?;
    let mut open = vec![true; blocks.len()];
    let size = |levels: &[usize], at: usize| -> f64 {
        // What is long and flat is large, though its area is small.
        let [width, height] = blocks[at].sizes[levels[at]];
        0.5 * (width * height + width.max(height).powi(2)) / blocks[at].weight
    };
    let mut has_grown = false;
    loop {
        for (at, open) in open.iter_mut().enumerate() {
            *open &= levels[at] + 1 < blocks[at].sizes.len();
        }
        let candidates = (0..blocks.len()).filter(|at| open[*at]);
        let least = candidates.min_by(|one, other| size(&levels, *one).total_cmp(&size(&levels, *other)));
        let Some(at) = least else {
            // What had no room may have some where others came to stand elsewhere.
            if !std::mem::take(&mut has_grown) {
                return Some(best);
            }
            open.fill(true);
            continue;
        };
        levels[at] += 1;
        if let Some(placed) = places(blocks, &levels, frame, title, way) {
            (best, has_grown) = (placed, true);
        } else {
            levels[at] -= 1;
            open[at] = false;
        }
    }
}

/// The places of blocks of these sizes, one after another; `None` where one has no room.
fn places(blocks: &[Block], levels: &[usize], frame: Area, title: Area, way: Way) -> Option<Vec<Placed>> {
    let inner = [frame[0] + GAP, frame[1] + GAP, frame[2], frame[3]];
    let mut free = cut(vec![inner], [title[0] - GAP, title[1] - GAP, title[2], title[3]]);
    let mut placed = vec![Placed { level: 0, corner: [0.0; 2] }; blocks.len()];
    let mut order: Vec<usize> = (0..blocks.len()).collect();
    if way.largest_first {
        let area = |at: usize| -> f64 { blocks[at].sizes[levels[at]].iter().product() };
        order[1..].sort_by(|one, other| area(*other).total_cmp(&area(*one)));
    }
    for at in order {
        let level = levels[at];
        let [width, height] = blocks[at].sizes[level].map(|side| side + GAP);
        let fits = |area: &&Area| area[2] - area[0] + SAME >= width && area[3] - area[1] + SAME >= height;
        let key = |area: &Area| if way.in_rows { [area[1], area[0]] } else { [area[0], area[1]] };
        let first = free.iter().filter(fits).min_by(|one, other| {
            let [one, other] = [key(one), key(other)];
            one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1]))
        });
        let corner = first.map(|area| [area[0], area[1]])?;
        placed[at] = Placed { level, corner };
        free = cut(free, [corner[0], corner[1], corner[0] + width, corner[1] + height]);
    }
    Some(placed)
}

/// The greatest free rectangles without what a rectangle covers.
fn cut(free: Vec<Area>, by: Area) -> Vec<Area> {
    let mut parts: Vec<Area> = Vec::new();
    for area in free {
        let is_apart = by[0] >= area[2] - SAME
            || by[2] <= area[0] + SAME
            || by[1] >= area[3] - SAME
            || by[3] <= area[1] + SAME;
        if is_apart {
            parts.push(area);
            continue;
        }
        let [left, top, right, bottom] = area;
        let sides = [
            [left, top, by[0], bottom],
            [by[2], top, right, bottom],
            [left, top, right, by[1]],
            [left, by[3], right, bottom],
        ];
        parts.extend(sides.into_iter().filter(|part| part[2] - part[0] > SAME && part[3] - part[1] > SAME));
    }
    let holds = |one: &Area, other: &Area| {
        one[0] <= other[0] && one[1] <= other[1] && one[2] >= other[2] && one[3] >= other[3]
    };
    let is_greatest = |at: usize| {
        !(0..parts.len()).any(|other| {
            other != at
                && holds(&parts[other], &parts[at])
                && (!holds(&parts[at], &parts[other]) || other < at)
        })
    };
    (0..parts.len()).filter(|at| is_greatest(*at)).map(|at| parts[at]).collect()
}

#[cfg(test)]
mod tests;
