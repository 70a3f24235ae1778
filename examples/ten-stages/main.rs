//! The ten stages of the complete calculation of a linkage, programmed by its user: each is a function of some twenty lines against
//! the crates, for the shaper of `fixtures/shaper-drive.toml`. `docs/course.md` leads through the same stages with the program.
//!
//! `cargo run -p assur-tests --example ten-stages`

use std::error::Error;

use assur_all as _;
use assur_dynamics::{Steady, steady};
use assur_force::{Cause, Kinetostatics, LoadState, Loads, Side, choose};
use assur_group::{Body, Order};
use assur_kinematics::Linkage;
use assur_mechanism::Mechanism;
use assur_motor::{
    Characteristic, CharacteristicKind, MotorFilter, SelectionRequest, catalogues, list_motors, rad_per_s,
    rpm, select,
};

type Done<T> = Result<T, Box<dyn Error>>;

/// Position of a working and of an idle stroke.
const POSITIONS: [usize; 2] = [12, 35];

fn main() -> Done<()> {
    let linkage = stage_1()?;
    stage_2(&linkage)?;
    println!("3. PF1 and J' against differences: {:.1e}", stage_3(&linkage)?);
    let loads = Loads::compile(&linkage)?;
    for index in POSITIONS {
        let [inertia, slope, moment] = stage_4(&linkage, &loads, index)?;
        println!("4. position {index}: J = {inertia:.6} kg m2, J' = {slope:.6}, Q = {moment:.4} N m");
    }
    println!("5. {}", stage_5(&loads, &linkage)?);
    let found = stage_6(&linkage, &loads)?;
    for index in POSITIONS {
        println!("7. position {index}: {}", stage_7(&linkage, &found, index)?);
    }
    println!("8. equation of motion: {:.1e}", stage_8(&linkage, &loads, &found)?);
    let balancing = stage_9(&linkage, &loads, &found)?;
    println!("10. balancing moment against the motor: {:.1e}", stage_10(&linkage, &balancing, &found));
    Ok(())
}

/// Structural analysis: groups in solving order.
fn stage_1() -> Done<Linkage> {
    let mechanism = assur_scene::read("shaper-drive.toml", assur_fixtures::scene("shaper-drive"))?;
    let linkage = Linkage::compile(mechanism)?;
    for group in &linkage.structure.groups {
        println!("1. group {} of links {:?}", group.plugin.kind, group.frame.links);
    }
    println!("1. {}, class {}", linkage.structure.formula, linkage.structure.class());
    Ok(linkage)
}

/// Metric analysis: position and transfer functions of every link, group after group.
fn stage_2(linkage: &Linkage) -> Done<()> {
    let rocker = linkage.mechanism.link("rocker").ok_or("no rocker")?;
    for index in POSITIONS {
        let Body { s, c, w1, w2, .. } = bodies(linkage, linkage.mechanism.input.coordinate(index))?[rocker];
        let angle = f64::atan2(s, c).to_degrees();
        println!("2. position {index}: rocker PF0 = {angle:.4} deg, PF1 = {w1:.6}, PF2 = {w2:.6}");
    }
    Ok(())
}

/// The links at a coordinate.
fn bodies(linkage: &Linkage, q: f64) -> Done<Vec<Body<f64>>> {
    let mut position = linkage.position();
    linkage.solve(q, Order::Second, &mut position)?;
    Ok(position.bodies)
}

