//! `rename`, `rename_in_link`, `dependents`, `delete`.

use assur_fixtures::scene;
use assur_mechanism::Key;

use crate::{Part, delete, dependents, rename, rename_in_link, renamed_key};

fn link(name: &str) -> Part {
    Part::Link(name.to_owned())
}

fn point(name: &str) -> Part {
    Part::Point(name.to_owned())
}

fn slide(name: &str) -> Part {
    Part::Slide(name.to_owned())
}

/// The text with these changes, each of which stands so often.
#[track_caller]
fn changed(text: &str, changes: &[(&str, &str, usize)]) -> String {
    let change = |text: String, (old, new, count): &(&str, &str, usize)| {
        assert_eq!(text.matches(old).count(), *count, "{old}");
        text.replace(old, new)
    };
    changes.iter().fold(text.to_owned(), change)
}

#[test]
fn a_link_is_renamed_everywhere() {
    let text = scene("shaper-friction");
    let wanted = changed(
        text,
        &[
            ("[link.ram]", "[link.tool]", 1),
            ("link = \"ram\"", "link = \"tool\"", 2),
            ("on = \"ram\"", "on = \"tool\"", 1),
            ("\"stone4/ram\"", "\"stone4/tool\"", 1),
            ("\"ram/ground\"", "\"tool/ground\"", 1),
        ],
    );
    assert_eq!(rename(text, &link("ram"), "tool").unwrap(), wanted);
    let text = scene("rolling-press");
    let wanted = changed(
        text,
        &[
            ("[link.rod]", "[link.'a b']", 1),
            ("link = \"rod\"", "link = \"a b\"", 1),
            ("links = [\"rod\"]", "links = [\"a b\"]", 1),
        ],
    );
    assert_eq!(rename(text, &link("rod"), "a b").unwrap(), wanted.replace("'a b'", "\"a b\""));
    let text = "[link.a.points]\nA = 0\n[link.a]\nmass = 1\n[[spring]]\nbetween = ['a.A', \"B\"]\n[[slide]]\nname = 'a/ground'\nlink = 'a'\non = 'ground'\n[output]\nslides = ['a/ground']\n";
    let wanted = "[link.b.points]\nA = 0\n[link.b]\nmass = 1\n[[spring]]\nbetween = ['b.A', \"B\"]\n[[slide]]\nname = 'a/ground'\nlink = 'b'\non = 'ground'\n[output]\nslides = ['a/ground']\n";
    assert_eq!(rename(text, &link("a"), "b").unwrap(), wanted);
    assert_eq!(
        rename("link.a.points.A = 0\nlink.a.mass = 1", &link("a"), "b").unwrap(),
        "link.b.points.A = 0\nlink.b.mass = 1"
    );
    assert_eq!(
        rename("link = { a.points.A = 0, a.mass = 1 }", &link("a"), "b").unwrap(),
        "link = { b.points.A = 0, b.mass = 1 }"
    );
}

#[test]
fn a_point_is_renamed_everywhere() {
    let text = scene("rolling-press");
    let wanted = changed(
        text,
        &[
            ("B = ", "tip = ", 3),
            ("point = \"B\"", "point = \"tip\"", 1),
            ("reactions = [\"B\"", "reactions = [\"tip\"", 1),
        ],
    );
    assert_eq!(rename(text, &point("B"), "tip").unwrap(), wanted);
    let text = scene("leg");
    let wanted = changed(text, &[("K = ", "knee = ", 3), ("pin = \"K\"", "pin = \"knee\"", 1)]);
    assert_eq!(rename(text, &point("K"), "knee").unwrap(), wanted);
}

#[test]
fn a_slide_gets_a_name_of_its_own() {
    let text = scene("boom");
    let wanted = changed(
        text,
        &[
            ("on = \"barrel\"\n", "on = \"barrel\"\nname = \"cylinder\"\n", 1),
            ("slide = \"rod/barrel\"", "slide = \"cylinder\"", 1),
        ],
    );
    let renamed = rename(text, &slide("rod/barrel"), "cylinder").unwrap();
    assert_eq!(renamed, wanted);
    assert_eq!(rename(&renamed, &slide("cylinder"), "rod/barrel").unwrap(), text);
    let text = scene("rolling-press");
    assert_eq!(rename(text, &slide("guide"), "x").unwrap(), changed(text, &[("\"guide\"", "\"x\"", 3)]));
    let named = rename(text, &Part::Load("brake", 0), "drum").unwrap();
    assert_eq!(named, changed(text, &[("\"holding brake\"", "\"drum\"", 1)]));
}

