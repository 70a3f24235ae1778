//! The licenses of all crates that are linked into the program: `cargo metadata --format-version 1 --filter-platform TARGET |
//! cargo run -p assur-tests --example licenses`. For `.ci/package`.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::Path;

use assur_tests as _;
use serde::Deserialize;

/// Names of the files with the texts of licenses begin so.
const BEGINNINGS: [&str; 5] = ["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE"];

#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
    resolve: Resolve,
}

#[derive(Deserialize)]
struct Package {
    id: String,
    name: String,
    version: String,
    license: Option<String>,
    authors: Vec<String>,
    source: Option<String>,
    manifest_path: String,
}

#[derive(Deserialize)]
struct Resolve {
    nodes: Vec<Node>,
}

#[derive(Deserialize)]
struct Node {
    id: String,
    deps: Vec<Dependency>,
}

#[derive(Deserialize)]
struct Dependency {
    pkg: String,
    dep_kinds: Vec<DependencyKind>,
}

#[derive(Deserialize)]
struct DependencyKind {
    /// `None`: linked; else of the tests or of a build script.
    kind: Option<String>,
}

/// The crates that the package with this name links, by name and version, without those of this repository.
fn linked<'a>(metadata: &'a Metadata, program: &str) -> BTreeMap<(&'a str, &'a str), &'a Package> {
    let packages: BTreeMap<&str, &Package> =
        metadata.packages.iter().map(|package| (package.id.as_str(), package)).collect();
    let nodes: BTreeMap<&str, &Node> =
        metadata.resolve.nodes.iter().map(|node| (node.id.as_str(), node)).collect();
    let roots = metadata.packages.iter().filter(|package| package.name == program);
    let mut open: Vec<&str> = roots.map(|package| package.id.as_str()).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = open.pop() {
        if seen.insert(id) {
            let dependencies = nodes.get(id).map_or(&[][..], |node| &node.deps);
            let linked =
                dependencies.iter().filter(|other| other.dep_kinds.iter().any(|kind| kind.kind.is_none()));
            open.extend(linked.map(|other| other.pkg.as_str()));
        }
    }
    let foreign = seen.iter().filter_map(|id| packages.get(id)).filter(|package| package.source.is_some());
    foreign.map(|package| ((package.name.as_str(), package.version.as_str()), *package)).collect()
}

/// The texts of the licenses in the folder of a crate, by name of the file.
fn texts(manifest: &str) -> io::Result<BTreeMap<String, String>> {
    let folder = Path::new(manifest).parent().unwrap_or(Path::new("."));
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_file() && BEGINNINGS.iter().any(|begin| name.to_uppercase().starts_with(begin)) {
            found.insert(name, String::from_utf8_lossy(&fs::read(&path)?).into_owned());
        }
    }
    Ok(found)
}

fn main() -> Result<(), Box<dyn Error>> {
    let metadata: Metadata = serde_json::from_reader(io::stdin().lock())?;
    let crates = linked(&metadata, "assur-cli");
    if crates.is_empty() {
        return Err("the metadata has no package `assur-cli` with dependencies".into());
    }
    let mut page = String::from("Crates that are linked into assur, each with its license.\n");
    // The same text stands once, with all crates that have it.
    let mut by_text: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for ((name, version), package) in &crates {
        let license = package.license.as_deref().unwrap_or("see the text of its license");
        writeln!(page, "{name} {version}: {license}; {}", package.authors.join(", "))?;
        for (file, text) in texts(&package.manifest_path)? {
            by_text.entry(text.trim().to_owned()).or_default().push(format!("{name} {version} ({file})"));
        }
    }
    for (text, owners) in by_text {
        write!(page, "\n{}\n{}:\n\n{text}\n", "-".repeat(72), owners.join(", "))?;
    }
    print!("{page}");
    Ok(())
}
