//! Lists to choose from, several views at once, and what closes what is open.

use assur_picture::Transfer;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::layout::Rect;

use super::{View, empty, opened, press, scene, settle, text, write};
use crate::number::number as plain;
use crate::screen::command;
use crate::screen::state::{Effect, PickerKind, State, ViewPart};
use crate::screen::view;

fn type_in(state: &mut State, letters: &str) {
    for letter in letters.chars() {
        press(state, if letter == ' ' { "Space".to_owned() } else { letter.to_string() }.as_str());
    }
}

#[test]
fn the_greatest_moment_of_a_guide_is_found_and_gone_to() {
    let mut state = opened("shaper");
    press(&mut state, "p");
    type_in(&mut state, "ram mom");
    press(&mut state, "Enter");
    assert_eq!(state.view, View::Curves);
    let found = state.found().unwrap();
    let guide = found
        .reactions
        .iter()
        .find(|reaction| reaction.of.as_ref().is_some_and(|of| of.0 == "ram/ground"))
        .unwrap();
    let moment = &found.series[guide.moment.unwrap()];
    assert_eq!(state.picked, std::slice::from_ref(&moment.short));
    let values: Vec<f64> = moment.course.nodes().iter().map(|node| node.value).collect();
    let line = moment.course.points([1.0; 2]);
    // The greatest moment is that of greatest modulus, whatever its sense; the other key goes on from extreme to extreme.
    let at = (0..values.len()).max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs())).unwrap();
    assert!(values[at] < 0.0);
    press(&mut state, "g");
    assert_eq!(state.position, at);
    let least = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap();
    let mut met = Vec::new();
    for _ in 0..12 {
        press(&mut state, "G");
        met.push(state.position);
    }
    assert!(met.contains(&at) && met.iter().any(|met| met.abs_diff(least) <= 1), "{least}: {met:?}");
    // The table has what lies between the positions too: extremes beyond those of the positions, means as by the trapezoidal rule
    // over the curve.
    let integral = |of: fn(f64) -> f64| {
        let pairs =
            line.windows(2).map(|two| (two[1][0] - two[0][0]) * (of(two[0][1]) + of(two[1][1])) / 2.0);
        pairs.sum::<f64>() / std::f64::consts::TAU
    };
    let (mean, rms) = (integral(|value| value), integral(|value| value * value).sqrt());
    let frame = text(&state, 100, 24);
    let row = frame.lines().find(|line| line.trim_start().starts_with("1 ram/ground")).unwrap();
    let shown: Vec<f64> = row.split_whitespace().filter_map(|word| word.parse().ok()).skip(1).collect();
    let [greatest, _, lowest, _, shown_mean, shown_rms] = shown[..] else { panic!("{row}") };
    assert!((0.0..1e-3 * values[least]).contains(&(greatest - values[least])), "{row}");
    assert!((0.0..-1e-3 * values[at]).contains(&(values[at] - lowest)), "{row}");
    assert!(
        (shown_mean - mean).abs() < 2e-3 * rms && (shown_rms - rms).abs() < 2e-3 * rms,
        "{mean} {rms}: {row}"
    );
}

#[test]
fn the_greatest_value_that_is_gone_to_is_that_of_the_table() {
    let mut compared = 0;
    for name in ["shaper", "conveyor", "four-bar"] {
        let mut state = opened(name);
        let found = state.found().unwrap();
        let best = |series: &assur_picture::Series| {
            let range = found.range(series)?;
            let is_sense = assur_book::catalogue::sign_is_sense(series.column);
            let by_modulus = if range.least.value.abs() > range.greatest.value.abs() {
                range.least
            } else {
                range.greatest
            };
            Some((
                series.short.clone(),
                series.unit.factor * if is_sense { by_modulus } else { range.greatest }.value,
            ))
        };
        let all: Vec<_> =
            found.series.iter().filter_map(best).filter(|(_, best)| best.abs() > 1e-6).collect();
        for (short, best) in all {
            state.view = View::Curves;
            state.picked = vec![short.clone()];
            press(&mut state, "g");
            let frame = text(&state, 160, 24);
            assert!(frame.contains(&plain(best)), "{name} {short}: {best}\n{frame}");
            compared += 1;
        }
    }
    assert!(compared > 60, "{compared}");
}

