//! Files written by hand.

use assur_import::{Imported, Source, import};
use assur_mechanism::Mechanism;
use assur_words::Language;

/// With units of 1 mm the numbers are read off.
fn imported(content: &str) -> Imported {
    let source = Source { file: "x.linkage2", bytes: content.as_bytes(), unit: Some(1e-3) };
    import(&source, None, Language::english()).unwrap()
}

fn scene(content: &str) -> (Imported, Mechanism) {
    let imported = imported(content);
    let mechanism = assur_scene::read("x", &imported.scene)
        .unwrap_or_else(|errors| panic!("{errors}\n{}", imported.scene));
    (imported, mechanism)
}

fn has(imported: &Imported, line: &str) {
    assert!(imported.scene.lines().any(|found| found == line), "{line}\nis not in\n{}", imported.scene);
}

const CRANK: &str = r#"
    <connector id="0" anchor="true" input="true" rpm="30" x="0" y="0"/>
    <connector id="1" x="0" y="30"/>
    <Link id="0"><connector id="0"/><connector id="1"/></Link>"#;

fn file(rest: &str) -> String {
    format!("<linkage2><program units=\"Millimeters\" zoom=\"1\"/>{CRANK}{rest}</linkage2>")
}

#[test]
fn a_four_bar_has_the_names_that_the_program_shows_and_turns_clockwise() {
    let rest = r#"<connector id="27" name="тяга" x="40" y="30"/><connector id="2" anchor="true" x="40" y="-20"/>
        <Link id="4"><connector id="1"/><connector id="27"/></Link>
        <Link id="5" name="rocker"><connector id="27"/><connector id="2"/></Link>"#;
    let (imported, mechanism) = scene(&file(rest));
    assert!(imported.lost.is_empty(), "{:?}", imported.lost);
    let names: Vec<&str> = mechanism.points.iter().map(|point| point.name.as_str()).collect();
    assert_eq!(names, ["A", "C", "B", "тяга"]);
    let links: Vec<&str> = mechanism.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(links, ["ground", "L1", "L5", "rocker"]);
    has(&imported, "points = { A = [0, 0], C = [0.04, -0.02] }");
    has(&imported, "points = { B = [0, 0], \"тяга\" = [0.04, 0] }");
    has(&imported, "points = { \"тяга\" = [0, 0], C = [0.05, 0] }");
    has(&imported, "direction = \"cw\"");
    // 30 rpm are pi rad/s.
    has(&imported, "speed = 3.14159265358979");
}

#[test]
fn a_unit_of_the_file_is_a_96th_of_an_inch() {
    let bytes = file("").replace("y=\"30\"", "y=\"96\"");
    let source = Source { file: "", bytes: bytes.as_bytes(), unit: None };
    let scene = import(&source, None, Language::english()).unwrap().scene;
    assert!(scene.contains("points = { A = [0, 0], B = [0.0254, 0] }"), "{scene}");
    assert!(scene.contains("# A unit of the file is 0.264583 mm"));
}

#[test]
fn a_pin_in_a_slot_is_a_block_on_the_link_of_its_ends() {
    // The crank pin slides in a link that is pinned at (0, -40) and goes up.
    let content = file(
        r#"<connector id="4" anchor="true" x="0" y="-40"/><connector id="5" x="0" y="100"/>
        <Link id="2"><connector id="4"/><connector id="5"/></Link>"#,
    )
    .replace(
        r#"<connector id="1" x="0" y="30"/>"#,
        r#"<connector id="1" x="0" y="30" slider="true"><slidelimit id="4"/><slidelimit id="5"/></connector>"#,
    );
    let (imported, mechanism) = scene(&content);
    assert!(imported.lost.is_empty());
    assert_eq!((mechanism.links.len(), mechanism.slides.len()), (4, 1));
    for line in ["link = \"B-block\"", "on = \"L3\"", "through = [0, 0]", "angle = 0", "tilt = 0"] {
        has(&imported, line);
    }
    has(&imported, "# Replaced: the pin B in its slot by a pin in a block without mass.");
}

