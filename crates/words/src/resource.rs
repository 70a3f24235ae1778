//! The texts that a crate brings along.

/// The texts of a crate in a language.
#[derive(Debug, Clone, Copy)]
pub struct Resource {
    /// Code of the language: one of [`LANGUAGES`](crate::LANGUAGES).
    pub language: &'static str,
    /// The texts by identity, in the syntax of Fluent.
    pub texts: &'static str,
    /// The crate, for messages.
    pub crate_name: &'static str,
}

inventory::collect!(Resource);

/// Brings along the files `lang/en.ftl`, `lang/uk.ftl` and `lang/ru.ftl` of the crate. It stands once in a crate.
#[macro_export]
macro_rules! resources {
    () => {
        $crate::resources!("en" "uk" "ru");
    };
    ($($language:literal)*) => {
        $($crate::inventory::submit! {
            $crate::Resource {
                language: $language,
                texts: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/lang/", $language, ".ftl")),
                crate_name: env!("CARGO_PKG_NAME"),
            }
        })*
    };
}
