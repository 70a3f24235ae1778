use super::{checks, hold, names, scene, show};

#[test]
fn every_fixture_holds() {
    let folder = format!("{}/../../fixtures", env!("CARGO_MANIFEST_DIR"));
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    assert!(paths.len() > 10);
    for path in paths {
        let all = checks(&scene(&std::fs::read_to_string(&path).unwrap()));
        let name = path.file_stem().unwrap().to_string_lossy();
        println!("{name}\n{}", show(&all));
        assert!(hold(&all), "{name}\n{}", show(&all));
        let count = all.len();
        assert!(count >= 5, "{name} has only {count} checks");
    }
}

const FOUR_BAR: &str = "[ground]\npoints = { O = [0, 0], C = [3, 0] }\n\
    [link.crank]\npoints = { O = 0, A = 1 }\n[link.coupler]\npoints = { A = 0, B = 3 }\n\
    [link.rocker]\npoints = { C = 0, B = 2 }\n[input]\nlink = \"crank\"\n";

#[test]
fn checks_that_do_not_apply_are_left_out() {
    let bare = names(&scene(FOUR_BAR));
    assert_eq!(bare, ["closure PF0", "closure PF1", "closure PF2", "TestPf PF1", "TestPf PF2"]);
    let loaded = format!("{FOUR_BAR}[[moment]]\nlink = \"rocker\"\nvalue = 5\n");
    let loaded = names(&scene(&loaded));
    assert!(loaded.contains(&"Lagrange-d'Alembert") && loaded.contains(&"agreement of the methods"));
    assert!(!loaded.contains(&"slides push across") && !loaded.contains(&"TestPf J'"));
}
