//! Groups and Newton-Euler share no formula: they must agree on mechanisms of every type of group, whatever the lengths,
//! the masses and the loads.

use assur_all as _;
use assur_force::{ForceAnalyzer, LoadState, Loads, Reactions, joints, power};
use assur_force_groups::Groups;
use assur_group::{Order, Wrench};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Balance, Direction, Force, Load, Mechanism, Place, Value};
use proptest::prelude::*;

use crate::NewtonEuler;

/// Types 3 and 5, 3 and 4, 1 and 2, 1 and 2 with a moving guide, three of type 1.
const SCENES: [&str; 5] = ["shaper", "guide-shaper", "conveyor", "stephenson3", "andrews"];

fn mechanism(name: &str) -> Mechanism {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    assur_scene::read(name, &std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Numbers in (-1, 1), one after the other.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 32).unwrap()) / f64::from(1_u32 << 31) - 1.0
    }

    fn pair(&mut self) -> [f64; 2] {
        [self.next(), self.next()]
    }
}

/// The same topology with other lengths, masses and loads.
fn shaken(name: &str, dice: &mut Dice) -> Mechanism {
    let mut mechanism = mechanism(name);
    for place in mechanism.points.iter_mut().flat_map(|point| &mut point.places) {
        place.at = place.at.map(|x| x * (1.0 + 0.02 * dice.next()));
    }
    for slide in &mut mechanism.slides {
        slide.tilt += 0.1 * dice.next();
        slide.through[1] += 0.002 * dice.next();
    }
    for link in mechanism.links.iter_mut().skip(1) {
        (link.mass, link.inertia, link.center) = (1.0 + dice.next(), (1.0 + dice.next()).into(), dice.pair());
    }
    mechanism.gravity = Some([dice.next(), -9.81]);
    mechanism.loads.clear();
    for link in 1..mechanism.links.len() {
        let at = Place { link, at: dice.pair() };
        let direction = Direction::Ground(3.0 * dice.next());
        let value = Value::Constant(100.0 * dice.next());
        mechanism.loads.push(Load::new(format!("force {link}"), Force { at, direction, value }));
    }
    mechanism
}

/// Both answers, the loads and the position; `None` where the mechanism can't be assembled or is nearly singular.
fn both(linkage: &Linkage, q: f64) -> Option<([Reactions; 2], Vec<Wrench<f64>>, Position)> {
    let loads = Loads::compile(linkage).unwrap();
    let mut position = linkage.position();
    linkage.solve(q, Order::Second, &mut position).ok()?;
    if position.health.iter().any(|health| health.abs() < 0.05) {
        return None;
    }
    let state = LoadState { coordinate: q, speed: 6.0, acceleration: -9.0, ..LoadState::default() };
    let mut all = vec![Wrench::ZERO; linkage.structure.links];
    loads.evaluate(&state, &position.bodies, &mut all);
    let methods: [&dyn ForceAnalyzer; 2] = [&Groups, &NewtonEuler];
    let answers = methods.map(|method| {
        method.supports(linkage).unwrap();
        let mut out = Reactions::new(linkage);
        method.solve(linkage, &position, &mut all.clone(), &mut out).ok().map(|()| out)
    });
    let [Some(one), Some(two)] = answers else { return None };
    Some(([one, two], all, position))
}

fn assert_same(answers: &[Reactions; 2]) -> Result<(), TestCaseError> {
    let [one, two] = answers;
    let size =
        one.pairs.iter().map(|r| r.fx.abs() + r.fy.abs() + r.m.abs()).fold(one.balancing.abs(), f64::max);
    prop_assert!((one.balancing - two.balancing).abs() <= 1e-10 * size);
    for (a, b) in one.pairs.iter().zip(&two.pairs) {
        let gap = (a.fx - b.fx).abs() + (a.fy - b.fy).abs() + (a.m - b.m).abs();
        prop_assert!(gap <= 1e-10 * size, "{a:?} {b:?}");
    }
    Ok(())
}

proptest! {
    #[test]
    fn both_methods_agree(seed: u64, q in -6.0..6.0f64) {
        let mut dice = Dice(seed);
        for name in SCENES {
            let linkage = Linkage::compile(shaken(name, &mut dice)).unwrap();
            let Some((answers, all, position)) = both(&linkage, q) else { continue };
            assert_same(&answers)?;
            // Virtual power, a third way to the balancing moment.
            let each = all.iter().zip(&position.bodies).map(|(load, body)| power(load, body));
            let (sum, size) = each.fold((0.0, 0.0), |(s, t): (f64, f64), p| (s + p, t + p.abs()));
            prop_assert!((answers[1].balancing + sum).abs() <= 1e-10 * size);
        }
    }

    #[test]
    fn both_methods_agree_on_a_balancing_load_elsewhere(seed: u64, q in -6.0..6.0f64) {
        let mut dice = Dice(seed);
        for name in SCENES {
            let mut mechanism = shaken(name, &mut dice);
            let link = mechanism.links.len() - 1;
            let at = Place { link, at: dice.pair() };
            mechanism.balance = Some(Balance::Force { at, angle: 3.0 * dice.next() });
            let linkage = Linkage::compile(mechanism).unwrap();
            let Some((answers, ..)) = both(&linkage, q) else { continue };
            assert_same(&answers)?;
        }
    }
}

#[test]
fn forces_of_a_joint_add_up_to_nothing() {
    let linkage = Linkage::compile(mechanism("andrews")).unwrap();
    let (answers, ..) = both(&linkage, 0.3).unwrap();
    for joint in
        joints(&linkage.mechanism, &linkage.structure).iter().map(|joint| joint.reaction(&answers[1].pairs))
    {
        let sum = joint.forces.iter().fold([0.0, 0.0], |s, (_, f)| [s[0] + f[0], s[1] + f[1]]);
        assert!(sum[0].abs() + sum[1].abs() < 1e-12, "{joint:?}");
    }
}

#[test]
fn shaken_mechanisms_are_mostly_solvable() {
    for name in SCENES {
        let solved = (0..40).filter(|seed| {
            let linkage = Linkage::compile(shaken(name, &mut Dice(*seed))).unwrap();
            both(&linkage, 0.3).is_some()
        });
        // Otherwise the agreement above would compare nothing.
        assert!(solved.count() >= 30, "{name}");
    }
}
