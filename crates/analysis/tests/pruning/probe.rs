//! Kernels that count what is asked of them, and leave nothing behind that was not.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use assur_analysis::Calculation;
use assur_group::{AssurGroup, Body, GroupError, GroupFrame, Number, Order, Wrench};

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
struct Probe<T> {
    inner: Box<dyn AssurGroup<T>>,
    calls: Arc<Calls>,
}

impl<T: Number> Probe<T> {
    /// How many positions a call solves.
    const POSITIONS: usize = size_of::<T>() / size_of::<f64>();

    fn count(&self, order: Order) {
        self.calls.derived[0].fetch_add(Self::POSITIONS * usize::from(order >= Order::First), Relaxed);
        self.calls.derived[1].fetch_add(Self::POSITIONS * usize::from(order >= Order::Second), Relaxed);
    }

    fn forget(&self, bodies: &mut [Body<T>]) {
        for &link in &self.inner.frame().links {
            let Body { x, y, c, s, .. } = bodies[link];
            let none = T::from_f64(f64::NAN);
            bodies[link] = Body { x, y, c, s, x1: none, y1: none, w1: none, x2: none, y2: none, w2: none };
        }
    }
}

impl<T: Number> AssurGroup<T> for Probe<T> {
    fn frame(&self) -> &GroupFrame {
        self.inner.frame()
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        self.calls.placed.fetch_add(Self::POSITIONS, Relaxed);
        self.forget(bodies);
        self.inner.place(bodies, way)
    }

    fn ways(&self) -> usize {
        self.inner.ways()
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        self.count(order);
        self.inner.derive(bodies, order)
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        self.calls.placed.fetch_add(Self::POSITIONS, Relaxed);
        self.count(order);
        self.forget(bodies);
        self.inner.solve(bodies, way, order)
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        self.inner.health(bodies)
    }

    fn reactions_under(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
        sets: usize,
    ) -> Result<(), GroupError> {
        self.calls.reactions.fetch_add(Self::POSITIONS, Relaxed);
        self.inner.reactions_under(bodies, loads, reactions, sets)
    }
}

/// Puts a counter before every kernel of a compiled study.
pub(crate) fn probe(study: &mut Calculation) -> Vec<Arc<Calls>> {
    let counters: Vec<Arc<Calls>> = study.linkage.groups().iter().map(|_| Arc::default()).collect();
    // Nobody else has the linkage.
    let linkage = Arc::get_mut(&mut study.linkage).expect("its own linkage");
    watch(&mut Arc::get_mut(&mut linkage.chain).expect("its own chain").groups, &counters);
    watch(&mut Arc::get_mut(&mut linkage.lane_chain).expect("its own chain").groups, &counters);
    counters
}

fn watch<T: Number>(kernels: &mut Vec<Box<dyn AssurGroup<T>>>, counters: &[Arc<Calls>]) {
    for (inner, calls) in std::mem::take(kernels).into_iter().zip(counters) {
        kernels.push(Box::new(Probe { inner, calls: Arc::clone(calls) }));
    }
}
