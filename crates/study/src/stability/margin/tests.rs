//! Against closed forms of the limits.

use super::Margin;
use crate::stability::tests::studied;

/// A slider-crank with crank, rod and offset, m.
fn slider_crank(crank: f64, rod: f64, offset: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank:?} }}\n\
         [link.rod]\npoints = {{ A = 0, B = {rod:?} }}\n[link.slider]\npoints = {{ B = 0 }}\n\
         [[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = [0, {offset:?}]\n\
         [input]\nlink = \"crank\"\nfrom = 0.3\n"
    )
}

/// A four-bar with its ground pivots at (0, 0) and `c`, m.
fn four_bar(c: [f64; 2], crank: f64, coupler: f64, rocker: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0], C = {c:?} }}\n[link.crank]\npoints = {{ O = 0, A = {crank:?} }}\n\
         [link.coupler]\npoints = {{ A = 0, B = {coupler:?} }}\n[link.rocker]\npoints = {{ C = 0, B = {rocker:?} }}\n\
         [input]\nlink = \"crank\"\n"
    )
}

fn margins(text: &str) -> Vec<Margin> {
    studied(assur_scene::read("scene.toml", text).unwrap()).unwrap().lengths
}

/// The increase and the decrease of the length that begins so are these, to 1e-12 of the size (1 m).
fn check(found: &[Margin], start: &str, increase: Option<f64>, decrease: Option<f64>) {
    let margin = found.iter().find(|margin| margin.length.to_string().starts_with(start)).unwrap();
    for (found, wanted) in [(margin.increase, increase), (margin.decrease, decrease)] {
        match (found, wanted) {
            (Some(found), Some(wanted)) => assert!((found - wanted).abs() < 1e-12, "{wanted}: {margin:?}"),
            (found, wanted) => assert_eq!(found, wanted, "{margin:?}"),
        }
    }
}

/// The rod reaches the guide all over while rod >= crank + |offset|.
#[test]
fn slider_crank_breaks_where_rod_is_crank_and_offset() {
    let found = margins(&slider_crank(0.06, 0.24, 0.0));
    check(&found, "crank", Some(0.18), None);
    check(&found, "rod", None, Some(0.18));
    check(&found, "slider", Some(0.18), Some(0.18));
    let rod = found.iter().find(|margin| margin.length.to_string().starts_with("rod")).unwrap();
    assert!((rod.increase_searched - 24.0).abs() < 1e-12);
    let found = margins(&slider_crank(0.0613, 0.2471, 0.0391));
    check(&found, "crank", Some(0.2471 - 0.0391 - 0.0613), None);
    check(&found, "rod", None, Some(0.2471 - 0.0391 - 0.0613));
    check(&found, "slider", Some(0.2471 - 0.0391 - 0.0613), Some(0.2471 + 0.0391 - 0.0613));
}

/// The crank turns fully while ground + crank <= coupler + rocker and |ground - crank| >= |coupler - rocker|.
#[test]
fn four_bar_breaks_where_grashof_says() {
    let found = margins(&four_bar([0.4, 0.0], 0.1, 0.35, 0.25));
    check(&found, "crank", Some(0.1), None);
    check(&found, "ground", Some(0.1), Some(0.2));
    check(&found, "coupler", Some(0.2), Some(0.1));
    check(&found, "rocker", Some(0.4), Some(0.1));
    // The ground at an angle: the coordinates of the limits lie between those of any grid.
    let (x, y) = (0.32_f64, -0.04_f64);
    let ground = x.hypot(y);
    let found = margins(&four_bar([x, y], 0.09, 0.28, 0.21));
    let sum = 0.28 + 0.21 - ground - 0.09;
    check(&found, "crank", Some(sum), None);
    check(&found, "ground", Some(sum), Some(ground - 0.09 - 0.07));
    check(&found, "coupler", Some(ground - 0.09 - 0.07), Some(sum));
}

/// Coupler and rocker differ by 2 mm: a crank longer than 398 mm breaks, one longer than 402 mm doesn't.
#[test]
fn a_narrow_band_of_lengths_that_break_is_found() {
    let found = margins(&four_bar([0.4, 0.0], 0.1, 0.7, 0.702));
    check(&found, "crank", Some(0.298), None);
    check(&found, "ground", Some(0.902), Some(0.298));
    // A drag link: the shortest is the ground.
    let found = margins(&four_bar([0.1, 0.0], 0.4, 0.7, 0.702));
    check(&found, "crank", Some(0.902), Some(0.298));
}

