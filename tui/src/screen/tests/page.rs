//! The frames of docs/screen.md are those of the program; `INSTA_UPDATE=always` writes them anew.

use super::{opened, press, text};

#[test]
fn the_page_shows_the_frames_of_the_program() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/screen.md");
    let mut page = std::fs::read_to_string(path).unwrap();
    let update = std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always");
    let mut state = opened("shaper");
    state.position = 18;
    for view in ["1", "2", "3"] {
        press(&mut state, view);
        let frame = text(&state, 80, 24);
        let shown = page.split("```\n").filter(|block| block.starts_with(" position ")).map(str::to_owned);
        let shown: Vec<String> = shown.collect();
        assert_eq!(shown.len(), 3);
        let own = &shown[view.parse::<usize>().unwrap() - 1];
        if update {
            page = page.replace(own, &frame);
        } else {
            assert_eq!(*own, frame, "view {view}");
        }
    }
    if update {
        std::fs::write(path, page).unwrap();
    }
}