#[test]
fn several_quantities_of_one_unit_share_a_chart() {
    let mut state = opened("shaper");
    press(&mut state, "p");
    type_in(&mut state, "K vel");
    press(&mut state, "Tab Tab Enter");
    assert_eq!(state.picked, ["K.vx", "K.vy"], "a word that is a name goes before letters in other words");
    let figure = view::figure(&state, View::Curves).unwrap();
    assert_eq!(figure.panels.len(), 1);
    press(&mut state, "p");
    type_in(&mut state, "balancing");
    press(&mut state, "Enter Down");
    assert_ne!(state.picked, ["balancing load"], "the next quantity of all");
    press(&mut state, "Up");
    assert_eq!(state.picked, ["balancing load"]);
    press(&mut state, "Esc");
    assert!(state.picked.is_empty() && text(&state, 80, 24).contains("PF0"));
}

#[test]
fn escape_and_control_g_close_whatever_is_open() {
    for key in ["Esc", "C-g"] {
        let mut state = opened("shaper");
        let before = text(&state, 80, 24);
        for open in ["?", ":", "/", "p", "o", "n", "e", "? / q", ": v i e w", "9 Tab 1"] {
            press(&mut state, open);
            press(&mut state, key);
            if open.starts_with('9') {
                press(&mut state, &format!("9 {key} 1"));
            }
            assert_eq!(text(&state, 80, 24), before, "{open} {key}");
        }
    }
}

#[test]
fn a_search_may_begin_with_any_letter() {
    let mut state = opened("shaper");
    press(&mut state, "? / q u i t");
    assert_eq!(state.help.as_ref().unwrap().filter.text.to_string(), "quit");
    press(&mut state, "Esc p q");
    assert_eq!(state.picker.as_ref().unwrap().filter.text.to_string(), "q");
    press(&mut state, "Esc ? m a x i m u m");
    assert!(text(&state, 80, 24).contains("greatest"), "other words for it find a command");
    press(&mut state, "Esc ? d e t e r m");
    assert!(text(&state, 80, 24).contains("singular position"), "words of the field are explained");
}

#[test]
fn the_list_of_scenes_is_no_trap() {
    let mut state = opened("shaper");
    let before = text(&state, 80, 24);
    write(&mut state, ":value link.crank.points.A 101 mm");
    press(&mut state, "o q");
    assert!(state.picker.is_none() && state.effects.is_empty(), "q closes the list, not the program");
    press(&mut state, "u o");
    type_in(&mut state, "fb");
    press(&mut state, "Esc");
    assert_eq!(text(&state, 80, 24), before);
    let mut state = empty(None);
    command::start(&mut state);
    settle(&mut state);
    press(&mut state, "Esc");
    assert!(state.picker.is_some(), "there is nothing behind it");
    write(&mut state, ":view mechanism");
    assert!(text(&state, 80, 24).contains("no scene is open"));
    type_in(&mut state, "press-compr");
    press(&mut state, "Enter");
    assert_eq!(state.scene.as_ref().unwrap().session.source.name(), "press-compression.toml");
    assert!(state.picker.is_none());
}

#[test]
fn each_view_keeps_its_part_and_shows_none_that_is_empty() {
    let mut state = opened("shaper");
    press(&mut state, "3 Tab Tab Tab");
    assert_eq!(state.part(View::Forces), ViewPart::Hodograph);
    // The balancing load has no direction, hence no hodograph.
    press(&mut state, "Up");
    assert_eq!(state.part(View::Forces), ViewPart::Overview);
    let parts: Vec<ViewPart> = (0..4)
        .map(|_| {
            press(&mut state, "Tab");
            assert!(text(&state, 80, 24).lines().skip(3).take(18).any(|line| !line.trim().is_empty()));
            state.part(View::Forces)
        })
        .collect();
    assert!(!parts.contains(&ViewPart::Hodograph), "{parts:?}");
    press(&mut state, "4 Tab");
    assert_eq!(
        (state.part(View::Plans), state.part(View::Motion)),
        (ViewPart::Velocities, ViewPart::Overview)
    );
}

#[test]
fn the_open_list_of_values_leaves_the_balancing_load_in_sight() {
    let mut state = opened("shaper");
    press(&mut state, "3 e");
    assert!(text(&state, 80, 24).contains("balancing load"));
}

#[test]
fn views_beside_each_other_move_together() {
    let mut state = opened("shaper");
    for (size, least) in [((80, 24), 1), ((119, 60), 1), ((120, 40), 3), ((200, 60), 4)] {
        state.size = size;
        let areas = view::areas(&state);
        assert_eq!(areas.len(), least, "{size:?}");
        let sum: u32 = areas.iter().map(|(_, area)| area.area()).sum();
        assert_eq!(sum, u32::from(size.0) * u32::from(size.1 - 4), "nothing is left free, nothing overlaps");
    }
    let beside = |state: &State| {
        let body = Rect::new(100, 2, 100, 54);
        let frame = super::frame(state, 200, 60);
        body.positions().map(|at| frame[at].symbol().to_owned()).collect::<String>()
    };
    let before = beside(&state);
    press(&mut state, "Right");
    assert_ne!(beside(&state), before);
    write(&mut state, ":panels table checks");
    assert!(beside(&state).contains("residual"));
    write(&mut state, ":panels tabel");
    assert!(text(&state, 200, 60).contains("did you mean `table`?"));
    press(&mut state, "P");
    assert_eq!(view::areas(&state).len(), 1);
}

