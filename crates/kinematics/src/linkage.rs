//! A mechanism compiled for many positions.

use std::{f64::consts::TAU, sync::Arc};

use assur_group::{AssurGroup, Body, GroupError, Order};
use assur_mechanism::{CoordinateKind, Driver, GROUND, Mechanism, Name, Slide};
use assur_number::{Lanes, Real, elementary};
use assur_structure::Structure;

use crate::elsewhere::elsewhere;
use crate::follow::{coordinate_unit, follow};
use crate::passive::{Misfit, decompose, misfits};
use crate::ways::{END_ROUNDING, Transition, Ways, shifted};
use crate::{
    AssemblyRange, Chain, ChainError, CompileError, PositionError, dependence::Dependence,
    interpolant::Interpolation, interpolants::Interpolants, poses::Guesses, start::refuse_without_start,
};

/// The way to a position from the nearest kept poses is divided into at most two to this power of steps.
const MOST_HALVINGS: u32 = 8;

/// A mechanism decomposed into groups and compiled, with everything needed to calculate positions. A clone shares what is
/// compiled.
#[derive(Debug, Clone)]
pub struct Linkage {
    /// The mechanism as read.
    pub mechanism: Mechanism,
    /// Its pairs and groups.
    pub structure: Structure,
    /// The compiled chain.
    pub chain: Arc<Chain<f64>>,
    /// The compiled chain for eight positions at once.
    pub lane_chain: Arc<Chain<Lanes>>,
    /// The mode of each group at every coordinate.
    pub ways: Ways,
    /// The range in which it can be assembled; `None` if it can't be assembled in the first position.
    pub range: Option<AssemblyRange>,
    /// Why the first position can't be assembled, if so.
    first_failure: Option<ChainError>,
    /// Where it could be assembled instead.
    elsewhere: Option<[f64; 2]>,
    /// What ends the range, below and above.
    ends: [Option<ChainError>; 2],
    pub(crate) interpolants: Interpolants,
    /// Starting poses for the groups that iterate.
    pub(crate) guesses: Option<Guesses>,
    /// How much each passive part misses over the cycle; empty without any.
    pub misfits: Vec<Misfit>,
    /// Unit of the coordinate: of laws over time it takes a sum over the motion.
    unit: f64,
}

/// Pose and derivatives of all links at one coordinate: the scratch of [`Linkage::solve`].
#[derive(Debug, Clone)]
pub struct Position {
    /// The coordinate, rad or m.
    pub coordinate: f64,
    /// One for each link, the ground first.
    pub bodies: Vec<Body<f64>>,
    /// Dimensionless determinant of each group: 0 at a singular position. Its sign carries no meaning.
    pub health: Vec<f64>,
}

impl Linkage {
    /// Decomposes a mechanism into groups, compiles it and follows its assembly over the cycle.
    ///
    /// A mechanism that can't be assembled compiles too; [`solve`](Self::solve) then reports the group and the gap.
    pub fn compile(mechanism: Mechanism) -> Result<Self, CompileError> {
        let structure = decompose(&mechanism)?;
        let needed = vec![true; structure.groups.len()];
        Self::compile_for(mechanism, structure, &needed)
    }

    /// Compiles some of the groups of a decomposed mechanism and follows their assembly.
    ///
    /// Groups that are not needed are neither assembled nor solved, and don't limit the range; the bodies of their
    /// links and their determinant are undefined. No needed group may depend on one of them.
    ///
    /// A turn in which no group comes near a singular position is proved to be such over few intervals of the angle. Where
    /// that fails, following takes nearly all of the time: 720 samples a turn for each group, eight at once. The chain in 32
    /// digits is compiled only where the places in `[assembly]` don't tell two modes apart in 16 digits, and where a
    /// determinant comes near zero between two samples.
    pub fn compile_for(
        mechanism: Mechanism,
        structure: Structure,
        needed: &[bool],
    ) -> Result<Self, CompileError> {
        let mut chain = Chain::compile(&mechanism, &structure)?;
        chain.needed = needed.to_vec();
        refuse_without_start(&mechanism, &structure, &chain)?;
        let mut lane_chain = Chain::compile(&mechanism, &structure)?;
        lane_chain.needed = needed.to_vec();
        let followed = follow(&mechanism, &structure, (&chain, &lane_chain));
        let is_lost = followed.range.is_none();
        let elsewhere = is_lost.then(|| elsewhere(&mechanism, &structure, &chain)).flatten();
        let mut linkage = Self {
            unit: coordinate_unit(&mechanism, &structure),
            mechanism,
            structure,
            chain: Arc::new(chain),
            lane_chain: Arc::new(lane_chain),
            ways: followed.ways,
            range: followed.range,
            first_failure: followed.first_failure,
            elsewhere,
            ends: followed.ends,
            interpolants: followed.interpolants,
            guesses: followed.guesses,
            misfits: Vec::new(),
        };
        linkage.misfits = misfits(&linkage);
        Ok(linkage)
    }

