//! The links of the pages lead to files and headings that are there, and every page is found from the list of all.

use std::fs;
use std::path::{Path, PathBuf};

use super::root;

/// The pages of the repository.
fn pages() -> Vec<PathBuf> {
    let in_folder = |folder: &str| {
        let entries = fs::read_dir(root().join(folder)).unwrap();
        entries
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.extension().is_some_and(|end| end == "md"))
    };
    [".", "docs", "docs/measured"].into_iter().flat_map(in_folder).collect()
}

/// The anchor of a heading.
fn anchor(heading: &str) -> String {
    let kept = heading.trim().chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

/// What stands in the brackets of the links of a page.
fn targets(text: &str) -> impl Iterator<Item = &str> {
    // What stands in blocks of code is none.
    let outside = text.split("```").step_by(2);
    outside.flat_map(|part| part.split("](").skip(1)).filter_map(|rest| rest.split(')').next())
}

#[test]
fn every_link_leads_somewhere() {
    let mut broken = Vec::new();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        for target in targets(&text).filter(|target| !target.contains("://")) {
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let path = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
            let has_heading = || {
                let text = fs::read_to_string(&path).unwrap();
                text.lines()
                    .any(|line| line.starts_with('#') && anchor(line.trim_start_matches('#')) == heading)
            };
            if !path.exists() || !(heading.is_empty() || has_heading()) {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn every_page_is_in_the_list() {
    let docs = root().join("docs");
    let list = fs::read_to_string(docs.join("README.md")).unwrap();
    let listed: Vec<PathBuf> = targets(&list).map(|target| docs.join(target)).collect();
    for page in pages().into_iter().filter(|page| page.starts_with(&docs) && !page.ends_with("README.md")) {
        let page = page.strip_prefix(&docs).map(Path::to_owned).unwrap();
        assert!(listed.contains(&docs.join(&page)), "{} is not in docs/README.md", page.display());
    }
}
