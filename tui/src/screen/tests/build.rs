//! Building: the keys of docs/build.md make scenes with the numbers of known ones; any keys leave a file that reads back as it is shown.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

use assur_analysis::results::{Column, Owner, Quantity};
use assur_fixtures::scene as shipped;
use crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

use super::random::Dice;
use super::{Effect, Key, State, View, empty, press, settle, text};
use crate::screen::command;
use crate::screen::state::{Draft, Series};
use crate::session::{Session, Source};

/// Greatest deviation of a number from that of the known scene, as part of the greatest of its column.
const LIMIT: f64 = 1e-12;
/// Greatest number of keys beyond names and numbers.
const MOST_KEYS: usize = 90;

/// A scene that ships nowhere: a slider-crank with offset and friction.
const OFFSET: &str = r#"
[ground]
points = { O = 0 }
[link.crank]
points = { O = 0, A = "50 mm" }
[link.rod]
points = { A = 0, B = "180 mm" }
[link.slider]
points = { B = 0 }
mass = "2 kg"
[[slide]]
link = "slider"
on = "ground"
through = [0, "20 mm"]
[input]
link = "crank"
positions = 24
[motion]
speed = "300 rpm"
[[force]]
link = "slider"
at = "B"
angle = "180 deg"
value = "400 N"
[[friction]]
pair = "slider/ground"
coefficient = 0.1
[[friction]]
pair = "A"
coefficient = 0.08
radius = "12 mm"
[assembly]
B = [0.22, 0.02]
"#;

/// The recipes of docs/build.md: what each builds, and its keys.
fn recipes() -> Vec<(String, Vec<String>)> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/build.md");
    let page = fs::read_to_string(page).unwrap();
    let parts = page.split("\n## ").skip(1).filter_map(|part| {
        let (title, rest) = part.split_once('\n')?;
        let (_, keys) = rest.split_once("```keys\n")?;
        let (keys, _) = keys.split_once("```")?;
        Some((title.to_owned(), pieces(keys)))
    });
    parts.collect()
}

/// The pieces of a recipe: `"100 mm"` is typed, anything else is a key or a word of a list.
fn pieces(keys: &str) -> Vec<String> {
    let lines = keys.lines().map(|line| line.split(" # ").next().unwrap_or_default());
    let mut all = Vec::new();
    for line in lines {
        for (index, piece) in line.split('"').enumerate() {
            if index % 2 == 1 {
                all.push(format!("\"{piece}"));
            } else {
                all.extend(piece.split_whitespace().map(str::to_owned));
            }
        }
    }
    all
}

/// Plays a recipe from nothing; the number of keys beyond names and numbers.
fn play(keys: &[String]) -> (State, usize) {
    let mut state = empty(None);
    command::from_nothing(&mut state);
    settle(&mut state);
    let count = play_on(&mut state, keys);
    (state, count)
}

/// Plays keys from where a state is; the number of those beyond names and numbers.
fn play_on(state: &mut State, keys: &[String]) -> usize {
    let mut count = 0;
    for piece in keys {
        if let Some(typed) = piece.strip_prefix('"') {
            type_in(state, typed);
        } else if Key::parse(piece).is_some() {
            press(state, piece);
            count += 1;
        } else {
            type_in(state, piece);
            count += piece.chars().count();
        }
        let _ = text(state, 80, 24);
    }
    count
}

fn type_in(state: &mut State, typed: &str) {
    for letter in typed.chars() {
        command::press(state, crossterm::event::KeyEvent::from(crossterm::event::KeyCode::Char(letter)));
        settle(state);
    }
}

/// The numbers of a scene by column. What depends on where the x axes of links lie is left out, and points of interest that another
/// scene has not.
fn columns(text: &str, other: &str) -> BTreeMap<String, Vec<f64>> {
    let read = |text: &str| Session::read(Source::File("built.toml".into()), text.to_owned());
    let session = read(text).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
    let other = read(other).unwrap_or_else(|fault| panic!("{fault}\n{other}")).mechanism;
    let options = assur_analysis::Options::default();
    let results = session.analyzed(&options, false, &mut assur_analysis::unwatched).unwrap();
    let is_wanted = |column: Column| match column.owner {
        Owner::Link(_) => column.quantity != Quantity::Transfer(0),
        Owner::Point(point) => {
            let point = &session.mechanism.points[point];
            point.is_pin() || other.point(point.name.as_str()).is_some()
        }
        _ => true,
    };
    let wanted = results.columns().skip(1).filter(|series| is_wanted(series.column));
    let values = |series: &Series| (0..results.positions()).map(|position| series.at(position)).collect();
    wanted.map(|series| (series.title().to_string(), values(series))).collect()
}

