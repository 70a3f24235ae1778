//! `TestPf` (S, stage 3): PF1 and PF2 of every element against numerical differentiation of PF0 and PF1, and the derivative of
//! the reduced inertia against differences of the reduced inertia.

use std::cell::OnceCell;

use assur_kinematics::Position;
use assur_mechanism::Link;
use assur_number::Dd;
use assur_words::{Text, text};

use crate::check::{Collector, greatest};
use crate::elements::{Element, elements};
use crate::kinetics;
use crate::numbers::{LEVELS, Numbers, SAFETY, extrapolated, numbers};
use crate::subject::{Solved, Subject};
use crate::surroundings::{Differences, Surroundings, interpolated};

/// Greatest limit, relative to what is compared, with which differences in 16 digits judge; where they need a wider one,
/// and where they find a deviation, the differences are taken in about 32 digits.
const JUDGES_IN_DOUBLE: f64 = 1e-9;

/// Least rounding of any value, in units of the last place of its own size and of a typical one.
const FLOOR: f64 = 4.0;

const REASON: Text = text!("check-testpf-reason");

const NO_ROOM: Text = text!("check-no-room");

/// The checks of PF1, PF2 and J'.
const NAMES: [Text; 3] =
    [text!("check-testpf-pf1"), text!("check-testpf-pf2"), text!("check-testpf-inertia")];

/// The check of the derivatives in the positions that were added.
pub(crate) struct TestPf<'a> {
    subject: &'a Subject<'a>,
    elements: Vec<Element>,
    /// Of PF1, PF2 and J'.
    collectors: [Collector; 3],
    /// Whether there is an inertia.
    heavy: bool,
    scratch: Position,
    double: Option<Differences<'a, f64>>,
    /// Compiled at the first position that needs it.
    double_double: OnceCell<Option<Differences<'a, Dd>>>,
    residuals: Vec<(usize, f64)>,
}

impl<'a> TestPf<'a> {
    pub(crate) fn new(subject: &'a Subject<'a>) -> Self {
        let linkage = subject.linkage;
        let mut moving = linkage.mechanism.links.iter().skip(1);
        Self {
            subject,
            elements: elements(linkage),
            collectors: NAMES.map(|name| Collector::new(name, REASON)),
            heavy: moving.any(Link::is_heavy),
            scratch: linkage.position(),
            double: Differences::of(subject),
            double_double: OnceCell::new(),
            residuals: Vec::new(),
        }
    }

    pub(crate) fn add(&mut self, one: &Solved) {
        let Some(deviations) = self.deviations(one) else {
            let applying = if self.heavy { 3 } else { 2 };
            self.collectors[..applying]
                .iter_mut()
                .for_each(|collector| collector.leave_out(one.index, NO_ROOM));
            return;
        };
        self.residuals.push((one.index, greatest(deviations.iter().map(|found| found.off / found.size))));
        for Deviation { check, element, off, limit, size } in deviations {
            self.collectors[check].offer_of(one.index, off, limit, size, || {
                element.map_or_else(|| text!("check-all-links"), |element| element.name(self.subject.linkage))
            });
        }
    }

    /// The deviations at a position, by the cheapest differences that judge them; `None` where there is no room for any.
    fn deviations(&mut self, one: &Solved) -> Option<Vec<Deviation>> {
        let Self { subject, elements: all, heavy, .. } = self;
        let deviations = |around| Comparison::of(subject, all, one, around).deviations(all, *heavy);
        if subject.linkage.is_interpolated(one.position.coordinate) {
            return interpolated(subject, all, one, &mut self.scratch).map(deviations);
        }
        let found = self.double.as_mut().and_then(|double| double.around(all, one)).map(deviations);
        if let Some(found) = found.filter(|found| found.iter().all(Deviation::is_judged_in_double)) {
            return Some(found);
        }
        self.double_double.get_or_init(|| Differences::of(subject));
        match self.double_double.get_mut() {
            Some(Some(double_double)) => double_double.around(all, one).map(deviations),
            _ => interpolated(subject, all, one, &mut self.scratch).map(deviations),
        }
    }

    /// What was collected, and by the number of each position its largest deviation.
    pub(crate) fn finish(self) -> (impl Iterator<Item = Collector>, Vec<(usize, f64)>) {
        (self.collectors.into_iter(), self.residuals)
    }
}

/// How far a derivative is from the differences.
pub(crate) struct Deviation {
    check: usize,
    /// `None`: the reduced inertia.
    element: Option<Element>,
    pub(crate) off: f64,
    pub(crate) limit: f64,
    /// Of what is compared.
    size: f64,
}

