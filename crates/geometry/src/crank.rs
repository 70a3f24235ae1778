//! Whether a crank can turn fully in a four-bar (Grashof).

use assur_mechanism::{GROUND, InputPair, LinkId, Mechanism, PointId};
use assur_number::elementary::hypot;

/// The crank condition of a loop of four links: ground, crank, coupler, rocker.
///
/// With the lengths a of the crank, b of the coupler, c of the rocker, d of the ground, the crank turns fully where
/// `a + d <= b + c` and `|d - a| >= |b - c|` (the sums of Grashof, solved for the crank).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrankCondition {
    /// Coupler and rocker.
    pub links: [LinkId; 2],
    /// Length of the crank, m.
    pub crank: f64,
    /// Least and greatest length with which it turns fully, m: of the lengths up to that of the ground, or of those above it, the
    /// ones on the side of the crank where there are any. With no length at all the first is above the second.
    pub turning: [f64; 2],
}

/// Rounding of a sum of lengths, as part of it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl CrankCondition {
    /// Of the lengths of crank, coupler, rocker and ground, m.
    fn of(links: [LinkId; 2], [a, b, c, d]: [f64; 4]) -> Self {
        let apart = (b - c).abs();
        // At a change point, as of a parallelogram, the limit is the length itself but for rounding.
        let rounding = ROUNDING * (a + b + c + d);
        let limit = |end: f64| if (end - a).abs() <= rounding { a } else { end };
        let [short, long] =
            [[0.0, (b + c - d).min(d - apart)], [d + apart, b + c - d]].map(|ends| ends.map(limit));
        // A crank longer than the ground turns about both pins of the ground.
        let [own, other] = if a > d { [long, short] } else { [short, long] };
        let is_empty = |[least, most]: [f64; 2]| least > most;
        Self { links, crank: a, turning: if is_empty(own) && !is_empty(other) { other } else { own } }
    }

    /// Whether the crank turns fully.
    pub fn holds(&self) -> bool {
        (self.turning[0]..=self.turning[1]).contains(&self.crank)
    }
}

/// The crank conditions of all four-bars that begin at an input link that turns.
pub fn crank_conditions(mechanism: &Mechanism) -> Vec<CrankCondition> {
    let (InputPair::Pin(o), Some(crank)) = (mechanism.input.first().pair, mechanism.input.crank()) else {
        return Vec::new();
    };
    let on =
        |link: LinkId| (0..mechanism.points.len()).filter(move |&p| mechanism.place_in(p, link).is_some());
    let others = |point: PointId| mechanism.points[point].places.iter().map(|place| place.link);
    let mut found = Vec::new();
    for a in on(crank).filter(|&a| a != o) {
        for coupler in others(a).filter(|&link| link != crank && link != GROUND) {
            for b in on(coupler).filter(|&b| b != a) {
                for rocker in others(b).filter(|link| ![GROUND, crank, coupler].contains(link)) {
                    let pivots = on(rocker).filter(|&c| c != b && mechanism.place_in(c, GROUND).is_some());
                    found.extend(pivots.filter_map(|c| {
                        let sides = [(crank, o, a), (coupler, a, b), (rocker, b, c), (GROUND, o, c)];
                        let [crank, b, c, d] = sides.map(|side| length(mechanism, side));
                        Some(CrankCondition::of([coupler, rocker], [crank?, b?, c?, d?]))
                    }));
                }
            }
        }
    }
    found
}

/// The distance of two points of a link, m.
fn length(mechanism: &Mechanism, (link, one, other): (LinkId, PointId, PointId)) -> Option<f64> {
    let [[x0, y0], [x1, y1]] = [mechanism.place_in(one, link)?, mechanism.place_in(other, link)?];
    Some(hypot(x1 - x0, y1 - y0))
}

#[cfg(test)]
mod tests {
    use super::CrankCondition;

    /// Turns the crank in small steps: whether the distance of its tip from the pivot of the rocker is always one that coupler and
    /// rocker reach.
    fn turns([a, b, c, d]: [f64; 4]) -> bool {
        (0..3600).all(|step| {
            let (s, cosine) = (f64::from(step) / 3600.0 * std::f64::consts::TAU).sin_cos();
            let away = (d - a * cosine).hypot(a * s);
            ((b - c).abs() - 1e-12..=b + c + 1e-12).contains(&away)
        })
    }

    #[test]
    fn the_condition_is_that_of_a_crank_turned_in_steps() {
        let mut held = [0, 0];
        for number in 0_u32..4000 {
            // Weyl's sequence of irrational steps: lengths from 1 to 5.
            let part = |factor: f64| 1.0 + 4.0 * (f64::from(number) * factor).fract();
            let lengths = [part(0.618_034), part(0.414_214), part(0.732_051), part(0.236_068)];
            let found = CrankCondition::of([1, 2], lengths);
            let near = found.turning.iter().any(|end| (end - lengths[0]).abs() < 1e-4);
            assert!(near || found.holds() == turns(lengths), "{lengths:?}: {found:?}");
            held[usize::from(found.holds())] += 1;
            // What it says of other lengths holds too.
            let [_, b, c, d] = lengths;
            let [least, most] = found.turning;
            if least <= most {
                assert!(turns([0.5 * (least + most), b, c, d]), "{lengths:?}: {found:?}");
            } else {
                let none = (1..60).all(|tenth| !turns([0.2 * f64::from(tenth), b, c, d]));
                assert!(none, "{lengths:?}: {found:?}");
            }
        }
        assert!(held.iter().all(|count| *count > 300), "{held:?}");
    }

    #[test]
    fn a_parallelogram_turns_over_its_change_points() {
        for lengths in [[0.1, 0.4, 0.1, 0.4], [0.3, 0.7, 0.3, 0.7], [0.4, 0.1, 0.4, 0.1]] {
            assert!(CrankCondition::of([1, 2], lengths).holds(), "{lengths:?}");
        }
        // A thousandth of a millimeter is no rounding.
        assert!(!CrankCondition::of([1, 2], [0.100_001, 0.4, 0.1, 0.4]).holds());
    }

    #[test]
    fn the_ends_are_where_the_crank_ceases_to_turn() {
        // Grashof: 1 + 4 <= 3.5 + 3, and the greatest crank is 3.5 + 3 - 4 = 2.5.
        let found = CrankCondition::of([1, 2], [1.0, 3.5, 3.0, 4.0]);
        assert!(found.holds() && (found.turning[1] - 2.5).abs() < 1e-12);
        for (crank, turning) in [(2.4999, true), (2.5001, false)] {
            assert_eq!(turns([crank, 3.5, 3.0, 4.0]), turning);
            assert_eq!(CrankCondition::of([1, 2], [crank, 3.5, 3.0, 4.0]).holds(), turning);
        }
    }
}
