//! Where links turn back over time: at a rest that falls on a sample, and where the speed of a drive jumps.

use assur_geometry::geometry;
use assur_kinematics::Linkage;
use assur_mechanism::GROUND;

/// The instants at which the crank of the four-bar turns back.
fn turns(law: &str, until: f64) -> Vec<f64> {
    let text = assur_fixtures::scene("four-bar");
    let tables = text.split("\n[");
    let tables =
        tables.filter(|table| !["input]", "motion]", "force"].iter().any(|of| table.starts_with(of)));
    let rest = tables.filter(|table| !table.contains("over = \"angle\"")).collect::<Vec<_>>().join("\n[");
    let text = format!(
        "{rest}\n[input]\nlink = \"crank\"\nover_time = {law}\n[motion]\nuntil = {until:?}\nsamples = 6\n"
    );
    let found = || -> Result<_, Box<dyn std::error::Error>> {
        let mechanism = assur_scene::read("scene.toml", &text).map_err(|faults| faults.to_string())?;
        Ok(geometry(&Linkage::compile(mechanism)?, GROUND)?)
    };
    let found = found().unwrap_or_else(|error| panic!("{error}\n{text}"));
    let crank = found.links.iter().find(|(link, _)| link.name == "crank");
    let stroke = crank.and_then(|(_, course)| course.stroke.as_ref());
    stroke.map(|stroke| stroke.dead_points.clone()).unwrap_or_default()
}

#[test]
fn a_rest_in_a_sample_is_a_turn() {
    // Of this spline the speed is 0 at whole seconds, which are samples of a motion of 6 s and lie between those of one of 5.9 s.
    let law = "{ table = [[0, 1], [1, 2], [2, 1]], shape = \"smooth\" }";
    for until in [6.0, 5.9] {
        let found = turns(law, until);
        assert_eq!(found.len(), 5, "{found:?}");
        for (found, expected) in found.iter().zip([1.0, 2.0, 3.0, 4.0, 5.0]) {
            assert!((found - expected).abs() < 1e-9, "{found} is not {expected}");
        }
    }
}

#[test]
fn where_the_speed_jumps_to_the_other_side_the_motion_turns() {
    let found = turns("{ table = [[0, 1], [0.7, 2], [1.1, 2.5], [2.2, 1], [3, 1.4]] }", 3.0);
    assert_eq!(found, [1.1, 2.2]);
}
