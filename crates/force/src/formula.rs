//! Loads by formula: which smooth branch applies, and where it ends.

use assur_formula::{Formula, Used, Variable, Variables};
use assur_integrator::Piece;
use assur_number::search::bisect;

use crate::State;
use crate::breaks::{Breaks, cut};
use crate::grid::Span;
use crate::state::Selection;
use crate::stroke::Travel;

/// Relative difference below which an argument has the same value a cycle later.
const REPEATS: f64 = 1e-9;

/// A formula, compiled.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FormulaLaw {
    formula: Formula,
    /// SI value of a result of 1.
    factor: f64,
    /// The extremes of the point whose place is `x`.
    travel: Option<Travel>,
    /// Where switches that depend on the place of the point change.
    places: Places,
}

/// Sides of the switches that depend on the place of a point, between coordinates of the cycle.
#[derive(Debug, Clone, PartialEq, Default)]
struct Places {
    breaks: Breaks,
    /// The sides of those switches in each interval.
    sides: Vec<u32>,
    /// Which switches they are.
    switches: u32,
}

/// A switch whose changes can't be found in advance; its index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Unlocated(pub(crate) usize);

/// The only variable on which a switch depends, if it is one of those that an integrator steps along.
fn variable_of(used: Used) -> Option<Variable> {
    match used {
        Used { place: true, .. } => None,
        Used { coordinate: true, speed: false, time: false, .. } => Some(Variable::Coordinate),
        Used { coordinate: false, speed: true, time: false, .. } => Some(Variable::Speed),
        Used { coordinate: false, speed: false, time: true, .. } => Some(Variable::Time),
        _ => None,
    }
}

impl FormulaLaw {
    /// A formula without places of points. `steps`: integrators must be able to step onto its jumps.
    pub(crate) fn new(formula: Formula, factor: f64, steps: bool) -> Result<Self, Unlocated> {
        let mixed = |used: Used| used != Used::default() && !used.place && variable_of(used).is_none();
        let found = formula.switches().iter().position(|switch| mixed(switch.used));
        match found.filter(|_| steps) {
            Some(index) => Err(Unlocated(index)),
            None => Ok(Self { formula, factor, travel: None, places: Places::default() }),
        }
    }

    /// Takes the place of a point along the travel for `x`; `point` gives it at a coordinate, m.
    pub(crate) fn along<E>(
        mut self,
        travel: Travel,
        span: &Span,
        mut point: impl FnMut(f64) -> Result<[f64; 2], E>,
    ) -> Result<Result<Self, Unlocated>, E> {
        self.travel = Some(travel);
        let mut points = Vec::new();
        let mut at = |q: f64| {
            let place = travel.part(point(q)?);
            Ok::<_, E>(Variables { coordinate: q, place, ..Variables::default() })
        };
        for (index, switch) in
            self.formula.switches().iter().enumerate().filter(|(_, switch)| switch.used.place)
        {
            if switch.used.speed || switch.used.time {
                return Ok(Err(Unlocated(index)));
            }
            self.places.switches |= 1 << index;
            let argument = |at: &Variables| self.formula.argument(index, at);
            let mut before = at(span.at(0))?;
            for cell in 1..=span.cells {
                let after = at(span.at(cell))?;
                if (argument(&before) >= 0.0) != (argument(&after) >= 0.0) {
                    let side = argument(&before) >= 0.0;
                    // A position that is missing between two that exist ends the search there.
                    let stays = |q: f64| at(q).is_ok_and(|at| (argument(&at) >= 0.0) == side);
                    points.push(bisect(before.coordinate, after.coordinate, 0.0, stays)[1]);
                }
                before = after;
            }
            if span.periodic && switch.used.coordinate {
                let [first, last] = [at(span.at(0))?, before].map(|at| argument(&at));
                if (first - last).abs() > REPEATS * first.abs().max(last.abs()).max(1.0) {
                    return Ok(Err(Unlocated(index)));
                }
            }
        }
        let breaks = Breaks::new(points, span.periodic.then_some(span.length));
        for index in 0..breaks.count() {
            let q = breaks.inside(index);
            let q = if span.periodic { q } else { q.clamp(span.from, span.from + span.length) };
            self.places.sides.push(self.formula.branches(&at(q)?) & self.places.switches);
        }
        self.places.breaks = breaks;
        Ok(Ok(self))
    }

    /// Variables on which it depends.
    pub(crate) fn used(&self) -> Used {
        self.formula.used()
    }

    /// The smooth branch on a side of a state, as the sides of all switches.
    #[inline]
    pub(crate) fn branches(&self, state: &State, side: &Selection, period: Option<f64>) -> u32 {
        self.branches_at(&beside(state, side, period))
    }

    fn branches_at(&self, at: &Variables) -> u32 {
        let Places { breaks, sides, switches } = &self.places;
        let of_places = sides.get(breaks.interval(at.coordinate).index).copied().unwrap_or(0);
        if self.formula.switches().is_empty() { 0 } else { self.formula.branches(at) & !switches | of_places }
    }

    /// The smooth branch on a side of a state; cuts the `bounds` to those in which it applies.
    pub(crate) fn enter(
        &self,
        state: &State,
        side: &Selection,
        period: Option<f64>,
        bounds: &mut Piece,
    ) -> u32 {
        let at = beside(state, side, period);
        for (index, switch) in self.formula.switches().iter().enumerate() {
            let Some(variable) = variable_of(switch.used) else { continue };
            let ends = [-1.0, 1.0].map(|along| self.formula.smooth_until(index, &at, variable, along));
            match variable {
                Variable::Coordinate => cut(&mut bounds.coordinate, ends),
                Variable::Speed => cut(&mut bounds.speed, ends),
                Variable::Time => cut(&mut bounds.time, ends),
                Variable::Place => {}
            }
        }
        if self.places.switches != 0 {
            cut(&mut bounds.coordinate, self.places.breaks.interval(at.coordinate).ends);
        }
        self.branches_at(&at)
    }

    /// Its value on one branch; `point`: its place, m.
    #[inline]
    pub(crate) fn value(&self, branches: u32, state: &State, point: [f64; 2]) -> f64 {
        let place = self.travel.map_or(0.0, |travel| travel.part(point));
        let State { coordinate, speed, time, .. } = *state;
        self.factor * self.formula.value_on(&Variables { coordinate, speed, time, place }, branches)
    }
}

/// The variables at which the branch is chosen; the place of a point is not among them.
fn beside(state: &State, side: &Selection, period: Option<f64>) -> Variables {
    Variables {
        coordinate: side.coordinate(state, period),
        speed: side.speed(state),
        time: side.time(state),
        place: f64::NAN,
    }
}