fn compare(title: &str, built: &str, known: &str) {
    let (built, known) = (columns(built, known), columns(known, built));
    assert!(known.len() > 8, "{title}: {} columns", known.len());
    // Of a number that is zero but for rounding, the greatest of its unit counts.
    let unit_of = |name: &str| name.rsplit_once(", ").map_or("", |(_, unit)| unit).to_owned();
    let size_of = |unit: String| {
        let alike = known.iter().filter(|(name, _)| unit_of(name) == unit).flat_map(|(_, values)| values);
        alike.fold(0.0, |most, value| f64::max(most, value.abs()))
    };
    for (name, known) in &known {
        // Of the two opposite reactions in a pair, that on the link which the file names first is told.
        let (sign, own) = match (built.get(name), name.split_once(" on ")) {
            (Some(own), _) => (1.0, own),
            (None, Some((pair, on))) => {
                let (_, component) = on.split_once(' ').unwrap();
                let opposite =
                    |own: &&String| own.starts_with(&format!("{pair} on ")) && own.ends_with(component);
                let found = built.keys().find(opposite).unwrap_or_else(|| panic!("{title}: no {name}"));
                (if component.starts_with("R ") { 1.0 } else { -1.0 }, &built[found])
            }
            _ => panic!("{title}: no {name} among {:?}", built.keys()),
        };
        let size = size_of(unit_of(name));
        for (at, (own, known)) in own.iter().zip(known).enumerate() {
            let is_same =
                own.is_nan() && known.is_nan() || (sign * own - known).abs() <= LIMIT * size.max(1e-9);
            assert!(is_same, "{title}: {name} at {at}: {own} for {known}");
        }
    }
}

#[test]
fn the_recipes_build_scenes_with_the_numbers_of_known_ones() {
    let known = [shipped("shaper"), OFFSET, shipped("stephenson3"), shipped("triad"), shipped("boom")];
    let recipes = recipes();
    assert_eq!(recipes.len(), known.len());
    for ((title, keys), known) in recipes.iter().zip(known) {
        let (state, count) = play(keys);
        println!("{title}: {count} keys");
        assert!(count <= MOST_KEYS, "{title}: {count} keys");
        compare(title, state.draft.text(), known);
    }
}

/// Scenes from which random building begins: the written ones, one with faults, one that is no mechanism, nothing.
fn beginnings() -> Vec<String> {
    let names = ["shaper", "four-bar", "slider-crank", "stephenson3", "boom", "shaper-drive"];
    let mut all: Vec<String> = names.iter().map(|name| shipped(name).to_owned()).collect();
    all.push(shipped("shaper").replace("\"rocker\"", "\"rokcer\""));
    all.push(shipped("four-bar").replace("[input]", "[inptu]"));
    all.push(
        "[ground]\npoints = { O = 0 }\n[link.a]\npoints = { O = 0, A = 0.1 }\n[link.b]\npoints = { Q = 0 }\n"
            .to_owned(),
    );
    all.push(String::new());
    all
}

/// Any keys and clicks while building: no panic, the file reads back as it is shown, undo leads to the first bytes.
fn build_at_random(steps: usize) {
    for (number, first) in beginnings().into_iter().enumerate() {
        let mut state = empty(None);
        command::from_nothing(&mut state);
        state.draft = Draft::from(1, Source::New, &first);
        state.picker = None;
        press(&mut state, "Esc B B");
        let mut dice = Dice(0x9e37_79b9_7f4a_7c15 ^ (number as u64 + 1));
        for _ in 0..steps {
            random_event(&mut state, &mut dice);
            state
                .effects
                .retain(|effect| !matches!(effect, Effect::Quit | Effect::Suspend | Effect::Write(_)));
            settle(&mut state);
            let read = state.build.read.as_ref().map(|read| Arc::clone(&read.text));
            if state.view == View::Build {
                assert_eq!(read.as_ref(), Some(state.draft.text()), "what is looked at is the text");
            }
            if state.view == View::Build
                && let Some(scene) = state.scene.as_ref().filter(|_| state.draft.shown == *state.draft.text())
            {
                let readable = state.build.read.as_ref().and_then(|read| read.readable.clone());
                assert_eq!(
                    readable.as_deref(),
                    Some(scene.session.text.as_str()),
                    "the picture is of the text"
                );
            }
            let _ = text(&state, 80, 24);
        }
        while state.draft.has_steps()[0] {
            state.draft.undo();
        }
        assert_eq!(&**state.draft.text(), first, "undo leads to the first bytes");
    }
}

