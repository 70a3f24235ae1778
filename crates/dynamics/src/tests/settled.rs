//! Regimes checked by an independent method: the motion in time by dop853, turn after turn until it repeats, with the motor's
//! formulas written out here.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use assur_integrator::{
    Dependence, EquationOfMotion, MotionError, Piece, Reduced, Request, State, Trajectory, Until, find,
};

use assur_fixtures::scene;

use super::compiled;
use crate::{Machine, Steady, steady};

/// The motor of shaper-drive.toml on the crank, by theory.md section 5.
struct Hand<'a> {
    machine: Machine<'a>,
    linear: bool,
    ratio: f64,
    inertia: f64,
    sense: f64,
    driving: bool,
}

const SYNCHRONOUS: f64 = 1500.0 * PI / 30.0;
const RATED: f64 = 1410.0 * PI / 30.0;
const EFFICIENCY: f64 = 0.95;

impl Hand<'_> {
    fn motor(&self, w: f64) -> f64 {
        let torque = 1100.0 / RATED;
        if self.linear {
            return torque * (SYNCHRONOUS - w) / (SYNCHRONOUS - RATED);
        }
        let (s, sn, l) = (1.0 - w / SYNCHRONOUS, 1.0 - RATED / SYNCHRONOUS, 2.2_f64);
        let sk = sn * (l + (l * l - 1.0).sqrt());
        2.0 * l * torque / (s / sk + sk / s)
    }
}

impl EquationOfMotion for Hand<'_> {
    fn dependence(&self) -> Dependence {
        Dependence { moment_on_coordinate: true, moment_on_speed: true, ..Dependence::default() }
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        let mut piece = self.machine.enter(state)?;
        let synchronous = self.sense * SYNCHRONOUS / self.ratio;
        self.driving = self.sense * state.speed < synchronous.abs();
        piece.speed = match (self.driving, self.sense > 0.0) {
            (true, true) => [0.0, synchronous],
            (false, true) => [synchronous, f64::INFINITY],
            (true, false) => [synchronous, 0.0],
            (false, false) => [f64::NEG_INFINITY, synchronous],
        };
        Ok(piece)
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let mut found = self.machine.reduced(state)?;
        found.inertia += self.inertia;
        let eta = if self.driving { EFFICIENCY } else { 1.0 / EFFICIENCY };
        found.moment += self.sense * self.ratio * eta * self.motor(self.ratio * self.sense * state.speed);
        Ok(found)
    }
}

struct Settled {
    mean: f64,
    unevenness: f64,
}

/// Turns in time until the speed repeats; then the extremes of a densely sampled turn, by parabolas.
fn settled(text: &str, ratio: f64, inertia: f64) -> Settled {
    let (linkage, loads) = compiled(text);
    let sense = linkage.mechanism.input.sign();
    let linear = text.contains("linear");
    let machine = Machine::new(&linkage, &loads);
    let mut hand = Hand { machine, linear, ratio, inertia, sense, driving: true };
    let integrator = find("dop853").unwrap();
    let from = linkage.mechanism.input.from;
    let mut speed = sense * RATED / ratio;
    for turn in 0..500 {
        let initial = State { time: 0.0, coordinate: from, speed };
        let until = Until::Coordinate(from + sense * 2.0 * PI);
        let request = Request { tolerance: 1e-11, samples: 4000, ..Request::new(initial, until) };
        let found = integrator.solve(&mut hand, &request).unwrap();
        let change = (found.end.speed / speed - 1.0).abs();
        speed = found.end.speed;
        if change < 1e-11 {
            return extremes(&found);
        }
        assert!(turn < 499, "does not settle");
    }
    unreachable!()
}

/// By parabolas through three samples; where the load jumps between them, w(t) has a corner, whose speed is the event's.
fn extremes(found: &Trajectory) -> Settled {
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    let mut note = |speed: f64| (low, high) = (low.min(speed), high.max(speed));
    for event in &found.events {
        note(event.state.speed.abs());
    }
    for triple in found.samples.windows(3) {
        let [a, b, c] = [0, 1, 2].map(|i| triple[i].speed.abs());
        let times = triple[0].time..triple[2].time;
        let corner = found.events.iter().any(|event| times.contains(&event.state.time));
        if !corner && (b - a) * (c - b) <= 0.0 {
            note(b - (c - a).powi(2) / (8.0 * (a - 2.0 * b + c)));
        }
    }
    Settled { mean: 0.5 * (low + high), unevenness: (high - low) / (0.5 * (low + high)) }
}

