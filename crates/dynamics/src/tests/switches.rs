//! Loads whose formula changes where several of coordinate, speed and time together make it.

use approx::assert_relative_eq;
use assur_integrator::{EventKind, State};
use assur_number::search::bisect;
use assur_words::Describe;

use super::compiled;
use crate::{Method, Transient, transient};

const INTEGRATORS: [&str; 6] = ["auto", "dopri5", "dop853", "radau5", "rk4", "uniform"];

/// A disc of 0.5 kg m² from 1 rad/s, with a moment by formula.
fn disc(moment: &str, until: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.disc]\npoints = {{ O = 0 }}\nmass = 2\ninertia = 0.5\n\
         [[moment]]\nlink = 'disc'\nvalue = {{ formula = '{moment}' }}\n\
         [input]\nlink = 'disc'\n[motion]\nkind = 'transient'\nspeed = 1\nuntil = '{until} s'\n"
    )
}

fn solved(scene: &str, integrator: &str) -> Transient {
    let (linkage, loads) = compiled(scene);
    let method = Method { integrator: Some(integrator), ..Method::default() };
    transient(&linkage, &loads, &method, None)
        .unwrap_or_else(|error| panic!("{integrator}: {}", error.describe()))
}

/// Coordinate and speed at the end, and the times of the changes.
fn ends(moment: &str, until: f64, integrator: &str) -> ([f64; 2], Vec<f64>) {
    let found = solved(&disc(moment, until), integrator).trajectory;
    let changes = found.events.iter().filter(|event| event.kind == EventKind::Switch);
    ([found.end.coordinate, found.end.speed], changes.map(|event| event.state.time).collect())
}

fn near(found: &[f64], wanted: &[f64], accuracy: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?} {wanted:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= accuracy, "{found} for {wanted}");
    }
}

/// Accelerations of 24 and 16 rad/s², changing where q = 2 t: z = q - 2 t = 12 t² - t before.
#[test]
fn a_jump_over_coordinate_and_time() {
    let (at, rest) = (1.0 / 12.0, 11.0 / 12.0);
    for integrator in INTEGRATORS {
        let (end, changes) = ends("10 - 2*sign(q - 2*t)", 1.0, integrator);
        near(&changes, &[at], 1e-9);
        near(&end, &[1.0 / 6.0 + 3.0 * rest + 8.0 * rest * rest, 3.0 + 16.0 * rest], 1e-8);
    }
    // Backward, as in a mirror.
    let scene = disc("2*sign(-q - 2*t) - 10", 1.0).replace("speed = 1", "speed = -1");
    assert_relative_eq!(solved(&scene, "auto").trajectory.end.speed, -3.0 - 16.0 * rest, max_relative = 1e-9);
}

/// 8 and -8 rad/s² by turns: z = q - 2 t is ± (τ - 4 τ²) in each quarter of a second.
#[test]
fn a_motion_that_comes_back_to_its_change() {
    for integrator in INTEGRATORS {
        let (end, changes) = ends("4 - 8*step(q - 2*t)", 0.9, integrator);
        near(&changes, &[0.25, 0.5, 0.75], 1e-8);
        near(&end, &[1.86, 1.8], 1e-8);
    }
}

/// 18 rad/s² until w = q, 6 rad/s² after it: w - q = 1 + 17 t - 9 t².
#[test]
fn a_jump_over_speed_and_coordinate() {
    let at = (17.0 + 325.0_f64.sqrt()) / 18.0;
    let [w, rest] = [1.0 + 18.0 * at, 2.5 - at];
    for integrator in INTEGRATORS {
        let (end, changes) = ends("6 + 3*sign(w - q)", 2.5, integrator);
        near(&changes, &[at], 1e-8);
        near(&end, &[w + w * rest + 3.0 * rest * rest, w + 6.0 * rest], 1e-6);
    }
}

