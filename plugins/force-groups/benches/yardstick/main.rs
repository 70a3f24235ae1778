//! What loads and reactions cost beside formulas that are written by hand for one mechanism with constant lengths:
//! `cargo bench -p assur-force-groups`.
//!
//! All contestants take turns in short rounds; the least time of each counts, since a shared machine only adds. The
//! formulas by hand find the same numbers: the bench compares them first. Figures: `docs/performance.md`.

#![allow(missing_docs, reason = "a program")]

mod andrews;
mod six_bar;

use std::hint::black_box;
use std::time::Instant;

use assur_all as _;
use assur_dynamics::Machine;
use assur_force::{Kinetostatics, LaneKinetostatics, Loads, State, choose};
use assur_group::Order;
use assur_integrator::Motion;
use assur_kinematics::Linkage;
use assur_number::{Formula, Lanes, Real};

/// The six-bar by hand at eight coordinates.
struct SixBar(Lanes);

impl Formula for SixBar {
    type Value = six_bar::Found<Lanes>;

    #[inline(always)]
    fn evaluate(self) -> six_bar::Found<Lanes> {
        let (s, c) = self.0.sin_cos();
        six_bar::by_hand([s, c])
    }
}

/// A contestant: its name, a call that solves a number of positions, and its least time for one, s.
struct Contestant<'a> {
    name: &'static str,
    call: Box<dyn FnMut(usize) + 'a>,
    least: f64,
}

impl<'a> Contestant<'a> {
    fn new(name: &'static str, call: impl FnMut(usize) + 'a) -> Self {
        Self { name, call: Box::new(call), least: f64::INFINITY }
    }
}

/// The coordinate of a position: none repeats, and whole turns are spread evenly.
fn coordinate(index: usize) -> f64 {
    (index % 4096) as f64 * 0.618
}

