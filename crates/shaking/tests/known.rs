//! Shaking forces against series of textbooks, known counterweights, and differences.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::f64::consts::PI;

use assur_all as _;
use assur_force::LoadState;
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_shaking::{Criterion, Shaking, ShakingError, shaking};

fn compile(scene: &str) -> Linkage {
    let mechanism = assur_scene::read("test.toml", scene).unwrap_or_else(|errors| panic!("{errors}"));
    Linkage::compile(mechanism).unwrap()
}

fn found(scene: &str) -> Result<Shaking, ShakingError> {
    let linkage = compile(scene);
    shaking(&linkage, &|q| LoadState::prescribed(&linkage.mechanism, q))
}

fn near(found: f64, wanted: f64, limit: f64) {
    assert!((found - wanted).abs() <= limit, "{found} instead of {wanted}: {:e} apart", found - wanted);
}

/// Radius of the crank, m; its mass at A and mass of the piston, kg; speed, rad/s.
const R: f64 = 0.05;
const AT_A: f64 = 0.8;
const AT_B: f64 = 1.5;
const W: f64 = 100.0;

fn slider_crank(ratio: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = {R} }}\nmass = {AT_A}\ncenter = 'A'\n\
         [link.rod]\npoints = {{ A = 0, B = {} }}\n[link.piston]\npoints = {{ B = 0 }}\nmass = {AT_B}\n\
         [[slide]]\nlink = 'piston'\non = 'ground'\n[input]\nlink = 'crank'\n[motion]\nspeed = {W}\n[assembly]\nB = [1, 0]",
        R / ratio
    )
}

#[test]
fn harmonics_of_an_in_line_slider_crank() {
    let l = 0.25_f64;
    let found = found(&slider_crank(l)).unwrap();
    let unit = R * W * W;
    let order = |order: usize| &found.harmonics[order];
    // x'' = -r w² (cos q + A2 cos 2q - A4 cos 4q + A6 cos 6q ...), to the seventh power of r/l.
    let a2 = l + l.powi(3) / 4.0 + 15.0 * l.powi(5) / 128.0;
    let a4 = l.powi(3) / 4.0 + 3.0 * l.powi(5) / 16.0;
    let a6 = 9.0 * l.powi(5) / 128.0;
    near(order(1).x[0], unit * (AT_A + AT_B), 1e-9 * unit);
    near(order(1).y[1], unit * AT_A, 1e-9 * unit);
    let left_out = AT_B * unit * l.powi(7);
    near(order(2).x[0], AT_B * unit * a2, left_out);
    near(order(4).x[0], -AT_B * unit * a4, left_out);
    near(order(6).x[0], AT_B * unit * a6, left_out);
    near(order(3).x[0], 0.0, 1e-9 * unit);
    near(order(2).y[0].hypot(order(2).y[1]), 0.0, 1e-9 * unit);
}

/// For a long rod the input torque is m r² w² (sin 2q / 2 - r/l sin q / 4 + 3 r/l sin 3q / 4).
#[test]
fn harmonics_of_the_input_torque() {
    let l = 1e-3;
    let found = found(&slider_crank(l)).unwrap();
    let unit = AT_B * R * R * W * W;
    for (order, wanted) in [(1, -l / 4.0), (2, 0.5), (3, 0.75 * l)] {
        near(found.harmonics[order].torque[1], wanted * unit, l * l * unit);
        near(found.harmonics[order].torque[0], 0.0, 1e-9 * unit);
    }
}

/// The counterweight for lumped masses: the rotating mass and half of the reciprocating one, opposite to the crank pin.
#[test]
fn counterweight_of_a_slider_crank() {
    let found = found(&slider_crank(0.25)).unwrap();
    let least = found.balances.iter().find(|balance| balance.criterion == Criterion::LeastSquares).unwrap();
    let [weight] = &least.counterweights[..] else { panic!() };
    near(weight.product, R * (AT_A + 0.5 * AT_B), 1e-12);
    near(weight.angle.abs(), PI, 1e-12);
    near(weight.mass, AT_A + 0.5 * AT_B, 1e-10);
    assert!(least.after.rms_force < found.before.rms_force);
}

/// A Scotch yoke moves in one harmonic: with half of the reciprocating mass balanced the force has one magnitude all over.
#[test]
fn least_maximum_of_a_scotch_yoke() {
    let scene = format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = {R} }}\nmass = {AT_A}\ncenter = 'A'\n\
         [link.stone]\npoints = {{ A = 0 }}\n[link.yoke]\npoints = {{ Y = 0 }}\nmass = {AT_B}\n\
         [[slide]]\nlink = 'stone'\non = 'yoke'\nangle = '90 deg'\n[[slide]]\nlink = 'yoke'\non = 'ground'\n\
         [input]\nlink = 'crank'\n[motion]\nspeed = {W}"
    );
    let found = found(&scene).unwrap();
    for balance in &found.balances {
        near(balance.counterweights[0].product, R * (AT_A + 0.5 * AT_B), 1e-8);
        near(balance.after.greatest_force, 0.5 * AT_B * R * W * W, 1e-6);
    }
    assert_eq!(found.balances.len(), 2);
}

