//! Numbers changed by keys: every view follows, undo leads back to the same screen, what is saved is the file but for them.

use std::sync::Arc;

use assur_kinematics::Chain;

use super::{View, opened, press, read, scene, settle, text, write};
use crate::screen::command;
use crate::screen::state::{Effect, Job, Report, Source, State, Wanted};

const LENGTH: &str = "link.crank.points.A";

/// A state in a view with the list open at the length of the crank.
fn at_length(view: View) -> State {
    let mut state = opened("shaper");
    state.view = view;
    press(&mut state, "e");
    write(&mut state, "/crank.points.A");
    state
}

fn header(state: &State) -> String {
    text(state, 80, 24).lines().next().unwrap_or_default().to_owned()
}

fn shipped() -> &'static str {
    assur_fixtures::scene("shaper")
}

#[test]
fn a_longer_crank_shows_in_every_view_and_undo_leads_back_to_the_same_screen() {
    for view in crate::screen::tests::VIEWS.into_iter().filter(|view| *view != View::Drive) {
        let mut state = at_length(view);
        press(&mut state, "Right Right Right");
        // The speed is given; what the crank changes comes after it.
        state.chosen.motion = 2;
        let before = text(&state, 80, 24);
        press(&mut state, "+");
        let changed = text(&state, 80, 24);
        assert!(changed.contains("* link.crank.points.A 100 mm -> 101 mm"), "{changed}");
        let follows = before.lines().zip(changed.lines()).skip(2).take(12).any(|(old, new)| old != new);
        assert!(follows, "{view:?}: {changed}");
        press(&mut state, "+ - u u u");
        assert_eq!(text(&state, 80, 24), before, "{view:?}");
        assert_eq!(state.draft.changes(), 0);
    }
}

#[test]
fn the_numbers_are_those_of_the_changed_scene() {
    // The crank lies along x in position 0, so that its end is its length away from the origin.
    let mut state = at_length(View::Mechanism);
    press(&mut state, "e");
    for (keys, length) in
        [("e + e", "101.000"), ("e % + e", "106.000"), ("e % - e", "96.0000"), ("u u", "101.000")]
    {
        press(&mut state, keys);
        let frame = text(&state, 80, 24);
        assert!(frame.contains(&format!("PF0 {length} mm")), "{keys}: {frame}");
    }
}

#[test]
fn the_list_of_values() {
    let mut state = at_length(View::Mechanism);
    press(&mut state, "+ Down Down % +");
    insta::assert_snapshot!(text(&state, 80, 24));
}

#[test]
fn an_exact_value_is_typed_with_its_name_completed() {
    let mut state = opened("shaper");
    press(&mut state, ": v a l u e Space c r a n k . p Tab");
    assert_eq!(
        state.prompt.as_ref().unwrap().text.to_string(),
        format!("value {LENGTH}.O").replace("A.O", "O")
    );
    press(&mut state, "Tab Space 1 2 Space c m Enter");
    assert!(header(&state).contains("* link.crank.points.A 100 mm -> 12 cm"), "{}", header(&state));
    assert!(text(&state, 80, 24).contains("PF0 120.000 mm"));
    write(&mut state, ":value link.crank.points.A 130");
    assert!(header(&state).contains("100 mm -> 130 mm"), "{}", header(&state));
    write(&mut state, ":value link.crank.mass 5");
    assert!(header(&state).contains("crank.mass 4 kg -> 5 kg (+1 more)"), "{}", header(&state));
    write(&mut state, ":value link.crank.mass");
    assert!(text(&state, 80, 24).contains("link.crank.mass is 4 kg -> 5 kg"));
    press(&mut state, ": v a Tab");
    assert_eq!(state.prompt.as_ref().unwrap().text.to_string(), "value gravity");
    press(&mut state, "Esc");
    write(&mut state, ":value link.crank.mas 5");
    assert!(text(&state, 80, 24).contains("did you mean `link.crank.mass`?"));
}

#[test]
fn a_change_that_makes_no_scene_is_told_and_taken_back() {
    for wrong in ["5 kg", "nothing", "1e40"] {
        let mut state = opened("shaper");
        let before = text(&state, 80, 24);
        write(&mut state, &format!(":value {LENGTH} {wrong}"));
        let frame = text(&state, 80, 24);
        assert!(
            frame.contains("The change gives no valid scene") && frame.contains("line 11, column 23"),
            "{frame}"
        );
        assert!(header(&state).contains("(not taken)"), "{frame}");
        press(&mut state, "Right Left");
        assert!(text(&state, 80, 24).contains("PF0 100.000 mm"), "the old result stays");
        press(&mut state, "u");
        assert_eq!(text(&state, 80, 24), before, "{wrong}");
    }
}

#[test]
fn a_change_without_assembly_is_told_and_taken_back() {
    let mut state = scene(crate::screen::tests::words::TURNS);
    let before = text(&state, 80, 24);
    assert!(!before.contains("no assembly"), "{before}");
    write(&mut state, ":value link.rod.points.B 200 mm");
    assert!(text(&state, 80, 24).contains("no assembly"), "{}", text(&state, 80, 24));
    press(&mut state, "u");
    assert_eq!(text(&state, 80, 24), before);
}

