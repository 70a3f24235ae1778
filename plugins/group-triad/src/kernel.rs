//! The kernel of both classes: places, derivatives and reactions from the lines of the legs.

use assur_group::plane::{minus, vector};
use assur_group::{
    AssurGroup, Body, BuildError, GroupError, GroupFrame, Mode, Order, PairGeometry, SeenPair, Wrench,
};
use assur_number::Real;

use crate::leg::{Leg, Line, Passed};
use crate::matrix::{Inverse, Matrix};
use crate::mover::{Freedom, Hub, Mover};
use crate::order;
use crate::parts::Parts;

/// Most steps of Newton's method from a pose near the wanted one.
const MOST_STEPS: usize = 12;

/// A second step of at most this part of the first shows that the root belongs to the start (Kantorovich: 1/2 would do for
/// exact steps), ...
const CONTRACTION: f64 = 0.25;

/// ... unless the first is below this, rad or parts of the size: both are then rounding.
const TINY: f64 = 1e-12;

/// A mode farther than this from the pose on entry, rad or parts of the size, is another one.
const FAR: f64 = 0.5;

/// Most steps towards a place where two modes meet: each halves the distance.
const MOST_STEPS_TO_MEETING: usize = 60;

/// A condition is satisfied up to so many units of the last place of the size.
const ROUNDINGS: f64 = 64.0;

/// Guides of one leg at a smaller sine than this are parallel.
const PARALLEL: f64 = 1e-12;

/// Most modes that are compared with a pose.
const MOST_MODES: usize = 12;

/// One group: a plate that legs hold against a base. In class III the base consists of the outer bodies, and the plate is
/// free; in class IV the base is a link of the group too, and base and plate have one freedom each.
#[derive(Debug, Clone)]
pub struct Legged<T> {
    frame: GroupFrame,
    pub(crate) legs: Vec<Leg<T>>,
    pub(crate) plate: Mover<T>,
    pub(crate) base: Option<Mover<T>>,
    /// Product of the sines of the guides of legs with two slides.
    spread: T,
    /// Violation of a condition that is rounding, m.
    rounding: f64,
}

/// The lines of all legs in one position, and what follows from them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lines<T> {
    each: [Line<T>; 3],
    plate: Hub<T>,
    base: Option<Hub<T>>,
    matrix: Matrix<T>,
}

/// A pose of base and plate: what decides the others.
pub(crate) type Core<T> = [Body<T>; 2];

impl<T: Real> Lines<T> {
    /// The greatest violation, m or rad.
    #[inline(always)]
    fn open(&self) -> f64 {
        let gaps = self.each.iter().map(|line| line.gap.abs().to_f64());
        gaps.fold(0.0, |most, gap| if gap <= most { most } else { gap })
    }
}

impl<T: Real> Legged<T> {
    pub(crate) fn new(parts: &Parts) -> Result<Self, BuildError> {
        let legs = parts
            .legs
            .iter()
            .map(|(link, outer, inner)| Leg::new(*link, outer, inner))
            .collect::<Result<Vec<_>, _>>()?;
        let anchor = legs.first().map_or([T::ZERO; 2], |leg: &Leg<T>| leg.ends()[0]);
        let size = |end: usize, from: [T; 2]| {
            let far = legs.iter().map(|leg| {
                let [x, y] = minus(leg.ends()[end], from);
                x.to_f64().hypot(y.to_f64())
            });
            let far = far.fold(0.0, f64::max);
            if far > 0.0 { far } else { parts.frame.scale }
        };
        let held = |outer: &Option<SeenPair>| outer.as_ref().map_or(anchor, |seen| vector(own_end(seen)));
        // One size for both links: what is taken of a determinant by it must not depend on the row.
        let own = size(0, held(&parts.plate_outer));
        let all = if parts.base.is_some() { own.max(size(1, held(&parts.base_outer))) } else { own };
        let plate = Mover::new(parts.plate, parts.plate_outer.as_ref(), anchor, all)?;
        let base = match parts.base {
            Some(base) => Some(Mover::new(base, parts.base_outer.as_ref(), anchor, all)?),
            None => None,
        };
        let spread = legs.iter().fold(T::ONE, |all, leg| all * leg.spread());
        let rounding = ROUNDINGS * T::EPSILON * parts.frame.scale.max(all);
        Ok(Self { frame: parts.frame.clone(), legs, plate, base, spread, rounding })
    }

