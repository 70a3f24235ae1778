//! The samples of one group along a branch.

use assur_group::{AssurGroup, Body, GroupError};
use assur_number::{Lanes, Real as _};

use crate::branch::Branch;
use crate::track::{LONGEST, Tracker, pose_distance};

/// A local minimum of the determinant among the samples that is above this can't belong to a zero between two of them.
pub(crate) const SUSPECT: f64 = 0.2;

/// A squared determinant whose interpolating parabola stays above this has no zero between the samples.
const CLEAR: f64 = 1e-4;

/// A pose that changes by more than the first number (rad, or parts of the scale), and by more than the second number
/// times the previous change, may have jumped.
const LEAST_JUMP: f64 = 0.02;
const JUMP_RATIO: f64 = 4.0;

/// Storage for all bodies of the mechanism, at one sample and at eight.
#[derive(Debug)]
pub(crate) struct Scratch {
    pub(crate) bodies: Vec<Body<f64>>,
    pub(crate) lanes: Vec<Body<Lanes>>,
}

/// One group, placed at successive samples in its present mode.
pub(crate) struct Samples<'a> {
    kernel: &'a dyn AssurGroup<f64>,
    /// The kernel for eight samples, where its solution needs no starting pose.
    lanes: Option<&'a dyn AssurGroup<Lanes>>,
    /// The bodies that carry it.
    outer: Vec<usize>,
    scratch: &'a mut Scratch,
    /// A typical length of the mechanism, m.
    scale: f64,
    /// The present mode.
    pub(crate) way: u8,
    /// Absolute value of the determinant at each sample.
    pub(crate) health: Vec<f64>,
    /// Square of the distance of the pose at each sample from that at the one before; see [`pose_distance`].
    moved: Vec<f64>,
    /// Why it can't be placed at the sample after the last one.
    pub(crate) failure: Option<GroupError>,
    /// Follows a kind that iterates where its pose changes much from sample to sample.
    tracker: Option<Tracker<'a>>,
    /// The last coordinate at which such a kind can be placed, if that is known.
    pub(crate) torn: Option<f64>,
}

impl<'a> Samples<'a> {
    pub(crate) fn new(
        (kernel, lanes): (&'a dyn AssurGroup<f64>, Option<&'a dyn AssurGroup<Lanes>>),
        (tracker, way): (Option<Tracker<'a>>, u8),
        scratch: &'a mut Scratch,
        branch: &Branch,
    ) -> Self {
        let frame = kernel.frame();
        let outer = frame.carriers().collect();
        let storage = || Vec::with_capacity(branch.samples);
        let (health, moved) = (storage(), storage());
        let scale = frame.scale;
        Self { kernel, lanes, outer, scratch, scale, way, health, moved, failure: None, tracker, torn: None }
    }

    /// Places the group at all samples from one on, until it can't be assembled; earlier samples stay unchanged.
    pub(crate) fn place_from(&mut self, first: usize, branch: &mut Branch) {
        self.health.truncate(first);
        self.moved.truncate(first);
        self.failure = None;
        self.torn = None;
        let links = &self.kernel.frame().links;
        for &link in links {
            branch.poses[link].truncate(first);
            branch.poses[link].reserve(branch.samples);
        }
        while self.health.len() < branch.samples && self.failure.is_none() {
            let is_whole = self.health.len().is_multiple_of(Lanes::WIDTH)
                && self.health.len() + Lanes::WIDTH <= branch.samples;
            if is_whole && self.place_eight(branch) {
                continue;
            }
            let end = (self.health.len() / Lanes::WIDTH + 1) * Lanes::WIDTH;
            while self.health.len() < end.min(branch.samples) && self.failure.is_none() {
                self.place_next(branch);
            }
        }
    }

    /// Places the group at the next eight samples; `false` where one of them has no solution.
    fn place_eight(&mut self, branch: &mut Branch) -> bool {
        let Some(kernel) = self.lanes else { return false };
        let block = self.health.len() / Lanes::WIDTH;
        let bodies = &mut self.scratch.lanes;
        self.outer.iter().for_each(|&body| branch.poses[body].load(block, &mut bodies[body]));
        let Ok(found) = kernel.place(bodies, usize::from(self.way)) else { return false };
        self.health.extend(found.abs().0);
        let mut moved = [0.0; Lanes::WIDTH];
        for &link in &kernel.frame().links {
            let body = &bodies[link];
            raise(&mut moved, branch.poses[link].last(), body, 1.0 / self.scale);
            branch.poses[link].push_block(body);
        }
        self.moved.extend(moved);
        true
    }

    /// Places the group at the next sample.
    fn place_next(&mut self, branch: &mut Branch) {
        let (kernel, bodies, sample) = (self.kernel, &mut self.scratch.bodies, self.health.len());
        self.outer.iter().for_each(|&body| bodies[body] = branch.pose(body, sample));
        // A kind that iterates starts from the previous sample.
        let links = &kernel.frame().links;
        for &link in links {
            bodies[link] = branch.poses[link].last().unwrap_or(branch.start[link]);
        }
        let mut placed = kernel.place(bodies, usize::from(self.way));
        let before: Vec<_> =
            links.iter().map(|&link| branch.poses[link].last().unwrap_or(bodies[link])).collect();
        let distance = |bodies: &[Body<f64>]| {
            pose_distance(links.iter().map(|&link| bodies[link]), before.iter().copied(), self.scale)
        };
        // Past a place where two modes meet, the sample before belongs to the mode before: there is nothing to follow from.
        let is_met = |tracker: &Tracker<'_>| {
            let last = branch.passages[tracker.group].last();
            last.is_some_and(|last| last.distance >= branch.distance(branch.at(sample - 1)))
        };
        if let Some(tracker) = self.tracker.filter(|tracker| sample > 0 && !is_met(tracker)) {
            let is_lost = matches!(placed, Err(GroupError::NoAssembly { .. }));
            if is_lost || placed.is_ok() && distance(bodies) > LONGEST {
                let start = (branch.at(sample - 1), before.clone());
                match tracker.follow(self.way, start, branch.at(sample), branch) {
                    Ok(found) => {
                        links.iter().zip(found).for_each(|(&link, body)| bodies[link] = body);
                        placed = Ok(kernel.health(bodies));
                    }
                    Err((last, reason)) => {
                        self.torn = Some(last);
                        placed = Err(reason);
                    }
                }
            }
        }
        match placed {
            Ok(found) => self.health.push(found.abs()),
            // At a change point itself a group may report "singular": the branch continues beyond it.
            Err(GroupError::Singular { .. }) => self.health.push(0.0),
            Err(failure) => {
                self.failure = Some(failure);
                return;
            }
        }
        let moved = distance(bodies);
        self.moved.push(moved * moved);
        for &link in links {
            branch.poses[link].push(&bodies[link]);
        }
    }

