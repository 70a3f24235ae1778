//! The drawing sheet as a view: its fields are switched and moved, and `[sheet] fields` has what is seen.

use super::{View, opened, press, text};

#[test]
fn fields_are_left_out_taken_again_and_moved_and_the_scene_has_their_order() {
    let mut state = opened("brake");
    state.view = View::Sheet;
    let frame = text(&state, 80, 24);
    assert!(frame.contains("> 1 mechanism") && frame.contains("sheet 1 of 1"), "{frame}");
    press(&mut state, "Enter");
    let all = r#"["diagrams", "velocities", "accelerations", "forces", "lever", "dynamics", "results"]"#;
    assert!(state.draft.text().contains(&format!("fields = {all}")), "{}", state.draft.text());
    // The field that is left out is at the end of the list, and stays chosen.
    let frame = text(&state, 80, 24);
    assert!(frame.contains("> - mechanism") && frame.contains("  1 diagrams"), "{frame}");
    press(&mut state, "Enter");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("> 8 mechanism"), "{frame}");
    press(&mut state, "<");
    let back = r#""dynamics", "mechanism", "results"]"#;
    assert!(state.draft.text().contains(back), "{}", state.draft.text());
    // The arrows with the shift key move it too, right after a switch.
    press(&mut state, "Enter Enter S-Up S-Up S-Down");
    let moved = r#""dynamics", "mechanism", "results"]"#;
    assert!(state.draft.text().contains(moved), "{}", state.draft.text());
    press(&mut state, "u u u u u u u u");
    assert!(!state.draft.is_changed());
}