/// 0.2 + 0.4 = 0.35 + 0.25: any longer crank breaks, and any shorter one turns.
#[test]
fn the_margin_of_a_change_point_is_zero() {
    let found = margins(&four_bar([0.4, 0.0], 0.2, 0.35, 0.25));
    check(&found, "crank", Some(0.0), None);
    check(&found, "coupler", Some(0.1), Some(0.0));
}

/// A stone on a guide of the rocker that passes its pivot C at a distance: the crank pin must stay outside the circle that
/// the guide touches.
#[test]
fn an_inverted_slider_crank_breaks_where_its_pin_meets_the_circle_of_the_guide() {
    let found = margins(
        "[ground]\npoints = { O = [0, 0], C = [0.31, 0.17] }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n\
         [link.stone]\npoints = { A = 0 }\n[link.rocker]\npoints = { C = 0 }\n\
         [[slide]]\nlink = \"stone\"\non = \"rocker\"\nthrough = [0, 0.05]\n[input]\nlink = \"crank\"\n",
    );
    let ground = 0.31_f64.hypot(0.17);
    let left = ground - 0.1 - 0.05;
    check(&found, "crank", Some(left), None);
    check(&found, "ground", None, Some(left));
    check(&found, "stone", Some(left), Some(ground - 0.1 + 0.05));
}

/// An ideal parallelogram turns a second crank as its own; behind it the slider-crank has its own limits.
#[test]
fn behind_a_parallelogram_the_limits_are_those_of_what_follows() {
    let found = margins(
        "[ground]\npoints = { O = [0, 0], C = [0.5, 0] }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n\
         [link.coupler]\npoints = { A = 0, B = 0.5 }\n[link.second]\npoints = { C = 0, B = 0.1 }\n\
         [link.rod]\npoints = { B = 0, D = 0.3 }\n[link.piston]\npoints = { D = 0 }\n\
         [[slide]]\nlink = \"piston\"\non = \"ground\"\n[input]\nlink = \"crank\"\nfrom = 1\n\
         [assembly]\nB = [0.554, 0.084]\nD = [0.84, 0]\n",
    );
    check(&found, "rod", None, Some(0.2));
    check(&found, "piston", Some(0.2), Some(0.2));
    check(&found, "crank", Some(0.0), None);
}

/// The size of a mechanism does not count.
#[test]
fn margins_scale_with_the_mechanism() {
    for unit in [1e-6, 1e3] {
        let found = margins(&four_bar([0.4 * unit, 0.0], 0.1 * unit, 0.35 * unit, 0.25 * unit));
        let margin = found.iter().find(|margin| margin.length.to_string().starts_with("rocker")).unwrap();
        assert!((margin.increase.unwrap() / unit - 0.4).abs() < 1e-12, "{unit}: {margin:?}");
        assert!((margin.decrease.unwrap() / unit - 0.1).abs() < 1e-12, "{unit}: {margin:?}");
    }
}

/// A bar through a sleeve on the crank pin, the line through its point T at 33 degrees to the bar: a longer bar carries the
/// line away from the pivot C. The crank pin A must stay outside the circle about C that a line at A's distance from the
/// guide touches.
#[test]
fn a_guide_through_a_joint_moves_with_it() {
    let found = margins(
        "[ground]\npoints = { O = [0, 0], C = [0.3, -0.1] }\n[link.crank]\npoints = { O = 0, A = 0.08 }\n\
         [link.bar]\npoints = { C = 0, T = 0.4 }\n[link.sleeve]\npoints = { A = [0.01, 0.02] }\n\
         [[slide]]\nlink = \"bar\"\non = \"sleeve\"\nthrough = [0, 0.03]\nangle = \"12 deg\"\npoint = \"T\"\ntilt = \"-33 deg\"\n\
         [link.rod]\npoints = { T = 0, H = 0.35 }\n[link.yoke]\npoints = { H = [0, 0.02] }\n\
         [[slide]]\nlink = \"yoke\"\non = \"ground\"\nthrough = [0, -0.3]\nangle = \"3 deg\"\n[input]\nlink = \"crank\"\n",
    );
    let (s, c) = 12.0_f64.to_radians().sin_cos();
    // From A to the guide, both in the frame of the sleeve.
    let apart = 0.01 * s + (0.03 - 0.02) * c;
    let longest = (0.3_f64.hypot(0.1) - 0.08 - apart) / 33.0_f64.to_radians().sin();
    check(&found, "bar: C to T", Some(longest - 0.4), None);
    assert!((longest - 0.4 - 0.012).abs() < 1e-4, "{longest}");
}

