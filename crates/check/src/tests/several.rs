//! Random mechanisms with two and three drives over time against an independent solution of the whole mechanism: places, derivatives by
//! time and by each coordinate, the load of each drive.

mod whole;

use assur_force::{LoadState, Loads, Reactions};
use assur_group::{Body, Order};
use assur_kinematics::Linkage;
use assur_mechanism::{Friction, PairId, Range, Surfaces, TimeLaw};
use assur_testkit::specimen::{Recipe, Rng, scene_text};
use nalgebra::DVector;

use super::{checks, hold, show};
use crate::case::Case;
use crate::check::Collector;
use crate::forces::CHECKS;
use crate::written::{Writer, given as given_loads};
use crate::{Chosen, Subject, equilibrium, methods, power};
use whole::{Law, Poses, Whole};

/// Random mechanisms that are compared.
const MECHANISMS: usize = 300;

/// Instants with a smaller determinant are too close to a singular position for differences.
const LEAST_HEALTH: f64 = 0.01;

/// A random mechanism as a scene with random laws, and the laws once more; `None` where they lead it out of its assembly.
fn scene(seed: u64) -> Option<(String, Linkage, Vec<Law>)> {
    let number = usize::try_from(seed).unwrap();
    let mechanism = Recipe::of(1 + number % 4).several(seed, 2 + number % 2).unwrap();
    let mut text = scene_text(&mechanism);
    let mut rng = Rng::new(seed);
    let Range::To(until) = mechanism.input.range else { panic!("no end") };
    let mut laws: Vec<Law> = Vec::new();
    for driver in &mechanism.input.drivers {
        let Some(TimeLaw::Uniform { from, rate }) = driver.law else { panic!("no even motion") };
        let (even, way) = (format!("from = {from:?}\nrate = {rate:?}"), rate * until);
        match rng.below(4) {
            0 => {
                let waves = rng.range(0.3, 3.0) / until;
                let formula = format!("{from:?} + {way:?}*(sin({waves:?}*t + 1) - sin(1))");
                text = text.replace(&even, &format!("over_time = {{ formula = \"{formula}\" }}"));
                laws.push(Box::new(move |t| from + way * ((waves * t + 1.0).sin() - 1.0_f64.sin())));
            }
            1 => {
                // A natural spline, or one that repeats within the motion; its knots are between the instants.
                let ends = if rng.chance(0.5) { [from + way, 1.1] } else { [from, 0.8] };
                let rows = [[0.0, from], [0.4 * until, from + 0.6 * way], [0.55 * until, from + 0.7 * way]];
                let rows = [rows[0], rows[1], rows[2], [ends[1] * until, ends[0]]];
                let table = format!("over_time = {{ table = {rows:?}, shape = \"smooth\" }}");
                text = text.replace(&even, &table);
                // The spline has tests of its own.
                let law = TimeLaw::smooth(&rows, until);
                laws.push(Box::new(move |t| law.at(t)[0]));
            }
            _ => laws.push(Box::new(move |t| from + rate * t)),
        }
    }
    let mechanism =
        assur_scene::read("scene.toml", &text).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
    let linkage = Linkage::compile(mechanism).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
    let mut position = linkage.position();
    let mut is_placed = |index| {
        linkage.solve_index(index, Order::Place, &mut position).is_ok()
            && position.health.iter().all(|health| health.abs() > LEAST_HEALTH)
    };
    (0..linkage.mechanism.input.positions).all(&mut is_placed).then_some((text, linkage, laws))
}

/// So many of them with their seeds.
fn scenes() -> impl Iterator<Item = (u64, (String, Linkage, Vec<Law>))> {
    (0..2 * MECHANISMS as u64).filter_map(|seed| Some((seed, scene(seed)?))).take(MECHANISMS)
}

/// The poses of all moving links, or derivatives of them: origin and angle.
fn poses(linkage: &Linkage, bodies: &[Body<f64>], of: impl Fn(&Body<f64>) -> [f64; 3]) -> Poses {
    let moving = &bodies[1..linkage.structure.links];
    DVector::from_iterator(3 * moving.len(), moving.iter().flat_map(of))
}

/// Numbers that were found in two ways, and how many could be judged.
#[derive(Debug, Default)]
struct Compared {
    judged: usize,
    all: usize,
}

impl Compared {
    /// `unit`: for each number of three (x, y, angle), that of a number in whose parts the limit is.
    fn add(&mut self, what: &str, found: &Poses, [mine, coarse]: [&Poses; 2], part: f64, size: f64) {
        let unit = |k: usize| if k % 3 == 2 { 1.0 } else { size };
        let largest = (0..found.len()).map(|k| mine[k].abs() / unit(k)).fold(0.0, f64::max);
        for k in 0..found.len() {
            self.one(what, found[k], [mine[k], coarse[k]], part * unit(k) * largest.max(1e-3));
        }
    }

