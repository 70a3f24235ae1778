//! How the size of a load follows from the state.

use assur_formula::{Branches, Used};
use assur_integrator::Piece;

use crate::breaks::{Breaks, cut};
use crate::stroke::{Segment, Stroke};
use crate::{LoadState, curve::Curve, formula::FormulaLaw, state::Selection};

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Law {
    Constant(f64),
    /// A table over the coordinate; with a period of its breaks it repeats, counted from its first row.
    Coordinate(Curve, Breaks),
    /// A table over the speed.
    Speed(Curve),
    /// A table over time.
    Time(Curve),
    /// Along the stroke of the load's point.
    Stroke(Box<Stroke>),
    Formula(Box<FormulaLaw>),
}

/// Which formula of a law is in use.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Active {
    /// Segment of the table, and which table.
    pub(crate) piece: Segment,
    /// Sum of the whole cycles that are subtracted from the argument.
    pub(crate) shift: f64,
    /// Of a formula, the sides of its switches.
    pub(crate) sides: Branches,
}

impl Active {
    fn segment(segment: usize, shift: f64) -> Self {
        Self { piece: Segment { back: false, segment }, shift, ..Self::default() }
    }

    fn branches(sides: Branches) -> Self {
        Self { sides, ..Self::default() }
    }
}

impl Law {
    /// Whether a motion meets changes of it on its way, which no bound of one variable describes.
    pub(crate) fn is_met(&self) -> bool {
        matches!(self, Self::Formula(law) if law.met().next().is_some())
    }

    /// Whether it is over the coordinate or the speed of the input.
    pub(crate) fn is_of_input(&self) -> bool {
        matches!(self, Self::Coordinate(..) | Self::Speed(_) | Self::Formula(_))
    }

    /// Whether all rows have one value, so that the law depends on nothing.
    pub(crate) fn is_constant(&self) -> bool {
        match self {
            Self::Constant(_) => true,
            Self::Coordinate(table, _) | Self::Speed(table) | Self::Time(table) => table.is_flat(),
            Self::Stroke(_) => false,
            Self::Formula(law) => law.used() == Used::default(),
        }
    }

    /// Variables on which it depends.
    pub(crate) fn used(&self) -> Used {
        let none = Used::default();
        match self {
            _ if self.is_constant() => none,
            Self::Constant(_) => none,
            Self::Coordinate(..) => Used { coordinate: true, ..none },
            Self::Speed(_) => Used { speed: true, ..none },
            Self::Time(_) => Used { time: true, ..none },
            Self::Stroke(_) => Used { place: true, ..none },
            Self::Formula(law) => law.used(),
        }
    }

    /// The formula on a side of a state.
    #[inline(always)]
    pub(crate) fn at(&self, state: &LoadState, side: &Selection, period: Option<f64>) -> Active {
        match self {
            Self::Constant(_) => Active::default(),
            Self::Coordinate(table, breaks) => {
                let ahead = side.coordinate(state, period);
                let interval = breaks.interval(ahead);
                // Rounding of the shift must not put a repeated table before its first row.
                let argument = (ahead - interval.shift).max(interval.start);
                Active::segment(table.segment(argument), interval.shift)
            }
            Self::Speed(table) => Active::segment(table.segment(side.speed(state)), 0.0),
            Self::Time(table) => Active::segment(table.segment(side.time(state)), 0.0),
            Self::Stroke(stroke) => {
                let (piece, _) = stroke.piece(side.coordinate(state, period), side.sense);
                Active { piece, ..Active::default() }
            }
            Self::Formula(law) => Active::branches(law.branches(state, side, period)),
        }
    }

    /// The formula on a side of a state; cuts the `bounds` to those in which it is smooth.
    pub(crate) fn enter(
        &self,
        state: &LoadState,
        side: &Selection,
        period: Option<f64>,
        bounds: &mut Piece,
    ) -> Active {
        if let Self::Formula(law) = self {
            return Active::branches(law.enter(state, side, period, bounds));
        }
        let (active, ahead) = (self.at(state, side, period), side.coordinate(state, period));
        match self {
            Self::Constant(_) | Self::Formula(_) => {}
            Self::Coordinate(_, breaks) => cut(&mut bounds.coordinate, breaks.interval(ahead).ends),
            Self::Speed(table) => cut(&mut bounds.speed, table.ends(active.piece.segment)),
            Self::Time(table) => cut(&mut bounds.time, table.ends(active.piece.segment)),
            Self::Stroke(stroke) => cut(&mut bounds.coordinate, stroke.piece(ahead, side.sense).1),
        }
        active
    }

    /// The size of the load by one formula, continued beyond its ends; `point`: its place, m.
    #[inline(always)]
    pub(crate) fn value(&self, active: Active, state: &LoadState, point: [f64; 2]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Coordinate(table, _) => table.value(active.piece.segment, state.coordinate - active.shift),
            Self::Speed(table) => table.value(active.piece.segment, state.speed),
            Self::Time(table) => table.value(active.piece.segment, state.time),
            Self::Stroke(stroke) => stroke.value(active.piece, point),
            Self::Formula(law) => law.value(active.sides, state, point),
        }
    }
}
