//! Dry friction of this position: the iteration of the textbooks, and the loads to which it leads.

use assur_force::{Bearing, FrictionIteration, Kinetostatics, Loads, UnknownKind};
use assur_group::plane::{dot, length, minus, perp};
use assur_kinematics::Position;
use assur_mechanism::{GROUND, Mechanism, PairId, Surfaces};
use assur_words::{Text, joined, number, quantity, text};
use assur_worksheet::{Expr, Symbol};

use crate::Work;

/// A component of a unit vector that is this small is rounding.
const AXIS: f64 = 1e-15;

impl Work<'_> {
    /// Writes how friction is found by a method and adds it to the loads on the links; whether there is a solution.
    pub(crate) fn friction(&mut self, loads: &Loads, analyzer: Option<&str>, position: &Position) -> bool {
        let Some(frictions) = loads.frictions() else { return true };
        let Ok(plugin) = assur_force::choose(analyzer, true, !self.linkage.structure.passive.is_empty())
        else {
            return true;
        };
        let carrying = vec![true; self.linkage.groups().len()];
        let mut forces = Kinetostatics::new(self.linkage, loads, plugin.instance, &carrying);
        let solved = forces.solve(&self.state, position).is_ok();
        self.sheet.section(text!("working-friction-in-pairs"));
        self.sheet.note(text!("working-friction-text"));
        let known =
            forces.reactions.friction.iter().all(|found| found.forces.iter().all(|force| force.is_finite()));
        if solved && !known {
            // At rest in a motion friction is not determined.
            return false;
        }
        for found in forces.iteration(&self.state, position) {
            self.iteration(&found, &frictions.bearings, |index| {
                let unknown = &frictions.unknowns[index];
                (unknown.bearing, unknown.kind)
            });
        }
        let (true, Some(friction)) = (solved, &forces.reactions.friction) else { return false };
        for ((bearing, force), sense) in frictions.bearings.iter().zip(&friction.forces).zip(&friction.senses)
        {
            let on_link = bearing.path.iter().fold([0.0; 2], |[x, y], (pair, sign)| {
                let one = &forces.reactions.pairs[*pair];
                [x + sign * one.fx, y + sign * one.fy]
            });
            let normal = if bearing.slides() { dot(on_link, perp(bearing.along(self.bodies))) } else { 0.0 };
            let pressing = if bearing.slides() { normal.abs() } else { length(on_link) };
            self.friction_loads(bearing, (*force, pressing), -sense * bearing.coefficient * normal);
        }
        true
    }

    /// Writes the magnitudes of a block, step by step.
    fn iteration(
        &mut self,
        found: &FrictionIteration,
        bearings: &[Bearing],
        unknown: impl Fn(usize) -> (usize, UnknownKind),
    ) {
        let mechanism = &self.linkage.mechanism;
        let moduli = |z: &[f64]| {
            let each = found.unknowns.iter().zip(z).map(|(index, z)| {
                let (bearing, kind) = unknown(*index);
                text!(
                    "working-friction-modulus",
                    name = modulus(mechanism, &bearings[bearing], kind),
                    value = quantity(format_args!("{z:.6}"), "N")
                )
            });
            joined("; ", each)
        };
        let radius = number(format_args!("{:.6}", found.radius));
        let proved = found.radius < 1.0;
        let id = if proved { "working-friction-block" } else { "working-friction-block-not-proved" };
        self.sheet.note(text!(id, what = &found.what, radius));
        for (step, z) in found.steps.iter().enumerate() {
            let moduli = moduli(z);
            self.sheet.note(text!("working-friction-step", step, moduli));
        }
        if let Some(z) = &found.solution {
            let moduli = moduli(z);
            self.sheet.note(text!("working-friction-newton", moduli));
        }
    }

    /// Writes the friction of a pair, of this value: f r R of a pin, f N of a slide; `pressing`: R or N.
    fn friction_of(&mut self, bearing: &Bearing, of: &Text, (value, pressing): (f64, f64)) -> Expr {
        /// Of a pair that is at rest friction is what holds it, not what the formula gives.
        const SAME: f64 = 1e-9;
        let tag = Symbol::from(of.clone()).of(self.sheet.body_name(bearing.link));
        let (letter, unit) = if bearing.slides() { ("F", "N") } else { ("M", "N·m") };
        let symbol = Symbol::from(letter).of("f").of(tag.clone());
        let coefficient = bearing.coefficient;
        let (radius, pressing, what) = match bearing.surfaces {
            Surfaces::Journal { radius, .. } => (radius, pressing, "working-friction-reaction"),
            Surfaces::Place => (1.0, pressing, "working-friction-pressing"),
            Surfaces::Faces { .. } => (1.0, value.abs() / coefficient, "working-friction-pressing-ends"),
        };
        let by_formula = coefficient * radius * pressing;
        let is_same = (by_formula - value.abs()).abs() <= SAME * value.abs();
        if !is_same {
            return self.sheet.given(symbol, value, unit, text!("working-friction-of", pair = of));
        }
        let f = Symbol::from("f").of(of.clone());
        let f = self.sheet.given(f, coefficient, "", text!("working-friction"));
        let what = Text::message(what, vec![("pair", of.clone())]);
        let size = if bearing.slides() {
            let normal = self.sheet.given(Symbol::from("N").of(tag), pressing, "N", what);
            f * normal
        } else {
            let r = Symbol::from("r").of(of.clone());
            let r = self.sheet.given(r, radius, "m", text!("working-radius"));
            let circle = self.sheet.work(Symbol::from("ρ").of(of.clone()), &(f * r), "m");
            let reaction = self.sheet.given(Symbol::from("R").of(tag), pressing, "N", what);
            circle * reaction
        };
        self.sheet.work(symbol, &if value < 0.0 { -size } else { size }, unit)
    }

    /// Adds the friction of a pair to the loads of its links; `lever`: of faces offset from the guide line, the force that has the
    /// moment, N.
    fn friction_loads(&mut self, bearing: &Bearing, (force, pressing): (f64, f64), lever: f64) {
        let mechanism = &self.linkage.mechanism;
        let of = Text::from(mechanism.pair_name(bearing.pair));
        if force == 0.0 {
            return;
        }
        let size = self.friction_of(bearing, &of, (force, pressing));
        if !bearing.slides() {
            let moment = size;
            self.turn(bearing.link, moment.clone());
            self.turn(bearing.on, -moment);
            return;
        }
        let PairId::Slide(slide) = bearing.pair else { return };
        let place = self.bodies[bearing.link].point(mechanism.slides[slide].point);
        let [c, s] = bearing.along(self.bodies);
        let along = [("c", c), ("s", s)].map(|(letter, part)| match part {
            // Along an axis one of them is zero but for the rounding of the angle.
            _ if part.abs() < AXIS => Expr::zero(),
            _ => {
                let symbol = Symbol::from(letter).of(of.clone());
                self.sheet.given(symbol, part, "", text!("working-friction-along"))
            }
        });
        for (link, sign) in
            [(bearing.link, 1.0), (bearing.on, -1.0)].into_iter().filter(|(link, _)| *link != GROUND)
        {
            let body = &self.bodies[link];
            let off = minus(place, [body.x, body.y]);
            let local = [body.c * off[0] + body.s * off[1], body.c * off[1] - body.s * off[0]];
            let at = self.sheet.point(link, local);
            let parts = [0, 1].map(|axis| &size * &along[axis] * Expr::number(sign));
            self.apply(link, parts, at);
        }
        if let Surfaces::Faces { offset, .. } = bearing.surfaces
            && offset != 0.0
        {
            let symbol = Symbol::from("M").of("f").of(of.clone());
            let moment =
                self.sheet.given(symbol, lever * offset, "N·m", text!("working-friction-of", pair = of));
            self.turn(bearing.link, moment.clone());
            self.turn(bearing.on, -moment);
        }
    }
}

/// A magnitude in words.
fn modulus(mechanism: &Mechanism, bearing: &Bearing, kind: UnknownKind) -> Text {
    let pair = Text::from(mechanism.pair_name(bearing.pair));
    match kind {
        UnknownKind::Force => {
            text!("working-friction-pin", pair, link = Text::from(&mechanism.links[bearing.link].name))
        }
        UnknownKind::End(end) => {
            text!("working-friction-end", pair, end = number(if end > 0.0 { 1 } else { 2 }))
        }
        UnknownKind::Normal | UnknownKind::Shift => text!("working-friction-normal", pair),
    }
}