#[test]
fn what_is_saved_is_the_file_but_for_the_changes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new.toml");
    let mut state = at_length(View::Mechanism);
    press(&mut state, "+");
    let save = |state: &mut State, answer: &str| {
        write(state, &format!(":save {}", path.display()));
        if state.question.is_some() {
            press(state, answer);
        }
        std::fs::read_to_string(&path).unwrap_or_default()
    };
    let changed = shipped().replace("A = \"100 mm\"", "A = \"101 mm\"");
    assert_eq!(save(&mut state, "n"), changed);
    assert!(changed.contains("# the stone at D"), "comments are kept");
    press(&mut state, "+");
    assert_eq!(save(&mut state, "n"), changed, "asked, and not overwritten");
    assert_eq!(save(&mut state, "y"), shipped().replace("A = \"100 mm\"", "A = \"102 mm\""));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing lies beside");
}

#[test]
fn reading_the_file_again_drops_the_changes_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    std::fs::write(&path, shipped()).unwrap();
    let mut state = crate::screen::tests::state_of(read(Source::File(path), shipped()).unwrap());
    let before = text(&state, 80, 24);
    write(&mut state, ":value link.crank.points.A 120 mm");
    write(&mut state, ":value link.crank.mass 5 kg");
    press(&mut state, "r");
    assert!(text(&state, 80, 24).contains("changes dropped: 2"));
    state.message = None;
    // But for the keys: there is a step that can be taken back.
    let picture = |frame: &str| frame.lines().take(21).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(picture(&text(&state, 80, 24)), picture(&before));
    press(&mut state, "u");
    assert!(header(&state).contains("120 mm"), "the changes are a step that can be taken back");
}

#[test]
fn a_key_that_is_held_down_asks_once_at_a_time() {
    let mut state = at_length(View::Mechanism);
    let key = crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Char('+'));
    (0..20).for_each(|_| command::press(&mut state, key));
    assert!(matches!(state.effects[..], [Effect::Work(Job::Read(Wanted::Change(_)))]), "{:?}", state.effects);
    settle(&mut state);
    assert!(header(&state).contains("100 mm -> 120 mm"));
    assert!(text(&state, 80, 24).contains("PF0 120.000 mm"));
    assert!(state.running.is_empty() && state.scene.as_ref().unwrap().found.is_some());
}

#[test]
fn a_change_of_a_scene_that_was_left_is_dropped() {
    let mut state = opened("shaper");
    write_without_reading(&mut state, ":value link.crank.points.A 120 mm");
    let Some(Effect::Work(job)) = state.effects.pop() else { panic!("no job") };
    let other = read(Source::Shipped("press"), assur_fixtures::scene("press"));
    let wanted = Wanted::Open(Source::Shipped("shaper"));
    command::take(&mut state, Report::Read(wanted, other.map(Box::new)));
    let title = header(&state);
    assert!(!command::take(&mut state, crate::screen::work::run(&job, &|_| ())));
    assert_eq!(header(&state), title);
}

fn write_without_reading(state: &mut State, line: &str) {
    for letter in line.chars() {
        command::press(state, crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Char(letter)));
    }
    command::press(state, crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Enter));
}

#[test]
fn leaving_with_changes_is_asked_once() {
    let mut state = at_length(View::Mechanism);
    press(&mut state, "+");
    (state.named("quit").unwrap().run)(&mut state);
    assert!(state.effects.is_empty());
    assert!(text(&state, 80, 24).contains("changes are not saved: S saves them, q once more leaves"));
    (state.named("quit").unwrap().run)(&mut state);
    assert!(matches!(state.effects[..], [Effect::Quit]));
}

#[test]
fn a_zero_has_no_per_cent() {
    let mut state = opened("shaper");
    press(&mut state, "e");
    write(&mut state, "/ground.points.O");
    press(&mut state, "+");
    assert!(
        text(&state, 80, 24)
            .contains("percentages don't apply to `ground.points.O[0]`: Enter takes an exact value")
    );
    press(&mut state, "Enter");
    assert_eq!(state.prompt.as_ref().unwrap().text.to_string(), "value ground.points.O[0] ");
}

#[test]
fn the_list_gives_the_keys_back() {
    let mut state = at_length(View::Curves);
    let chosen = state.chosen.transfer;
    press(&mut state, "Down Up");
    assert_eq!(state.chosen.transfer, chosen, "the list has them");
    press(&mut state, "Right");
    assert_eq!(state.position, 1, "what the list does not take goes to the view");
    press(&mut state, "Esc Down");
    assert_eq!(state.chosen.transfer, chosen + 1);
    let chosen = state.draft.chosen;
    press(&mut state, "e o Down");
    assert_eq!(state.draft.chosen, chosen, "the list of scenes lies over it");
}