    /// The linkage of a mechanism that differs in numbers only, with some groups needed as in
    /// [`compile_for`](Self::compile_for). It comes with the mechanism that this linkage had, and with whether both have the
    /// same positions: then nothing was compiled.
    pub fn varied(
        mut self,
        mechanism: Mechanism,
        needed: &[bool],
    ) -> Result<(Self, Mechanism, bool), CompileError> {
        if needed == self.chain.needed && mechanism.has_positions_of(&self.mechanism) {
            let before = std::mem::replace(&mut self.mechanism, mechanism);
            return Ok((self, before, true));
        }
        self.structure.set_geometry(&mechanism);
        let varied = Self::compile_for(mechanism, self.structure, needed)?;
        Ok((varied, self.mechanism, false))
    }

    /// Storage for one solved position.
    pub fn position(&self) -> Position {
        Position {
            coordinate: f64::NAN,
            bodies: self.chain.bodies(),
            health: vec![0.0; self.chain.groups.len()],
        }
    }

    /// The kernels of the groups in solving order.
    pub fn groups(&self) -> &[Box<dyn AssurGroup<f64>>] {
        &self.chain.groups
    }

    /// What the coordinate is.
    pub fn kind(&self) -> CoordinateKind {
        self.mechanism.input.kind()
    }

    /// Unit of the coordinate for steps and tolerances: 1 rad, the typical length of the mechanism in m, or the time in
    /// which a drive moves by that.
    pub fn coordinate_unit(&self) -> f64 {
        self.unit
    }

    /// Solves all links at one coordinate.
    #[inline]
    pub fn solve(&self, coordinate: f64, order: Order, position: &mut Position) -> Result<(), PositionError> {
        position.coordinate = coordinate;
        if let Some(guesses) = &self.guesses {
            // Beyond its range a group that iterates has no pose to begin with.
            if let Some((_, failure)) = self.barrier(coordinate) {
                return Err(self.explain(coordinate, failure));
            }
            guesses.put(self.followed(coordinate), &mut position.bodies);
        }
        let solved = self.solve_from(coordinate, order, position);
        let solved = match (solved, &self.guesses) {
            (Err(failure), Some(guesses)) => self.approach(coordinate, order, (guesses, failure), position),
            (solved, _) => solved,
        };
        solved.map_err(|failure| self.explain(coordinate, failure))
    }

    /// Solves all links at one coordinate; groups that iterate begin with the poses in `position`.
    #[inline]
    fn solve_from(&self, coordinate: f64, order: Order, position: &mut Position) -> Result<(), ChainError> {
        let ways = self.ways.at(coordinate);
        let (bodies, health) = (&mut position.bodies, &mut position.health);
        if self.interpolants.cover(coordinate) {
            let apply =
                |group: usize, bodies: &mut [Body<f64>]| self.interpolants.apply(group, coordinate, bodies);
            self.chain.solve_except(coordinate, ways, order, bodies, health, apply)
        } else {
            self.chain.solve(coordinate, ways, order, bodies, health)
        }
    }

