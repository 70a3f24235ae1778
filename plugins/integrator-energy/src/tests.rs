use assur_integrator::problems::{Andrews, e1, pendulum, pendulum_period};
use assur_integrator::{State, Until};

use super::*;

#[test]
fn scratch() {
    let mut request = Request::new(State::default(), Until::Coordinate(10.0*std::f64::consts::PI));
    let out = Energy.solve(&mut e1(), &request).unwrap();
    println!("{:?} {:e}", out.statistics, out.end.speed - (1000.0*std::f64::consts::PI).sqrt());
    for e in 3..13 {
        request = Request::new(State { coordinate: 2.0, ..State::default() }, Until::Time(pendulum_period(2.0)));
        request.samples = 1;
        request.tolerance = 10_f64.powi(-e);
        let p = Energy.solve(&mut pendulum(), &request).unwrap();
        print!("{e} {} {} {} {:e} {:e}|", p.statistics.evaluations, p.statistics.steps, p.statistics.rejected, (p.end.coordinate-2.0)/4.0, p.end.speed);
        request.initial = Andrews::START;
        request.until = Until::Time(0.03);
        let p = Energy.solve(&mut Andrews, &request).unwrap();
        println!("{} {} {} {:e} {:e}", p.statistics.evaluations, p.statistics.steps, p.statistics.rejected, (p.end.coordinate-15.810771195146563)/15.87, (p.end.speed-1139.9203022587067)/1140.0);
    }
    panic!();
}
