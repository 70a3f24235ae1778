use super::*;
use crate::{IntegrationError, Motion, Request, Trajectory};

#[derive(Debug)]
struct Any;
#[derive(Debug)]
struct WorkOnly;

impl Integrator for Any {
    fn name(&self) -> &'static str {
        "any"
    }
    fn supports(&self, _: &Dependence) -> Result<(), String> {
        Ok(())
    }
    fn solve(&self, _: &mut dyn Motion, _: &Request) -> Result<Trajectory, IntegrationError> {
        Ok(Trajectory::default())
    }
}

impl Integrator for WorkOnly {
    fn name(&self) -> &'static str {
        "work"
    }
    fn supports(&self, dependence: &Dependence) -> Result<(), String> {
        if dependence.is_work_of_coordinate() { Ok(()) } else { Err("no".to_owned()) }
    }
    fn solve(&self, _: &mut dyn Motion, _: &Request) -> Result<Trajectory, IntegrationError> {
        Ok(Trajectory::default())
    }
}

const fn entry(name: &'static str, order: u8, instance: fn() -> &'static dyn Integrator) -> IntegratorPlugin {
    IntegratorPlugin { name, crate_name: "test", summary: "", source: "", order, instance }
}

static CLOSED: IntegratorPlugin = entry("closed-form", 0, || &WorkOnly);
static ENERGY: IntegratorPlugin = entry("energy", 0, || &WorkOnly);
static TIME: IntegratorPlugin = entry("quadrature", 0, || &Any);
static FIVE: IntegratorPlugin = entry("dopri5", 5, || &Any);
static EIGHT: IntegratorPlugin = entry("dop853", 8, || &Any);
static FOREIGN: IntegratorPlugin = entry("foreign", 6, || &Any);

fn equation(inertia_constant: bool, [q, w, t]: [bool; 3]) -> Dependence {
    Dependence { inertia_constant, moment_on_coordinate: q, moment_on_speed: w, moment_on_time: t }
}

#[test]
fn cases_are_those_of_d() {
    for (dependence, case, words) in [
        (equation(true, [false, false, false]), 1, "J constant, M constant"),
        (equation(true, [true, false, false]), 2, "J constant, M(q)"),
        (equation(true, [false, true, false]), 2, "J constant, M(w)"),
        (equation(true, [false, false, true]), 2, "J constant, M(t)"),
        (equation(false, [true, false, false]), 3, "J(q), M(q)"),
        (equation(false, [false, false, false]), 3, "J(q), M constant"),
        (equation(true, [true, true, false]), 4, "J constant, M(q, w)"),
        (equation(false, [true, true, false]), 5, "J(q), M(q, w)"),
        (equation(false, [false, false, true]), 5, "J(q), M(t)"),
    ] {
        assert_eq!((dependence.case(), dependence.words().as_str()), (case, words));
    }
}

#[test]
fn the_cheapest_sufficient_method_is_taken() {
    let all = [&CLOSED, &ENERGY, &TIME, &FIVE, &EIGHT];
    for (dependence, tolerance, name) in [
        (equation(true, [false, false, false]), 1e-9, "closed-form"),
        (equation(true, [true, false, false]), 1e-9, "energy"),
        (equation(false, [true, false, false]), 1e-3, "energy"),
        (equation(true, [false, true, false]), 1e-9, "quadrature"),
        (equation(true, [false, false, true]), 1e-3, "quadrature"),
        (equation(true, [false, true, true]), 1e-9, "dop853"),
        (equation(false, [false, false, true]), 1e-9, "dop853"),
        (equation(false, [true, true, true]), 1e-3, "dopri5"),
    ] {
        let choice = choose(&dependence, tolerance, &all).unwrap();
        assert_eq!(choice.name(), name);
        assert!(choice.reason.starts_with(&format!("case {} of D ({}): ", choice.case, dependence.words())));
    }
}

#[test]
fn a_foreign_method_serves_where_nothing_else_is_linked() {
    let dependence = equation(false, [true, true, false]);
    assert_eq!(choose(&dependence, 1e-6, &[&ENERGY, &FOREIGN]).unwrap().name(), "foreign");
    assert!(choose(&dependence, 1e-6, &[&ENERGY]).is_none());
}
