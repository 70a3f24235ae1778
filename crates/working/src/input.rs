//! The input: a link whose position is given by the coordinate, or the coordinate of a pair between two links of a group.

use assur_mechanism::{GROUND, InputPair, Range};
use assur_words::{Text, text, unit};
use assur_worksheet::{Expr, Pose, Symbol};

use crate::{PositionOrSample, Work};

impl Work<'_> {
    /// Writes the coordinate and the motion of the input link.
    pub(crate) fn input(&mut self, place: PositionOrSample) {
        let input = self.linkage.mechanism.input.first();
        let link = input.link;
        let name = self.sheet.body_name(link);
        if input.is_relative() {
            let [pair, on] = [self.sheet.pair_name(0), self.sheet.body_name(input.on)];
            self.sheet.section(text!("working-driven", pair));
            let q = self.coordinate(place);
            if input.is_angle() {
                let degrees = &q * Expr::number(180.0) / Expr::pi();
                self.sheet.work(Symbol::from("q").of(unit("deg")), &degrees, "deg");
                self.sheet.note(text!("working-driven-angle", link = name, on));
            } else {
                self.sheet.note(text!("working-driven-displacement", link = name, on));
            }
            return;
        }
        self.sheet.section(text!("working-input", link = &name));
        let q = self.coordinate(place);
        match input.pair {
            InputPair::Pin(point) => {
                let degrees = &q * Expr::number(180.0) / Expr::pi();
                self.sheet.work(Symbol::from("q").of(unit("deg")), &degrees, "deg");
                self.sheet.note(text!("working-input-angle", link = name));
                let place = |body| self.linkage.mechanism.place_in(point, body).unwrap_or_default();
                let (ground, at) = (place(GROUND), place(link));
                let base = self.sheet.point(GROUND, ground);
                self.sheet.set_pose(link, Pose { base, at, phi: [q, Expr::number(1.0), Expr::zero()] });
            }
            InputPair::Slide(slide) => self.sliding(slide, &q),
        }
        self.points_of(&[link]);
    }

    fn coordinate(&mut self, place: PositionOrSample) -> Expr {
        let input = &self.linkage.mechanism.input;
        let unit = self.sheet.units.input[0];
        let PositionOrSample::Position(index) = place else {
            return self.sheet.given("q", self.state.coordinate, unit, text!("working-coordinate-of-sample"));
        };
        let from =
            self.sheet.given(Symbol::from("q").of(0), input.from, unit, text!("working-first-coordinate"));
        let (way, steps) = match input.range {
            Range::Cycle(cycle) => (input.sign() * cycle, input.positions),
            Range::To(to) => (to - input.from, input.positions - 1),
        };
        if steps == 0 || index == 0 {
            return self.sheet.work("q", &from, unit);
        }
        let symbol = Symbol::from("q").of(text!("working-travel"));
        let way = self.sheet.given(symbol, way, unit, text!("working-whole-travel"));
        let mut number =
            |letter: &'static str, value: usize, what: Text| self.sheet.given(letter, value as f64, "", what);
        let at = number("i", index, text!("working-number-of-position"));
        let steps = number("n", steps, text!("working-number-of-steps"));
        self.sheet.work("q", &(from + way * at / steps), unit)
    }

    /// The displacement is that of the slide's point along the guide; the guide is on either of the two bodies.
    fn sliding(&mut self, slide: usize, q: &Expr) {
        let found = self.linkage.mechanism.slides[slide].clone();
        let link = self.linkage.mechanism.input.first().link;
        let on_ground = found.on == GROUND;
        let (angle, fixed, own) = if on_ground {
            (found.angle, found.through, found.point)
        } else {
            (-found.tilt, found.point, found.through)
        };
        let guide = self.sheet.guide(0, GROUND, angle);
        let fixed = self.sheet.point(GROUND, fixed);
        let name = self.sheet.place_name(link, own);
        self.sheet.note(text!("working-input-displacement"));
        let unit = guide.t.each_ref().map(|t| if on_ground { t.clone() } else { -t });
        let place = [0, 1].map(|i| &fixed.pf[0][i] + q * &unit[i]);
        let pf0 = self.sheet.vector(&name, 0, &place);
        let pf1 = self.sheet.vector(&name, 1, &unit);
        let base = self.sheet.set_point(link, own, [pf0, pf1, [Expr::zero(), Expr::zero()]]);
        let turn = self.sheet.tilt(0, link, if on_ground { found.tilt } else { -found.angle });
        let phi = self.sheet.link_angle(link, &(&guide.alpha + turn));
        self.sheet.set_pose(link, Pose { base, at: own, phi: [phi, Expr::zero(), Expr::zero()] });
    }
}