fn random_event(state: &mut State, dice: &mut Dice) {
    // Without the key that writes a file.
    const KEYS: &str = "A Enter Enter Enter Tab S-Tab Right Left Up Down S-Right S-Up g % < > N D y T i C E P u u C-r \
                        PgDn PgUp Home Esc Space [ ] + - 0 Del Ins Backspace B 1 3 R";
    match dice.below(8) {
        0 => {
            let kinds = [
                MouseEventKind::Down(MouseButton::Left),
                MouseEventKind::Drag(MouseButton::Left),
                MouseEventKind::Up(MouseButton::Left),
            ];
            let [column, row] = [dice.below(80), dice.below(24)].map(|cell| u16::try_from(cell).unwrap());
            let kind = kinds[dice.below(kinds.len())];
            command::click(state, MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE });
        }
        1 => {
            let words = [
                "A",
                "0, -400",
                "100 mm",
                "rpr",
                "rrr",
                "12,5",
                "ground",
                "crank 50",
                "-1e300",
                "force",
                "\u{44f}\"'",
            ];
            type_in(state, words[dice.below(words.len())]);
        }
        _ => {
            let keys: Vec<&str> = KEYS.split_whitespace().collect();
            press(state, keys[dice.below(keys.len())]);
        }
    }
}

#[test]
fn any_keys_while_building_leave_a_file_that_is_shown() {
    build_at_random(60);
}

/// A hundred thousand events from ten scenes.
#[test]
#[ignore = "takes about half an hour"]
fn very_many_keys_while_building() {
    build_at_random(10_000);
}

/// A crank on its pivot, its form ended.
fn crank() -> State {
    let mut state = empty(None);
    command::from_nothing(&mut state);
    settle(&mut state);
    press(&mut state, "Enter Esc");
    state
}

#[test]
fn a_key_that_writes_nothing_leaves_the_value_and_backspace_changes_its_end() {
    let mut state = crank();
    press(&mut state, "T Enter");
    let before = state.draft.text().to_string();
    press(&mut state, "PgDn PgUp F5");
    assert_eq!(&**state.draft.text(), before);
    press(&mut state, "Esc Tab Tab Enter Down");
    // The place of A on the crank, 100 mm: without its last letter it is in meters.
    press(&mut state, "Backspace");
    let form = state.build.form().unwrap();
    assert_eq!(form.entry.as_ref().map(|entry| entry.to_string()).as_deref(), Some("100 m"));
    press(&mut state, "Esc");
    assert_eq!(&**state.draft.text(), before, "what was not ended is taken back");
}

#[test]
fn each_drag_is_a_step_of_its_own() {
    let mut state = crank();
    let event = |state: &mut State, kind, column, row| {
        command::click(state, MouseEvent { kind, column, row, modifiers: KeyModifiers::NONE });
        settle(state);
    };
    let first = state.draft.text().to_string();
    // The crank lies from the pivot, in the middle of the picture, to the right.
    let row = text(&state, 80, 24)
        .lines()
        .position(|line| line.contains('\u{2500}') && line.contains('A'))
        .unwrap_or(11);
    let mut texts = vec![first.clone()];
    for (column, to) in [(34, 38), (38, 30)] {
        let row = u16::try_from(row).unwrap();
        event(&mut state, MouseEventKind::Down(MouseButton::Left), column, row);
        event(&mut state, MouseEventKind::Drag(MouseButton::Left), to, row - 2);
        event(&mut state, MouseEventKind::Drag(MouseButton::Left), to, row - 3);
        event(&mut state, MouseEventKind::Up(MouseButton::Left), to, row - 3);
        texts.push(state.draft.text().to_string());
    }
    assert!(texts[0] != texts[1] && texts[1] != texts[2], "{texts:?}");
    for before in texts[..2].iter().rev() {
        press(&mut state, "u");
        assert_eq!(&**state.draft.text(), before);
    }
}

