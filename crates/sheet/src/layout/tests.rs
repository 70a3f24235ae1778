use super::{Block, GAP, arrange, fitting};

const FRAME: [f64; 4] = [20.0, 5.0, 420.0, 305.0];
const TITLE: [f64; 4] = [235.0, 250.0, 420.0, 305.0];

fn square(least: f64, most: f64) -> Block {
    let steps = [0.0, 0.25, 0.5, 0.75, 1.0];
    let sizes = steps.map(|part| [least + part * (most - least); 2]);
    Block { sizes: sizes.into(), weight: 1.0 }
}

#[test]
fn a_block_alone_is_as_large_as_the_place_beside_the_title() {
    // Above the title block 245 mm are free, less a gap at both ends; at its left 215 mm of width.
    let placed = arrange(&[square(50.0, 245.0 - 3.0 * GAP)], FRAME, TITLE).unwrap();
    assert_eq!(placed[0].level, 4);
    let too_large = arrange(&[square(50.0, 500.0)], FRAME, TITLE).unwrap();
    assert!(too_large[0].level < 4);
}

#[test]
fn blocks_grow_until_none_has_room_and_never_meet() {
    let blocks: Vec<Block> = (0..6).map(|_| square(40.0, 140.0)).collect();
    let placed = arrange(&blocks, FRAME, TITLE).unwrap();
    let areas: Vec<[f64; 4]> = placed
        .iter()
        .zip(&blocks)
        .map(|(own, block)| {
            let [width, height] = block.sizes[own.level];
            [own.corner[0], own.corner[1], own.corner[0] + width, own.corner[1] + height]
        })
        .chain([TITLE])
        .collect();
    for (index, one) in areas.iter().enumerate() {
        for other in &areas[..index] {
            assert!(!(0..2).all(|axis| one[axis] < other[axis + 2] && other[axis] < one[axis + 2]));
        }
    }
    assert!(placed.iter().any(|own| own.level > 0));
}

#[test]
fn what_has_no_room_is_left_for_the_next_sheet() {
    // Of squares of 140 mm two have room above each other at the left, and one at their right above the title block.
    let blocks: Vec<Block> = (0..6).map(|_| square(140.0, 140.0)).collect();
    assert_eq!(fitting(&blocks, FRAME, TITLE), 3);
    assert_eq!(fitting(&[square(400.0, 400.0)], FRAME, TITLE), 0);
    assert!(arrange(&[square(400.0, 400.0)], FRAME, TITLE).is_none());
}
