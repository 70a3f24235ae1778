//! All checks of a subject, one after the other.

use std::convert::Infallible;
use std::ops::ControlFlow;

use assur_force::{Loads, State};
use assur_kinematics::Linkage;

use crate::check::Check;
use crate::subject::{Subject, methods};
use crate::{closure, forces, test_pf};

/// Every check of a linkage under its prescribed motion, by all registered methods.
///
/// Where loads need a motion that the scene does not define, the checks of forces are left out.
pub fn checks(linkage: &Linkage) -> Vec<Check> {
    let loads = Loads::compile(linkage).ok();
    let input = &linkage.mechanism.input;
    let state = |index| (index, State::prescribed(&linkage.mechanism, input.coordinate(index)));
    let states = (0..input.positions).map(state).collect();
    let subject = Subject { linkage, loads: loads.as_ref(), states, methods: methods(linkage, None) };
    let ControlFlow::Continue(all) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    all
}

impl Subject<'_> {
    /// Every check that applies: of the transfer functions over all positions of the scene that can be solved, of the
    /// forces over the [states](Self::states). `watch` is called before each piece of work with the number of finished
    /// pieces and of all pieces, and may stop the run.
    pub fn checks<B>(
        &self,
        watch: &mut impl FnMut(usize, usize) -> ControlFlow<B>,
    ) -> ControlFlow<B, Vec<Check>> {
        let positions = self.positions();
        let states = if self.loads.is_some() { self.states.len() } else { 0 };
        let (mut done, total) = (0, 2 * positions.len() + states);
        let mut step = || {
            done += 1;
            watch(done - 1, total)
        };
        let mut all = closure::checks(self, &positions, &mut step)?;
        all.extend(test_pf::checks(self, &positions, &mut step)?);
        if let Some(loads) = self.loads {
            all.extend(forces::checks(self, loads, &mut step)?);
        }
        ControlFlow::Continue(all)
    }
}
