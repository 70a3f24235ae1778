use super::*;

/// `assur keys --format markdown > docs/scene.md`
#[test]
fn the_page_of_the_documentation_is_the_reference() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/scene.md");
    let found: Vec<_> = search("", Language::english()).collect();
    assert!(
        std::fs::read_to_string(path).unwrap() == markdown(&found, &[], Language::english()),
        "write {path} anew"
    );
}
