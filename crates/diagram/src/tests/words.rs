use assur_force::{LoadState, Loads, find};

use super::{compile, fixture};
use crate::sheet;

#[test]
fn a_sheet_has_everything_and_serializes() {
    let linkage = compile(&fixture("press"));
    let loads = Loads::compile(&linkage).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, -1.9);
    let found = sheet(&linkage, &loads, &state, true, find("groups").unwrap()).unwrap();
    assert_eq!((found.polygons.len(), found.centers.len(), found.constructions.len()), (2, 6, 3));
    assert!(found.constructions.iter().all(|plan| plan.residual < 1e-12));
    let json = serde_json::to_value(&found).unwrap();
    assert_eq!(json["constructions"][1]["items"][0]["name"], "F");
    assert_eq!(json["velocities"]["unit"], "m/s");
    assert_eq!(json["by_cause"]["shares"][0]["cause"], linkage.mechanism.loads[0].name.as_str());
}

#[test]
fn where_the_published_form_fails_the_sheet_still_comes() {
    let scene = fixture("press").replace(
        "from = \"-70 deg\"\nto = \"-110 deg\"\npositions = 33\ndirection = \"cw\"",
        "positions = 4",
    );
    let linkage = compile(&scene);
    let loads = Loads::compile(&linkage).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, 0.0);
    let found = sheet(&linkage, &loads, &state, true, find("longitudinal").unwrap()).unwrap();
    assert_eq!(found.constructions.len(), 3);
}

/// At the conveyor's pin of three links, an arrow of a polygon is the share of one pair, and is called so.
#[test]
fn a_share_of_a_multiple_joint_is_not_called_by_the_whole_reaction() {
    let linkage = compile(&fixture("conveyor"));
    let loads = Loads::compile(&linkage).unwrap();
    let state = LoadState::prescribed(&linkage.mechanism, linkage.mechanism.input.coordinate(2));
    let found = sheet(&linkage, &loads, &state, true, find("groups").unwrap()).unwrap();
    let names: Vec<_> =
        found.polygons.iter().flat_map(|plan| &plan.items).map(|v| v.name.to_string()).collect();
    assert!(names.iter().any(|name| name.starts_with("R(B from ")), "{names:?}");
    assert!(!names.iter().any(|name| name == "R(B)") && names.iter().any(|name| name == "R(C)"), "{names:?}");
}
