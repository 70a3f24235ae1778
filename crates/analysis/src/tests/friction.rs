//! Motions with dry friction: what is lost, what is not determined at rest, and checks that notice another friction.

use assur_force::Loads;

use crate::results::{Analysis, Column, Owner, Quantity};
use crate::{Calculation, Coverage, unwatched};

use super::{analyzed, study};

const CRANK: &str = "gravity = 9.81\n[ground]\npoints = { O = [0, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 0.1 }\nmass = 3\ncenter = \"A\"\ninertia = 0.08\n\
    [link.rod]\npoints = { A = 0, B = 0.35 }\nmass = 1.2\ncenter = [0.14, 0]\ninertia = 0.012\n\
    [link.piston]\npoints = { B = [0, 0] }\nmass = 2\n\
    [[slide]]\nlink = \"piston\"\non = \"ground\"\nthrough = \"O\"\npoint = \"B\"\nname = \"cylinder\"\n\
    [input]\nlink = \"crank\"\nfrom = \"30 deg\"\npositions = 12\n[assembly]\nB = [0.4, 0]\n";

fn scene(motion: &str, coefficient: f64) -> String {
    format!(
        "{CRANK}{motion}[[friction]]\npair = \"A\"\ncoefficient = {coefficient}\nradius = 0.02\n\
         [[friction]]\npair = \"cylinder\"\ncoefficient = {coefficient}\nlength = 0.08\n"
    )
}

const DOWN: &str = "[motion]\nkind = \"transient\"\nspeed = 12\nuntil = \"0.6 s\"\nsamples = 16\n";
const STEADY: &str = "[motion]\nkind = \"steady\"\nmean_speed = 12\n[drive]\ntorque = \"balance\"\nflywheel = 0.5\n\
    [[force]]\nlink = \"piston\"\nat = \"B\"\nagainst_motion = true\nvalue = 300\n";

fn energy(found: &Analysis, row: usize, quantity: Quantity) -> f64 {
    found.trajectory.get(row, Column::of(quantity, Owner::Input)).unwrap()
}

/// At the start and at each sample the kinetic energy and that of the place of the links give what was lost.
#[test]
fn what_friction_takes_is_what_the_energies_lose() {
    let found = analyzed(&scene(DOWN, 0.1));
    // The centers of mass of crank and rod; the piston stays on its level.
    let place = |row: usize| {
        let height = 0.1 * found.trajectory.get(row, Column::COORDINATE).unwrap().sin();
        9.81 * height * (3.0 + 1.2 * (1.0 - 0.14 / 0.35))
    };
    let start = energy(&found, 0, Quantity::KineticEnergy) + place(0);
    let mut before = 0.0;
    for row in 0..found.trajectory.len() {
        let lost = energy(&found, row, Quantity::FrictionWork);
        let left = energy(&found, row, Quantity::KineticEnergy) + place(row);
        assert!((left - start - lost).abs() < 1e-6 * start, "{row}: {lost} {}", left - start);
        assert!(lost <= before, "{row}: {lost} {before}");
        before = lost;
    }
    assert!(before < -1.0, "{before}");
}

/// A block thrown up an incline: friction takes its share up and down, though it turns back between two samples.
#[test]
fn a_block_that_turns_back_loses_what_it_slid() {
    let (f, speed, time) = (0.2, 3.0, 3.0);
    let found = analyzed(&format!(
        "gravity = 10\n[ground]\npoints = {{ O = 0 }}\n[link.block]\npoints = {{ P = 0 }}\nmass = 2\n\
         [[slide]]\nlink = \"block\"\non = \"ground\"\nangle = \"30 deg\"\n\
         [input]\nlink = \"block\"\nto = 5\npositions = 2\n\
         [motion]\nkind = \"transient\"\nspeed = {speed}\nuntil = \"{time} s\"\nsamples = 7\n\
         [[friction]]\npair = \"block/ground\"\ncoefficient = {f}\n"
    ));
    let (s, c) = (0.5, 0.75_f64.sqrt());
    let [up, down] = [10.0 * (s + f * c), 10.0 * (s - f * c)];
    let way = 0.5 * speed * speed / up + 0.5 * down * (time - speed / up).powi(2);
    let lost = energy(&found, 7, Quantity::FrictionWork);
    assert!((lost / (-f * 20.0 * c * way) - 1.0).abs() < 1e-12, "{lost}");
}

