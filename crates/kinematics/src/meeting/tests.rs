//! Mechanisms at, beside and past a meeting of two ways. Values with more than 15 digits: 50 digits, Newton on the
//! closure equations of the decimal lengths, PF1 and PF2 by their linear systems.

use std::f64::consts::{FRAC_PI_2, PI};

use assur_all as _;
use assur_group::{GroupError, Order};

use crate::{Linkage, ScalarMotion, continuous_angle};

fn compiled(text: &str) -> Linkage {
    Linkage::compile(assur_scene::read("meeting", text).unwrap()).unwrap()
}

/// Crank, rod, rocker and ground of these lengths; B near this place at the angle `from`.
fn four_bar([crank, rod, rocker, ground]: [&str; 4], from: f64, b: [f64; 2]) -> Linkage {
    compiled(&format!(
        "[ground]\npoints = {{ O = 0, C = {ground} }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
         [link.rod]\npoints = {{ A = 0, B = {rod} }}\n[link.rocker]\npoints = {{ C = 0, B = {rocker} }}\n\
         [input]\nlink = \"crank\"\nfrom = {from:?}\n[assembly]\nB = [{:?}, {:?}]\n",
        b[0], b[1]
    ))
}

/// A crank 0.3 and, at (0, -distance), a rocker on which the stone of the crank slides, its pin `e` beside the guide.
fn shaper(distance: &str, e: &str) -> Linkage {
    compiled(&format!(
        "[ground]\npoints = {{ O = 0, C = [0, -{distance}] }}\n[link.crank]\npoints = {{ O = 0, A = 0.3 }}\n\
         [link.stone]\npoints = {{ A = [0, {e}] }}\n[link.rocker]\npoints = {{ C = 0 }}\n\
         [[slide]]\nlink = \"stone\"\non = \"rocker\"\npoint = [0, 0]\n[input]\nlink = \"crank\"\nfrom = 0.2\n"
    ))
}

fn motion(linkage: &Linkage, link: usize, q: f64) -> ScalarMotion {
    let mut position = linkage.position();
    linkage.solve(q, Order::Second, &mut position).unwrap();
    linkage.link_motion(link, &position)
}

fn near(found: f64, wanted: f64, limit: f64) {
    assert!((found - wanted).abs() <= limit, "{found:?} instead of {wanted:?}");
}

const ROD: usize = 2;
const ROCKER: usize = 3;

#[test]
fn a_stone_that_misses_the_pivot_takes_the_rocker_round() {
    // The rocker points at the stone, always: with the pivot within the circle of the crank it turns fully, outside it
    // swings. Only where the stone meets the pivot does it go straight on.
    for distance in ["0.300001", "0.300000001", "0.300000000001", "0.299999999", "0.2999999999999"] {
        let linkage = shaper(distance, "0");
        assert!(linkage.change_points().count() == 0, "{distance}");
        let d: f64 = distance.parse().unwrap();
        for q in [0.2, 3.0, 4.7, 4.72, 6.0] {
            let wanted = (0.3 * f64::sin(q) + d).atan2(0.3 * f64::cos(q));
            let found = motion(&linkage, ROCKER, q).pf0;
            near(continuous_angle(found, wanted), wanted, 1e-12);
        }
    }
    let linkage = shaper("0.3", "0");
    // One in a turn; the rocker makes half of one, so that its motion repeats after two.
    assert_eq!(linkage.change_points().count(), 2);
    for q in [0.2, 4.7, 4.72, 6.0] {
        // The angle at the circumference is half of that at the center.
        let wanted = 0.5 * q + 0.5 * FRAC_PI_2;
        let found = motion(&linkage, ROCKER, q);
        near(continuous_angle(found.pf0, wanted), wanted, 1e-14);
        near(found.pf1, 0.5, 1e-12);
    }
}

#[test]
fn a_narrow_gap_ends_the_range() {
    for ground in ["0.700001", "0.700000001", "0.700000000001", "0.70000000000001"] {
        let linkage = four_bar(["0.1", "0.3", "0.5", ground], 0.2, [0.3, 0.2]);
        let mut position = linkage.position();
        let error = linkage.solve(PI, Order::Second, &mut position).unwrap_err();
        let excess = ground.parse::<f64>().unwrap() - 0.7;
        let GroupError::NoAssembly { gap_m } = error.source else { panic!("{error}") };
        near(gap_m, excess, 3e-16);
        // |AC| = 0.8 there: cos(pi - q) = (0.8² - 0.1² - g²) / (2 0.1 g), to the first order 1 - 8 excess/0.7.
        let [low, high] = error.range.unwrap();
        let square = 16.0 * excess / 0.7;
        // 8 units in the last place of a length are not a gap: the ends lie so much nearer.
        let limit = 0.02 * square + 16.0 * 8.0 * f64::EPSILON / 0.7;
        near((PI - high) * (PI - high), square, limit);
        near((low + PI) * (low + PI), square, limit);
    }
}

