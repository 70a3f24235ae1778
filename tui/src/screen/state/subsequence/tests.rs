//! Tests of `subsequence`.

use super::score;

#[test]
fn letters_stand_in_order_whatever_their_case() {
    assert!(score(&["fb"], "four-bar").is_some() && score(&["FB"], "four-bar").is_some());
    assert!(score(&["кр"], "Кривошип").is_some());
    assert_eq!(score(&["bf"], "four-bar"), None);
    assert_eq!(score(&["four", "x"], "four-bar"), None);
    assert_eq!(score(&["longer than it"], "short"), None);
    assert_eq!(score(&["aa"], "a"), None, "a letter counts once");
}

#[test]
fn starts_of_words_and_letters_side_by_side_go_first() {
    assert!(score(&["fb"], "four-bar") > score(&["fb"], "after-embed"));
    assert!(score(&["mom"], "ram moment") > score(&["mom"], "mass of motion"));
    assert!(score(&["ab"], "aab") == score(&["ab"], "aabb"), "the best of all places counts, not the first");
    assert!(score(&["bar"], "xbxaxrx bar") > score(&["bar"], "xbxaxrx"));
}
