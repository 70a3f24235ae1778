//! Whether the terminal's locale can show more than ASCII.

#[cfg(test)]
mod tests;

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