    #[inline(always)]
    pub(crate) fn lines(&self, bodies: &[Body<T>]) -> Lines<T> {
        let plate = self.plate.hub(bodies);
        let base = self.base.as_ref().map(|base| base.hub(bodies));
        let mut lines = [Line::NONE; 3];
        let mut matrix = [[T::ZERO; 3]; 3];
        matrix[2][2] = T::ONE;
        for (k, leg) in self.legs.iter().enumerate() {
            lines[k] = leg.line(bodies);
            matrix[k] = self.row(&plate, base.as_ref(), &lines[k]);
        }
        Lines { each: lines, plate, base, matrix }
    }

    /// What a line of action does on all freedoms: on the plate, with the opposite on the base.
    #[inline(always)]
    fn row(&self, plate: &Hub<T>, base: Option<&Hub<T>>, line: &Line<T>) -> [T; 3] {
        let on_plate = self.plate.column(plate, line);
        match (&self.base, base) {
            (Some(mover), Some(hub)) => [-mover.column(hub, line)[0], on_plate[0], T::ZERO],
            _ => on_plate,
        }
    }

    /// The dimensionless determinant, with its sign: of the lines of three legs as unit vectors, or of the shares of two legs
    /// in the freedoms of both links.
    #[inline(always)]
    fn measure(&self, lines: &Lines<T>) -> T {
        let size = |mover: &Mover<T>| match mover.freedom {
            Freedom::Shift(_) => T::ONE,
            _ => mover.inverse_size,
        };
        let mut rows = lines.matrix;
        let mut squares = T::ONE;
        for (row, line) in rows.iter_mut().zip(&lines.each).take(self.legs.len()) {
            // A moment has no length: it is taken as it is.
            let is_force = line.moment.to_f64() < 0.5;
            if let Some(base) = &self.base {
                if is_force {
                    (row[0], row[1]) = (row[0] * size(base), row[1] * size(&self.plate));
                }
                squares = squares * (T::ONE + row[0] * row[0] + row[1] * row[1]);
            } else {
                if is_force {
                    row[2] = row[2] * self.plate.inverse_size;
                }
                squares = squares * (row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
            }
        }
        Inverse::determinant(&rows) * self.spread / squares.sqrt()
    }

    /// One step of Newton's method: its size, the sign of the determinant before it.
    #[inline(always)]
    fn step(&self, bodies: &mut [Body<T>]) -> f64 {
        let found = self.lines(bodies);
        let inverse = Inverse::of(&found.matrix);
        let by = inverse.solve(found.each.map(|line| -line.gap));
        let mut size;
        if let (Some(base), Some(hub)) = (&self.base, &found.base) {
            let (own, other) = ([by[0], T::ZERO, T::ZERO], [by[1], T::ZERO, T::ZERO]);
            size = base.size_of(own).max(self.plate.size_of(other));
            base.step(bodies, hub, own);
            self.plate.step(bodies, &found.plate, other);
        } else {
            size = self.plate.size_of(by);
            self.plate.step(bodies, &found.plate, by);
        }
        if by.iter().any(|part| part.to_f64().is_nan()) {
            size = f64::NAN;
        }
        size
    }

    /// Satisfies the outer pairs of base and plate.
    #[inline(always)]
    fn settle(&self, bodies: &mut [Body<T>]) {
        if let Some(base) = &self.base {
            base.settle(bodies);
        }
        self.plate.settle(bodies);
    }

    /// Newton's method from the pose of the bodies. Whether it converged, and whether the first two steps show that the root
    /// belongs to the start.
    #[inline(always)]
    pub(crate) fn polish(&self, bodies: &mut [Body<T>]) -> Polished {
        self.settle(bodies);
        let mut before = f64::INFINITY;
        let mut is_near = true;
        let mut way = 0.0;
        for step in 0..MOST_STEPS {
            let size = self.step(bodies);
            if size.is_nan() || size > 1e3 {
                return Polished { converged: false, is_near: false, way: f64::INFINITY };
            }
            way += size;
            if step == 1 {
                is_near = size <= CONTRACTION * before || before < TINY;
            }
            // Quadratic: the next step would be about size³ / before².
            let next = size * (size / before) * (size / before);
            if size <= 2.0 * T::EPSILON || step > 0 && next <= 0.1 * T::EPSILON {
                return Polished { converged: true, is_near, way };
            }
            if step > 2 && size >= 0.9 * before && size < 1e6 * T::EPSILON {
                return Polished { converged: true, is_near: false, way };
            }
            before = size;
        }
        Polished { converged: before < T::EPSILON.sqrt(), is_near: false, way }
    }

    fn core(&self, bodies: &[Body<T>]) -> Core<T> {
        let base = self.base.as_ref().map_or_else(Body::ground, |base| bodies[base.link]);
        [base, bodies[self.plate.link]]
    }

    fn put_core(&self, core: &Core<T>, bodies: &mut [Body<T>]) {
        if let Some(base) = &self.base {
            bodies[base.link] = core[0];
        }
        bodies[self.plate.link] = core[1];
    }

    /// Distance of two poses, rad or parts of the size.
    fn apart(&self, one: &Core<T>, other: &Core<T>) -> f64 {
        let size = |a: T, b: T| a.to_f64().hypot(b.to_f64());
        let movers = [self.base.as_ref(), Some(&self.plate)];
        let distance = |(k, mover): (usize, Option<&Mover<T>>)| {
            let Some(mover) = mover else { return 0.0 };
            let (a, b) = (&one[k], &other[k]);
            let [ha, hb] = [a, b].map(|body| match &mover.freedom {
                Freedom::Free(anchor) => body.point(*anchor),
                Freedom::Turn(pin) => body.point(pin.own),
                Freedom::Shift(slide) => body.point(slide.own),
            });
            let way = size(ha[0] - hb[0], ha[1] - hb[1]) * mover.inverse_size.to_f64();
            way.max(size(a.c - b.c, a.s - b.s))
        };
        movers.into_iter().enumerate().map(distance).fold(0.0, f64::max)
    }

    /// All poses of base and plate in which the group can be assembled; the bodies are changed.
    fn cores(&self, bodies: &mut [Body<T>]) -> Result<Cores<T>, GroupError> {
        let loci = self.loci(bodies);
        let Some(poses) = loci.poses() else { return Err(GroupError::Singular { health: 0.0 }) };
        let mut found = Cores { all: [[Body::ground(); 2]; MOST_MODES], health: [0.0; MOST_MODES], count: 0 };
        for pose in poses.each() {
            self.put_pose(pose, bodies);
            let raw = self.core(bodies);
            let polished = self.polish(bodies);
            if !polished.converged || polished.way > FAR || self.lines(bodies).open() > self.rounding {
                // Where two modes meet, Newton's method converges slowly, if at all.
                self.put_core(&raw, bodies);
                if !self.approach(bodies) {
                    continue;
                }
            }
            let lines = self.lines(bodies);
            let health = self.measure(&lines).to_f64();
            let core = self.core(bodies);
            let limit = (1e-4 * health.abs()).max(64.0 * T::EPSILON);
            let is_new = found.each().all(|(other, _)| self.apart(other, &core) > limit);
            if is_new && found.count < MOST_MODES {
                (found.all[found.count], found.health[found.count]) = (core, health);
                found.count += 1;
            }
        }
        if found.count == 0 {
            return Err(GroupError::NoAssembly { gap_m: loci.gap() });
        }
        Ok(found)
    }

    /// Goes to the pose with the least violations on the way of Newton's method; whether that closes the group. So it finds
    /// the place where two modes meet, to half of the digits.
    fn approach(&self, bodies: &mut [Body<T>]) -> bool {
        self.settle(bodies);
        let start = self.core(bodies);
        let mut best = (self.lines(bodies).open(), start);
        for _ in 0..MOST_STEPS_TO_MEETING {
            if self.step(bodies).is_nan() || self.apart(&start, &self.core(bodies)) > FAR {
                break;
            }
            let gap = self.lines(bodies).open();
            if gap < best.0 {
                best = (gap, self.core(bodies));
            }
        }
        self.put_core(&best.1, bodies);
        best.0 <= self.rounding
    }

    /// Places base and plate in the mode whose determinant has the sign of the way and which is nearest to their poses.
    #[cold]
    fn place_far(&self, bodies: &mut [Body<T>], start: &Core<T>, way: usize) -> Result<(), GroupError> {
        let found = self.cores(bodies)?;
        let resolution = (256.0 * T::EPSILON).sqrt();
        let fits = |health: f64| health.abs() <= resolution || (health > 0.0) == (way == 0);
        let nearest = found.each().filter(|(_, health)| fits(*health));
        let nearest =
            nearest.map(|(core, _)| (self.apart(core, start), core)).min_by(|a, b| a.0.total_cmp(&b.0));
        match nearest {
            Some((distance, core)) if distance <= FAR => {
                self.put_core(core, bodies);
                Ok(())
            }
            _ => Err(GroupError::NoAssembly { gap_m: self.loci(bodies).gap() }),
        }
    }

    /// Places base and plate.
    #[inline(always)]
    fn place_core(&self, bodies: &mut [Body<T>], way: usize) -> Result<(Lines<T>, T), GroupError> {
        if !self.spread.abs().at_least(PARALLEL) {
            return Err(GroupError::Singular { health: 0.0 });
        }
        let start = self.core(bodies);
        let polished = self.polish(bodies);
        if polished.converged && polished.is_near {
            let lines = self.lines(bodies);
            let health = self.measure(&lines);
            if (health.to_f64() > 0.0) == (way == 0) && lines.open() <= self.rounding {
                return Ok((lines, health));
            }
        }
        self.put_core(&start, bodies);
        self.place_far(bodies, &start, way)?;
        let lines = self.lines(bodies);
        let health = self.measure(&lines);
        if health.to_f64().is_nan() {
            return Err(GroupError::Singular { health: f64::NAN });
        }
        Ok((lines, health))
    }

    #[inline(always)]
    fn finish(&self, bodies: &mut [Body<T>]) {
        self.legs.iter().for_each(|leg| leg.put(bodies));
    }

    /// Sets PF1 or PF2 of base and plate for given rates of their freedoms.
    #[inline(always)]
    fn set(&self, bodies: &mut [Body<T>], lines: &Lines<T>, first: [T; 3], second: Option<[T; 3]>) {
        let parts = |u: [T; 3]| match self.base {
            Some(_) => ([u[0], T::ZERO, T::ZERO], [u[1], T::ZERO, T::ZERO]),
            None => ([T::ZERO; 3], u),
        };
        let (base, plate) = parts(first);
        let rates = second.map(parts);
        if let (Some(mover), Some(hub)) = (&self.base, &lines.base) {
            match rates {
                None => mover.set_first(bodies, hub, base),
                Some((rate, _)) => mover.set_second(bodies, hub, base, rate),
            }
        }
        match rates {
            None => self.plate.set_first(bodies, &lines.plate, plate),
            Some((_, rate)) => self.plate.set_second(bodies, &lines.plate, plate, rate),
        }
    }

    /// PF1 and PF2 at these lines.
    #[inline(always)]
    fn differentiate(
        &self,
        bodies: &mut [Body<T>],
        lines: &Lines<T>,
        (inverse, order): (&Inverse<T>, Order),
    ) -> Result<(), GroupError> {
        let zero = [T::ZERO; 3];
        self.set(bodies, lines, zero, None);
        let mut right = zero;
        for (k, leg) in self.legs.iter().enumerate() {
            right[k] = -leg.first(bodies, &lines.each[k]);
        }
        let first = inverse.solve(right);
        self.set(bodies, lines, first, None);
        self.legs.iter().for_each(|leg| leg.put_first(bodies));
        if order < Order::Second {
            return self.numbers(bodies, first, |leg| leg.x1 + leg.y1);
        }
        self.set(bodies, lines, first, Some(zero));
        for (k, leg) in self.legs.iter().enumerate() {
            right[k] = -leg.second(bodies, &lines.each[k]);
        }
        let second = inverse.solve(right);
        self.set(bodies, lines, first, Some(second));
        self.legs.iter().for_each(|leg| leg.put_second(bodies));
        self.numbers(bodies, first, |leg| leg.x1 + leg.y1)?;
        self.numbers(bodies, second, |leg| leg.x2 + leg.y2)
    }

    /// An error where a rate, or a number of a leg, is none.
    #[inline(always)]
    fn numbers(
        &self,
        bodies: &[Body<T>],
        rates: [T; 3],
        of: impl Fn(&Body<T>) -> T,
    ) -> Result<(), GroupError> {
        let start = rates[0] + rates[1] + rates[2];
        GroupError::if_nan(self.legs.iter().fold(start, |sum, leg| sum + of(&bodies[leg.link])))
    }

    /// An error where derivatives and reactions are not determined.
    #[inline(always)]
    fn determined(&self, lines: &Lines<T>) -> Result<Inverse<T>, GroupError> {
        let inverse = Inverse::of(&lines.matrix);
        GroupError::if_singular(self.measure(lines).abs())?;
        Ok(inverse)
    }

    /// The load on a ternary link about its hub, with what the legs pass to it.
    #[inline(always)]
    fn gathered(
        mover: &Mover<T>,
        hub: &Hub<T>,
        bodies: &[Body<T>],
        loads: &[Wrench<T>],
        more: impl Iterator<Item = ([T; 2], [T; 2], T)>,
    ) -> Wrench<T> {
        let load = &loads[mover.link];
        let mut sum = Wrench::ZERO;
        sum.add_at(minus(bodies[mover.link].origin(), hub.place), load.force(), load.m);
        for (at, force, moment) in more {
            sum.add_at(minus(at, hub.place), force, moment);
        }
        sum
    }
}

/// The result of an iteration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Polished {
    pub(crate) converged: bool,
    /// Whether the root belongs to the start.
    is_near: bool,
    /// Length of the way, rad or parts of the size.
    pub(crate) way: f64,
}

