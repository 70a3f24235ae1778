//! The solution where the certificate proves that there is one, block by block and for any number: eight positions at once too.
//!
//! It keeps to small fixed memory. What it can't treat (a certificate of 1 or more, groups that are solved together, a
//! balancing load elsewhere) is left to [`Chain`](crate::chain::Chain).

use assur_force::{Block, Reactions, Rubbing, Unknown, UnknownKind, input_link};
use assur_friction::{MOST, Unique, Vector};
use assur_group::{AssurGroup, Body, Number, Wrench};
use assur_kinematics::Linkage;
use assur_number::Real;

/// Most columns of what answers the loads: those without friction, sums of moduli, and normal forces.
const COLUMNS: usize = 1 + MOST[0] + MOST[2];

/// Most rows: vectors whose moduli count, and normal forces.
const ROWS: usize = MOST[1] + MOST[2];

/// A determinant of the linear part below this is zero.
const SINGULAR: f64 = 1e-14;

/// A mechanism at a position, or eight.
pub(crate) struct Quick<'a, T: Real> {
    pub(crate) linkage: &'a Linkage,
    pub(crate) groups: &'a [Box<dyn AssurGroup<T>>],
    pub(crate) bodies: &'a [Body<T>],
}

/// What is unknown in a block: sums of moduli by rub, then normal forces.
struct Columns {
    of: [usize; COLUMNS],
    sums: usize,
    count: usize,
}

impl Columns {
    /// The columns of a block; `None` where there are too many.
    fn of(block: &Block, unknowns: &[Unknown]) -> Option<Self> {
        let mut found = Self { of: [0; COLUMNS], sums: 0, count: 1 };
        for modulus in [true, false] {
            for &unknown in block.unknowns.iter().filter(|one| unknowns[**one].is_modulus() == modulus) {
                let again = found.count > 1 && {
                    let last = &unknowns[found.of[found.count - 1]];
                    last.rub == unknowns[unknown].rub && modulus && last.is_modulus()
                };
                if !again {
                    *found.of.get_mut(found.count)? = unknown;
                    found.count += 1;
                }
            }
            if modulus {
                found.sums = found.count - 1;
            }
        }
        (found.sums <= MOST[0]).then_some(found)
    }
}

/// For each unknown of a block, as rows, the vector by each column.
type Table<T> = [[[T; 2]; COLUMNS]; ROWS];

