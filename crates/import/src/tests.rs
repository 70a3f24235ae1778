//! Drawings made by hand, and the scenes that hand calculation gives.

use std::f64::consts::FRAC_PI_2;

use assur_words::{Language, text};

use crate::{
    Drawing, Driven, Force, Imported, ImporterPlugin, Input, Joint, Link, Sign, Slide, Source, import,
};

fn joint(name: &str, at: [f64; 2], is_grounded: bool) -> Joint {
    Joint { name: name.to_owned(), at, is_grounded }
}

fn link(name: &str, joints: &[usize]) -> Link {
    Link { name: name.to_owned(), joints: joints.to_vec(), ..Link::default() }
}

/// A slider-crank: crank of 30 mm upright, rod of 50 mm, block on the x axis, 40 mm from the crank's pin.
fn slider_crank() -> Drawing {
    Drawing {
        joints: vec![
            joint("O", [0.0, 0.0], true),
            joint("A", [0.0, 0.03], false),
            joint("B", [0.04, 0.0], false),
        ],
        links: vec![link("crank", &[0, 1]), link("rod", &[1, 2]), link("block", &[2])],
        slides: vec![Slide { name: "way".to_owned(), link: 2, on: None, joint: 2, ..Slide::default() }],
        inputs: vec![Input { pair: Driven::Pin { joint: 0, of: 0, on: None }, rate: -2.0, travel: None }],
        ..Drawing::default()
    }
}

fn written(mut drawing: Drawing) -> Imported {
    crate::mechanism::reduce(&mut drawing).unwrap();
    let lost = drawing.remarks.iter().filter(|one| one.is_lost).map(|one| one.text.clone()).collect();
    Imported { scene: crate::scene::write(&drawing, "test", Language::english()), lost }
}

fn has(scene: &str, line: &str) {
    assert!(scene.lines().any(|found| found == line), "{line}\nis not in\n{scene}");
}

#[test]
fn a_slider_crank_is_said_as_hand_calculation_gives() {
    let Imported { scene, lost } = written(slider_crank());
    assert!(lost.is_empty());
    for line in [
        "points = { O = [0, 0] }",
        "points = { O = [0, 0], A = [0.03, 0] }",
        "points = { A = [0, 0], B = [0.05, 0] }",
        "through = [0, 0]",
        "point = \"B\"",
        "direction = \"cw\"",
        "speed = 2",
        "A = [0, 0.03]",
        "B = [0.04, 0]",
    ] {
        has(&scene, line);
    }
    has(&scene, "from = 1.5707963267949");
    let mechanism = assur_scene::read("test", &scene).unwrap();
    assert_eq!((mechanism.links.len(), mechanism.slides.len()), (4, 1));
}

#[test]
fn masses_forces_and_weights_are_in_the_frames_of_their_links() {
    let mut drawing = slider_crank();
    drawing.has_gravity = true;
    drawing.links[0] = Link { mass: 2.0, center: Some([0.0, 0.01]), inertia: 0.5, ..link("crank", &[0, 1]) };
    // Upwards at A: along the crank, on its x axis.
    let force = Force {
        name: "P".to_owned(),
        link: 0,
        at: [0.0, 0.03],
        angle: FRAC_PI_2,
        value: 7.0,
        is_local: true,
    };
    drawing.forces = vec![force.clone(), Force { name: "Q".to_owned(), is_local: false, ..force }];
    let scene = written(drawing).scene;
    for line in
        ["gravity = 9.81", "mass = 2", "center = [0.01, 0]", "inertia = 0.5", "angle = 0", "value = 7"]
    {
        has(&scene, line);
    }
    has(&scene, "frame = \"link\"");
    has(&scene, "angle = 1.5707963267949");
    assur_scene::read("test", &scene).unwrap();
}

#[test]
fn what_cannot_move_or_stands_beside_is_left_out_with_a_remark() {
    let mut drawing = slider_crank();
    drawing.joints.extend([
        joint("C", [1.0, 0.0], true),
        joint("D", [1.0, 1.0], true),
        joint("E", [1.0, 2.0], false),
        joint("F", [2.0, 2.0], false),
    ]);
    // Fixed twice; on its free end a link alone; a flag on a pin.
    drawing.links.extend([link("frame", &[3, 4, 5]), link("arm", &[5, 6]), link("flag", &[6])]);
    let Imported { scene, lost } = written(drawing);
    has(&scene, "# A link with two fixed joints is a part of the ground: frame.");
    has(&scene, "# Links that only one joint holds are left out, nothing depends on them: flag.");
    assert_eq!(lost.len(), 1);
    assert!(scene.contains("Links of the others: arm."), "{scene}");
    assert!(!scene.contains("[link.arm]") && scene.contains("[link.crank]"));
}

