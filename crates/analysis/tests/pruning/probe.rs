//! Kernels that count what is asked of them, and leave nothing behind that was not.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use assur_analysis::Calculation;
use assur_group::{AssurGroup, Body, GroupError, GroupFrame, Order, Wrench};

/// What was asked of one group.
#[derive(Debug, Default)]
pub(crate) struct Calls {
    placed: AtomicUsize,
    derived: [AtomicUsize; 2],
    reactions: AtomicUsize,
}

/// The same as numbers: places, first and second derivatives, force systems that were solved.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Solved {
    pub(crate) places: usize,
    pub(crate) first: usize,
    pub(crate) second: usize,
    pub(crate) forces: usize,
}

impl Calls {
    pub(crate) fn solved(&self) -> Solved {
        Solved {
            places: self.placed.load(Relaxed),
            first: self.derived[0].load(Relaxed),
            second: self.derived[1].load(Relaxed),
            forces: self.reactions.load(Relaxed),
        }
    }
}

/// A kernel behind a counter. Derivatives that are not asked for become NaN, so that whatever looks at them shows it.
#[derive(Debug)]
struct Probe {
    inner: Box<dyn AssurGroup<f64>>,
    calls: Arc<Calls>,
}

impl Probe {
    fn count(&self, order: Order) {
        self.calls.derived[0].fetch_add(usize::from(order >= Order::First), Relaxed);
        self.calls.derived[1].fetch_add(usize::from(order >= Order::Second), Relaxed);
    }

    fn forget(&self, bodies: &mut [Body<f64>]) {
        for &link in &self.inner.frame().links {
            let Body { x, y, c, s, .. } = bodies[link];
            let none = f64::NAN;
            bodies[link] = Body { x, y, c, s, x1: none, y1: none, w1: none, x2: none, y2: none, w2: none };
        }
    }
}

impl AssurGroup<f64> for Probe {
    fn frame(&self) -> &GroupFrame {
        self.inner.frame()
    }

    fn place(&self, bodies: &mut [Body<f64>], way: usize) -> Result<f64, GroupError> {
        self.calls.placed.fetch_add(1, Relaxed);
        self.forget(bodies);
        self.inner.place(bodies, way)
    }

    fn ways(&self) -> usize {
        self.inner.ways()
    }

    fn derive(&self, bodies: &mut [Body<f64>], order: Order) -> Result<(), GroupError> {
        self.count(order);
        self.inner.derive(bodies, order)
    }

    fn solve(&self, bodies: &mut [Body<f64>], way: usize, order: Order) -> Result<f64, GroupError> {
        self.calls.placed.fetch_add(1, Relaxed);
        self.count(order);
        self.forget(bodies);
        self.inner.solve(bodies, way, order)
    }

    fn health(&self, bodies: &[Body<f64>]) -> f64 {
        self.inner.health(bodies)
    }

    fn reactions(
        &self,
        bodies: &[Body<f64>],
        loads: &mut [Wrench<f64>],
        reactions: &mut [Wrench<f64>],
    ) -> Result<(), GroupError> {
        self.calls.reactions.fetch_add(1, Relaxed);
        self.inner.reactions(bodies, loads, reactions)
    }
}

/// Puts a counter before every kernel of a compiled study.
pub(crate) fn probe(study: &mut Calculation) -> Vec<Arc<Calls>> {
    let kernels = std::mem::take(&mut study.linkage.chain.groups);
    let mut counters = Vec::new();
    for inner in kernels {
        let calls = Arc::new(Calls::default());
        counters.push(Arc::clone(&calls));
        study.linkage.chain.groups.push(Box::new(Probe { inner, calls }));
    }
    counters
}