/// Check by numbers: PF1 of every link against central differences of PF0, J' against those of J; the greatest deviation.
fn stage_3(linkage: &Linkage) -> Done<f64> {
    let (step, mut greatest) = (1e-5, 0.0_f64);
    for index in 0..linkage.mechanism.input.positions {
        let q = linkage.mechanism.input.coordinate(index);
        let (before, here, after) =
            (bodies(linkage, q - step)?, bodies(linkage, q)?, bodies(linkage, q + step)?);
        for ((a, b), c) in before.iter().zip(&after).zip(&here) {
            let slopes = [(b.x - a.x, c.x1), (b.y - a.y, c.y1), (b.w1 - a.w1, c.w2)];
            let off = slopes.map(|(difference, slope)| (difference / (2.0 * step) - slope).abs());
            greatest = off.into_iter().fold(greatest, f64::max);
        }
        let [low, high] = [&before, &after].map(|bodies| inertia(&linkage.mechanism, bodies)[0]);
        let slope = inertia(&linkage.mechanism, &here)[1];
        greatest = greatest.max(((high - low) / (2.0 * step) - slope).abs());
    }
    Ok(greatest)
}

/// The reduced moment of inertia and its derivative, by their sums over the links.
fn inertia(mechanism: &Mechanism, bodies: &[Body<f64>]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for (link, body) in mechanism.links.iter().zip(bodies).skip(1) {
        let own = link.inertia.constant();
        let arm = body.arm(link.center);
        let ([x1, y1], [x2, y2]) = (body.first(arm), body.second(arm));
        sums[0] += link.mass * (x1 * x1 + y1 * y1) + own * body.w1 * body.w1;
        sums[1] += 2.0 * (link.mass * (x1 * x2 + y1 * y2) + own * body.w1 * body.w2);
    }
    sums
}

/// The dynamic model: J and J' by their sums, Q by the powers of weights and resistance.
fn stage_4(linkage: &Linkage, loads: &Loads, index: usize) -> Done<[f64; 3]> {
    let q = linkage.mechanism.input.coordinate(index);
    let (bodies, state) =
        (bodies(linkage, q)?, LoadState { coordinate: q, speed: 1.0, ..LoadState::default() });
    let mut moment = 0.0;
    loads.by_cause(&state, &bodies, &mut |cause, link, load| {
        if !matches!(cause, Cause::Inertia(_)) {
            let body = &bodies[link];
            moment += load.fx * body.x1 + load.fy * body.y1 + load.m * body.w1;
        }
    });
    let [inertia, slope] = inertia(&linkage.mechanism, &bodies);
    Ok([inertia, slope, moment])
}

/// The motor: the smallest of a catalogue that has the power and keeps the speed limit.
fn stage_5(loads: &Loads, linkage: &Linkage) -> Done<String> {
    let (mut work, count) = (0.0, 720);
    for index in 0..count {
        let q = std::f64::consts::TAU * (f64::from(index) + 0.5) / f64::from(count);
        let state = LoadState { coordinate: q, speed: 1.0, ..LoadState::default() };
        work -= loads.reduced(&state, &bodies(linkage, q)?).moment * std::f64::consts::TAU / f64::from(count);
    }
    let input_speed = rad_per_s(60.0);
    let request = SelectionRequest {
        required_power: work * input_speed / std::f64::consts::TAU / 0.95,
        input_speed,
        max_motor_speed: Some(rad_per_s(1500.0)),
        characteristic: CharacteristicKind::Kloss,
    };
    let filter = MotorFilter { catalogue: Some("4A".to_owned()), ..MotorFilter::default() };
    let motor = select(list_motors(&catalogues()?, &filter)?, &request)?.chosen.motor;
    let kloss = Characteristic::new(CharacteristicKind::Kloss, &motor.rated_data())?;
    let torque = kloss.torque(motor.rated_speed);
    let speed = rpm(motor.rated_speed);
    let (designation, power) = (motor.latin_designation(), request.required_power);
    Ok(format!("{power:.2} W wanted: {designation}, {torque:.3} N m at {speed:.0} rpm"))
}

/// The equation of motion, solved together with gear ratio and flywheel.
fn stage_6(linkage: &Linkage, loads: &Loads) -> Done<Steady> {
    let found = steady(linkage, loads, None)?;
    let figures = &found.regime.figures;
    println!(
        "6. gear ratio {:.4}, flywheel {:.3} kg m2, speed {:.5} to {:.5} rad/s, unevenness {:.4}",
        figures.ratio.ok_or("no motor")?,
        found.regime.flywheel,
        figures.speed_min,
        figures.speed_max,
        figures.unevenness
    );
    Ok(found)
}