impl<T: Number> Quick<'_, T> {
    /// Finds reactions and friction; `None`, with loads and results in any state, where it can't.
    pub(crate) fn solve(&self, loads: &mut [Wrench<T>], out: &mut Reactions<T>) -> Option<()> {
        let frictions = out.rubbing.as_ref()?.frictions.clone();
        if out.unit.is_some() {
            return None;
        }
        out.pairs.fill(Wrench::ZERO);
        for block in &frictions.blocks {
            let [stage] = block.stages[..] else { return None };
            if block.unknowns.is_empty() {
                let drive = self.respond(stage, &out.solved, loads, &mut out.pairs)?;
                out.balancing = if stage == 0 { drive } else { out.balancing };
            } else {
                self.block(block, stage, loads, out)?;
            }
        }
        let Reactions { rubbing: Some(rubbing), pairs, .. } = out else { return None };
        self.tell(rubbing, pairs);
        Some(())
    }

    /// Finds the reactions of a stage; the load of the drive where it is the input link.
    #[inline]
    fn respond(
        &self,
        stage: usize,
        solved: &[bool],
        loads: &mut [Wrench<T>],
        pairs: &mut [Wrench<T>],
    ) -> Option<T> {
        match stage.checked_sub(1) {
            None => {
                let (pair, input) =
                    (&self.linkage.structure.pairs[0].pair, self.linkage.mechanism.input.link);
                let drive;
                (pairs[0], drive) = input_link(pair, input, self.bodies, loads);
                Some(drive)
            }
            Some(group) => {
                if solved[group] {
                    self.groups[group].reactions(self.bodies, loads, pairs).ok()?;
                }
                Some(T::ZERO)
            }
        }
    }

    /// Solves a block of one stage and adds its friction to the loads.
    fn block(
        &self,
        block: &Block,
        stage: usize,
        loads: &mut [Wrench<T>],
        out: &mut Reactions<T>,
    ) -> Option<()> {
        let Reactions { rubbing: Some(rubbing), pairs, solved, scratch_pairs, scratch_bodies, .. } = out
        else {
            return None;
        };
        let Rubbing { frictions, senses, forces, certificates, .. } = rubbing;
        let columns = Columns::of(block, &frictions.unknowns)?;
        let factor = |column: usize| {
            let rub = frictions.unknowns[columns.of[column]].rub;
            senses[rub] * T::from_f64(frictions.rubs[rub].coefficient)
        };
        let load = |column: usize, size: T, loads: &mut [Wrench<T>]| {
            let unknown = &frictions.unknowns[columns.of[column]];
            unknown.load(&frictions.rubs[unknown.rub], self.bodies, factor(column) * size, loads);
        };
        let mut table: Table<T> = [[[T::ZERO; 2]; COLUMNS]; ROWS];
        for column in 0..columns.count {
            if column == 0 {
                scratch_bodies.copy_from_slice(loads);
                scratch_pairs.copy_from_slice(pairs);
            } else {
                scratch_bodies.fill(Wrench::ZERO);
                scratch_pairs.fill(Wrench::ZERO);
                load(column, T::ONE, scratch_bodies);
            }
            self.respond(stage, solved, scratch_bodies, scratch_pairs)?;
            for (row, &unknown) in block.unknowns.iter().enumerate() {
                let unknown = &frictions.unknowns[unknown];
                let rub = &frictions.rubs[unknown.rub];
                table.get_mut(row)?[column] = unknown.vector(rub, self.bodies, scratch_pairs);
            }
        }
        columns.without_normals(block, &mut table)?;
        let mut equations = Unique::new(columns.sums);
        for (row, &unknown) in table.iter().zip(&block.unknowns) {
            let unknown = &frictions.unknowns[unknown];
            if unknown.is_modulus() {
                let of =
                    (1..=columns.sums).find(|c| frictions.unknowns[columns.of[*c]].rub == unknown.rub)?;
                let slopes = std::array::from_fn(|k| row[k + 1]);
                equations.push(Vector { unknown: of - 1, constant: row[0], slopes });
            }
        }
        let (radius, z) = equations.solve()?;
        if let Some(group) = stage.checked_sub(1) {
            certificates[group] = radius;
        }
        for column in 1..columns.count {
            let (index, rub) = (column - 1, frictions.unknowns[columns.of[column]].rub);
            let size = if index < columns.sums {
                let share = frictions.unknowns[columns.of[column]].share(&frictions.rubs[rub]);
                forces[rub] = factor(column) * T::from_f64(share) * z[index] + T::ZERO;
                z[index]
            } else {
                let row = &table[block.unknowns.iter().position(|one| *one == columns.of[column])?];
                (1..=columns.sums).fold(row[0][0], |sum, k| sum + row[k][0] * z[k - 1])
            };
            load(column, size, loads);
        }
        let drive = self.respond(stage, solved, loads, pairs)?;
        out.balancing = if stage == 0 { drive } else { out.balancing };
        Some(())
    }

    /// Adds friction to the reactions in its pairs.
    fn tell(&self, rubbing: &Rubbing<T>, pairs: &mut [Wrench<T>]) {
        let Rubbing { frictions, senses, forces, .. } = rubbing;
        for unknown in frictions.unknowns.iter().filter(|unknown| unknown.kind == UnknownKind::Shift) {
            let rub = &frictions.rubs[unknown.rub];
            let [normal, _] = unknown.vector(rub, self.bodies, pairs);
            let factor = senses[unknown.rub] * T::from_f64(rub.coefficient * unknown.moment(rub));
            for &(pair, sign) in &rub.path {
                pairs[pair].m += T::from_f64(sign) * factor * normal;
            }
        }
        for (rub, force) in frictions.rubs.iter().zip(forces) {
            let along = rub.slides().then(|| rub.along(self.bodies));
            for &(pair, sign) in &rub.path {
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

impl Columns {
    /// Expresses the normal forces by the sums of moduli; `None` where these determine none.
    fn without_normals<T: Real>(&self, block: &Block, table: &mut Table<T>) -> Option<()> {
        for column in self.sums + 1..self.count {
            let own = block.unknowns.iter().position(|one| *one == self.of[column])?;
            let left = T::ONE - table[own][column][0];
            if !left.abs().at_least(SINGULAR) {
                return None;
            }
            let gains: [T; COLUMNS] =
                std::array::from_fn(|c| if c == column { T::ZERO } else { table[own][c][0] / left });
            for row in &mut table[..block.unknowns.len()] {
                let by = row[column];
                for (entry, gain) in row[..self.count].iter_mut().zip(gains) {
                    entry[0] += by[0] * gain;
                    entry[1] += by[1] * gain;
                }
                row[column] = [T::ZERO; 2];
            }
            for (entry, gain) in table[own].iter_mut().zip(gains) {
                entry[0] = gain;
            }
        }
        Some(())
    }
}
