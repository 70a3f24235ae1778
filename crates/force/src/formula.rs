//! Loads by formula: on which side of its switches a state lies, and where the smooth branch ends.

use std::sync::Arc;

use assur_formula::{Branches, Formula, Sign, Used, Variable, Variables};
use assur_integrator::{Piece, State, Stretch};
use assur_number::search::bisect;

use crate::breaks::{Breaks, cut};
use crate::{LoadFault, LoadState, grid::Span, place::PlaceCourse, state::Selection, stroke::Travel};

/// The greatest size of a load by formula in SI: that of a force or moment given as a number (docs/ranges.md). Beyond it the
/// rounding of a force across a guide outweighs all others.
const MOST: f64 = 1e15;

/// Relative difference below which an argument has the same value a cycle later.
const REPEATS: f64 = 1e-9;

/// Part of a cell between two places of an interval at which its sides are looked for.
const BESIDE: f64 = 0.381_966_011_250_105;

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FormulaLaw {
    formula: Formula,
    /// SI value of a result of 1.
    factor: f64,
    /// Integrators step onto its switches; else the motion is known in advance, or there is none.
    steps: bool,
    /// The switches at which it jumps, as bits.
    jumps: u32,
    /// The extremes of the point whose place is `x`.
    travel: Option<Travel>,
    /// Where switches that depend on the place of the point change.
    places: Places,
    /// The place of the point by the coordinate, and the switches that depend on it and are met on the way, as bits.
    met_places: (Option<Arc<PlaceCourse>>, u32),
}

/// Sides of the switches that depend on the place of a point, between coordinates of the cycle.
#[derive(Debug, Clone, PartialEq, Default)]
struct Places {
    breaks: Breaks,
    /// The sides of those switches in each interval.
    sides: Vec<Branches>,
    switches: u32,
}

/// How often a formula may change in a cycle: what follows its changes takes time and memory with their number.
const MOST_CHANGES: usize = 10_000;

/// The function of a switch as it is written, and where it stands in the formula, from 1.
fn place_of(formula: &Formula, switch: usize) -> (String, usize) {
    let span = &formula.switches()[switch].span;
    (formula.text()[span.clone()].to_owned(), span.start + 1)
}

/// Bounds of the products of two numbers within bounds.
fn products(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let all = a.map(|a| b.map(|b| a * b));
    let of = |pick: fn(f64, f64) -> f64| pick(pick(all[0][0], all[0][1]), pick(all[1][0], all[1][1]));
    [of(f64::min), of(f64::max)]
}

/// Whether a switch depends on speed or time and on something else.
fn is_mixed(used: Used) -> bool {
    (used.speed || used.time) && used.only().is_none()
}

impl FormulaLaw {
    /// A formula without places of points. `steps`: integrators must be able to step onto its switches.
    pub(crate) fn new(formula: Formula, factor: f64, steps: bool) -> Self {
        let jumps = formula.jumps();
        let switches = formula.switches().iter().enumerate();
        let met = switches.filter(|(_, switch)| steps && switch.used.place && is_mixed(switch.used));
        let met_places = (None, met.map(|(index, _)| 1 << index).sum());
        Self { formula, factor, steps, jumps, travel: None, places: Places::default(), met_places }
    }

    /// The switches whose changes are found from the place of a point: a bend that mixes it with speed or time needs none,
    /// since the motion is known then.
    fn by_place(&self) -> Vec<(usize, Used)> {
        let switches = self.formula.switches().iter().map(|switch| switch.used).enumerate();
        let is_found = |index: usize, used: Used| {
            let moves = used.speed || used.time;
            let is_met = self.met_places.1 >> index & 1 == 1;
            used.place && !is_met && (!moves || self.jumps >> index & 1 == 1)
        };
        switches.filter(|(index, used)| is_found(*index, *used)).collect()
    }

    /// Whether a switch depends on the place of a point and on speed or time, so that it does not repeat with the cycle.
    pub(crate) fn mixes_place(&self) -> bool {
        self.by_place().iter().any(|(_, used)| used.speed || used.time)
    }

    /// Whether switches that depend on the place of the point are met on the way of a motion that is calculated.
    pub(crate) fn meets_places(&self) -> bool {
        self.met_places.1 != 0
    }

    /// Takes the place of a point by the coordinate, for the switches that are met on the way.
    pub(crate) fn with_places(mut self, course: PlaceCourse) -> Self {
        self.met_places.0 = Some(Arc::new(course));
        self
    }

