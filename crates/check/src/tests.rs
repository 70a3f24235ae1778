use assur_all as _;
use assur_kinematics::Linkage;

use assur_specimen::Recipe;

use crate::{Check, checks};

fn show(all: &[Check]) -> String {
    let line = |c: &Check| {
        format!("{:28} {:10.3e} {:10.3e} at {:?} {} {}", c.name, c.residual, c.limit, c.at, c.place, if c.ok { "ok" } else { "FAILED" })
    };
    all.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn fixture(name: &str) -> Linkage {
    let path = format!("{}/../../fixtures/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    Linkage::compile(assur_scene::read(name, &text).unwrap()).unwrap()
}

#[test]
fn every_fixture_holds() {
    let path = format!("{}/../../fixtures", env!("CARGO_MANIFEST_DIR"));
    let mut names: Vec<_> = std::fs::read_dir(path).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    for name in names.iter().filter_map(|name| name.strip_suffix(".toml")) {
        let all = checks(&fixture(name));
        println!("{name}\n{}", show(&all));

        assert!(all.len() >= 5, "{name}\n{}", show(&all));
    }
}

#[test]
fn every_check_holds_on_random_mechanisms() {
    let mut worst = std::collections::BTreeMap::new();
    for seed in 0..240 {
        let groups = 1 + usize::try_from(seed % 5).unwrap();
        let specimen = Recipe::of(groups).specimen(seed).unwrap();
        let linkage = Linkage::compile(specimen.mechanism.clone()).unwrap();
        let all = checks(&linkage);
        for check in &all {
            let share = check.residual / check.limit;
            let entry = worst.entry(check.name).or_insert((0.0, 0, 0.0, 0.0));
            if !(share <= entry.0) { *entry = (share, seed, check.residual, check.limit); }
        }
        if !all.iter().all(|check| check.ok) { println!("seed {seed}, health {}\n{}", specimen.health, show(&all)); }
    }
    println!("{worst:#?}");
}