    /// Solves all links where the poses that were kept are too far away, as beside a place where links run to infinity: in
    /// ever more steps from there.
    #[cold]
    fn approach(
        &self,
        coordinate: f64,
        order: Order,
        (guesses, failure): (&Guesses, ChainError),
        position: &mut Position,
    ) -> Result<(), ChainError> {
        if !matches!(failure.source, GroupError::NoAssembly { .. }) || !self.reaches(coordinate) {
            return Err(failure);
        }
        let followed = self.followed(coordinate);
        let near = guesses.coordinate_near(followed);
        let start = near + (coordinate - followed);
        let by_steps = |steps: u32, position: &mut Position| {
            guesses.put(near, &mut position.bodies);
            (1..=steps).try_for_each(|step| {
                let part = f64::from(step) / f64::from(steps);
                let (at, order) = if step < steps {
                    (start + part * (coordinate - start), Order::Place)
                } else {
                    (coordinate, order)
                };
                self.solve_from(at, order, position)
            })
        };
        (1..=MOST_HALVINGS).find_map(|halvings| by_steps(1 << halvings, position).ok()).ok_or(failure)
    }

    /// The coordinate shifted into the interval in which the assembly was followed: if the mechanism does not turn
    /// fully, an angle is taken in the turn that begins at the lower end.
    #[inline]
    pub(crate) fn followed(&self, coordinate: f64) -> f64 {
        match self.range {
            Some(AssemblyRange { low, high, full: false }) if self.kind().is_angle() && high - low < TAU => {
                shifted(coordinate, low, TAU)
            }
            _ => coordinate,
        }
    }

    /// Bodies to begin the solution at a coordinate with, in any number type: groups that iterate are near their poses there.
    pub fn starting_bodies<T: Real>(&self, coordinate: f64) -> Vec<Body<T>> {
        let mut bodies = self.chain.bodies();
        if let Some(guesses) = &self.guesses {
            guesses.put(self.followed(coordinate), &mut bodies);
        }
        bodies.iter().map(|body| body.map(T::from_f64)).collect()
    }

    /// The end of the range that separates a coordinate from the first position, if the mechanism would have to pass
    /// a gap: its coordinate, and the error of the group beyond it.
    pub fn barrier(&self, coordinate: f64) -> Option<(f64, ChainError)> {
        let range = self.range.filter(|range| !range.full)?;
        let rounding = END_ROUNDING * self.coordinate_unit();
        match self.ends {
            [Some(below), _] if coordinate < range.low - rounding => Some((range.low, below)),
            [_, Some(above)] if coordinate > range.high + rounding => Some((range.high, above)),
            _ => None,
        }
    }

    /// Whether the motion from the first position reaches a coordinate (forward or backward), up to whole turns.
    pub fn reaches(&self, coordinate: f64) -> bool {
        let rounding = END_ROUNDING * self.coordinate_unit();
        let followed = self.followed(coordinate);
        let inside =
            |range: AssemblyRange| followed >= range.low - rounding && followed <= range.high + rounding;
        self.range.is_some_and(|range| range.full || inside(range))
    }

    /// Solves position `index` of the scene.
    pub fn solve_index(
        &self,
        index: usize,
        order: Order,
        position: &mut Position,
    ) -> Result<(), PositionError> {
        let coordinate = self.mechanism.input.coordinate(index);
        self.solve(coordinate, order, position).map_err(|error| PositionError { index: Some(index), ..error })
    }

    /// Whether a solved position is so near to a change point that forces are indeterminate there: two modes of a
    /// group meet, its constraints become dependent, and its reactions have the form 0/0.
    pub fn is_at_change_point(&self, position: &Position) -> bool {
        /// Determinant of the group whose modes meet: below this, places of 16 digits leave too few digits in it.
        const NEAR: f64 = 1e-5;
        self.interpolants.cover_unhealthy(position.coordinate, &position.health, NEAR)
    }

    /// How the motion at a coordinate is interpolated across a change point (if several interpolations cover it, the
    /// widest); `None` where all groups are solved by their own equations.
    pub fn interpolation(&self, coordinate: f64) -> Option<Interpolation> {
        self.interpolants.widest(coordinate)
    }

    /// Whether the motion of a group is interpolated across a change point at a coordinate.
    pub fn is_interpolated(&self, coordinate: f64) -> bool {
        self.interpolants.cover(coordinate)
    }

