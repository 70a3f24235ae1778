//! A mechanism compiled for many positions.

use assur_group::{AssurGroup, Body, Order};
use assur_mechanism::{InputPair, Mechanism};
use assur_structure::Structure;

use crate::assembly::Ways;
use crate::patch::{Interpolation, Patch};
use crate::patches::ancestors;
use crate::seeds::Seeds;
use crate::{Chain, ChainError, CompileError, PositionError, Range, walk};

/// Rounding of an end of the range, rad (or parts of the scale).
const HAIR: f64 = 1e-9;

/// A mechanism, taken apart and compiled: everything that positions need.
#[derive(Debug)]
pub struct Linkage {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// Its groups.
    pub structure: Structure,
    /// The compiled chain.
    pub chain: Chain<f64>,
    /// The way of each group at every coordinate.
    pub ways: Ways,
    /// Where it can be assembled; `None`: not even in the first position.
    pub range: Option<Range>,
    /// Why the first position can't be assembled, if so.
    pub(crate) first_failure: Option<ChainError>,
    /// What ends the range, below and above.
    pub(crate) ends: [Option<ChainError>; 2],
    pub(crate) patches: Vec<Patch>,
    /// For kinds that iterate.
    pub(crate) seeds: Option<Seeds>,
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
    /// Takes a mechanism apart, compiles it and follows its assembly over the cycle.
    ///
    /// A mechanism that can't be assembled compiles too; [`solve`](Self::solve) then says where and by how much.
    ///
    /// # Errors
    ///
    /// [`CompileError`] if the mechanism can't be taken apart into registered groups.
    pub fn compile(mechanism: Mechanism) -> Result<Self, CompileError> {
        let structure = Structure::of(&mechanism)?;
        let needed = vec![true; structure.groups.len()];
        Self::compile_for(mechanism, structure, &needed)
    }

    /// The same for some of the groups only, of a mechanism that is taken apart already.
    ///
    /// Groups that are not needed are neither assembled nor solved, and don't limit the range: the bodies of their links,
    /// and their health, mean nothing. No needed group may depend on one of them.
    ///
    /// # Errors
    ///
    /// [`CompileError`] if lengths make no group of its kind.
    pub fn compile_for(
        mechanism: Mechanism,
        structure: Structure,
        needed: &[bool],
    ) -> Result<Self, CompileError> {
        let mut chain = Chain::compile(&mechanism, &structure)?;
        chain.limit_to(needed);
        let walked = walk::walk(&mechanism, &structure, &chain);
        Ok(Self {
            mechanism,
            structure,
            chain,
            ways: walked.ways,
            range: walked.range,
            first_failure: walked.failure,
            ends: walked.ends,
            patches: walked.patches,
            seeds: walked.seeds,
        })
    }

    /// Scratch for positions.
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

    /// Whether the coordinate is an angle (rad); otherwise a displacement (m).
    pub fn angular(&self) -> bool {
        matches!(self.mechanism.input.pair, InputPair::Pin(_))
    }

    /// Unit of the coordinate for steps and tolerances: 1 rad, or the typical length of the mechanism in m.
    pub fn coordinate_unit(&self) -> f64 {
        if self.angular() { 1.0 } else { self.structure.scale }
    }

    /// Solves all links at one coordinate.
    ///
    /// # Errors
    ///
    /// [`PositionError`] with group, coordinate and what is missing.
    #[inline]
    pub fn solve(&self, coordinate: f64, order: Order, position: &mut Position) -> Result<(), PositionError> {
        position.coordinate = coordinate;
        let place = self.place(coordinate);
        if let Some(seeds) = &self.seeds {
            seeds.put(place, &mut position.bodies);
        }
        let ways = self.ways.at(place);
        let (bodies, health) = (&mut position.bodies, &mut position.health);
        let solved = if self.patches.iter().any(|patch| patch.covers(coordinate)) {
            let across = |group: usize, bodies: &mut [Body<f64>]| {
                let patch =
                    self.patches.iter().find(|patch| patch.group == group && patch.covers(coordinate));
                patch.map(|patch| patch.apply(coordinate, bodies))
            };
            self.chain.solve_around(coordinate, ways, order, bodies, health, across)
        } else {
            self.chain.solve(coordinate, ways, order, bodies, health)
        };
        solved.map_err(|failure| self.explain(coordinate, failure))
    }