#[test]
fn a_pasted_text_is_written_and_never_run() {
    let mut state = opened("shaper");
    command::paste(&mut state, "q\n1e5\u{1b}[A");
    assert_eq!(state.prompt.as_ref().unwrap().text.to_string(), "q 1e5 [A");
    assert!(state.effects.is_empty());
    press(&mut state, "Esc p");
    command::paste(&mut state, "ram ");
    assert_eq!(state.picker.as_ref().unwrap().filter.text.to_string(), "ram");
    press(&mut state, "Esc ?");
    command::paste(&mut state, "q");
    assert_eq!(state.help.as_ref().unwrap().filter.text.to_string(), "q");
}

#[test]
fn the_motion_plays_between_the_positions() {
    let mut state = opened("shaper");
    press(&mut state, ", , Space");
    let still = text(&state, 80, 24);
    state.advance();
    assert_eq!((state.position, state.phase), (0, 4));
    assert_ne!(text(&state, 80, 24), still);
    (0..3).for_each(|_| state.advance());
    assert_eq!((state.position, state.phase), (1, 0));
    press(&mut state, ". . . .");
    state.advance();
    assert_eq!(state.position, 5);
    press(&mut state, "x x");
    assert_ne!(text(&state, 80, 24), still, "trails");
}

#[test]
fn a_moved_point_describes_its_path() {
    let mut state = opened("four-bar");
    press(&mut state, "n");
    let scene = state.scene.as_ref().unwrap();
    let mut probe = state.probe.unwrap();
    // On the crank the path is a circle about its pin, whose radius is the distance from the pin.
    probe.link = scene.linkage.mechanism.input.first().link;
    let (pose, place) = (scene.pose(0, 0.0).unwrap(), [0.03, 0.04]);
    probe.put(&pose, place);
    let there = pose.bodies[probe.link].point(probe.at);
    assert!((there[0] - place[0]).hypot(there[1] - place[1]) < 1e-15);
    let center = pose.bodies[0].point(scene.linkage.mechanism.points[0].places[0].at);
    let radius = (place[0] - center[0]).hypot(place[1] - center[1]);
    for at in probe.path(scene) {
        assert!(((at[0] - center[0]).hypot(at[1] - center[1]) - radius).abs() < 1e-14, "{at:?}");
    }
    state.probe = Some(probe);
    let frame = text(&state, 80, 24);
    assert!(frame.contains(&format!("{} mm", crate::number::digits(1e3 * radius, 5))), "{frame}");
    press(&mut state, "Up Left Tab");
    assert_ne!(state.probe.unwrap().link, probe.link);
}

#[test]
fn the_structure_is_joined_group_by_group() {
    let mut state = opened("shaper");
    press(&mut state, "9 Tab");
    let links = |state: &State| {
        let figure = view::figure(state, View::Structure).unwrap();
        let inks = figure.panels[0].items.iter().filter_map(|item| match item {
            assur_figure::Item::Line { ink, stroke: assur_figure::Stroke::Thick, .. }
            | assur_figure::Item::Area { ink, .. } => Some(*ink),
            _ => None,
        });
        inks.count()
    };
    let counts: Vec<usize> = (0..4)
        .map(|_| {
            let count = links(&state);
            press(&mut state, "Tab");
            count
        })
        .collect();
    assert!(counts[0] < counts[1] && counts[1] < counts[2] && counts[3] == counts[0], "{counts:?}");
}

#[test]
fn a_motor_is_taken_into_the_scene() {
    let own = assur_fixtures::scene("shaper-drive");
    let motor = own.lines().find(|line| line.starts_with("motor = ")).unwrap();
    let mut state = scene(&own.replace(motor, "motor = \"auto\"\ncatalogue = \"4A\""));
    press(&mut state, "6 p");
    let picker = state.picker.as_ref().unwrap();
    assert_eq!(picker.kind, PickerKind::Motors);
    let designation = picker.rows[1].name.clone();
    press(&mut state, "Down Enter");
    let dynamics = state.found().unwrap().analysis.dynamics.as_ref().unwrap();
    assert_eq!(dynamics.motor.as_ref().unwrap().motor.designation, designation);
    press(&mut state, "u");
    assert_eq!(state.draft.changes(), 0);
    write(&mut state, ":motors 3 kW, 1000 rpm");
    let picker = state.picker.as_ref().unwrap();
    assert!(
        picker
            .rows
            .iter()
            .all(|row| row.text.split_whitespace().nth(2).unwrap().parse::<f64>().unwrap() >= 3.0)
    );
    write(&mut state, "");
    press(&mut opened("shaper"), "6 p");
}

