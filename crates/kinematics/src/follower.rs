//! Follows one group after the other along a branch.

use assur_group::{Body, GroupError, Order};
use assur_number::{Dd, Lanes, Real};
use assur_structure::Structure;

use crate::branch::{Branch, Passage};
use crate::meeting::{Judge, Minimum};
use crate::samples::{Samples, Scratch};
use crate::track::{Tracker, pose_distance};
use crate::wide::{Assembly, Wide};
use crate::{Chain, ChainError, dependence::Dependence, poses::Poses};

/// Coordinates whose relative difference is smaller than this are equal.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Two meetings of one group nearer than this, in units of the coordinate, are one.
const SAME_MEETING: f64 = 1e-6;

/// Distances past a change point at which the motion is compared with its extrapolation from before it, in steps of
/// the branch.
const BEHIND: f64 = 0.25;

/// Data for following a branch.
#[derive(Debug)]
pub(crate) struct Follower<'a> {
    pub(crate) chain: &'a Chain<f64>,
    /// The chain for eight samples at once.
    pub(crate) lane_chain: &'a Chain<Lanes>,
    pub(crate) structure: &'a Structure,
    pub(crate) dependence: &'a Dependence,
    /// The chain in 32 digits.
    pub(crate) wide: Wide<'a>,
    /// Links of the groups that iterate.
    pub(crate) iterated: Vec<usize>,
    /// Unit of the coordinate: 1 rad, or the scale in m.
    pub(crate) unit: f64,
}

/// How the present mode of a group ends.
pub(crate) enum Event {
    /// The group continues in another mode past this coordinate.
    Transition(Passage),
    /// The group can't be assembled beyond this coordinate.
    End(f64, GroupError),
}