/// q'' = 6 q - 2 while q < w, w' = 6 w - 2 after it.
#[test]
fn a_bend_over_speed_and_coordinate() {
    let root = 6.0_f64.sqrt();
    let before = |t: f64| {
        let [fall, rise] = [-1.0 / 6.0 - 0.5 / root, -1.0 / 6.0 + 0.5 / root];
        let [down, up] = [(-root * t).exp(), (root * t).exp()];
        [1.0 / 3.0 + fall * down + rise * up, root * (rise * up - fall * down)]
    };
    let slower = |t: f64| before(t)[0] < before(t)[1];
    // The motion has q < w from the start; then w never falls below q again before the end.
    let later = |t: f64, [q, w]: [f64; 2]| {
        let grown = (w - 1.0 / 3.0) * (6.0 * t).exp();
        [q + t / 3.0 + (grown - w + 1.0 / 3.0) / 6.0, grown + 1.0 / 3.0]
    };
    let until = 1.0;
    let wanted = if slower(until) {
        before(until)
    } else {
        let at = bisect(0.0, until, 0.0, slower)[0];
        later(until - at, before(at))
    };
    for integrator in &INTEGRATORS[..5] {
        let (end, _) = ends("3*min(w, q) - 1", until, integrator);
        near(&end, &wanted, 1e-7);
    }
}

/// A fine integration of q'' = 10 max(t, sin q), split where the greater one changes.
#[test]
fn a_bend_over_time_and_coordinate() {
    let step = |[t, q, w]: [f64; 3], h: f64, by_time: bool| {
        let slope = |[t, q, w]: [f64; 3]| [1.0, w, 10.0 * if by_time { t } else { q.sin() }];
        let ahead = |k: [f64; 3], part: f64| [t + part * h * k[0], q + part * h * k[1], w + part * h * k[2]];
        let a = slope([t, q, w]);
        let b = slope(ahead(a, 0.5));
        let c = slope(ahead(b, 0.5));
        let d = slope(ahead(c, 1.0));
        ahead(std::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0), 1.0)
    };
    let (mut state, h) = ([0.0, 0.0, 1.0], 1e-4);
    let (mut by_time, mut changes) = (false, Vec::new());
    let greater = |[t, q, _]: [f64; 3]| t > q.sin();
    for _ in 0..15_000 {
        let next = step(state, h, by_time);
        // At the start both are zero.
        if state[0] > 0.0 && greater(next) != by_time {
            let part = bisect(0.0, h, 0.0, |part| greater(step(state, part, by_time)) == by_time)[1];
            state = step(state, part, by_time);
            changes.push(state[0]);
            by_time = !by_time;
            state = step(state, h - part, by_time);
        } else {
            state = next;
        }
    }
    assert!(!changes.is_empty());
    for integrator in &INTEGRATORS[..5] {
        let (end, mut found) = ends("5*max(t, sin(q))", 1.5, integrator);
        // At the start t and sin q touch in the third order: which is greater shows only later.
        found.retain(|change| *change > 1e-6);
        near(&found, &changes, 1e-7);
        near(&end, &state[1..], 1e-6);
    }
}

/// Friction by formula, with a sense that the coordinate has a part in: 8 rad/s² to rest, and released by time and coordinate.
#[test]
fn friction_by_formula_holds_and_releases() {
    for integrator in INTEGRATORS {
        let found = solved(&disc("1 - 5*sign(w*cos(q)) + 20*step(t + q - 1)", 1.0), integrator);
        let kinds: Vec<_> = found.trajectory.events.iter().map(|event| (event.kind, event.state)).collect();
        let [(EventKind::Switch, stop), (EventKind::Rest, _), (EventKind::Release, free)] = kinds[..] else {
            panic!("{integrator}: {kinds:?}")
        };
        near(&[stop.time, stop.coordinate, free.time], &[0.125, 0.0625, 0.9375], 1e-9);
        // It begins with an acceleration of 32 rad/s².
        let State { coordinate, speed, .. } = found.trajectory.end;
        near(&[coordinate, speed], &[0.125, 2.0], 1e-8);
        let held = found.instants.iter().find(|instant| instant.state.speed == 0.0).unwrap();
        // The friction is held below its bound.
        near(&[held.holding.unwrap().moment, held.holding.unwrap().bound], &[-1.0, 5.0], 1e-9);
    }
}