impl Deviation {
    pub(crate) fn is_judged_in_double(&self) -> bool {
        self.off <= self.limit && self.limit <= JUDGES_IN_DOUBLE * self.size
    }
}

/// What is compared at one position.
pub(crate) struct Comparison<'a> {
    subject: &'a Subject<'a>,
    one: &'a Solved,
    around: Surroundings,
    /// The calculated numbers.
    found: Numbers<f64>,
    /// The largest PF0, PF1, PF2 of anything on each link, in its unit, at least 1: what stands still on a fast link is a
    /// difference of what moves.
    sizes: Vec<[f64; 3]>,
    /// How far the links are from the origin, in sizes of the mechanism, at least 1: everything follows from differences of
    /// places, which are rounded by that distance, and directions carry that rounding to the farthest point of a link.
    distance: f64,
}

impl<'a> Comparison<'a> {
    pub(crate) fn of(
        subject: &'a Subject<'a>,
        all: &[Element],
        one: &'a Solved,
        around: Surroundings,
    ) -> Self {
        let found = numbers(subject.linkage, all, &one.position, &one.position);
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
        let far = one.position.bodies.iter().map(|body| body.x.hypot(body.y)).fold(0.0, f64::max);
        let distance = (far / subject.linkage.structure.scale).max(1.0);
        Self { subject, one, around, found, sizes, distance }
    }

    pub(crate) fn deviations(&self, all: &[Element], heavy: bool) -> Vec<Deviation> {
        let mut found = Vec::with_capacity(4 * all.len() + 1);
        for (i, element) in all.iter().enumerate() {
            for order in [1, 2] {
                found.extend(self.compare((i, *element), order));
            }
        }
        found.extend(self.compare_inertia().filter(|_| heavy));
        found
    }

    /// Deviation and limit of a derivative. `slope`: which of the differences; `below`, `own`: rounding of what was differenced
    /// and of the value itself.
    fn deviation(&self, slope: impl Fn(&Numbers<f64>) -> f64, value: f64, below: f64, own: f64) -> [f64; 2] {
        let mut quotients = [(0.0, 0.0); LEVELS];
        for (one, all) in quotients.iter_mut().zip(&self.around.quotients) {
            *one = (all.step, slope(&all.slopes));
        }
        let estimate = extrapolated(&quotients[..self.around.quotients.len().min(LEVELS)], below);
        [(value - estimate.value).abs(), SAFETY * (estimate.error + own)]
    }

    /// Of both components of the transfer function of an element; links and slides have one.
    fn compare(&self, (i, element): (usize, Element), order: usize) -> impl Iterator<Item = Deviation> {
        let Self { subject, around, found, sizes, .. } = self;
        let unit = subject.unit(order, element.is_length());
        let below_unit = subject.unit(order - 1, element.is_length());
        let floor = |number: f64, unit: f64| FLOOR * f64::EPSILON * (number.abs() + unit) * self.distance;
        let links = element.links(subject.linkage);
        let size = links.map(|link| sizes[link][order]).into_iter().fold(1.0, f64::max);
        let components = 0..element.components();
        components.map(move |k| {
            let below = around.below.motion(i, order - 1, k);
            let below = below.max(around.floor * floor(around.values.motion(i, order - 1, k), below_unit));
            let least = around.floor.max(1.0) * floor(around.values.motion(i, order, k), unit);
            let own = around.own.motion(i, order, k) + least;
            let slope = |slopes: &Numbers<f64>| slopes.motion(i, order - 1, k);
            let [off, limit] = self.deviation(slope, found.motion(i, order, k), below, own);
            let (off, limit) = (off / unit, limit / unit);
            Deviation { check: order - 1, element: Some(element), off, limit, size }
        })
    }

    fn compare_inertia(&self) -> Option<Deviation> {
        let Self { subject, one, around, found, .. } = self;
        let [size, slope] = [0, 1].map(|order| around.values.inertia(order));
        if size == 0.0 {
            return None;
        }
        let unit = size.abs() / subject.linkage.coordinate_unit();
        // J' sums products of PF1 and PF2 that cancel; the rounding of each is that of the terms.
        let terms = {
            let position = &one.position;
            kinetics::sizes(&subject.linkage.mechanism, position.coordinate, &position.bodies)[1]
        };
        let floor = FLOOR * f64::EPSILON;
        let below = around.below.inertia(0).max(around.floor * floor * size.abs());
        let own = around.own.inertia(1) + around.floor.max(1.0) * floor * (slope.abs() + unit);
        let [off, limit] = self.deviation(|slopes| slopes.inertia(0), found.inertia(1), below, own);
        let (off, limit, size) = (off / unit, limit / unit, 1.0_f64.max(terms / unit));
        Some(Deviation { check: 2, element: None, off, limit, size })
    }
}
