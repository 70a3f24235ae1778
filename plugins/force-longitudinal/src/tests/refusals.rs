use assur_force::ForceAnalyzer;

use super::{compile, fixture};
use crate::Longitudinal;

fn refusal(scene: &str) -> String {
    Longitudinal::Stable.supports(&compile(scene)).unwrap_err().to_string()
}

const FOUR_BAR: &str = "[ground]\npoints = { O = 0, C = 0.4 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n\
    [link.rod]\npoints = { A = 0, B = 0.4 }\n[link.rocker]\npoints = { C = 0, B = 0.3 }\n[input]\nlink = 'crank'\n";

#[test]
fn a_sliding_input() {
    let scene = "[ground]\npoints = { C = [0.3, 0.1] }\n[link.ram]\npoints = { A = 0 }\n[link.rod]\npoints = { A = 0, B = 0.4 }\n\
        [link.rocker]\npoints = { C = 0, B = 0.3 }\n[[slide]]\nlink = 'ram'\non = 'ground'\n[input]\nlink = 'ram'\nto = 0.05\n";
    assert_eq!(refusal(scene), "its input link `ram` slides; the method needs a crank");
}

#[test]
fn a_balancing_load_elsewhere() {
    let scene = format!("{FOUR_BAR}[balance]\nlink = 'rocker'\n");
    assert_eq!(refusal(&scene), "`[balance]` puts the balancing load elsewhere than on the crank `crank`");
    let on_crank = format!("{FOUR_BAR}[balance]\nlink = 'crank'\n");
    assert_eq!(Longitudinal::Published.supports(&compile(&on_crank)), Ok(()));
}

#[test]
fn more_than_one_group() {
    assert_eq!(refusal(&fixture("stephenson3.toml")), "it has 2 groups; the method needs one");
}

#[test]
fn no_group() {
    let scene =
        "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[input]\nlink = 'crank'\n";
    assert_eq!(refusal(scene), "it has 0 groups; the method needs one");
}

#[test]
fn another_kind_of_group() {
    let scene = "[ground]\npoints = { O = 0, C = [0, -0.4] }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n[link.stone]\n\
        points = { A = 0 }\n[link.rocker]\npoints = { C = 0 }\n[[slide]]\nlink = 'stone'\non = 'rocker'\nthrough = 'C'\n\
        [input]\nlink = 'crank'\n";
    assert_eq!(refusal(scene), "its group is of kind RPR; the method needs RRP or RRR");
}

#[test]
fn a_slide_on_the_crank() {
    let scene = "[ground]\npoints = { O = 0, C = [0.3, 0.1] }\n[link.crank]\npoints = { O = 0 }\n[link.stone]\n\
        points = { B = 0 }\n[link.rod]\npoints = { C = 0, B = 0.5 }\n[[slide]]\nlink = 'stone'\non = 'crank'\n\
        [input]\nlink = 'crank'\n";
    assert_eq!(refusal(scene), "its slide is on the crank `crank`; the method needs a guide on the ground");
}

#[test]
fn a_group_on_the_crank_alone() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1, D = 0.5 }\n[link.rod]\n\
        points = { A = 0, B = 0.3 }\n[link.strut]\npoints = { D = 0, B = 0.3 }\n[input]\nlink = 'crank'\n";
    assert_eq!(refusal(scene), "its group is not carried by the crank `crank` and the ground");
}

#[test]
fn a_crank_without_length() {
    // The reader of scenes refuses such a link; a mechanism from elsewhere may have one.
    let mut mechanism = assur_scene::read("test.toml", FOUR_BAR).unwrap_or_else(|errors| panic!("{errors}"));
    let crank_pin = mechanism.points.iter_mut().find(|point| point.name == "A").unwrap();
    crank_pin.places[0].at = [0.0, 0.0];
    let linkage = assur_kinematics::Linkage::compile(mechanism).unwrap();
    let refusal = Longitudinal::Stable.supports(&linkage).unwrap_err();
    assert_eq!(refusal.to_string(), "the crank `crank` has no length");
}

#[test]
fn solving_a_mechanism_that_is_not_supported_is_an_error() {
    let linkage = compile(&fixture("stephenson3.toml"));
    let error = super::reactions(&Longitudinal::Published, &linkage, 0.6).unwrap_err();
    assert_eq!(
        error.to_string(),
        "force analyzer `longitudinal-published` does not support this mechanism: it has 2 groups; the method needs one"
    );
}
