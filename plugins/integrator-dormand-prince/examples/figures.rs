//! Evaluations, rejections and errors on the pendulum and on Andrews' mechanism.
use assur_integrator::problems::{Andrews, pendulum, pendulum_period};
use assur_integrator::*;
use assur_integrator_dormand_prince::{Dop853, Dopri5};

fn main() {
    for method in [&Dopri5 as &dyn Integrator, &Dop853] {
        for exponent in [3, 4, 5, 6, 7, 8, 9, 10, 11, 12] {
            let mut request = Request::new(State { coordinate: 2.0, ..State::default() }, Until::Time(pendulum_period(2.0)));
            request.samples = 1;
            request.tolerance = 10_f64.powi(-exponent);
            let p = method.solve(&mut pendulum(), &request).unwrap();
            let pe = ((p.end.coordinate - 2.0) / 4.0).abs().max(p.end.speed.abs() / 1.683);
            request.initial = Andrews::START;
            request.samples = 4;
            request.until = Until::Time(0.03);
            let a = method.solve(&mut Andrews, &request).unwrap();
            let ae = ((a.end.coordinate - Andrews::END.coordinate) / 15.87).abs();
            let we = ((a.end.speed - Andrews::END.speed) / 1139.9).abs();
            println!(
                "{} 1e-{exponent}: pendulum {} evals {} rej err {pe:.1e} | andrews {} evals {} steps {} rej err {ae:.1e} w {we:.1e}",
                method.name(), p.statistics.evaluations, p.statistics.rejected,
                a.statistics.evaluations, a.statistics.steps, a.statistics.rejected,
            );
            if exponent==12 { println!("{:?}", a.end); }
        }
    }
}