#[test]
fn at_rest_friction_and_what_depends_on_it_are_not_known() {
    let found = analyzed(
        "gravity = 9.81\n[ground]\npoints = { O = [0, 0] }\n[link.block]\npoints = { P = 0 }\nmass = 2\n\
         [[slide]]\nlink = \"block\"\non = \"ground\"\nthrough = \"O\"\nname = \"guide\"\n\
         [input]\nlink = \"block\"\nto = 1\npositions = 2\n\
         [motion]\nkind = \"transient\"\nspeed = 3\nuntil = \"3 s\"\nsamples = 4\n\
         [[friction]]\npair = \"guide\"\ncoefficient = 0.3\n",
    );
    let table = &found.trajectory;
    let rows = [1, 4].map(|row| {
        let of = |quantity| {
            let owner = table.schema().owners(quantity)[0];
            table.get(row, Column::of(quantity, owner))
        };
        [Quantity::FrictionForce, Quantity::FrictionPower].map(of)
    });
    let speed = 3.0 - 0.3 * 9.81 * 0.75;
    let near = |found: Option<f64>, wanted: f64| (found.unwrap() - wanted).abs() < 1e-12;
    assert!(near(rows[0][0], -0.6 * 9.81) && near(rows[0][1], -0.6 * 9.81 * speed), "{rows:?}");
    assert_eq!(rows[1], [None, Some(0.0)]);
    assert_eq!(table.get(4, Column::BALANCING), None);
    assert!((energy(&found, 4, Quantity::FrictionWork) + 9.0).abs() < 1e-12);
    let failed: Vec<_> = found.checks.iter().filter(|check| check.finding.failed()).collect();
    assert!(failed.is_empty(), "{failed:?}");
}

#[test]
fn the_works_of_a_cycle_are_the_losses_of_its_pairs() {
    let found = analyzed(&scene(STEADY, 0.1));
    let lost: f64 = found.friction.as_ref().unwrap().friction_work.values().map(|work| work.unwrap()).sum();
    let last = found.trajectory.len() - 1;
    let [drives, resists, dissipated] =
        [Quantity::DrivingWork, Quantity::ResistingWork, Quantity::FrictionWork]
            .map(|quantity| energy(&found, last, quantity));
    assert!((dissipated - lost).abs() < 1e-5 * lost.abs(), "{dissipated} {lost}");
    assert!((drives + resists + dissipated).abs() < 1e-9 * drives, "{drives} {resists} {dissipated}");
    // Over four strokes the force takes 300 N, the weights nothing.
    let torque = found.dynamics.as_ref().unwrap().figures.torque.unwrap();
    assert!(
        (torque * std::f64::consts::TAU - 4.0 * 0.1 * 300.0 + lost).abs() < 1e-5 * lost.abs(),
        "{torque}"
    );
}

/// The checks that fail for a motion with the friction of other coefficients.
fn failing(motion: &str, factor: f64) -> Vec<String> {
    let mut calculation: Calculation = study(&scene(motion, 0.1)).unwrap();
    let other = study(&scene(motion, 0.1 * factor)).unwrap();
    calculation.loads = Some(Loads::compile(&other.linkage).unwrap());
    let found = calculation.checks(Coverage::All, &mut unwatched).unwrap();
    found.all.iter().filter(|check| check.finding.failed()).map(|check| check.name.to_string()).collect()
}

#[test]
fn a_motion_with_another_friction_is_noticed() {
    for (motion, name) in [(DOWN, "drive against force analysis"), (STEADY, "cycle in time")] {
        assert_eq!(failing(motion, 1.0), [""; 0], "{name}");
        let found = failing(motion, 1.0 + 1e-3);
        assert!(found.iter().any(|failed| failed == name), "{found:?}");
    }
}

/// A block on a spring, which each half swing takes twice the same from its amplitude, until it stays: how seldom it is looked at
/// changes nothing in what friction takes.
#[test]
fn a_block_that_turns_back_often_between_two_samples_loses_what_it_slid() {
    let (f, stiffness, start) = (0.1, 800.0, 0.1);
    // Friction of 2 N and a spring of 800 N/m: 5 mm are taken from the amplitude by each half swing; it stays within 2.5 mm.
    let shift = f * 20.0 / stiffness;
    let (mut amplitude, mut way) = (start, 0.0);
    while amplitude > shift {
        way += 2.0 * (amplitude - shift);
        amplitude -= 2.0 * shift;
    }
    for samples in [2, 3, 8, 60] {
        let found = analyzed(&format!(
            "gravity = 10\n[ground]\npoints = {{ W = [-1, 0] }}\n[link.block]\npoints = {{ P = 0 }}\nmass = 2\n\
             [[slide]]\nlink = \"block\"\non = \"ground\"\n\
             [[spring]]\nbetween = [\"ground.W\", \"block.P\"]\nstiffness = {stiffness}\nlength = 1\n\
             [input]\nlink = \"block\"\nfrom = {start}\nto = -0.1\npositions = 2\n\
             [motion]\nkind = \"transient\"\nspeed = 0\nuntil = \"4 s\"\nsamples = {samples}\n\
             [[friction]]\npair = \"block/ground\"\ncoefficient = {f}\n"
        ));
        let lost = energy(&found, samples, Quantity::FrictionWork);
        assert!((lost / (-f * 20.0 * way) - 1.0).abs() < 1e-9, "{samples}: {lost} for {way}");
    }
}
