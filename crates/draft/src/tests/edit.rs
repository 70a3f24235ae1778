//! `set`, `remove`, `append`.

use assur_mechanism::Key;

use crate::{append, remove, set};

const SCENE: &str = "\
# A crank.
title = \"Crank\" # a title

[ground]
points = { O = 0 }

# The crank.
[link.crank]
points = { O = 0, A = \"100 mm\" } # two
mass = 1
# inertia = 2

[[force]] # the first
link = \"crank\"
at = \"A\"
angle = 0
value = 5

# a remark

[[force]]
name = \"second\"
link = \"crank\"
at = \"A\"
angle = 0
value = { over = \"time\", table = [
    [0, 1], # begins
    [1, 2] # ends
] }
# at the end
";

fn key(key: &str) -> Key {
    Key::parse(key).unwrap()
}

#[track_caller]
fn sets(key_of: &str, toml: &str, before: &str, after: &str) {
    let text = set(SCENE, &key(key_of), toml).unwrap();
    assert!(SCENE.contains(before), "{before}");
    assert_eq!(text, SCENE.replacen(before, after, 1), "{text}");
}

#[track_caller]
fn removes(key_of: &str, before: &str, after: &str) {
    let text = remove(SCENE, &key(key_of));
    assert!(SCENE.contains(before), "{before}");
    assert_eq!(text, SCENE.replacen(before, after, 1), "{text}");
}

#[test]
fn a_value_that_stands_changes_alone() {
    sets("title", "\"X\"", "\"Crank\"", "\"X\"");
    sets("link.crank.points.A", "[0, 1]", "\"100 mm\"", "[0, 1]");
    sets("link.crank.points", "{ A = 0 }", "{ O = 0, A = \"100 mm\" }", "{ A = 0 }");
    sets("force.second.value.table[1][0]", "\"2 s\"", "[1, 2]", "[\"2 s\", 2]");
    sets(
        "force.second.value.table[*][1]",
        "3",
        "[0, 1], # begins\n    [1, 2]",
        "[0, 3], # begins\n    [1, 3]",
    );
    sets("force[0].value", "{ formula = \"1\" }", "value = 5", "value = { formula = \"1\" }");
}

#[test]
fn a_value_is_added_in_the_style_of_its_table() {
    sets("link.crank.points.B", "1", "\"100 mm\" }", "\"100 mm\", B = 1 }");
    sets("link.crank.center", "\"O\"", "mass = 1\n", "mass = 1\ncenter = \"O\"\n");
    sets("force[0].name", "\"first\"", "value = 5\n", "value = 5\nname = \"first\"\n");
    sets("force.second.value.shape", "\"step\"", "] }\n", "], shape = \"step\" }\n");
    sets("force.second.value.table[2]", "[2, 2]", "2] # ends\n", "2], # ends\n    [2, 2]\n");
    sets("force.second.value.table[1][2]", "7", "[1, 2]", "[1, 2, 7]");
    sets("gravity", "9.81", "# a title\n", "# a title\ngravity = 9.81\n");
    sets("ground.points.'B c'", "1", "{ O = 0 }", "{ O = 0, \"B c\" = 1 }");
}

#[test]
fn a_table_that_lacks_is_made() {
    sets("link.rod.points.A", "0", "# inertia = 2\n", "# inertia = 2\n\n[link.rod]\npoints = { A = 0 }\n");
    sets("input.link", "\"crank\"", "# inertia = 2\n", "# inertia = 2\n\n[input]\nlink = \"crank\"\n");
    sets("slide[0].link", "\"crank\"", "# inertia = 2\n", "# inertia = 2\n\n[[slide]]\nlink = \"crank\"\n");
    sets("motion.speed", "1", "# at the end\n", "# at the end\n\n[motion]\nspeed = 1\n");
    sets("force[2].value", "1", "# at the end\n", "# at the end\n\n[[force]]\nvalue = 1\n");
    sets(
        "link.rod",
        "{ points = { A = 0 }, mass = 1 }",
        "# inertia = 2\n",
        "# inertia = 2\n\n[link.rod]\npoints = { A = 0 }\nmass = 1\n",
    );
    sets("output.points[0]", "\"A\"", "# at the end\n", "# at the end\n\n[output]\npoints = [\"A\"]\n");
    let slides = "[{ link = \"a\", on = \"b\" }, { link = \"b\" }]";
    sets(
        "slide",
        slides,
        "# inertia = 2\n",
        "# inertia = 2\n\n[[slide]]\nlink = \"a\"\non = \"b\"\n\n[[slide]]\nlink = \"b\"\n",
    );
    let text = set("", &key("link.a.points.A"), "0").unwrap();
    assert_eq!(text, "[link.a]\npoints = { A = 0 }\n");
    assert_eq!(set(&text, &key("title"), "''").unwrap(), "title = ''\n\n[link.a]\npoints = { A = 0 }\n");
    assert_eq!(set("gravity = 1", &key("title"), "''").unwrap(), "title = ''\ngravity = 1");
    assert_eq!(
        set("\u{feff}# a\n\n[x]\r\n", &key("title"), "''").unwrap(),
        "\u{feff}# a\ntitle = ''\r\n\n[x]\r\n"
    );
}

#[test]
fn tables_are_written_anew() {
    sets(
        "link.crank",
        "{ points = { O = 0 } }",
        "points = { O = 0, A = \"100 mm\" } # two\nmass = 1\n",
        "points = { O = 0 }\n",
    );
    let text = set("[a]\nb.c = 1\nb.d = 2\ne = 3\n", &key("a.b"), "{ c = 5 }").unwrap();
    assert_eq!(text, "[a]\ne = 3\nb = { c = 5 }\n");
    let text = set("[link.a.points]\nA = 0\n\n[motion]\n", &key("link.a.points"), "{ B = 0 }").unwrap();
    assert_eq!(text, "[link.a.points]\nB = 0\n\n[motion]\n");
}