#[cfg(unix)]
#[test]
fn a_file_that_is_overwritten_keeps_its_link_and_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("own.toml"), folder.path().join("link.toml"));
    std::fs::write(&file, "old").unwrap();
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o600)).unwrap();
    std::os::unix::fs::symlink(&file, &link).unwrap();
    let mut state = opened("shaper");
    write(&mut state, &format!(":save {}", link.display()));
    press(&mut state, "y");
    assert_eq!(std::fs::read_to_string(&file).unwrap(), shipped());
    assert_eq!(std::fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
}

#[test]
fn what_cannot_be_written_is_told() {
    let mut state = opened("shaper");
    write(&mut state, ":save /nowhere/x.toml");
    assert!(text(&state, 80, 24).contains("/nowhere/x.toml: there is no folder /nowhere"));
}

/// What is compiled of the scene that is shown, and of its results.
fn compiled(state: &State) -> [*const Chain<f64>; 3] {
    let scene = state.scene.as_ref().unwrap();
    let whole = scene.found.as_ref().unwrap().plans.calculation();
    [&scene.session.linkage().unwrap(), &scene.linkage, &whole.linkage]
        .map(|linkage| Arc::as_ptr(&linkage.chain))
}

/// Linkages that are alive have different addresses: the scene before is kept for the comparison.
#[test]
fn a_changed_length_compiles_once_and_a_changed_mass_never() {
    for name in ["shaper", "shaper-drive", "press"] {
        let mut state = opened(name);
        let before = compiled(&state);
        assert!(before.iter().all(|other| *other == before[0]), "{name}");
        let values = state.draft.values.iter();
        let keys: Vec<_> =
            values.map(|value| value.key.to_string()).filter(|key| key.starts_with("link.")).collect();
        let one = |ending: &str| keys.iter().find(|key| key.ends_with(ending)).cloned();
        if let Some(mass) = one(".mass") {
            write(&mut state, &format!(":value {mass} 7 kg"));
            assert!(state.draft.changes() == 1 && compiled(&state) == before, "{name}: {mass}");
            press(&mut state, "u");
            assert_eq!(compiled(&state), before, "{name}: {mass}");
        }
        let length = keys.iter().find(|key| key.contains(".points.")).unwrap();
        write(&mut state, &format!(":value {length} 101 mm"));
        let after = compiled(&state);
        assert!(after.iter().all(|other| *other == after[0] && *other != before[0]), "{name}: {length}");
    }
}

#[test]
fn modes_of_a_group_are_shown_one_after_the_other_and_one_is_taken() {
    let present = |state: &State| {
        let modes = state.scene.as_ref().and_then(|scene| scene.modes(0, 0)).unwrap();
        (modes.number(modes.present), modes.all.len())
    };
    // `[assembly]` stands in the file, and does not.
    for assembly in [true, false] {
        let text_of = |scene: &str| {
            let (before, after) = scene.split_once("[assembly]").unwrap();
            let (_, after) = after.split_once("[motion]").unwrap();
            if assembly { scene.to_owned() } else { format!("{before}[motion]{after}") }
        };
        let mut state = scene(&text_of(assur_fixtures::scene("triad")));
        state.view = View::Structure;
        let (first, count) = present(&state);
        assert!(count > 1);
        let before = text(&state, 80, 24);
        for (language, kind) in
            [("uk", "клас III, RR-RR-RR, порядок 3"), ("en", "class III, RR-RR-RR, order 3")]
        {
            state.look.language = language;
            assert!(text(&state, 80, 40).contains(kind), "{}", text(&state, 80, 40));
        }
        for step in 1..=count {
            press(&mut state, "]");
            let frame = text(&state, 80, 40);
            assert!(frame.contains(&format!("shown: mode {}", (first + step) % count + 1)), "{frame}");
        }
        press(&mut state, "] A");
        assert_eq!(present(&state), ((first + 1) % count, count));
        press(&mut state, "u");
        assert_eq!(present(&state), (first, count));
        assert!(!assembly || text(&state, 80, 24) == before);
    }
}

/// Of the four modes of the fixture two are left where the strut is 60 mm longer than 0.5 m.
#[test]
fn a_changed_length_keeps_the_mode_while_it_exists_and_its_end_is_told() {
    let strut = |state: &mut State, length: &str| {
        write(state, &format!(":value link.strut.points.E {length}"));
        let modes = state.scene.as_ref().and_then(|scene| scene.modes(0, 0)).unwrap();
        let told = text(state, 80, 24).contains("has vanished");
        (modes.number(modes.present), modes.all.len(), told)
    };
    // Way 2 meets way 1 between 0.5 m and 0.56 m.
    let mut state = scene(assur_fixtures::scene("triad"));
    assert_eq!(strut(&mut state, "500 mm"), (2, 4, false));
    assert_eq!(strut(&mut state, "560 mm"), (1, 2, true));
    // Way 3 goes on, as way 1 of the two that are left.
    let mut state = scene(assur_fixtures::scene("triad"));
    state.view = View::Structure;
    press(&mut state, "] A");
    assert_eq!(strut(&mut state, "500 mm"), (3, 4, false));
    assert_eq!(strut(&mut state, "560 mm"), (1, 2, false));
    assert_eq!(strut(&mut state, "620 mm"), (1, 2, false));
}
