//! Positions and transfer functions, group by group.

use std::f64::consts::TAU;

use assur_mechanism::PairId;
use assur_structure::roman;
use assur_words::{Text, list, name, text};
use assur_worksheet::{Symbol, dyad::along, plugin_for};

use crate::{Work, WorkingError};

/// If the equations of a kind differ from the program's values by more than this fraction, they are singular there
/// and not used.
const AGREEMENT: f64 = 1e-7;

impl Work<'_> {
    /// Writes positions, PF1 and PF2 of one group and of all points and slides on its links.
    pub(crate) fn group(&mut self, group: usize) -> Result<(), WorkingError> {
        let found = &self.linkage.structure.groups[group];
        let class = name(roman(found.class));
        let class = match found.plugin.number {
            0 => text!("working-class", class),
            number => text!("working-class-and-type", class, number = usize::from(number)),
        };
        let links: Vec<Text> = found.frame.links.iter().map(|&link| self.sheet.body_name(link)).collect();
        let kind = name(found.plugin.kind);
        self.sheet.section(text!("working-group", group = group + 1, kind, class, links = list(links)));
        self.sheet.begin_group(group + 1);
        let before = self.sheet.clone();
        let own = plugin_for(found.plugin.name)?.filter(|_| self.own).filter(|plugin| {
            let written = (plugin.motion)(&mut self.sheet, &found.frame, self.bodies);
            written.is_ok() && !self.sheet.is_unfit() && self.agrees(&found.frame.links)
        });
        if own.is_none() {
            self.sheet = before;
            self.general.push(group);
            self.general_motion(group);
        }
        self.points_of(&found.frame.links);
        let pairs: Vec<_> = found.frame.pairs().map(|pair| pair.id).collect();
        for pair in pairs {
            self.slide(pair);
        }
        Ok(())
    }

    /// Whether the poses on the sheet agree with those of the program.
    fn agrees(&self, links: &[usize]) -> bool {
        let scale = self.linkage.structure.scale;
        links.iter().all(|&link| {
            let (Some(pose), body) = (self.sheet.pose(link), &self.bodies[link]) else { return false };
            let arm = body.arm(pose.at);
            let wanted = [body.point(pose.at), body.first(arm), body.second(arm)];
            let close = |found: f64, wanted: f64, unit: f64| {
                (found - wanted).abs() <= AGREEMENT * (wanted.abs() + unit)
            };
            let points = (0..3).all(|order| {
                let size = wanted[order][0].hypot(wanted[order][1]) + scale;
                (0..2).all(|i| close(pose.base.pf[order][i].value(), wanted[order][i], size))
            });
            let [phi, first, second] = pose.phi.each_ref().map(assur_worksheet::Expr::value);
            let turn = phi - body.s.atan2(body.c);
            let turn = turn - TAU * (turn / TAU).round();
            let unit = if self.linkage.kind().is_angle() { 1.0 } else { 1.0 / scale };
            points
                && turn.abs() <= AGREEMENT
                && close(first, body.w1, unit)
                && close(second, body.w2, unit * unit)
        })
    }

    /// All named places of links that are placed.
    pub(crate) fn points_of(&mut self, links: &[usize]) {
        let named = crate::names::of(self.linkage).places;
        for (body, at, _) in named.into_iter().filter(|(body, ..)| links.contains(body)) {
            self.sheet.point(body, at);
        }
    }

    /// Writes the displacement of a slide and its derivatives; the point stays on the line.
    fn slide(&mut self, pair: usize) {
        let PairId::Slide(id) = self.linkage.structure.pairs[pair].source else { return };
        let slide = self.linkage.mechanism.slides[id].clone();
        let point = self.sheet.point(slide.link, slide.point);
        let through = self.sheet.point(slide.on, slide.through);
        let t = self.sheet.guide(pair, slide.on, slide.angle).t;
        let symbol = Symbol::from("s").of(self.sheet.pair_name(pair));
        let units = self.sheet.units.length;
        if point.name == through.name {
            return;
        }
        self.sheet.note(text!("working-displacement", slide = &slide.name));
        let s = self.sheet.work(&symbol, &along(&t, &point.from(&through, 0)), units[0]);
        let first = along(&t, &point.from(&through, 1));
        self.sheet.work_unless_zero(symbol.clone().prime(1), &first, units[1]);
        let turning = self.sheet.angle(slide.on)[1].squared() * s;
        let second = along(&t, &point.from(&through, 2)) + turning;
        self.sheet.work_unless_zero(symbol.prime(2), &second, units[2]);
    }
}
