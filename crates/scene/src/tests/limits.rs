//! Files that are no scenes: endless, with a fault in every word.

use std::fmt::Write as _;

use assur_mechanism::{
    LONGEST_NAME, MOST_LINKS, MOST_LOADS, MOST_PARTS_SAMPLED, MOST_PLACES, MOST_SLIDES, MOST_STEPS_KEPT,
};

use super::BASE;
use crate::{document, read};

#[test]
fn of_many_faults_the_first_are_kept_and_the_rest_is_counted() {
    let mut text = BASE.to_owned();
    for index in 0..200_000 {
        writeln!(text, "unknown{index} = {index}").unwrap();
    }
    let errors = read("many.toml", &text).unwrap_err();
    assert_eq!((errors.errors.len(), errors.more), (1000, 199_000));
    assert!(errors.to_string().ends_with("... and 199980 more\n"), "{errors}");
}

#[test]
fn faults_of_one_line_share_it() {
    let rows = "[0, \"x\"], ".repeat(20_000);
    let value = format!("value = {{ over = \"angle\", table = [{rows}] }}");
    let errors = read("wide.toml", &BASE.replacen("value = 700", &value, 1)).unwrap_err();
    assert_eq!(errors.errors.len() + errors.more, 20_000);
    let [first, second, ..] = &errors.errors[..] else { panic!("{errors}") };
    assert_eq!(
        (first.line, second.line, second.column - first.column),
        (first.line, first.line, "[0, \"x\"], ".len())
    );
    assert!(errors.to_string().len() < 20_000);
}

#[test]
fn a_file_that_is_too_large_is_not_read() {
    let errors = read("zero", &"\0".repeat(document::MOST_BYTES + 1)).unwrap_err();
    assert_eq!(errors.errors[0].message.to_string(), "a scene has at most 8 MiB, this one has 9");
}

#[test]
fn tables_and_lists_are_counted_before_they_are_made() {
    let most = crate::scan::MOST_TABLES;
    let refused = |text: &str| {
        let errors = read("many.toml", text).unwrap_err();
        let first = &errors.errors[0];
        let many = "a scene has at most 300000 tables and lists, this one has more";
        (first.message.to_string() == many).then_some((first.line, first.column))
    };
    // Each of these makes one table or list more than the same without its last line, which is at its place.
    let keys = |count: usize| "a.b = 1\n".repeat(count);
    assert_eq!(refused(&keys(most)), None);
    assert_eq!(refused(&keys(most + 1)), Some((most + 1, 5)));
    assert_eq!(refused(&format!("{}{}", "[a.b]\n".repeat(most / 2), "[c]\n")), Some((most / 2 + 1, 3)));
    assert_eq!(refused(&format!("x = [{}]", "{},".repeat(most))), Some((1, 3 + 3 * most)));
    assert_eq!(
        refused(&format!("x = [{}]", "[0.5, 1.5],".repeat(most - 1))),
        None,
        "points of numbers are none of keys"
    );
    assert_eq!(refused(&format!("a{} = 1", ".a".repeat(2 * most))), Some((1, 4 * most + 3)));
    // Points and brackets in comments and texts make nothing, whatever quotes are in them.
    let silent = "a = \"[{.\\\"\" # [.=\nb = '[\"'\nc = \"\"\"\n[{.\"\"\"\nd = '''['''\n";
    assert_eq!(crate::scan::excess(&silent.repeat(most)), None);
}

#[test]
fn a_table_has_a_greatest_number_of_rows() {
    let rows = "[0,1],".repeat(100_001);
    let value = format!("value = {{ over = \"angle\", table = [{rows}] }}");
    let errors = read("rows.toml", &BASE.replacen("value = 700", &value, 1)).unwrap_err();
    assert_eq!(errors.errors[0].message.to_string(), "`table` has 100001 rows, at most 100000 are read");
}

#[test]
fn pins_at_one_place_are_refused_where_nothing_else_turns_the_link() {
    let scene = |slide: &str| {
        format!(
            "[ground]\npoints = {{ O = 0, C = 1 }}\n[link.crank]\npoints = {{ O = 0, A = 0 }}\n\
             [link.rod]\npoints = {{ A = 0, B = 1 }}\n[link.rocker]\npoints = {{ C = 0, B = 0.5 }}\n\
             [link.stone]\npoints = {{ S = 0 }}\n{slide}[input]\nlink = \"crank\"\n"
        )
    };
    let errors = read("one.toml", &scene("")).unwrap_err();
    assert_eq!(
        errors.errors[0].message.to_string(),
        "link `crank` has its pins O, A at one place: its length is zero"
    );
    assert_eq!((errors.errors[0].line, errors.errors[0].column), (3, 7));
    // The crank turns a guide: its angle matters.
    assert!(read("two.toml", &scene("[[slide]]\nlink = \"stone\"\non = \"crank\"\n")).is_ok());
}

/// A crank with these points beside its joint, after which come other parts of the scene.
fn crank(points: &str, more: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0{points} }}\n[input]\nlink = \"crank\"\n{more}"
    )
}

