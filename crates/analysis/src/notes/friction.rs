//! What is said of dry friction: pairs that never move, positions of no relative speed, several solutions.

use assur_mechanism::Notice;
use assur_structure::name_of;
use assur_words::{Text, text};

use super::Listed;
use crate::Calculation;
use crate::friction::Several;

impl Calculation {
    /// Pairs with friction that rest, always or in some positions, and positions with several solutions.
    pub(crate) fn friction_notes(&self, several: &[Several]) -> Vec<Notice> {
        let Some(frictions) = self.loads.as_ref().and_then(|loads| loads.frictions()) else {
            return Vec::new();
        };
        let mechanism = &self.linkage.mechanism;
        let input = &mechanism.input;
        let mut notes = Vec::new();
        for rub in &frictions.rubs {
            let named = |link: usize| Text::from(&mechanism.links[link].name);
            let (pair, link, on) = (name_of(mechanism, rub.pair), named(rub.link), named(rub.on));
            if rub.rests() {
                notes.push(text!("analysis-friction-rests", pair, link, on).into());
                continue;
            }
            let turning =
                (0..input.positions).filter(|index| rub.turns_at(input.coordinate(*index), input.period()));
            let turning: Listed = turning.collect();
            if !turning.is_empty() {
                let positions = turning.words();
                notes.push(text!("analysis-friction-turns", pair, link, on, positions).into());
            }
        }
        let mut add = |said: fn(&Several) -> bool, note: fn(Text) -> Text| {
            let found: Listed = several.iter().filter(|one| said(one)).map(|one| one.index).collect();
            if !found.is_empty() {
                notes.push(note(found.words()).into());
            }
        };
        add(|one| one.solutions.len() > 1, |positions| text!("analysis-friction-several", positions));
        add(|one| one.continuum, |positions| text!("analysis-friction-continuum", positions));
        add(|one| !one.proved, |positions| text!("analysis-friction-not-proved", positions));
        notes
    }
}
