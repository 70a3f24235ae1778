//! Planted mistakes next to singular positions of each type, and sound mechanisms there.

use std::sync::Arc;

use assur_force::Loads;
use assur_kinematics::Linkage;

use super::mutants::{Mutant, NONE, SLIPS, Slip};
use super::mutations::{differs, everything, failed};
use super::{checks, hold, scene, show};
use crate::{Check, methods};

const LOADS: &str = "mass = 1.7\ncenter = [0.05, -0.03]\ninertia = 0.03\n";

/// Two links in line at the end of the crank's way: crank 2, ground 3, coupler and rocker 1.5.
fn rrr(distance: f64) -> String {
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0], C = [3, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 2 }}\n\
         [link.coupler]\npoints = {{ A = 0, B = 1.5 }}\n{LOADS}[link.rocker]\npoints = {{ C = 0, B = 1.5 }}\n{LOADS}\
         [input]\nlink = \"crank\"\nfrom = {:?}\npositions = 1\n[assembly]\nB = [2.5, 1.5]\n[motion]\nspeed = 3\n",
        (1.0_f64 / 3.0).acos() - distance
    )
}

/// A rod that is shorter than the crank, across the guide.
fn rrp(distance: f64) -> String {
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 0.2 }}\n\
         [link.rod]\npoints = {{ A = 0, B = 0.15 }}\n{LOADS}[link.slider]\npoints = {{ B = 0 }}\n{LOADS}\
         [[slide]]\nlink = \"slider\"\non = \"ground\"\n\
         [input]\nlink = \"crank\"\nfrom = {:?}\npositions = 1\n[assembly]\nB = [0.3, 0]\n[motion]\nspeed = 3\n",
        0.75_f64.asin() - distance
    )
}

/// The pin of the crank runs past that of the rocker, so close.
fn rpr(distance: f64) -> String {
    // Not quite in line with the crank: there PF2 would pass zero.
    let (s, c) = (0.7 + 0.5 * distance).sin_cos();
    let [x, y] = [c, s].map(|part| 0.2 * (1.0 + distance) * part);
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0, 0], C = [{x:?}, {y:?}] }}\n\
         [link.crank]\npoints = {{ O = 0, A = 0.2 }}\n[link.stone]\npoints = {{ A = 0 }}\n{LOADS}\
         [link.rocker]\npoints = {{ C = 0, D = 0.5 }}\n{LOADS}[[slide]]\nlink = \"stone\"\non = \"rocker\"\n\
         [input]\nlink = \"crank\"\nfrom = 0.7\npositions = 1\n[assembly]\nD = [0.6, 0.5]\n[motion]\nspeed = 3\n"
    )
}

/// Two guides that are so nearly parallel.
fn prp(distance: f64) -> String {
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0.1, -0.3] }}\n[link.crank]\npoints = {{ O = 0 }}\n\
         [link.s1]\npoints = {{ P = [0, 0.01] }}\n{LOADS}[link.s2]\npoints = {{ P = [0.02, -0.015] }}\n{LOADS}\
         [[slide]]\nlink = \"s1\"\non = \"crank\"\nthrough = [0.05, 0.02]\nangle = 0.5\npoint = [0, 0]\ntilt = 0.2\n\
         [[slide]]\nlink = \"s2\"\non = \"ground\"\nthrough = [0.3, 0.1]\nangle = 0.3\npoint = [0, 0]\ntilt = -0.1\n\
         [input]\nlink = \"crank\"\nfrom = {:?}\npositions = 1\n[motion]\nspeed = 3\n",
        -0.2 + distance
    )
}

/// Two guides of one link that are so nearly parallel.
fn rpp(distance: f64) -> String {
    format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = [0.1, -0.3] }}\n[link.crank]\npoints = {{ O = 0, A = 0.2 }}\n\
         [link.s1]\npoints = {{ A = [0, 0.01] }}\n{LOADS}[link.s2]\npoints = {{ E = [0, 0] }}\n{LOADS}\
         [[slide]]\nlink = \"s1\"\non = \"s2\"\nthrough = [0.05, 0.02]\nangle = {distance:?}\npoint = [0, 0]\ntilt = 0.2\n\
         [[slide]]\nlink = \"s2\"\non = \"ground\"\nthrough = [0.3, 0.1]\nangle = 0.3\n\
         [input]\nlink = \"crank\"\nfrom = 0.7\npositions = 1\n[motion]\nspeed = 3\n"
    )
}

