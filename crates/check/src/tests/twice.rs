//! How wide the limits are: an error of twice its limit must be caught, in each of many random mechanisms, by the check that
//! judges the number in which it was planted.
//!
//! Two properties make a limit too wide, and both are looked at. A limit may grow with the error that it should catch: so the
//! limit of a gross error and that of a small one are compared. And it may be far above any rounding: so the error that is
//! caught is a small part of the number in which it stands, and of all mechanisms one comes near the limit by its
//! rounding alone.

use std::sync::OnceLock;

use assur_force::{LoadState, Loads};
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_testkit::specimen::Recipe;

use crate::Chosen;
use crate::check::{Check, Collector};
use crate::subject::{InputLoad, Subject, methods};

mod forces;
mod joints;
mod loads;
mod motion;

/// Random mechanisms in which each error is planted.
const MECHANISMS: usize = 50;

/// Seeds among which so many are found that have what is planted in.
const SEEDS: usize = 400;

/// The first gross error, in parts of the number.
const GROSS: f64 = 1e-9;

/// A random mechanism of one to five groups, and the number of one of its positions.
struct Trial {
    seed: usize,
    linkage: Linkage,
    loads: Loads,
    index: usize,
}

impl Trial {
    fn new(seed: usize) -> Self {
        let mechanism = Recipe::of(1 + seed % 5).specimen(seed as u64).unwrap().mechanism;
        let index = seed % mechanism.input.positions;
        let linkage = Linkage::compile(mechanism).unwrap();
        let loads = Loads::compile(&linkage).unwrap();
        Self { seed, linkage, loads, index }
    }

    /// One after the other; each is made once for all tests.
    fn all() -> impl Iterator<Item = &'static Self> {
        static ALL: [OnceLock<Trial>; SEEDS] = [const { OnceLock::new() }; SEEDS];
        ALL.iter().enumerate().map(|(seed, trial)| trial.get_or_init(|| Self::new(seed)))
    }

    fn mechanism(&self) -> &Mechanism {
        &self.linkage.mechanism
    }

    fn state(&self) -> LoadState {
        LoadState::prescribed(self.mechanism(), self.mechanism().input.coordinate(self.index))
    }

    /// What is checked, with all registered methods.
    fn subject<'a>(
        &'a self,
        state: &'a (dyn Fn(usize) -> Option<LoadState> + Sync),
        drive: Option<&'a (dyn Fn(&LoadState) -> InputLoad + Sync)>,
    ) -> Subject<'a> {
        let all = Chosen::all(self.mechanism().input.positions);
        let methods = methods(&self.linkage, None);
        let loads = Some(&self.loads);
        Subject { linkage: &self.linkage, loads, positions: all.clone(), states: all, state, drive, methods }
    }
}

/// What was found about one check in many mechanisms.
#[derive(Debug, Default)]
struct Width {
    mechanisms: usize,
    /// The largest error of twice a limit, in parts of the number in which it was planted.
    error: f64,
    /// The largest residual of a sound mechanism, in parts of its limit.
    share: f64,
}

impl Width {
    /// Plants errors: `check` gives the check of a mechanism with an error of so many parts of a number; `None` where the
    /// mechanism has nothing of the sort.
    fn add(&mut self, what: &str, check: impl Fn(f64) -> Option<Check>) {
        let Some(sound) = check(0.0).filter(|check| check.finding.holds.is_some()) else { return };
        assert!(sound.finding.holds == Some(true), "{what}: {sound:?}");
        let Some(error) = twice_the_limit(what, &check) else { return };
        self.mechanisms += 1;
        self.error = self.error.max(error);
        if sound.finding.bound > 0.0 {
            self.share = self.share.max(sound.finding.error / sound.finding.bound);
        }
    }

    fn is_complete(&self) -> bool {
        self.mechanisms == MECHANISMS
    }

    /// Whether there were enough mechanisms, and errors of this part were caught in all of them. `rounding`: what part of
    /// its limit the rounding of one of them at least reaches.
    fn judge(&self, name: &str, error: f64, rounding: f64) {
        println!("{name}: {self:?}");
        assert_eq!(self.mechanisms, MECHANISMS, "{name}");
        assert!(self.error < error, "{name}: an error of {:e} is needed to be seen", self.error);
        assert!(self.share > rounding, "{name}: no rounding reaches more than {:e} of its limit", self.share);
    }
}

/// An error that makes the residual twice the limit, and whether it is caught; `None` where even a gross error has no effect (a
/// force on a point that is at rest).
fn twice_the_limit(what: &str, check: &impl Fn(f64) -> Option<Check>) -> Option<f64> {
    let at = |error| check(error).unwrap();
    let gross = [GROSS, 1e3 * GROSS, 1e6 * GROSS].into_iter().find(|error| at(*error).finding.failed())?;
    let first = at(gross);
    let error = 2.0 * gross * first.finding.bound / first.finding.error;
    let found = at(error);
    if (1.5..3.0).contains(&(found.finding.error / found.finding.bound)) {
        assert!(found.finding.failed(), "{what}: twice the limit is not caught: {found:?}");
        let grown = first.finding.bound / found.finding.bound;
        assert!(
            first.finding.place != found.finding.place || grown < 2.0,
            "{what}: {gross:e} widens its own limit {grown} times"
        );
        return Some(error);
    }
    Some(twice_what_passes(what, &at, gross))
}

/// The same where residual and error are not in proportion: where the check allows for the rounding of an argument, or has two
/// limits, of coarse and of fine differences. Twice the greatest error that passes must be caught, and all beyond it.
fn twice_what_passes(what: &str, at: &impl Fn(f64) -> Check, gross: f64) -> f64 {
    let (mut low, mut high) = (1e-9 * gross, gross);
    if at(low).finding.failed() {
        // Zero against zero: there is nothing to round.
        return low;
    }
    while high > 1.5 * low {
        let middle = (low * high).sqrt();
        *if at(middle).finding.failed() { &mut high } else { &mut low } = middle;
    }
    for factor in [2.0, 3.0, 5.0, 10.0, 100.0] {
        let found = at(factor * low);
        assert!(
            found.finding.failed(),
            "{what}: {factor} times an error that passes is not caught: {found:?}"
        );
    }
    2.0 * low
}

/// The check of a name among those that were collected.
fn named(all: impl IntoIterator<Item = Collector>, name: &str) -> Option<Check> {
    all.into_iter().filter_map(Collector::into_check).find(|check| check.name.to_string() == name)
}