/// Behind w = q both values drive the motion back to it.
#[test]
fn a_motion_along_a_change_is_refused() {
    for integrator in INTEGRATORS {
        let (linkage, loads) = compiled(&disc("6 - 3*sign(w - q)", 3.0));
        let method = Method { integrator: Some(integrator), ..Method::default() };
        let why = transient(&linkage, &loads, &method, None).unwrap_err().describe().to_string();
        assert!(why.contains("`sign` (character 7") && why.contains("driven back"), "{why}");
        // w = 12.08 where q is.
        assert!(why.contains("12.08"), "{why}");
    }
}

/// A steady regime of the disc, driven by 20 N m against 2 w and a moment of w and q.
fn regime(moment: &str, speed: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.disc]\npoints = {{ O = 0 }}\nmass = 2\ninertia = 0.5\n\
         [[moment]]\nlink = 'disc'\nvalue = {{ formula = '{moment}' }}\n[[moment]]\nlink = 'disc'\n\
         value = {{ formula = '-2*w' }}\n[input]\nlink = 'disc'\n[motion]\nkind = 'steady'\n\
         mean_speed = '{speed} rad/s'\n[drive]\ntorque = 20\nflywheel = 0\n"
    )
}

/// Speeds of the periodic motion w' = f(q, w)/(J w) at `count` places of a turn. Runge and Kutta's steps end at the changes of
/// `side`, on whose sides f is smooth: the side of the step's start holds throughout the step.
fn periodic(f: impl Fn(f64, f64, bool) -> f64, side: impl Fn(f64, f64) -> bool, count: u32) -> Vec<f64> {
    let step = |q: f64, w: f64, h: f64, above: bool| {
        let rate = |q: f64, w: f64| f(q, w, above) / (0.5 * w);
        let a = rate(q, w);
        let b = rate(q + 0.5 * h, w + 0.5 * h * a);
        let c = rate(q + 0.5 * h, w + 0.5 * h * b);
        let d = rate(q + h, w + h * c);
        w + h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
    };
    let parts = 16 * count;
    let width = std::f64::consts::TAU / f64::from(parts);
    let (mut w, mut speeds) = (10.0, Vec::new());
    for _ in 0..40 {
        speeds.clear();
        for part in 0..parts {
            if part % 16 == 0 {
                speeds.push(w);
            }
            let (mut q, mut left) = (width * f64::from(part), width);
            while left > 1e-14 {
                let above = side(q + 1e-12, step(q, w, 1e-12, side(q, w)));
                let to = |h: f64| step(q, w, h, above);
                let stays = |h: f64| side(q + h, to(h)) == above;
                let h = if stays(left) { left } else { bisect(0.0, left, 0.0, stays)[1] };
                w = to(h);
                (q, left) = (q + h, left - h);
            }
        }
    }
    speeds
}

/// Both switches mix w and q: one only bends, the other jumps, twice a turn.
#[test]
fn regimes_that_switch_over_speed_and_coordinate() {
    type Side = fn(f64, f64) -> bool;
    type Moment = fn(f64, f64, bool) -> f64;
    let cases: [(&str, Side, Moment); 2] = [
        (
            "min(w, 10 + 4*sin(q)) - 9",
            move |q, w| w > 10.0 + 4.0 * q.sin(),
            |q, w, above| 20.0 - 2.0 * w + if above { 10.0 + 4.0 * q.sin() } else { w } - 9.0,
        ),
        (
            "3*sign(w - 10 - 5*cos(q))",
            |q, w| w > 10.0 + 5.0 * q.cos(),
            |_, w, above| 20.0 - 2.0 * w + if above { 3.0 } else { -3.0 },
        ),
    ];
    for (moment, side, f) in cases {
        let count = 40;
        let wanted = periodic(f, side, count);
        let (linkage, loads) = compiled(&regime(moment, 10.0));
        let found = crate::steady(&linkage, &loads, None)
            .unwrap_or_else(|error| panic!("{moment}: {}", error.describe()));
        for (place, wanted) in wanted.iter().enumerate() {
            let q = std::f64::consts::TAU * place as f64 / f64::from(count);
            let speed = found.regime.state(q).speed;
            assert!((speed - wanted).abs() < 1e-8, "{moment} at {q}: {speed} for {wanted}");
        }
    }
}

