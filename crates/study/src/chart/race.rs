//! Measuring the rows of a stage: each is compared with the reference once, then timed in turns.

use std::ops::ControlFlow;

use assur_number::greater;
use assur_words::{Text, number, text};

use super::{Measurement, Reference, Stage};

/// Shortest stretch that is timed, s: far above the resolution of a clock.
const STRETCH: f64 = 2e-4;

const MOST_RUNS: f64 = 1e5;

/// Part of a time by which it changes with the place of code and data in memory, which repetitions do not show: two equal methods
/// were seen to differ by twice that.
const PLACEMENT: f64 = 0.03;

/// A run longer than this, s, need not be repeated.
const LONG: f64 = 0.05;

/// The reason of rows that were not reached.
pub(crate) const STOPPED: Text = text!("chart-not-reached");
const OUT_OF_TIME: Text = text!("chart-out-of-time");

pub(crate) struct Judge<'a> {
    pub(crate) clock: &'a mut dyn FnMut() -> f64,
    pub(crate) options: ChartOptions,
    pub(crate) progress: &'a mut dyn FnMut(Progress) -> ControlFlow<()>,
    pub(crate) start: f64,
    pub(crate) stopped: bool,
}

/// An entry that was compared with the reference and can be timed.
struct Timed<'e, 'a> {
    entry: &'e mut Entry<'a>,
    runs: f64,
    rounds: usize,
    times: Vec<f64>,
}

impl Judge<'_> {
    fn report(&mut self, stage: Stage, done: usize, total: usize) {
        if (self.progress)(Progress { stage, done, total }).is_break() {
            self.stopped = true;
        }
    }

    fn out_of_time(&mut self) -> bool {
        (self.clock)() - self.start > self.options.limit
    }

    pub(crate) fn race(&mut self, stage: Stage, field: Field<'_>) -> Vec<Measurement> {
        let Field { reference, mut entries } = field;
        let total = entries.len() + self.options.rounds;
        let mut first_times = Vec::with_capacity(entries.len());
        for (done, entry) in entries.iter_mut().enumerate() {
            self.report(stage, done, total);
            first_times.push(self.judge(entry, reference.error));
        }
        let judged = entries.len();
        let timed = entries.iter_mut().zip(first_times).filter_map(|(entry, time)| Some((entry, time?)));
        let mut timings = self.timings(timed.collect());
        let most = timings.iter().map(|timing| timing.rounds).max().unwrap_or(0);
        for round in 0..most {
            self.report(stage, judged + round * self.options.rounds / most, total);
            if self.stopped || self.out_of_time() {
                break;
            }
            self.round(&mut timings, round, most);
        }
        for Timed { entry, times, .. } in timings {
            let found = median(times.clone());
            let noise = found.and_then(|found| {
                let apart = times.iter().map(|time| (time - found).abs());
                Some(median(apart.collect())?.max(PLACEMENT * found))
            });
            [entry.row.seconds, entry.row.noise] = [found, noise].map(|time| Some(time? / entry.units));
        }
        entries.into_iter().map(|entry| entry.row).collect()
    }

    /// The run that is compared with the reference; its time if it produced a result.
    fn judge(&mut self, entry: &mut Entry<'_>, estimate: f64) -> Option<f64> {
        let work = entry.work.as_mut()?;
        if self.stopped || self.out_of_time() {
            entry.row.reason = Some(if self.stopped { STOPPED } else { OUT_OF_TIME });
            return None;
        }
        let before = (self.clock)();
        let verdict = work(true);
        let time = (self.clock)() - before;
        let row = &mut entry.row;
        row.evaluations = verdict.evaluations;
        row.error = verdict.error.filter(|error| error.is_finite());
        if let Some(error) = row.error.filter(|error| *error < estimate) {
            row.at_most = error < estimate;
            row.error = Some(estimate);
        }
        row.reason = verdict.failure;
        if row.error.is_none() && row.reason.is_none() {
            row.reason = Some(text!("chart-not-a-number"));
        }
        row.ok = row.reason.is_none();
        row.error.is_some().then_some(time)
    }

    /// Number of timings of each entry: all share the time of the stage equally.
    fn timings<'e, 'a>(&mut self, timed: Vec<(&'e mut Entry<'a>, f64)>) -> Vec<Timed<'e, 'a>> {
        let share = self.options.stage_seconds / timed.len().max(1) as f64;
        let mut timings = Vec::with_capacity(timed.len());
        for (entry, judged) in timed {
            // The compared run counts as one timing; short runs are repeated to measure them warm.
            let (mut runs, mut one, mut times) = (1.0, judged, Vec::new());
            if judged > STRETCH {
                times.push(judged);
            }
            while one * runs < STRETCH && runs < MOST_RUNS {
                one = self.stretch(entry, runs);
                runs = if one * runs >= STRETCH { break } else { grown(runs, one) };
            }
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small and positive")]
            let rounds = (share / (one * runs)).clamp(0.0, self.options.rounds as f64) as usize;
            // A median needs several timings; for long runs, the compared run must suffice.
            let least = if one * runs < LONG { 2 } else { usize::from(times.is_empty()) };
            timings.push(Timed { entry, runs, rounds: rounds.max(least), times });
        }
        timings
    }

    /// One round over every row that is due; rows with few timings are spread over all rounds.
    fn round(&mut self, timings: &mut [Timed<'_, '_>], round: usize, most: usize) {
        for timing in timings {
            let due = (round + 1) * timing.rounds / most > round * timing.rounds / most;
            if due {
                let time = self.stretch(timing.entry, timing.runs);
                timing.times.push(time);
            }
        }
    }

    /// Time of one run, s, averaged over several.
    fn stretch(&mut self, entry: &mut Entry<'_>, runs: f64) -> f64 {
        let Some(work) = entry.work.as_mut() else { return 0.0 };
        let before = (self.clock)();
        let mut left = runs;
        while left > 0.0 {
            std::hint::black_box(work(false));
            left -= 1.0;
        }
        ((self.clock)() - before) / runs
    }
}

