use assur_kinematics::Linkage;
use assur_mechanism::{LawTable, Load, Moment, Value};

use super::{fixture, linkage};
use crate::Loads;

fn error(change: impl FnOnce(&mut assur_mechanism::Mechanism)) -> String {
    let mut mechanism = linkage(&fixture("slider-crank")).mechanism;
    change(&mut mechanism);
    Loads::compile(&Linkage::compile(mechanism).unwrap()).unwrap_err().to_string()
}

#[test]
fn a_load_that_needs_a_motion() {
    let text = error(|mechanism| {
        mechanism.motion = None;
        mechanism.loads[0].kind.force_mut().unwrap().direction = assur_mechanism::Direction::AgainstMotion;
    });
    assert_eq!(text, "load `gas`: a force against the motion needs a motion; add `[motion]` with a speed");
}

#[test]
fn a_point_without_a_stroke() {
    let text = error(|mechanism| {
        let Some(Value::Stroke { axis, .. }) = mechanism.loads[0].kind.law_mut() else {
            panic!("the gas force is given over a stroke")
        };
        *axis = 0.0;
    });
    assert!(text.starts_with("load `gas` is given over a stroke, but its point moves only "), "{text}");
    assert!(text.ends_with(" m along the axis; turn the axis"), "{text}");
}

#[test]
fn a_moment_has_no_stroke() {
    let text = error(|mechanism| {
        let table = LawTable::constant(1.0);
        let value = Value::Stroke { axis: 0.0, forward: table.clone(), back: table };
        mechanism.loads.push(Load::new("drag", Moment { link: 1, value, against_motion: false }));
    });
    assert_eq!(
        text,
        "moment `drag` is given over a stroke, but a moment has no point that could move; use a table over the angle"
    );
}
