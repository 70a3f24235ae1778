use assur_force::LoadState;

use super::{compile, fixture, solved};
use assur_geometry::{CenterAt, instant_centers};

use crate::{VectorKind, acceleration_plan, velocity_plan};

const PARALLELOGRAM: &str = "[ground]\npoints = { O = 0, C = 0.3 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n\
    [link.rod]\npoints = { A = 0, B = 0.3 }\n[link.rocker]\npoints = { C = 0, B = 0.1 }\n\
    [input]\nlink = 'crank'\nfrom = 1\n[assembly]\nB = [0.354, 0.084]\n";

fn vector<'a>(plan: &'a crate::VectorPlan, name: &str) -> &'a crate::PlanVector {
    plan.items.iter().find(|item| item.name.to_string() == name).unwrap_or_else(|| panic!("{name}"))
}

fn center(linkage: &assur_kinematics::Linkage, q: f64, link: &str, against: &str) -> CenterAt {
    let centers = instant_centers(linkage, &solved(linkage, q));
    centers.into_iter().find(|center| center.link == link && center.against == against).unwrap().at
}

#[test]
fn the_rod_of_a_parallelogram_is_carried_parallel() {
    let linkage = compile(PARALLELOGRAM);
    // The center of the rod lies at infinity along the crank.
    let CenterAt::Direction([x, y]) = center(&linkage, 1.0, "rod", "ground") else { panic!() };
    assert!((x * 1.0_f64.sin() - y * 1.0_f64.cos()).abs() < 1e-12);
    // Crank and rocker turn equally, so that they do not turn against each other.
    let CenterAt::Direction(_) = center(&linkage, 1.0, "rocker", "crank") else { panic!() };
}

#[test]
fn centers_in_pins_are_the_pins() {
    let linkage = compile(&fixture("four-bar"));
    let position = solved(&linkage, 0.7);
    for (pin, link, against) in [
        ("O", "crank", "ground"),
        ("C", "rocker", "ground"),
        ("A", "coupler", "crank"),
        ("B", "rocker", "coupler"),
    ] {
        let id = linkage.mechanism.point(pin).unwrap();
        let at = linkage.point_motion(id, &position).pf0;
        let CenterAt::Point(found) = center(&linkage, 0.7, link, against) else { panic!("{pin}") };
        assert!((found[0] - at[0]).hypot(found[1] - at[1]) < 1e-13, "{pin}");
    }
}

#[test]
fn a_slider_goes_to_infinity_across_its_guide_and_stands_in_its_dead_center() {
    let linkage = compile(&fixture("slider-crank"));
    let CenterAt::Direction([x, y]) = center(&linkage, 0.4, "piston", "ground") else { panic!() };
    assert!((x.abs() - 1.0).abs() < 1e-14 && y.abs() < 1e-14);
    // With the crank up, the rod turns about the piston's pin, at 60 + 240 mm.
    let top = std::f64::consts::FRAC_PI_2;
    let CenterAt::Point([x, y]) = center(&linkage, top, "rod", "ground") else { panic!() };
    assert!(x.abs() < 1e-12 && (y - 0.3).abs() < 1e-12);
    assert_eq!(center(&linkage, top, "piston", "ground"), CenterAt::Everywhere);
}

#[test]
fn a_slider_crank_in_its_dead_center() {
    // r = 0.06, l = 0.24, w = 10, e = 5: at the top the pins are in line; a(B) = -w^2 r (1 + r/l) along y.
    let linkage = compile(&fixture("slider-crank"));
    let position = solved(&linkage, std::f64::consts::FRAC_PI_2);
    let state = LoadState { speed: 10.0, acceleration: 5.0, ..LoadState::default() };
    let v = velocity_plan(&linkage, &position, Some(&state));
    assert_eq!(v.unit, "m/s");
    assert!((vector(&v, "v(A)").end[0] + 0.6).abs() < 1e-14 && vector(&v, "v(B)").size < 1e-14);
    assert!((vector(&v, "v(B/A)").size - 0.6).abs() < 1e-14);
    let a = acceleration_plan(&linkage, &position, Some(&state));
    assert!((vector(&a, "a(B)").end[1] + 100.0 * 0.06 * 1.25).abs() < 1e-12);
    assert!(
        (vector(&a, "an(A/O)").size - 6.0).abs() < 1e-13 && (vector(&a, "at(A/O)").size - 0.3).abs() < 1e-13
    );
    assert!((vector(&a, "an(B/A)").size - 0.6 * 0.6 / 0.24).abs() < 1e-12);
    assert_eq!((a.unit.as_str(), vector(&a, "an(B/A)").kind), ("m/s^2", VectorKind::Normal));
}

#[test]
fn without_a_motion_plans_are_per_unit_speed() {
    let linkage = compile(PARALLELOGRAM);
    let position = solved(&linkage, 1.0);
    let (v, a) = (velocity_plan(&linkage, &position, None), acceleration_plan(&linkage, &position, None));
    assert_eq!((v.unit.as_str(), a.unit.as_str()), ("m/rad", "m/rad^2"));
    assert_eq!(v.title.to_string(), "Plan of velocities for a unit speed of the input (PF1)");
    assert!((vector(&v, "v(B)").size - 0.1).abs() < 1e-12 && vector(&v, "v(B/A)").size < 1e-12);
}

#[test]
fn coriolis_of_a_stone_on_a_turning_guide() {
    // A crank of 0.1 about O turns a guide through C = (0, -0.1). With the crank along x the guide has 45 degrees, |CA| = r sqrt 2,
    // and by the angle in the circle it turns half as fast: w3 = 1/2; the stone goes along the guide with r / sqrt 2 per unit;
    // Coriolis: 2 * 1/2 * r / sqrt 2.
    let scene = "[ground]\npoints = { O = 0, C = [0, -0.1] }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[link.stone]\n\
        points = { A = 0 }\n[link.guide]\npoints = { C = 0 }\n[[slide]]\nlink = 'stone'\non = 'guide'\nthrough = 'C'\n\
        [input]\nlink = 'crank'\nto = 1\n";
    let linkage = compile(scene);
    let position = solved(&linkage, 0.0);
    let a = acceleration_plan(&linkage, &position, None);
    let v = velocity_plan(&linkage, &position, None);
    let half = 0.1 / 2.0_f64.sqrt();
    assert!((vector(&v, "v(A/A on guide)").size - half).abs() < 1e-14);
    assert!((vector(&v, "v(A on guide)").size - half).abs() < 1e-14);
    assert!((vector(&a, "ac(A/A on guide)").size - half).abs() < 1e-14);
}