type Scene = (&'static str, fn(f64) -> String);

const SCENES: [Scene; 5] = [("RRR", rrr), ("RRP", rrp), ("RPR", rpr), ("PRP", prp), ("RPP", rpp)];

fn one(all: &[Check], name: &str) -> Check {
    all.iter().find(|check| check.name.to_string() == name).unwrap().clone()
}

#[test]
fn sound_results_pass_as_close_as_they_are_calculated() {
    for (kind, text) in SCENES {
        for power in 1..=14 {
            let linkage = scene(&text(0.1_f64.powi(power)));
            let all = checks(&linkage);
            assert!(
                all.iter().all(|check| check.finding.holds == Some(true) || check.finding.holds.is_none()),
                "{kind} 1e-{power}\n{}",
                show(&all)
            );
            // A group whose ways meet keeps half of the digits only.
            let judged = if matches!(kind, "RRR" | "RRP") { 10 } else { 8 };
            assert!(power > judged || hold(&all), "{kind} 1e-{power}\n{}", show(&all));
        }
    }
}

#[test]
fn every_slip_in_a_closed_form_is_caught_next_to_a_singular_position() {
    let mut planted = 0;
    for (kind, text) in SCENES {
        for distance in [1e-2, 1e-4] {
            let sound = scene(&text(distance));
            let loads = Loads::compile(&sound).unwrap();
            // Rounded as the others are: next to a singular position that alone is more than some slips.
            let numbers = everything(&mutant(&sound, NONE, 0), &loads);
            for (victim, slip) in (0..3).flat_map(|victim| SLIPS.map(|slip| (victim, slip))) {
                let linkage = mutant(&sound, slip, victim);
                let found = everything(&linkage, &loads);
                if !differs(&numbers, &found) || is_hidden(&sound, &numbers, &found) {
                    continue;
                }
                let caught = failed(&linkage, &loads, methods(&linkage, None));
                assert!(!caught.is_empty(), "{kind}, {distance:e} away, victim {victim}: {}", slip.name);
                planted += 1;
            }
        }
    }
    assert!(planted > 250, "only {planted} slips had an effect");
}

/// Whether nothing but reactions differ, and by less than the rounding of the largest, which grows to the singular position.
fn is_hidden(sound: &Linkage, numbers: &[f64], found: &[f64]) -> bool {
    let bodies = 10 * sound.structure.links;
    let largest = numbers[bodies..].iter().fold(0.0_f64, |most, number| most.max(number.abs()));
    let off = numbers[bodies..].iter().zip(&found[bodies..]).map(|(a, b)| (a - b).abs());
    numbers[..bodies] == found[..bodies] && off.fold(0.0, f64::max) < 1e-9 * largest
}

fn mutant(sound: &Linkage, slip: Slip, victim: usize) -> Linkage {
    let mut linkage = Linkage::compile(sound.mechanism.clone()).unwrap();
    let groups = &mut Arc::get_mut(&mut linkage.chain).expect("its own chain").groups;
    let kernel = groups.remove(0);
    groups.push(Box::new(Mutant { sound: kernel, slip, victim }));
    linkage
}

fn slip(name: &str) -> Slip {
    *SLIPS.iter().find(|slip| slip.name == name).unwrap()
}

#[test]
fn test_pf_alone_sees_a_millionth_at_a_distance_of_1e_4() {
    for (kind, text) in SCENES {
        let sound = scene(&text(1e-4));
        let turning = matches!(kind, "RRR" | "RRP" | "RPR");
        for (order, name) in [(1, "TestPf PF1"), (2, "TestPf PF2")] {
            let wanted = match (turning, order) {
                (true, 1) => "PF1: w1 longer by 1e-6",
                (true, _) => "PF2: w2 longer by 1e-6",
                (false, 1) => "PF1: y1 longer by 1e-6",
                (false, _) => "PF2: x2 longer by 1e-6",
            };
            // The slider of an RRP does not turn.
            let linkage = mutant(&sound, slip(wanted), usize::from(kind != "RRP"));
            let check = one(&checks(&linkage), name);
            assert!(
                check.finding.holds.is_some() && check.finding.holds != Some(true),
                "{kind}: {wanted}: {check:?}"
            );
        }
    }
}

#[test]
fn limits_grow_towards_the_singular_position() {
    for (kind, text) in &SCENES[..3] {
        let mut before = 0.0;
        for power in 2..=8 {
            let sound = scene(&text(0.1_f64.powi(power)));
            // What fails worst shows its limit, so that the same number is seen at every distance.
            let forgotten = mutant(&sound, slip("PF2: w2 forgotten"), usize::from(*kind != "RRP"));
            let check = one(&checks(&forgotten), "TestPf PF2");
            assert!(
                check.finding.holds != Some(true) && check.finding.bound > 3.0 * before,
                "{kind} 1e-{power}: {check:?} after {before:e}"
            );
            before = check.finding.bound;
        }
    }
}

#[test]
fn a_check_that_can_judge_nothing_says_so() {
    // Of the sine between the guides, 1e-14, rounding leaves no digit.
    let all = checks(&scene(&prp(1e-14)));
    for name in ["TestPf PF1", "TestPf PF2"] {
        let check = one(&all, name);
        assert_eq!(
            (check.finding.holds.is_some(), check.finding.holds == Some(true), check.left_out),
            (false, false, 1),
            "{check:?}"
        );
        assert!(
            check.finding.why.to_string().contains("limit exceeds a tenth") && check.finding.bound > 0.1,
            "{check:?}"
        );
    }
    // Where there are digits, nothing is left out.
    assert!(
        checks(&scene(&prp(1e-6))).iter().all(|check| check.finding.holds.is_some() && check.left_out == 0)
    );
}
