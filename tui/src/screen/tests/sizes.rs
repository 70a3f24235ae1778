//! No size of the terminal, and of a view, is too small.

use super::{View, frame, opened, text};
use crate::screen::draw::Pen;
use crate::screen::state::State;

fn all_parts(state: &mut State, view: View, mut check: impl FnMut(&State)) {
    check(state);
    for part in view.parts() {
        state.parts.insert(view, *part);
        check(state);
    }
}

#[test]
fn every_size_is_drawn_in_every_view() {
    let mut state = opened("slider-crank");
    for view in crate::screen::tests::VIEWS.into_iter().chain([View::Working, View::Accuracy]) {
        state.view = view;
        for width in 0..=100 {
            for height in 0..=40 {
                // Sizes that hold the view: enough of them, with its edges.
                let small = width < 80 || height < 24;
                if small || width % 5 == 0 || height % 8 == 0 {
                    let _ = frame(&state, width, height);
                }
            }
        }
    }
}

#[test]
fn every_size_is_drawn_with_the_list_of_values() {
    let mut state = opened("slider-crank");
    crate::screen::command::toggle(&mut state);
    for view in crate::screen::tests::VIEWS {
        state.view = view;
        for (width, height) in [(0, 0), (79, 24), (80, 23), (80, 24), (81, 25), (100, 30), (200, 60)] {
            let _ = frame(&state, width, height);
        }
    }
    for width in 0..=60 {
        for height in 0..=20 {
            let area = ratatui::layout::Rect::new(0, 0, width, height);
            let mut buffer = ratatui::buffer::Buffer::empty(area);
            crate::screen::view::values::draw(&mut Pen { state: &state, buffer: &mut buffer }, area);
        }
    }
}

#[test]
fn every_view_survives_any_area() {
    let mut state = opened("slider-crank");
    for view in crate::screen::tests::VIEWS.into_iter().chain([View::Working, View::Accuracy]) {
        state.view = view;
        all_parts(&mut state, view, |state| {
            for width in [0, 1, 2, 5, 11, 12, 13, 26, 27, 40] {
                for height in [0, 1, 2, 3, 4, 5, 9, 17] {
                    let area = ratatui::layout::Rect::new(3, 2, width, height);
                    let mut buffer = ratatui::buffer::Buffer::empty(ratatui::layout::Rect::new(0, 0, 50, 25));
                    crate::screen::view::draw_view(&mut Pen { state, buffer: &mut buffer }, view, area);
                }
            }
        });
    }
}

#[test]
fn a_small_terminal_is_told_what_is_needed() {
    let state = opened("slider-crank");
    assert!(text(&state, 60, 20).starts_with("needs 80 x 24, has 60 x 20\n"));
    assert!(!text(&state, 80, 24).contains("needs"));
}