/// Speed and acceleration of the input in the regime.
fn state(found: &Steady, q: f64) -> LoadState {
    let at = found.regime.state(q);
    let (speed, acceleration, time) = (at.speed, at.acceleration, at.time);
    LoadState { coordinate: q, speed, acceleration, time, side: Side::After, drive: None }
}

/// Real motion and inertia loads: those of the rocker.
fn stage_7(linkage: &Linkage, found: &Steady, index: usize) -> Done<String> {
    let q = linkage.mechanism.input.coordinate(index);
    let (LoadState { speed, acceleration, .. }, bodies) = (state(found, q), bodies(linkage, q)?);
    let id = linkage.mechanism.link("rocker").ok_or("no rocker")?;
    let (link, body) = (&linkage.mechanism.links[id], &bodies[id]);
    let by_time = |first: f64, second: f64| second * speed * speed + first * acceleration;
    let arm = body.arm(link.center);
    let [first, second] = [body.first(arm), body.second(arm)];
    let force = [0, 1].map(|axis| -link.mass * by_time(first[axis], second[axis]));
    let moment = -link.inertia.constant() * by_time(body.w1, body.w2);
    Ok(format!("inertia loads of the rocker {:.3} N, {:.3} N, {moment:.4} N m", force[0], force[1]))
}

/// Lagrange and d'Alembert: moment of the motor, all loads and inertia loads, link by link, have no power together; the greatest
/// residual, relative.
fn stage_8(linkage: &Linkage, loads: &Loads, found: &Steady) -> Done<f64> {
    let mut greatest = 0.0_f64;
    for index in 0..linkage.mechanism.input.positions {
        let q = linkage.mechanism.input.coordinate(index);
        let (state, bodies) = (state(found, q), bodies(linkage, q)?);
        let at = found.regime.state(q);
        let shaft = found.regime.drive_inertia * state.acceleration;
        let (mut sum, mut size) = (at.drive - shaft, at.drive.abs() + shaft.abs());
        loads.by_cause(&state, &bodies, &mut |_, link, load| {
            let body = &bodies[link];
            let power = load.fx * body.x1 + load.fy * body.y1 + load.m * body.w1;
            sum += power;
            size += power.abs();
        });
        greatest = greatest.max(sum.abs() / size);
    }
    Ok(greatest)
}

/// Force analysis group by group, and the balancing moment.
fn stage_9(linkage: &Linkage, loads: &Loads, found: &Steady) -> Done<Vec<f64>> {
    let analyzer = choose(None, false, false)?.instance;
    let carrying = vec![true; linkage.structure.groups.len()];
    let mut statics = Kinetostatics::new(linkage, loads, analyzer, &carrying);
    let (mut position, mut balancing) = (linkage.position(), Vec::new());
    for index in 0..linkage.mechanism.input.positions {
        let q = linkage.mechanism.input.coordinate(index);
        linkage.solve(q, Order::Second, &mut position)?;
        statics.solve(&state(found, q), &position)?;
        balancing.push(statics.reactions.balancing);
        if POSITIONS.contains(&index) {
            let forces = statics.reactions.pairs.iter().map(|pair| format!("{:.2}", pair.fx.hypot(pair.fy)));
            println!("9. position {index}: reactions {} N", forces.collect::<Vec<_>>().join(", "));
        }
    }
    Ok(balancing)
}

/// Global check: the balancing moment is what the motor gives beyond accelerating its rotor and the flywheel.
fn stage_10(linkage: &Linkage, balancing: &[f64], found: &Steady) -> f64 {
    let off = balancing.iter().enumerate().map(|(index, balancing)| {
        let at = found.regime.state(linkage.mechanism.input.coordinate(index));
        let given = at.drive - found.regime.drive_inertia * at.acceleration;
        (given - balancing).abs() / given.abs().max(balancing.abs())
    });
    off.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests;