#[test]
fn what_lies_behind_a_narrow_gap_is_told() {
    // The crank is longer than the rod by so little, and the slider in line with its pivot: past 90 degrees it can't go.
    for crank in ["0.200001", "0.200000001", "0.200000000001", "0.20000000000001"] {
        let linkage = compiled(&format!(
            "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
             [link.rod]\npoints = {{ A = 0, B = 0.2 }}\n[link.slider]\npoints = {{ B = 0 }}\n\
             [[slide]]\nlink = \"slider\"\non = \"ground\"\n[input]\nlink = \"crank\"\nfrom = 0.2\n"
        ));
        assert_eq!(linkage.barrier(-1.5), None);
        let (end, failure) = linkage.barrier(PI).unwrap();
        let GroupError::NoAssembly { gap_m } = failure.source else { panic!("{failure:?}") };
        let excess = crank.parse::<f64>().unwrap() - 0.2;
        // The way is looked at in some places only, not where it is worst.
        assert!(gap_m > 0.3 * excess && gap_m < excess + 3e-16, "{gap_m}");
        // 0.2 = crank sin(end).
        near(FRAC_PI_2 - end, (10.0 * excess).sqrt(), 0.2 * (10.0 * excess).sqrt());
    }
    let stone = shaper("0.3", "1e-9");
    let mut position = stone.position();
    let error = stone.solve(1.5 * PI, Order::First, &mut position).unwrap_err();
    assert!(matches!(error.source, GroupError::NoAssembly { .. }), "{error}");
    assert!(stone.barrier(5.0).is_some());
}

#[test]
fn ways_that_part_again_are_kept() {
    for ground in ["0.699999", "0.699999999", "0.699999999999", "0.69999999999999"] {
        let linkage = four_bar(["0.1", "0.3", "0.5", ground], 0.2, [0.3, 0.2]);
        assert!(linkage.change_points().count() == 0, "{ground}");
        // B stays on its side of the line from A to C, so that the rod never turns below the rocker's way.
        for q in [0.2, 3.0, 3.3, 6.0] {
            let (rod, rocker) = (motion(&linkage, ROD, q).pf0, motion(&linkage, ROCKER, q).pf0);
            assert!((rocker - rod).sin() > 0.0, "{ground} at {q}");
        }
    }
}

/// Expected: two circles in 80 digits, lengths and coordinate as they are written, derivatives by differences of 1e-14.
#[test]
fn close_to_a_change_point_the_motion_keeps_its_digits() {
    let q = 3.141_592_5;
    let linkage =
        four_bar(["0.1", "0.3", "0.5", "0.7"], q, [0.200_000_000_000_000_86, 2.927_220_019_575_937e-8]);
    assert_eq!(linkage.change_points().count(), 2);
    let (rod, rocker) = (motion(&linkage, ROD, q), motion(&linkage, ROCKER, q));
    near(rod.pf0, 4.637_740_290_637_724e-8, 1e-15);
    near(rod.pf1, -0.301_956_281_914_983_8, 1e-11);
    near(rod.pf2, 6.724_634_677_361_461e-9, 1e-8);
    near(rocker.pf0, 3.141_592_595_045_392_8, 2e-15);
    near(rocker.pf1, 0.381_173_769_148_988_4, 1e-11);
    near(rocker.pf2, 2.071_420_845_041_431_6e-8, 1e-8);
}

#[test]
fn an_exact_change_point_is_crossed_to_the_last_place() {
    // Lengths that are no fractions: the parallelogram meets exactly, and its motion is known at any distance.
    let linkage = four_bar(["2", "5", "2", "5"], 1.0, [6.0, 1.7]);
    for off in [0.0, 1e-12, -1e-9, 1e-7, -1e-5, 1e-3, -0.01, 0.0124] {
        for center in [0.0, PI] {
            let (rod, rocker) = (motion(&linkage, ROD, center + off), motion(&linkage, ROCKER, center + off));
            near(rod.pf0, 0.0, 2e-15);
            near(continuous_angle(rocker.pf0, center + off), center + off, 2e-15);
            near(rod.pf1, 0.0, 1e-14);
            near(rocker.pf1, 1.0, 1e-14);
            near(rod.pf2, 0.0, 1e-13);
            near(rocker.pf2, 0.0, 1e-13);
        }
    }
}

#[test]
fn a_first_position_in_or_beside_a_change_point_is_followed_both_ways() {
    // Kite: at 0 the pin A lies on C, and the equal links upon each other. It does not turn fully.
    for from in [0.0, 1e-5, -1e-5, 1e-8] {
        let b = [0.5 + 0.3 * f64::cos(4.0 / 3.0 * from), 0.3 * f64::sin(4.0 / 3.0 * from)];
        let linkage = four_bar(["0.5", "0.3", "0.3", "0.5"], from, b);
        assert_eq!(linkage.change_points().count(), 1, "from {from}");
        // In position 1e-5, whatever the first one is: 1e-8 tells the ways apart by 1e-8 of a length.
        near(motion(&linkage, ROCKER, 1e-5).pf0, 1.333_333_333_339_506_1e-5, 1e-15);
        near(motion(&linkage, ROCKER, 1e-5).pf1, 1.333_333_333_351_852, 1e-12);
        // Smooth through 0: equal angles on both sides of it, measured from the angle in it.
        let at = |q: f64| motion(&linkage, ROCKER, q);
        let middle = at(0.0).pf0;
        for q in [1e-3, 0.1, 0.4] {
            let [above, below] = [q, -q].map(|q| continuous_angle(at(q).pf0, middle) - middle);
            near(above, -below, 1e-11);
        }
    }
}