#[test]
fn a_name_that_can_not_be_is_refused() {
    let text = scene("shaper-friction");
    let fault = |part: &Part, new: &str| rename(text, part, new).unwrap_err().to_string();
    assert_eq!(fault(&link("ram"), "crank"), "the name `crank` is taken");
    assert_eq!(fault(&point("A"), "D"), "the name `D` is taken");
    assert_eq!(fault(&link("lever"), "x"), "there is no `lever`");
    assert_eq!(fault(&link("ram"), "ram.x"), "`ram.x` can't be the name of a link");
    assert_eq!(fault(&point("A"), ""), "`` can't be the name of a point");
    assert_eq!(fault(&Part::Load("friction", 0), "x"), "`friction[0]` takes no name");
    assert_eq!(fault(&Part::Load("force", 1), "x"), "there is no `force[1]`");
    for (part, new) in [
        (slide("ram/ground"), "A"),
        (link("ram"), "ground"),
        (link("ram"), "moment"),
        (slide("ram/ground"), "stone4/ram"),
    ] {
        assert!(rename(text, &part, new).is_err(), "{part:?} {new}");
    }
    assert!(rename_in_link(text, "ram", "E", "a.b").unwrap_err().to_string().starts_with("`a.b` can't"));
    assert!(rename_in_link(text, "ram", "D", "X").is_err() && rename_in_link(text, "ram", "E", "K").is_err());
}

#[test]
fn a_point_of_one_link_is_renamed_there() {
    let text = scene("shaper-friction");
    let own = rename_in_link(text, "stone4", "D", "D2").unwrap();
    assert_eq!(own, changed(text, &[("points = { D = 0 }\nmass", "points = { D2 = 0 }\nmass", 1)]));
    let alone = rename_in_link(text, "ram", "K", "tip").unwrap();
    assert_eq!(alone, changed(text, &[("K = [", "tip = [", 1), ("at = \"K\"", "at = \"tip\"", 1)]));
    let framed = rename_in_link(text, "rocker", "C", "Q").unwrap();
    let wanted =
        [("points = { C = 0, S3", "points = { Q = 0, S3", 1), ("through = \"C\"", "through = \"Q\"", 1)];
    assert_eq!(framed, changed(text, &wanted));
    let text =
        "[link.a]\npoints = { A = 0 }\n[link.b]\npoints = { B = 0 }\n[assembly]\nA = [0, 1]\nB = [0, 2]\n";
    let joined = rename_in_link(text, "b", "B", "A").unwrap();
    assert_eq!(
        joined,
        "[link.a]\npoints = { A = 0 }\n[link.b]\npoints = { A = 0 }\n[assembly]\nA = [0, 1]\n"
    );
}

#[test]
fn keys_follow_names() {
    let renamed =
        |key: &str, part: &Part, new: &str| renamed_key(&Key::parse(key).unwrap(), part, new).to_string();
    assert_eq!(renamed("link.ram.points.A[0]", &link("ram"), "x"), "link.x.points.A[0]");
    assert_eq!(renamed("link.A.points.A[0]", &point("A"), "x"), "link.A.points.x[0]");
    assert_eq!(renamed("ground.points.A", &point("A"), "x"), "ground.points.x");
    assert_eq!(renamed("assembly.A[1]", &point("A"), "x"), "assembly.x[1]");
    assert_eq!(renamed("slide.ram/ground.angle", &link("ram"), "x"), "slide.x/ground.angle");
    assert_eq!(renamed("slide.ram/ground.angle", &slide("ram/ground"), "x"), "slide.x.angle");
    assert_eq!(renamed("friction.A.radius", &point("A"), "x"), "friction.x.radius");
    assert_eq!(renamed("input.K:shin.rate", &link("shin"), "x"), "input.K:x.rate");
    assert_eq!(renamed("force.ram.value", &link("ram"), "x"), "force.ram.value");
}