#[test]
fn a_guide_on_a_fixed_link_is_a_guide_on_the_ground() {
    let mut drawing = slider_crank();
    drawing.joints.extend([joint("C", [-0.1, 0.0], true), joint("D", [0.2, 0.0], true)]);
    drawing.links.push(link("bed", &[3, 4]));
    drawing.slides[0].on = Some(3);
    has(&written(drawing).scene, "on = \"ground\"");
    // The same pair the other way round: the rod's guide moves on a fixed block.
    let mut drawing = slider_crank();
    drawing.joints.extend([joint("C", [0.0, 0.5], true), joint("D", [0.1, 0.5], true)]);
    drawing.links.push(link("bed", &[3, 4]));
    let slide =
        Slide { name: "way".to_owned(), link: 3, on: Some(2), joint: 3, through: [0.0, 0.5], angle: 0.0 };
    drawing.slides = vec![slide];
    let scene = written(drawing).scene;
    for line in ["link = \"block\"", "on = \"ground\"", "through = [0.04, 0]", "point = \"B\""] {
        has(&scene, line);
    }
}

#[test]
fn several_inputs_go_over_time_and_a_swing_goes_there_and_back() {
    let mut drawing = slider_crank();
    drawing.inputs.push(Input { pair: Driven::Slide(0), rate: 0.01, travel: Some([-0.01, 0.03]) });
    let scene = written(drawing).scene;
    // From 40 mm to 70 in 3 s, to 30 in 4 s, back in 1 s; the crank turns in pi seconds.
    has(&scene, "over_time = { table = [[0, 0.04], [3, 0.07], [7, 0.03], [8, 0.04]] }");
    for line in ["[[input]]", "rate = -2", "until = 8", "samples = 40"] {
        has(&scene, line);
    }
    let mut drawing = slider_crank();
    drawing.inputs[0].travel = Some([-1.0, 0.5]);
    let scene = written(drawing).scene;
    has(&scene, "from = 2.0707963267949");
    has(&scene, "to = 0.570796326794897");
}

#[test]
fn names_are_those_that_a_scene_can_have() {
    let mut drawing = slider_crank();
    drawing.title = "a \"title\"\nwith lines".to_owned();
    drawing.joints[0].name = "ground".to_owned();
    drawing.joints[1].name = "A.\u{7}x".to_owned();
    drawing.joints[2].name = "A.\u{7}x".to_owned();
    drawing.links[0].name = "кривошип = \"1\"]\n[link.x]".to_owned();
    drawing.links[1].name = String::new();
    drawing.remarks.push(crate::Remark { text: assur_words::name("a\n[link.y]"), is_lost: false });
    let scene = written(drawing).scene;
    let mechanism = assur_scene::read("test", &scene).unwrap();
    let names: Vec<&str> = mechanism.points.iter().map(|point| point.name.as_str()).collect();
    assert_eq!(names, ["ground-2", "A__x", "A__x-2"]);
    assert_eq!(mechanism.title, "a \"title\"with lines");
}

#[test]
fn a_drawing_without_an_input_says_so_and_one_without_links_is_refused() {
    let mut drawing = slider_crank();
    drawing.inputs.clear();
    assert_eq!(written(drawing.clone()).lost.len(), 1);
    drawing.links.clear();
    drawing.slides.clear();
    assert!(crate::mechanism::reduce(&mut drawing).is_err());
    let mut drawing = slider_crank();
    drawing.joints[1].at[0] = f64::NAN;
    assert!(drawing.check().unwrap_err().to_string().contains("`A`"));
}

inventory::submit! {
    ImporterPlugin {
        name: "sketch",
        crate_name: "test",
        summary: text!("import-sort"),
        source: text!("import-sort"),
        signs: &[Sign::Ending(".sketch"), Sign::Prefix("sketch:")],
        read: |source| {
            assert_eq!(source.unit, None);
            Ok(slider_crank())
        },
    }
}

#[test]
fn a_format_is_known_by_ending_or_beginning_or_named() {
    let of = |file, content: &str, format| {
        import(&Source { file, bytes: content.as_bytes(), unit: None }, format, Language::english())
    };
    assert!(of("a.SKETCH", "", None).is_ok());
    assert!(of("", " \u{feff}sketch: 1", None).is_err());
    assert!(of("", "\u{feff} sketch: 1", None).is_ok());
    assert!(of("x.dat", "", Some("sketch")).is_ok());
    let unknown = of("x.dat", "", None).unwrap_err().to_string();
    assert!(
        unknown.contains("sketch (a file that ends in .sketch, text that begins with sketch:)"),
        "{unknown}"
    );
    assert!(of("x.dat", "", Some("other")).unwrap_err().to_string().contains("sketch"));
}

#[test]
fn an_input_and_a_force_of_a_link_that_is_left_out_are_named() {
    let mut drawing = slider_crank();
    drawing.joints.extend([joint("C", [1.0, 0.0], true), joint("D", [1.0, 1.0], true)]);
    drawing.links.push(link("frame", &[3, 4]));
    drawing.inputs.push(Input { pair: Driven::Pin { joint: 3, of: 3, on: None }, rate: 1.0, travel: None });
    let force =
        Force { name: "P".to_owned(), link: 3, at: [0.0; 2], angle: 0.0, value: 1.0, is_local: false };
    drawing.forces.push(force);
    let Imported { scene, lost } = written(drawing);
    assert_eq!(lost.len(), 2);
    has(&scene, "# NOT IN THE SCENE: inputs of the links that are left out: 1.");
    has(&scene, "# NOT IN THE SCENE: forces on the links that are left out: 1.");
}
