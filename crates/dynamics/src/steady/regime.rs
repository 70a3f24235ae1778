//! A periodic regime and what follows from it.

use super::CycleRequest;
use super::approximate::Diagram;
use super::arc::Solution;
use super::collocation::{Nodal, RULE, S, product};
use super::report::{Effort, FlywheelByMethod, RegimeState, Trial, Turn};
use super::sweep::Setup;
use super::tuning::{Tuned, Wish};
use crate::shaft::{Shaft, Source};

/// What the search found.
#[derive(Debug)]
pub(crate) struct Reached {
    pub(crate) diagram: Diagram,
    pub(crate) request: CycleRequest,
    pub(crate) wanted_unevenness: Option<f64>,
    pub(crate) required_power: f64,
    pub(crate) effort: Effort,
    pub(crate) wish: Wish,
    pub(crate) tuned: Tuned,
}

/// The periodic regime. Speeds, moments and coordinates have the signs of the coordinate; "least" and "greatest" speed are
/// meant without the sign, so that a machine that runs clockwise is the mirror image of one that does not.
#[derive(Debug, Clone)]
pub struct Regime {
    /// Flywheel on its own shaft, without the rotor, kg m²: the given one, or the one found (0: none is needed).
    pub flywheel: f64,
    /// The wanted unevenness is met without a flywheel.
    pub flywheel_needless: bool,
    /// Flywheel and rotor reduced to the input shaft, kg m².
    pub shaft_inertia: f64,
    /// Gear ratio; `None` without a motor.
    pub ratio: Option<f64>,
    /// Mean speed (greatest + least)/2, rad/s.
    pub mean_speed: f64,
    /// (greatest - least)/mean.
    pub unevenness: f64,
    /// Least speed, rad/s.
    pub speed_min: f64,
    /// Greatest speed, rad/s.
    pub speed_max: f64,
    /// Where the speed is least, rad, within the first cycle.
    pub coordinate_at_min: f64,
    /// Where the speed is greatest, rad.
    pub coordinate_at_max: f64,
    /// Work of all moments from the least speed to the greatest, J (E example 2).
    pub excess_work: f64,
    /// Artobolevsky's dynamic unevenness: 2 δ/(way from the least speed to the greatest), 1/rad.
    pub dynamic_unevenness: f64,
    /// Power needed on the motor shaft, W, at the wanted mean speed; negative where the loads drive.
    pub required_power: f64,
    /// Constant moment of the drive along the coordinate, N m; `None` with a motor or without drive.
    pub torque: Option<f64>,
    /// Time of a cycle, s.
    pub cycle_time: f64,
    /// What a small change of the speed is multiplied by over a cycle: the regime is stable below 1; 1 where nothing
    /// restores the speed.
    pub multiplier: f64,
    /// The flywheel by the methods of the textbooks, and exactly.
    pub flywheel_by_method: Vec<FlywheelByMethod>,
    /// Trials of ratio and flywheel (S stage 6).
    pub trials: Vec<Trial>,
    /// Iteration to the periodic regime from the mean speed (S fig. 10); empty if the machine stalls in its first turn.
    pub turns: Vec<Turn>,
    /// What it cost, and how exact it is.
    pub effort: Effort,
    solution: Solution,
    first: Option<Solution>,
    times: Vec<(f64, Nodal)>,
}

impl Regime {
    pub(crate) fn new(reached: Reached, first: Option<Solution>, turns: Vec<Turn>) -> Self {
        let by_method = by_method(&reached);
        let Reached { request, wanted_unevenness, required_power, effort, tuned, .. } = reached;
        let Tuned { unknowns, solution, swing, trials } = tuned;
        let (way, shaft) = (solution.way, solution.setup.shaft);
        let (low, high) = (swing.least, swing.greatest);
        let energy = |at: &super::curve::Extreme| solution.arcs[at.piece].energy_at(at.theta);
        let swing_way = (high.at.x - low.at.x).rem_euclid(request.length);
        // Past the end of the cycle the energy begins anew, with what little a cycle may gain.
        let excess_work = energy(&high.at) - energy(&low.at);
        let (times, cycle_time) = times(&solution);
        Self {
            flywheel: unknowns.flywheel,
            flywheel_needless: wanted_unevenness.is_some() && unknowns.flywheel == 0.0,
            shaft_inertia: shaft.inertia,
            ratio: unknowns.ratio(),
            mean_speed: way.sense * swing.mean(),
            unevenness: swing.unevenness(),
            speed_min: way.sense * low.value,
            speed_max: way.sense * high.value,
            coordinate_at_min: way.coordinate(low.at.x.rem_euclid(request.length)),
            coordinate_at_max: way.coordinate(high.at.x.rem_euclid(request.length)),
            excess_work,
            dynamic_unevenness: 2.0 * swing.unevenness() / swing_way,
            required_power,
            torque: if let Source::Constant(moment) = shaft.source { Some(way.sense * moment) } else { None },
            cycle_time,
            multiplier: solution.multiplier(),
            flywheel_by_method: by_method,
            trials,
            turns,
            effort,
            solution,
            first,
            times,
        }
    }

    pub(crate) fn setup(&self) -> &Setup {
        &self.solution.setup
    }

    /// What is on the input shaft: an equation of motion with it has this regime.
    pub fn shaft(&self) -> Shaft {
        self.solution.setup.shaft
    }

