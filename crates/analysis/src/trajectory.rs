//! The motion over time: every sample of a transient motion, one cycle of a steady one.

use assur_dynamics::Instant;
use assur_force::State;

use crate::motion::CYCLE_INTERVALS;
use crate::progress::{Stopped, Watch, step};
use crate::reader::Reader;
use crate::results::{MotionSample, Named, PointPosition};
use crate::{Calculation, InputMotion, Progress};

/// Samples of a motion that have no forces.
#[derive(Debug, Default)]
pub(crate) struct WithoutForces {
    /// How many of them are at a change point.
    pub(crate) at_change_points: usize,
    /// For how many of them the method fails.
    pub(crate) refused: usize,
    /// The error of the method at the first of them.
    pub(crate) reason: Option<String>,
}

impl Calculation {
    /// The states of a trajectory, in order of time; empty with a prescribed motion.
    pub(crate) fn states(&self) -> Vec<State> {
        self.instants().into_iter().map(|instant| instant.state).collect()
    }

    fn instants(&self) -> Vec<Instant> {
        match &self.motion {
            InputMotion::Prescribed => Vec::new(),
            InputMotion::Transient(found) => found.instants.clone(),
            InputMotion::Steady(found) => {
                let input = &self.linkage.mechanism.input;
                let cycle = input.sign() * input.period().unwrap_or(0.0);
                let end = found.regime.cycle_time;
                let each = (0..=CYCLE_INTERVALS).map(|i| {
                    let state = self.state(input.from + cycle * (f64::from(i) / f64::from(CYCLE_INTERVALS)));
                    // The end of the cycle is its start, one cycle later.
                    let time = if i == CYCLE_INTERVALS { end } else { state.time };
                    Instant { state: State { time, ..state }, holding: None }
                });
                each.collect()
            }
        }
    }

    /// The samples, with forces for a transient motion, because its positions have none; and where they are missing.
    pub(crate) fn trajectory(
        &self,
        watch: &mut Watch<'_>,
    ) -> Result<(Vec<MotionSample>, WithoutForces), Stopped> {
        let mut reader = Reader::new(self);
        let transient = matches!(self.motion, InputMotion::Transient(_));
        let (mut samples, mut without) = (Vec::new(), WithoutForces::default());
        let instants = self.instants();
        let total = instants.len();
        for (done, Instant { state, holding }) in instants.into_iter().enumerate() {
            step(watch, Progress::Samples { done, total })?;
            if reader.solve(state.coordinate).is_err() {
                continue;
            }
            let mut sample = MotionSample {
                time: state.time,
                coordinate: state.coordinate,
                speed: state.speed,
                acceleration: state.acceleration,
                holding,
                ..MotionSample::default()
            };
            if transient {
                add_motion(&mut sample, &mut reader, &state);
                self.add_forces(&mut sample, &mut reader, &state, &mut without);
            } else {
                sample.links = reader.links();
            }
            samples.push(sample);
        }
        Ok((samples, without))
    }

    fn add_forces(
        &self,
        sample: &mut MotionSample,
        reader: &mut Reader<'_>,
        state: &State,
        without: &mut WithoutForces,
    ) {
        if self.linkage.is_at_change_point(&reader.position) {
            without.at_change_points += usize::from(reader.has_forces());
            sample.balancing = reader.balancing_alone(state);
            return;
        }
        match reader.forces(state) {
            Some(Ok((reactions, balancing))) => {
                (sample.reactions, sample.balancing) = (reactions, Some(balancing));
            }
            Some(Err(error)) => {
                without.refused += 1;
                without.reason.get_or_insert(error.to_string());
            }
            None => {}
        }
    }
}

/// Links, points and slides with velocities and accelerations.
fn add_motion(sample: &mut MotionSample, reader: &mut Reader<'_>, state: &State) {
    let found = reader.transfers();
    let [velocities, accelerations] = found.rates(state);
    (sample.velocities, sample.accelerations) = (Some(velocities), Some(accelerations));
    let positions = found.points.0.into_iter().map(|(name, point)| (name, PointPosition { pf0: point.pf0 }));
    sample.points = Named(positions.collect());
    sample.links = found.links;
    sample.slides = found.slides;
}
