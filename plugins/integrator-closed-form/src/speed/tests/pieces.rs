//! Jumps and kinks of the moment over the speed.

use assur_integrator::{EventKind, MotionError, Piece};

use super::*;

/// The acceleration as a table over the speed, linear between the rows, which may jump at them: of each segment the values at
/// its ends.
pub(super) struct Rows {
    pub(super) speeds: Vec<f64>,
    pub(super) ends: Vec<[f64; 2]>,
    pub(super) segment: usize,
}

impl EquationOfMotion for Rows {
    fn dependence(&self) -> Dependence {
        BY_SPEED
    }

    fn enter(&mut self, state: &State) -> Result<Piece, MotionError> {
        self.segment = self.speeds.partition_point(|row| *row <= state.speed);
        let low = self.segment.checked_sub(1).map_or(f64::NEG_INFINITY, |before| self.speeds[before]);
        let high = self.speeds.get(self.segment).copied().unwrap_or(f64::INFINITY);
        Ok(Piece { speed: [low, high], ..Piece::UNBOUNDED })
    }

    fn reduced(&mut self, state: &State) -> Result<Reduced, MotionError> {
        let [low, high] = self.ends[self.segment];
        let inside = self.segment.checked_sub(1).zip(self.speeds.get(self.segment));
        Ok(reduced(inside.map_or(low, |(before, to)| {
            let from = self.speeds[before];
            low + (high - low) * (state.speed - from) / (to - from)
        })))
    }
}

/// Dry friction beside a brake: w' = -(a + b w) for w > 0 and +a for w < 0: rest at ln(1 + b w0/a)/b.
fn braked(a: f64, b: f64) -> impl EquationOfMotion {
    Example::new(BY_SPEED, move |place: Place, at: &State| reduced(-a * place.direction - b * at.speed))
        .directed()
}

#[test]
fn friction_holds_at_rest() {
    let (a, b, w0) = (2.0, 0.5, 30.0_f64);
    let rest = (b * w0 / a).ln_1p() / b;
    let way = w0 / b - a / b * rest;
    let found = solve(&mut braked(a, b), &request(w0, Until::Turn, 1e-9));
    assert!((found.end.time - 1.0 - rest).abs() < 1e-12, "{:?}", found.end);
    assert!((found.end.coordinate + 2.0 - way).abs() < 1e-11, "{:?}", found.end);
    let found = solve(&mut braked(a, b), &request(w0, Until::Time(40.0), 1e-9));
    assert_eq!(found.events.iter().map(|event| event.kind).collect::<Vec<_>>(), [EventKind::Rest]);
    assert_follows(&found, [1e-11, 1e-10], |t| {
        let w = -a / b + (w0 + a / b) * (-b * t).exp();
        if t < rest { [w, (w0 - w) / b - a / b * t] } else { [0.0, way] }
    });
    let error = refused(&mut braked(a, b), &request(w0, Until::Coordinate(-2.0 + way + 0.1), 1e-9));
    assert!(error.ends_with("rests there for good"), "{error}");
}

/// Stalled by hardly more than nothing: w' = -a - w with a down to a rounding of the moment, at rest after ln(1 + 1/a).
#[test]
fn a_stall_by_a_hair_is_a_rest() {
    for exponent in 1..=15 {
        let load = 1.0 + 10.0_f64.powi(-exponent);
        let a = load - 1.0;
        let mut motion = Example::new(BY_SPEED, move |place: Place, at: &State| {
            reduced(1.0 - at.speed - load * place.direction)
        })
        .directed();
        let found = solve(&mut motion, &request(1.0, Until::Turn, 1e-10));
        let time = (1.0 / a).ln_1p();
        // The moment left is known to a rounding of 1 in a.
        let allowed = 1e-9 + 8.0 * f64::EPSILON / a;
        assert!((found.end.time - 1.0 - time).abs() < allowed, "{a:e}: {:?}", found.end);
        assert!((found.end.coordinate + 2.0 - (1.0 - a * time)).abs() < 1e-12, "{a:e}: {:?}", found.end);
    }
}

/// 1 up to w = 2, then 3 up to 5, then -1: the speed is held at 5, where each side drives back.
#[test]
fn a_jump_is_stepped_onto_and_holds_where_both_sides_drive_back() {
    let rows = || Rows { speeds: vec![2.0, 5.0], ends: vec![[1.0; 2], [3.0; 2], [-1.0; 2]], segment: 0 };
    let found = solve(&mut rows(), &request(0.0, Until::Time(7.0), 1e-9));
    assert_eq!(
        found.events.iter().map(|event| event.kind).collect::<Vec<_>>(),
        [EventKind::Speed, EventKind::Speed, EventKind::Held]
    );
    assert_follows(&found, [1e-12, 1e-11], |t| match t {
        _ if t < 2.0 => [t, 0.5 * t * t],
        _ if t < 3.0 => [2.0 + 3.0 * (t - 2.0), 2.0 + (t - 2.0) * (2.0 + 1.5 * (t - 2.0))],
        _ => [5.0, 5.5 + 5.0 * (t - 3.0)],
    });
    let found = solve(&mut rows(), &request(0.0, Until::Coordinate(-2.0 + 15.5), 1e-9));
    assert!((found.end.time - 6.0).abs() < 1e-12, "{:?}", found.end);
    // From above it comes down to the same speed; from a row itself it leaves to the right side.
    let found = solve(&mut rows(), &request(6.0, Until::Time(4.0), 1e-9));
    assert_follows(&found, [1e-12, 1e-11], |t| {
        if t < 1.0 { [6.0 - t, t * (6.0 - 0.5 * t)] } else { [5.0, 5.5 + 5.0 * (t - 1.0)] }
    });
    let found = solve(&mut rows(), &request(2.0, Until::Time(1.5), 1e-9));
    assert_follows(&found, [1e-12, 1e-11], |t| [2.0 + 3.0 * t, t * (2.0 + 1.5 * t)]);
}

/// A jump that no table tells of: the method goes over it or says that it can't; never a wrong motion.
#[test]
fn a_hidden_jump_is_passed_or_refused() {
    let mut motion = speed_law(|w| if w < 2.3 { 1.0 } else { 4.0 });
    match QUADRATURE.solve(&mut motion, &request(0.0, Until::Time(6.0), 1e-8)) {
        Ok(found) => assert_follows(&found, [1e-5, 1e-4], |t| {
            let s = t - 2.3;
            if s < 0.0 { [t, 0.5 * t * t] } else { [2.3 + 4.0 * s, 2.645 + s * (2.3 + 2.0 * s)] }
        }),
        Err(error) => assert!(matches!(error, IntegrationError::Unsupported { .. }), "{error}"),
    }
}