#[test]
fn a_new_scene_that_is_saved_counts_its_changes_from_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("own.toml");
    let mut state = crank();
    assert!(text(&state, 80, 24).contains("* new.toml"));
    super::write(&mut state, &format!(":save {}", path.display()));
    assert_eq!(fs::read_to_string(&path).unwrap(), **state.draft.text());
    let frame = text(&state, 80, 24);
    assert!(frame.contains("own.toml") && !frame.contains("* own.toml"), "{frame}");
    press(&mut state, "1");
    assert!(!text(&state, 80, 24).lines().next().unwrap().contains('*'));
    // A later change is written to the same file without a question.
    press(&mut state, "B D y");
    press(&mut state, "S Enter");
    assert!(state.question.is_none());
}

#[test]
fn a_number_of_a_text_with_faults_is_changed_where_it_stands() {
    let first = shipped("shaper");
    let mut draft = Draft::from(0, Source::New, first);
    let index = draft.values.iter().position(|value| value.key.to_string() == "link.crank.points.A").unwrap();
    // The values are those of the text before: a text with a fault has none.
    let faulty = format!("nonsense = 1\n{first}");
    assert!(draft.take(&faulty) && draft.put(index, "\"90 mm\""));
    assert_eq!(**draft.text(), faulty.replace("A = \"100 mm\"", "A = \"90 mm\""));
}

/// The tour, by the keys that its texts name. Its last step, that of saving, ends with the answer of whoever writes the file.
#[test]
fn each_step_of_the_tour_ends_by_the_keys_that_it_names() {
    let mut state = empty(None);
    command::tour(&mut state);
    settle(&mut state);
    let masses = format!("b {} \"30 kg; 0, 0; 0.9 kg*m^2\" Enter Esc", "Down ".repeat(12));
    let steps = [
        "Enter Esc",
        "A rpr Enter \"A\" Enter \"0, -400\" Enter \"stone2; rocker\" Enter Down \"D; 700 mm\" Up Up \"C\" Enter Esc",
        "A rpp Enter \"D\" Enter \"0, 270\" Enter \"stone4; ram\" Enter Esc",
        "Space Space Tab g Right Esc u",
        &masses,
        "T motion Enter Down \"60 rpm\" Enter Esc",
        "T force Enter Down \"ram\" Enter \"0, 0\" Enter \"0 deg\" Enter Down \"1500 N\" Enter Esc",
        "3 Down",
        "7",
    ];
    for (number, keys) in steps.into_iter().enumerate() {
        let step = state.tour.as_ref().map(|(step, _)| *step);
        assert_eq!(step, Some(number), "{}\n{}", text(&state, 80, 24), &**state.draft.text());
        play_on(&mut state, &pieces(keys));
    }
    assert_eq!(state.tour.as_ref().map(|(step, _)| *step), Some(steps.len()), "{}", text(&state, 80, 24));
}

#[test]
fn undo_and_redo_tell_what_they_did() {
    let mut state = crank();
    press(&mut state, "Tab Tab g Right");
    let before = state.draft.text().to_string();
    let told = |state: &State| text(state, 80, 24).lines().last().unwrap().trim().to_owned();
    press(&mut state, "u");
    assert_eq!(told(&state), "taken back: -input.from, link.crank.points.A 101 mm -> 100 mm");
    press(&mut state, "C-r");
    assert_eq!(told(&state), "done again: +input.from, link.crank.points.A 100 mm -> 101 mm");
    assert_eq!(**state.draft.text(), before);
    press(&mut state, "g D y u");
    assert!(told(&state).starts_with("taken back: +"), "{}", told(&state));
}

/// A shipped scene that is built on.
fn building(name: &'static str) -> State {
    let mut state = super::opened(name);
    press(&mut state, "B");
    state
}