/// Crank 0.1 m and rod 0.2 m without mass but for the crank's 0.5 kg m²: the force along the guide at B by formula, and the rest.
fn crank(force: &str, rest: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\nmass = 2\ncenter = 0\ninertia = 0.5\n\
         [link.rod]\npoints = {{ A = 0, B = 0.2 }}\n[link.slider]\npoints = {{ B = 0 }}\n[[slide]]\nlink = 'slider'\n\
         on = 'ground'\n[[force]]\nlink = 'slider'\nat = 'B'\nangle = 0\nvalue = {{ formula = '{force}', axis = 0 }}\n\
         [assembly]\nB = [0.3, 0]\n[input]\nlink = 'crank'\n{rest}"
    )
}

/// The place of B between its extremes 0.1 m and 0.3 m, and the derivative of its coordinate.
fn place(q: f64) -> [f64; 2] {
    let root = (0.04 - (0.1 * q.sin()).powi(2)).sqrt();
    [(0.1 * q.cos() + root - 0.1) / 0.2, -0.1 * q.sin() - 0.01 * q.sin() * q.cos() / root]
}

/// What a force gives by place, speed, time and side, and on which side of its change a state is.
type PlaceForce = (&'static str, fn([f64; 3], bool) -> f64, fn([f64; 3]) -> bool);

/// A fine integration of the crank by Runge and Kutta, whose steps end where the force changes its side: times of the changes, end.
fn crank_by_steps(
    f: fn([f64; 3], bool) -> f64,
    side: fn([f64; 3]) -> bool,
    until: f64,
) -> (Vec<f64>, [f64; 2]) {
    const STEPS: u32 = 20_000;
    let side = |[t, q, w]: [f64; 3]| side([place(q)[0], w, t]);
    let step = |[t, q, w]: [f64; 3], h: f64, above: bool| {
        let slope = |[t, q, w]: [f64; 3]| {
            let [x, arm] = place(q);
            [1.0, w, f([x, w, t], above) * arm / 0.5]
        };
        let ahead = |k: [f64; 3], part: f64| [t + part * h * k[0], q + part * h * k[1], w + part * h * k[2]];
        let a = slope([t, q, w]);
        let b = slope(ahead(a, 0.5));
        let c = slope(ahead(b, 0.5));
        let d = slope(ahead(c, 1.0));
        ahead(std::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0), 1.0)
    };
    let h = until / f64::from(STEPS);
    let (mut state, mut changes) = ([0.0, 0.5, 6.0], Vec::new());
    for _ in 0..STEPS {
        let mut left = h;
        while left > 1e-15 {
            let above = side(step(state, 1e-12, side(state)));
            let stays = |h: f64| side(step(state, h, above)) == above;
            let taken = if stays(left) { left } else { bisect(0.0, left, 0.0, stays)[1] };
            state = step(state, taken, above);
            if taken < left {
                changes.push(state[0]);
            }
            left -= taken;
        }
    }
    (changes, [state[1], state[2]])
}

