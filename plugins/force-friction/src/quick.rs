//! The solution where the certificate proves that there is one, block by block and for any number: eight positions at once too.
//!
//! It keeps to small fixed memory. What it can't treat (a certificate of 1 or more, groups that are solved together, a
//! balancing load elsewhere) is left to [`Chain`](crate::chain::Chain).

use assur_force::{Bearing, Block, FrictionForces, Frictions, Reactions, Unknown, UnknownKind, drive};
use assur_friction::{Sum, Unique};
use assur_group::{AssurGroup, Body, Number, Wrench};
use assur_kinematics::Linkage;
use assur_number::Real;

/// A determinant of the linear part below this is zero.
const SINGULAR: f64 = 1e-14;

/// A mechanism at a position, or eight.
#[derive(Clone, Copy)]
pub(crate) struct Quick<'a, T: Real> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) groups: &'a [Box<dyn AssurGroup<T>>],
    pub(crate) bodies: &'a [Body<T>],
}

/// What presses in a bearing: two parts of its unknown, and the normal force of a slide.
type Pressing<T> = [T; 3];

/// Response matrix of the pressing forces in each of N bearings. Its C = 1 + 2 N columns are the ideal load, a unit friction
/// magnitude in each bearing, and a unit normal force in each bearing whose friction has a moment; one column more are the inertia
/// loads of a motion whose acceleration is looked for.
pub(crate) struct Table<T, const N: usize, const C: usize> {
    rows: [[Pressing<T>; C]; N],
    /// Loads of the drive, where the input link is one of the stages.
    pub(crate) drives: [T; C],
}

/// A bearing, with the first of what its friction depends on, and its sense times its coefficient.
#[derive(Clone, Copy)]
struct Rubbing<'a, T> {
    bearing: &'a Bearing,
    unknown: &'a Unknown,
    factor: T,
    /// Whether its friction has a moment that is linear in the normal force.
    is_shifted: bool,
}

/// The bearings of a block, at most N.
pub(crate) struct Bearings<'a, T, const N: usize> {
    count: usize,
    all: [Rubbing<'a, T>; N],
}

impl<'a, T: Real, const N: usize> Bearings<'a, T, N> {
    /// `None` of a block without friction.
    #[inline(always)]
    pub(crate) fn of(frictions: &'a Frictions, senses: &[T], block: &Block) -> Option<Self> {
        let read = |unknown: usize| {
            let unknown = &frictions.unknowns[unknown];
            let bearing = &frictions.bearings[unknown.bearing];
            let factor = senses[unknown.bearing] * T::from_f64(bearing.coefficient);
            Rubbing { bearing, unknown, factor, is_shifted: bearing.is_shifted() }
        };
        let mut all = [read(*block.firsts.first()?); N];
        for (one, unknown) in all.iter_mut().zip(&block.firsts) {
            *one = read(*unknown);
        }
        Some(Self { count: block.firsts.len().min(N), all })
    }

    #[inline(always)]
    fn each(&self) -> &[Rubbing<'a, T>] {
        &self.all[..self.count]
    }

    /// The bearings whose friction has a moment that is linear in the normal force.
    #[inline(always)]
    fn shifted(&self) -> impl Iterator<Item = usize> {
        (0..self.count).filter(|index| self.all[*index].is_shifted)
    }
}

impl<T: Real> Rubbing<'_, T> {
    /// Adds the load of a sum of magnitudes of this size, or of a normal force.
    #[inline(always)]
    fn load(&self, is_normal: bool, size: T, bodies: &[Body<T>], loads: &mut [Wrench<T>]) {
        let kind = if is_normal { UnknownKind::Shift } else { self.unknown.kind };
        kind.load(self.bearing, bodies, self.factor * size, loads);
    }
}