    /// Takes the place of a point along the travel for `x`; `motion` gives the state and the point, m, at a coordinate. What does not
    /// repeat with the cycle is met on the way of a motion that is calculated; of a known one `None`, over a span that repeats.
    pub(crate) fn along(
        mut self,
        travel: Travel,
        span: &Span,
        mut motion: impl FnMut(f64) -> Result<(LoadState, [f64; 2]), LoadFault>,
    ) -> Result<Option<Self>, LoadFault> {
        self.travel = Some(travel);
        let mut at = |q: f64| {
            let (LoadState { speed, time, .. }, point) = motion(q)?;
            Ok::<_, LoadFault>(Variables { coordinate: q, speed, time, place: travel.part(point) })
        };
        let mut points = Vec::new();
        for (index, used) in self.by_place() {
            let argument = |at: &Variables| self.formula.argument(index, at);
            if span.periodic && used.coordinate {
                let [first, last] = [at(span.at(0))?, at(span.at(span.cells))?].map(|at| argument(&at));
                if (first - last).abs() > REPEATS * first.abs().max(last.abs()).max(1.0) {
                    if !self.steps {
                        return Ok(None);
                    }
                    self.met_places.1 |= 1 << index;
                    continue;
                }
            }
            self.places.switches |= 1 << index;
            let mut before = at(span.at(0))?;
            for cell in 1..=span.cells {
                let after = at(span.at(cell))?;
                let side = Sign::of(argument(&before));
                if Sign::of(argument(&after)) != side {
                    // A position that is missing between two that exist ends the search there.
                    let stays = |q: f64| at(q).is_ok_and(|at| Sign::of(argument(&at)) == side);
                    points.push(bisect(before.coordinate, after.coordinate, 0.0, stays)[1]);
                }
                before = after;
            }
        }
        let breaks = Breaks::new(points, span.period());
        for index in 0..breaks.count() {
            let within = |q: f64| if span.periodic { q } else { q.clamp(span.from, span.from + span.length) };
            let inside = breaks.inside(index, span.ends());
            // The argument may just touch zero in the middle, at a dead point.
            let other = within(inside + BESIDE * (span.at(1) - span.at(0)));
            let other = if breaks.interval(other).index == index { other } else { inside };
            let (inside, other, mut sides) = (at(inside)?, at(other)?, Branches::default());
            for (switch, _) in self.by_place() {
                let sign = |at: &Variables| Sign::of(self.formula.argument(switch, at));
                let side = sign(&inside).filter(|side| *side != Sign::Zero).or_else(|| sign(&other));
                if let Some(side) = side {
                    sides.set(switch, side);
                }
            }
            self.places.sides.push(sides);
        }
        self.places.breaks = breaks;
        Ok(Some(self))
    }

    /// Variables on which it depends.
    pub(crate) fn used(&self) -> Used {
        self.formula.used()
    }

    /// The sides of its jumps at a state; where it bends, the formula itself holds.
    #[inline]
    pub(crate) fn branches(&self, state: &LoadState, side: &Selection, period: Option<f64>) -> Branches {
        if self.jumps == 0 {
            return Branches::default();
        }
        let mut found = self.of_places(side.coordinate(state, period)).only(self.jumps);
        for index in 0..self.formula.switches().len() {
            let bit = 1 << index;
            if self.jumps & bit != 0
                && self.places.switches & bit == 0
                && let Some(side) = self.side_ahead(index, state, side, period).0
            {
                found.set(index, side);
            }
        }
        found
    }

    /// The side of a switch just ahead of a state, and the variables there.
    fn side_ahead(
        &self,
        switch: usize,
        state: &LoadState,
        side: &Selection,
        period: Option<f64>,
    ) -> (Option<Sign>, Variables) {
        let used = self.formula.switches()[switch].used;
        let is_met = self.is_met(switch);
        let later = |distance| self.placed(side.later(state, period, distance));
        let ahead =
            |distance| if is_met { later(distance) } else { side.ahead(state, period, used, distance) };
        let (sign, distance) = self.formula.side_ahead(switch, ahead);
        (sign, ahead(distance))
    }

    /// Variables with the place of the point at their coordinate, as far as that is needed.
    fn placed(&self, at: Variables) -> Variables {
        let place = self.met_places.0.as_ref().map_or(at.place, |course| course.at(at.coordinate));
        Variables { place, ..at }
    }

    /// Whether a switch is met on the way of a motion that is calculated: no bound of one variable describes it.
    fn is_met(&self, switch: usize) -> bool {
        self.met_places.1 >> switch & 1 == 1 || self.steps && is_mixed(self.formula.switches()[switch].used)
    }

    /// The switches that are met on the way.
    pub(crate) fn met(&self) -> impl Iterator<Item = usize> {
        (0..self.formula.switches().len()).filter(|switch| self.is_met(*switch))
    }

    /// Whether all `sides` hold throughout a stretch of a motion, see [`EquationOfMotion::holds`](assur_integrator::EquationOfMotion::holds).
    pub(crate) fn holds(&self, sides: Branches, stretch: &Stretch) -> Option<bool> {
        let places = self.met_places.0.as_ref().map(|course| {
            let [place, slope] = course.bounds(stretch.states.coordinate);
            [place, products(slope, stretch.states.speed)]
        });
        let along = |name| match name {
            Variable::Coordinate => [stretch.states.coordinate, stretch.states.speed],
            Variable::Speed => [stretch.states.speed, stretch.acceleration],
            Variable::Time => [stretch.states.time, [1.0; 2]],
            Variable::Place => places.unwrap_or([[f64::NAN; 2]; 2]),
        };
        let State { time, coordinate, speed } = stretch.end;
        let end = self.placed(Variables { coordinate, speed, time, place: f64::NAN });
        let stays = |switch| self.formula.stays(switch, sides.side(switch)?, along, &end);
        let mut found = self.met().map(stays);
        found.try_fold(true, |all, stays| Some(stays? && all))
    }

