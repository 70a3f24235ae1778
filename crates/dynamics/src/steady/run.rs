//! One cycle from a given kinetic energy: collocation on each panel by Newton's method, with the derivatives of the
//! energy with respect to its initial value, the drive and the flywheel (variational equation).

use super::path::{Coefficients, NodalCoefficients, Path, PathPanel, RULE, S, Values};
use super::segment::{Failure, Moment, Segment, Setup, Start, solve};
use super::solution::CycleSolution;
use crate::DynamicsError;

/// How often a panel may be halved where Newton's method fails.
const MOST_HALVINGS: usize = 12;

/// A run along the path.
struct Run<'r, 'a> {
    path: &'r mut Path<'a>,
    setup: Setup,
    /// The state at the place reached.
    state: Start,
    /// Interval of the speed in which the present formulas are valid.
    bounds: [f64; 2],
    /// At a crossing of such a bound: 1 if upward, -1 if downward; else 0.
    side: f64,
    /// dv/dx at the place reached.
    slope: f64,
    crossings: usize,
    segments: Vec<Segment>,
}

/// Runs one cycle from the kinetic energy `energy`; `guess` is a run nearby.
pub(crate) fn run_cycle(
    path: &mut Path<'_>,
    setup: Setup,
    panels: &[PathPanel],
    energy: f64,
    guess: Option<&CycleSolution>,
) -> Result<CycleSolution, DynamicsError> {
    let cycle = path.cycle;
    let mut run = Run {
        path,
        setup,
        state: Start { energy, derivatives: [1.0, 0.0, 0.0], factor: 1.0 },
        bounds: [0.0, f64::INFINITY],
        side: 0.0,
        slope: 0.0,
        crossings: 0,
        segments: Vec::with_capacity(panels.len() + 8),
    };
    let mut near = guess.map_or(&[][..], |solution| &solution.segments);
    for panel in panels {
        while let [first, rest @ ..] = near
            && first.x < panel.x
        {
            near = rest;
        }
        let bits = |[x, h]: [f64; 2]| [x.to_bits(), h.to_bits()];
        let same = |segment: &&Segment| bits([segment.x, segment.h]) == bits([panel.x, panel.h]);
        let start = near.first().filter(same);
        let start = start.map(|segment| &segment.energy);
        run.advance(panel.x, panel.h, &panel.coefficients, start, 0)?;
    }
    let Run { state: Start { energy: end, derivatives, .. }, segments, .. } = run;
    Ok(CycleSolution { setup, cycle, start: energy, end, derivatives, segments })
}

impl Run<'_, '_> {
    /// The speed at a place with the present energy; at a crossing, just beyond it.
    fn speed_beside(&self, at: &Coefficients) -> f64 {
        /// Far above rounding, far below any width between two rows of a table.
        const BESIDE: f64 = 1e-10;
        let speed = (2.0 * self.state.energy / (at.inertia + self.setup.drive.inertia)).sqrt();
        speed * (1.0 + self.side * BESIDE)
    }

    /// Chooses the branch of the drive, and the formulas of the loads if the given ones aren't valid at the speed.
    fn choose(
        &mut self,
        x: f64,
        h: f64,
        given: &NodalCoefficients,
    ) -> Result<NodalCoefficients, DynamicsError> {
        let v = self.speed_beside(&given.nodes[0]);
        let branch = self.setup.drive.branch(v);
        self.state.factor = branch.factor;
        let [low, high] = given.speed;
        let valid = v >= low && v <= high && !self.path.switches;
        let chosen = if valid { *given } else { self.coefficients(x, h, v)? };
        self.bounds = [branch.speed[0].max(chosen.speed[0]), branch.speed[1].min(chosen.speed[1])];
        Ok(chosen)
    }

    /// Coefficients of a stretch that is no panel, near the speed at `at`.
    fn beside(&mut self, x: f64, h: f64, at: &Coefficients) -> Result<NodalCoefficients, DynamicsError> {
        let v = self.speed_beside(at);
        self.coefficients(x, h, v)
    }

