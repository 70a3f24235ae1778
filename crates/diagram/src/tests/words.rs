use assur_force::{Loads, State, find};

use super::{compile, fixture};
use crate::{Plan, VectorKind, sheet, sheet_text, text};

#[test]
fn a_plan_as_a_table() {
    let mut plan = Plan::new("Force polygon of the arm", "N");
    let corner = plan.push(
        VectorKind::Weight,
        "weight of arm".to_owned(),
        [0.0; 2],
        [0.0, -20.0],
        "load on `arm`".to_owned(),
    );
    plan.push(VectorKind::Reaction, "R(O)".to_owned(), corner, [0.0, 20.0], "pin O on `arm`".to_owned());
    plan.point("start", [0.0; 2]);
    assert_eq!(
        text(&plan.finish(0.0)),
        "Force polygon of the arm\n\
         unit N, 1 mm = 0.2 N; residual 0.0e0\n\
         \x20 vector         size      unit  deg       from x  from y     meaning\n\
         \x20 weight of arm  20.00000  N     -90.0000  0       0          load on `arm`\n\
         \x20 R(O)           20.00000  N     90.0000   0       -20.00000  pin O on `arm`\n\
         \x20 point  x  y\n\
         \x20 start  0  0\n"
    );
}

#[test]
fn directions_that_differ_by_rounding_are_told_alike() {
    let mut plan = Plan::new("Two", "N");
    plan.push(VectorKind::Load, "right".to_owned(), [0.0; 2], [1.0, -1e-17], String::new());
    plan.push(VectorKind::Load, "left".to_owned(), [0.0; 2], [-1.0, -0.0], String::new());
    let words = text(&plan.finish(0.0));
    assert!(words.contains(" 0.0000 ") && words.contains(" 180.0000 ") && !words.contains("-180"), "{words}");
}

#[test]
fn a_sheet_has_everything_and_serializes() {
    let linkage = compile(&fixture("press"));
    let loads = Loads::compile(&linkage).unwrap();
    let state = State::prescribed(&linkage.mechanism, 2.0);
    let found = sheet(&linkage, &loads, &state, true, find("groups").unwrap()).unwrap();
    assert_eq!((found.polygons.len(), found.centers.len(), found.constructions.len()), (2, 6, 3));
    assert!(found.constructions.iter().all(|plan| plan.residual < 1e-12));
    let json = serde_json::to_value(&found).unwrap();
    assert_eq!(json["constructions"][1]["items"][0]["name"], "F");
    assert_eq!(json["velocities"]["unit"], "m/s");
    assert_eq!(json["by_cause"]["shares"][0]["cause"], linkage.mechanism.contacts[0].name.as_str());
    let words = sheet_text(&found);
    assert!(words.is_ascii());
    for title in [
        "Plan of velocities\n",
        "Plan of accelerations\n",
        "Instant centers (m)\n",
        "Force polygon of group 1 (RRP rod, slider)\n",
        "Longitudinal reactions: pole of `rod`, balancing force at A: force polygon\n",
        "Zhukovsky's lever",
        "Reactions by cause (N)",
    ] {
        assert!(words.contains(title), "{title}\n{words}");
    }
}

#[test]
fn where_the_published_form_fails_the_sheet_still_comes() {
    let scene =
        fixture("press").replace("from = \"130 deg\"\nto = \"50 deg\"\npositions = 33", "positions = 4");
    let linkage = compile(&scene);
    let loads = Loads::compile(&linkage).unwrap();
    let state = State::prescribed(&linkage.mechanism, 0.0);
    let found = sheet(&linkage, &loads, &state, true, find("longitudinal").unwrap()).unwrap();
    assert_eq!(found.constructions.len(), 3);
}

/// At the conveyor's pin of three links, an arrow of a polygon is the share of one pair, and is called so.
#[test]
fn a_share_of_a_multiple_joint_is_not_called_by_the_whole_reaction() {
    let linkage = compile(&fixture("conveyor"));
    let loads = Loads::compile(&linkage).unwrap();
    let state = State::prescribed(&linkage.mechanism, linkage.mechanism.input.coordinate(2));
    let found = sheet(&linkage, &loads, &state, true, find("groups").unwrap()).unwrap();
    let names: Vec<_> = found.polygons.iter().flat_map(|plan| &plan.items).map(|v| v.name.as_str()).collect();
    assert!(names.iter().any(|name| name.starts_with("R(B from ")), "{names:?}");
    assert!(!names.contains(&"R(B)") && names.contains(&"R(C)"), "{names:?}");
}