#[test]
fn a_force_goes_with_its_link_and_a_fault_leads_to_its_field() {
    let mut state = building("shaper");
    press(&mut state, "T");
    type_in(&mut state, "cutting");
    press(&mut state, "Enter Down");
    type_in(&mut state, "crank");
    press(&mut state, "Enter");
    assert!(state.draft.text().contains("link = \"crank\"\nat = \"A\""), "{}", state.draft.text());
    // A fault that no form has made: its field is chosen, of a number in rows that of the number.
    let faults = [
        ("at = \"K\"", "at = \"A\"", "force[0].at"),
        ("[0.95, 1500]", "[0.95, \"1 m\"]", "force[0].value.forward[2][1]"),
        ("mass = \"12 kg\"", "mass = \"12 mm\"", "link.rocker.mass"),
        ("D = \"700 mm\"", "D = \"7 N\"", "link.rocker.points.D"),
    ];
    for (from, to, key) in faults {
        let mut state = crank();
        state.draft = Draft::from(1, Source::New, &shipped("shaper").replace(from, to));
        press(&mut state, "B B E");
        let field = state.build.form().and_then(|form| form.field()).map(|field| field.key.to_string());
        assert_eq!(field.as_deref(), Some(key));
    }
}

#[test]
fn a_refused_field_is_left_by_one_key_with_the_value_before() {
    let mut state = crank();
    press(&mut state, "Tab Tab Enter Down");
    let before = state.draft.text().to_string();
    type_in(&mut state, "10 kg");
    press(&mut state, "Enter");
    assert!(state.build.form().is_some_and(|form| form.fault.is_some()));
    press(&mut state, "Esc");
    assert!(state.build.form().is_none());
    assert_eq!(**state.draft.text(), before);
    // A name that is taken too.
    press(&mut state, "N");
    type_in(&mut state, "O");
    press(&mut state, "Enter");
    assert!(text(&state, 80, 24).contains("`O` is taken"), "{}", text(&state, 80, 24));
    press(&mut state, "Esc");
    assert!(state.build.form().is_none());
    assert_eq!(**state.draft.text(), before);
}

#[test]
fn an_empty_view_of_forces_advises_by_the_links_of_its_scene() {
    let mut state = crank();
    press(&mut state, "3");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("link = \"crank\"") && frame.contains("at = \"A\""), "{frame}");
    assert!(frame.contains("B, then T"), "{frame}");
}

#[test]
fn the_help_has_the_whole_text_of_a_field_that_is_cut() {
    let mut state = crank();
    press(&mut state, "Tab Tab Enter Down");
    let about = state.told(state.build.form().unwrap().field().unwrap().about.clone());
    let last = about.split_whitespace().last().unwrap().to_owned();
    let side = |state: &State| -> String {
        text(state, 80, 24)
            .lines()
            .filter_map(|line| line.split_once('\u{2502}').map(|(_, side)| side.to_owned()))
            .collect()
    };
    assert!(!side(&state).contains(&last) && side(&state).contains("?: all of it"), "{}", side(&state));
    press(&mut state, "?");
    let help = text(&state, 80, 24);
    assert!(help.contains(&last) && help.contains("Chosen: link.crank.points.A: 100 mm"), "{help}");
}

#[test]
fn the_help_begins_with_what_is_chosen() {
    let mut state = building("shaper");
    let first = |state: &mut State| -> [String; 2] {
        press(state, "?");
        let frame = text(state, 80, 24);
        press(state, "Esc");
        let mut lines =
            frame.lines().skip(3).map(|line| line.trim_matches(['\u{2502}', '\u{2588}', ' ']).to_owned());
        [(); 2].map(|()| lines.next().unwrap())
    };
    for (chosen, lines) in [
        (assur_draft::Part::Point("A".to_owned()), ["Chosen: point A", "joins crank, stone2"]),
        (assur_draft::Part::Link("rocker".to_owned()), ["Chosen: link rocker", "points: C, S3, D"]),
        (
            assur_draft::Part::Slide("stone4/ram".to_owned()),
            ["Chosen: slide stone4/ram", "stone4 slides on ram"],
        ),
    ] {
        state.build.chosen = Some(chosen);
        assert_eq!(first(&mut state), lines);
    }
    press(&mut state, "A Down Down");
    assert_eq!(first(&mut state)[0], "Chosen: RPR");
    press(&mut state, "Enter");
    assert_eq!(first(&mut state)[0], "Chosen: RPR");
}

