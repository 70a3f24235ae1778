use super::*;
use crate::{Cost, Integrator, Knob, Suitability};

struct Nothing;

impl Integrator for Nothing {
    fn solve(&self, _: &mut dyn EquationOfMotion, _: &Request) -> Result<Trajectory, IntegrationError> {
        Ok(Trajectory::default())
    }
}

type Suits = fn(&Dependence, f64) -> Result<Suitability, Text>;

const NONE: Text = Text::message("", Vec::new());

const fn method(name: &'static str, order: u8, stiff: bool, suitability: Suits) -> IntegratorPlugin {
    IntegratorPlugin {
        name,
        crate_name: "test",
        summary: NONE,
        source: NONE,
        order,
        knob: Knob::Tolerance,
        stiff,
        suitability,
        method: &Nothing,
    }
}

#[expect(clippy::unnecessary_wraps, clippy::trivially_copy_pass_by_ref, reason = "the signature of an entry")]
fn anything(_: &Dependence, _: f64) -> Result<Suitability, Text> {
    Ok(Suitability { cost: Cost::LastResort, reason: NONE })
}

static CLOSED: IntegratorPlugin = method("closed", 0, false, |dependence, _| match dependence.case() {
    1 => Ok(Suitability { cost: Cost::ClosedForm, reason: name("exact") }),
    _ => Err(NONE),
});
static LOW: IntegratorPlugin = method("low", 2, false, |_, tolerance| {
    let cost = if tolerance > 1e-4 { Cost::Steps } else { Cost::OtherSteps };
    Ok(Suitability { cost, reason: NONE })
});
static HIGH: IntegratorPlugin = method("high", 8, false, |_, tolerance| {
    let cost = if tolerance > 1e-4 { Cost::OtherSteps } else { Cost::Steps };
    Ok(Suitability { cost, reason: NONE })
});
static STIFF: IntegratorPlugin = method("implicit", 5, true, anything);
static SPARE: IntegratorPlugin = method("any", 4, false, anything);

fn equation(inertia_constant: bool, [q, w, t]: [bool; 3]) -> Dependence {
    Dependence {
        inertia_constant,
        moment_on_coordinate: q,
        moment_on_speed: w,
        moment_on_time: t,
        ..Dependence::default()
    }
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
        assert_eq!((dependence.case(), dependence.describe().to_string().as_str()), (case, words));
    }
}

#[test]
fn methods_are_ranked_by_cost_then_by_order() {
    let registry = [&SPARE, &CLOSED, &HIGH, &STIFF, &LOW];
    let names = |dependence, tolerance| {
        let choice = ranked(&registry, dependence, tolerance).unwrap();
        assert_eq!(choice.stiff.unwrap().name, "implicit");
        let first = std::iter::once(&choice.first);
        first.chain(&choice.others).map(|candidate| candidate.integrator.name).collect::<Vec<_>>()
    };
    let constant = equation(true, [false; 3]);
    assert_eq!(names(constant, 1e-9), ["closed", "high", "low", "implicit", "any"]);
    assert_eq!(names(constant, 1e-3), ["closed", "low", "high", "implicit", "any"]);
    let variable = equation(false, [true; 3]);
    assert_eq!(names(variable, 1e-9), ["high", "low", "implicit", "any"]);
}

#[test]
fn the_reason_names_the_case_and_nothing_suitable_is_an_error() {
    let choice = ranked(&[&CLOSED], equation(true, [false; 3]), 1e-6).unwrap();
    assert_eq!(choice.first.reason.to_string(), "case 1 of D (J constant, M constant): exact");
    assert!(choice.stiff.is_none() && choice.others.is_empty());
    let error = ranked(&[&CLOSED], equation(false, [true, true, false]), 1e-6).unwrap_err().to_string();
    assert_eq!(error, "no linked integrator supports this equation (J(q), M(q, w))");
}

#[test]
fn only_an_explicit_method_of_steps_may_turn_out_to_be_stiff() {
    let if_stiff = |first: &'static IntegratorPlugin| {
        let choice = ranked(&[first, &STIFF], equation(true, [false; 3]), 1e-9).unwrap();
        assert_eq!(choice.first.integrator.name, first.name);
        choice.if_stiff().map(|method| method.name)
    };
    assert_eq!((if_stiff(&HIGH), if_stiff(&CLOSED)), (Some("implicit"), None));
    let alone = ranked(&[&STIFF], equation(true, [false; 3]), 1e-9).unwrap();
    assert!(alone.if_stiff().is_none());
}

#[test]
fn a_method_refuses_an_equation_that_it_does_not_suit() {
    assert!(CLOSED.supports(&equation(true, [false; 3])).is_ok());
    let error = CLOSED.supports(&equation(false, [false; 3])).unwrap_err();
    assert!(matches!(error, IntegrationError::Unsupported { integrator: "closed", .. }), "{error}");
}
