//! The states of a motion in which rounding is greatest.

use assur_force::Reactions;
use assur_kinematics::{LanePosition, Linkage};
use assur_number::{Lanes, Real};

/// The greatest values in the states that were added, each with the number of the first state that has it: of the condition
/// (the sum of 1/determinant over the groups), of PF1 and PF2 of a link, of the balancing load and of a reaction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Notable([Option<(f64, usize)>; 5]);

/// Eight values of which each is the greatest up to now.
type Most = [f64; Lanes::WIDTH];

impl Notable {
    /// Adds the states of some lanes of eight solved positions; their numbers follow `first`. `forces`: their balancing
    /// loads and reactions, and the lanes in which they are determined.
    pub fn add(
        &mut self,
        linkage: &Linkage,
        first: usize,
        (lanes, position): ([bool; Lanes::WIDTH], &LanePosition),
        forces: Option<([bool; Lanes::WIDTH], &Reactions<Lanes>)>,
    ) {
        let by = Lanes::from_f64(1.0 / linkage.structure.scale);
        let health = position.health.iter();
        let condition = health.fold(Lanes::ZERO, |sum, health| sum + Lanes::ONE / health.abs()).0;
        let [mut pf1, mut pf2, mut balancing, mut reaction] = [[0.0; Lanes::WIDTH]; 4];
        for body in position.bodies.iter().skip(1) {
            raise(&mut pf1, (body.x1.abs() + body.y1.abs()) * by + body.w1.abs());
            raise(&mut pf2, (body.x2.abs() + body.y2.abs()) * by + body.w2.abs() + body.w1 * body.w1);
        }
        if let Some((determined, reactions)) = forces {
            raise(&mut balancing, reactions.balancing.abs());
            for wrench in &reactions.pairs {
                raise(&mut reaction, wrench.fx.abs() + wrench.fy.abs() + wrench.m.abs() * by);
            }
            for lane in (0..Lanes::WIDTH).filter(|&lane| !determined[lane]) {
                (balancing[lane], reaction[lane]) = (0.0, 0.0);
            }
        }
        for (most, values) in self.0.iter_mut().zip([condition, pf1, pf2, balancing, reaction]) {
            for lane in (0..Lanes::WIDTH).filter(|&lane| lanes[lane]) {
                keep(most, Some((values[lane], first + lane)));
            }
        }
    }

    /// Adds what was found in the states after these.
    pub fn append(&mut self, next: &Self) {
        self.0.iter_mut().zip(&next.0).for_each(|(most, next)| keep(most, *next));
    }

    /// The numbers of the states, increasing.
    pub fn numbers(&self) -> Vec<usize> {
        let mut numbers: Vec<usize> = self.0.iter().flatten().map(|(_, number)| *number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    }
}

/// Keeps the greater value; the first of equals, and none that is zero.
fn keep(most: &mut Option<(f64, usize)>, next: Option<(f64, usize)>) {
    let value = |of: Option<(f64, usize)>| of.map_or(0.0, |(value, _)| value);
    if value(next) > value(*most) {
        *most = next;
    }
}

/// Replaces each number by the greater one of both.
fn raise(most: &mut Most, values: Lanes) {
    for (most, value) in most.iter_mut().zip(values.0) {
        *most = if value > *most { value } else { *most };
    }
}
