//! A mechanism with its drive as an equation of motion.

use assur_integrator::{Dependence, Motion, MotionError, Piece, Reduced, State};

use crate::Shaft;

/// The equation of motion of a machine with a drive, a flywheel and a rotor on its input shaft.
#[derive(Debug, Clone)]
pub struct Driven<M> {
    machine: M,
    shaft: Shaft,
    factor: f64,
}

impl<M: Motion> Driven<M> {
    /// Puts a drive on the input shaft of a machine.
    pub fn new(machine: M, shaft: Shaft) -> Self {
        Self { machine, shaft, factor: 1.0 }
    }

    /// The machine without its drive.
    pub fn machine(&mut self) -> &mut M {
        &mut self.machine
    }

    /// What is on the shaft.
    pub fn shaft(&self) -> &Shaft {
        &self.shaft
    }

    /// Moment of the drive, N m, along the coordinate, at a speed of the coordinate.
    pub fn torque(&self, speed: f64) -> f64 {
        let v = self.shaft.sense * speed;
        self.shaft.sense * self.shaft.moment(self.shaft.branch(v).factor, v).value
    }
}

impl<M: Motion> Motion for Driven<M> {
    fn dependence(&self) -> Dependence {
        let mut dependence = self.machine.dependence();
        dependence.moment_on_speed |= self.shaft.depends_on_speed();
        dependence
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        let mut piece = self.machine.enter(state)?;
        let branch = self.shaft.branch(self.shaft.sense * state.speed);
        self.factor = branch.factor;
        let [low, high] = branch.speed;
        let own = if self.shaft.sense < 0.0 { [-high, -low] } else { [low, high] };
        piece.speed = [piece.speed[0].max(own[0]), piece.speed[1].min(own[1])];
        Ok(piece)
    }

    #[inline]
    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let mut reduced = self.machine.reduced(state)?;
        let sense = self.shaft.sense;
        reduced.inertia += self.shaft.inertia;
        reduced.moment += sense * self.shaft.moment(self.factor, sense * state.speed).value;
        Ok(reduced)
    }
}