/// Counterweights on crank and rocker balance the force of a four-bar completely (Berkof, Lowen 1969); with one on the
/// crank alone each criterion is best at what it makes least.
#[test]
fn counterweights_of_a_four_bar() {
    let found = found(assur_fixtures::scene("four-bar")).unwrap();
    let [squares, maximum, both_squares, both_maximum] = &found.balances[..] else { panic!() };
    assert_eq!(
        [&squares.criterion, &maximum.criterion],
        [&Criterion::LeastSquares, &Criterion::LeastMaximum]
    );
    assert!(squares.after.rms_force < maximum.after.rms_force);
    assert!(maximum.after.greatest_force < squares.after.greatest_force);
    assert!(maximum.after.greatest_force < found.before.greatest_force);
    for both in [both_squares, both_maximum] {
        assert_eq!(both.counterweights.len(), 2);
        assert!(both.after.greatest_force < 1e-8 * found.before.greatest_force, "{both:?}");
    }
    // No other counterweight on the crank has a smaller maximum: walk around it.
    let linkage = compile(assur_fixtures::scene("four-bar"));
    let greatest = |product: [f64; 2]| {
        let mut scene = linkage.mechanism.clone();
        // The counterweight as a part of the crank's mass: same first moment, same mass.
        let crank = &mut scene.links[1];
        crank.center = [0, 1].map(|i| crank.center[i] + product[i] / crank.mass);
        let changed = Linkage::compile(scene).unwrap();
        shaking(&changed, &|q| LoadState::prescribed(&changed.mechanism, q)).unwrap().before.greatest_force
    };
    let weight = &maximum.counterweights[0];
    let best = [weight.product * weight.angle.cos(), weight.product * weight.angle.sin()];
    near(greatest(best), maximum.after.greatest_force, 1e-9 * maximum.after.greatest_force);
    for i in 0..8 {
        let (sin, cos) = (f64::from(i) * PI / 4.0).sin_cos();
        let step = 1e-3 * weight.product;
        assert!(greatest([best[0] + step * cos, best[1] + step * sin]) > maximum.after.greatest_force);
    }
}

/// Force and moment are the changes of momentum and of angular momentum about the origin.
#[test]
fn momentum_changes_by_the_shaking_force() {
    let scene = assur_fixtures::scene("four-bar").replace("acceleration = 30", "");
    let linkage = compile(&scene);
    let found = shaking(&linkage, &|q| LoadState::prescribed(&linkage.mechanism, q)).unwrap();
    let speed = LoadState::prescribed(&linkage.mechanism, 0.0).speed;
    let momentum = |q: f64| {
        let mut position = linkage.position();
        linkage.solve(q, Order::First, &mut position).unwrap();
        let mut sum = [0.0; 3];
        for (link, body) in linkage.mechanism.links.iter().zip(&position.bodies) {
            let arm = body.arm(link.center);
            let ([x, y], [vx, vy]) = (body.point(link.center), body.first(arm).map(|v| v * speed));
            sum[0] += link.mass * vx;
            sum[1] += link.mass * vy;
            sum[2] += link.mass * (x * vy - y * vx) + link.inertia.constant() * body.w1 * speed;
        }
        sum
    };
    for at in found.positions.iter().step_by(5) {
        let h = 1e-5;
        let [before, after] = [at.coordinate - h, at.coordinate + h].map(momentum);
        let wanted = [0, 1, 2].map(|i| -(after[i] - before[i]) / (2.0 * h) * speed);
        let scale = found.before.greatest_force;
        near(at.force[0], wanted[0], 1e-6 * scale);
        near(at.force[1], wanted[1], 1e-6 * scale);
        near(at.moment, wanted[2], 1e-6 * found.before.greatest_moment);
    }
}

#[test]
fn what_is_missing_is_said() {
    let scene = slider_crank(0.25);
    let still = scene.replace(&format!("[motion]\nspeed = {W}\n"), "");
    assert!(matches!(found(&still), Err(ShakingError::NoMotion)));
    let part = scene.replace("link = 'crank'\n[motion]", "link = 'crank'\nto = 1\n[motion]");
    assert!(matches!(found(&part), Err(ShakingError::NoCycle)));
    let light =
        scene.replace(&format!("mass = {AT_A}\ncenter = 'A'\n"), "").replace(&format!("mass = {AT_B}\n"), "");
    assert!(matches!(found(&light), Err(ShakingError::NoMass)));
}