/// More runs, so that the timed interval becomes long enough.
fn grown(runs: f64, one: f64) -> f64 {
    let wanted = if one > 0.0 { STRETCH / one * 1.2 } else { runs * 10.0 };
    wanted.clamp(runs + 1.0, runs * 10.0).min(MOST_RUNS).ceil()
}

pub(crate) fn median(mut times: Vec<f64>) -> Option<f64> {
    times.sort_by(f64::total_cmp);
    let middle = times.len() / 2;
    let upper = *times.get(middle)?;
    if times.len() % 2 == 1 {
        return Some(upper);
    }
    Some(0.5 * (times[middle - 1] + upper))
}

/// How thorough the measurement is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChartOptions {
    /// Every second setting, few repetitions, at most [`limit`](Self::limit) in all.
    pub quick: bool,
    /// Time for repetitions in one stage, s.
    pub stage_seconds: f64,
    /// Most repetitions of one row.
    pub rounds: usize,
    /// Time after which no further row is begun, s.
    pub limit: f64,
    /// Most steps of an integrator; if one needs more, its row has the reason.
    pub max_steps: usize,
}

impl ChartOptions {
    /// The thorough chart: tens of seconds.
    pub const THOROUGH: Self =
        Self { quick: false, stage_seconds: 12.0, rounds: 31, limit: f64::INFINITY, max_steps: 1_000_000 };

    /// The quick chart: within five seconds.
    pub const QUICK: Self =
        Self { quick: true, stage_seconds: 0.6, rounds: 7, limit: 3.0, max_steps: 40_000 };

    /// Decimal exponents from `first` down to `last`; the quick chart takes every second.
    pub(crate) fn decades(self, first: i32, last: i32) -> impl Iterator<Item = f64> {
        let step = if self.quick { 2 } else { 1 };
        (last..=first).rev().step_by(step).map(|exponent| 10.0_f64.powi(exponent))
    }
}

/// Progress of a chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The stage in work.
    pub stage: super::Stage,
    /// Pieces of work done in it.
    pub done: usize,
    /// Pieces of work in it.
    pub total: usize,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Verdict {
    /// Evaluations in one unit of work.
    pub(crate) evaluations: Option<u64>,
    /// Largest relative deviation; `None` without a result.
    pub(crate) error: Option<f64>,
    pub(crate) failure: Option<Text>,
}

impl Verdict {
    /// The outcome of a run over positions: the largest of their errors, and the failures.
    pub(crate) fn of_positions(
        evaluations: u64,
        errors: impl ExactSizeIterator<Item = Result<f64, Text>>,
    ) -> Self {
        let count = errors.len();
        let (mut worst, mut failures, mut first) = (None, 0, None);
        for error in errors {
            match error {
                Ok(error) => worst = Some(greater(worst.unwrap_or(0.0), error)),
                Err(why) => {
                    failures += 1;
                    first.get_or_insert(why);
                }
            }
        }
        let failure = first.map(|first| {
            if failures == count {
                return first;
            }
            let [failures, count] = [failures, count].map(number);
            text!("chart-some-positions", failures, count, first)
        });
        Self { evaluations: Some(evaluations), error: worst, failure }
    }

    /// The outcome of a run that gives one number: that number and its evaluations, or why there is none.
    pub(crate) fn of_number(solved: Result<(f64, usize), Text>, truth: f64) -> Self {
        match solved {
            Ok((found, count)) => {
                let error = ((found - truth) / truth).abs();
                Self { evaluations: Some(count as u64), error: Some(error), failure: None }
            }
            Err(why) => Self { failure: Some(why), ..Self::default() },
        }
    }
}

/// The work of a method at a setting, done once. With `true` it is compared with the reference; with `false` it is
/// timed, and its return value is ignored.
type Work<'a> = Box<dyn FnMut(bool) -> Verdict + 'a>;

/// A row that is not measured yet; without work it has its reason already.
pub(crate) struct Entry<'a> {
    pub(crate) row: Measurement,
    pub(crate) units: f64,
    pub(crate) work: Option<Work<'a>>,
}

impl<'a> Entry<'a> {
    /// A method whose run is one unit of work.
    pub(crate) fn run(row: Measurement, work: impl FnMut(bool) -> Verdict + 'a) -> Self {
        Self { row, units: 1.0, work: Some(Box::new(work)) }
    }

    /// A method that can't be measured.
    pub(crate) fn refused(mut row: Measurement, why: Text) -> Self {
        row.reason = Some(why);
        Self { row, units: 1.0, work: None }
    }
}

pub(crate) struct Field<'a> {
    pub(crate) reference: Reference,
    pub(crate) entries: Vec<Entry<'a>>,
}