impl<T: Number> Quick<'_, T> {
    /// Finds reactions and friction; `None`, with loads and results in any state, where it can't.
    pub(crate) fn solve(&self, loads: &mut [Wrench<T>], out: &mut Reactions<T>) -> Option<()> {
        T::evaluate(
            #[inline(always)]
            move || self.blocks(loads, out),
        )
    }

    #[inline(always)]
    fn blocks(&self, loads: &mut [Wrench<T>], out: &mut Reactions<T>) -> Option<()> {
        let frictions = out.friction.as_ref()?.frictions.clone();
        if out.unit.is_some() {
            return None;
        }
        out.pairs.fill(Wrench::ZERO);
        for block in &frictions.blocks {
            let [stage] = block.stages[..] else { return None };
            match block.firsts.len() {
                0 => {}
                1 => self.block::<1, 3>(&frictions, block, loads, out)?,
                2..=3 => self.block::<3, 7>(&frictions, block, loads, out)?,
                4..=6 => self.block::<6, 13>(&frictions, block, loads, out)?,
                _ => return None,
            }
            let drive = self.respond(stage, &out.solved, loads, &mut out.pairs)?;
            out.balancing = if stage == 0 { drive } else { out.balancing };
        }
        let Reactions { friction: Some(friction), pairs, .. } = out else { return None };
        self.tell(friction, pairs);
        Some(())
    }

    /// Finds the reactions of a stage; the load of the drive where it is the input link.
    #[inline(always)]
    pub(crate) fn respond(
        &self,
        stage: usize,
        solved: &[bool],
        loads: &mut [Wrench<T>],
        pairs: &mut [Wrench<T>],
    ) -> Option<T> {
        let Some(group) = stage.checked_sub(1) else {
            return Some(drive(self.linkage, self.bodies, loads, pairs));
        };
        if solved[group] {
            self.groups[group].reactions(self.bodies, loads, pairs).ok()?;
        }
        Some(T::ZERO)
    }

    #[inline(always)]
    fn links(&self, stage: usize) -> impl Iterator<Item = usize> {
        let placed = self.linkage.mechanism.input.placed().filter(move |_| stage == 0);
        let group = stage.checked_sub(1).map(|group| &self.linkage.structure.groups[group].frame.links);
        placed.chain(group.into_iter().flatten().copied())
    }

    /// Solves the friction of a block and adds it to the loads.
    #[inline(always)]
    fn block<const N: usize, const C: usize>(
        &self,
        frictions: &Frictions,
        block: &Block,
        loads: &mut [Wrench<T>],
        out: &mut Reactions<T>,
    ) -> Option<()> {
        let bearings = Bearings::of(frictions, &out.friction.as_ref()?.senses, block)?;
        let mut table: Table<T, N, C> = self.table(&bearings, &block.stages, [loads, &[]], out)?;
        table.without_normals(&bearings)?;
        let FrictionForces { forces, certificates, are_certificates_wanted, .. } = out.friction.as_mut()?;
        let (radius, sums) = table.equations(&bearings).solve(*are_certificates_wanted)?;
        for group in block.groups() {
            certificates[group] = radius.unwrap_or(T::from_f64(f64::NAN));
        }
        self.rub(&bearings, &table, &sums, forces, loads);
        Some(())
    }

    /// Writes the friction of bearings from the sums of their magnitudes, and adds it to the loads.
    #[inline(always)]
    pub(crate) fn rub<const N: usize, const C: usize>(
        &self,
        bearings: &Bearings<'_, T, N>,
        table: &Table<T, N, C>,
        sums: &[T; N],
        forces: &mut [T],
        loads: &mut [Wrench<T>],
    ) {
        for ((one, z), row) in bearings.each().iter().zip(sums).zip(&table.rows) {
            forces[one.unknown.bearing] =
                one.factor * T::from_f64(one.unknown.share(one.bearing)) * *z + T::ZERO;
            one.load(false, *z, self.bodies, loads);
            if one.is_shifted {
                let normal = row[1..=N].iter().zip(sums).fold(row[0][2], |sum, (by, z)| sum + by[2] * *z);
                one.load(true, normal, self.bodies, loads);
            }
        }
    }

    /// Puts a unit of each magnitude of friction, then of each normal force of a shifted face, on the links of a set of its own.
    #[inline(always)]
    fn load_units<'s, const N: usize>(
        &self,
        bearings: &Bearings<'_, T, N>,
        mut sets: impl Iterator<Item = &'s mut [Wrench<T>]>,
    ) where
        T: 's,
    {
        for is_normal in [false, true] {
            let units = bearings.each().iter().filter(|one| one.is_shifted || !is_normal);
            for (one, set) in units.zip(sets.by_ref()) {
                one.load(is_normal, T::ONE, self.bodies, set);
            }
        }
    }

    /// The response of stages to their loads, to the friction of each unknown, and to inertia loads (none where these are empty).
    #[inline(always)]
    pub(crate) fn table<const N: usize, const C: usize>(
        &self,
        bearings: &Bearings<'_, T, N>,
        stages: &[usize],
        [loads, inertia]: [&[Wrench<T>]; 2],
        out: &mut Reactions<T>,
    ) -> Option<Table<T, N, C>> {
        let Reactions { pairs, solved, scratch_pairs, scratch_bodies, .. } = out;
        let (links, count) = (loads.len(), pairs.len());
        let shifted = bearings.shifted().count();
        let sets = 1 + bearings.count + shifted + usize::from(!inertia.is_empty());
        scratch_bodies.resize(scratch_bodies.len().max(sets * links), Wrench::ZERO);
        scratch_pairs.resize(scratch_pairs.len().max(sets * count), Wrench::ZERO);
        let (own, found) = (&mut scratch_bodies[..sets * links], &mut scratch_pairs[..sets * count]);
        // A stage reads the loads of its own links only; a joint may have reactions that are known before.
        for link in stages.iter().flat_map(|stage| self.links(*stage)) {
            own.iter_mut().skip(link).step_by(links).for_each(|load| *load = Wrench::ZERO);
            if let Some(load) = inertia.get(link) {
                own[(sets - 1) * links + link] = *load;
            }
            own[link] = loads[link];
        }
        for &(pair, _) in bearings.each().iter().flat_map(|one| &one.unknown.pairs) {
            found.iter_mut().skip(pair).step_by(count).for_each(|reaction| *reaction = Wrench::ZERO);
            found[pair] = pairs[pair];
        }
        self.load_units(bearings, own.chunks_exact_mut(links).skip(1));
        // The normal forces have their columns behind those of all sums.
        let last = if inertia.is_empty() { C } else { bearings.count + shifted };
        let columns = || {
            (0..=bearings.count)
                .chain(1 + N..)
                .enumerate()
                .map(|(set, at)| if set > last { C - 1 } else { at })
        };
        let mut table = Table { rows: [[[T::ZERO; 3]; C]; N], drives: [T::ZERO; C] };
        for &stage in stages {
            match stage.checked_sub(1) {
                Some(group) if !solved[group] => {}
                Some(group) => self.groups[group].reactions_under(self.bodies, own, found, sets).ok()?,
                None => {
                    let each = own.chunks_exact_mut(links).zip(found.chunks_exact_mut(count));
                    for (column, (own, found)) in columns().zip(each) {
                        table.drives[column] = self.respond(stage, solved, own, found)?;
                    }
                }
            }
        }
        for (row, one) in table.rows.iter_mut().zip(bearings.each()) {
            let pressing = one.unknown.pressing(one.bearing, self.bodies);
            for (column, found) in columns().zip(found.chunks_exact(count)) {
                let ([one, other], normal) = pressing.of(&one.unknown.load_on(found));
                row[column] = [one, other, normal];
            }
        }
        Some(table)
    }

    /// Adds friction to the reactions in its pairs.
    #[inline(always)]
    pub(crate) fn tell(&self, friction: &FrictionForces<T>, pairs: &mut [Wrench<T>]) {
        let FrictionForces { frictions, senses, forces, .. } = friction;
        for unknown in frictions.unknowns.iter().filter(|unknown| unknown.kind == UnknownKind::Shift) {
            let bearing = &frictions.bearings[unknown.bearing];
            let [normal, _] = unknown.vector(bearing, self.bodies, pairs);
            let factor = senses[unknown.bearing] * T::from_f64(bearing.coefficient * unknown.moment(bearing));
            for &(pair, sign) in &bearing.path {
                pairs[pair].m += T::from_f64(sign) * factor * normal;
            }
        }
        for (bearing, force) in frictions.bearings.iter().zip(forces) {
            let along = bearing.slides().then(|| bearing.along(self.bodies));
            for &(pair, sign) in &bearing.path {
                let force = T::from_f64(sign) * *force;
                match along {
                    None => pairs[pair].m += force,
                    Some([x, y]) => {
                        pairs[pair].fx += force * x;
                        pairs[pair].fy += force * y;
                    }
                }
            }
        }
    }
}

