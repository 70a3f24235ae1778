use assur_words::Text;

use super::{Registered, RegistryError, all, find, sorted};

#[derive(Debug, PartialEq)]
struct Tool(&'static str, &'static str);

inventory::collect!(Tool);

impl Registered for Tool {
    const WHAT: Text = Text::message("tool", Vec::new());

    fn registration(&self) -> (&'static str, &'static str) {
        (self.0, self.1)
    }
}

inventory::submit! { Tool("saw", "a") }
inventory::submit! { Tool("file", "b") }

#[derive(Debug, PartialEq)]
struct Nothing;

inventory::collect!(Nothing);

impl Registered for Nothing {
    const WHAT: Text = Text::message("nothing", Vec::new());

    fn registration(&self) -> (&'static str, &'static str) {
        ("", "")
    }
}

#[test]
fn entries_are_sorted_and_found_by_name() {
    assert_eq!(all::<Tool>().unwrap(), [&Tool("file", "b"), &Tool("saw", "a")]);
    assert_eq!(find::<Tool>("saw").unwrap(), &Tool("saw", "a"));
    let error = find::<Tool>("axe").unwrap_err();
    assert_eq!(error.to_string(), "no tool is called `axe`; there are: file, saw");
}

#[test]
fn two_of_one_name_and_none_at_all_are_refused() {
    static TWICE: [Tool; 3] = [Tool("saw", "c"), Tool("axe", "b"), Tool("saw", "a")];
    let error = sorted(TWICE.iter().collect()).unwrap_err();
    assert_eq!(error, RegistryError::Duplicate { what: Tool::WHAT, name: "saw", first: "a", second: "c" });
    assert_eq!(error.to_string(), "two plugins are registered as tool `saw`: a and c; rename one");
    let error = all::<Nothing>().unwrap_err();
    assert_eq!(error, RegistryError::Empty(Nothing::WHAT));
    assert!(error.to_string().starts_with("no nothing is registered; the program must link the plugins"));
}
