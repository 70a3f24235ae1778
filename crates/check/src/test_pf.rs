//! `TestPf` (S, stage 3): PF1 and PF2 of every element against numerical differentiation of PF0 and PF1, and the derivative of
//! the reduced inertia against differences of the reduced inertia.

use std::ops::ControlFlow;

use crate::around::{Around, Numbers, narrow, numbers};
use crate::differences::extrapolated;
use crate::elements::{Element, elements};
use crate::kinetics;
use crate::subject::{Solved, Subject};
use crate::wide::Wide;
use crate::worst::{Check, Worst};

/// The estimates are right within a small factor: a deviation from a few samples, an extrapolation from its neighbors.
pub(crate) const SAFETY: f64 = 8.0;

/// Least rounding of any value, in units of the last place of its own size and of a typical one.
const FLOOR: f64 = 4.0;

const REASON: &str = "against numerical differentiation of the order below, in about 32 digits with steps far smaller than the \
                      distance to a singular position; limit: 8 times the error estimate of the extrapolation and 64 \
                      rounding units by what each is magnified to there (across a change point in 16 digits, with the \
                      rounding measured)";

const NO_ROOM: &str = "no room for differences before the end of assembly";

/// What is compared at one position.
struct Here<'a> {
    subject: &'a Subject<'a>,
    one: &'a Solved,
    around: Around,
    /// The calculated numbers.
    found: Numbers,
    /// The largest PF0, PF1, PF2 of anything on each link, in its unit, at least 1: what stands still on a fast link is a
    /// difference of what moves.
    sizes: Vec<[f64; 3]>,
}

pub(crate) fn checks<B>(
    subject: &Subject<'_>,
    solved: &[Solved],
    step: &mut impl FnMut() -> ControlFlow<B>,
) -> ControlFlow<B, Vec<Check>> {
    let mut worst =
        [Worst::new("TestPf PF1", REASON), Worst::new("TestPf PF2", REASON), Worst::new("TestPf J'", REASON)];
    let all = elements(subject.linkage);
    let heavy =
        subject.linkage.mechanism.links.iter().skip(1).any(|link| link.mass > 0.0 || link.inertia > 0.0);
    let applying = if heavy { 3 } else { 2 };
    let mut scratch = subject.linkage.position();
    let mut wide = Wide::of(subject);
    for one in solved {
        step()?;
        let bridged = subject.linkage.is_interpolated(one.position.coordinate);
        let around = match wide.as_mut().filter(|_| !bridged) {
            Some(wide) => wide.around(&all, one),
            None => narrow(subject, &all, one, &mut scratch),
        };
        let Some(around) = around else {
            worst[..applying].iter_mut().for_each(|worst| worst.leave_out(one.index, NO_ROOM));
            continue;
        };
        let here = Here::of(subject, &all, one, around);
        for (i, element) in all.iter().enumerate() {
            for order in [1, 2] {
                here.compare((i, *element), order, &mut worst[order - 1]);
            }
        }
        if heavy {
            here.compare_inertia(&mut worst[2]);
        }
    }
    ControlFlow::Continue(worst.into_iter().filter_map(Worst::into_check).collect())
}

impl<'a> Here<'a> {
    fn of(subject: &'a Subject<'a>, all: &[Element], one: &'a Solved, around: Around) -> Self {
        let found = numbers(subject, all, &one.position, &one.position);
        let mut sizes = vec![[1.0_f64; 3]; subject.linkage.structure.links];
        for (element, motion) in all.iter().zip(&around.values.motions) {
            for (order, [x, y]) in motion.iter().enumerate() {
                let number = x.hypot(*y) / subject.unit(order, element.is_length());
                for link in element.links(subject.linkage) {
                    sizes[link][order] = sizes[link][order].max(number);
                }
            }
        }
        Self { subject, one, around, found, sizes }
    }

    /// Deviation and limit of a derivative. `number`: which of the differences; `noise`: rounding of what was differenced.
    fn deviation(
        &self,
        number: impl Fn(&crate::around::Quotient) -> f64,
        value: f64,
        noise: [f64; 2],
    ) -> [f64; 2] {
        let quotients: Vec<_> = self.around.quotients.iter().map(|all| (all.step, number(all))).collect();
        let estimate = extrapolated(&quotients, noise[0]);
        [(value - estimate.value).abs(), SAFETY * (estimate.error + noise[1])]
    }

    fn compare(&self, (i, element): (usize, Element), order: usize, worst: &mut Worst) {
        let Self { subject, one, around, found, sizes } = self;
        let unit = subject.unit(order, element.is_length());
        let below_unit = subject.unit(order - 1, element.is_length());
        let floor = |number: f64, unit: f64| FLOOR * f64::EPSILON * (number.abs() + unit);
        let exact = around.values.motions[i][order];
        let links = element.links(subject.linkage);
        let size = links.map(|link| sizes[link][order]).into_iter().fold(1.0, f64::max);
        for (k, exact) in exact.into_iter().enumerate() {
            let value = found.motions[i][order][k];
            let below = around.below.motions[i][order - 1][k];
            let below = below.max(around.floor * floor(around.values.motions[i][order - 1][k], below_unit));
            let floor = around.floor.max(1.0) * floor(exact, unit);
            let own = around.own.motions[i][order][k] + floor;
            let [off, limit] = self.deviation(|all| all.motions[i][order - 1][k], value, [below, own]);
            let name = || element.name(subject.linkage);
            worst.offer_of(one.index, off / unit, limit / unit, size, name);
        }
    }

    fn compare_inertia(&self, worst: &mut Worst) {
        let Self { subject, one, around, found, .. } = self;
        let [size, slope] = around.values.inertia;
        if size == 0.0 {
            return;
        }
        let unit = size.abs() / subject.linkage.coordinate_unit();
        // J' sums products of PF1 and PF2 that cancel; the rounding of each is that of the terms.
        let terms = kinetics::slope_terms(&subject.linkage.mechanism, &one.position.bodies);
        let floor = FLOOR * f64::EPSILON;
        let below = around.below.inertia[0].max(around.floor * floor * size.abs());
        let own = around.own.inertia[1] + around.floor.max(1.0) * floor * (slope.abs() + unit);
        let [off, limit] = self.deviation(|all| all.inertia, found.inertia[1], [below, own]);
        worst.offer_of(one.index, off / unit, limit / unit, 1.0_f64.max(terms / unit), || {
            "all links".to_owned()
        });
    }
}
