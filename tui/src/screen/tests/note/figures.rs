//! Every curve of the note holds the numbers of the JSON at the same coordinates.

use assur_book::Block;

use crate::screen::tests::courses::{assert_found, lines};
use crate::screen::tests::opened;

#[test]
fn every_curve_of_a_note_is_a_column_of_the_json() {
    let mut compared = 0;
    for (name, _) in assur_fixtures::SCENES {
        let state = opened(name);
        let document =
            assur_note::document(state.scene.as_ref().unwrap(), &assur_scene::Note::default(), &[0]).unwrap();
        let figures = document.blocks.iter().filter_map(|block| match block {
            Block::Figure { frames, caption, .. } => Some(lines(&frames[0], &caption.to_string())),
            _ => None,
        });
        let drawn: Vec<_> = figures.flatten().collect();
        assert_found(name, &state, &drawn);
        compared += drawn.len();
    }
    assert!(compared > 100, "{compared}");
}
