//! Whether the terminal's locale can show more than ASCII.

/// Whether the first that is set of `LC_ALL`, `LC_CTYPE`, `LANG` names UTF-8.
pub(crate) fn is_utf8(variable: impl Fn(&str) -> Option<String>) -> bool {
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"]
        .into_iter()
        .filter_map(variable)
        .find(|value| !value.is_empty())
        .unwrap_or_default()
        .to_ascii_lowercase();
    locale.contains("utf-8") || locale.contains("utf8")
}

#[cfg(test)]
mod tests {
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
}