    /// Whether small changes of the speed die out.
    pub fn is_stable(&self) -> bool {
        self.multiplier < 1.0
    }

    /// Time, speed, acceleration, moments and inertia at a coordinate, from the polynomials of the solution.
    pub fn state(&self, coordinate: f64) -> RegimeState {
        let x = self.solution.way.place(coordinate);
        state_at(&self.solution, Some(&self.times), x)
    }

    /// The first turn from the mean speed (S fig. 9) at the coordinate; `None` if the machine stalls in it.
    pub fn first_turn(&self, coordinate: f64) -> Option<RegimeState> {
        let first = self.first.as_ref()?;
        let times = times(first).0;
        Some(state_at(first, Some(&times), first.way.place(coordinate)))
    }

    /// Speeds at the nodes of the solution, rad/s, with the time that each stands for, s.
    pub(crate) fn weighted_speeds(&self) -> Vec<(f64, f64)> {
        let last = S - 1;
        let mut found = Vec::with_capacity(self.solution.arcs.len() * S);
        for arc in &self.solution.arcs {
            for i in 0..S {
                let v = (2.0 * arc.place(i + 1, &self.solution.setup.shaft).half_square).sqrt();
                found.push((v, arc.h * RULE.a[last][i] / v));
            }
        }
        found
    }

    /// Coordinates of the solution's nodes, in the order of the motion: as dense as the solution is.
    pub fn nodes(&self) -> Vec<f64> {
        let shaft = &self.solution.setup.shaft;
        let x = self.solution.nodes().map(|(arc, index)| arc.place(index, shaft).x);
        x.map(|x| self.solution.way.coordinate(x)).collect()
    }
}

fn state_at(solution: &Solution, times: Option<&[(f64, Nodal)]>, x: f64) -> RegimeState {
    let (way, shaft) = (solution.way, &solution.setup.shaft);
    let after = solution.arcs.partition_point(|arc| arc.x <= x);
    let index = after.saturating_sub(1);
    let Some(arc) = solution.arcs.get(index) else { return RegimeState::default() };
    let theta = (x - arc.x) / arc.h;
    let places: [super::arc::Place; S + 1] = std::array::from_fn(|i| arc.place(i, shaft));
    let over = |field: &dyn Fn(usize) -> f64| {
        RULE.interpolate(field(0), &std::array::from_fn(|i| field(i + 1)), theta)
    };
    let datum = |i: usize| if i == 0 { &arc.data.start } else { &arc.data.nodes[i - 1] };
    let v = (2.0 * over(&|i| places[i].half_square)).sqrt();
    let drive = |i: usize| shaft.moment(arc.factor, (2.0 * places[i].half_square).sqrt()).value;
    let total = |i: usize| if i == 0 { arc.first_moment } else { arc.moment[i - 1] };
    RegimeState {
        time: times
            .and_then(|times| times.get(index))
            .map_or(0.0, |(start, nodes)| RULE.interpolate(*start, nodes, theta)),
        speed: way.sense * v,
        acceleration: way.sense * over(&|i| places[i].acceleration),
        drive: way.sense * shaft.moment(arc.factor, v).value,
        load: way.sense * over(&|i| total(i) - drive(i)),
        inertia: over(&|i| datum(i).inertia),
        inertia_derivative: way.sense * over(&|i| datum(i).slope),
    }
}

/// Time at the start and the nodes of each arc, and of the whole cycle: the integral of dx/v.
fn times(solution: &Solution) -> (Vec<(f64, Nodal)>, f64) {
    let mut now = 0.0;
    let mut found = Vec::with_capacity(solution.arcs.len());
    for arc in &solution.arcs {
        let slowness: Nodal =
            std::array::from_fn(|i| 1.0 / (2.0 * arc.place(i + 1, &solution.setup.shaft).half_square).sqrt());
        let nodes = product(&RULE.a, &slowness).map(|part| now + arc.h * part);
        found.push((now, nodes));
        now = nodes[S - 1];
    }
    (found, now)
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

fn by_method(reached: &Reached) -> Vec<FlywheelByMethod> {
    let Reached { diagram, request, tuned, wish, .. } = reached;
    let swing = &tuned.swing;
    let unevenness = reached.wanted_unevenness.unwrap_or(swing.unevenness());
    let ratio = tuned.unknowns.ratio().unwrap_or(1.0);
    let rotor = ratio * ratio * wish.rotor;
    let found = diagram.approximate(swing.mean(), unevenness, request.constant_inertia, rotor);
    let exact = tuned.unknowns.flywheel;
    let to_shaft = if wish.on_motor { 1.0 / (ratio * ratio) } else { 1.0 };
    let row = |method, formula, reduced: f64| {
        let flywheel = reduced * to_shaft;
        FlywheelByMethod { method, formula, flywheel, difference: finite((flywheel - exact) / exact) }
    };
    vec![
        row("excess-work", "J = A/(w² δ), A with a constant drive, E eq. 10", found.excess),
        row("excess-work-less-inertia", "the same less other inertia, E eq. 9", found.less_inertia),
        row("mertsalov", "J = range(A - Jv w²/2)/(w² δ) less constant inertia", found.mertsalov),
        row("wittenbauer", "tangents of the energy-mass diagram, constant drive", found.wittenbauer),
        FlywheelByMethod {
            method: "exact",
            formula: "periodic solution with the drive",
            flywheel: exact,
            difference: finite(0.0),
        },
    ]
}
