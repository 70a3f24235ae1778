//! Where a group can't be placed any further, or jumps: the end of its range, or a change in the numbering of its modes.

use assur_group::{Body, GroupError};
use assur_number::search::bisect;

use crate::branch::{Branch, Passage};
use crate::follower::{Event, Follower};
use crate::{track::placed_before, track::pose_distance};

/// Poses on both sides of a coordinate that differ by less than this (parts of the scale, or rad) continue each
/// other.
const CONTINUOUS: f64 = 1e-6;

impl Follower<'_> {
    /// Examines where a group can't be placed at a sample: either its range ends, or another mode continues the
    /// motion.
    pub(crate) fn stop(
        &self,
        (group, way): (usize, u8),
        sample: usize,
        source: GroupError,
        branch: &Branch,
    ) -> Event {
        let Some(before) = sample.checked_sub(1) else { return Event::End(branch.from, source) };
        let ends = self.end((group, way), branch.behind(group, before), branch.at(sample), branch);
        self.stopped((group, way), ends, source, branch)
    }

    /// Likewise for a group that can't be placed at the end of a branch, which a group before it has set beyond the last sample;
    /// `None` where it can.
    pub(crate) fn stop_behind(&self, (group, way): (usize, u8), branch: &Branch) -> Option<Event> {
        let (last, reached) = (branch.samples.checked_sub(1)?, branch.from + branch.reached);
        branch.failure.as_ref()?;
        let kernel = self.chain.groups[group].as_ref();
        let error = |q: f64| match placed_before((self.chain, self.dependence), group, q, branch) {
            Ok(mut bodies) => kernel.place(&mut bodies, usize::from(way)).err(),
            // A group before it may not be found so near to its own end: that says nothing of this one.
            Err(_) => None,
        };
        let source = error(reached).filter(|error| matches!(error, GroupError::NoAssembly { .. }))?;
        let ends = bisect(branch.behind(group, last), reached, 0.0, |q| error(q).is_none());
        Some(self.stopped((group, way), ends, source, branch))
    }

    fn stopped(&self, at: (usize, u8), [good, bad]: [f64; 2], source: GroupError, branch: &Branch) -> Event {
        let is_bounded = branch.passages[at.0].len() < branch.samples;
        let renumbered = self.renumbered(at, [good, bad], branch).filter(|_| is_bounded);
        renumbered.map_or(Event::End(good, source), Event::Transition)
    }

    /// A transition between a sample and the previous one, from which the pose jumps, if it jumps because the kind's numbering of its
    /// modes changes.
    pub(crate) fn jump(&self, (group, way): (usize, u8), sample: usize, branch: &Branch) -> Option<Event> {
        let links = &self.chain.groups[group].frame().links;
        let scale = self.structure.scale;
        let poses = |sample: usize| links.iter().map(move |&link| branch.pose(link, sample));
        let is_before = |q: f64| {
            let found = self.place((group, way), q, branch);
            found.is_ok_and(|bodies| {
                let own = self.own(group, &bodies);
                let apart = |sample: usize| pose_distance(own.iter().copied(), poses(sample), scale);
                apart(sample - 1) < apart(sample)
            })
        };
        let ends = bisect(branch.behind(group, sample - 1), branch.at(sample), 0.0, is_before);
        self.renumbered((group, way), ends, branch).map(Event::Transition)
    }

    /// The other mode that continues the motion of a group between neighboring coordinates, if its present one does
    /// not.
    fn renumbered(
        &self,
        (group, before): (usize, u8),
        [good, bad]: [f64; 2],
        branch: &Branch,
    ) -> Option<Passage> {
        let placed = |way: u8, q: f64| Some(self.own(group, &self.place((group, way), q, branch).ok()?));
        let last = placed(before, good)?;
        let continues = |way: &u8| {
            let next = placed(*way, bad);
            next.is_some_and(|next| {
                pose_distance(last.iter().copied(), next, self.structure.scale) < CONTINUOUS
            })
        };
        let ways = 0..u8::try_from(self.chain.groups[group].ways()).unwrap_or(u8::MAX);
        let after = if continues(&before) { None } else { ways.filter(|way| *way != before).find(continues) };
        let distance = branch.distance(bad);
        after.map(|after| Passage { distance, before, after, is_change_point: false })
    }

    /// Two neighboring coordinates: the group can be placed at the first and not at the second.
    pub(crate) fn end(&self, at: (usize, u8), good: f64, bad: f64, branch: &Branch) -> [f64; 2] {
        bisect(good, bad, 0.0, |q| self.place(at, q, branch).is_ok())
    }

    /// Places a group and the groups that determine its motion; returns all bodies.
    fn place(
        &self,
        (group, way): (usize, u8),
        q: f64,
        branch: &Branch,
    ) -> Result<Vec<Body<f64>>, GroupError> {
        let mut bodies = placed_before((self.chain, self.dependence), group, q, branch)?;
        self.chain.groups[group].place(&mut bodies, usize::from(way))?;
        Ok(bodies)
    }

    fn own(&self, group: usize, bodies: &[Body<f64>]) -> Vec<Body<f64>> {
        self.chain.groups[group].frame().links.iter().map(|&link| bodies[link]).collect()
    }
}