#[test]
fn longer_keys_and_braces_are_kept() {
    let text = set("link.a.points.A = 0\n", &key("link.a.points.B"), "1").unwrap();
    assert_eq!(text, "link.a.points.A = 0\nlink.a.points.B = 1\n");
    let text = set(&text, &key("link.b.points.B"), "1").unwrap();
    assert_eq!(text, "link.a.points.A = 0\nlink.a.points.B = 1\nlink.b = { points = { B = 1 } }\n");
    let text = set("link = { a = { points.A = 0 } }\n", &key("link.a.points.B"), "1").unwrap();
    assert_eq!(text, "link = { a = { points.A = 0, points.B = 1 } }\n");
    assert_eq!(remove(&text, &key("link.a.points")), "link = { a = {} }\n");
    assert_eq!(remove(&text, &key("link.a.points.A")), "link = { a = { points.B = 1 } }\n");
    assert_eq!(set("slide = [ ]", &key("slide[0].link"), "1").unwrap(), "slide = [{ link = 1 }]");
    assert_eq!(
        set("[drive.motor]\npower = 1\n", &key("drive.ratio"), "2").unwrap(),
        "[drive.motor]\npower = 1\n\n[drive]\nratio = 2\n"
    );
    let rows = "x = [\n  1,\n  2,\n]\n";
    assert_eq!(set(rows, &key("x[2]"), "3").unwrap(), "x = [\n  1,\n  2,\n  3,\n]\n");
    assert_eq!(remove(rows, &key("x[1]")), "x = [\n  1,\n]\n");
}

#[test]
fn what_is_removed_leaves_the_rest() {
    removes("title", "title = \"Crank\" # a title\n", "");
    removes("link.crank.mass", "mass = 1\n", "");
    removes("link.crank.points.A", ", A = \"100 mm\"", "");
    removes("link.crank.points.O", "O = 0, A", "A");
    removes("ground.points.O", "{ O = 0 }", "{}");
    removes(
        "link.crank",
        "# The crank.\n[link.crank]\npoints = { O = 0, A = \"100 mm\" } # two\nmass = 1\n# inertia = 2\n\n",
        "",
    );
    removes("force.second.value.table[0]", "    [0, 1], # begins\n", "");
    removes("force[0]", "[[force]] # the first\nlink = \"crank\"\nat = \"A\"\nangle = 0\nvalue = 5\n\n", "");
    removes("force.second", &SCENE[SCENE.find("\n[[force]]\nname").unwrap()..], "");
    removes("force", &SCENE[SCENE.find("\n[[force]] #").unwrap()..], "");
    removes("nothing", "", "");
    removes("force[7].value", "", "");
    removes("force.second.value.table[0][5]", "", "");
    assert_eq!(remove("x = [", &key("x")), "x = [");
}

#[test]
fn tables_are_appended_in_order() {
    let more = "title = 'new'\n[ground]\npoints = { B = [1, 0], O = 2 }\n# A rod.\n[link.rod] # of steel\npoints = { A = 0 }\n[[slide]]\nlink = 'rod'\n[assembly]\nB = [1, 2]\n[[force]]\nlink = 'rod'\n[force.value]\nformula = '1'\n";
    let wanted = SCENE
        .replace("\"Crank\"", "'new'")
        .replace("{ O = 0 }", "{ O = 2, B = [1, 0] }")
        .replace(
            "# inertia = 2\n",
            "# inertia = 2\n\n# A rod.\n[link.rod] # of steel\npoints = { A = 0 }\n\n[[slide]]\nlink = 'rod'\n\n[assembly]\nB = [1, 2]\n",
        )
        + "\n[[force]]\nlink = 'rod'\n[force.value]\nformula = '1'\n";
    assert_eq!(append(SCENE, more).unwrap(), wanted);
    assert_eq!(
        append("slide = [{ link = 'a' }]\n", "[[slide]]\nlink = 'b'\n").unwrap(),
        "slide = [{ link = 'a' }, { link = 'b' }]\n"
    );
    assert_eq!(
        append("link = { a = {} }\n", "[link.b]\nmass = 1\n").unwrap(),
        "link = { a = {}, b = { mass = 1 } }\n"
    );
    assert_eq!(append("", "[input]\nlink = 'a'").unwrap(), "[input]\nlink = 'a'\n");
}

#[test]
fn what_is_wrong_is_said() {
    let fault = |text: &str, of: &str, toml: &str| set(text, &key(of), toml).unwrap_err().to_string();
    assert_eq!(fault("x = \"", "x", "1"), "not TOML: this text has no closing quote");
    assert_eq!(
        fault(SCENE, "title", "5 mm"),
        assur_scene::read("", "value = 5 mm").unwrap_err().errors[0].message.to_string()
    );
    assert!(set(SCENE, &key("title"), "1\n[x]").is_err());
    assert!(fault(SCENE, "force[5].value", "1").contains("force"));
    assert!(fault(SCENE, "force.third.value", "1").contains("third"));
    assert!(fault(SCENE, "title.x", "1").contains("title"));
    assert!(append(SCENE, "[a").is_err() && append("[a", "").is_err());
    assert!(append("[input]\n", "[[input]]\nlink = 'a'\n").is_err());
}