impl<T: Real, const N: usize, const C: usize> Table<T, N, C> {
    /// Adds to each response that of the inertia loads of the acceleration with which the drive gives what is known of it: the
    /// accelerations replace the loads of the drive. `None` where there is no inertia.
    #[inline(always)]
    pub(crate) fn accelerate(&mut self, drive: T, drive_inertia: T) -> Option<()> {
        let inertia = self.drives[C - 1] + drive_inertia;
        let of_unit = self.rows.map(|row| row[C - 1]);
        for column in 0..C - 1 {
            // The base moves under the drive, what friction adds without it.
            let given = if column == 0 { drive } else { T::ZERO };
            let acceleration = (given - self.drives[column]) / inertia;
            self.drives[column] = acceleration;
            for (row, by) in self.rows.iter_mut().zip(&of_unit) {
                row[column].iter_mut().zip(by).for_each(|(entry, by)| *entry += *by * acceleration);
            }
        }
        inertia.abs().exceeds(0.0).then_some(())
    }

    /// The load of the drive, or the acceleration, with these sums of magnitudes.
    #[inline(always)]
    pub(crate) fn drive(&self, sums: &[T; N]) -> T {
        self.drives[1..=N].iter().zip(sums).fold(self.drives[0], |sum, (by, z)| sum + *by * *z)
    }