    /// Coefficients of a stretch that begins at the speed `v`; where switches over several variables tell which formulas hold, by
    /// those just ahead along the motion.
    fn coefficients(&mut self, x: f64, h: f64, v: f64) -> Result<NodalCoefficients, DynamicsError> {
        /// Part of a stretch: far above the rounding of a switch.
        const AHEAD: f64 = 1e-6;
        if !self.path.switches {
            return self.path.coefficients(x, h, v);
        }
        let [_, speed] = self.path.enter(x + AHEAD * h, v + self.slope * AHEAD * h)?;
        self.path.coefficients_entered([x, h], v, speed)
    }

    /// Where the formulas of a segment end: the part of it, and the side of the bound of the speed that it crosses, 0 at a switch.
    fn end_of_formulas(&self, segment: &Segment) -> Option<(f64, f64)> {
        let crossing = first_crossing(segment, &self.setup, self.bounds);
        let half_squares = segment.half_squares(&self.setup.drive);
        let switch = self.path.first_switch([segment.x, segment.h], &half_squares);
        let switch = switch.map(|[_, after]| (after, 0.0));
        let both = crossing.into_iter().chain(switch);
        both.min_by(|one, other| one.0.total_cmp(&other.0))
    }

    /// Solves a stretch of the path and advances to its end; if the formulas change inside, in several segments.
    fn advance(
        &mut self,
        x: f64,
        h: f64,
        given: &NodalCoefficients,
        guess: Option<&Values>,
        halvings: usize,
    ) -> Result<(), DynamicsError> {
        let coefficients = self.choose(x, h, given)?;
        match solve(&self.setup, &self.state, [x, h], &coefficients, guess) {
            Ok(segment) => match self.end_of_formulas(&segment) {
                None => {
                    self.keep(&segment);
                    Ok(())
                }
                Some((theta, side)) => self.cross(&segment, theta, side, halvings),
            },
            Err(_) if halvings < MOST_HALVINGS => {
                let half = 0.5 * h;
                let start = coefficients.nodes[0];
                let first = self.beside(x, half, &start)?;
                self.advance(x, half, &first, None, halvings + 1)?;
                let at = self.segments.last().map_or(start, |segment| segment.coefficients.nodes[S]);
                let second = self.beside(x + half, half, &at)?;
                self.advance(x + half, half, &second, None, halvings + 1)
            }
            Err(Failure { stalled }) => {
                let coordinate = self.path.cycle.coordinate(x);
                let stall = DynamicsError::Stalled(coordinate);
                Err(if stalled { stall } else { DynamicsError::NoPath(coordinate) })
            }
        }
    }

    fn keep(&mut self, segment: &Segment) {
        self.state.energy = segment.energy[S];
        self.state.derivatives = segment.derivatives.map(|values| values[S]);
        self.side = 0.0;
        let drive = &self.setup.drive;
        self.slope = segment.accelerations(drive)[S] / (2.0 * segment.half_squares(drive)[S]).sqrt();
        self.segments.push(*segment);
    }

