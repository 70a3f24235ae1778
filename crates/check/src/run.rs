//! All checks of a subject, one after the other.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{LoadState, Loads};
use assur_kinematics::Linkage;
use rayon::prelude::*;

use crate::check::{Check, Collector, Residuals};
use crate::subject::{Subject, methods};
use crate::{Chosen, closure::Closure, forces::Forces, test_pf::TestPf, written::Writer};

/// Positions times links from which on several threads work: some ten milliseconds of work.
const MUCH: usize = 1024;
/// Fewest positions for a thread, and how many it takes until the run may be stopped.
const LEAST: usize = 8;

/// Every check of a linkage under its prescribed motion, in all positions and by all registered methods.
///
/// Where loads need a motion that the scene does not define, the checks of forces are left out.
pub fn checks(linkage: &Linkage) -> Vec<Check> {
    let loads = Loads::compile(linkage).ok();
    let input = &linkage.mechanism.input;
    let all = Chosen::all(input.positions);
    let subject = Subject {
        linkage,
        loads: loads.as_ref(),
        positions: all.clone(),
        states: all,
        state: &|index| Some(LoadState::prescribed(&linkage.mechanism, input.coordinate(index))),
        drive: None,
        methods: methods(linkage, None),
    };
    let ControlFlow::Continue((all, _)) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    all
}

impl Subject<'_> {
    /// Every check that applies: of the transfer functions over the [positions](Self::positions) that can be solved, of
    /// the forces over the [states](Self::states); and the residuals of each position and state. `watch` is called before
    /// each of them with the number of those that are finished and of all, and may stop the run.
    pub fn checks<B>(
        &self,
        watch: &mut impl FnMut(usize, usize) -> ControlFlow<B>,
    ) -> ControlFlow<B, (Vec<Check>, Residuals)> {
        let states = if self.loads.is_some() { self.states.count() } else { 0 };
        let (mut done, total) = (0, self.positions.count() + states);
        let mut step = |count: usize| {
            let flow = watch(done, total);
            done += count;
            flow
        };
        let new = || (Closure::new(self), TestPf::new(self));
        let add = |(closure, test_pf): &mut (Closure, TestPf<'_>), index| {
            if let Some(one) = self.solve(index, self.linkage.mechanism.input.coordinate(index)) {
                closure.add(self, &one);
                test_pf.add(&one);
            }
        };
        let finish = |(closure, test_pf): (Closure, TestPf<'_>)| {
            let (collectors, residuals) = test_pf.finish();
            (closure.collectors().chain(collectors).collect(), residuals)
        };
        let (mut all, test_pf) = self.each(&self.positions, &mut step, (new, add, finish))?;
        let mut residuals = Residuals { test_pf, forces: Vec::new() };
        if let Some(loads) = self.loads {
            let writer = Writer::new(self);
            let add = |forces: &mut Forces<'_>, index| {
                if let Some(state) = (self.state)(index) {
                    forces.add(index, &state);
                }
            };
            let work = (|| Forces::new(self, loads, &writer), add, Forces::finish);
            let (checks, of_forces) = self.each(&self.states, &mut step, work)?;
            all.extend(checks);
            residuals.forces = of_forces;
        }
        ControlFlow::Continue((all, residuals))
    }

    /// Goes through all numbered positions or states that are chosen; many by all threads, a range of them each, which `new` begins,
    /// `add` goes on with and `finish` ends. The result is the same: the ranges are joined in their order. `step` is called with the
    /// number of those that follow.
    fn each<C: Send, R, B>(
        &self,
        chosen: &Chosen,
        step: &mut impl FnMut(usize) -> ControlFlow<B>,
        (new, add, finish): (
            impl Fn() -> C + Sync,
            impl Fn(&mut C, usize) + Sync,
            impl Fn(C) -> (Vec<Collector>, Vec<R>),
        ),
    ) -> ControlFlow<B, (Vec<Check>, Vec<R>)> {
        let numbers: Vec<usize> = chosen.iter().collect();
        let much = numbers.len() * self.linkage.structure.links >= MUCH;
        let parts = if much { rayon::current_num_threads().min(numbers.len() / LEAST).max(1) } else { 1 };
        let range = numbers.len().div_ceil(parts).max(1);
        let mut parts: Vec<(Option<C>, &[usize])> = numbers.chunks(range).map(|part| (None, part)).collect();
        let together = if parts.len() > 1 { LEAST } else { 1 };
        for start in (0..range.min(numbers.len())).step_by(together) {
            let left = |part: &[usize]| part.len().saturating_sub(start).min(together);
            step(parts.iter().map(|(_, part)| left(part)).sum())?;
            let go_on = |(found, part): &mut (Option<C>, &[usize])| {
                let found = found.get_or_insert_with(&new);
                part.iter().skip(start).take(together).for_each(|number| add(found, *number));
            };
            match &mut parts[..] {
                [only] => go_on(only),
                all => all.par_iter_mut().for_each(go_on),
            }
        }
        let mut found = parts.into_iter().filter_map(|(found, _)| found).map(finish);
        let (mut collectors, mut residuals) = found.next().unwrap_or_default();
        for (others, more) in found {
            collectors.iter_mut().zip(others).for_each(|(collector, next)| collector.append(next));
            residuals.extend(more);
        }
        let checks = collectors.into_iter().filter_map(Collector::into_check);
        let checks = checks.map(|check| Check { sample: chosen.share(), ..check });
        ControlFlow::Continue((checks.collect(), residuals))
    }
}
