//! Reduction to the input link, and the equation of motion term by term (E eqs. 4-6; D 3.10).

use assur_mechanism::ReductionPoint;
use assur_words::text;
use assur_worksheet::{Expr, Symbol};

use crate::{Work, balancing};

impl Work<'_> {
    /// Writes J, J' and Q, after the applied loads, and with a drive the acceleration that follows from them.
    pub(crate) fn equation_of_motion(&mut self) {
        let units = self.sheet.units;
        self.sheet.section(text!("working-reduction"));
        self.sheet.note(text!("working-reduced-inertia"));
        let [inertia, slope] = self.reduced_inertia(units.inertia);
        self.sheet.note(text!("working-reduced-moment"));
        let moment = self.total_power("Q");
        self.reduce_to_point(&inertia, &moment);
        let Some([driving, own]) = self.drive else { return };
        self.sheet.section(text!("working-equation"));
        let what = text!("working-driving-moment");
        let driving = self.sheet.given(of_drive("M"), driving, units.moment, what);
        let what = text!("working-inertia-of-drive");
        let own = self.sheet.given(of_drive("J"), own, units.inertia[0], what);
        let w = self.sheet.find("ω").unwrap_or_else(Expr::zero);
        let kinetic = slope * w.squared() / Expr::number(2.0);
        let unknown = Expr::symbol("ε", f64::NAN);
        self.sheet.equation((&inertia + &own) * unknown + &kinetic, &moment + &driving);
        let net = moment + driving - kinetic;
        self.sheet.work("ε", &(net / (inertia + own)), units.input[2]);
    }

    /// The force and the mass that stand for them at a point of the input link (E eqs. 4-6).
    fn reduce_to_point(&mut self, inertia: &Expr, moment: &Expr) {
        let mechanism = &self.linkage.mechanism;
        let link = mechanism.input.first().link;
        let Some(place) = ReductionPoint::farthest(mechanism)
            .filter(|_| self.linkage.kind().is_angle())
            .and_then(|found| mechanism.place_in(found.point.id, link))
        else {
            return;
        };
        let at = self.sheet.point(link, place);
        self.sheet.note(text!("working-to-point", point = &at.name));
        let [x, y] = &at.pf[1];
        let of = |letter: &'static str| Symbol::from(letter).of(&at.name);
        let radius = self.sheet.work(of("r"), &(x.squared() + y.squared()).sqrt(), "m");
        self.sheet.work(of("F"), &(moment / &radius), "N");
        self.sheet.work(of("m"), &(inertia / radius.squared()), "kg");
    }

    /// The sums of J and J' over the links.
    fn reduced_inertia(&mut self, [unit, slope_unit]: [&'static str; 2]) -> [Expr; 2] {
        let (mut sums, two) = ([Expr::zero(), Expr::zero()], Expr::number(2.0));
        for link in 1..self.linkage.structure.links {
            let found = &self.linkage.mechanism.links[link];
            let center = found.center;
            let m = self.mass(link);
            let tag = self.sheet.body_name(link);
            let (mut inertia, mut slope) = (Expr::zero(), Expr::zero());
            if !m.is_zero() {
                let at = self.sheet.point(link, center);
                let [[x1, y1], [x2, y2]] = [&at.pf[1], &at.pf[2]];
                inertia = &m * (x1.squared() + y1.squared());
                slope = &two * &m * (x1 * x2 + y1 * y2);
            }
            let [_, first, second] = self.sheet.angle(link);
            let [own, varies] = self.own_inertia(link);
            inertia = inertia + &own * first.squared();
            slope = slope + &two * own * &first * second + varies * first.squared();
            let shares = [
                self.sheet.work_unless_zero(Symbol::from("J").of(&tag), &inertia, unit),
                self.sheet.work_unless_zero(Symbol::from("J").prime(1).of(&tag), &slope, slope_unit),
            ];
            let [inertia, slope] = shares;
            sums = [&sums[0] + inertia, &sums[1] + slope];
        }
        let [inertia, slope] = sums;
        let derivative = Symbol::from("J").prime(1);
        [self.sheet.work("J", &inertia, unit), self.sheet.work(derivative, &slope, slope_unit)]
    }

    /// Writes what the drive exerts beyond accelerating flywheel and rotor, which must be the balancing load.
    pub(crate) fn drive_check(&mut self) {
        let known = [of_drive("M"), of_drive("J"), "ε".into()];
        let [Some(driving), Some(own), Some(e)] = known.map(|symbol| self.sheet.find(symbol)) else {
            return;
        };
        self.sheet.section(text!("working-check-by-drive"));
        self.sheet.note(text!("working-what-the-drive-gives"));
        let symbol = self.balancing_at_input();
        let by_drive = symbol.clone().of(text!("working-by-drive"));
        self.sheet.work(by_drive, &(driving - own * e), self.sheet.units.moment);
        self.sheet.note(text!("working-must-be", quantity = &symbol));
    }

    /// The balancing load of the input.
    pub(crate) fn balancing_at_input(&self) -> Symbol {
        balancing(if self.linkage.kind().is_angle() { "M" } else { "F" })
    }
}

fn of_drive(letter: &'static str) -> Symbol {
    Symbol::from(letter).of(text!("working-of-drive"))
}
