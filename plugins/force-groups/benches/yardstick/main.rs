//! What loads and reactions cost beside formulas that are written by hand for one mechanism with constant lengths:
//! `cargo bench -p assur-force-groups`.
//!
//! The formulas by hand find the same numbers: the bench compares them first. Figures: `docs/measured/performance.md`.

#![allow(missing_docs, reason = "a program")]

mod andrews;
mod six_bar;

use std::hint::black_box;

use assur_all as _;
use assur_dynamics::Machine;
use assur_force::{Kinetostatics, LaneKinetostatics, LoadState, Loads, choose};
use assur_group::Order;
use assur_integrator::EquationOfMotion;
use assur_kinematics::{LanePosition, Linkage, Position};
use assur_number::Lanes;
use assur_testkit::yardstick::{Contestant, coordinates, race};

/// A mechanism with its loads.
struct Subject {
    linkage: Linkage,
    loads: Loads,
}

impl Subject {
    fn of(text: &str) -> Self {
        let linkage = Linkage::compile(assur_scene::read("yardstick", text).expect("a good scene"));
        let linkage = linkage.expect("a good mechanism");
        let loads = Loads::compile(&linkage).expect("good loads");
        Self { linkage, loads }
    }

    fn kinetostatics(&self) -> Kinetostatics<'_> {
        let analyzer = choose(None, false, false).expect("an analyzer").instance;
        Kinetostatics::new(&self.linkage, &self.loads, analyzer, &vec![true; self.linkage.groups().len()])
    }

    fn states(&self, coordinates: Lanes) -> [LoadState; Lanes::WIDTH] {
        coordinates.0.map(|coordinate| LoadState::prescribed(&self.linkage.mechanism, coordinate))
    }

    fn state(&self, coordinate: f64) -> LoadState {
        LoadState::prescribed(&self.linkage.mechanism, coordinate)
    }

    fn one_by_one<'a>(&'a self, name: &'static str) -> Contestant<'a> {
        let (mut position, mut forces) = (self.linkage.position(), self.kinetostatics());
        Contestant::one_by_one(name, move |q| {
            let placed = self.linkage.solve(q, Order::Second, &mut position).is_ok();
            let solved = forces.solve(&self.state(q), &position).is_ok();
            assert!(black_box(placed && solved));
        })
    }

    fn eight_by_eight<'a>(&'a self, name: &'static str) -> Contestant<'a> {
        let mut position = self.linkage.lane_position();
        let mut forces = LaneKinetostatics::new(self.kinetostatics());
        Contestant::eight_by_eight(name, move |q| {
            let placed = self.linkage.solve_lanes(q, Order::Second, &mut position).is_ok();
            let solved = forces.solve(&self.states(q), &position).is_ok();
            assert!(black_box(placed && solved));
        })
    }

    /// Some solved positions.
    fn solved(&self) -> Vec<Position> {
        let mut position = self.linkage.position();
        let solved = coordinates().take(64).map(|q| {
            assert!(self.linkage.solve(q, Order::Second, &mut position).is_ok());
            position.clone()
        });
        solved.collect()
    }

    /// Some solved positions, eight at a time.
    fn solved_lanes(&self) -> Vec<LanePosition> {
        let mut position = self.linkage.lane_position();
        let mut all = coordinates();
        let solved = (0..8).map(|_| {
            let eight = Lanes::of(|_| all.next().unwrap_or_default());
            assert!(self.linkage.solve_lanes(eight, Order::Second, &mut position).is_ok());
            position.clone()
        });
        solved.collect()
    }

    /// The parts of a position: the position alone, loads, reactions, and reduction.
    fn parts<'a>(&'a self, solved: &'a [Position]) -> Vec<Contestant<'a>> {
        let [mut one, mut two, mut three] = [(); 3].map(|()| solved.iter().cycle());
        let mut wrenches = vec![assur_group::Wrench::ZERO; self.linkage.structure.links];
        let mut forces = self.kinetostatics();
        let mut position = self.linkage.position();
        vec![
            Contestant::one_by_one("- position alone", move |q| {
                assert!(black_box(self.linkage.solve(q, Order::Second, &mut position).is_ok()));
            }),
            Contestant::one_by_one("- loads alone", move |_| {
                let position = one.next().expect("a cycle");
                let state = self.state(position.coordinate);
                self.loads.evaluate(&state, black_box(&position.bodies), &mut wrenches);
                black_box(&wrenches);
            }),
            Contestant::one_by_one("- loads and reactions alone", move |_| {
                let position = two.next().expect("a cycle");
                assert!(forces.solve(&self.state(position.coordinate), black_box(position)).is_ok());
            }),
            Contestant::one_by_one("- reduction alone", move |_| {
                let position = three.next().expect("a cycle");
                let state = self.state(position.coordinate);
                black_box(self.loads.reduced(&state, black_box(&position.bodies)));
            }),
        ]
    }

    /// The parts of eight positions.
    fn lane_parts<'a>(&'a self, solved: &'a [LanePosition]) -> Vec<Contestant<'a>> {
        let [mut one, mut two] = [(); 2].map(|()| solved.iter().cycle());
        let mut wrenches = vec![assur_group::Wrench::ZERO; self.linkage.structure.links];
        let mut forces = LaneKinetostatics::new(self.kinetostatics());
        let mut position = self.linkage.lane_position();
        vec![
            Contestant::eight_by_eight("- positions alone", move |q| {
                assert!(black_box(self.linkage.solve_lanes(q, Order::Second, &mut position).is_ok()));
            }),
            Contestant::eight_by_eight("- states alone", move |q| {
                black_box(self.states(q));
            }),
            Contestant::eight_by_eight("- states and loads alone", move |_| {
                let position = black_box(one.next().expect("a cycle"));
                self.loads.evaluate(&self.states(position.coordinates), &position.bodies, &mut wrenches);
                black_box(&wrenches);
            }),
            Contestant::eight_by_eight("- states, loads and reactions", move |_| {
                let position = black_box(two.next().expect("a cycle"));
                assert!(forces.solve(&self.states(position.coordinates), position).is_ok());
            }),
        ]
    }

    fn right_hand_side<'a>(&'a self, name: &'static str) -> Contestant<'a> {
        let mut machine = Machine::new(&self.linkage, &self.loads);
        Contestant::one_by_one(name, move |q| {
            black_box(acceleration(&mut machine, q));
        })
    }
}

