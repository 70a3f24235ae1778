//! What is said of dry friction: pairs that never move, positions of no relative speed, several solutions.

use assur_force::{Cause, LoadState};
use assur_group::Order;
use assur_mechanism::{Contact, LoadId, Name};
use assur_number::{ROUNDING, elementary};
use assur_words::{Text, number, text};

use super::Listed;
use crate::{Calculation, several::Several};

impl Calculation {
    /// Pairs with friction that rest, always or in some positions, and positions with several solutions.
    pub(super) fn friction_of_pairs(&self, several: &[Several]) -> Vec<Text> {
        let Some(frictions) = self.loads.as_ref().and_then(|loads| loads.frictions()) else {
            return Vec::new();
        };
        let mechanism = &self.linkage.mechanism;
        let input = &mechanism.input;
        let mut notes = Vec::new();
        for bearing in &frictions.bearings {
            let named = |link: usize| Text::from(&mechanism.links[link].name);
            let (pair, link, on) =
                (mechanism.pair_name(bearing.pair), named(bearing.link), named(bearing.on));
            if bearing.rests() {
                notes.push(text!("analysis-friction-rests", pair, link, on));
                continue;
            }
            let turning = (0..input.positions)
                .filter(|index| bearing.turns_at(input.coordinate(*index), input.period()));
            let turning: Listed = turning.collect();
            let note = |positions| text!("analysis-friction-turns", pair, link, on, positions);
            notes.extend(turning.note(note));
        }
        let mut add = |said: fn(&Several) -> bool, note: fn(Text) -> Text| {
            let found: Listed = several.iter().filter(|one| said(one)).map(|one| one.index).collect();
            notes.extend(found.note(note));
        };
        add(|one| one.solutions.len() > 1, |positions| text!("analysis-friction-several", positions));
        add(|one| one.continuum, |positions| text!("analysis-friction-continuum", positions));
        add(|one| !one.proved, |positions| text!("analysis-friction-not-proved", positions));
        notes
    }

    /// Where a friction whose sign is given pushes with the sliding, and where one against the sliding has nothing to oppose.
    pub(super) fn friction_of_contacts(&self) -> Vec<Text> {
        let loads = self.linkage.mechanism.loads.iter().enumerate();
        let rough = loads.filter_map(|(id, load)| {
            let contact = load.kind.contact().filter(|contact| contact.friction != 0.0)?;
            self.friction(id, &load.name, contact)
        });
        rough.collect()
    }

    fn friction(&self, id: LoadId, name: &Name, contact: &Contact) -> Option<Text> {
        let count = self.linkage.mechanism.input.positions;
        let (mut pushing, mut rolling, mut known) = (Listed::default(), Listed::default(), 0);
        for index in 0..count {
            let Some([sliding, friction]) = self.sliding(id, contact, index) else { continue };
            known += 1;
            if sliding == 0.0 {
                rolling.add(index);
            } else if sliding * friction > 0.0 {
                pushing.add(index);
            }
        }
        if contact.against_sliding && rolling.count() == known && known > 0 {
            return Some(text!("analysis-arc-never-slides", contact = name));
        }
        if contact.against_sliding {
            return rolling.note(|positions| text!("analysis-arc-rolls", contact = name, positions));
        }
        let friction = number(contact.friction.abs());
        pushing.note(|positions| text!("analysis-friction-pushes", contact = name, positions, friction))
    }

    /// Sliding of the arc along its line in the direction of motion, and the friction along it, N; `None` where there is no contact.
    fn sliding(&self, id: LoadId, contact: &Contact, index: usize) -> Option<[f64; 2]> {
        let (linkage, loads) = (&self.linkage, self.loads.as_ref()?);
        let mut position = linkage.position();
        linkage.solve_index(index, Order::First, &mut position).ok()?;
        let state = LoadState::prescribed(&linkage.mechanism, position.coordinate);
        let [angle, friction] = loads.contact(id, &state)?;
        let mut force = None;
        loads.sizes(&state, &position.bodies, |cause, size| {
            if cause == Cause::Load(id) {
                force = Some(size);
            }
        });
        let body = &position.bodies[contact.center.link];
        let ([sin, cos], center) =
            ([elementary::sin(angle), elementary::cos(angle)], body.first(body.arm(contact.center.at)));
        let [own, turned] = [center[0] * cos - center[1] * sin, contact.radius * body.w1];
        let rolls = (own + turned).abs() <= ROUNDING * (own.abs() + turned.abs());
        let sense = if state.speed == 0.0 { linkage.mechanism.input.sign() } else { state.speed.signum() };
        Some([if rolls { 0.0 } else { sense * (own + turned) }, friction * force?])
    }
}
