//! Files that are no scenes: endless, with a fault in every word.

use std::fmt::Write as _;

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
    assert_eq!(errors.errors[0].message, "a scene has at most 8 MiB, this one has 9");
}

#[test]
fn a_table_has_a_greatest_number_of_rows() {
    let rows = "[0,1],".repeat(100_001);
    let value = format!("value = {{ over = \"angle\", table = [{rows}] }}");
    let errors = read("rows.toml", &BASE.replacen("value = 700", &value, 1)).unwrap_err();
    assert_eq!(errors.errors[0].message, "`table` has 100001 rows, at most 100000 are read");
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
    assert_eq!(errors.errors[0].message, "link `crank` has its pins O, A at one place: its length is zero");
    assert_eq!((errors.errors[0].line, errors.errors[0].column), (3, 7));
    // The crank turns a guide: its angle matters.
    assert!(read("two.toml", &scene("[[slide]]\nlink = \"stone\"\non = \"crank\"\n")).is_ok());
}
