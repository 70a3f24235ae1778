use assur_integrator::problems::{motor, pendulum, pendulum_period};
use assur_integrator::{State, Until};

use super::*;

#[test]
fn scratch() {
    for steep in [1e1, 1e3,1e6,1e8] {
        for tol in [1e-4,1e-6,1e-9] {
        let mut request = Request::new(State { speed: 9.0, ..State::default() }, Until::Coordinate(std::f64::consts::TAU));
        request.tolerance = tol;
        let out = Radau5.solve(&mut motor(steep), &request).unwrap();
        println!("{steep:e} {tol:e} {:?} {:?}", out.statistics, out.end);
        }
    }
    for e in 3..13 {
        let mut request = Request::new(State { coordinate: 2.0, ..State::default() }, Until::Time(pendulum_period(2.0)));
        request.samples = 1;
        request.tolerance = 10_f64.powi(-e);
        let p = Radau5.solve(&mut pendulum(), &request).unwrap();
        println!("{e} {:?} {:e}", p.statistics, (p.end.coordinate-2.0)/4.0);
    }
    panic!();
}
