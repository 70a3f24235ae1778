//! Dry friction over the cycle, against closed forms.

use assur_number::search::bisect;

use super::analyzed;

/// A crank whose piston drives it against a moment; friction in the bearing of the crank alone.
fn driven(coefficient: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\n[link.rod]\npoints = {{ A = 0, B = 0.35 }}\n\
         [link.piston]\npoints = {{ B = 0 }}\n[[slide]]\nlink = \"piston\"\non = \"ground\"\n[assembly]\nB = [0.43, 0]\n\
         [input]\nlink = \"crank\"\nfrom = 1\npositions = 4\n[[moment]]\nlink = \"crank\"\nvalue = -5\n\
         [balance]\nlink = \"piston\"\nat = \"B\"\nangle = 0\n\
         [[friction]]\npair = \"O\"\ncoefficient = {coefficient:?}\nradius = 0.02\n"
    )
}

/// The arm of the force of the rod about the crank's bearing.
fn arm(q: f64) -> f64 {
    let rod = (0.1 * q.sin() / 0.35).asin();
    0.1 * (q + rod).sin()
}

#[test]
fn dead_angles_are_where_the_force_of_the_rod_meets_the_circle_of_friction() {
    // The second is far narrower than the distance of two samples.
    for coefficient in [0.3, 1e-5] {
        let circle = 0.02 * coefficient;
        let found = analyzed(&driven(coefficient));
        let cycle = found.friction.as_ref().unwrap();
        let half = std::f64::consts::PI;
        let [outer, _] = bisect(0.0, 1.0, 0.0, |q| arm(q) < circle);
        let [inner, _] = bisect(half, 2.0, 0.0, |q| arm(q) < circle);
        let expected = [[inner, 2.0 * half - inner], [2.0 * half - outer, 2.0 * half + outer]];
        assert_eq!(cycle.dead_angles.len(), 2, "{:?}", cycle.dead_angles);
        for (found, expected) in cycle.dead_angles.iter().zip(expected) {
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-13, "{coefficient}: {found} {expected}");
            }
        }
        assert_eq!(cycle.efficiency, None);
    }
}

/// A wedge of 20 degrees under a load, with friction on its incline; `direction`: lifted or let down.
fn wedge(coefficient: f64, direction: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.wedge]\npoints = {{ W = 0 }}\n[link.block]\npoints = {{ B = 0 }}\n\
         [link.plunger]\npoints = {{ B = 0 }}\n[[slide]]\nlink = \"wedge\"\non = \"ground\"\nangle = \"180 deg\"\n\
         [[slide]]\nlink = \"block\"\non = \"wedge\"\nangle = \"20 deg\"\n[[slide]]\nlink = \"plunger\"\non = \"ground\"\n\
         angle = \"90 deg\"\n[input]\nlink = \"wedge\"\nfrom = 0.1\nto = 0.2\npositions = 3\ndirection = \"{direction}\"\n\
         [[force]]\nlink = \"plunger\"\nat = \"B\"\nangle = \"-90 deg\"\nvalue = 1000\n\
         [[friction]]\npair = \"block/wedge\"\ncoefficient = {coefficient:?}\n"
    )
}

#[test]
fn a_wedge_brakes_itself_from_the_tangent_of_its_angle_on() {
    let angle = 20_f64.to_radians();
    for part in [0.1, 0.5, 1.0 - 1e-9, 1.0 + 1e-9, 1.7] {
        let coefficient = part * angle.tan();
        let friction = f64::atan(coefficient);
        let lifted = analyzed(&wedge(coefficient, "ccw")).friction.unwrap();
        let expected = angle.tan() / (angle + friction).tan();
        assert!((lifted.efficiency.unwrap() - expected).abs() < 1e-12);
        assert!(lifted.self_braking.is_empty());
        let down = analyzed(&wedge(coefficient, "cw")).friction.unwrap();
        let expected = ((angle - friction).tan() / angle.tan()).max(0.0);
        assert!((down.efficiency.unwrap() - expected).abs() < 1e-12, "{part}");
        let whole: &[[f64; 2]] = if part > 1.0 { &[[0.1, 0.2]] } else { &[] };
        assert_eq!(down.self_braking, whole, "{part}");
        // On the way of 0.1 m the load does the work 1000 N 0.1 m tan a; the balancing load takes the rest.
        let work: f64 = down.friction_work.values().map(|work| work.unwrap()).sum();
        let balancing = 1000.0 * (angle - friction).tan() * 0.1;
        assert!((work + 100.0 * angle.tan() - balancing).abs() < 1e-10, "{work}");
    }
}