/// Speed at which right-hand sides are evaluated, rad/s.
const SPEED: f64 = 300.0;

fn acceleration(machine: &mut Machine<'_>, coordinate: f64) -> f64 {
    let state = assur_integrator::State { time: 0.0, coordinate, speed: SPEED };
    machine.acceleration(&state).unwrap_or(f64::NAN)
}

/// Panics unless the formulas by hand find what the program finds.
fn compare(six_bar: &Subject, andrews: &Subject) {
    let near = |a: f64, b: f64, size: f64| assert!((a - b).abs() < 1e-11 * size, "{a:e} and {b:e}");
    let (mut position, mut forces) = (six_bar.linkage.position(), six_bar.kinetostatics());
    let joints = assur_force::joints(&six_bar.linkage.mechanism, &six_bar.linkage.structure);
    for q in coordinates().take(50) {
        six_bar.linkage.solve(q, Order::Second, &mut position).expect("a position");
        forces.solve(&LoadState::prescribed(&six_bar.linkage.mechanism, q), &position).expect("reactions");
        let (s, c) = q.sin_cos();
        let found = six_bar::by_hand([s, c]);
        let pairs = &forces.reactions.pairs;
        let name = |link: usize| six_bar.linkage.mechanism.links[link].name.as_str();
        let force = |joint: usize, on: &str| {
            let links = joints[joint].links.iter().position(|link| name(*link) == on);
            joints[joint].force(links.expect("a link of the joint"), pairs)
        };
        let rocker = &position.bodies[3];
        let across = |force: [f64; 2]| rocker.c * force[1] - rocker.s * force[0];
        near(found.drive, forces.reactions.balancing, 1e3);
        let pins =
            [("O", "crank", found.on_crank), ("A", "stone", found.on_stone), ("B", "ram", found.on_ram)];
        for (point, on, wanted) in pins.into_iter().chain([("C", "rocker", found.on_rocker)]) {
            let joint =
                joints.iter().position(|joint| six_bar.linkage.mechanism.pair_name(joint.id) == point);
            let force = force(joint.expect("a pin"), on);
            near(force[0], wanted[0], 1e4);
            near(force[1], wanted[1], 1e4);
        }
        let slides = joints.len() - 3;
        for (slide, on) in [(0, "stone"), (1, "stone2")] {
            near(across(force(slides + slide, on)), found.guides[slide][0], 1e4);
            near(joints[slides + slide].moment(pairs).expect("a slide"), found.guides[slide][1], 1e3);
        }
        near(force(slides + 2, "ram")[1], found.of_ground[0], 1e4);
        near(joints[slides + 2].moment(pairs).expect("a slide"), found.of_ground[1], 1e3);
    }
    let mut machine = Machine::new(&andrews.linkage, &andrews.loads);
    machine.enter(&assur_integrator::State { time: 0.0, coordinate: 0.0, speed: SPEED }).expect("a piece");
    let accelerations = || coordinates().take(50).map(|q| [q, andrews::by_hand(q, SPEED)]);
    let greatest = accelerations().map(|[_, wanted]| wanted.abs()).fold(0.0, f64::max);
    for [q, wanted] in accelerations() {
        near(acceleration(&mut machine, q), wanted, greatest);
    }
}

const ROUNDS: usize = 1500;

fn main() {
    let six_bar = Subject::of(six_bar::SCENE);
    let [shaper, andrews] = ["shaper", "andrews"].map(|name| Subject::of(assur_fixtures::scene(name)));
    compare(&six_bar, &andrews);
    let (solved, solved_lanes, solved_andrews) = (six_bar.solved(), six_bar.solved_lanes(), andrews.solved());
    let mut all = vec![
        Contestant::one_by_one("six-bar by hand", |q| {
            let (s, c) = f64::sin_cos(q);
            black_box(six_bar::by_hand([s, c]));
        }),
        six_bar.one_by_one("six-bar"),
    ];
    all.extend(six_bar.parts(&solved));
    all.extend([
        shaper.one_by_one("shaper of the fixtures"),
        Contestant::by_hand_in_lanes("six-bar by hand, lanes", six_bar::by_hand),
        six_bar.eight_by_eight("six-bar, lanes"),
    ]);
    all.extend(six_bar.lane_parts(&solved_lanes));
    all.extend([
        shaper.eight_by_eight("shaper of the fixtures, lanes"),
        Contestant::one_by_one("Andrews by hand", |q| {
            black_box(andrews::by_hand(q, black_box(SPEED)));
        }),
        andrews.right_hand_side("Andrews, right-hand side"),
    ]);
    all.extend(andrews.parts(&solved_andrews));
    race(all, ROUNDS);
}
