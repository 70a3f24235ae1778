//! Forces: loads, the groups from the last to the first, the input link, and a check by power.

use assur_force::{Loads, UnitBalance};
use assur_group::PairGeometry;
use assur_kinematics::Position;
use assur_mechanism::Balance;
use assur_words::{name, text};
use assur_worksheet::{Expr, Symbol, plugin_for};

use crate::{Work, WorkingError, balancing};

impl Work<'_> {
    /// Writes all forces; the balancing load is returned if it is determined.
    pub(crate) fn forces(
        &mut self,
        loads: &Loads,
        analyzer: Option<&str>,
        position: &Position,
    ) -> Result<Option<f64>, WorkingError> {
        self.loads(loads);
        if !self.friction(loads, analyzer, position) {
            self.sheet.note(text!("working-no-reactions"));
            return Ok(None);
        }
        let elsewhere = self.balance();
        if self.sheet.is_unfit() {
            self.sheet.note(text!("working-no-balancing"));
            return Ok(None);
        }
        for group in (0..self.linkage.structure.groups.len()).rev() {
            if !self.group_reactions(group)? {
                self.sheet.note(text!("working-no-reactions"));
                return Ok(None);
            }
        }
        let drive = self.input_reactions();
        if elsewhere.is_none() {
            self.virtual_power();
            self.drive_check();
        }
        if let Some(analyzer) = analyzer {
            self.by_method(analyzer)?;
        }
        Ok(Some(elsewhere.unwrap_or(drive).value()))
    }

    fn group_reactions(&mut self, group: usize) -> Result<bool, WorkingError> {
        let found = &self.linkage.structure.groups[group];
        let kind = name(found.plugin.kind);
        self.sheet.section(text!("working-reactions", group = group + 1, kind));
        self.sheet.begin_group(group + 1);
        let before = self.sheet.clone();
        if let Some(plugin) = plugin_for(found.plugin.name)?.filter(|_| !self.general.contains(&group)) {
            let written = (plugin.reactions)(&mut self.sheet, &found.frame, self.bodies);
            if written.is_ok() && !self.sheet.is_unfit() {
                return Ok(true);
            }
        }
        self.sheet = before;
        Ok(self.general_reactions(group))
    }

    /// Writes a balancing load that does not act on the input, from the condition that it and the loads have no power
    /// together.
    fn balance(&mut self) -> Option<Expr> {
        let mechanism = &self.linkage.mechanism;
        UnitBalance::of(mechanism)?;
        let balance = mechanism.balance?;
        self.sheet.section(text!("working-balancing-load"));
        let power = self.total_power("P");
        self.sheet.note(text!("working-unit-power"));
        match balance {
            Balance::Moment(link) => {
                let p = self.sheet.work("p", &self.sheet.angle(link)[1].clone(), self.sheet.units.angle[1]);
                let moment = self.sheet.work(balancing("M"), &-(power / p), "N·m");
                self.turn(link, moment.clone());
                Some(moment)
            }
            Balance::Force { at, angle } => {
                let point = self.sheet.point(at.link, at.at);
                let angle =
                    self.sheet.given(balancing("α"), angle, "rad", text!("working-balancing-direction"));
                let (c, s) = (angle.cos(), angle.sin());
                let p = &c * &point.pf[1][0] + &s * &point.pf[1][1];
                let p = self.sheet.work("p", &p, self.sheet.units.length[1]);
                let size = self.sheet.work(balancing("F"), &-(power / p), "N");
                let force = [&size * &c, &size * &s];
                let force = self.sheet.components("F", text!("working-balancing"), &force, "N");
                self.apply(at.link, force, point);
                Some(size)
            }
        }
    }

    /// Writes the power of the applied loads on all links for dq = 1.
    pub(crate) fn total_power(&mut self, symbol: &'static str) -> Expr {
        let each: Vec<_> = (1..self.linkage.structure.links).map(|link| self.sheet.power_of(link)).collect();
        let sum = each.into_iter().fold(Expr::zero(), |sum, power| sum + power);
        self.sheet.work(symbol, &sum, self.sheet.units.moment)
    }

    fn virtual_power(&mut self) {
        self.sheet.section(text!("working-check-by-power"));
        self.sheet.note(text!("working-whole-power"));
        let power = self.total_power("P");
        let symbol = self.balancing_at_input();
        self.sheet.work(symbol.clone().of(text!("working-by-power")), &-power, self.sheet.units.moment);
        self.sheet.note(text!("working-must-be", quantity = &symbol));
    }

    /// Writes the reaction at the ground, and the balancing moment or force at the input.
    pub(crate) fn input_reactions(&mut self) -> Expr {
        if let Some(drive) = &self.pair_drive {
            return drive.clone();
        }
        let pair = self.linkage.structure.pairs[0].pair;
        let link = self.linkage.mechanism.input.first().link;
        let name = self.sheet.body_name(link);
        self.sheet.section(text!("working-input-forces", link = name));
        match pair.geometry {
            PairGeometry::Pin { at_a, .. } => {
                let at = self.sheet.point(pair.a, at_a);
                let [x, y] = self.sheet.resultant(link);
                self.sheet.pin_reaction(0, link, &at, &[-x, -y]);
                self.sheet.note(text!("working-moments-about", point = &at.name));
                let moment = self.sheet.moment_about(link, &at);
                self.sheet.work(balancing("M"), &-moment, "N·m")
            }
            PairGeometry::Slide { point, .. } => self.sliding_reaction(pair.a, point),
        }
    }

    /// The balancing force is the component along the guide; the guide exerts the component across it.
    fn sliding_reaction(&mut self, a: usize, point: [f64; 2]) -> Expr {
        let link = self.linkage.mechanism.input.first().link;
        let at = self.sheet.point(a, point);
        let direction = match self.sheet.pose(link) {
            Some(pose) => pose.base.pf[1].clone(),
            None => [Expr::zero(), Expr::zero()],
        };
        let [x, y] = self.sheet.resultant(link);
        let [c, s] = direction;
        let symbol = Symbol::from("F").of("n").of(self.sheet.body_name(link));
        let across = self.sheet.work_unless_zero(symbol, &(&c * &y - &s * &x), "N");
        let moment = -self.sheet.moment_about(link, &at);
        let force = [&across * &s, -(&across * &c)];
        self.sheet.slide_reaction(0, link, &at, &force, &moment);
        self.sheet.work(balancing("F"), &-(&x * &c + &y * &s), "N")
    }
}
