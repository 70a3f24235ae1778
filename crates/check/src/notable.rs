//! The states of a motion in which rounding is greatest.

use assur_force::{AnalyzerPlugin, Kinetostatics, LaneKinetostatics, Loads, State};
use assur_group::Order;
use assur_kinematics::{LanePosition, Linkage};
use assur_number::{Lanes, Real};

/// Condition, PF1, PF2, balancing load and reaction.
const QUANTITIES: usize = 5;

/// The numbers of the states with the greatest condition (the sum of 1/determinant over the groups), the greatest PF1
/// and PF2 of a link, and with `forces` the greatest balancing load and the greatest reaction. States that can't be
/// solved are left out.
pub fn notable(
    linkage: &Linkage,
    forces: Option<(&Loads, &AnalyzerPlugin)>,
    mut states: impl Iterator<Item = (usize, State)>,
) -> Vec<usize> {
    let carrying = vec![true; linkage.groups().len()];
    let forces = forces.map(|(loads, method)| {
        LaneKinetostatics::new(Kinetostatics::new(linkage, loads, method.instance, &carrying))
    });
    let mut scan = Scan { linkage, position: linkage.lane_position(), forces, greatest: [None; QUANTITIES] };
    loop {
        let block: Vec<_> = states.by_ref().take(Lanes::WIDTH).collect();
        let Some(last) = block.last() else { break };
        scan.add(&block, &std::array::from_fn(|lane| block.get(lane).unwrap_or(last).1));
    }
    let mut numbers: Vec<usize> = scan.greatest.into_iter().flatten().map(|(_, number)| number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

/// The greatest values up to now.
struct Scan<'a> {
    linkage: &'a Linkage,
    position: LanePosition,
    forces: Option<LaneKinetostatics<'a>>,
    greatest: [Option<(f64, usize)>; QUANTITIES],
}

impl Scan<'_> {
    /// Adds up to eight numbered states; `states` has the last of them in the lanes that are left over.
    fn add(&mut self, numbered: &[(usize, State)], states: &[State; Lanes::WIDTH]) {
        let coordinates = Lanes::of(|lane| states[lane].coordinate);
        let unsolved = self.linkage.solve_lanes(coordinates, Order::Second, &mut self.position);
        let unsolved: Vec<usize> = unsolved.err().into_iter().flatten().map(|(lane, _)| lane).collect();
        let mut found = [[0.0; Lanes::WIDTH]; QUANTITIES];
        self.motion(&mut found);
        self.reactions(states, &mut found);
        for (lane, (number, _)) in numbered.iter().enumerate().filter(|(lane, _)| !unsolved.contains(lane)) {
            for (most, values) in self.greatest.iter_mut().zip(&found) {
                if values[lane] > most.map_or(0.0, |(value, _)| value) {
                    *most = Some((values[lane], *number));
                }
            }
        }
    }

    /// Condition, PF1 and PF2.
    fn motion(&self, [condition, first, second, ..]: &mut [[f64; Lanes::WIDTH]; QUANTITIES]) {
        let position = &self.position;
        condition.copy_from_slice(
            &position.health.iter().fold(Lanes::ZERO, |sum, h| sum + Lanes::ONE / h.abs()).0,
        );
        let by = Lanes::from_f64(1.0 / self.linkage.structure.scale);
        for body in position.bodies.iter().skip(1) {
            raise(first, (body.x1.abs() + body.y1.abs()) * by + body.w1.abs());
            raise(second, (body.x2.abs() + body.y2.abs()) * by + body.w2.abs() + body.w1 * body.w1);
        }
    }

    /// The balancing load and the reaction; zero where they are not determined.
    fn reactions(
        &mut self,
        states: &[State; Lanes::WIDTH],
        [.., balancing, greatest]: &mut [[f64; Lanes::WIDTH]; QUANTITIES],
    ) {
        let Some(forces) = &mut self.forces else { return };
        let refused = forces.solve(states, &self.position).err();
        raise(balancing, forces.reactions.balancing.abs());
        let by = Lanes::from_f64(1.0 / self.linkage.structure.scale);
        for wrench in &forces.reactions.pairs {
            raise(greatest, wrench.fx.abs() + wrench.fy.abs() + wrench.m.abs() * by);
        }
        for (lane, _) in refused.into_iter().flatten() {
            (balancing[lane], greatest[lane]) = (0.0, 0.0);
        }
    }
}

/// Replaces each number by the greater one of both.
fn raise(most: &mut [f64; Lanes::WIDTH], values: Lanes) {
    for (most, value) in most.iter_mut().zip(values.0) {
        *most = if value > *most { value } else { *most };
    }
}
