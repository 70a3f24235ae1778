//! The motion of bodies over a cycle, whose places are asked for in the order of a grid.

use assur_group::{Body, Order};
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_mechanism::LinkId;
use assur_number::Lanes;

/// Number of cells of the cycle in which an extreme, a rest or a switch is bracketed.
pub(crate) const GRID: u32 = 720;

/// An interval of the input coordinate.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Span {
    /// Start, rad or m.
    pub(crate) from: f64,
    /// Length, positive.
    pub(crate) length: f64,
    /// Whether the motion repeats with the length.
    pub(crate) periodic: bool,
}

impl Span {
    /// Place `index` of the grid.
    pub(crate) fn at(&self, index: u32) -> f64 {
        self.from + self.length * (f64::from(index) / f64::from(GRID))
    }

    pub(crate) fn period(&self) -> Option<f64> {
        self.periodic.then_some(self.length)
    }
}

/// Solves the positions of a linkage: those of the grid eight at once, others one at a time.
pub(crate) struct Bodies<'a> {
    linkage: &'a Linkage,
    single: Position,
    /// The last places of the grid.
    eight: LanePosition,
    /// Whether all of them are solved.
    solved: bool,
    grid: Span,
    /// The place of the grid after them.
    next: u32,
}

impl<'a> Bodies<'a> {
    /// Memory, for the places of a grid over `grid`.
    pub(crate) fn new(linkage: &'a Linkage, grid: Span) -> Self {
        let (single, eight) = (linkage.position(), linkage.lane_position());
        Self { linkage, single, eight, solved: false, grid, next: 0 }
    }

    /// The motion of a link at a coordinate, or why there is none.
    pub(crate) fn at(&mut self, coordinate: f64, link: LinkId) -> Result<Body<f64>, String> {
        if let Some(lane) = self.lane(coordinate) {
            return Ok(self.eight.bodies[link].lane(lane));
        }
        let solved = self.linkage.solve(coordinate, Order::Second, &mut self.single);
        solved.map_err(|error| error.to_string())?;
        Ok(self.single.bodies[link])
    }

    /// The lane that holds a coordinate; solves the next places of the grid where it is the first of them.
    fn lane(&mut self, coordinate: f64) -> Option<usize> {
        let same = |other: f64| other.to_bits() == coordinate.to_bits();
        if same(self.grid.at(0)) {
            self.next = 0;
        }
        if self.next <= GRID && same(self.grid.at(self.next)) {
            let mut places = (self.next..).map(|index| self.grid.at(index.min(GRID)));
            let places = Lanes::of(|_| places.next().unwrap_or(coordinate));
            self.solved = self.linkage.solve_lanes(places, Order::Second, &mut self.eight).is_ok();
            self.next += 8;
        }
        self.eight.coordinates.0.into_iter().position(same).filter(|_| self.solved)
    }
}
