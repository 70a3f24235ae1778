//! The working of a position or of a sample of a motion.

use assur_analysis::Calculation;
use assur_analysis::results::{Analysis, Column, Owner, Quantity, Table};
use assur_figure::extent;
use assur_mechanism::{Mechanism, Motion};
use assur_words::text;
use assur_working::{Done, Ending, EnergyForm, PositionOrSample, Task, Working, WorkingError};
use assur_worksheet::Section;

/// The working of a position, of a transient motion that of a sample: with the forces, where there are some.
pub fn of_position(calculation: &Calculation, index: usize) -> Result<Working, WorkingError> {
    if let Some(state) = calculation.sample(index).0 {
        return of(calculation, PositionOrSample::Sample(index), state, true);
    }
    let mechanism = &calculation.linkage.mechanism;
    let is_transient = matches!(mechanism.motion, Some(Motion::Transient { .. }));
    let has_forces = !is_transient && (mechanism.motion.is_some() || mechanism.has_loads());
    let state = calculation.state(mechanism.input.coordinate(index));
    of(calculation, PositionOrSample::Position(index), state, has_forces)
}

fn of(
    calculation: &Calculation,
    place: PositionOrSample,
    state: assur_force::LoadState,
    has_forces: bool,
) -> Result<Working, WorkingError> {
    // Where the motion is not found, neither are its forces.
    let loads = calculation.loads.as_ref().filter(|_| has_forces && calculation.no_motion.is_none());
    let drive = calculation.drive_in(&state).filter(|_| has_forces);
    let analyzer = calculation.analyzer.map(|analyzer| analyzer.name);
    Working::of(&Task { linkage: &calculation.linkage, loads, state, place, drive, analyzer })
}

/// The energy form of the motion of a scene (E eqs. 1-3, 10); nothing where the motion is prescribed, or its works are not known.
pub fn energy(analysis: &Analysis, mechanism: &Mechanism) -> Vec<Section> {
    energy_form(analysis, mechanism).map_or_else(Vec::new, |form| form.sections())
}

fn energy_form<'a>(analysis: &'a Analysis, mechanism: &'a Mechanism) -> Option<EnergyForm<'a>> {
    let table = &analysis.trajectory;
    let last = table.len().checked_sub(1)?;
    let value = |row, quantity, owner| table.get(row, Column::of(quantity, owner));
    let ending = |row| {
        let of = |quantity| value(row, quantity, Owner::Input);
        let energy = of(Quantity::KineticEnergy)?;
        Some(Ending { coordinate: of(Quantity::Transfer(0))?, speed: of(Quantity::Velocity)?, energy })
    };
    let schema = table.schema();
    let links = schema.owners(Quantity::KineticEnergy).into_iter().filter_map(|owner| match owner {
        Owner::Link(link) => Some((link, value(last, Quantity::KineticEnergy, owner)?)),
        _ => None,
    });
    let (ends, links, inertia) = ([ending(0)?, ending(last)?], links.collect(), constant_inertia(table));
    let cycle = analysis.dynamics.as_ref().map(|found| &found.figures);
    let form = EnergyForm { mechanism, ends, works: Vec::new(), links, inertia, cycle };
    let known = |owner: &Owner| *owner != Owner::Input || form.balance().is_none();
    let done = |owner| {
        let (name, load) = match owner {
            Owner::Load(load) => (schema.named(owner)?.into(), Some(load)),
            Owner::Input => (text!("work-of-drive"), None),
            _ => (text!("work-of-weights"), None),
        };
        Some(Done { name, load, work: value(last, Quantity::Work, owner)? })
    };
    let works = schema.owners(Quantity::Work).into_iter().filter(known).map(done).collect::<Option<_>>()?;
    Some(EnergyForm { works, ..form })
}

/// The reduced inertia of all samples that move, where it is one number but for rounding.
fn constant_inertia(table: &Table) -> Option<f64> {
    /// Slower samples than this part of the fastest have an energy that is only rounding.
    const SLOW: f64 = 1e-3;
    const ROUNDING: f64 = 1e-12;
    let of = |row, quantity| table.get(row, Column::of(quantity, Owner::Input));
    let speed = |row| of(row, Quantity::Velocity);
    let fastest = (0..table.len()).filter_map(speed).fold(0.0_f64, |most, speed| most.max(speed.abs()));
    let moving = (0..table.len()).filter(|row| speed(*row).is_some_and(|speed| speed.abs() > SLOW * fastest));
    let inertia = |row| Some(2.0 * of(row, Quantity::KineticEnergy)? / speed(row)?.powi(2));
    let [least, most] = extent(moving.filter_map(inertia))?;
    (most - least <= ROUNDING * most).then_some(most)
}