    /// Expresses the normal forces by the sums of magnitudes; `None` where these determine none.
    #[inline(always)]
    pub(crate) fn without_normals(&mut self, bearings: &Bearings<'_, T, N>) -> Option<()> {
        for (nth, own) in bearings.shifted().enumerate() {
            let column = 1 + N + nth;
            let left = T::ONE - self.rows[own][column][2];
            if !left.abs().at_least(SINGULAR) {
                return None;
            }
            let inverse = T::ONE / left;
            let gains: [T; C] = std::array::from_fn(|c| self.rows[own][c][2] * inverse);
            if C > 1 + 2 * N {
                let by = std::mem::replace(&mut self.drives[column], T::ZERO);
                self.drives.iter_mut().zip(gains).for_each(|(drive, gain)| *drive += by * gain);
                self.drives[column] = T::ZERO;
            }
            for row in &mut self.rows {
                let by = row[column];
                row[column] = [T::ZERO; 3];
                for (c, (entry, gain)) in row.iter_mut().zip(gains).enumerate() {
                    if c != column {
                        entry.iter_mut().zip(by).for_each(|(entry, by)| *entry += by * gain);
                    }
                }
            }
        }
        Some(())
    }

    /// The equations of the sums of magnitudes.
    #[inline(always)]
    pub(crate) fn equations(&self, bearings: &Bearings<'_, T, N>) -> Unique<T, N> {
        let mut equations = [Sum::NONE; N];
        for ((sum, row), one) in equations.iter_mut().zip(&self.rows).zip(bearings.each()) {
            sum.is_vector = !one.bearing.slides();
            sum.constant = [row[0][0], row[0][1]];
            for (slope, by) in sum.slopes.iter_mut().zip(&row[1..]) {
                *slope = [by[0], by[1]];
            }
        }
        Unique(equations)
    }
}
