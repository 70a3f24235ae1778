use assur_testkit::Rng;
use nalgebra::DVector;

mod scaling;

use super::least_maximum;
use crate::cone::LinearForce;

/// The center of the smallest circle around points: a force is the way to a point.
fn around(points: &[[f64; 2]]) -> (f64, f64) {
    let row = |&force: &[f64; 2]| LinearForce { force, columns: vec![[-1.0, 0.0], [0.0, -1.0]] };
    let rows: Vec<LinearForce> = points.iter().map(row).collect();
    let least = least_maximum(&rows, &DVector::zeros(2), 2.0, 1e-13);
    let [x, y] = [least.unknowns[0], least.unknowns[1]];
    (least.bound, points.iter().map(|p| (p[0] - x).hypot(p[1] - y)).fold(0.0, f64::max))
}

/// The smallest of all circles through two or three points that hold all.
fn smallest(points: &[[f64; 2]]) -> f64 {
    let holds = |[x, y]: [f64; 2], radius: f64| {
        points.iter().all(|p| (p[0] - x).hypot(p[1] - y) <= radius * (1.0 + 1e-12))
    };
    let mut best = f64::INFINITY;
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate().take(i) {
            let center = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
            let radius = 0.5 * (a[0] - b[0]).hypot(a[1] - b[1]);
            if holds(center, radius) {
                best = best.min(radius);
            }
            for c in points.iter().take(j) {
                let [u, v] = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
                let twice = 2.0 * (u[0] * v[1] - u[1] * v[0]);
                let [p, q] = [u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]];
                let arm = [(v[1] * p - u[1] * q) / twice, (u[0] * q - v[0] * p) / twice];
                let radius = arm[0].hypot(arm[1]);
                if holds([a[0] + arm[0], a[1] + arm[1]], radius) {
                    best = best.min(radius);
                }
            }
        }
    }
    best
}

#[test]
fn the_smallest_circle_around_points() {
    for seed in 0..40 {
        let mut rng = Rng::new(seed);
        let points: Vec<[f64; 2]> = (0..12).map(|_| [rng.range(-0.7, 0.7), rng.range(-0.7, 0.7)]).collect();
        let (wanted, (bound, greatest)) = (smallest(&points), around(&points));
        assert!((greatest / wanted - 1.0).abs() < 1e-10, "seed {seed}: {greatest} instead of {wanted}");
        assert!(bound <= wanted * (1.0 + 1e-14), "seed {seed}: {bound} proves more than {wanted}");
        assert!(bound >= wanted * (1.0 - 1e-10), "seed {seed}: {bound} proves less than {wanted}");
    }
}

/// Points on one circle: every one of them touches.
#[test]
fn all_rows_touch() {
    let points: Vec<[f64; 2]> =
        (0..60).map(|i| (f64::from(i) * 0.105).sin_cos()).map(|(y, x)| [0.6 * x + 0.1, 0.6 * y]).collect();
    let (bound, greatest) = around(&points);
    assert!((greatest - 0.6).abs() < 1e-10 && (bound - 0.6).abs() < 1e-10, "{bound} {greatest}");
}

/// A force that no unknown reaches can't be less.
#[test]
fn what_no_unknown_changes_is_the_least() {
    let row = |force, column| LinearForce { force, columns: vec![column] };
    let rows = [row([0.6, -0.8], [0.0; 2]), row([0.5, 0.0], [1.0, 0.0])];
    let least = least_maximum(&rows, &DVector::zeros(1), 2.0, 1e-13);
    assert!((least.bound - 1.0).abs() < 1e-12, "{}", least.bound);
}