    /// The coordinate as the walk over the cycle knows it: where the mechanism does not turn fully, an angle counts from
    /// the lower end.
    #[inline]
    fn place(&self, coordinate: f64) -> f64 {
        match self.range {
            Some(range) if !range.full && self.angular() => range.place(coordinate),
            _ => coordinate,
        }
    }

    /// What is in the way where a mechanism that does not turn fully would have to pass a gap to come from the first
    /// position to a coordinate: the coordinate of the end, and what the group says beyond it.
    pub fn barrier(&self, coordinate: f64) -> Option<(f64, ChainError)> {
        let range = self.range.filter(|range| !range.full)?;
        let hair = HAIR * self.coordinate_unit();
        match self.ends {
            [Some(below), _] if coordinate < range.low - hair => Some((range.low, below)),
            [_, Some(above)] if coordinate > range.high + hair => Some((range.high, above)),
            _ => None,
        }
    }

    /// Whether the motion from the first position comes to a coordinate, forward or turning back, whole turns apart.
    pub fn reaches(&self, coordinate: f64) -> bool {
        let hair = HAIR * self.coordinate_unit();
        let place = self.place(coordinate);
        self.range.is_some_and(|range| range.full || place >= range.low - hair && place <= range.high + hair)
    }

    /// Solves position `index` of the scene.
    ///
    /// # Errors
    ///
    /// As [`solve`](Self::solve), with the number of the position.
    pub fn solve_index(
        &self,
        index: usize,
        order: Order,
        position: &mut Position,
    ) -> Result<(), PositionError> {
        let coordinate = self.mechanism.input.coordinate(index);
        self.solve(coordinate, order, position).map_err(|error| PositionError { index: Some(index), ..error })
    }

    /// Whether a solved position lies so near to a change point that forces are not determined there: two ways of a group
    /// meet, its constraints coincide, and its reactions have the form 0/0.
    pub fn is_at_change_point(&self, position: &Position) -> bool {
        /// Determinant of the group whose ways meet: with less, of the 16 digits of the places too few are left in it.
        const NEAR: f64 = 1e-5;
        let mut covering = self.patches.iter().filter(|patch| patch.covers(position.coordinate));
        covering.any(|patch| position.health[patch.group].abs() < NEAR)
    }

    /// How the motion at a coordinate is interpolated across a change point, of several the widest interpolation; `None`
    /// where all groups are solved by their own equations.
    pub fn interpolation(&self, coordinate: f64) -> Option<Interpolation> {
        let found = self.patches.iter().filter_map(|patch| patch.at(coordinate));
        found.max_by(|a, b| a.half_width.total_cmp(&b.half_width))
    }

    /// Whether the motion of a group is interpolated across a change point at a coordinate.
    pub fn is_interpolated(&self, coordinate: f64) -> bool {
        self.patches.iter().any(|patch| patch.covers(coordinate))
    }

    /// The change points, at which two ways of a group meet: coordinate (rad or m) and index of the group.
    ///
    /// They lie within one period of the motion, which may be several turns.
    pub fn change_points(&self) -> &[(f64, usize)] {
        self.ways.changes()
    }

    /// The change point nearest to a coordinate, rad or m, in the turn of the coordinate; `None` where there is none.
    pub fn nearest_change_point(&self, coordinate: f64) -> Option<f64> {
        let offsets = self.change_points().iter().map(|(at, _)| self.ways.offset(coordinate, *at));
        offsets.min_by(|a, b| a.abs().total_cmp(&b.abs())).map(|offset| coordinate + offset)
    }

    /// Whether a change point lies within a distance (rad or m) of a coordinate.
    pub fn is_near_change_point(&self, coordinate: f64, distance: f64) -> bool {
        self.change_points().iter().any(|(at, _)| self.ways.offset(coordinate, *at).abs() < distance)
    }

    /// The groups whose links determine the motion of a group, in solving order, itself last.
    pub fn ancestors(&self, group: usize) -> Vec<usize> {
        ancestors(&self.structure, group)
    }

    #[cold]
    fn explain(&self, coordinate: f64, failure: ChainError) -> PositionError {
        let failure = self.first_failure.filter(|_| self.range.is_none()).unwrap_or(failure);
        PositionError {
            group: failure.group,
            group_name: self.structure.group_name(&self.mechanism, failure.group),
            index: None,
            coordinate,
            angular: self.angular(),
            source: failure.source,
            range: self.range.map(|range| [range.low, range.high]),
        }
    }
}
