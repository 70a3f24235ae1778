//! Works and energies of motions, against closed forms.

use std::f64::consts::PI;

use crate::results::{Analysis, Column, Owner, Quantity};

use super::{analyzed, text};

/// Driving work, resisting work and kinetic energy at the last sample.
fn last(found: &Analysis) -> [f64; 3] {
    let table = &found.trajectory;
    [Quantity::DrivingWork, Quantity::ResistingWork, Quantity::KineticEnergy]
        .map(|quantity| table.get(table.len() - 1, Column::of(quantity, Owner::Input)).unwrap())
}

fn assert_energies(found: &Analysis, wanted: [f64; 3], tolerance: f64) {
    let last = last(found);
    for (found, wanted) in last.iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance * wanted.abs().max(1.0), "{last:?}: {found} {wanted}");
    }
}

#[test]
fn e1_drives_with_150_pi_and_resists_with_100_pi() {
    assert_energies(&analyzed(&text("run-up")), [150.0 * PI, -100.0 * PI, 50.0 * PI], 1e-8);
}

#[test]
fn d1_brakes_all_energy_away() {
    assert_energies(&analyzed(&text("brake")), [0.0, -2000.0, 0.0], 1e-8);
}

/// A resistance that jumps from 5 to 15 N m in the middle of a sample, along a falling coordinate.
#[test]
fn a_jump_between_samples_is_seen() {
    let scene = text("run-up")
        .replace("value = -10", "value = { over = \"angle\", table = [[-100, 15], [-1.23456, 15], [-1.23456, 5], [0, 5]], repeat = false }")
        .replace("value = { over = \"angle\", table = [[0, 30], [\"5 rev\", 0]], repeat = false }", "value = -30")
        .replace("until = \"5 rev\"", "until = \"0.5 rev\"\nsamples = 7")
        .replace("link = \"AB\"\n\n[motion]", "link = \"AB\"\ndirection = \"cw\"\n\n[motion]");
    let resisting = -5.0 * 1.23456 - 15.0 * (PI - 1.23456);
    assert_energies(&analyzed(&scene), [30.0 * PI, resisting, 30.0 * PI + resisting], 1e-8);
}

/// E example 2: the triangle of the engine has 40 pi J, the constant resistance takes them away.
#[test]
fn e2_takes_in_a_cycle_what_it_gives() {
    let found = analyzed(&text("flywheel"));
    let dynamics = found.dynamics.as_ref().unwrap();
    let first = 0.5 * dynamics.flywheel.unwrap() * found.trajectory.get(0, SPEED).unwrap().powi(2);
    assert_energies(&found, [40.0 * PI, -40.0 * PI, first], 1e-9);
}

const SPEED: Column = Column::of(Quantity::Velocity, Owner::Input);

/// The shares of the links are the reduced inertia of all.
#[test]
fn shares_of_links_sum_to_the_reduced_inertia() {
    let table = analyzed(&text("shaper-drive")).positions;
    let of = |owner| Column::of(Quantity::ReducedInertia, owner);
    let links = table.schema().owners(Quantity::ReducedInertia).into_iter();
    let links: Vec<_> = links.filter(|owner| *owner != Owner::Input).collect();
    assert!(links.len() > 3);
    for row in 0..table.len() {
        let sum: f64 = links.iter().map(|owner| table.get(row, of(*owner)).unwrap()).sum();
        let whole = table.get(row, of(Owner::Input)).unwrap();
        assert!((sum - whole).abs() <= 1e-14 * whole, "{row}: {sum} {whole}");
    }
}