#[test]
fn a_slot_between_anchors_is_on_the_ground_and_an_anchored_slider_holds_a_block() {
    let rest = r#"<connector id="2" x="40" y="0" slider="true"><slidelimit id="3"/><slidelimit id="4"/></connector>
        <connector id="3" anchor="true" x="-10" y="0"/><connector id="4" anchor="true" x="90" y="0"/>
        <Link id="1"><connector id="1"/><connector id="2"/></Link>"#;
    let (imported, _) = scene(&file(rest));
    for line in ["on = \"ground\"", "through = [-0.01, 0]", "point = \"C\""] {
        has(&imported, line);
    }
    // A swinging guide: the rod slides through a block pinned at (0, 80).
    let rest = r#"<connector id="2" x="0" y="130"/>
        <connector id="3" anchor="true" x="0" y="80" slider="true"><slidelimit id="1"/><slidelimit id="2"/></connector>
        <Link id="1"><connector id="1"/><connector id="2"/></Link><Link id="7"><connector id="3"/></Link>"#;
    let (imported, mechanism) = scene(&file(rest));
    for line in ["link = \"D-block\"", "on = \"L2\"", "points = { A = [0, 0], D = [0, 0.08] }"] {
        has(&imported, line);
    }
    assert_eq!(mechanism.links.len(), 4);
}

#[test]
fn a_curved_slot_is_a_rod_to_its_center() {
    // Ends 60 mm apart, radius 50: the center is 40 mm to the left of the line between them, and for -50 to the right.
    for (radius, y) in [("50", "0.04"), ("-50", "-0.04")] {
        let rest = format!(
            r#"<connector id="2" x="60" y="-10" slider="true" slideradius="{radius}"><slidelimit id="3"/><slidelimit id="4"/></connector>
            <connector id="3" anchor="true" x="30" y="0"/><connector id="4" anchor="true" x="90" y="0"/>
            <Link id="1"><connector id="1"/><connector id="2"/></Link>"#
        );
        let (imported, _) = scene(&file(&rest));
        has(&imported, &format!("points = {{ A = [0, 0], C-center = [0.06, {y}] }}"));
        assert!(imported.scene.contains("as long as its radius 50.0000 mm"));
        has(&imported, "[link.C-arm]");
    }
}

#[test]
fn a_cylinder_is_a_barrel_and_a_rod_whose_slide_drives() {
    let content = r#"<linkage2><connector id="0" anchor="true" x="0" y="0"/><connector id="1" anchor="true" x="30" y="0"/>
        <connector id="2" x="30" y="40"/>
        <Link id="0"><connector id="1"/><connector id="2"/></Link>
        <Link id="1" actuator="true" throw="10" cpm="6"><connector id="0"/><connector id="2"/></Link></linkage2>"#;
    let (again, imported) = (imported, imported(content));
    // 50 mm long, ten more in 5 s: 6 times a minute there and back.
    for line in [
        "slide = \"L2-stroke\"",
        "from = 0.05",
        "to = 0.06",
        "speed = 0.002",
        "[link.L2-barrel]",
        "[link.L2-rod]",
    ] {
        has(&imported, line);
    }
    let pulls = again(&content.replace("cpm=\"6\"", "cpm=\"-6\" startoffset=\"4\""));
    for line in ["from = 0.054", "to = 0.044", "direction = \"cw\""] {
        has(&pulls, line);
    }
}

