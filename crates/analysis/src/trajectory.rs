//! The course over time: every sample of a transient motion, one cycle of a steady one.

use std::ops::ControlFlow;

use crate::results::{Named, Spot, Trajectory};
use assur_force::State;
use assur_kinematics::Position;

use crate::angles::Angles;
use crate::forces::Forces;
use crate::names::Names;
use crate::{Course, Progress, Study, motions};

/// Rows over one cycle of a steady regime, the end included.
const ROWS: u32 = 360;

/// Samples of a motion that have no forces.
#[derive(Debug, Default)]
pub(crate) struct Lost {
    /// Where the mechanism stands at a change point.
    pub(crate) at_change_points: usize,
    /// Where the method refuses.
    pub(crate) refused: usize,
    /// What it says at the first of them.
    pub(crate) reason: Option<String>,
}

impl Lost {
    fn refuse(&mut self, reason: String) {
        self.refused += 1;
        self.reason.get_or_insert(reason);
    }
}

impl Study {
    /// The states that a trajectory goes through, in order of time; empty with a prescribed motion.
    pub(crate) fn states(&self) -> Vec<State> {
        match &self.course {
            Course::Prescribed => Vec::new(),
            Course::Transient(found) => {
                let each = found.trajectory.samples.iter().map(|sample| State {
                    coordinate: sample.coordinate,
                    speed: sample.speed,
                    acceleration: sample.acceleration,
                    time: sample.time,
                });
                each.collect()
            }
            Course::Steady(found) => {
                let input = &self.linkage.mechanism.input;
                let cycle = input.sign() * input.period().unwrap_or(0.0);
                let end = found.regime.cycle_time;
                let each = (0..=ROWS).map(|i| {
                    let state = self.state(input.from + cycle * (f64::from(i) / f64::from(ROWS)));
                    // The end of the cycle is its start, one cycle later.
                    if i == ROWS { State { time: end, ..state } } else { state }
                });
                each.collect()
            }
        }
    }

    /// The course over time, with forces for a transient motion, whose positions have none; and where they are missing.
    pub(crate) fn trajectory<B>(
        &self,
        watch: &mut impl FnMut(Progress) -> ControlFlow<B>,
    ) -> ControlFlow<B, (Vec<Trajectory>, Lost)> {
        let (linkage, plan) = (&self.linkage, &self.plan);
        let names = Names::of(&linkage.mechanism);
        let mut angles = Angles::new(linkage);
        let mut position = linkage.position();
        let transient = matches!(self.course, Course::Transient(_));
        let mut forces = match (&self.loads, self.analyzer) {
            (Some(loads), Some(analyzer)) if transient => {
                Some(Forces::new(linkage, loads, analyzer, &plan.groups_carrying))
            }
            _ => None,
        };
        let (mut rows, mut lost) = (Vec::new(), Lost::default());
        let states = self.states();
        let total = states.len();
        for (done, state) in states.into_iter().enumerate() {
            watch(Progress::Instants { done, total })?;
            if linkage.solve(state.coordinate, plan.order, &mut position).is_err() {
                continue;
            }
            let mut row = self.instant(&state, &position, &names, &mut angles);
            if linkage.is_at_change_point(&position) {
                lost.at_change_points += usize::from(forces.is_some());
            } else if let Some(forces) = &mut forces {
                match forces.solve(&state, &position, &plan.wanted, &names) {
                    Ok((reactions, balancing)) => {
                        row.reactions = reactions;
                        row.balancing = Some(balancing);
                    }
                    Err(error) => lost.refuse(error.to_string()),
                }
            }
            rows.push(row);
        }
        ControlFlow::Continue((rows, lost))
    }

    /// How links move at one instant; in a transient motion points and slides too, with velocities and accelerations.
    fn instant(&self, state: &State, position: &Position, names: &Names, angles: &mut Angles) -> Trajectory {
        let (linkage, wanted) = (&self.linkage, &self.plan.wanted);
        let followed = angles.follow(linkage, position, &wanted.links);
        let mut row = Trajectory {
            time: state.time,
            coordinate: state.coordinate,
            speed: state.speed,
            acceleration: state.acceleration,
            links: motions::links(linkage, wanted, names, position, followed),
            ..Trajectory::default()
        };
        if matches!(self.course, Course::Transient(_)) {
            let points = motions::points(linkage, wanted, names, position);
            let slides = motions::slides(linkage, wanted, names, position);
            let all = (&row.links, &points, &slides);
            row.velocities = Some(motions::rates(all, state.speed, state.acceleration, false));
            row.accelerations = Some(motions::rates(all, state.speed, state.acceleration, true));
            let spots = points.0.into_iter().map(|(name, point)| (name, Spot { pf0: point.pf0 }));
            row.points = Named(spots.collect());
            row.slides = slides;
        }
        row
    }
}
