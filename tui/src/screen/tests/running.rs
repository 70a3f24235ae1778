//! Work beside the screen: counted, stopped, and dropped where nobody waits for it.

use assur_analysis::results::Checks;

use super::{opened, press, text};
use crate::screen::state::{Effect, Job, Outcome, Report, State};
use crate::screen::{command, work};

/// What was asked for and is not done yet.
fn job(state: &mut State) -> Job {
    let effect = state.effects.pop().unwrap();
    assert!(state.effects.is_empty());
    match effect {
        Effect::Work(job) => job,
        other => panic!("{other:?}"),
    }
}

fn number(state: &State) -> usize {
    state.running[0].number
}

#[test]
fn a_count_is_shown_with_the_key_that_stops() {
    let mut state = opened("shaper");
    assert!(state.running.is_empty());
    command::start(&mut state);
    assert!(text(&state, 80, 24).contains("calculating ...  (Esc stops)"));
    let number = number(&state);
    assert!(command::take(
        &mut state,
        Report::Calculated(number, Outcome::Count(assur_words::name("position 3 of 48")))
    ));
    assert!(text(&state, 80, 24).contains("calculating: position 3 of 48  (Esc stops)"));
    assert!(!command::take(
        &mut state,
        Report::Calculated(number + 1, Outcome::Count(assur_words::name("late")))
    ));
}

#[test]
fn an_analysis_that_is_stopped_ends_and_its_answer_is_dropped() {
    for key in ["Esc", "C-g"] {
        let mut state = opened("shaper");
        command::start(&mut state);
        let job = job(&mut state);
        let number = number(&state);
        press(&mut state, key);
        assert!(text(&state, 80, 24).contains("stopped; r calculates again"), "{key}");
        // The worker sees the sign: it has nothing to tell.
        let answer = work::run(&job, &|report| panic!("{report:?}"));
        assert!(matches!(&answer, Report::Calculated(_, Outcome::Failed(_))), "{answer:?}");
        assert!(!command::take(&mut state, answer));
        assert!(!command::take(&mut state, Report::Calculated(number, Outcome::Checks(Checks::default()))));
        // What was found before stays.
        assert!(!state.scene.as_ref().unwrap().found.as_ref().unwrap().analysis.checks.is_empty());
    }
}

#[test]
fn only_the_last_question_is_answered() {
    let mut state = opened("shaper");
    command::start(&mut state);
    let first = job(&mut state);
    command::start(&mut state);
    assert_eq!(state.running.len(), 1);
    let answer = work::run(&first, &|report| panic!("{report:?}"));
    assert!(!command::take(&mut state, answer));
}

#[test]
fn reading_again_goes_on_after_a_stop() {
    let mut state = opened("shaper");
    state.scene.as_mut().unwrap().found = None;
    command::start(&mut state);
    state.effects.clear();
    press(&mut state, "Esc 5");
    assert!(text(&state, 80, 24).contains("no analysis: stopped"));
    press(&mut state, "r");
    assert!(text(&state, 80, 24).contains("reduced inertia J"));
}
