//! A slide alone, pressed on one face or on both: all solutions and the limit of jamming by cases.

use assur_force::{Kinetostatics, LoadState, Loads, find};
use assur_group::Order;
use assur_kinematics::Linkage;

use super::cases::{Dice, limit, scene};

/// A slide that is driven by a force along its guide at the height `a`, against a load at a place of it.
#[derive(Debug, Clone, Copy)]
struct Guide {
    f: f64,
    length: f64,
    offset: f64,
    through: bool,
    a: f64,
    load: [f64; 2],
    at: [f64; 2],
    angle: f64,
    /// The coordinate, and 1 or -1 for the direction.
    here: f64,
    way: f64,
}

impl Guide {
    fn drawn(dice: &mut Dice) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + dice.next());
        Self {
            f: between(0.02, 1.4),
            length: between(0.05, 0.6),
            offset: if between(0.0, 1.0) > 0.5 { between(0.0, 0.1) } else { 0.0 },
            through: between(0.0, 1.0) > 0.5,
            a: between(-0.5, 0.5),
            load: [between(-100.0, 100.0), between(-100.0, 100.0)],
            at: [between(-0.3, 0.3), between(-0.3, 0.3)],
            angle: between(-3.0, 3.0),
            here: between(-0.2, 0.2),
            way: if between(0.0, 1.0) > 0.5 { 1.0 } else { -1.0 },
        }
    }

    fn linkage(&self) -> Linkage {
        let Self { f, length, offset, a, angle, here, .. } = *self;
        let [x, y] = self.load;
        let (size, toward) = (x.hypot(y), y.atan2(x));
        let [at_x, at_y] = self.at;
        scene(&format!(
            r#"
            [ground]
            points = {{ O = 0 }}
            [link.drawer]
            points = {{ K = 0 }}
            [[slide]]
            link = "drawer"
            on = "ground"
            angle = {angle:?}
            [input]
            link = "drawer"
            from = {here:?}
            to = {to:?}
            positions = 2
            direction = "{direction}"
            [[force]]
            link = "drawer"
            at = [{at_x:?}, {at_y:?}]
            frame = "link"
            angle = {toward:?}
            value = {size:?}
            [balance]
            link = "drawer"
            at = [0, {a:?}]
            angle = {angle:?}
            [[friction]]
            pair = "drawer/ground"
            coefficient = {f:?}
            length = {length:?}
            offset = {offset:?}
            middle = "{middle}"
            "#,
            to = here + 0.1,
            direction = if self.way > 0.0 { "ccw" } else { "cw" },
            middle = if self.through { "through" } else { "point" },
        ))
    }

    /// All balancing forces with the coefficient times k, ascending. In the frame of the guide: N = -load across; about the
    /// middle of the contact M = a B - moment of the load + way f h N (+ s N), and B + load along = way f max(|N|, 2 |M| / l).
    fn balancing(&self, k: f64) -> Vec<f64> {
        let f = k * self.f;
        let [along, across] = self.load;
        let normal = -across;
        let shift = if self.through { self.here * normal } else { 0.0 };
        let own = -(self.at[0] * across - self.at[1] * along) + self.way * f * self.offset * normal + shift;
        let pressed = |force: f64| (self.a * force + own) * 2.0 / self.length;
        let mut all = vec![self.way * f * normal.abs() - along];
        all.retain(|force| pressed(*force).abs() <= normal.abs());
        for sign in [1.0, -1.0] {
            // B + along = way f sign (a B + own) 2 / l.
            let factor = self.way * f * sign * 2.0 / self.length;
            let force = (factor * own - along) / (1.0 - factor * self.a);
            let moment = sign * pressed(force);
            if moment > normal.abs() {
                all.push(force);
            }
        }
        all.sort_by(f64::total_cmp);
        all
    }
}

/// All balancing loads that the method finds.
fn found(linkage: &Linkage, coordinate: f64) -> Vec<f64> {
    let loads = Loads::compile(linkage).unwrap();
    let mut forces = Kinetostatics::new(linkage, &loads, find("coulomb").unwrap().instance, &[]);
    let mut position = linkage.position();
    linkage.solve(coordinate, Order::Second, &mut position).unwrap();
    if forces.solve(&LoadState::prescribed(&linkage.mechanism, coordinate), &position).is_err() {
        return Vec::new();
    }
    let doubts = forces.reactions.friction.unwrap().doubts;
    let each = doubts.first().map(|(_, doubt)| doubt.solutions.iter().map(|one| one.balancing).collect());
    each.unwrap_or_else(|| vec![forces.reactions.balancing])
}

#[test]
fn a_guide_has_all_solutions_of_its_cases() {
    let mut dice = Dice(7);
    let mut counts = [0; 4];
    for _ in 0..1500 {
        let guide = Guide::drawn(&mut dice);
        let expected = guide.balancing(1.0);
        let found = found(&guide.linkage(), guide.here);
        assert_eq!(found.len(), expected.len(), "{guide:?}: {found:?} {expected:?}");
        counts[found.len()] += 1;
        let size = expected.iter().fold(100.0_f64, |most, force| most.max(force.abs()));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-10 * size, "{guide:?}: {found} {expected}");
        }
    }
    assert!(counts[0] > 20 && counts[1] > 200 && counts[2] + counts[3] > 20, "{counts:?}");
}

#[test]
fn a_guide_jams_where_its_cases_end() {
    let mut dice = Dice(19);
    let mut checked = 0;
    for _ in 0..1000 {
        let guide = Guide::drawn(&mut dice);
        if !guide.balancing(1.0).is_empty() {
            continue;
        }
        let k = limit(&guide.linkage(), guide.here);
        let below = guide.balancing(k * (1.0 - 1e-9));
        let above = guide.balancing(k * (1.0 + 1e-9));
        assert!(!below.is_empty() && above.is_empty(), "{guide:?}: {k} {below:?} {above:?}");
        checked += 1;
    }
    assert!(checked > 20, "{checked}");
}
