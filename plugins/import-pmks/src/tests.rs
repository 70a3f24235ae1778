//! Links written by hand.

use assur_import::{Imported, Source, import};
use assur_words::Language;

const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";

/// A number in thousandths, as the link has it.
fn n(value: f64) -> String {
    #[expect(clippy::cast_possible_truncation, reason = "numbers of a drawing")]
    let whole = (value * 1000.0).round() as i64;
    let mut rest = whole.unsigned_abs();
    let mut digits = Vec::new();
    while rest > 0 || digits.is_empty() {
        digits.push(DIGITS.as_bytes()[usize::try_from(rest % 64).unwrap()] as char);
        rest /= 64;
    }
    let sign = if whole < 0 { "0" } else { "" };
    format!("{sign}{}", digits.iter().rev().collect::<String>())
}

fn joint(flags: &str, name: &str, [x, y]: [f64; 2], angle: f64) -> String {
    format!("{flags}{name},{name},{},{},{}.", n(x), n(y), n(angle))
}

fn link(kind: &str, name: &str, [mass, inertia, x, y]: [f64; 4], joints: &str) -> String {
    format!("{kind}{name},{name},{},{},{},{},ffffff,{joints},,.", n(mass), n(inertia), n(x), n(y))
}

fn address(flags: &str, units: &str, parts: [&str; 3]) -> String {
    let [joints, links, forces] = parts;
    let content = format!("{flags}.{}.U,0.{units}.{joints}.{links}.{forces}.NA", n(1.0));
    let control = DIGITS.as_bytes()[content.len() % 62] as char;
    format!("https://app.pmksplus.com/?{content}{control}")
}

fn read(address: &str) -> Result<Imported, String> {
    let source = Source { file: "", bytes: address.as_bytes(), unit: None };
    import(&source, None, Language::english()).map_err(|problem| problem.to_string())
}

fn has(imported: &Imported, line: &str) {
    assert!(imported.scene.lines().any(|found| found == line), "{line}\nis not in\n{}", imported.scene);
}

/// Crank from (0, 0) to (0, 3), rod to (4, 0), where a piston slides along the x axis.
fn slider_crank(flags: &str, units: &str, forces: &str) -> String {
    let joints = joint("6", "A", [0.0, 0.0], 0.0)
        + &joint("0", "B", [0.0, 3.0], 0.0)
        + &joint("0", "C", [4.0, 0.0], 0.0)
        + &joint("5", "D", [4.0, 0.0], 0.0);
    let links = link("YR", "AB", [2.0, 0.5, 0.0, 1.0], "A,B")
        + &link("YR", "BC", [0.0, 0.0, 2.0, 1.5], "B,C")
        + &link("YP", "CD", [3.0, 0.0, 0.0, 0.0], "C,D");
    address(flags, units, [&joints, &links, forces])
}

#[test]
fn numbers_are_as_the_program_writes_them() {
    // From its own links: 1000 thousandths are `Fe`, and `0P` are the flags 25.
    assert_eq!((n(1.0).as_str(), n(-0.025).as_str()), ("Fe", "0P"));
}

#[test]
fn a_slider_crank_in_each_unit_of_length() {
    for (units, unit) in [("001", 0.0254), ("101", 0.01), ("201", 1.0)] {
        let imported = read(&slider_crank("00", units, "")).unwrap();
        assert!(imported.lost.is_empty());
        assur_scene::read("x", &imported.scene).unwrap();
        let at = |x: f64| ((x * unit * 1e12).round() / 1e12).to_string();
        has(&imported, &format!("points = {{ A = [0, 0], B = [{}, 0] }}", at(3.0)));
        has(&imported, &format!("points = {{ B = [0, 0], C = [{}, 0] }}", at(5.0)));
        has(&imported, &format!("C = [{}, 0]", at(4.0)));
        // The center is a third of the way along the crank; kg and kg times the unit squared.
        has(&imported, &format!("center = [{}, 0]", at(1.0)));
        has(&imported, &format!("inertia = {}", at(0.5 * unit)));
        for line in
            ["mass = 2", "mass = 3", "center = [0, 0]", "link = \"CD\"", "on = \"ground\"", "point = \"C\""]
        {
            has(&imported, line);
        }
        // 30 rpm are pi rad/s; without the flag counter-clockwise.
        has(&imported, "speed = 3.14159265358979");
        assert!(!imported.scene.contains("direction") && !imported.scene.contains("gravity ="));
    }
}

