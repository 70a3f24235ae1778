//! Agreement of the methods: every reaction and the balancing load.

use assur_force::{AnalyzerPlugin, Loads, Reactions, State};
use assur_group::{Order, Wrench};

use crate::forces::{NO_ANSWER, SOLUTION, largest};
use crate::noise::{SAMPLES, SPACING, noise_of};
use crate::subject::{Answer, Solved, Subject};
use crate::worst::{Check, Worst};

/// A measured rounding is right within a small factor.
const SAFETY: f64 = 8.0;

/// Numbers of one answer: the balancing load, then three for each pair.
type Numbers = Vec<f64>;

pub(crate) struct Agreement<'a> {
    subject: &'a Subject<'a>,
    loads: &'a Loads,
    worst: Worst,
}

impl<'a> Agreement<'a> {
    pub(crate) fn new(subject: &'a Subject<'a>, loads: &'a Loads) -> Self {
        let reason = "every reaction and the balancing load by each method, relative to the largest reaction or load; limit: 64 \
                      rounding units by the sum of 1/determinant over the groups, and where a method is worse conditioned \
                      than the mechanism 8 times the rounding measured in its answers";
        Self { subject, loads, worst: Worst::new("agreement of the methods", reason) }
    }

    pub(crate) fn leave_out(&mut self, at: usize) {
        self.worst.leave_out(at, NO_ANSWER);
    }

    pub(crate) fn into_check(self) -> Option<Check> {
        self.worst.into_check()
    }

    /// Compares all answers with that of the method `full`; `load`: the largest load, N.
    pub(crate) fn add(&mut self, one: &Solved, state: &State, answers: &[Answer], full: usize, load: f64) {
        let Some(reference) = &answers[full] else { return };
        for (i, other) in answers.iter().enumerate().filter(|(i, _)| *i != full) {
            if let Some(other) = other {
                self.compare(one, state, [full, i], [reference, other], load);
            }
        }
    }

    fn compare(
        &mut self,
        one: &Solved,
        state: &State,
        methods: [usize; 2],
        answers: [&Reactions; 2],
        load: f64,
    ) {
        let [first, second] = methods.map(|i| self.subject.methods[i]);
        let scale = self.subject.linkage.structure.scale;
        let units = self.units(answers[0], load);
        let [mine, theirs] = answers.map(numbers);
        let difference: Numbers = mine.iter().zip(&theirs).map(|(a, b)| a - b).collect();
        let off = sizes(&difference, scale, units);
        let usual = SOLUTION * f64::EPSILON * one.condition;
        let shown = if second.gives_reactions { off.len() } else { 1 };
        // A method may be worse conditioned than the mechanism (a pole near infinity); then its rounding is measured.
        let measured = off[..shown].iter().any(|off| *off > usual).then(|| {
            let both = [first, second].map(|method| self.rounding(one, state, &method));
            both.map(|rounding| rounding.map(|numbers| sizes(&numbers, scale, units)))
        });
        for (k, off) in off[..shown].iter().enumerate() {
            let noise = |which: usize| Some(measured.as_ref()?[which].as_ref()?[k]);
            let limit = usual + SAFETY * (noise(0).unwrap_or(0.0) + noise(1).unwrap_or(0.0));
            self.worst.offer(one.index, *off, limit, || self.subject.number_name(k, second.name));
        }
    }

    /// Units of the balancing load and of the reactions. A balancing moment compares with that of the largest reaction.
    fn units(&self, reference: &Reactions, load: f64) -> [f64; 2] {
        let scale = self.subject.linkage.structure.scale;
        let unit = largest(&reference.pairs, scale).max(load);
        let moment = crate::power::balances_by_moment(&self.subject.linkage.mechanism);
        let lever = if moment { scale } else { 1.0 };
        [reference.balancing.abs().max(unit * lever), unit]
    }

    /// Deviation of the rounding of each number, from answers at closely spaced coordinates, the position among them. The
    /// loads keep their laws; only the places move.
    fn rounding(&self, one: &Solved, state: &State, method: &AnalyzerPlugin) -> Option<Numbers> {
        let linkage = self.subject.linkage;
        let mut position = linkage.position();
        let mut reactions = Reactions::new(linkage);
        let mut wrenches = vec![Wrench::ZERO; linkage.structure.links];
        let mut rows: Vec<Numbers> = Vec::with_capacity(SAMPLES);
        for i in 0..SAMPLES {
            let shift = (i as f64 - 3.0) * SPACING * self.subject.linkage.coordinate_unit();
            linkage.solve(one.position.coordinate + shift, Order::Second, &mut position).ok()?;
            self.loads.apply(state, &position.bodies, &mut wrenches);
            self.loads.inertia(state, &position.bodies, &mut wrenches);
            method.instance.solve(linkage, &position, &mut wrenches, &mut reactions).ok()?;
            rows.push(numbers(&reactions));
        }
        let noise = |k: usize| noise_of(&std::array::from_fn(|i| rows[i][k]));
        Some((0..rows[0].len()).map(noise).collect())
    }
}

fn numbers(reactions: &Reactions) -> Numbers {
    let pairs = reactions.pairs.iter().flat_map(|r| [r.fx, r.fy, r.m]);
    std::iter::once(reactions.balancing).chain(pairs).collect()
}

/// The balancing load and each reaction in their units.
fn sizes(numbers: &[f64], scale: f64, units: [f64; 2]) -> Vec<f64> {
    let pairs = numbers[1..].chunks_exact(3).map(|r| (r[0].hypot(r[1]) + r[2].abs() / scale) / units[1]);
    std::iter::once(numbers[0].abs() / units[0]).chain(pairs).collect()
}

impl Subject<'_> {
    fn number_name(&self, k: usize, method: &str) -> String {
        match k.checked_sub(1) {
            None => format!("balancing load by {method}"),
            Some(pair) => {
                let name = self.linkage.structure.pair_name(&self.linkage.mechanism, pair);
                format!("pair {name} by {method}")
            }
        }
    }
}