/// The curve of the energy-mass diagram lies between its tangents, which meet at the origin and touch it; it is the work of
/// the energies over the cycle.
#[test]
fn the_energy_mass_diagram_lies_between_its_tangents() {
    for name in ["shaper-drive", "flywheel"] {
        let found = analyzed(&text(name));
        let dynamics = found.dynamics.as_ref().unwrap();
        let diagram = &dynamics.energy_mass;
        let [x, y] = diagram.origin;
        let size = -y;
        for tangent in &diagram.tangents {
            let [inertia, work] = tangent.touches;
            assert!((y + tangent.slope * (inertia - x) - work).abs() < 1e-12 * size, "{name}");
        }
        let [fast, slow] = diagram.tangents.map(|tangent| tangent.slope);
        for [inertia, work] in &diagram.curve {
            let along = |slope: f64| y + slope * (inertia - x);
            assert!(*work <= along(fast) + 1e-12 * size && *work >= along(slow) - 1e-12 * size, "{name}");
        }
        // Half of the cycle on: driving and resisting work together.
        let row = found.trajectory.len() / 2;
        let works = [Quantity::DrivingWork, Quantity::ResistingWork];
        let work: f64 = works
            .map(|quantity| found.trajectory.get(row, Column::of(quantity, Owner::Input)).unwrap())
            .iter()
            .sum();
        assert!((work - diagram.curve[diagram.curve.len() / 2][1]).abs() < 1e-9 * size, "{name}");
        // Wittenbauer: what the tangents cut off the axis of the energy, over the difference of their slopes.
        let cut = (y - fast * x) - (y - slow * x);
        let inertia = cut / (fast - slow);
        assert!((inertia - dynamics.regime.found.drive_inertia).abs() < 1e-9 * inertia, "{name}: {inertia}");
    }
}

/// The works of all loads are the driving and the resisting work together, and the kinetic energies of the links those of the
/// mechanism; E example 1: 150 pi and -100 pi J.
#[test]
fn works_by_load_and_energies_by_link_sum_up() {
    let found = analyzed(&text("run-up")).trajectory;
    let of = |quantity, owner| found.get(found.len() - 1, Column::of(quantity, owner)).unwrap();
    for (load, wanted) in [150.0 * PI, -100.0 * PI].into_iter().enumerate() {
        let work = of(Quantity::Work, Owner::Load(load));
        assert!((work - wanted).abs() < 1e-8 * wanted.abs(), "{work} {wanted}");
    }
    // Half of the way: 15 N m.
    let moments: Vec<f64> = (0..found.len())
        .map(|row| found.get(row, Column::of(Quantity::ReducedLoad, Owner::Load(0))).unwrap())
        .collect();
    for (row, moment) in moments.into_iter().enumerate() {
        let q = found.get(row, Column::COORDINATE).unwrap();
        assert!((moment - 30.0 * (1.0 - q / (10.0 * PI))).abs() < 1e-9, "{q}: {moment}");
    }
    for name in ["shaper-drive", "andrews", "n-four-bar-2"] {
        let table = analyzed(&text(name)).trajectory;
        let owners = |quantity| table.schema().owners(quantity);
        for row in (0..table.len()).step_by(7) {
            let at = |quantity, owner| table.get(row, Column::of(quantity, owner)).unwrap();
            let sum = |quantity: Quantity, owners: Vec<Owner>| {
                owners.into_iter().map(|owner| at(quantity, owner)).sum::<f64>()
            };
            let both = at(Quantity::DrivingWork, Owner::Input) + at(Quantity::ResistingWork, Owner::Input);
            let works = sum(Quantity::Work, owners(Quantity::Work));
            let size = at(Quantity::DrivingWork, Owner::Input) + at(Quantity::KineticEnergy, Owner::Input);
            assert!((works - both).abs() <= 1e-9 * (1.0 + size.abs()), "{name} {row}: {works} {both}");
            let whole = at(Quantity::KineticEnergy, Owner::Input);
            let links = owners(Quantity::KineticEnergy).into_iter().filter(|owner| *owner != Owner::Input);
            let links = sum(Quantity::KineticEnergy, links.collect());
            // The rest is that of flywheel and rotor.
            let has_drive = name == "shaper-drive";
            let rest = (whole - links) / whole.max(1e-12);
            assert!(rest > -1e-9 && (has_drive || rest < 1e-7), "{name} {row}: {whole} {links}");
        }
    }
}
