//! How wide the limits of the checks of motions are: an error of twice the limit must be caught in each of 50 random mechanisms.
//!
//! Not planted is the unevenness of a motor: its error is one of the motor's catalogue entry, and its limit stands once.

use assur_check::Check;
use assur_dynamics::{Steady, Transient};
use assur_mechanism::{
    Balance, Drive, FlywheelPlace, Mechanism, Motion, Over, Range, Solve, Torque, Until, Value,
};
use assur_testkit::specimen::Recipe;

use crate::{Calculation, InputMotion, Options, unwatched};

const MECHANISMS: usize = 50;

/// A motion that is found, with its drive.
type Asked = (Motion, Option<Drive>);

/// Random mechanisms of one or two groups, without what `remove` removes, in a motion.
fn calculations(
    motion: fn(&Mechanism) -> Option<Asked>,
    remove: fn(&mut Mechanism),
) -> impl Iterator<Item = (u64, Calculation)> {
    (0..1000).filter_map(move |seed| {
        let mut mechanism = Recipe::of(1 + usize::try_from(seed).ok()? % 2).specimen(seed)?.mechanism;
        remove(&mut mechanism);
        let (motion, drive) = motion(&mechanism)?;
        (mechanism.motion, mechanism.drive) = (Some(motion), drive);
        mechanism.balance = None::<Balance>;
        let found = Calculation::of(mechanism, &Options::default(), &mut unwatched).ok()?;
        found.no_motion.is_none().then_some((seed, found))
    })
}

fn one(all: &[Check], name: &str) -> Option<Check> {
    all.iter().find(|check| check.name.to_string() == name).cloned()
}

/// Whether a check holds as it is and fails with twice its limit.
fn assert_caught(what: &str, sound: &Check, wrong: &Check) {
    assert!(sound.finding.holds == Some(true), "{what}: {sound:?}");
    assert!(wrong.finding.failed(), "{what}: twice the limit is not caught: {wrong:?}");
    let share = wrong.finding.error / wrong.finding.bound;
    assert!((1.0..=3.1).contains(&share), "{what}: {share}: {wrong:?} after {sound:?}");
}

/// A tenth of a second from a speed, until the first turning point at most.
fn released(mechanism: &Mechanism) -> Option<Asked> {
    let Some(Motion::Prescribed { speed, .. }) = mechanism.motion else { return None };
    // Within the range in which the mechanism stays away from singular positions.
    let way = match mechanism.input.range {
        Range::Cycle(cycle) => cycle,
        Range::To(to) => 0.9 * (to - mechanism.input.from),
    };
    let sign = if matches!(mechanism.input.range, Range::Cycle(_)) { speed.signum() } else { way.signum() };
    let motion = Motion::Transient {
        speed: sign * speed.abs(),
        until: Until::Time((0.2 * way.abs() / speed.abs()).min(0.1)),
        samples: 8,
        integrator: "auto".to_owned(),
        tolerance: 1e-9,
        step: None,
        max_steps: None,
    };
    Some((motion, None))
}

fn keep_weights_and_springs(mechanism: &mut Mechanism) {
    mechanism.loads.retain(|load| load.kind.spring().is_some());
    mechanism
        .loads
        .iter_mut()
        .filter_map(|load| load.kind.spring_mut())
        .for_each(|spring| spring.damping = 0.0);
}

#[test]
fn energy_that_changes_by_twice_the_limit_is_caught() {
    let mut caught = 0;
    let name = "energy";
    for (seed, calculation) in calculations(released, keep_weights_and_springs) {
        let InputMotion::Transient(found) = &calculation.motion else { continue };
        let check = |energy: f64| {
            let mut wrong = Transient::clone(found);
            wrong.energy.change += energy;
            one(&calculation.transient_checks(&wrong), name)
        };
        let Some(sound) = check(0.0).filter(|check| check.finding.holds.is_some()) else { continue };
        // A motion in a tenth of a second is known to a millionth of its energy at least.
        assert!(sound.finding.bound < 1e-6, "seed {seed}: {sound:?}");
        assert_caught(&format!("{name}, seed {seed}"), &sound, &check(2.0 * sound.finding.bound).unwrap());
        caught += 1;
        if caught == MECHANISMS {
            return;
        }
    }
    panic!("only {caught} mechanisms");
}

