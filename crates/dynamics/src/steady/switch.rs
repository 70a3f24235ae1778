//! Where a formula changes along the path at a place that several variables determine together, as `min(w, q)` does.

use assur_integrator::{Part, Piece, State, Stretch, first_change};
use assur_number::panel::Bernstein;
use assur_number::search::bisect;

use super::path::{CyclePath, Path, RULE, S, Values};

/// A part of a motion along the path.
#[derive(Clone, Copy)]
struct PathPart {
    cycle: CyclePath,
    /// The whole: where it begins, and its length.
    whole: [f64; 2],
    ends: [f64; 2],
    /// v²/2.
    half_square: Bernstein<{ S + 1 }>,
}

impl Part for PathPart {
    fn ends(&self) -> [f64; 2] {
        self.ends
    }

    fn halves(&self) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = f64::midpoint(from, to);
        let [first, second] = self.half_square.halves();
        let half = |ends, half_square| Self { ends, half_square, ..*self };
        [half([middle, to], second), half([from, middle], first)]
    }

    fn stretch(&self) -> Stretch {
        let ([x, h], sense) = (self.whole, self.cycle.sense);
        let signed = |[low, high]: [f64; 2]| if sense > 0.0 { [low, high] } else { [-high, -low] };
        let speed = |half: f64| (2.0 * half.max(0.0)).sqrt();
        let [from, to] = self.ends.map(|theta| self.cycle.coordinate(x + theta * h));
        let states = Piece {
            coordinate: [from.min(to), from.max(to)],
            speed: signed(self.half_square.bounds().map(speed)),
            time: [0.0; 2],
        };
        // d(v²/2)/dx is the acceleration.
        let acceleration = signed(self.half_square.slopes((self.ends[1] - self.ends[0]) * h));
        let end = State { time: 0.0, coordinate: to, speed: sense * speed(self.half_square.end()) };
        Stretch { states, acceleration, end }
    }
}

impl Path<'_> {
    /// Where the formulas entered last end on a stretch of the path, as parts of it: where they hold for the last time, and just
    /// beyond; with v²/2 at the start and the nodes.
    pub(crate) fn first_switch(&self, [x, h]: [f64; 2], half_squares: &Values) -> Option<[f64; 2]> {
        if !self.switches {
            return None;
        }
        let half_square = Bernstein::through(&RULE.c, half_squares);
        let whole = PathPart { cycle: self.cycle, whole: [x, h], ends: [0.0, 1.0], half_square };
        let speed = |theta| (2.0 * RULE.interpolate(half_squares, theta)).sqrt();
        first_change(whole, |theta| self.state(x + theta * h, speed(theta)), |stretch| self.holds(stretch))
    }

    /// dv/dx of the line in the plane of x and v at which the formulas entered last end, near a state on it; infinite where a
    /// place x is such a line, or none is found.
    pub(crate) fn slope_of_switch(&self, x: f64, v: f64, length: f64) -> f64 {
        /// Part of the length, and of the speed within which the line is looked for.
        const BESIDE: f64 = 1e-5;
        const WITHIN: f64 = 1e-2;
        let holds = |x: f64, v: f64| self.holds(&Stretch::at(self.state(x, v))) != Some(false);
        let at = |x: f64| {
            let ends = [1.0 - WITHIN, 1.0 + WITHIN].map(|part| part * v);
            let [low, high] = ends.map(|v| holds(x, v));
            (low != high).then(|| bisect(ends[0], ends[1], 0.0, |v| holds(x, v) == low)[1])
        };
        let beside = BESIDE * length;
        match [at(x - beside), at(x + beside)] {
            [Some(before), Some(after)] => (after - before) / (2.0 * beside),
            _ => f64::INFINITY,
        }
    }
}