impl Follower<'_> {
    /// Follows all groups along a branch; with `is_back`, a meeting at the start itself belongs to it.
    pub(crate) fn follow(&mut self, mut branch: Branch, is_back: bool) -> Branch {
        self.wide.restart(Order::Place);
        let mut scratch = Scratch { bodies: self.chain.bodies(), lanes: self.lane_chain.bodies() };
        self.place_input(&mut branch, &mut scratch);
        let released = self.released();
        for group in (0..self.chain.groups.len()).filter(|group| self.chain.needed[*group]) {
            self.follow_group(group, &mut branch, is_back, &mut scratch);
            for &link in &released[group] {
                branch.poses[link] = Poses::default();
            }
        }
        branch.trim();
        branch
    }

    /// Places what is driven at all samples.
    fn place_input(&self, branch: &mut Branch, scratch: &mut Scratch) {
        let inputs = || self.chain.inputs.iter().map(crate::ChainInput::body);
        let whole = branch.samples - branch.samples % Lanes::WIDTH;
        inputs().for_each(|input| branch.poses[input].reserve(branch.samples));
        for first in (0..whole).step_by(Lanes::WIDTH) {
            let coordinates = Lanes::of(|lane| branch.at(first + lane));
            self.lane_chain.set_input(coordinates, &mut scratch.lanes);
            inputs().for_each(|input| branch.poses[input].push_block(&scratch.lanes[input]));
        }
        for sample in whole..branch.samples {
            self.chain.set_input(branch.at(sample), &mut scratch.bodies);
            inputs().for_each(|input| branch.poses[input].push(&scratch.bodies[input]));
        }
    }

    /// For each group the links whose poses no later group needs. Those that are iterated are kept.
    fn released(&self) -> Vec<Vec<usize>> {
        let mut users = vec![None; self.chain.bodies().len()];
        for (group, found) in self.structure.groups.iter().enumerate() {
            let frame = &found.frame;
            frame.carriers().chain(frame.links.iter().copied()).for_each(|link| users[link] = Some(group));
        }
        self.iterated.iter().for_each(|&link| users[link] = None);
        let mut released = vec![Vec::new(); self.structure.groups.len()];
        for (link, user) in users.into_iter().enumerate() {
            if let Some(user) = user {
                released[user].push(link);
            }
        }
        released
    }

    /// Follows a group from event to event to the end of the branch or of its own range.
    fn follow_group(&mut self, group: usize, branch: &mut Branch, is_back: bool, scratch: &mut Scratch) {
        let kernel = self.chain.groups[group].as_ref();
        let iterates = self.structure.groups[group].plugin.iterates;
        let lanes = (!iterates).then(|| self.lane_chain.groups[group].as_ref());
        let (chain, dependence, scale) = (self.chain, self.dependence, self.structure.scale);
        let tracker = iterates.then_some(Tracker { chain, dependence, group, scale });
        let mut samples =
            Samples::new((kernel, lanes), (tracker, branch.way(group, branch.from)), scratch, branch);
        samples.place_from(0, branch);
        let mut sample = 0;
        loop {
            let event = match samples.failure {
                Some(source) if sample == samples.health.len() => Some(match samples.torn {
                    Some(last) => Event::End(last, source),
                    None => self.stop((group, samples.way), sample, source, branch),
                }),
                None if sample == samples.health.len() => {
                    let found = (!iterates).then(|| self.stop_behind((group, samples.way), branch)).flatten();
                    let Some(event) = found else { break };
                    Some(event)
                }
                _ if kernel.ways() == 1 => None,
                _ => {
                    let found = self.meeting(group, sample, &mut samples, branch, is_back);
                    found.or_else(|| {
                        let jumps = !iterates && samples.jumps(sample);
                        jumps.then(|| self.jump((group, samples.way), sample, branch)).flatten()
                    })
                }
            };
            match event {
                None => sample += 1,
                Some(Event::End(coordinate, source)) => {
                    let end = branch.distance(coordinate);
                    let inside =
                        (0..samples.health.len()).take_while(|i| branch.distance(branch.at(*i)) <= end);
                    branch.end(coordinate, inside.count(), ChainError { group, source });
                    break;
                }
                Some(Event::Transition(passage)) => {
                    branch.passages[group].push(passage);
                    samples.way = passage.after;
                    let behind = |sample: &usize| branch.distance(branch.at(*sample)) > passage.distance;
                    let first = (0..branch.samples).find(behind).unwrap_or(branch.samples);
                    samples.place_from(first, branch);
                    sample = (sample + 1).min(samples.health.len());
                }
            }
        }
    }

    /// Whether two modes of a group meet near a sample (its determinant touches zero), or leave a gap.
    fn meeting(
        &mut self,
        group: usize,
        sample: usize,
        samples: &mut Samples<'_>,
        branch: &mut Branch,
        is_back: bool,
    ) -> Option<Event> {
        let last = samples.health.len() - 1;
        // Past its last sample the group can't be assembled; `stop` handles that.
        if samples.failure.is_some() && sample == last {
            return None;
        }
        let offset = samples.minimum_near(sample)?;
        let near = branch.at(sample) + offset * (branch.at(1) - branch.at(0));
        let reached = branch.distance(branch.at(last));
        let resolution = samples.resolution(sample, branch);
        let meeting = match self.judge((group, samples.way), (near, resolution), branch) {
            Minimum::Beside => return None,
            Minimum::Gap(inside, gap_m) => {
                let distance = branch.distance(inside);
                let is_before = |sample: &usize| branch.distance(branch.at(*sample)) < distance;
                let before = (0..=last).rev().find(is_before).filter(|_| distance <= reached)?;
                let end = self.end((group, samples.way), branch.at(before), inside, branch)[0];
                return Some(Event::End(end, GroupError::NoAssembly { gap_m }));
            }
            Minimum::Meeting(meeting) => meeting,
        };
        branch.meetings.push(meeting);
        let rounding = ROUNDING * self.unit.max(branch.at(last).abs()).max(branch.from.abs());
        let mut distance = branch.distance(meeting.coordinate);
        if distance.abs() <= rounding {
            branch.met_at_start.push(group);
            if !is_back {
                return None;
            }
            distance = 0.0;
        }
        let is_new = |one: &Passage| (one.distance - distance).abs() > SAME_MEETING * self.unit;
        let is_within = distance >= 0.0 && distance <= reached + rounding;
        (is_within && branch.passages[group].last().is_none_or(is_new))
            .then(|| Event::Transition(self.through((group, samples.way), distance, branch)))
    }

    fn judge(
        &mut self,
        (group, way): (usize, u8),
        (near, resolution): (f64, f64),
        branch: &Branch,
    ) -> Minimum {
        let wide = &mut self.wide;
        if !wide.is_available() {
            return Minimum::Beside;
        }
        let mut determinant = |q: Dd| wide.solve(q, (group, way), branch).map(|(_, health)| health);
        let earlier = &branch.meetings;
        Judge { determinant: &mut determinant, sample: branch.step(), resolution, earlier }.judge(near)
    }

    /// The passage of a group through a meeting at a distance from the start, into the mode that continues the motion.
    fn through(&mut self, (group, before): (usize, u8), distance: f64, branch: &Branch) -> Passage {
        let mut after = before;
        // A smaller step, because another event may be within the first one.
        for steps in [BEHIND, 0.1 * BEHIND, 0.01 * BEHIND] {
            if let Some(found) = self.continuing((group, before), distance, steps * branch.step(), branch) {
                after = found;
                break;
            }
        }
        Passage { distance, before, after, is_change_point: true }
    }

    /// The mode that continues the motion of a group past a distance from the start, extrapolated from its poses at
    /// three multiples of `step` before it; `None` if they can't be solved.
    fn continuing(
        &mut self,
        (group, way): (usize, u8),
        distance: f64,
        step: f64,
        branch: &Branch,
    ) -> Option<u8> {
        let wide = &mut self.wide;
        wide.is_available().then_some(())?;
        // All groups that meet here use the same places.
        let lattice = step / 16.0;
        let middle = (distance / lattice).round() * lattice;
        let mut solve = |steps: f64, way: u8| {
            let q = Dd::from_f64(branch.coordinate(middle + steps * step));
            let (bodies, _) = wide.solve(q, (group, way), branch).ok()?;
            Some(bodies.iter().map(|body| body.map(Real::to_f64)).collect::<Vec<_>>())
        };
        let [far, middle, near] = [solve(-3.0, way)?, solve(-2.0, way)?, solve(-1.0, way)?];
        // Parabola through three poses, extrapolated one step past the meeting.
        let expected = |link: usize| {
            let [far, middle, near] = [&far, &middle, &near].map(|bodies| bodies[link].numbers());
            Body::of_numbers(std::array::from_fn(|k| 3.0 * far[k] - 8.0 * middle[k] + 6.0 * near[k]))
        };
        let expected: Vec<_> = (0..near.len()).map(expected).collect();
        let scale = self.structure.scale;
        let ways = 0..u8::try_from(self.chain.groups[group].ways()).unwrap_or(u8::MAX);
        let candidates = ways
            .filter_map(|way| Some((way, pose_distance(solve(1.0, way)?, expected.iter().copied(), scale))));
        candidates.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(way, _)| way)
    }

    /// A meeting at the start of a full turn is found again at its end, and is counted there, once.
    pub(crate) fn close(&mut self, branch: &mut Branch) {
        let length = branch.reached.abs();
        let rounding = 16.0 * ROUNDING * (length + 1.0);
        for group in std::mem::take(&mut branch.met_at_start) {
            let is_end = |one: &Passage| (one.distance - length).abs() <= rounding;
            if !branch.passages[group].iter().any(is_end) {
                let way = branch.last()[group];
                let passage = self.through((group, way), length, branch);
                branch.passages[group].push(passage);
            }
        }
    }
}