#[test]
fn flags_and_forces() {
    // Upwards on the crank at (0, 2), with the link; 10 lbf are 44.482216152605 N.
    let force = format!("3F1,AB,P,{},{},{},{},{}.", n(0.0), n(2.0), n(0.0), n(5.0), n(10.0));
    // Clockwise and gravity.
    let imported = read(&slider_crank("03", "100", &force)).unwrap();
    for line in [
        "direction = \"cw\"",
        "gravity = 9.81",
        "name = \"P\"",
        "at = [0.02, 0]",
        "angle = 0",
        "frame = \"link\"",
    ] {
        has(&imported, line);
    }
    has(&imported, "value = 44.482216152605");
    assur_scene::read("x", &imported.scene).unwrap();
    // Forces on: weights count too.
    has(&read(&slider_crank("20", "101", "")).unwrap(), "gravity = 9.81");
    let lost = read(&slider_crank("00", "101", &force.replace("AB", "XY"))).unwrap().lost;
    assert_eq!(lost[0].to_string(), "the force P: its link `XY` is not in the drawing.");
}

#[test]
fn a_guide_between_moving_links_drives() {
    // A boom from (0, 0) over (3, 0) with its cylinder: barrel from (0, -4), rod to (3, 0), guide drawn at half way.
    let angle = 4.0_f64.atan2(3.0);
    let joints = joint("4", "A", [0.0, 0.0], 0.0)
        + &joint("0", "B", [3.0, 0.0], 0.0)
        + &joint("4", "G", [0.0, -4.0], 0.0)
        + &joint("3", "S", [1.5, -2.0], angle);
    let links = link("YR", "AB", [1.0, 0.0, 0.0, 0.0], "A,B")
        + &link("YR", "GS", [1.0, 0.0, 0.0, 0.0], "G,S")
        + &link("YR", "SB", [1.0, 0.0, 0.0, 0.0], "S,B");
    let imported = read(&address("00", "201", [&joints, &links, ""])).unwrap();
    assert!(imported.lost.is_empty());
    for line in
        ["slide = \"S-guide\"", "link = \"SB\"", "on = \"GS\"", "point = \"S\"", "from = 0", "to = 0.4"]
    {
        has(&imported, line);
    }
    assert!(imported.scene.contains("tells no range of the sliding input S"));
    has(&imported, "points = { G = [0, 0] }");
}

#[test]
fn parts_of_a_welded_link_are_no_links() {
    let joints = joint("6", "A", [0.0, 0.0], 0.0)
        + &joint("8", "B", [0.0, 3.0], 0.0)
        + &joint("0", "C", [4.0, 3.0], 0.0);
    let links = link("YR", "ABC", [2.0, 0.0, 0.0, 0.0], "A,B,C")
        + &link("NR", "AB", [1.0, 0.0, 0.0, 0.0], "A,B")
        + &link("NR", "BC", [1.0, 0.0, 0.0, 0.0], "B,C");
    let imported = read(&address("00", "201", [&joints, &links, ""])).unwrap();
    has(&imported, "points = { A = [0, 0], B = [3, 0], C = [3, -4] }");
    assert!(!imported.scene.contains("[link.AB]"));
    has(&imported, "# The joint B is welded: the links that it joins are one.");
}

#[test]
fn a_broken_link_says_what_is_wrong() {
    let whole = slider_crank("00", "101", "");
    assert!(read(&whole[..whole.len() - 4]).unwrap_err().contains("the link is not whole"));
    for empty in ["https://app.pmksplus.com/", "https://app.pmksplus.com/?"] {
        assert!(read(empty).unwrap_err().contains("nothing stands behind the question mark"));
    }
    let content = "00.Fe.U,0.101.6A,A,!,0,0...";
    let broken =
        format!("https://app.pmksplus.com/?{content}N{}", DIGITS.as_bytes()[content.len() + 1] as char);
    assert_eq!(
        read(&broken).unwrap_err(),
        "`!` in `A` is no number of PMKS+ (digits 0-9, A-Z, a-z, _ and -); copy the link again"
    );
    let escaped = whole.replace(",AB,", ",A%42,");
    assert!(read(&escaped).unwrap().scene.contains("[link.AB]"));
}
