//! The motion of bodies over a cycle, whose places are asked for in the order of a grid.

use assur_group::plane::{dot, vector};
use assur_group::{Body, Order};
use assur_kinematics::{LanePosition, Linkage, Position, PositionError};
use assur_mechanism::{LinkId, Place};
use assur_number::{Intervals, Lanes, elementary, search::try_newton_root};

use crate::breaks::Breaks;

/// Number of cells of a span where nothing is known of them.
pub(crate) const GRID: u32 = 720;

/// Into how many cells a span is divided where that suffices; beyond these, proving it takes as long as it saves.
const FEW: [u32; 2] = [32, 128];

/// An interval of the input coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    /// Start, rad or m.
    pub(crate) from: f64,
    /// Length, positive.
    pub(crate) length: f64,
    /// Whether the motion repeats with the length.
    pub(crate) periodic: bool,
    /// Number of equal cells in which an extreme, a rest or a switch is bracketed.
    pub(crate) cells: u32,
}

impl Span {
    /// Place `index` of the grid.
    pub(crate) fn at(&self, index: u32) -> f64 {
        self.from + self.length * (f64::from(index) / f64::from(self.cells))
    }

    /// The span in as few cells as show where a point reverses along an axis: in each of them it moves in one direction, or its
    /// PF2 keeps its sign. Intervals prove it; where they don't, there are as many cells as usual.
    pub(crate) fn for_stroke(self, linkage: &Linkage, at: Place, axis: f64) -> Self {
        let Some(mut enclosures) = linkage.enclosures() else { return self };
        let (axis, point) = (vector([elementary::cos(axis), elementary::sin(axis)]), vector(at.at));
        let mut is_simple = |cells: u32| {
            let radius = 0.5 * self.length / f64::from(cells);
            enclosures.all(self.ends(), cells, Order::Second, |bodies, _| {
                let body: &Body<Intervals> = &bodies[at.link];
                let [first, second] = body.motion(body.arm(point)).map(|along| dot(axis, along));
                (0..Lanes::WIDTH).all(|lane| {
                    let [[slope, error], [bend, of_bend]] =
                        [first, second].map(|order| [order.middle.0[lane].abs(), order.radius.0[lane]]);
                    // The mean value theorem encloses PF1 more narrowly than its own formula where PF2 is small.
                    slope > error || slope > radius * (bend + of_bend) || bend > of_bend
                })
            })
        };
        let cells = FEW.into_iter().find(|cells| is_simple(*cells)).unwrap_or(self.cells);
        Self { cells, ..self }
    }

    pub(crate) fn ends(&self) -> [f64; 2] {
        [self.from, self.from + self.length]
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
    pub(crate) fn at(&mut self, coordinate: f64, link: LinkId) -> Result<Body<f64>, PositionError> {
        if let Some(lane) = self.lane(coordinate) {
            return Ok(self.eight.bodies[link].lane(lane));
        }
        self.linkage.solve(coordinate, Order::Second, &mut self.single)?;
        Ok(self.single.bodies[link])
    }

    /// The lane that holds a coordinate; solves the next places of the grid where it is the first of them.
    fn lane(&mut self, coordinate: f64) -> Option<usize> {
        let same = |other: f64| other.to_bits() == coordinate.to_bits();
        if same(self.grid.at(0)) {
            self.next = 0;
        }
        if self.next <= self.grid.cells && same(self.grid.at(self.next)) {
            let mut places = (self.next..).map(|index| self.grid.at(index.min(self.grid.cells)));
            let places = Lanes::of(|_| places.next().unwrap_or(coordinate));
            self.solved = self.linkage.solve_lanes(places, Order::Second, &mut self.eight).is_ok();
            self.next += 8;
        }
        self.eight.coordinates.0.into_iter().position(same).filter(|_| self.solved)
    }
}

/// A minimum of the velocity below this part of its greatest value over the cycle counts as a rest.
const REST: f64 = 1e-9;

/// The rests of a point or link, from its PF1 and PF2; coordinates without a position of the mechanism are skipped.
pub(crate) fn rests(
    motion: &mut dyn FnMut(f64) -> Result<[[f64; 2]; 2], PositionError>,
    span: &Span,
) -> Breaks {
    let mut slope = |q: f64| -> Result<[f64; 2], PositionError> {
        let [v, a] = motion(q)?;
        Ok([elementary::hypot(v[0], v[1]), v[0] * a[0] + v[1] * a[1]])
    };
    let mut greatest = 0.0_f64;
    let mut minima = Vec::new();
    let mut before = slope(span.from);
    for index in 1..=span.cells {
        let (low, high) = (span.at(index - 1), span.at(index));
        let after = slope(high);
        if let (Ok(a), Ok(b)) = (&before, &after) {
            greatest = greatest.max(b[0]);
            // The square of the velocity falls, then grows: a minimum between.
            if a[1] < 0.0 && b[1] >= 0.0 {
                minima.push([low, high]);
            }
        }
        before = after;
    }
    let mut rests = Vec::new();
    for [low, high] in minima {
        // The derivative is not available: with a slope of 0 the root finder bisects.
        let Ok(q) = try_newton_root(low, high, |q| slope(q).map(|s| (s[1], 0.0))) else { continue };
        if slope(q).is_ok_and(|s| s[0] <= REST * greatest) {
            rests.push(q);
        }
    }
    Breaks::new(rests, span.period())
}