#[test]
fn the_working_is_that_of_the_position() {
    let mut state = opened("shaper");
    press(&mut state, "W");
    assert!(text(&state, 80, 24).contains("working of position 0"));
    press(&mut state, "Right");
    assert!(text(&state, 80, 24).contains("working of position 1"));
    write(&mut state, "/balancing");
    assert!(text(&state, 80, 24).to_lowercase().contains("balancing"));
    press(&mut state, "Home End PgUp");
}

#[test]
fn a_group_whose_name_is_wider_than_its_column_is_seen_to_be_cut() {
    let mut state = opened("contour");
    state.view = View::Structure;
    let shown = text(&state, 80, 24);
    let heading = shown.lines().find(|row| row.starts_with(" > group 1 (RR-RR-RR/IV")).unwrap();
    assert!(heading.contains('…'), "{heading}");
}

#[test]
fn a_picked_quantity_has_the_mean_of_the_first_page() {
    for scene in ["shaper", "shaper-friction", "slider-crank"] {
        let state = opened(scene);
        let found = state.found().unwrap();
        let range = found.range(found.balancing().unwrap()).unwrap();
        assert_eq!(range.means, found.analysis.peaks.balancing, "{scene}");
        let most = found.analysis.peaks.of(assur_analysis::results::Column::BALANCING).unwrap();
        let size = range.greatest.value.abs().max(range.least.value.abs());
        assert!((size - most.value.abs()).abs() <= 1e-9 * size, "{scene}");
    }
}

#[test]
fn a_rotor_that_counts_as_massless_is_told_in_a_transient_motion() {
    // The catalogue 4A has no moments of inertia.
    let state = opened("compressor-start");
    let notes: Vec<String> =
        state.found().unwrap().analysis.warnings.iter().map(|note| note.text.to_string()).collect();
    assert!(notes.iter().any(|note| note.contains("4A100L4") || note.contains("4А100L4")), "{notes:?}");
}

#[test]
fn the_end_of_a_cycle_is_not_called_its_first_position() {
    let mut state = opened("shaper");
    press(&mut state, "t g");
    let frame = text(&state, 100, 24);
    // The coordinate is 0 in position 0, and 360 deg only at the end.
    assert!(frame.contains("360.000 deg at 360") && !frame.contains("in position 0"), "{frame}");
}

#[test]
fn rows_out_of_sight_are_counted_and_reached() {
    let mut state = opened("six-links");
    press(&mut state, "3");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("1-7 / 10") && frame.contains("█") && !frame.contains("V on right"), "{frame}");
    press(&mut state, "Down Down Down Down Down Down Down Down Down");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("4-10 / 10") && frame.contains("V on right"), "{frame}");
    // All vectors of a plan, before the plan of the next group.
    press(&mut state, "4");
    assert!(!text(&state, 80, 24).contains(" R17 "));
    press(&mut state, "Down Down");
    let frame = text(&state, 80, 24);
    assert!(frame.contains(" R17 ") && frame.contains("group 1"), "{frame}");
    press(&mut state, "Down");
    assert!(text(&state, 80, 24).contains("input link"));
    press(&mut state, "Up");
    let frame = text(&state, 80, 24);
    assert!(frame.contains("F2 ") && !frame.contains("input link"), "{frame}");
}

