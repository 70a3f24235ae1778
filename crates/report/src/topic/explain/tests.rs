//! The explanation names what is done, what is left out, and why.

use assur_all as _;
use assur_analysis::{Options, methods, plan};
use assur_mechanism::Mechanism;
use assur_structure::Structure;

use super::model::{modelled, not_modelled};
use crate::text::Style;

fn scene(name: &str, change: impl Fn(String) -> String) -> Mechanism {
    assur_scene::read(name, &change(assur_fixtures::scene(name).to_owned())).unwrap()
}

fn explained_by(mechanism: &Mechanism, analyzer: Option<&str>) -> String {
    let structure = Structure::of(mechanism).unwrap();
    let options = Options { analyzer: analyzer.map(str::to_owned), ..Options::default() };
    let methods = methods(mechanism, &structure, &options);
    let plan = plan(mechanism, &structure, &options);
    crate::text::told(Style::english(), |page| {
        super::explain(mechanism, &structure, &plan, &methods, None, page);
    })
}

/// What is said of one stage: all its lines in one.
fn stage(mechanism: &Mechanism, name: &str) -> String {
    let text = explained_by(mechanism, None);
    let start = text.find(&format!("\n{name}: ")).unwrap() + 1;
    let lines = text[start..].lines().enumerate().take_while(|(i, line)| *i == 0 || line.starts_with("  "));
    lines.map(|(_, line)| line.trim()).collect::<Vec<_>>().join(" ")
}

/// The shaper without its masses (but for the named links'), limited to an output.
fn shaper(heavy: &[&str], moves: bool, output: &str) -> Mechanism {
    let mut mechanism = scene("shaper", |text| format!("{text}\n[output]\n{output}\n"));
    for link in &mut mechanism.links {
        if !heavy.contains(&link.name.as_str()) {
            (link.mass, link.inertia) = (0.0, 0.0.into());
        }
    }
    if !moves {
        mechanism.motion = None;
    }
    mechanism
}

#[test]
fn stages_that_nothing_needs_are_left_out() {
    let kinematic = scene("shaper", |text| format!("{text}\n[output]\npoints = [\"S3\"]\n"));
    for name in ["inertia loads", "reactions", "balancing load", "checks", "equation of motion"] {
        assert!(stage(&kinematic, name).contains(": left out: "), "{name}");
    }
    let none = shaper(&[], false, "reactions = []");
    let transfer = stage(&none, "transfer functions (PF1, PF2)");
    assert!(transfer.contains("left out: orders up to 0"), "{transfer}");
}

#[test]
fn what_is_saved_is_named() {
    let still = shaper(&[], false, "reactions = [\"A\"]");
    assert!(stage(&still, "transfer functions (PF1, PF2)").contains("saves PF2 of 2 groups"));
    let crank = shaper(&["crank"], false, "reactions = [\"A\"]");
    assert!(stage(&crank, "reduction to the input link").contains("crank alone"));
    let mut light = shaper(&["rocker"], true, "reactions = [\"A\"]");
    light.loads.clear();
    assert!(stage(&light, "reactions").contains("1 of 2 groups not solved"));
}

#[test]
fn a_method_for_the_whole_system_says_so() {
    let mut light = shaper(&["rocker"], true, "reactions = [\"A\"]");
    light.loads.clear();
    let text = explained_by(&light, Some("newton-euler"));
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("solves the mechanism as one system"), "{text}");
}

#[test]
fn what_is_not_modelled_is_named_with_the_way_to_include_it() {
    let press = scene("press", |text| text);
    let how = |what: &str| {
        let mut remarks = not_modelled(&press).into_iter().map(|remark| remark.to_string());
        remarks.find(|remark| remark.starts_with(what))
    };
    assert!(how("mass of crank, rod, slider").unwrap().contains("add `mass`"));
    assert!(how("weights").unwrap().contains("gravity"));
    assert!(how("friction in pairs").unwrap().contains("[[friction]]"));
    assert!(how("velocities").is_none());
    assert!(modelled(&press).iter().any(|remark| remark.to_string().starts_with("contact 1 on rod: ")));
}

#[test]
fn every_part_has_its_heading() {
    let text = explained_by(&scene("shaper", |text| text), None);
    for words in ["\n1. Structure\n", "group 1 (RPR stone2, rocker)", "\n3. Modeled\n", "\n4. Not modeled\n"]
    {
        assert!(text.contains(words), "{words}");
    }
    assert_eq!(text.matches(": run: ").count() + text.matches(": left out: ").count(), 11);
}