fn check(text: &str) -> Steady {
    let (linkage, loads) = compiled(text);
    let found = steady(&linkage, &loads, None).unwrap();
    let regime = &found.regime;
    let ratio = regime.figures.ratio.unwrap();
    let on_motor = text.contains("flywheel_on = \"motor\"");
    let flywheel = if on_motor { regime.flywheel * ratio * ratio } else { regime.flywheel };
    let by_hand = settled(text, ratio, flywheel + 0.0045 * ratio * ratio);
    assert_relative_eq!(by_hand.mean, regime.figures.mean_speed.abs(), max_relative = 1e-8);
    assert_relative_eq!(by_hand.unevenness, regime.figures.unevenness, max_relative = 1e-8);
    assert!(regime.multiplier < 1.0);
    found
}

fn variant(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(scene("shaper-drive").to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

fn meets(found: &Steady) {
    assert_relative_eq!(found.regime.figures.mean_speed.abs(), 2.0 * PI, max_relative = 1e-10);
    assert_relative_eq!(found.regime.figures.unevenness, 0.05, max_relative = 1e-10);
}

#[test]
fn as_the_fixture_has_it() {
    meets(&check(scene("shaper-drive")));
}

#[test]
fn linear_characteristic() {
    meets(&check(&variant(&[("\"kloss\"", "\"linear\"")])));
}

#[test]
fn flywheel_on_the_motor() {
    let found = check(&variant(&[("flywheel_on = \"crank\"", "flywheel_on = \"motor\"")]));
    meets(&found);
    // The same machine: only the shaft that the wheel sits on differs.
    let ratio = found.regime.figures.ratio.unwrap();
    assert_relative_eq!(found.regime.flywheel * ratio * ratio, 101.9001, max_relative = 1e-6);
}

#[test]
fn clockwise() {
    let found = check(&variant(&[(
        "link = \"crank\"\npositions = 48",
        "link = \"crank\"\npositions = 48\ndirection = \"cw\"",
    )]));
    meets(&found);
    assert!(
        found.regime.figures.mean_speed < 0.0
            && found.regime.figures.speed_max < found.regime.figures.speed_min
    );
}

#[test]
fn fixed_ratio() {
    for ratio in ["23", "24.5", "25"] {
        let found = check(&variant(&[("ratio = \"solve\"", &format!("ratio = {ratio}"))]));
        assert_relative_eq!(found.regime.figures.unevenness, 0.05, max_relative = 1e-10);
    }
}

#[test]
fn fixed_flywheel() {
    for flywheel in ["2", "30", "500"] {
        let found = check(&variant(&[("flywheel = \"solve\"", &format!("flywheel = {flywheel}"))]));
        assert_relative_eq!(found.regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-10);
    }
}

#[test]
fn everything_given() {
    check(&variant(&[("ratio = \"solve\"", "ratio = 24"), ("flywheel = \"solve\"", "flywheel = 50")]));
}

#[test]
fn clockwise_on_the_motor_with_a_straight_line_and_other_wishes() {
    for (speed, unevenness) in [("40 rpm", "0.02"), ("60 rpm", "0.1"), ("50 rpm", "0.115")] {
        let found = check(&variant(&[
            ("positions = 48", "positions = 48\ndirection = \"cw\""),
            ("\"kloss\"", "\"linear\""),
            ("flywheel_on = \"crank\"", "flywheel_on = \"motor\""),
            ("60 rpm", speed),
            ("unevenness = 0.05", &format!("unevenness = {unevenness}")),
        ]));
        assert_relative_eq!(
            found.regime.figures.unevenness,
            unevenness.parse().unwrap(),
            max_relative = 1e-10
        );
    }
}

#[test]
fn no_flywheel_is_needed() {
    let found = check(&variant(&[("unevenness = 0.05", "unevenness = 0.6")]));
    assert!(found.regime.flywheel_needless && found.regime.flywheel == 0.0);
    assert!(found.regime.figures.unevenness < 0.6);
    assert_relative_eq!(found.regime.figures.mean_speed, 2.0 * PI, max_relative = 1e-10);
}
