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
    write(&mut state, ":compare nowhere.toml");
    assert!(text(&state, 120, 40).contains("nowhere.toml: there is no such file"));
    // The drive changes no position.
    write(&mut state, ":compare shaper-drive.toml");
    press(&mut state, "2 Right");
    assert!(text(&state, 120, 40).contains("1 - 2: 0 mm"));
}

#[test]
fn scenes_of_other_positions_are_compared_at_the_same_places() {
    // Crank, so that the second scene with its own 24 positions has every other place of the first one.
    let mut state = opened("shaper");
    write(&mut state, ":compare shaper-friction.toml");
    let own = opened("shaper-friction");
    assert_eq!((state.positions(), own.positions()), (48, 24));
    let second = state.second().unwrap().results.found.as_deref().unwrap();
    let of_own = own.found().unwrap();
    let mut compared = 0;
    for one in &of_own.series {
        // The residuals are those of checks, which only the open scene has.
        let Some(same) = second.series.iter().find(|series| series.column == one.column) else { continue };
        for position in 0..24 {
            let [whole, every_other] = [one.at(position), same.at(2 * position)];
            let apart = (whole - every_other).abs();
            // Friction is iterated to 1e-9 or better.
            assert!(apart <= 1e-7 * one.size() || whole.is_nan(), "{:?} {position}: {apart}", one.short);
            compared += 1;
        }
    }
    assert!(compared > 1000, "{compared}");
}

#[test]
fn forces_and_results_of_two_scenes_stand_beside_each_other() {
    let mut state = opened("shaper");
    write(&mut state, ":compare shaper-friction.toml");
    press(&mut state, "3");
    let frame = text(&state, 120, 40);
    let row = frame.lines().find(|line| line.contains("|F1 - F2|")).unwrap_or_else(|| panic!("{frame}"));
    assert!(row.contains("|F1|") && row.contains("|F2|"), "{frame}");
    let number = |text: &str| text.parse::<f64>().ok();
    let numbers = |line: &str| line.split_whitespace().filter_map(number).collect::<Vec<_>>();
    // The two numbers of the balancing moment, which have signs, and their difference.
    let balancing = frame.lines().find(|line| line.contains("balancing") && line.contains("N·m")).unwrap();
    let [one, two, apart] = numbers(balancing)[..] else { panic!("{frame}") };
    assert!(((one - two).abs() - apart).abs() < 1e-3 * one.abs() && apart > 0.0, "{balancing}");
    press(&mut state, "R");
    let frame = text(&state, 120, 40);
    let stroke = frame.lines().find(|line| line.contains("1 - 2")).unwrap_or_else(|| panic!("{frame}"));
    assert!(stroke.contains("Quantity"), "{frame}");
    let is_compared = |line: &&str| line.contains("N·m") || line.contains(" N ") || line.contains("deg");
    let rows = frame.lines().skip(3).filter(is_compared).map(numbers).filter(|row| row.len() == 3);
    let apart = |row: &Vec<f64>| (row[0] - row[1] - row[2]).abs() <= 1e-3 * row[0].abs().max(row[1].abs());
    let count = rows.inspect(|row| assert!(apart(row), "{row:?} {frame}")).count();
    assert!(count > 5, "{frame}");
}
