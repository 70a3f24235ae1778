//! Evaluations, rejections and errors of both methods on the pendulum and on Andrews' mechanism, for the choice of
//! controller constants. `cargo run --release -p assur-integrator-dormand-prince --example figures`

use assur_integrator::problems::{Andrews, pendulum, pendulum_period};
use assur_integrator::{IntegrationError, Integrator, Motion, Request, State, Until};
use assur_integrator_dormand_prince::{Dop853, Dopri5};

/// Evaluations, steps, rejections, and the errors of coordinate and speed relative to their sizes.
fn row(
    method: &dyn Integrator,
    motion: &mut dyn Motion,
    request: &Request,
    wanted: State,
    (travel, fastest): (f64, f64),
) -> Result<String, IntegrationError> {
    let found = method.solve(motion, request)?;
    let cost = found.statistics;
    Ok(format!(
        "{:5} evaluations {:4} steps {:2} rejected, errors {:.1e} {:.1e}",
        cost.evaluations,
        cost.steps,
        cost.rejected,
        (found.end.coordinate - wanted.coordinate).abs() / travel,
        (found.end.speed - wanted.speed).abs() / fastest,
    ))
}

fn main() -> Result<(), IntegrationError> {
    let start = State { coordinate: 2.0, ..State::default() };
    for method in [&Dopri5 as &dyn Integrator, &Dop853] {
        for exponent in 3..13 {
            let period = Until::Time(pendulum_period(2.0));
            let mut request = Request::new(start, period);
            (request.samples, request.tolerance) = (1, 10_f64.powi(-exponent));
            let swing = row(method, &mut pendulum(), &request, start, (4.0, 1.683))?;
            (request.initial, request.until) = (Andrews::START, Until::Time(Andrews::END.time));
            let press = row(method, &mut Andrews, &request, Andrews::END, (15.87, 1140.0))?;
            println!("{:6} 1e-{exponent:02} pendulum {swing} | andrews {press}", method.name());
        }
    }
    Ok(())
}
