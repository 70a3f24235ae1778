//! Reduction to the input link, and the equation of motion term by term (E eqs. 4-6; D 3.10).

use assur_worksheet::Expr;

use crate::{Drive, Work};

/// Units of inertia, of its derivative, of a moment, and of speed and acceleration of the input.
struct Units {
    inertia: &'static str,
    slope: &'static str,
    moment: &'static str,
    acceleration: &'static str,
}

const ANGULAR: Units =
    Units { inertia: "kg·m²", slope: "kg·m²/rad", moment: "N·m", acceleration: "rad/s²" };
const LINEAR: Units = Units { inertia: "kg", slope: "kg/m", moment: "N", acceleration: "m/s²" };

impl Work<'_> {
    /// Writes J, J', Q and the acceleration that follows from them, after the applied loads.
    pub(crate) fn equation_of_motion(&mut self, drive: Drive) {
        let units = if self.linkage.angular() { ANGULAR } else { LINEAR };
        self.sheet.section("Reduction to the input link");
        self.sheet
            .note("J: twice the kinetic energy of the links for w = 1; J': its derivative with respect to q");
        let [inertia, slope] = self.reduced_inertia(&units);
        self.sheet.note("Q: power of all loads but that of the drive for w = 1, link by link");
        let powers: Vec<_> =
            (1..self.linkage.structure.links).map(|link| self.sheet.power_of(link)).collect();
        let sum = powers.into_iter().fold(Expr::zero(), |sum, power| sum + power);
        let moment = self.sheet.work("Q", &sum, units.moment);
        self.sheet.section("Equation of motion");
        self.sheet.note("(J + J_d)*e + J'*w^2/2 = Q + M_d");
        let driving = self.sheet.given(
            "M_d",
            drive.moment,
            units.moment,
            "of the drive at this speed, on the input link",
        );
        let own = self.sheet.given(
            "J_d",
            drive.inertia,
            units.inertia,
            "flywheel and rotor, reduced to the input link",
        );
        let w = self.sheet.find("w").unwrap_or_else(Expr::zero);
        let net = moment + driving - slope * w.squared() / Expr::number(2.0);
        self.sheet.work("e", &(net / (inertia + own)), units.acceleration);
    }

    /// The sums of J and J' over the links.
    fn reduced_inertia(&mut self, units: &Units) -> [Expr; 2] {
        let (mut sums, two) = ([Expr::zero(), Expr::zero()], Expr::number(2.0));
        for link in 1..self.linkage.structure.links {
            let found = &self.linkage.mechanism.links[link];
            let (center, own) = (found.center, found.inertia);
            let m = self.mass(link);
            let tag = self.sheet.tag(link);
            let (mut inertia, mut slope) = (Expr::zero(), Expr::zero());
            if !m.is_zero() {
                let at = self.sheet.point(link, center);
                let [[x1, y1], [x2, y2]] = [&at.pf[1], &at.pf[2]];
                inertia = &m * (x1.squared() + y1.squared());
                slope = &two * &m * (x1 * x2 + y1 * y2);
            }
            let [_, first, second] = self.sheet.angle(link);
            if own != 0.0 {
                let own = self.sheet.given(&format!("I_{tag}"), own, "kg·m²", "about the center of mass");
                inertia = inertia + &own * first.squared();
                slope = slope + &two * own * first * second;
            }
            let shares = [
                self.sheet.work_unless_zero(&format!("J_{tag}"), &inertia, units.inertia),
                self.sheet.work_unless_zero(&format!("J'_{tag}"), &slope, units.slope),
            ];
            let [inertia, slope] = shares;
            sums = [&sums[0] + inertia, &sums[1] + slope];
        }
        let [inertia, slope] = sums;
        [self.sheet.work("J", &inertia, units.inertia), self.sheet.work("J'", &slope, units.slope)]
    }

    /// Writes what the drive exerts beyond accelerating flywheel and rotor, which must be the balancing load.
    pub(crate) fn drive_check(&mut self, balancing: &str) {
        let [Some(driving), Some(own), Some(e)] = ["M_d", "J_d", "e"].map(|name| self.sheet.find(name))
        else {
            return;
        };
        self.sheet.section("Check by the drive");
        let unit = if self.linkage.angular() { ANGULAR.moment } else { LINEAR.moment };
        self.sheet.note("The drive gives the balancing load, and accelerates flywheel and rotor:");
        self.sheet.work("M_drive", &(driving - own * e), unit);
        self.sheet.note(format!("It must be {balancing} above."));
    }
}
