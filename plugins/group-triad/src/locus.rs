//! The conditions of three legs on the pose of the plate relative to the base, and all poses that satisfy them.

use assur_group::plane::{cross, dot, length, meet, minus, opposite, perp, plus, scaled, times};
use assur_number::Real;

use crate::trig::{Trig, sampled};

/// A determinant of two lines below this, in parts of its greatest value, is not divided by, nor is it where circles are closer to
/// concentric than this part of the size: the poses are then found from each line alone.
const FLAT: f64 = 1e-3;

/// By how much a pose that was found from two legs may miss the third before it is polished, in parts of the size.
const NEAR: f64 = 0.05;

/// Samples over a turn, in the search for the least gap.
const GAP_SAMPLES: usize = 96;

/// The condition of one leg. `at` is a point in the frame of the base, `on` one in that of the plate, m.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Locus<T> {
    /// Their distance is given.
    Circle { at: [T; 2], on: [T; 2], length: T },
    /// The way from `at` to `on` has a given part along a normal of the base.
    OnBase { at: [T; 2], on: [T; 2], normal: [T; 2], offset: T },
    /// The way from `on` to `at` has a given part along a normal of the plate.
    OnPlate { at: [T; 2], on: [T; 2], normal: [T; 2], offset: T },
    /// The direction of the plate is given.
    Angle { direction: [T; 2] },
}

/// Pose of the plate relative to the base: origin, m, and direction of its x axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pose<T> {
    pub(crate) origin: [T; 2],
    pub(crate) direction: [T; 2],
}

/// A line for the way r of the reference leg: m r = k.
type Straight<T> = ([T; 2], T);

impl<T: Real> Locus<T> {
    fn ends(&self) -> [[T; 2]; 2] {
        match *self {
            Self::Circle { at, on, .. } | Self::OnBase { at, on, .. } | Self::OnPlate { at, on, .. } => {
                [at, on]
            }
            Self::Angle { .. } => [[T::ZERO; 2]; 2],
        }
    }

    /// Length by which the condition is violated where the way from `at` to `on` is given, m.
    fn miss(&self, way: [T; 2], direction: [T; 2]) -> T {
        match *self {
            Self::Circle { length, .. } => (dot(way, way).sqrt() - length).abs(),
            Self::OnBase { normal, offset, .. } => (dot(normal, way) - offset).abs(),
            Self::OnPlate { normal, offset, .. } => (dot(times(normal, direction), way) + offset).abs(),
            Self::Angle { .. } => T::ZERO,
        }
    }
}

/// Three conditions, the reference first: a circle, if there is one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Loci<T> {
    all: [Locus<T>; 3],
    /// Greatest distance of the joints, m.
    size: f64,
}

/// Two conditions for the way of the reference leg at one direction of the plate, with what the third is.
struct Cut<T> {
    direction: [T; 2],
    /// From the way of the reference leg to that of each leg.
    offsets: [[T; 2]; 3],
}

impl<T: Real> Loci<T> {
    pub(crate) fn new(mut all: [Locus<T>; 3]) -> Self {
        let rank = |locus: &Locus<T>| match locus {
            Locus::Circle { .. } => 0,
            Locus::OnBase { .. } | Locus::OnPlate { .. } => 1,
            Locus::Angle { .. } => 2,
        };
        all.sort_by_key(rank);
        let mut size = 0.0_f64;
        let [at, on] = all[0].ends();
        for locus in &all {
            let [other, its] = locus.ends();
            let own = match *locus {
                Locus::Circle { length, .. } => length,
                Locus::OnBase { offset, .. } | Locus::OnPlate { offset, .. } => offset.abs(),
                Locus::Angle { .. } => T::ZERO,
            };
            if !matches!(locus, Locus::Angle { .. }) {
                size = size.max(length(minus(other, at))).max(length(minus(its, on))).max(own.to_f64());
            }
        }
        Self { all, size }
    }

    fn cut(&self, direction: [T; 2]) -> Cut<T> {
        let [at, on] = self.all[0].ends();
        let offsets = self.all.map(|locus| {
            let [other, its] = locus.ends();
            minus(times(minus(its, on), direction), minus(other, at))
        });
        Cut { direction, offsets }
    }