/// The place of the force's point with time, with the speed, with both, and with a coordinate that does not repeat.
#[test]
fn motions_that_switch_over_a_place() {
    let cases: [PlaceForce; 4] = [
        (
            "20*max(t/2, x)",
            |[x, _, t], above| 20.0 * if above { 0.5 * t } else { x },
            |[x, _, t]| t > 2.0 * x,
        ),
        ("5 + 4*sign(x - 0.08*w)", |_, above| if above { 9.0 } else { 1.0 }, |[x, w, _]| x > 0.08 * w),
        (
            "9*step(x*w - 3 - t)*w",
            |[_, w, _], above| if above { 9.0 * w } else { 0.0 },
            |[x, w, t]| x * w > 3.0 + t,
        ),
        (
            "8*abs(2*x - t - 0.3)",
            |[x, _, t], above| (2.0 * x - t - 0.3) * if above { 8.0 } else { -8.0 },
            |[x, _, t]| 2.0 * x > t + 0.3,
        ),
    ];
    for (force, f, side) in cases {
        let (changes, end) = crank_by_steps(f, side, 1.5);
        assert!(changes.len() > 1, "{force}: {changes:?}");
        for integrator in &INTEGRATORS[..5] {
            let motion = "[motion]\nkind = 'transient'\nspeed = 6\nuntil = '1.5 s'\n";
            let found = solved(&crank(force, &format!("from = 0.5\n{motion}")), integrator).trajectory;
            let met = found.events.iter().filter(|event| event.kind == EventKind::Switch);
            near(&met.map(|event| event.state.time).collect::<Vec<_>>(), &changes, 1e-7);
            near(&[found.end.coordinate, found.end.speed], &end, 1e-6);
        }
    }
    // x = q/10 + 0.2 does not repeat with the turn; nor is there a bound of the coordinate for methods that go along it alone.
    let motion = "[motion]\nkind = 'transient'\nspeed = 6\nuntil = '2 rev'\n";
    let found = solved(&crank("sign(x - q/10 - 0.2)", motion), "auto").trajectory;
    let met = found.events.iter().filter(|event| event.kind == EventKind::Switch);
    let met: Vec<f64> = met.map(|event| event.state.coordinate).collect();
    let side = |q: f64| place(q)[0] > q / 10.0 + 0.2;
    let cells = (0..2000)
        .map(|cell| [f64::from(cell), f64::from(cell + 1)].map(|at| at * std::f64::consts::TAU / 1000.0));
    let wanted = cells.filter(|[a, b]| side(*a) != side(*b));
    let wanted: Vec<f64> = wanted.map(|[a, b]| bisect(a, b, 0.0, |q| side(q) == side(a))[1]).collect();
    near(&met, &wanted, 1e-7);
    assert!(wanted.len() > 2, "{wanted:?}");
}

/// A force that jumps, and one that bends, where the place of its point and the speed make it.
#[test]
fn regimes_that_switch_over_a_place_and_the_speed() {
    type Side = fn(f64, f64) -> bool;
    type Moment = fn(f64, f64, bool) -> f64;
    let cases: [(&str, Side, Moment); 2] = [
        (
            "30*sign(x - 0.1*w + 0.5)",
            |q, w| place(q)[0] > 0.1 * w - 0.5,
            |q, w, above| 20.0 - 2.0 * w + place(q)[1] * if above { 30.0 } else { -30.0 },
        ),
        (
            "40*min(w/10, 2*x)",
            |q, w| w / 10.0 > 2.0 * place(q)[0],
            |q, w, above| {
                20.0 - 2.0 * w + place(q)[1] * 40.0 * if above { 2.0 * place(q)[0] } else { w / 10.0 }
            },
        ),
    ];
    for (force, side, f) in cases {
        let count = 40;
        let wanted = periodic(f, side, count);
        let rest = "[[moment]]\nlink = 'crank'\nvalue = { formula = '-2*w' }\n[motion]\nkind = 'steady'\n\
            mean_speed = '10 rad/s'\n[drive]\ntorque = 20\nflywheel = 0\n";
        let (linkage, loads) = compiled(&crank(force, rest));
        let found = crate::steady(&linkage, &loads, None)
            .unwrap_or_else(|error| panic!("{force}: {}", error.describe()));
        for (index, wanted) in wanted.iter().enumerate() {
            let q = std::f64::consts::TAU * index as f64 / f64::from(count);
            let speed = found.regime.state(q).speed;
            assert!((speed - wanted).abs() < 1e-8, "{force} at {q}: {speed} for {wanted}");
        }
    }
}
