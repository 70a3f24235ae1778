//! Dry friction of this position: the iteration of the textbooks, and the loads to which it leads.

use assur_force::{Iteration, Kinetostatics, Loads, Rub, UnknownKind};
use assur_group::plane::{dot, minus, perp};
use assur_kinematics::Position;
use assur_mechanism::{GROUND, LinkId, Mechanism, PairId, Rubbing};
use assur_structure::name_of;
use assur_words::{Text, joined, number, quantity, text};
use assur_worksheet::{Expr, Load, Symbol};

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
        self.sheet.section(text!("working-rubbing"));
        self.sheet.note(text!("working-rubbing-text"));
        let known =
            forces.reactions.rubbing.iter().all(|found| found.forces.iter().all(|force| force.is_finite()));
        if solved && !known {
            // At rest in a motion friction is not determined.
            return false;
        }
        for found in forces.iteration(&self.state, position) {
            self.iteration(&found, &frictions.rubs, |index| {
                let unknown = &frictions.unknowns[index];
                (unknown.rub, unknown.kind)
            });
        }
        let (true, Some(rubbing)) = (solved, &forces.reactions.rubbing) else { return false };
        for ((rub, force), sense) in frictions.rubs.iter().zip(&rubbing.forces).zip(&rubbing.senses) {
            let on_link = rub.path.iter().fold([0.0; 2], |[x, y], (pair, sign)| {
                let one = &forces.reactions.pairs[*pair];
                [x + sign * one.fx, y + sign * one.fy]
            });
            let normal = if rub.slides() { dot(on_link, perp(rub.along(self.bodies))) } else { 0.0 };
            self.rubbing(rub, *force, -sense * rub.coefficient * normal);
        }
        true
    }

    /// Writes the moduli of a block, step by step.
    fn iteration(
        &mut self,
        found: &Iteration,
        rubs: &[Rub],
        unknown: impl Fn(usize) -> (usize, UnknownKind),
    ) {
        let mechanism = &self.linkage.mechanism;
        let moduli = |z: &[f64]| {
            let each = found.unknowns.iter().zip(z).map(|(index, z)| {
                let (rub, kind) = unknown(*index);
                text!(
                    "working-rubbing-modulus",
                    name = modulus(mechanism, &rubs[rub], kind),
                    value = quantity(format_args!("{z:.6}"), "N")
                )
            });
            joined("; ", each)
        };
        let radius = number(format_args!("{:.6}", found.radius));
        let proved = found.radius < 1.0;
        let id = if proved { "working-rubbing-block" } else { "working-rubbing-block-not-proved" };
        self.sheet.note(text!(id, what = &found.what, radius = radius));
        for (step, z) in found.steps.iter().enumerate() {
            let moduli = moduli(z);
            self.sheet.note(text!("working-rubbing-step", step = step, moduli = moduli));
        }
        if let Some(z) = &found.solution {
            let moduli = moduli(z);
            self.sheet.note(text!("working-rubbing-newton", moduli = moduli));
        }
    }

    /// Adds the friction of a pair to the loads of its links; `lever`: of faces beside the guide line, the force that has the
    /// moment, N.
    fn rubbing(&mut self, rub: &Rub, force: f64, lever: f64) {
        let mechanism = &self.linkage.mechanism;
        let of = Text::from(name_of(mechanism, rub.pair));
        let tag = Symbol::from(of.clone()).of(self.sheet.body_name(rub.link));
        if force == 0.0 {
            return;
        }
        if !rub.slides() {
            let moment = self.sheet.given(
                Symbol::from("M").of("f").of(tag),
                force,
                "N·m",
                text!("working-rubbing-of", pair = of),
            );
            self.turn(rub.link, moment.clone());
            self.turn(rub.on, -moment);
            return;
        }
        let PairId::Slide(slide) = rub.pair else { return };
        let place = self.bodies[rub.link].point(mechanism.slides[slide].point);
        let size = self.sheet.given(
            Symbol::from("F").of("f").of(tag),
            force,
            "N",
            text!("working-rubbing-of", pair = of.clone()),
        );
        let [c, s] = rub.along(self.bodies);
        let along = [("c", c), ("s", s)].map(|(letter, part)| match part {
            // Along an axis one of them is zero but for the rounding of the angle.
            _ if part.abs() < AXIS => Expr::zero(),
            _ => self.sheet.given(
                Symbol::from(letter).of(of.clone()),
                part,
                "",
                text!("working-rubbing-along"),
            ),
        });
        for (link, sign) in [(rub.link, 1.0), (rub.on, -1.0)].into_iter().filter(|(link, _)| *link != GROUND)
        {
            let body = &self.bodies[link];
            let off = minus(place, [body.x, body.y]);
            let local = [body.c * off[0] + body.s * off[1], body.c * off[1] - body.s * off[0]];
            let at = self.sheet.point(link, local);
            let parts = [0, 1].map(|axis| &size * &along[axis] * Expr::number(sign));
            self.sheet.load(link, Load { force: Some((parts, at)), moment: Expr::zero(), applied: true });
        }
        if let Rubbing::Faces { offset, .. } = rub.rubbing
            && offset != 0.0
        {
            let symbol = Symbol::from("M").of("f").of(of.clone());
            let moment =
                self.sheet.given(symbol, lever * offset, "N·m", text!("working-rubbing-of", pair = of));
            self.turn(rub.link, moment.clone());
            self.turn(rub.on, -moment);
        }
    }

    fn turn(&mut self, link: LinkId, moment: Expr) {
        if link != GROUND {
            self.sheet.load(link, Load { force: None, moment, applied: true });
        }
    }
}

/// A modulus in words.
fn modulus(mechanism: &Mechanism, rub: &Rub, kind: UnknownKind) -> Text {
    let pair = Text::from(name_of(mechanism, rub.pair));
    match kind {
        UnknownKind::Force => {
            text!("working-rubbing-pin", pair = pair, link = Text::from(&mechanism.links[rub.link].name))
        }
        UnknownKind::End(end) => {
            text!("working-rubbing-end", pair = pair, end = number(if end > 0.0 { 1 } else { 2 }))
        }
        UnknownKind::Normal | UnknownKind::Shift => text!("working-rubbing-normal", pair = pair),
    }
}