    /// Differences with twice the step are 16 times as far off: the difference of both is more than the error of the finer one, but for
    /// rounding, which is `limit`.
    fn one(&mut self, what: &str, found: f64, [mine, coarse]: [f64; 2], limit: f64) {
        let error = (mine - coarse).abs();
        self.all += 1;
        self.judged += usize::from(error < 100.0 * limit);
        let off = (found - mine).abs();
        assert!(off <= limit + error, "{what}: {found} is off by {off:e} from {mine} ({error:e}, {limit:e})");
    }
}

#[test]
fn several_drives_move_and_load_a_mechanism_as_an_independent_solution_does() {
    let (mut compared, mut relative, mut kinds) = (Compared::default(), 0, std::collections::BTreeSet::new());
    for (seed, (text, linkage, laws)) in scenes() {
        let whole = Whole { mechanism: &linkage.mechanism, laws: &laws };
        for index in 0..linkage.mechanism.input.positions {
            compare(&linkage, &whole, index, &mut compared, &format!("seed {seed}, instant {index}\n{text}"));
        }
        relative += linkage.mechanism.input.drivers.iter().filter(|driver| driver.is_relative()).count();
        kinds.extend(linkage.structure.groups.iter().map(|group| group.plugin.name));
    }
    println!("{compared:?}, {relative} drives between moving links, {kinds:?}");
    assert!(compared.judged > compared.all / 20 * 19, "{compared:?}");
    assert!(relative > MECHANISMS / 2, "{relative}");
    let dyads = ["driven-link", "rrr", "rpr", "prp", "rrp", "rpp"];
    assert!(dyads.iter().all(|kind| kinds.contains(kind)) && kinds.len() > 20, "{kinds:?}");
}

fn compare(linkage: &Linkage, whole: &Whole<'_>, index: usize, compared: &mut Compared, what: &str) {
    let mechanism = &linkage.mechanism;
    let time = mechanism.input.coordinate(index);
    let size = linkage.structure.scale;
    let mut position = linkage.position();
    linkage.solve_index(index, Order::Second, &mut position).unwrap_or_else(|e| panic!("{what}: {e}"));
    let placed = poses(linkage, &position.bodies, |body| [body.x, body.y, body.s.atan2(body.c)]);
    let mut rng = Rng::new(index as u64);
    let disturbed = placed.map(|number| number + 1e-4 * size.min(1.0) * rng.range(-1.0, 1.0));
    let center = whole.solve(time, disturbed).unwrap_or_else(|| panic!("{what}: Newton's method fails"));
    let off = (center.poses() - &placed).amax();
    let condition: f64 = position.health.iter().map(|health| 1.0 / health.abs()).product();
    assert!(off < 1e-13 * condition * (1.0 + placed.amax()), "{what}: places are off by {off:e}");
    let until = mechanism.input.ends()[1];
    let find = |steps: f64| whole.find(time, &center, [steps * 2e-3 * until, steps * 1e-3], size);
    compared.all += 1;
    // Close to a singular position there is no room for differences.
    let (Some(fine), Some(coarse)) = (find(1.0), find(2.0)) else { return };
    compared.judged += 1;
    let velocity = poses(linkage, &position.bodies, |body| [body.x1, body.y1, body.w1]);
    let acceleration = poses(linkage, &position.bodies, |body| [body.x2, body.y2, body.w2]);
    // Rounding of 1e-16 of the places and its growth by the condition over the step, and over its square.
    compared.add(&format!("velocity, {what}"), &velocity, [&fine.motion[0], &coarse.motion[0]], 1e-9, size);
    let accelerations = [&fine.motion[1], &coarse.motion[1]];
    compared.add(&format!("acceleration, {what}"), &acceleration, accelerations, 1e-6, size);
    let loads = Loads::compile(linkage).unwrap();
    let state = LoadState::prescribed(mechanism, time);
    for method in methods(linkage, None).iter().filter(|method| method.gives_reactions) {
        let mut wrenches = loads.total(&state, &position.bodies);
        let mut reactions = Reactions::new(linkage);
        assur_force::solve_by(method.instance, linkage, &position, &mut wrenches, &mut reactions).unwrap();
        for drive in 0..mechanism.input.drivers.len() {
            let mut bodies = position.bodies.clone();
            linkage.derive_by(drive, time, &mut bodies).unwrap();
            let by_drive = poses(linkage, &bodies, |body| [body.x1, body.y1, body.w1]);
            let derivatives = [&fine.by_drive[drive], &coarse.by_drive[drive]];
            compared.add(&format!("by {drive}, {what}"), &by_drive, derivatives, 1e-9, size);
            let both = [fine.loads[drive], coarse.loads[drive]];
            let what = format!("load of drive {drive} by {}, {what}", method.name);
            compared.one(&what, reactions.drives[drive], both, 1e-6 * fine.sizes[drive] + 1e-9);
        }
    }
}

#[test]
fn every_check_holds_with_several_drives() {
    let (mut complete, mut checked) = (0, 0);
    for (seed, (text, linkage, _)) in scenes() {
        let all = checks(&linkage);
        assert!(hold(&all), "seed {seed}\n{}\n{text}", show(&all));
        complete += usize::from(all.len() >= 13);
        checked += 1;
    }
    assert_eq!(checked, MECHANISMS);
    // Where nothing heavy moves, there is no inertia to check.
    assert!(complete > MECHANISMS / 10 * 9, "{complete}");
}

