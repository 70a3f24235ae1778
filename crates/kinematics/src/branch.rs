//! The assembly, followed from the first position in one direction.

use assur_group::Body;

use crate::{ChainError, meeting::Meeting, poses::Poses, wide::Assembly};

/// A transition of one group on a branch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Passage {
    /// Distance from the start in the direction of the branch, rad or m.
    pub(crate) distance: f64,
    /// The group's way before it.
    pub(crate) before: u8,
    /// The group's way after it.
    pub(crate) after: u8,
    /// Whether two modes meet there.
    pub(crate) is_change_point: bool,
}

/// A branch as far as it is known. Groups are followed one after the other, each over the whole branch.
#[derive(Debug)]
pub(crate) struct Branch {
    /// Coordinate of the start.
    pub(crate) from: f64,
    /// Full length if every group can be assembled, rad or m; negative towards smaller coordinates.
    length: f64,
    /// Number of steps in the full length.
    steps: usize,
    /// Number of samples, the start included, at which all groups followed up to now can be assembled.
    pub(crate) samples: usize,
    /// Length over which the mechanism can be assembled, rad or m, with the sign of `length`.
    pub(crate) reached: f64,
    /// What ends the branch before its full length.
    pub(crate) failure: Option<ChainError>,
    /// The modes at the start.
    first: Vec<u8>,
    /// The passages of each group, in order of increasing distance.
    pub(crate) passages: Vec<Vec<Passage>>,
    /// Groups for which the start is a change point. It belongs to the branch of descending coordinates, as its first passage; the
    /// ascending branch begins just beyond it.
    pub(crate) met_at_start: Vec<usize>,
    /// The meetings of all groups followed up to now.
    pub(crate) meetings: Vec<Meeting>,
    /// For each link, its pose at every sample, as long as other groups need it.
    pub(crate) poses: Vec<Poses>,
    /// Links of the groups that iterate.
    iterated: Vec<usize>,
    /// All links at the start.
    pub(crate) start: Vec<Body<f64>>,
}

impl Branch {
    pub(crate) fn new(
        from: f64,
        (length, steps): (f64, usize),
        first: &[u8],
        (start, iterated): (&[Body<f64>], &[usize]),
    ) -> Self {
        Self {
            from,
            length,
            steps,
            samples: steps + 1,
            reached: length,
            failure: None,
            first: first.to_vec(),
            passages: vec![Vec::new(); first.len()],
            met_at_start: Vec::new(),
            meetings: Vec::new(),
            poses: vec![Poses::default(); start.len()],
            iterated: iterated.to_vec(),
            start: start.to_vec(),
        }
    }

    /// Pose of a link at a sample; where there is none, that at the start.
    pub(crate) fn pose(&self, link: usize, sample: usize) -> Body<f64> {
        self.poses[link].get(sample).unwrap_or(self.start[link])
    }

    /// Coordinate of a sample.
    pub(crate) fn at(&self, sample: usize) -> f64 {
        self.from + self.length * (sample as f64) / (self.steps as f64)
    }

    /// Distance between neighboring samples, positive.
    pub(crate) fn step(&self) -> f64 {
        self.length.abs() / self.steps as f64
    }

    /// Distance from the start in the direction of the branch.
    pub(crate) fn distance(&self, coordinate: f64) -> f64 {
        (coordinate - self.from) * self.length.signum()
    }

    /// The coordinate at a distance from the start.
    pub(crate) fn coordinate(&self, distance: f64) -> f64 {
        self.from + distance * self.length.signum()
    }

    /// Coordinate of a sample, or of the last passage of a group if that is past the sample.
    pub(crate) fn behind(&self, group: usize, sample: usize) -> f64 {
        let coordinate = self.at(sample);
        let passed = self.passages[group].last().filter(|one| one.distance > self.distance(coordinate));
        passed.map_or(coordinate, |one| self.coordinate(one.distance))
    }

    /// Ends the branch at a coordinate, after this number of samples.
    pub(crate) fn end(&mut self, coordinate: f64, samples: usize, failure: ChainError) {
        self.reached = coordinate - self.from;
        self.samples = samples;
        self.failure = Some(failure);
    }

    /// Removes the passages past the end of the branch.
    pub(crate) fn trim(&mut self) {
        let reached = self.reached.abs();
        self.passages.iter_mut().for_each(|passages| passages.retain(|one| one.distance <= reached));
    }

    /// The modes at the end of the branch.
    pub(crate) fn last(&self) -> Vec<u8> {
        let last = |(first, passages): (&u8, &Vec<Passage>)| passages.last().map_or(*first, |one| one.after);
        self.first.iter().zip(&self.passages).map(last).collect()
    }
}

impl Assembly for Branch {
    fn way(&self, group: usize, coordinate: f64) -> u8 {
        let distance = self.distance(coordinate);
        let passed = self.passages[group].iter().rev().find(|one| one.distance < distance);
        passed.map_or(self.first[group], |one| one.after)
    }

    fn guess(&self, coordinate: f64, bodies: &mut [Body<f64>]) {
        let nearest = (self.distance(coordinate) / self.step()).round();
        for &link in &self.iterated {
            let last = self.poses[link].iter().len().saturating_sub(1) as f64;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "clamped to the samples"
            )]
            let sample = nearest.clamp(0.0, last) as usize;
            bodies[link] = self.pose(link, sample);
        }
    }
}