/// A crank in steady rotation: a constant moment of the drive makes up for the work of the loads.
fn turning(mechanism: &Mechanism) -> Option<Asked> {
    let Some(Motion::Prescribed { speed, .. }) = mechanism.motion else { return None };
    matches!(mechanism.input.range, Range::Cycle(_)).then_some(())?;
    let unevenness = Some(Solve::Given(0.05));
    let drive = Drive {
        torque: Torque::Balance,
        ratio: Solve::Given(1.0),
        efficiency: 1.0,
        flywheel: Some(Solve::Wanted),
        flywheel_on: FlywheelPlace::Crank,
    };
    Some((Motion::Steady { mean_speed: speed, unevenness }, Some(drive)))
}

/// What does not repeat with the cycle, or not with one turn of it.
fn keep_what_repeats(mechanism: &mut Mechanism) {
    let repeats = |value: &Value| match value {
        Value::Constant(_) => true,
        Value::Table { over, repeat, .. } => *over == Over::Coordinate && *repeat,
        _ => false,
    };
    mechanism.loads.retain(|load| load.kind.contact().is_none() && load.kind.law().is_none_or(repeats));
}

#[test]
fn a_regime_that_is_wrong_by_twice_the_limits_is_caught() {
    let mut caught = 0;
    for (seed, calculation) in calculations(turning, keep_what_repeats) {
        let InputMotion::Steady(found) = &calculation.motion else { continue };
        if found.regime.flywheel_needless || found.regime.iterations.is_empty() {
            continue;
        }
        let sound = calculation.steady_checks(found);
        let names = ["cycle in time", "periodicity", "mean speed", "unevenness"];
        let Some(limits) = names.iter().map(|name| one(&sound, name)).collect::<Option<Vec<_>>>() else {
            continue;
        };
        let [cycle, periodicity, mean, unevenness] = [0, 1, 2, 3].map(|k| 2.0 * limits[k].finding.bound);
        assert!(limits.iter().all(|check| check.finding.bound < 1e-6), "seed {seed}: {limits:?}");
        let mut wrong = Steady::clone(found);
        wrong.regime.cycle_time *= 1.0 + cycle;
        let last = wrong.regime.iterations.last_mut().unwrap();
        last.residual += periodicity * last.speed_end;
        wrong.regime.figures.mean_speed *= 1.0 + mean;
        wrong.regime.figures.unevenness *= 1.0 + unevenness;
        let wrong = calculation.steady_checks(&wrong);
        for (name, sound) in names.iter().zip(&limits) {
            assert_caught(&format!("{name}, seed {seed}"), sound, &one(&wrong, name).unwrap());
        }
        caught += 1;
        if caught == MECHANISMS {
            return;
        }
    }
    panic!("only {caught} mechanisms");
}

#[test]
fn work_that_is_missed_by_twice_the_limit_is_caught() {
    let mut caught = 0;
    for (seed, calculation) in calculations(released, |_| ()) {
        let InputMotion::Transient(found) = &calculation.motion else { continue };
        if let Some([sound, wrong]) = crate::proof::twice_the_limit(&calculation, found) {
            assert_caught(&format!("work, seed {seed}"), &sound, &wrong);
            caught += 1;
        }
        if caught == MECHANISMS {
            return;
        }
    }
    panic!("only {caught} mechanisms");
}

/// The regime is right to 1e-11, and its least speed a hundredth of the greatest: what a step in time is off by counts for more
/// there. Where the speed is nearly the same all over the cycle it counts once.
#[test]
fn a_cycle_in_time_is_judged_by_where_it_is_slow() {
    let cycle = |text: &str| {
        let mechanism = assur_scene::read("scene.toml", text).unwrap();
        let calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
        let InputMotion::Steady(found) = &calculation.motion else { panic!("no regime") };
        calculation.cycle_check(found).unwrap()
    };
    let slow = cycle(include_str!("../tests/nearly-stalls.toml"));
    assert!(
        slow.finding.holds == Some(true) && slow.finding.holds.is_some() && slow.finding.bound < 1e-4,
        "{slow:?}"
    );
    let even = cycle(assur_fixtures::scene("flywheel"));
    assert!(even.finding.holds == Some(true) && even.finding.bound < 1.1e-9, "{even:?}");
}