#[test]
fn no_two_kinds_of_groups_look_the_same_in_their_list() {
    for language in ["en", "uk"] {
        let mut state = building("shaper");
        state.look.language = language;
        press(&mut state, "A");
        let count = state.picker.as_ref().unwrap().rows.len();
        let mut seen = BTreeMap::new();
        for _ in 0..count {
            let frame = text(&state, 80, 24);
            let chosen = frame.lines().find(|line| line.starts_with(" >")).unwrap().chars().take(54);
            let below: String = frame.lines().skip(18).take(4).collect();
            let name = state.picker.as_ref().unwrap().choice().unwrap().name.clone();
            let twin = seen.insert(chosen.collect::<String>() + &below, name.clone());
            assert_eq!(twin, None, "{name}\n{frame}");
            press(&mut state, "Down");
        }
    }
}

#[test]
fn a_group_on_one_link_is_told_to_be_rigid_with_it() {
    let mut state = building("shaper");
    press(&mut state, "A Enter");
    for pin in ["C", "D"] {
        type_in(&mut state, pin);
        press(&mut state, "Enter");
    }
    let frame = text(&state, 80, 24);
    assert!(frame.contains("it is rigid with rocker"), "{frame}");
}

#[test]
fn loads_are_in_the_picture_and_curves_follow_what_is_moved() {
    let mut state = building("shaper");
    // The cutting force, which is zero at the ends of the stroke: behind the weights of five links.
    state.position = 12;
    assert!(text(&state, 80, 24).contains("F6"), "{}", text(&state, 80, 24));
    state.position = 0;
    state.build.chosen = Some(assur_draft::Part::Point("D".to_owned()));
    assert!(!text(&state, 80, 24).contains("path of D"));
    press(&mut state, "g");
    let before = text(&state, 80, 40);
    assert!(before.contains("path of D") && before.contains("stone2/rocker"), "{before}");
    assert!(text(&state, 80, 50).contains("transmission angle"), "{}", text(&state, 80, 50));
    press(&mut state, "Up Up Up");
    let after = text(&state, 80, 40);
    let side =
        |frame: &str| -> Vec<String> { frame.lines().map(|line| line.chars().skip(46).collect()).collect() };
    assert!(after.contains("path of D") && side(&before) != side(&after));
}

#[test]
fn page_keys_go_on_in_a_long_form() {
    let mut state = building("shaper");
    press(&mut state, "b");
    let chosen = |state: &State| state.build.form().unwrap().chosen;
    for (key, at) in
        [("PgDn", 6), ("PgDn", 12), ("PgDn", 14), ("PgUp", 8), ("Home", 0), ("PgUp", 0), ("End", 14)]
    {
        press(&mut state, key);
        assert_eq!(chosen(&state), at, "{key}");
    }
}

/// Counts bytes.
#[derive(Clone, Default)]
struct Count(std::rc::Rc<std::cell::Cell<usize>>);

impl std::io::Write for Count {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.set(self.0.get() + bytes.len());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// How many bytes a terminal gets for each key: what differs from the frame before.
fn bytes(state: &mut State, keys: &str) -> Vec<usize> {
    let viewport = ratatui::Viewport::Fixed(ratatui::layout::Rect::new(0, 0, 80, 24));
    let count = Count::default();
    let backend = ratatui::backend::CrosstermBackend::new(count.clone());
    let mut terminal =
        ratatui::Terminal::with_options(backend, ratatui::TerminalOptions { viewport }).unwrap();
    let mut frame = |state: &State| {
        count.0.set(0);
        terminal.draw(|frame| crate::screen::view::draw(state, frame)).unwrap();
        count.0.get()
    };
    frame(state);
    let of_key = |key: &str| {
        press(state, key);
        frame(state)
    };
    keys.split(' ').map(of_key).collect()
}

/// More bytes than a line of 9600 baud takes in about a second.
const SLOW_LINE: usize = 1000;

#[test]
fn a_step_goes_over_a_slow_line() {
    let mut state = building("shaper");
    let mut check = |what: &str, begin: &str, keys: &str| {
        press(&mut state, begin);
        let all = bytes(&mut state, keys);
        assert!(all.iter().all(|count| (1..SLOW_LINE).contains(count)), "{what}: {all:?} bytes");
    };
    check("choose", "Tab", "Tab Right Left Up Down");
    check("move", "Esc Tab Tab Tab Tab g", "Up Up Right Left Down");
    check("fields", "Esc b", "Down Down Up 5 6 Down");
}
