//! `differences`.

use crate::differences;

/// `KEY: BEFORE > AFTER` of each difference.
fn told(before: &str, after: &str) -> Vec<String> {
    let side = |value: Option<String>| value.unwrap_or_default();
    let all = differences(before, after).into_iter();
    all.map(|one| format!("{}: {} > {}", one.key, side(one.before), side(one.after))).collect()
}

#[test]
fn a_table_that_only_one_text_has_is_one_difference() {
    let text = "[link.a]\npoints = { A = 0 }\n";
    let more = format!("{text}[link.b]\npoints = {{ A = 0, B = 1 }}\nmass = 2\n[assembly]\nB = [0, 1]\n");
    let table = "{ points = { A = 0, B = 1 }, mass = 2 }";
    assert_eq!(told(text, &more), ["assembly:  > { B = [0, 1] }".to_owned(), format!("link.b:  > {table}")]);
    assert_eq!(told(&more, text).len(), 2);
    assert!(told(&more, &more).is_empty());
}

#[test]
fn a_value_is_told_with_both_texts_and_spelling_around_it_does_not_count() {
    let text = "[link.a]\npoints = { A = 0, B = \"100 mm\" }\n";
    let same = "# a crank\n[link.a]\npoints.A = 0\npoints.B = \"120 mm\" # longer\n";
    assert_eq!(told(text, same), ["link.a.points.B: \"100 mm\" > \"120 mm\""]);
}

#[test]
fn an_element_that_goes_from_the_middle_of_a_list_is_one_difference() {
    let force = |value: u32| format!("[[force]]\nlink = \"a\"\nvalue = {value}\n");
    let [one, two, three] = [1, 2, 3].map(force);
    let all = [one.clone(), two, three.clone()].concat();
    assert_eq!(told(&all, &[one.clone(), three].concat()), ["force[1]: { link = \"a\", value = 2 } > "]);
    assert_eq!(told(&one, &force(4)), ["force[0].value: 1 > 4"]);
    // A first element makes the list.
    assert_eq!(told("", &one), ["force:  > [{ link = \"a\", value = 1 }]"]);
}