/// Lines that are made from numbers.
fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).map(line).collect()
}

#[test]
fn the_first_that_is_too_many_is_named_with_its_line() {
    /// A scene with so many of a kind, their greatest number, their name, and the line of the first that is too many.
    type Limit<'a> = (&'a dyn Fn(usize) -> String, usize, &'static str, usize);
    let slides = |count| crank("", &lines(count, |_| "[[slide]]\n".to_owned()));
    let links = |count| crank("", &lines(count - 1, |i| format!("[link.k{i}]\n")));
    // Two of the points are there already.
    let points = |count| crank(&lines(count - 2, |i| format!(", P{i} = 1")), "");
    let loads = |count: usize| {
        let half = count / 2;
        crank(
            "",
            &(lines(half, |_| "[[force]]\n".to_owned())
                + &lines(count - half, |_| "[[spring]]\n".to_owned())),
        )
    };
    let all: [Limit<'_>; 4] = [
        (&slides, MOST_SLIDES, "slides", 7 + MOST_SLIDES),
        (&links, MOST_LINKS, "links", 6 + MOST_LINKS),
        (&points, MOST_PLACES, "points on its links", 4),
        (&loads, MOST_LOADS, "loads", 7 + MOST_LOADS),
    ];
    for (scene, most, what, line) in all {
        let errors = read("many.toml", &scene(most + 1)).unwrap_err();
        let message = format!("a scene has at most {most} {what}, this one has {}", most + 1);
        let found: Vec<_> =
            errors.errors.iter().map(|error| (error.message.to_string(), error.line)).collect();
        assert_eq!(found, [(message, line)]);
        let said = |errors: crate::SceneErrors| {
            errors.errors.iter().any(|error| error.message.to_string().contains("at most"))
        };
        assert!(!read("most.toml", &scene(most)).err().is_some_and(said), "{what}");
    }
}

#[test]
fn a_name_has_a_greatest_length() {
    let scene = |name: &str| {
        [
            format!("title = \"{name}\"\n{}", crank("", "")),
            crank(&format!(", {name} = 1"), ""),
            crank(
                "",
                &format!(
                    "[link.{name}]\npoints = {{ S = 0 }}\n[[slide]]\nlink = \"{name}\"\non = \"crank\"\n"
                ),
            ),
            crank(
                "",
                &format!(
                    "[link.k]\npoints = {{ S = 0 }}\n[[slide]]\nlink = \"k\"\non = \"crank\"\nname = \"{name}\"\n"
                ),
            ),
            crank("", &format!("[[moment]]\nname = \"{name}\"\nlink = \"crank\"\nvalue = 1\n")),
        ]
    };
    for text in scene(&"n".repeat(LONGEST_NAME)) {
        assert!(read("long.toml", &text).is_ok(), "{text}");
    }
    for text in scene(&"n".repeat(LONGEST_NAME + 1)) {
        let errors = read("longer.toml", &text).unwrap_err();
        let message = format!(
            "`{}...` has {} characters, at most {LONGEST_NAME} are read",
            "n".repeat(40),
            LONGEST_NAME + 1
        );
        assert_eq!(errors.errors[0].message.to_string(), message);
    }
}

#[test]
fn samples_and_kept_steps_are_as_many_as_memory_holds() {
    let scene = |keys: &str| {
        let motion = format!(
            "mass = 1\ncenter = \"O\"\ninertia = 1\n[motion]\nkind = \"transient\"\nspeed = 1\n{keys}\n"
        );
        crank("", "").replace("[input]", &format!("{motion}[input]"))
    };
    // Ground, crank and their joint.
    let most = MOST_PARTS_SAMPLED / 3;
    assert!(read("most.toml", &scene(&format!("until = 1\nsamples = {most}"))).is_ok());
    let errors = read("more.toml", &scene(&format!("until = 1\nsamples = {}", most + 1))).unwrap_err();
    let message = format!("`samples` may be at most {most} in a scene of 3 links, points, slides and loads");
    assert_eq!((errors.errors[0].message.to_string(), errors.errors[0].line), (message, 12));
    // Only where the instants of the samples are known from the start are other steps dropped.
    let steps = MOST_STEPS_KEPT + 1;
    assert!(read("time.toml", &scene(&format!("until = 1\nmax_steps = {steps}"))).is_ok());
    let errors = read("rest.toml", &scene(&format!("until = \"rest\"\nmax_steps = {steps}"))).unwrap_err();
    assert!(
        errors.errors[0].message.to_string().contains(&format!("from 1 to {MOST_STEPS_KEPT}")),
        "{errors}"
    );
}

#[test]
fn of_a_large_text_that_is_no_toml_the_first_fault_is_named() {
    for text in ["=".repeat(document::MOST_BYTES), "\"\n".repeat(document::MOST_BYTES / 2)] {
        let errors = read("none.toml", &text).unwrap_err();
        let lines: Vec<_> = errors.errors.iter().map(|error| error.line).collect();
        assert_eq!((lines, errors.more), (vec![1], 0));
    }
}