#[test]
fn an_input_that_swings_goes_over_its_angle() {
    // Upright; clockwise from 10 degrees behind to 50 before.
    let limited = file("").replace("rpm=\"30\"", "rpm=\"30\" limitangle=\"60\" startoffset=\"10\"");
    let (imported, _) = scene(&limited);
    let at = |degrees: f64| degrees.to_radians();
    let number = |key: &str| {
        let found = imported.scene.lines().find_map(|line| line.strip_prefix(&format!("{key} = ")));
        found.unwrap().parse::<f64>().unwrap()
    };
    assert!((number("from") - at(100.0)).abs() < 1e-14 && (number("to") - at(40.0)).abs() < 1e-14);
}

#[test]
fn links_at_one_input_and_fastened_links_are_one() {
    let rest = r#"<connector id="2" x="20" y="0"/><connector id="3" x="0" y="50"/><connector id="4" x="5" y="5" fastenlink="0"/>
        <Link id="1"><connector id="0"/><connector id="2"/></Link>
        <Link id="2" fastenlink="0"><connector id="1"/><connector id="3"/></Link>"#;
    let (imported, mechanism) = scene(&file(rest));
    assert_eq!(mechanism.links.len(), 2);
    has(
        &imported,
        "points = { A = [0, 0], B = [0.03, 0], E = [0.005, -0.005], D = [0.05, 0], C = [0, -0.02] }",
    );
}

#[test]
fn gears_chains_and_what_turns_with_a_connector_are_named() {
    let rest = r#"<connector id="2" anchor="true" x="70" y="0"/><connector id="3" x="90" y="0"/>
        <Link id="1" gear="true" name="wheel"><connector id="2"/><connector id="3"/></Link>
        <ratios><ratio type="gears"><link id="0" size="2"/><link id="1" size="1"/></ratio>
        <ratio type="chain"><link id="0" size="25"/><link id="1" size="10"/></ratio></ratios>"#;
    let imported = imported(&file(rest));
    let lost: Vec<String> = imported.lost.iter().map(ToString::to_string).collect();
    assert!(lost.contains(&"the gears L1, wheel (2 : 1): a scene has no gears.".to_owned()), "{lost:?}");
    assert!(
        lost.contains(&"the chain between L1, wheel (25 : 10): a scene has no chains.".to_owned()),
        "{lost:?}"
    );
    // The wheel is a mechanism of its own then.
    assert!(lost.iter().any(|lost| lost.ends_with("Links of the others: wheel.")), "{lost:?}");
}

#[test]
fn decoration_is_counted_and_a_file_of_windows_is_read() {
    let rest = r#"<connector id="8" layer="1" x="1" y="1"/><connector id="9" layer="1" x="2" y="1"/>
        <Link id="8" layer="1"><connector id="8"/><connector id="9"/></Link>
        <Link id="9" layer="16" measurementelement="true"><connector id="0"/><connector id="1"/></Link>"#;
    let imported = imported(&file(rest));
    has(&imported, "# Left out: 4 lines, points and measures that belong to no moving part.");
    let mut bytes = file("").replace("<Link id=\"0\"", "<Link id=\"0\" name=\"K?rper\"").into_bytes();
    let at = bytes.iter().position(|byte| *byte == b'?').unwrap();
    bytes[at] = 0xF6;
    let read =
        import(&Source { file: "a.linkage2", bytes: &bytes, unit: None }, None, Language::english()).unwrap();
    assert!(read.scene.contains("[link.\"Körper\"]"), "{}", read.scene);
}

#[test]
fn a_file_that_is_none_says_what_and_where() {
    let refused = |content: &str| {
        let source = Source { file: "a.linkage2", bytes: content.as_bytes(), unit: None };
        import(&source, None, Language::english()).unwrap_err().to_string()
    };
    assert!(refused("<linkage2>").contains("save it again"));
    assert!(refused("<svg/>").contains("`svg`, not `linkage2`"));
    let wrong = file("").replace("y=\"30\"", "y=\"3o\"");
    assert_eq!(refused(&wrong), "`y` is `3o` in line 3, not a number; correct the file");
    assert!(refused("<linkage2></linkage2>").contains("nothing in the drawing moves"));
}
