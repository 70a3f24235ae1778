//! All checks of a subject, one after the other.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{Loads, State};
use assur_kinematics::Linkage;

use crate::Chosen;
use crate::check::Check;
use crate::closure::Closure;
use crate::forces::Forces;
use crate::residuals::Residuals;
use crate::subject::{Subject, methods};
use crate::test_pf::TestPf;

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
        state: &|index| Some(State::prescribed(&linkage.mechanism, input.coordinate(index))),
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
        let mut step = || {
            done += 1;
            watch(done - 1, total)
        };
        let (mut closure, mut test_pf) = (Closure::new(), TestPf::new(self));
        for index in self.positions.iter() {
            step()?;
            if let Some(one) = self.solve(index, self.linkage.mechanism.input.coordinate(index)) {
                closure.add(self, &one);
                test_pf.add(&one);
            }
        }
        let (of_transfer, test_pf) = test_pf.finish();
        let mut residuals = Residuals { test_pf, forces: Vec::new() };
        let mut all: Vec<Check> = closure.finish().chain(of_transfer).collect();
        for check in &mut all {
            check.sample = self.positions.share();
        }
        if let Some(loads) = self.loads {
            let mut forces = Forces::new(self, loads);
            for index in self.states.iter() {
                step()?;
                if let Some(state) = (self.state)(index) {
                    forces.add(index, &state);
                }
            }
            let (found, of_forces) = forces.finish();
            residuals.forces = of_forces;
            all.extend(found.map(|check| Check { sample: self.states.share(), ..check }));
        }
        ControlFlow::Continue((all, residuals))
    }
}
