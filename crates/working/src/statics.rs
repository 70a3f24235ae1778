//! Equilibrium of the input link.

use assur_group::PairGeometry;
use assur_worksheet::Expr;

use crate::Work;

impl Work<'_> {
    /// Writes the reaction at the ground, and the balancing moment or force at the input.
    pub(crate) fn input_reactions(&mut self) -> Expr {
        let pair = self.linkage.structure.pairs[0].pair;
        let link = self.linkage.mechanism.input.link;
        let name = self.sheet.body_name(link).to_owned();
        self.sheet.section(&format!("Input link {name}: reaction and balancing load"));
        match pair.geometry {
            PairGeometry::Pin { at_a, .. } => {
                let at = self.sheet.point(pair.a, at_a);
                let [x, y] = self.sheet.resultant(link);
                self.sheet.pin_reaction(0, link, &at, &[-x, -y]);
                self.sheet.note(format!("moments about {}:", at.name));
                let moment = self.sheet.moment_about(link, &at);
                self.sheet.work("M_bal", &-moment, "N·m")
            }
            PairGeometry::Slide { point, .. } => self.sliding_reaction(pair.a, point),
        }
    }

    /// The balancing force is the component along the guide; the guide exerts the component across it.
    fn sliding_reaction(&mut self, a: usize, point: [f64; 2]) -> Expr {
        let link = self.linkage.mechanism.input.link;
        let at = self.sheet.point(a, point);
        let direction = match self.sheet.pose(link) {
            Some(pose) => pose.base.pf[1].clone(),
            None => [Expr::zero(), Expr::zero()],
        };
        let [x, y] = self.sheet.resultant(link);
        let [c, s] = direction;
        let across = self.sheet.work_unless_zero("Fn_input", &(&c * &y - &s * &x), "N");
        let moment = -self.sheet.moment_about(link, &at);
        let force = [&across * &s, -(&across * &c)];
        self.sheet.slide_reaction(0, link, &at, &force, &moment);
        self.sheet.work("F_bal", &-(&x * &c + &y * &s), "N")
    }
}