/// A second guide is passive: crank and rod may change as with one guide, the guides not at all.
#[test]
fn a_passive_guide_takes_no_margin_from_other_lengths() {
    let second = "B = 0, R = 0.1 }\n[[slide]]\nname = \"rear\"\npoint = \"R\"\nlink = \"slider\"\non = \"ground\"\n[[slide]]";
    let found = margins(&slider_crank(0.06, 0.24, 0.0).replace("B = 0 }\n[[slide]]", second));
    check(&found, "crank", Some(0.18), None);
    check(&found, "rod", None, Some(0.18));
    check(&found, "rear", Some(0.0), Some(0.0));
    check(&found, "slider", Some(0.0), Some(0.0));
}

/// Numbers between 0 and 1 (a linear congruence).
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 53) as f64
}

/// Wherever the cycle begins, also a little before, at and after the coordinate at which the limit is met.
#[test]
fn limits_do_not_depend_on_where_the_cycle_begins() {
    use std::f64::consts::{FRAC_PI_2, TAU};
    let mut seed = 5;
    for trial in 0..24 {
        let mut between = |low: f64, high: f64| low + (high - low) * random(&mut seed);
        let (crank, offset, over) = (between(0.05, 0.2), between(-0.1, 0.1), between(0.01, 0.3));
        let rod = crank + offset.abs() + over;
        // The crank stands across the guide there.
        let across = -FRAC_PI_2.copysign(offset);
        let near = across + between(-1.0, 1.0) * TAU / 180.0;
        let from = [near, across, between(-4.0, 4.0)][trial % 3];
        let clockwise = if trial % 2 == 0 { "" } else { "direction = \"cw\"\n" };
        let text = slider_crank(crank, rod, offset)
            .replace("from = 0.3\n", &format!("from = {from:?}\n{clockwise}"));
        let found = margins(&text);
        let left = rod - crank - offset.abs();
        check(&found, "rod", None, Some(left));
        check(&found, "crank", Some(left), None);

        let (x, y) = (between(0.2, 0.4), between(-0.2, 0.2));
        let ground = x.hypot(y);
        let crank = between(0.2, 0.5) * ground;
        let (coupler, rocker) = (ground + between(-0.3, 0.3) * crank, ground + between(-0.3, 0.3) * crank);
        let sum = coupler + rocker - ground - crank;
        let difference = ground - crank - (coupler - rocker).abs();
        // Crank and ground in line.
        let near = y.atan2(x) + between(-1.0, 1.0) * TAU / 180.0;
        let from = [near, between(-4.0, 4.0)][trial % 2];
        let text = four_bar([x, y], crank, coupler, rocker) + &format!("from = {from:?}\n");
        let found = margins(&text);
        check(&found, "crank", Some(sum.min(difference)), None);
        let shorter = if coupler < rocker { "coupler" } else { "rocker" };
        let margin = found.iter().find(|margin| margin.length.to_string().starts_with(shorter)).unwrap();
        assert!((margin.decrease.unwrap() - sum.min(difference)).abs() < 1e-12, "{margin:?}");
    }
}

/// A guide at 1.5873 rad whose limit is met at 0.0165 rad, beside the first position.
#[test]
fn the_limit_at_the_seam_of_the_cycle_is_found() {
    let (through, angle) = ([-0.1994_f64, 0.2294], 1.5873_f64);
    let left = 0.627 - 0.1211 - (angle.cos() * through[1] - angle.sin() * through[0]).abs();
    assert!((left - 0.310_312_925_567_150_5).abs() < 1e-15);
    for from in [0.0, 0.002, 0.005, 0.0165, 0.03, 3.0] {
        let found = margins(&format!(
            "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 0.1211 }}\n\
             [link.rod]\npoints = {{ A = 0, B = 0.627 }}\n[link.slider]\npoints = {{ B = 0 }}\n\
             [[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = {through:?}\nangle = {angle:?}\npoint = \"B\"\n\
             [input]\nlink = \"crank\"\nfrom = {from:?}\n[assembly]\nB = [-0.2045, 0.5359]\n"
        ));
        check(&found, "rod", None, Some(left));
        check(&found, "crank", Some(left), None);
        let offset = found.iter().find(|margin| margin.length.to_string().starts_with("slider")).unwrap();
        assert!((offset.least().unwrap() - left).abs() < 1e-12, "{from}: {offset:?}");
    }
}
