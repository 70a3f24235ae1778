//! Checks of places.

use assur_group::Body;

use crate::case::{Case, Fault};

/// Greatest difference between the poses of the group's links.
pub(crate) fn apart(case: &Case, one: &[Body<f64>], two: &[Body<f64>]) -> f64 {
    let links = &case.sample.frame.links;
    let parts = links.iter().flat_map(|&i| {
        let (a, b) = (&one[i], &two[i]);
        [a.x - b.x, a.y - b.y, a.c - b.c, a.s - b.s]
    });
    parts.fold(0.0, |worst: f64, part| if part.is_nan() { f64::INFINITY } else { worst.max(part.abs()) })
}

/// One of the ways gives the poses from which the pairs were constructed; returns this way.
pub(crate) fn recovers(case: &Case) -> Result<usize, Fault> {
    let built = case.sample.built();
    let mut least = f64::INFINITY;
    for way in 0..case.kernel.ways() {
        let mut bodies = case.sample.bodies(0.0);
        let Some(health) = case.placed(&mut bodies, way)? else { continue };
        let off = apart(case, &bodies, &built);
        if off <= 1e-13 / health.abs().min(1.0) {
            return Ok(way);
        }
        least = least.min(off);
    }
    Err(case.fault("recovers", format!("no way gives the known place; the nearest is off by {least:.3e}")))
}

/// Every way satisfies the pairs, leaves the outer bodies unchanged, keeps unit directions, and differs from the
/// other ways.
pub(crate) fn all_ways_close(case: &Case) -> Result<(), Fault> {
    let mut found: Vec<Vec<Body<f64>>> = vec![];
    for way in 0..case.kernel.ways() {
        let before = case.sample.bodies(0.0);
        let mut bodies = before.clone();
        if case.placed(&mut bodies, way)?.is_none() {
            continue;
        }
        case.within("closure", "a pair", case.residual(&bodies), 2e-14)?;
        for (i, body) in bodies.iter().enumerate() {
            case.within("closure", "length of a direction", body.c.hypot(body.s) - 1.0, 1e-14)?;
            if case.sample.frame.column(i).is_none() && *body != before[i] {
                return Err(case.fault("closure", format!("body {i} is not of the group and was moved")));
            }
        }
        for other in &found {
            if apart(case, other, &bodies) < 1e-3 {
                return Err(case.fault("ways", format!("way {way} is the same as another")));
            }
        }
        found.push(bodies);
    }
    Ok(())
}

/// The health that `place` returns equals that of `health`, and is between 0 and about 1.
pub(crate) fn health_is_consistent(case: &Case, bodies: &[Body<f64>], health: f64) -> Result<(), Fault> {
    let separate = case.kernel.health(bodies);
    case.within(
        "health",
        "what `place` and `health` say",
        health.abs() - separate.abs(),
        1e-13 / health.abs(),
    )?;
    if health.abs() > 1.5 {
        return Err(case.fault("health", format!("{health} is far above 1")));
    }
    Ok(())
}