/// Poses of base and plate, with their determinants.
pub(crate) struct Cores<T> {
    all: [Core<T>; MOST_MODES],
    health: [f64; MOST_MODES],
    count: usize,
}

impl<T: Real> Cores<T> {
    fn each(&self) -> impl ExactSizeIterator<Item = (&Core<T>, f64)> {
        self.all[..self.count].iter().zip(self.health)
    }
}

/// The joint of a pair on its own link, m.
fn own_end(seen: &SeenPair) -> [f64; 2] {
    match seen.pair.geometry {
        PairGeometry::Pin { at_a, .. } => at_a,
        PairGeometry::Slide { point, .. } => point,
    }
}

impl<T: Real> AssurGroup<T> for Legged<T> {
    fn frame(&self) -> &GroupFrame {
        &self.frame
    }

    /// Of the modes with this sign of the determinant, the one nearest to the poses on entry.
    fn ways(&self) -> usize {
        2
    }

    fn place(&self, bodies: &mut [Body<T>], way: usize) -> Result<T, GroupError> {
        self.solve(bodies, way, Order::Place)
    }

    fn derive(&self, bodies: &mut [Body<T>], order: Order) -> Result<(), GroupError> {
        if order == Order::Place {
            return Ok(());
        }
        let lines = self.lines(bodies);
        let inverse = self.determined(&lines)?;
        self.differentiate(bodies, &lines, (&inverse, order))
    }