/// The checks of powers and of equilibrium at an instant that fail where the load of a drive is wrong by a part of its size; `None` where
/// it is zero.
fn failed_with(linkage: &Linkage, loads: &Loads, (drive, part): (usize, f64)) -> Option<Vec<String>> {
    let state = LoadState::prescribed(&linkage.mechanism, linkage.mechanism.input.coordinate(1));
    let (all, given) = (Chosen::all(1), |_| Some(state));
    let subject = Subject {
        linkage,
        loads: Some(loads),
        positions: all.clone(),
        states: all,
        state: &given,
        drive: None,
        methods: methods(linkage, None),
    };
    let one = &subject.solve(1, state.coordinate).unwrap();
    let given = given_loads(loads, &state, &one.position.bodies);
    let items = &Writer::new(&subject).items(&given, &state, &one.position.bodies);
    let mut wrong = subject.answer(&subject.methods[0], loads, &state, &one.position, 1.0).unwrap();
    if wrong.drives[drive].abs() < 1e-9 {
        return None;
    }
    wrong.drives[drive] *= 1.0 + part;
    let joints = assur_force::joints(&linkage.mechanism, &linkage.structure);
    let joints = joints.iter().map(|joint| joint.reaction(&wrong.pairs)).collect();
    let answers = &[Some(wrong.clone())];
    let case = Case {
        subject: &subject,
        loads,
        one,
        state: &state,
        items,
        answers,
        full: 0,
        reactions: &wrong,
        joints,
    };
    let mut collectors = CHECKS.map(|(name, reason)| Collector::new(name, reason));
    let [_, links, joints, guides, _, reduced, lagrange, powers, drive, _] = &mut collectors;
    equilibrium::compare(&case, [links, joints, guides]);
    power::compare(&case, [reduced, lagrange, powers, drive]);
    let found = collectors.into_iter().filter_map(Collector::into_check);
    Some(found.filter(|check| check.finding.failed()).map(|check| check.name.to_string()).collect())
}

#[test]
fn a_wrong_load_of_any_drive_is_caught_by_power_and_by_equilibrium() {
    let mut planted = 0;
    for (seed, (text, linkage, _)) in scenes().take(60) {
        let loads = Loads::compile(&linkage).unwrap();
        for drive in 0..linkage.mechanism.input.drivers.len() {
            let Some(sound) = failed_with(&linkage, &loads, (drive, 0.0)) else { continue };
            assert_eq!(sound, [""; 0], "seed {seed}\n{text}");
            let caught = failed_with(&linkage, &loads, (drive, 1e-6)).unwrap();
            assert_eq!(
                caught,
                ["equilibrium of links", "virtual power"],
                "seed {seed}, drive {drive}\n{text}"
            );
            planted += 1;
        }
    }
    assert!(planted > 120, "{planted}");
}

#[test]
fn every_check_holds_with_several_drives_and_friction() {
    let (mut checked, mut rubbed) = (0, 0);
    for (seed, (text, linkage, _)) in scenes().take(150) {
        let mut mechanism = linkage.mechanism;
        let mut rng = Rng::new(seed);
        let size = linkage.structure.scale;
        let pins = mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin());
        let journals = pins.map(|(id, point)| {
            let (radius, owner) = (0.02 * size, rng.pick(&point.places).link);
            Friction {
                pair: PairId::Pin(id),
                coefficient: rng.range(0.05, 0.4),
                surfaces: Surfaces::Journal { radius, owner },
            }
        });
        mechanism.frictions = journals.collect();
        let all = checks(&Linkage::compile(mechanism).unwrap());
        assert!(all.iter().all(|check| !check.finding.failed()), "seed {seed}\n{}\n{text}", show(&all));
        checked += usize::from(hold(&all));
        rubbed += usize::from(all.iter().any(|check| check.name.to_string() == "friction of pairs"));
    }
    assert!(checked > 140 && rubbed > 140, "{checked} {rubbed}");
}

#[test]
fn every_check_holds_with_several_drives_at_rest() {
    let mut complete = 0;
    for (seed, (text, linkage, _)) in scenes().take(100) {
        let mut mechanism = linkage.mechanism;
        // As of a scene without a motion.
        (mechanism.motion, mechanism.input.positions, mechanism.input.range) = (None, 1, Range::To(0.0));
        mechanism.loads.retain(|load| !load.kind.is_against_motion());
        for spring in mechanism.loads.iter_mut().filter_map(|load| load.kind.spring_mut()) {
            spring.damping = 0.0;
        }
        let all = checks(&Linkage::compile(mechanism).unwrap());
        assert!(all.iter().all(|check| !check.finding.failed()), "seed {seed}\n{}\n{text}", show(&all));
        complete += usize::from(hold(&all) && all.len() >= 13);
    }
    assert!(complete > 90, "{complete}");
}
