//! `TestPf` (S, stage 3): PF1 and PF2 of every element against numerical differentiation of PF0 and PF1, and the derivative of
//! the reduced inertia against differences of the reduced inertia.

use std::ops::ControlFlow;

use crate::check::{Check, Collector};
use crate::differences::{SAFETY, extrapolated};
use crate::double_double::DoubleDouble;
use crate::elements::{Element, elements};
use crate::kinetics;
use crate::sample::{Sample, Surroundings, interpolated, sample};
use crate::subject::{Solved, Subject};

/// Least rounding of any value, in units of the last place of its own size and of a typical one.
const FLOOR: f64 = 4.0;

const REASON: &str = "against numerical differentiation of the order below, in about 32 digits with steps far smaller than the \
                      distance to a singular position; limit: 8 times the error estimate of the extrapolation and 64 \
                      rounding units by what each is magnified to there (across a change point in 16 digits, with the \
                      rounding measured)";

const NO_ROOM: &str = "no room for differences before the end of assembly";

/// What is compared at one position.
struct Comparison<'a> {
    subject: &'a Subject<'a>,
    one: &'a Solved,
    around: Surroundings,
    /// The calculated numbers.
    found: Sample<f64>,
    /// The largest PF0, PF1, PF2 of anything on each link, in its unit, at least 1: what stands still on a fast link is a
    /// difference of what moves.
    sizes: Vec<[f64; 3]>,
}

pub(crate) fn checks<B>(
    subject: &Subject<'_>,
    solved: &[Solved],
    step: &mut impl FnMut() -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Check>> {
    let mut collectors = ["TestPf PF1", "TestPf PF2", "TestPf J'"].map(|name| Collector::new(name, REASON));
    let linkage = subject.linkage;
    let all = elements(linkage);
    let heavy = linkage.mechanism.links.iter().skip(1).any(|link| link.mass > 0.0 || link.inertia > 0.0);
    let applying = if heavy { 3 } else { 2 };
    let mut scratch = linkage.position();
    let mut double_double = DoubleDouble::of(subject);
    for one in solved {
        step()?;
        let crossing = linkage.is_interpolated(one.position.coordinate);
        let around = match double_double.as_mut().filter(|_| !crossing) {
            Some(chain) => chain.surroundings(&all, one),
            None => interpolated(subject, &all, one, &mut scratch),
        };
        let Some(around) = around else {
            collectors[..applying].iter_mut().for_each(|collector| collector.leave_out(one.index, NO_ROOM));
            continue;
        };
        let here = Comparison::of(subject, &all, one, around);
        for (i, element) in all.iter().enumerate() {
            for order in [1, 2] {
                here.compare((i, *element), order, &mut collectors[order - 1]);
            }
        }
        if heavy {
            here.compare_inertia(&mut collectors[2]);
        }
    }
    ControlFlow::Continue(collectors.into_iter().filter_map(Collector::into_check).collect())
}

impl<'a> Comparison<'a> {
    fn of(subject: &'a Subject<'a>, all: &[Element], one: &'a Solved, around: Surroundings) -> Self {
        let found = sample(subject.linkage, all, &one.position, &one.position);
        let mut sizes = vec![[1.0_f64; 3]; subject.linkage.structure.links];
        for (i, element) in all.iter().enumerate() {
            let numbers = [0, 1, 2].map(|order| {
                let [x, y] = [0, 1].map(|k| around.values.motion(i, order, k));
                x.hypot(y) / subject.unit(order, element.is_length())
            });
            for link in element.links(subject.linkage) {
                for (size, number) in sizes[link].iter_mut().zip(numbers) {
                    *size = size.max(number);
                }
            }
        }
        Self { subject, one, around, found, sizes }
    }

    /// Deviation and limit of a derivative. `slope`: which of the differences; `below`, `own`: rounding of what was differenced
    /// and of the value itself.
    fn deviation(&self, slope: impl Fn(&Sample<f64>) -> f64, value: f64, below: f64, own: f64) -> [f64; 2] {
        let quotients = self.around.quotients.iter().map(|all| (all.step, slope(&all.slopes)));
        let estimate = extrapolated(&quotients.collect::<Vec<_>>(), below);
        [(value - estimate.value).abs(), SAFETY * (estimate.error + own)]
    }

    fn compare(&self, (i, element): (usize, Element), order: usize, collector: &mut Collector) {
        let Self { subject, one, around, found, sizes } = self;
        let unit = subject.unit(order, element.is_length());
        let below_unit = subject.unit(order - 1, element.is_length());
        let floor = |number: f64, unit: f64| FLOOR * f64::EPSILON * (number.abs() + unit);
        let links = element.links(subject.linkage);
        let size = links.map(|link| sizes[link][order]).into_iter().fold(1.0, f64::max);
        for k in [0, 1] {
            let below = around.below.motion(i, order - 1, k);
            let below = below.max(around.floor * floor(around.values.motion(i, order - 1, k), below_unit));
            let least = around.floor.max(1.0) * floor(around.values.motion(i, order, k), unit);
            let own = around.own.motion(i, order, k) + least;
            let slope = |slopes: &Sample<f64>| slopes.motion(i, order - 1, k);
            let [off, limit] = self.deviation(slope, found.motion(i, order, k), below, own);
            let name = || element.name(subject.linkage);
            collector.offer_of(one.index, off / unit, limit / unit, size, name);
        }
    }

    fn compare_inertia(&self, collector: &mut Collector) {
        let Self { subject, one, around, found, .. } = self;
        let [size, slope] = [0, 1].map(|order| around.values.inertia(order));
        if size == 0.0 {
            return;
        }
        let unit = size.abs() / subject.linkage.coordinate_unit();
        // J' sums products of PF1 and PF2 that cancel; the rounding of each is that of the terms.
        let terms = kinetics::slope_terms(&subject.linkage.mechanism, &one.position.bodies);
        let floor = FLOOR * f64::EPSILON;
        let below = around.below.inertia(0).max(around.floor * floor * size.abs());
        let own = around.own.inertia(1) + around.floor.max(1.0) * floor * (slope.abs() + unit);
        let [off, limit] = self.deviation(|slopes| slopes.inertia(0), found.inertia(1), below, own);
        collector.offer_of(one.index, off / unit, limit / unit, 1.0_f64.max(terms / unit), || {
            "all links".to_owned()
        });
    }
}