    fn solve(&self, bodies: &mut [Body<T>], way: usize, order: Order) -> Result<T, GroupError> {
        let (lines, health) = self.place_core(bodies, way)?;
        self.finish(bodies);
        self.numbers(bodies, [T::ZERO; 3], |leg| leg.x + leg.y)?;
        if order > Order::Place {
            let inverse = self.determined(&lines)?;
            self.differentiate(bodies, &lines, (&inverse, order))?;
        }
        Ok(health.abs())
    }

    fn health(&self, bodies: &[Body<T>]) -> f64 {
        let lines = self.lines(bodies);
        self.measure(&lines).abs().to_f64()
    }

    fn reactions(
        &self,
        bodies: &[Body<T>],
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
    ) -> Result<(), GroupError> {
        let lines = self.lines(bodies);
        let inverse = self.determined(&lines)?;
        let nothing = Passed { force: [T::ZERO; 2], at: [T::ZERO; 2], moment: T::ZERO };
        let mut passed = [nothing; 3];
        let mut right =
            self.plate.share(&lines.plate, bodies[self.plate.link].origin(), &loads[self.plate.link]);
        if let (Some(base), Some(hub)) = (&self.base, &lines.base) {
            let own = base.share(hub, bodies[base.link].origin(), &loads[base.link]);
            right = [own[0], right[0], T::ZERO];
        }
        for (k, leg) in self.legs.iter().enumerate() {
            let load = &loads[leg.link];
            passed[k] = leg.passed(bodies, &lines.each[k], load);
            let share = self.row(&lines.plate, lines.base.as_ref(), &passed[k].line());
            for (sum, part) in right.iter_mut().zip(share) {
                *sum += part;
            }
            if let (Some(base), Some(hub)) = (&self.base, &lines.base) {
                right[0] += base.share(hub, bodies[leg.link].origin(), load)[0];
            }
        }
        let sizes = inverse.solve_transposed(right.map(|part| -part));
        self.hand_on(bodies, (&lines, &passed, &sizes), loads, reactions);
        GroupError::if_nan(sizes[0] + sizes[1] + sizes[2])
    }