    /// The change points, at which two modes of a group meet, in increasing order of the coordinate.
    ///
    /// They are given for one period of the motion, which may be several turns.
    pub fn change_points(&self) -> impl Iterator<Item = &Transition> {
        self.ways.change_points()
    }

    /// The change point nearest to a coordinate, rad or m, in the same turn; `None` if there is none.
    pub fn nearest_change_point(&self, coordinate: f64) -> Option<f64> {
        let offsets = self.change_points().map(|point| self.ways.offset(coordinate, point.coordinate));
        offsets.min_by(|a, b| a.abs().total_cmp(&b.abs())).map(|offset| coordinate + offset)
    }

    /// Whether there is a change point within a distance (rad or m) of a coordinate.
    pub fn is_near_change_point(&self, coordinate: f64, distance: f64) -> bool {
        self.change_points().any(|point| self.ways.offset(coordinate, point.coordinate).abs() < distance)
    }

    /// The groups that determine the motion of a group, in solving order, the group itself last.
    pub fn ancestors(&self, group: usize) -> Vec<usize> {
        let mut found = Dependence::of(&self.structure).ancestors(group, |_| false);
        found.push(group);
        found
    }

    /// Over time, the drives that determine the motion of a group, by their indices; none where the coordinate is that of the only one.
    pub fn drives_of(&self, group: usize) -> Vec<usize> {
        let drivers = self.mechanism.input.drivers.iter().enumerate();
        let ancestors = self.ancestors(group);
        let carriers: Vec<usize> =
            ancestors.iter().flat_map(|group| self.structure.groups[*group].frame.carriers()).collect();
        let moves = |(index, driver): &(usize, &Driver)| {
            let body = if driver.is_relative() { self.structure.links + index } else { driver.link };
            driver.law.is_some() && carriers.contains(&body)
        };
        drivers.filter(moves).map(|(index, _)| index).collect()
    }

    /// Two slides of a link whose guides are parallel wherever it is: between them it is not held.
    fn parallel_guides(&self, group: usize) -> Option<Box<[Name; 2]>> {
        /// The sine of the angle between parallel directions, to the rounding of angles in degrees.
        const PARALLEL: f64 = 1e-9;
        let slides = &self.mechanism.slides;
        // The direction of the guide in the frame of a link.
        let direction = |slide: &Slide, link| match link {
            _ if slide.link == link => Some(-slide.tilt),
            _ if slide.on == link => Some(slide.angle),
            _ => None,
        };
        let links = &self.structure.groups[group].frame.links;
        let both = links.iter().flat_map(|link| {
            let own = slides.iter().filter_map(move |slide| Some((slide, direction(slide, *link)?)));
            own.clone()
                .enumerate()
                .flat_map(move |(k, one)| own.clone().skip(k + 1).map(move |other| [one, other]))
        });
        let mut parallel = both.filter(|[one, other]| elementary::sin(one.1 - other.1).abs() < PARALLEL);
        parallel.next().map(|both| Box::new(both.map(|(slide, _)| slide.name.clone())))
    }

    #[cold]
    fn explain(&self, coordinate: f64, failure: ChainError) -> PositionError {
        let failure = self.first_failure.filter(|_| self.range.is_none()).unwrap_or(failure);
        let (mechanism, links) = (&self.mechanism, &self.structure.groups[failure.group].frame.links);
        let of_ground = |slide: &&Slide| {
            slide.on == GROUND
                && slide.through.iter().all(|part| part.abs() <= 0.0)
                && links.contains(&slide.link)
        };
        let by_default = mechanism.slides.iter().find(of_ground);
        let by_default =
            by_default.map(|slide| Box::new([slide.name.clone(), mechanism.links[GROUND].name.clone()]));
        let parallel =
            matches!(failure.source, GroupError::Singular { .. } | GroupError::SingularStart { .. })
                .then(|| self.parallel_guides(failure.group))
                .flatten();
        PositionError {
            parallel,
            group: failure.group,
            group_name: Box::new(self.structure.group_name(&self.mechanism, failure.group)),
            index: None,
            coordinate,
            kind: self.kind(),
            source: failure.source,
            range: self.range.map(|range| [range.low, range.high]),
            elsewhere: self.elsewhere.map(Box::new),
            by_default,
        }
    }
}
