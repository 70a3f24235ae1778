//! Two scenes beside each other.

use super::{opened, press, text, write};

/// A crank that turns about a point of the ground, with this length in mm and this many positions.
fn crank(length: u32, positions: u32) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = \"{length} mm\" }}\n\
         [input]\nlink = \"crank\"\npositions = {positions}\n"
    )
}

#[test]
fn two_scenes_have_two_curves_and_a_difference() {
    let folder = tempfile::tempdir().unwrap();
    let longer = folder.path().join("longer.toml");
    std::fs::write(&longer, crank(130, 12)).unwrap();
    let mut state = crate::screen::tests::scene(&crank(100, 12));
    press(&mut state, "2");
    write(&mut state, &format!(":compare {}", longer.display()));
    let frame = text(&state, 120, 40);
    assert!(frame.contains("1 scene.toml (line)  2 ") && frame.contains("longer.toml (stars)"), "{frame}");
    assert!(frame.contains("1 - 2: -30.0000 mm"), "{frame}");
    // The second curve has stars, so that it is told apart without color: 12 in each of three charts, but for covered ones.
    assert!(frame.matches('*').count() >= 24, "{frame}");
    press(&mut state, "t");
    let frame = text(&state, 120, 40);
    assert!(frame.contains("-30.0000") && frame.contains("differences to"), "{frame}");
    write(&mut state, ":compare off");
    assert!(text(&state, 120, 40).contains("100.000"));
}

#[test]
fn what_can_not_be_compared_is_told() {
    let mut state = opened("shaper");
    write(&mut state, ":compare slider-crank.toml");
    assert!(text(&state, 120, 40).contains("slider-crank.toml has 24 positions, not 48"));
    write(&mut state, ":compare nowhere.toml");
    assert!(text(&state, 120, 40).contains("nowhere.toml: there is no such file"));
    // The drive changes no position.
    write(&mut state, ":compare shaper-drive.toml");
    press(&mut state, "2 Right");
    assert!(text(&state, 120, 40).contains("1 - 2: 0 mm"));
}