    fn lists_modes(&self) -> bool {
        true
    }

    fn modes(&self, bodies: &[Body<T>]) -> Result<Option<Vec<Mode<T>>>, GroupError> {
        self.listed(bodies).map(Some)
    }
}

impl<T: Real> Legged<T> {
    /// Stores all reactions for the forces along the lines, and hands the outer ones on.
    fn hand_on(
        &self,
        bodies: &[Body<T>],
        (lines, passed, sizes): (&Lines<T>, &[Passed<T>; 3], &[T; 3]),
        loads: &mut [Wrench<T>],
        reactions: &mut [Wrench<T>],
    ) {
        for (k, leg) in self.legs.iter().enumerate() {
            let load = loads[leg.link];
            let outer = leg.store(bodies, (&lines.each[k], &passed[k], sizes[k]), &load, reactions);
            let handed = if self.base.is_some() { None } else { Some(&mut *loads) };
            leg.store_outer(bodies, outer, handed, reactions);
        }
        let (Some(base), Some(hub)) = (&self.base, &lines.base) else { return };
        let along = |k: usize, sign: T| {
            let line = &lines.each[k];
            let size = sign * sizes[k];
            (line.at, [size * line.f[0], size * line.f[1]], size * line.moment)
        };
        let beside = |k: usize, sign: T| {
            let Passed { force, at, moment } = passed[k];
            (at, [sign * force[0], sign * force[1]], sign * moment)
        };
        let count = self.legs.len();
        let on_plate = (0..count).flat_map(|k| [along(k, T::ONE), beside(k, T::ONE)]);
        let plate = Self::gathered(&self.plate, &lines.plate, bodies, loads, on_plate);
        let own = |k: usize| {
            let load = &loads[self.legs[k].link];
            (bodies[self.legs[k].link].origin(), load.force(), load.m)
        };
        let on_base = (0..count).flat_map(|k| [along(k, -T::ONE), beside(k, -T::ONE), own(k)]);
        let based = Self::gathered(base, hub, bodies, loads, on_base);
        self.plate.hold(bodies, &lines.plate, &plate, loads, reactions);
        base.hold(bodies, hub, &based, loads, reactions);
    }

    /// All modes in their order.
    fn listed(&self, bodies: &[Body<T>]) -> Result<Vec<Mode<T>>, GroupError> {
        let mut bodies = bodies.to_vec();
        let found = self.cores(&mut bodies)?;
        let mut modes = Vec::new();
        for (core, health) in found.each() {
            self.put_core(core, &mut bodies);
            self.finish(&mut bodies);
            let own = self.frame.links.iter().map(|&link| bodies[link]).collect();
            let way = usize::from(health <= 0.0);
            modes.push((order::key(self, &bodies), Mode { bodies: own, way, health: health.abs() }));
        }
        order::sort(&mut modes);
        Ok(modes.into_iter().map(|(_, mode)| mode).collect())
    }
}