#[test]
fn what_hangs_on_a_part_goes_with_it() {
    let of = |scene_name: &str, part: &Part| {
        let mut parts = dependents(scene(scene_name), part);
        parts.sort_unstable();
        parts
    };
    let friction = |index| Part::Load("friction", index);
    assert_eq!(
        of("shaper-friction", &link("ram")),
        [slide("ram/ground"), slide("stone4/ram"), Part::Load("force", 0), friction(5), friction(6)]
    );
    // The crank takes its pins with the ground and the stone, and drives.
    assert_eq!(
        of("shaper-friction", &link("crank")),
        [point("O"), friction(0), friction(2), Part::Load("input", 0)]
    );
    // A stone has no other point than its pin.
    assert_eq!(of("shaper", &point("D")), [link("stone4"), slide("stone4/ram")]);
    assert_eq!(of("shaper-friction", &point("C")), [slide("stone2/rocker"), friction(1), friction(4)]);
    assert_eq!(of("shaper-friction", &slide("ram/ground")), [friction(6)]);
    assert_eq!(of("boom", &slide("rod/barrel")), [Part::Load("input", 0)]);
    assert_eq!(of("leg", &link("shin")), [point("A"), Part::Load("input", 0)]);
    assert_eq!(of("shaper", &point("O")), [Part::Load("input", 0)]);
    let loads = ["balance", "brake", "contact", "input", "moment"].map(|table| Part::Load(table, 0));
    assert_eq!(of("rolling-press", &link("crank")), [&[point("O")], &loads[..2], &loads[3..]].concat());
}

#[test]
fn what_is_deleted_leaves_no_rest() {
    let text = scene("rolling-press");
    let rest = delete(text, &[link("rod")]).unwrap();
    let cut = |text: &str, from: &str, to: &str| {
        let start = text.find(from).unwrap();
        let end = text[start..].find(to).unwrap() + start;
        format!("{}{}", &text[..start], &text[end..])
    };
    let wanted = cut(text, "[link.rod]", "[link.slider]");
    let wanted = cut(&wanted, "[[contact]]", "[[moment]]");
    let changes = [
        ("points = [\"A\", \"N\"]", "points = [\"A\"]", 1),
        ("links = [\"rod\"]\n", "", 1),
        ("[\"B\", \"guide\"]", "[\"guide\"]", 1),
    ];
    assert_eq!(rest, changed(&wanted, &changes));
    let all: Vec<Part> = ["crank", "rod", "slider"].map(link).into();
    let rest = delete(text, &all).unwrap();
    assert_eq!(
        rest,
        format!(
            "{}\n[motion]\nspeed = \"10 rpm\"\n\n{}",
            &text[..text.find("\n[ground]").unwrap()],
            &text[text.find("[note]").unwrap()..text.find("\n[assembly]").unwrap()]
        )
    );
    let rest = delete(scene("shaper-friction"), &[point("S3")]).unwrap();
    assert_eq!(
        rest,
        changed(scene("shaper-friction"), &[(", S3 = \"375 mm\"", "", 1), ("center = \"S3\"\n", "", 1)])
    );
}

/// A link whose points are given by others, and another one with points of the same names.
const PLATE: &str = r#"
[ground]
points = { O = 0, C = 1, G = { r = 1, angle = 0, about = "C" } }
[link.crank]
points = { O = 0, A = 1, B = { r = 1, angle = 0, about = "A" }, P = { from = ["O", "A"], lengths = [1, 1] } }
[link.rod]
points = { A = 0, C = 1, Q = { from = ["A", "C"], lengths = [1, 1] } }
"#;

#[test]
fn points_by_which_places_are_given_are_renamed_in_their_links() {
    let wanted = changed(PLATE, &[("A = ", "D = ", 2), ("\"A\"", "\"D\"", 3)]);
    assert_eq!(rename(PLATE, &point("A"), "D").unwrap(), wanted);
    let wanted = changed(
        PLATE,
        &[
            ("O = 0, A = 1", "O = 0, D = 1", 1),
            ("about = \"A\"", "about = \"D\"", 1),
            ("\"O\", \"A\"", "\"O\", \"D\"", 1),
        ],
    );
    assert_eq!(rename_in_link(PLATE, "crank", "A", "D").unwrap(), wanted);
    let wanted = changed(PLATE, &[("C = 1, G", "D = 1, G", 1), ("about = \"C\"", "about = \"D\"", 1)]);
    assert_eq!(rename_in_link(PLATE, "ground", "C", "D").unwrap(), wanted);
}

#[test]
fn a_point_goes_with_those_by_which_it_is_given() {
    assert_eq!(dependents(PLATE, &point("A")), [point("B"), point("P"), point("Q")]);
    let text = delete(PLATE, &[point("A")]).unwrap();
    assert!(text.contains("[link.crank]\npoints = { O = 0 }\n[link.rod]\npoints = { C = 1 }\n"), "{text}");
    // A point of the ground that another place needs stays with it; a point of another link is none of it.
    assert_eq!(dependents(PLATE, &link("rod")), []);
    let text = delete(PLATE, &[link("rod")]).unwrap();
    assert_eq!(text, &PLATE[..PLATE.find("[link.rod]").unwrap()]);
}
