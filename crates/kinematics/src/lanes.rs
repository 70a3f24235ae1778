//! Eight positions at once, in lanes.

use assur_group::{Body, Order};
use assur_number::{Lanes, Real};

use crate::{ChainError, Linkage, Position, PositionError};

/// Pose and derivatives of all links at eight coordinates: the scratch of [`Linkage::solve_lanes`].
///
/// `bodies` has the layout of [`Position::bodies`], with a lane for each coordinate: `bodies[link].x.0[lane]`. Stages
/// that are written over [`Real`] take it as it is; [`copy_lane`](Self::copy_lane) gives one of the positions to the others.
#[derive(Debug, Clone)]
pub struct LanePosition {
    /// The coordinates, rad or m.
    pub coordinates: Lanes,
    /// One for each link, the ground first.
    pub bodies: Vec<Body<Lanes>>,
    /// Dimensionless determinant of each group: 0 at a singular position. Its sign carries no meaning.
    pub health: Vec<Lanes>,
    /// For the lanes that are solved one at a time.
    single: Position,
}

impl LanePosition {
    /// Copies one of the eight positions.
    pub fn copy_lane(&self, lane: usize, position: &mut Position) {
        position.coordinate = self.coordinates.0[lane];
        position.bodies.iter_mut().zip(&self.bodies).for_each(|(one, all)| *one = all.lane(lane));
        position.health.iter_mut().zip(&self.health).for_each(|(one, all)| *one = all.0[lane]);
    }

    /// Copies the numbers of one lane to another.
    fn repeat(&mut self, from: usize, to: usize) {
        self.bodies.iter_mut().for_each(|body| body.set_lane(to, &body.lane(from)));
        self.health.iter_mut().for_each(|all| all.0[to] = all.0[from]);
    }
}

impl Linkage {
    /// Storage for eight solved positions.
    pub fn lane_position(&self) -> LanePosition {
        LanePosition {
            coordinates: Lanes::from_f64(f64::NAN),
            bodies: self.lane_chain.bodies(),
            health: vec![Lanes::ZERO; self.groups().len()],
            single: self.position(),
        }
    }

    /// Solves all links at eight coordinates. Every lane gets the bits that [`solve`](Self::solve) gives at its
    /// coordinate, whatever the other lanes are.
    ///
    /// A lane without a position holds the bodies and the determinant of a lane that has one, if there is any, so that
    /// formulas over all lanes stay defined.
    ///
    /// # Errors
    ///
    /// The lanes that have no position, each with the group, the coordinate and the reason; the others are solved.
    pub fn solve_lanes(
        &self,
        coordinates: Lanes,
        order: Order,
        position: &mut LanePosition,
    ) -> Result<(), Vec<(usize, PositionError)>> {
        position.coordinates = coordinates;
        let mut alone = self.alone(coordinates);
        if let Some(first) = alone.iter().position(|alone| !alone) {
            // A lane that is solved alone must not keep the others from being solved together.
            let together = Lanes::of(|lane| coordinates.0[if alone[lane] { first } else { lane }]);
            if let Some(guesses) = &self.guesses {
                for (lane, coordinate) in together.0.into_iter().enumerate() {
                    let poses = guesses.at(self.followed(coordinate));
                    poses.for_each(|(link, pose)| position.bodies[link].set_lane(lane, &pose));
                }
            }
            let ways = self.ways.at(coordinates.0[first]);
            let (bodies, health) = (&mut position.bodies, &mut position.health);
            if self.lane_chain.solve(together, ways, order, bodies, health).is_err() {
                alone = [true; Lanes::WIDTH];
            }
        }
        if alone.contains(&true) { self.solve_alone(alone, order, position) } else { Ok(()) }
    }

    /// Over time, all links at eight solved positions for PF1 and PF2 with respect to the coordinate of each drive, the others at
    /// rest; none where the coordinate is that of a drive. NaN where the groups can't be derived.
    pub fn partials(&self, position: &LanePosition) -> Vec<Vec<Body<Lanes>>> {
        let drives = if self.kind().is_time() { self.mechanism.input.drivers.len() } else { 0 };
        let of_drive = |drive: usize| {
            let mut all = position.bodies.clone();
            for lane in 0..Lanes::WIDTH {
                let time = position.coordinates.0[lane];
                let mut bodies: Vec<_> = position.bodies.iter().map(|body| body.lane(lane)).collect();
                if self.derive_by(drive, time, &mut bodies).is_err() {
                    for body in &mut bodies {
                        (body.w1, body.x1, body.y1) = (f64::NAN, f64::NAN, f64::NAN);
                    }
                }
                all.iter_mut().zip(&bodies).for_each(|(all, one)| all.set_lane(lane, one));
            }
            all
        };
        (0..drives).map(of_drive).collect()
    }

    /// Over time: PF1 and PF2 of all placed links with respect to the coordinate of one drive, the others at rest.
    pub fn derive_by(&self, drive: usize, time: f64, bodies: &mut [Body<f64>]) -> Result<(), ChainError> {
        self.chain.derive_by(drive, time, bodies)
    }

    /// The lanes that must be solved one at a time: those whose motion is interpolated, or whose groups are in other modes
    /// than in the first lane.
    fn alone(&self, coordinates: Lanes) -> [bool; Lanes::WIDTH] {
        let mut alone = [false; Lanes::WIDTH];
        if self.guesses.is_some() {
            for (alone, coordinate) in alone.iter_mut().zip(coordinates.0) {
                *alone = self.barrier(coordinate).is_some();
            }
        }
        if self.ways.are_constant() {
            return alone;
        }
        let mut common = None;
        for (alone, coordinate) in alone.iter_mut().zip(coordinates.0) {
            let ways = self.ways.at(coordinate);
            *alone |= self.interpolants.cover(coordinate) || *common.get_or_insert(ways) != ways;
        }
        alone
    }

    /// Solves some of the lanes one at a time.
    #[cold]
    fn solve_alone(
        &self,
        alone: [bool; Lanes::WIDTH],
        order: Order,
        position: &mut LanePosition,
    ) -> Result<(), Vec<(usize, PositionError)>> {
        let mut failures = Vec::new();
        let mut solved = alone.iter().position(|alone| !alone);
        for lane in (0..Lanes::WIDTH).filter(|&lane| alone[lane]) {
            match self.solve(position.coordinates.0[lane], order, &mut position.single) {
                Ok(()) => {
                    let LanePosition { bodies, health, single, .. } = position;
                    bodies.iter_mut().zip(&single.bodies).for_each(|(all, one)| all.set_lane(lane, one));
                    health.iter_mut().zip(&single.health).for_each(|(all, one)| all.0[lane] = *one);
                    solved = Some(lane);
                }
                Err(error) => failures.push((lane, error)),
            }
        }
        if failures.is_empty() {
            return Ok(());
        }
        if let Some(solved) = solved {
            for (lane, _) in &failures {
                position.repeat(solved, *lane);
            }
        }
        Err(failures)
    }
}
