//! All checks of a subject, one after the other.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{LoadState, Loads};
use assur_kinematics::Linkage;
use rayon::prelude::*;

use crate::Chosen;
use crate::check::Residuals;
use crate::check::{Check, Collector};
use crate::closure::Closure;
use crate::forces::Forces;
use crate::subject::{Subject, methods};
use crate::test_pf::TestPf;
use crate::written::Writer;

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
        let transfer = Work {
            new: || (Closure::new(self), TestPf::new(self)),
            add: |(closure, test_pf): &mut (Closure, TestPf<'_>), index| {
                if let Some(one) = self.solve(index, self.linkage.mechanism.input.coordinate(index)) {
                    closure.add(self, &one);
                    test_pf.add(&one);
                }
            },
            finish: |(closure, test_pf): (Closure, TestPf<'_>)| {
                let (collectors, residuals) = test_pf.finish();
                (closure.collectors().chain(collectors).collect(), residuals)
            },
        };
        let (mut all, test_pf) = transfer.run(self, &self.positions, &mut step)?;
        let mut residuals = Residuals { test_pf, forces: Vec::new() };
        if let Some(loads) = self.loads {
            let writer = Writer::new(self);
            let forces = Work {
                new: || Forces::new(self, loads, &writer),
                add: |forces: &mut Forces<'_>, index| {
                    if let Some(state) = (self.state)(index) {
                        forces.add(index, &state);
                    }
                },
                finish: |forces: Forces<'_>| {
                    let (collectors, residuals) = forces.finish();
                    (collectors.collect(), residuals)
                },
            };
            let (checks, of_forces) = forces.run(self, &self.states, &mut step)?;
            all.extend(checks);
            residuals.forces = of_forces;
        }
        ControlFlow::Continue((all, residuals))
    }
}

/// Checks that go through numbered positions or states: how a part of them begins, goes on and ends.
struct Work<New, Add, Finish> {
    new: New,
    add: Add,
    finish: Finish,
}

impl<New: Sync, Add: Sync, Finish> Work<New, Add, Finish> {
    /// Goes through all that are chosen; many by all threads, a range of them each. The result is the same: the ranges are
    /// joined in their order. `step` is called with the number of those that follow.
    fn run<C: Send, R, B>(
        &self,
        subject: &Subject<'_>,
        chosen: &Chosen,
        step: &mut impl FnMut(usize) -> ControlFlow<B>,
    ) -> ControlFlow<B, (Vec<Check>, Vec<R>)>
    where
        New: Fn() -> C,
        Add: Fn(&mut C, usize),
        Finish: Fn(C) -> (Vec<Collector>, Vec<R>),
    {
        let Self { new, add, finish } = self;
        let numbers: Vec<usize> = chosen.iter().collect();
        let much = numbers.len() * subject.linkage.structure.links >= MUCH;
        let parts = if much { rayon::current_num_threads().min(numbers.len() / LEAST).max(1) } else { 1 };
        let range = numbers.len().div_ceil(parts).max(1);
        let mut parts: Vec<(Option<C>, &[usize])> = numbers.chunks(range).map(|part| (None, part)).collect();
        let together = if parts.len() > 1 { LEAST } else { 1 };
        for start in (0..range.min(numbers.len())).step_by(together) {
            let left = |part: &[usize]| part.len().saturating_sub(start).min(together);
            step(parts.iter().map(|(_, part)| left(part)).sum())?;
            let go_on = |(found, part): &mut (Option<C>, &[usize])| {
                let found = found.get_or_insert_with(new);
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