    /// The condition of a leg for the way of the reference leg as a line; of a circle the line through its points of
    /// intersection with the reference circle.
    fn straight(&self, cut: &Cut<T>, leg: usize) -> Straight<T> {
        let u = cut.offsets[leg];
        match self.all[leg] {
            Locus::Circle { length, .. } => {
                let own = match self.all[0] {
                    Locus::Circle { length, .. } => length,
                    _ => T::ZERO,
                };
                (u, ((length - own) * (length + own) - dot(u, u)).half())
            }
            Locus::OnBase { normal, offset, .. } => (normal, offset - dot(normal, u)),
            Locus::OnPlate { normal, offset, .. } => {
                let m = times(normal, cut.direction);
                (m, -offset - dot(m, u))
            }
            Locus::Angle { .. } => ([T::ZERO; 2], T::ZERO),
        }
    }

    /// The closure as a function of the direction of the plate: zero where all three conditions hold, and of degree 3 at
    /// most; with the size of its greatest terms.
    fn closure(&self, direction: [T; 2]) -> (T, f64) {
        let cut = self.cut(direction);
        let [(m1, k1), (m2, k2)] = [self.straight(&cut, 1), self.straight(&cut, 2)];
        let d = cross(m1, m2);
        let n = [k1 * m2[1] - k2 * m1[1], k2 * m1[0] - k1 * m2[0]];
        let terms = |leg: usize, m: [T; 2]| {
            let u = cut.offsets[leg];
            match (self.all[leg], self.all[0]) {
                (Locus::Circle { length, .. }, Locus::Circle { length: own, .. }) => {
                    (length * length + own * own + dot(u, u)).half()
                }
                (Locus::OnBase { offset, .. } | Locus::OnPlate { offset, .. }, _) => {
                    offset.abs() + (dot(m, m) * dot(u, u)).sqrt()
                }
                _ => T::ZERO,
            }
        };
        let [s1, s2] = [m1, m2].map(|m| dot(m, m).sqrt());
        let most = (terms(1, m1) * s2 + terms(2, m2) * s1).to_f64();
        if let Locus::Circle { length, .. } = self.all[0] {
            let second = length * length * d * d;
            (dot(n, n) - second, most * most + second.to_f64())
        } else {
            let (m0, k0) = self.straight(&cut, 0);
            (m0[0] * n[0] + m0[1] * n[1] - k0 * d, most + (k0 * d).abs().to_f64())
        }
    }

    /// All poses, near which there is exactly one or, where two can't be told from none, at most two; `None` where the plate
    /// is not determined at all. Each is to be polished.
    pub(crate) fn poses(&self) -> Option<Vec<Pose<T>>> {
        let mut poses = Vec::new();
        if let Locus::Angle { direction } = self.all[2] {
            self.both(&mut poses, direction, [0, 1], f64::INFINITY);
            return (!poses.is_empty() || self.is_apart(direction)).then_some(poses);
        }
        let directions = sampled::<T>();
        let values = directions.map(|direction| self.closure(direction));
        let most = values.iter().map(|(_, size)| *size).fold(0.0, f64::max);
        let zeros = Trig::through(&values.map(|(value, _)| value), &directions).zeros(most)?;
        for direction in zeros {
            self.at(&mut poses, direction);
        }
        Some(poses)
    }

    /// Whether the first two conditions have no pose at a direction, rather than any number.
    fn is_apart(&self, direction: [T; 2]) -> bool {
        let cut = self.cut(direction);
        let (m, k) = self.straight(&cut, 1);
        let m_size = dot(m, m).sqrt().to_f64();
        match self.all[0] {
            Locus::Circle { .. } => m_size > 0.0 || k.abs().to_f64() > 0.0,
            _ => false,
        }
    }

