use super::*;
use crate::{Dependence, IntegrationError, Motion, Request, Trajectory};

#[derive(Debug)]
struct Nothing;

impl Integrator for Nothing {
    fn name(&self) -> &'static str {
        "nothing"
    }

    fn supports(&self, _: &Dependence) -> Result<(), String> {
        Ok(())
    }

    fn solve(&self, _: &mut dyn Motion, _: &Request) -> Result<Trajectory, IntegrationError> {
        Ok(Trajectory::default())
    }
}

const fn plugin(name: &'static str, crate_name: &'static str) -> IntegratorPlugin {
    IntegratorPlugin { name, crate_name, summary: "", source: "", order: 1, instance: || &Nothing }
}

#[test]
fn names_are_sorted_and_unique() {
    let (a, b, again) = (plugin("a", "first"), plugin("b", "second"), plugin("a", "third"));
    let names: Vec<&str> = sorted(vec![&b, &a]).unwrap().iter().map(|plugin| plugin.name).collect();
    assert_eq!(names, ["a", "b"]);
    assert_eq!(
        sorted(vec![&again, &b, &a]).unwrap_err().to_string(),
        "two integrators are named `a`: from `first` and from `third`; rename one"
    );
    assert_eq!(sorted(Vec::new()).unwrap_err(), RegistryError::Empty);
}
