//! Very many loads.

use super::{checks, hold, scene, show};

/// A crank and a rod on a slider, which so many equal springs pull to the pin of the crank.
fn springs(count: usize) -> String {
    let spring = "[[spring]]\nbetween = [\"ground.O\", \"slider.B\"]\nstiffness = 1\n";
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 0.06 }}\nmass = 3\n\
         center = 0.015\ninertia = 0.008\n[link.rod]\npoints = {{ A = 0, B = 0.24 }}\nmass = 1.8\ncenter = 0.08\n\
         inertia = 0.014\n[link.slider]\npoints = {{ B = 0 }}\nmass = 1.1\n[[slide]]\nlink = \"slider\"\non = \"ground\"\n\
         angle = 1.57\n[assembly]\nB = [0, 0.23]\n[input]\nlink = \"crank\"\npositions = 24\n[motion]\nspeed = 9.4\n{}",
        spring.repeat(count)
    )
}

#[test]
fn thousands_of_equal_loads_keep_the_limits_and_few_do_not_widen_them() {
    let limit = |count: usize| {
        let all = checks(&scene(&springs(count)));
        assert!(hold(&all), "{count} springs\n{}", show(&all));
        all.iter().find(|check| check.name.to_string() == "Lagrange-d'Alembert").unwrap().finding.bound
    };
    let few = limit(10);
    assert!(limit(60) < 1.1 * few);
    // Half a unit for each of 5,000 additions in two sums.
    assert!(limit(5000) < 5000.0 / 64.0 * few);
}