    /// Whether the pose changes abruptly from the sample before to this one: by far more than over the step before.
    pub(crate) fn jumps(&self, sample: usize) -> bool {
        if sample < 2 || self.moved[sample] < LEAST_JUMP * LEAST_JUMP {
            return false;
        }
        self.moved[sample].sqrt() >= LEAST_JUMP + JUMP_RATIO * self.moved[sample - 1].sqrt()
    }

    /// Determinant below which, near a sample, nothing but rounding is left.
    pub(crate) fn resolution(&mut self, sample: usize, branch: &Branch) -> f64 {
        let kernel = self.kernel;
        let links = self.outer.iter().chain(&kernel.frame().links);
        links.for_each(|&body| self.scratch.bodies[body] = branch.pose(body, sample));
        kernel.resolution(&self.scratch.bodies)
    }

    /// Where the squared determinant has a minimum near a sample, in samples from it; `None` if there is no minimum,
    /// or one that is certainly not zero.
    pub(crate) fn minimum_near(&self, sample: usize) -> Option<f64> {
        let (health, last) = (&self.health, self.health.len() - 1);
        let before = sample.checked_sub(1).map_or(f64::INFINITY, |before| health[before]);
        let after = health.get(sample + 1).copied().unwrap_or(f64::INFINITY);
        if health[sample] > before || health[sample] >= after || health[sample] > SUSPECT {
            return None;
        }
        if last < 2 {
            return Some(0.0);
        }
        let square = |sample: usize| health[sample] * health[sample];
        let bend = |sample: usize| square(sample - 1) - 2.0 * square(sample) + square(sample + 1);
        let middle = sample.clamp(1, last - 1);
        let (slope, curvature) = (0.5 * (square(middle + 1) - square(middle - 1)), bend(middle));
        if curvature <= 0.0 {
            return Some(0.0);
        }
        let least = square(middle) - 0.5 * slope * slope / curvature;
        // The neighboring samples show the error of the parabola.
        let is_inside = middle >= 2 && middle + 2 <= last;
        if is_inside {
            let change = [middle - 1, middle + 1].map(|other| (bend(other) - curvature).abs());
            if least - change[0].max(change[1]) > CLEAR {
                return None;
            }
        }
        let place = (middle as f64 - slope / curvature)
            .clamp(sample.saturating_sub(1) as f64, last.min(sample + 1) as f64);
        Some(place - sample as f64)
    }
}

/// Raises each number to the square of the distance of a pose from the one before, if that is greater; `by`: factor of
/// places.
fn raise(moved: &mut [f64; Lanes::WIDTH], before: Option<Body<f64>>, body: &Body<Lanes>, by: f64) {
    let numbers = [body.x.0, body.y.0, body.c.0, body.s.0];
    let mut earlier = numbers;
    let first = before.map_or(numbers.map(|now| now[0]), |before| [before.x, before.y, before.c, before.s]);
    for k in 0..numbers.len() {
        earlier[k][0] = first[k];
        earlier[k][1..].copy_from_slice(&numbers[k][..Lanes::WIDTH - 1]);
    }
    for lane in 0..Lanes::WIDTH {
        let step = |k: usize| numbers[k][lane] - earlier[k][lane];
        let (dx, dy, dc, ds) = (by * step(0), by * step(1), step(2), step(3));
        let (place, turn) = (dx * dx + dy * dy, dc * dc + ds * ds);
        let most = if place > turn { place } else { turn };
        moved[lane] = if most > moved[lane] { most } else { moved[lane] };
    }
}