    /// The poses at a direction that is a zero of the closure.
    fn at(&self, poses: &mut Vec<Pose<T>>, direction: [T; 2]) {
        let cut = self.cut(direction);
        let lines = [self.straight(&cut, 1), self.straight(&cut, 2)];
        let Locus::Circle { .. } = self.all[0] else {
            // Three lines through one point: from the two that cross at the greatest angle.
            let all = [self.straight(&cut, 0), lines[0], lines[1]];
            let angle = |[a, b]: [usize; 2]| cross(all[a].0, all[b].0).abs().to_f64();
            let best = [[0, 1], [0, 2], [1, 2]].into_iter().max_by(|a, b| angle(*a).total_cmp(&angle(*b)));
            if let Some([a, b]) = best {
                poses.push(self.pose(&cut, meet([all[a].0, all[b].0], [all[a].1, all[b].1])));
            }
            return;
        };
        let [(m1, k1), (m2, k2)] = lines;
        let d = cross(m1, m2);
        let [s1, s2] = [m1, m2].map(|m| dot(m, m).sqrt().to_f64());
        // Two legs of a parallelogram say the same of the place of the plate.
        let is_concentric = |leg: usize, distance: f64| {
            matches!(self.all[leg], Locus::Circle { .. }) && distance <= FLAT * self.size
        };
        let tells = d.abs().to_f64() > FLAT * s1 * s2;
        if tells && !is_concentric(1, s1) && !is_concentric(2, s2) {
            poses.push(self.pose(&cut, meet([m1, m2], [k1, k2])));
        } else {
            self.both(poses, direction, [0, 1], NEAR * self.size);
            self.both(poses, direction, [0, 2], NEAR * self.size);
        }
    }

    /// The poses at a direction at which two conditions hold and the third is missed by `near` at most, m.
    fn both(&self, poses: &mut Vec<Pose<T>>, direction: [T; 2], [one, other]: [usize; 2], near: f64) {
        let cut = self.cut(direction);
        for way in self.meeting(&cut, [one, other], false).into_iter().flatten() {
            let third = 3 - one - other;
            let miss = self.all[third].miss(plus(way, cut.offsets[third]), direction);
            if near.is_infinite() || miss.to_f64() <= near {
                poses.push(self.pose(&cut, way));
            }
        }
    }

    /// The ways of the reference leg at which two conditions hold. With `nearest`, circle and line that don't meet give the
    /// point of the circle that is nearest to the line.
    fn meeting(&self, cut: &Cut<T>, [one, other]: [usize; 2], nearest: bool) -> [Option<[T; 2]>; 2] {
        let (m, k) = self.straight(cut, other);
        let square = dot(m, m);
        if square.to_f64() <= 0.0 {
            return [None; 2];
        }
        let Locus::Circle { length, .. } = self.all[one] else {
            let (m0, k0) = self.straight(cut, one);
            let is_parallel = cross(m0, m).abs().to_f64() <= 1e-12 * square.to_f64().sqrt();
            return [(!is_parallel).then(|| meet([m0, m], [k0, k])), None];
        };
        let inverse = T::ONE / square;
        // The distance of the line is k / |m|.
        let part = length * length - k * k * inverse;
        let limit = 64.0 * T::EPSILON * self.size * self.size;
        if part.to_f64() < -limit {
            let toward = scaled(length / square.sqrt(), m);
            let toward = if k.to_f64() < 0.0 { opposite(toward) } else { toward };
            return [nearest.then_some(toward), None];
        }
        let foot = scaled(k * inverse, m);
        let across = scaled((part.clamp_negative() * inverse).sqrt(), perp(m));
        [Some(plus(foot, across)), Some(minus(foot, across))]
    }

    fn pose(&self, cut: &Cut<T>, way: [T; 2]) -> Pose<T> {
        let [at, on] = self.all[0].ends();
        Pose { origin: plus(at, minus(way, times(on, cut.direction))), direction: cut.direction }
    }

    /// The least sum of violations over all directions, m: by about so much a length must change to close the group.
    pub(crate) fn gap(&self) -> f64 {
        let at = |angle: f64| {
            let (s, c) = T::from_f64(angle).sin_cos();
            self.misses([c, s])
        };
        if let Locus::Angle { direction } = self.all[2] {
            return self.misses(direction);
        }
        let step = std::f64::consts::TAU / GAP_SAMPLES as f64;
        let best = (0..GAP_SAMPLES).map(|k| step * k as f64).min_by(|a, b| at(*a).total_cmp(&at(*b)));
        let best = best.unwrap_or(0.0);
        assur_number::search::least(best - step, best + step, 60, at).1
    }

    /// The least sum of violations at a direction, m.
    fn misses(&self, direction: [T; 2]) -> f64 {
        let cut = self.cut(direction);
        let mut least = f64::INFINITY;
        for pair in [[0, 1], [0, 2]] {
            for way in self.meeting(&cut, pair, true).into_iter().flatten() {
                let all =
                    (0..3).map(|leg| self.all[leg].miss(plus(way, cut.offsets[leg]), direction).to_f64());
                least = least.min(all.sum());
            }
        }
        least
    }
}