    /// Takes the sides of the switches that are met on the way just ahead of a state with its acceleration. Returns the one that
    /// changes, as it is written and where.
    pub(crate) fn turn(
        &self,
        sides: &mut Branches,
        state: &LoadState,
        side: &Selection,
        period: Option<f64>,
    ) -> Option<(String, usize)> {
        let mut turned = None;
        for switch in self.met() {
            let ahead = self.side_ahead(switch, state, side, period).0;
            if let Some(ahead) = ahead.filter(|ahead| sides.side(switch) != Some(*ahead)) {
                sides.set(switch, ahead);
                turned = Some(place_of(&self.formula, switch));
            }
        }
        turned
    }

    fn of_places(&self, coordinate: f64) -> Branches {
        let Places { breaks, sides, .. } = &self.places;
        sides.get(breaks.interval(coordinate).index).copied().unwrap_or_default()
    }

    /// The smooth branch on a side of a state; cuts the `bounds` to those in which it applies.
    pub(crate) fn enter(
        &self,
        state: &LoadState,
        side: &Selection,
        period: Option<f64>,
        bounds: &mut Piece,
    ) -> Branches {
        let coordinate = side.coordinate(state, period);
        let mut found = self.of_places(coordinate);
        if self.places.switches != 0 {
            cut(&mut bounds.coordinate, self.places.breaks.interval(coordinate).ends);
        }
        for (index, switch) in self.formula.switches().iter().enumerate() {
            if switch.used.place && !self.is_met(index) {
                continue;
            }
            let (sign, from) = self.side_ahead(index, state, side, period);
            if let Some(sign) = sign {
                found.set(index, sign);
            }
            let until = |here: f64, path: &dyn Fn(f64) -> Variables| {
                [-1.0, 1.0].map(|along| self.formula.smooth_until(index, sign, here, along, path))
            };
            match switch.used.only() {
                _ if switch.used == Used::default() => {}
                // Under a known motion time passes with the coordinate.
                Some(Variable::Time) | None if !self.steps => {
                    cut(&mut bounds.coordinate, until(from.coordinate, &|q| side.passing(state, q)));
                }
                Some(Variable::Coordinate) => {
                    let path = |coordinate| Variables { coordinate, ..from };
                    cut(&mut bounds.coordinate, until(from.coordinate, &path));
                }
                Some(Variable::Speed) => {
                    cut(&mut bounds.speed, until(from.speed, &|speed| Variables { speed, ..from }));
                }
                Some(Variable::Time) => {
                    cut(&mut bounds.time, until(from.time, &|time| Variables { time, ..from }));
                }
                Some(Variable::Place) | None => {}
            }
        }
        found
    }

    /// Refuses a formula that changes too often between two coordinates; `motion` gives the state at a coordinate of a known
    /// motion. Switches that depend on places of points change as seldom as there are cells in which they are looked for.
    pub(crate) fn check_changes(
        &self,
        range: [f64; 2],
        motion: impl Fn(f64) -> LoadState,
    ) -> Result<(), LoadFault> {
        let at = |q: f64| {
            let LoadState { coordinate, speed, time, .. } = motion(q);
            Variables { coordinate, speed, time, place: f64::NAN }
        };
        let mut left = MOST_CHANGES;
        let changes_with_coordinate = |used: Used| {
            let follows = used.coordinate || used.time && !self.steps;
            follows && !used.place && !(used == Used { speed: true, ..Used::default() })
        };
        for (index, _) in self
            .formula
            .switches()
            .iter()
            .enumerate()
            .filter(|(_, switch)| changes_with_coordinate(switch.used))
        {
            let found = self.formula.changes_between(index, range, left, at);
            left = left.checked_sub(found).ok_or_else(|| {
                let (function, column) = place_of(&self.formula, index);
                LoadFault::ChangesTooOften { function, column, most: MOST_CHANGES }
            })?;
        }
        Ok(())
    }

    /// Its value on given sides; `point`: its place, m. Beyond [`MOST`] it is not a number, as where it divides by zero.
    #[inline]
    pub(crate) fn value(&self, branches: Branches, state: &LoadState, point: [f64; 2]) -> f64 {
        let place = self.travel.map_or(0.0, |travel| travel.part(point));
        let LoadState { coordinate, speed, time, .. } = *state;
        let value =
            self.factor * self.formula.value_on(&Variables { coordinate, speed, time, place }, branches);
        if value.abs() <= MOST { value } else { f64::NAN }
    }
}