    /// Advances to a crossing of the speed's bounds, or to a switch, by the old formulas, and beyond it by the new ones.
    fn cross(
        &mut self,
        segment: &Segment,
        theta: f64,
        side: f64,
        halvings: usize,
    ) -> Result<(), DynamicsError> {
        /// More crossings in one cycle are chatter, not motion.
        const MOST: usize = 1000;
        /// A crossing so near to the start is taken to be at the start.
        const AT_START: f64 = 1e-9;
        let (x, h) = (segment.x + theta * segment.h, (1.0 - theta) * segment.h);
        let coordinate = self.path.cycle.coordinate(x);
        self.crossings += 1;
        if self.crossings > MOST {
            return Err(DynamicsError::NoPath(coordinate));
        }
        let (mut at, mut before) = (segment.coefficients.nodes[0], segment.moment[0]);
        if theta > AT_START {
            let stretch = [segment.x, theta * segment.h];
            let coefficients = self.beside(stretch[0], stretch[1], &at)?;
            let part = solve(&self.setup, &self.state, stretch, &coefficients, None)
                .map_err(|_| DynamicsError::NoPath(coordinate))?;
            (at, before) = (part.coefficients.nodes[S], part.moment[S]);
            self.keep(&part);
        }
        let v = self.speed_beside(&at);
        let slope = if side == 0.0 { self.path.slope_of_switch(x, v, segment.h) } else { 0.0 };
        self.side = side;
        if h <= 1e-12 * self.path.cycle.length {
            return Ok(());
        }
        let coefficients = self.beside(x, h, &at)?;
        let coefficients = self.choose(x, h, &coefficients)?;
        let after = Moment::at(&self.setup, self.state.factor, &coefficients.nodes[0], self.state.energy);
        if !self.state.carry_over(&self.setup, &at, [before, after.value], [slope, side]) {
            return Err(DynamicsError::Held(coordinate));
        }
        self.advance(x, h, &coefficients, None, halvings)
    }
}

/// Where the speed first leaves the `bounds` of its formulas on a segment: the part of the segment, and 1 for a
/// crossing upward or -1 downward.
pub(crate) fn first_crossing(segment: &Segment, setup: &Setup, [low, high]: [f64; 2]) -> Option<(f64, f64)> {
    const SLACK: f64 = 1e-13;
    if low <= 0.0 && high == f64::INFINITY {
        return None;
    }
    let nodes = &segment.coefficients.nodes;
    let mut places: [(f64, f64, &Coefficients); S + 1] =
        std::array::from_fn(|i| (RULE.c[i], segment.energy[i], &nodes[i]));
    // The start is on the bound that was crossed last; the middle is examined instead.
    places[0] = (RULE.middle, segment.middle_energy(), &segment.coefficients.middle);
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut inside = 0.0;
    for (theta, energy, place) in places {
        let v = (2.0 * energy / (place.inertia + setup.drive.inertia)).sqrt();
        let (level, side) = if v > high * (1.0 + SLACK) {
            (high, 1.0)
        } else if v < low * (1.0 - SLACK) {
            (low, -1.0)
        } else {
            inside = theta;
            continue;
        };
        return Some((segment.crossing(level, &setup.drive, [inside, theta]), side));
    }
    None
}

impl Start {
    /// Carries the derivatives over a crossing at the place `at`, where the moment jumps: the crossing itself moves
    /// with the parameters. `moments`: before and after; `slope`: dv/dx of the line that is crossed; `side`: 1 upward, -1
    /// downward, 0 as the moment before leads. `false` if the moment after drives the motion back.
    pub(crate) fn carry_over(
        &mut self,
        setup: &Setup,
        at: &Coefficients,
        moments: [f64; 2],
        [slope, side]: [f64; 2],
    ) -> bool {
        let inertia = at.inertia + setup.drive.inertia;
        let half_square = self.energy / inertia;
        // The level T = J v²/2 rises with J, and with the speed of the line.
        let rise = at.slope * half_square + inertia * (2.0 * half_square).sqrt() * slope;
        let [approach, leaving] = moments.map(|moment| moment - rise);
        let side = if side == 0.0 { approach.signum() } else { side };
        if leaving * side <= 0.0 {
            return false;
        }
        let [by_ratio, by_flywheel] = setup.inertia_by;
        let level = [0.0, by_ratio * half_square, by_flywheel * half_square];
        for (derivative, level) in self.derivatives.iter_mut().zip(level) {
            // dx = -(dT - dB)/(M before - B'), dT after = dT + (M before - M after) dx
            *derivative -= (moments[0] - moments[1]) * (*derivative - level) / approach;
        }
        true
    }
}