#[test]
fn escape_leaves_the_first_list_and_tab_names_no_scene() {
    let mut state = empty(None);
    command::start(&mut state);
    press(&mut state, "Tab");
    assert_eq!(state.prompt.as_ref().map(|prompt| &*prompt.text), Some("open "));
    press(&mut state, "Esc");
    assert!(state.picker.is_some() && state.prompt.is_none());
    command::press(&mut state, KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
    assert!(matches!(state.effects[..], [Effect::Quit]));
}

#[test]
fn the_singular_places_of_the_last_group_are_seen() {
    for name in ["six-links", "triad", "contour", "conveyor", "shaper"] {
        let mut state = opened(name);
        press(&mut state, "9");
        let groups = state.scene.as_ref().unwrap().linkage.structure.groups.len();
        (1..groups).for_each(|_| press(&mut state, "Down"));
        let singular = &state.scene.as_ref().unwrap().linkage.structure.groups[groups - 1].plugin.singular;
        let told = state.told(singular);
        let frame = text(&state, 80, 24);
        let last = told.split_whitespace().next_back().unwrap();
        let left: String = frame
            .lines()
            .skip(6)
            .map(|line| line.chars().take(45).chain(['\n']).collect::<String>())
            .collect();
        assert!(left.contains(last) && left.contains("> "), "{name}: {last}: {frame}");
    }
}

#[test]
fn all_that_is_told_of_a_group_can_be_scrolled_to() {
    for name in ["triad", "six-links", "contour", "shaper"] {
        let mut state = opened(name);
        press(&mut state, "9");
        let scene = state.scene.as_ref().unwrap();
        let area = view::room(&state);
        let told = view::structure::of_groups(&state, scene, area);
        assert!(told.iter().any(|line| line.contains("source")), "{told:?}");
        let mut seen = String::new();
        for _ in 0..told.len() + scene.linkage.structure.groups.len() {
            seen += &text(&state, 80, 24);
            press(&mut state, "Down");
        }
        for line in told {
            assert!(seen.contains(line.trim_matches([' ', '>'])), "{name}: {line}\n{}", text(&state, 80, 24));
        }
    }
}

#[test]
fn the_events_of_the_cycle_are_bands_and_enter_goes_there() {
    let mut state = opened("shaper-friction");
    press(&mut state, "9 b");
    let events = state.found().unwrap().events.clone();
    let frame = text(&state, 80, 24);
    assert!(frame.contains("mode 1 of group 1") && frame.contains("self-locking"), "{frame}");
    // A place where the force of a guide changes its sign: between the position reached and one beside it.
    let at = events.iter().position(assur_report::topic::Event::is_place).unwrap();
    (0..at).for_each(|_| press(&mut state, "Down"));
    press(&mut state, "Enter");
    assert!(text(&state, 80, 24).contains("changes side"));
    let scene = state.scene.as_ref().unwrap();
    let here = scene.linkage.mechanism.input.coordinate(state.position);
    let step = std::f64::consts::TAU / 24.0;
    assert!((here - events[at].ends[0]).abs() <= 0.5 * step + 1e-12, "{here} {:?}", events[at]);
    let bands = view::figure(&state, View::Structure).unwrap();
    assert_eq!(bands.legend.len(), events.iter().map(|event| event.band).max().unwrap());
    press(&mut state, "b");
    assert!(text(&state, 80, 24).contains("Formula") || text(&state, 80, 24).contains("I(ground"));
}

#[test]
fn every_quantity_beside_the_mechanism_comes_in_sight() {
    for name in ["jansen", "six-links", "n-four-bar-40"] {
        let mut state = opened(name);
        press(&mut state, "1");
        let frame = text(&state, 80, 24);
        let scene = state.scene.as_ref().unwrap();
        // The chosen one has its whole name.
        let names =
            |one: &Transfer| [&scene.series[one.orders[0]].head, &one.name].map(|text| state.told(text));
        let heads: Vec<[String; 2]> = scene.transfers.iter().map(names).collect();
        assert!(frame.contains(&format!("/ {}", heads.len() - 1)), "{frame}");
        let mut seen = String::new();
        for _ in 0..heads.len() {
            seen += &text(&state, 80, 24);
            press(&mut state, "Down");
        }
        for head in heads {
            assert!(
                head.iter()
                    .any(|head| seen.contains(&format!("{head} ")) || seen.contains(&format!("{head}\n"))),
                "{name}: {head:?}"
            );
        }
    }
}

/// Two turns of the crank, whose events have coordinates of the cycle, are shown at instants over time.
#[test]
fn an_event_leads_to_the_instant_that_is_nearest_in_the_cycle() {
    let mut state = opened("compressor-start");
    press(&mut state, "9 b");
    let events = state.found().unwrap().events.clone();
    for (number, event) in events.iter().enumerate() {
        state.position = 100;
        state.chosen.event = number;
        press(&mut state, "Enter");
        let scene = state.scene.as_ref().unwrap();
        let cycle = scene.linkage.mechanism.input.period().unwrap();
        let apart = |sample: usize| {
            let away = (scene.coordinate(sample) - event.ends[0]).rem_euclid(cycle);
            away.min(cycle - away)
        };
        let least = (0..scene.positions()).map(apart).fold(f64::INFINITY, f64::min);
        assert!(apart(state.position) <= least + 1e-9, "{event:?}: {}", state.position);
    }
    assert!(!events.is_empty());
}