fn coordinates(block: usize) -> Lanes {
    Lanes::of(|lane| coordinate(block * Lanes::WIDTH + lane))
}

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
        let analyzer = choose(None).expect("an analyzer").instance;
        Kinetostatics::new(&self.linkage, &self.loads, analyzer, &vec![true; self.linkage.groups().len()])
    }

    fn states(&self, coordinates: Lanes) -> [State; Lanes::WIDTH] {
        coordinates.0.map(|coordinate| State::prescribed(&self.linkage.mechanism, coordinate))
    }

    fn one_by_one<'a>(&'a self, name: &'static str) -> Contestant<'a> {
        let (mut position, mut forces) = (self.linkage.position(), self.kinetostatics());
        Contestant::new(name, move |count| {
            for index in 0..count {
                let q = black_box(coordinate(index));
                let placed = self.linkage.solve(q, Order::Second, &mut position).is_ok();
                let solved = forces.solve(&State::prescribed(&self.linkage.mechanism, q), &position).is_ok();
                assert!(black_box(placed && solved));
            }
        })
    }

    fn eight_by_eight<'a>(&'a self, name: &'static str) -> Contestant<'a> {
        let mut position = self.linkage.lane_position();
        let mut forces = LaneKinetostatics::new(self.kinetostatics());
        Contestant::new(name, move |count| {
            for block in 0..count / Lanes::WIDTH {
                let q = black_box(coordinates(block));
                let placed = self.linkage.solve_lanes(q, Order::Second, &mut position).is_ok();
                let solved = forces.solve(&self.states(q), &position).is_ok();
                assert!(black_box(placed && solved));
            }
        })
    }

    /// The parts of a position: positions alone, loads, reactions, and reduction.
    fn parts(&self) -> Vec<Contestant<'_>> {
        let mut solved = vec![self.linkage.position(); 64];
        for (index, position) in solved.iter_mut().enumerate() {
            assert!(self.linkage.solve(coordinate(index), Order::Second, position).is_ok());
        }
        let state = |q: f64| State::prescribed(&self.linkage.mechanism, q);
        let (one, two, three) = (solved.clone(), solved.clone(), solved);
        let mut wrenches = vec![assur_group::Wrench::ZERO; self.linkage.structure.links];
        let mut forces = self.kinetostatics();
        let mut position = self.linkage.position();
        vec![
            Contestant::new("- position alone", move |count| {
                for index in 0..count {
                    let q = black_box(coordinate(index));
                    assert!(black_box(self.linkage.solve(q, Order::Second, &mut position).is_ok()));
                }
            }),
            Contestant::new("- loads alone", move |count| {
                for index in 0..count {
                    let position = &one[index % one.len()];
                    self.loads.evaluate(
                        &state(position.coordinate),
                        black_box(&position.bodies),
                        &mut wrenches,
                    );
                    black_box(&wrenches);
                }
            }),
            Contestant::new("- loads and reactions alone", move |count| {
                for index in 0..count {
                    let position = &two[index % two.len()];
                    assert!(forces.solve(&state(position.coordinate), black_box(position)).is_ok());
                }
            }),
            Contestant::new("- reduction alone", move |count| {
                for index in 0..count {
                    let position = &three[index % three.len()];
                    black_box(self.loads.reduced(&state(position.coordinate), black_box(&position.bodies)));
                }
            }),
        ]
    }

    /// The parts of eight positions.
    fn lane_parts(&self) -> Vec<Contestant<'_>> {
        let mut solved = vec![self.linkage.lane_position(); 8];
        for (block, position) in solved.iter_mut().enumerate() {
            assert!(self.linkage.solve_lanes(coordinates(block), Order::Second, position).is_ok());
        }
        let (one, two) = (solved.clone(), solved);
        let mut wrenches = vec![assur_group::Wrench::ZERO; self.linkage.structure.links];
        let mut forces = LaneKinetostatics::new(self.kinetostatics());
        let mut position = self.linkage.lane_position();
        vec![
            Contestant::new("- positions alone", move |count| {
                for block in 0..count / Lanes::WIDTH {
                    let q = black_box(coordinates(block));
                    assert!(black_box(self.linkage.solve_lanes(q, Order::Second, &mut position).is_ok()));
                }
            }),
            Contestant::new("- states alone", move |count| {
                for block in 0..count / Lanes::WIDTH {
                    black_box(self.states(black_box(coordinates(block))));
                }
            }),
            Contestant::new("- states and loads alone", move |count| {
                for block in 0..count / Lanes::WIDTH {
                    let position = black_box(&one[block % one.len()]);
                    self.loads.evaluate(&self.states(position.coordinates), &position.bodies, &mut wrenches);
                    black_box(&wrenches);
                }
            }),
            Contestant::new("- states, loads and reactions", move |count| {
                for block in 0..count / Lanes::WIDTH {
                    let position = black_box(&two[block % two.len()]);
                    assert!(forces.solve(&self.states(position.coordinates), position).is_ok());
                }
            }),
        ]
    }

    fn right_hand_side<'a>(&'a self, name: &'static str) -> Contestant<'a> {
        let mut machine = Machine::new(&self.linkage, &self.loads);
        Contestant::new(name, move |count| {
            for index in 0..count {
                black_box(acceleration(&mut machine, black_box(coordinate(index))));
            }
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
    for index in 0..50 {
        let q = coordinate(index);
        six_bar.linkage.solve(q, Order::Second, &mut position).expect("a position");
        forces.solve(&State::prescribed(&six_bar.linkage.mechanism, q), &position).expect("reactions");
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
            let joint = joints
                .iter()
                .position(|joint| assur_structure::name_of(&six_bar.linkage.mechanism, joint.id) == point);
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
    let accelerations = |index: usize| [coordinate(index), andrews::by_hand(coordinate(index), SPEED)];
    let greatest = (0..50).map(|index| accelerations(index)[1].abs()).fold(0.0, f64::max);
    for [q, wanted] in (0..50).map(accelerations) {
        near(acceleration(&mut machine, q), wanted, greatest);
    }
}

/// Positions of one contestant in one round, and rounds.
const COUNT: usize = 1024;
const ROUNDS: usize = 1500;

fn main() {
    let six_bar = Subject::of(six_bar::SCENE);
    let [shaper, andrews] = ["shaper", "andrews"].map(|name| Subject::of(assur_fixtures::scene(name)));
    compare(&six_bar, &andrews);
    let mut all = vec![
        Contestant::new("six-bar by hand", |count| {
            for index in 0..count {
                let (s, c) = black_box(coordinate(index)).sin_cos();
                black_box(six_bar::by_hand([s, c]));
            }
        }),
        six_bar.one_by_one("six-bar"),
    ];
    all.extend(six_bar.parts());
    all.extend([
        shaper.one_by_one("shaper of the fixtures"),
        Contestant::new("six-bar by hand, lanes", |count| {
            for block in 0..count / Lanes::WIDTH {
                black_box(Lanes::evaluate(SixBar(black_box(coordinates(block)))));
            }
        }),
        six_bar.eight_by_eight("six-bar, lanes"),
    ]);
    all.extend(six_bar.lane_parts());
    all.extend([
        shaper.eight_by_eight("shaper of the fixtures, lanes"),
        Contestant::new("Andrews by hand", |count| {
            for index in 0..count {
                black_box(andrews::by_hand(black_box(coordinate(index)), black_box(SPEED)));
            }
        }),
        andrews.right_hand_side("Andrews, right-hand side"),
    ]);
    all.extend(andrews.parts());
    for _ in 0..ROUNDS {
        for one in &mut all {
            let start = Instant::now();
            (one.call)(COUNT);
            one.least = one.least.min(start.elapsed().as_secs_f64() / COUNT as f64);
        }
    }
    println!("{:32} {:>8} {:>12}", "", "ns", "of by hand");
    let mut by_hand = f64::NAN;
    for one in &all {
        if one.name.contains("by hand") {
            by_hand = one.least;
        }
        println!("{:32} {:8.2} {:12.2}", one.name, one.least * 1e9, one.least / by_hand);
    }
}
