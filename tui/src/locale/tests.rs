//! Tests of `locale`.

use super::is_utf8;

fn with(pairs: &[(&str, &str)]) -> bool {
    is_utf8(|name| pairs.iter().find(|(key, _)| *key == name).map(|(_, value)| (*value).to_owned()))
}

#[test]
fn the_first_that_is_set_decides() {
    assert!(with(&[("LANG", "C.UTF-8")]));
    assert!(with(&[("LC_CTYPE", "en_US.utf8"), ("LANG", "C")]));
    assert!(with(&[("LC_ALL", ""), ("LC_CTYPE", "uk_UA.UTF-8"), ("LANG", "")]));
    assert!(!with(&[("LC_ALL", "C"), ("LANG", "C.UTF-8")]));
    assert!(!with(&[]));
}
