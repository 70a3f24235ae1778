//! The conventions of a working.

use crate::{Place, Work};

const CONVENTIONS: [&str; 9] = [
    "Axes: x to the right, y up, fixed to the ground. Angles in rad, counter-clockwise positive, from the x axis; those of \
     links lie between -pi and pi, the tables of the analysis may differ by whole turns.",
    "Units: m, kg, s, rad, N, N·m.",
    "PF0 is the position of a point (x, y) or the angle phi of the x axis of a link; PF1 and PF2 are its first and second \
     derivatives with respect to the input coordinate q, marked ' and ''. They are not \
     velocities: v = PF1 w, a = PF2 w^2 + PF1 e with w = dq/dt, e = dw/dt.",
    "x_A, y_A: point A. phi_r: link r. u_A_B, v_A_B: from A to B in the frame of their link. l_A_B: length. beta_A_B: angle \
     of A-B from the x axis of its link. alpha, tx, ty: angle and unit vector of a guide, its normal is (-ty, tx).",
    "Quantities of one group carry its number: D_2 is the determinant of group 2.",
    "Positions run from the input link to the last group; forces from the last group back to the input link.",
    "Results have 6 significant digits. Intermediate values are carried with all digits; each line shows as many digits of \
     its numbers as its result needs, and can be recomputed from the digits shown. A result such as 0.00000 is zero \
     except for rounding.",
    "atan2(y, x) is the angle of the vector (x, y) in its own quadrant.",
    "Assumptions: plane motion, rigid links, pairs without clearance.",
];

const FORCES: [&str; 4] = [
    "Rx_B_r, Ry_B_r: the force that the pair B exerts on link r; on the other link the pair exerts the opposite. MR: the \
     moment of a slide on that link about the point named with it; its force acts at that point, across the guide.",
    "X_r, Y_r: sum of the known forces on link r. M_r_A: their moment about A, counter-clockwise positive.",
    "Inertia loads are -m a at the center of mass and -I phi'' (by time); with them each link is in equilibrium.",
    "Assumptions: pairs without friction; weights and inertia at the centers of mass.",
];

/// Added if a joint has more than two links.
const SHARES: &str = "In a joint B of more than two links, Rx_B_s_t_r is the share of links s and t alone; the reaction of B on r \
                      is the sum of its shares.";

impl Work<'_> {
    /// Writes the first section: signs, symbols, assumptions.
    pub(crate) fn conventions(&mut self, place: Place, forces: bool) {
        let mechanism = &self.linkage.mechanism;
        let title = if mechanism.title.is_empty() { "Working" } else { mechanism.title.as_str() };
        let what = match place {
            Place::Position(index) => format!("position {index}"),
            Place::Sample(number) => format!("sample {number}, time {} s", self.state.time),
        };
        self.sheet.section(&format!("{title}: working of {what}"));
        self.sheet.note(format!("Structure: {}", self.linkage.structure.formula));
        self.sheet.section("Conventions and assumptions");
        for words in CONVENTIONS {
            self.sheet.note(words);
        }
        if forces {
            for words in FORCES {
                self.sheet.note(words);
            }
            let structure = &self.linkage.structure;
            if (0..structure.pairs.len()).any(|pair| structure.is_share(pair)) {
                self.sheet.note(SHARES);
            }
        }
    }
}
