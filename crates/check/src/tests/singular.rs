use super::{checks, hold, scene, show};

/// Crank 2, ground 3, coupler and rocker 1.5: assembles while cos q >= 1/3.
fn near_the_end(distance: f64) -> String {
    let end = (1.0_f64 / 3.0).acos();
    format!(
        "[ground]\npoints = {{ O = [0, 0], C = [3, 0] }}\n[link.crank]\npoints = {{ O = 0, A = 2 }}\n\
         [link.coupler]\npoints = {{ A = 0, B = 1.5 }}\nmass = 2\ncenter = 0.7\n[link.rocker]\npoints = {{ C = 0, B = 1.5 }}\n\
         [input]\nlink = \"crank\"\nfrom = {:?}\nto = {:?}\npositions = 2\n[[moment]]\nlink = \"rocker\"\nvalue = 3\n\
         [assembly]\nB = [2.5, 1.5]\n[motion]\nspeed = 3\n",
        end - 2.0 * distance,
        end - distance,
    )
}

#[test]
fn sound_results_pass_up_to_the_end_of_assembly() {
    for power in 1..=12 {
        let all = checks(&scene(&near_the_end(0.1_f64.powi(power))));
        assert!(hold(&all), "10^-{power} rad from the end\n{}", show(&all));
        assert!(all.iter().any(|check| check.name.to_string() == "TestPf PF2"));
    }
}

#[test]
fn positions_that_are_hardly_determined_are_left_out_and_counted() {
    // The derivatives are numbers still, but not a digit of theirs is sure.
    let all = checks(&scene(&near_the_end(2e-13)));
    let test_pf = all.iter().find(|check| check.name.to_string() == "TestPf PF2").unwrap();
    assert!(test_pf.left_out > 0 && !test_pf.finding.why.is_empty(), "{}", show(&all));
    assert!(all.iter().any(|check| check.name.to_string() == "closure PF2"));
}

#[test]
fn a_method_that_is_ill_conditioned_by_itself_is_measured_by_its_own_rounding() {
    // The longitudinal reactions as published lose digits where the crank stands across the guide.
    let path = format!("{}/../../fixtures/slider-crank.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    for distance in [1e-3, 1e-5, 1e-7, 1e-9] {
        let mut mechanism = assur_scene::read("slider-crank", &text).unwrap();
        mechanism.input.positions = 2;
        mechanism.input.from = std::f64::consts::FRAC_PI_2 + distance;
        mechanism.input.range = assur_mechanism::Range::To(std::f64::consts::FRAC_PI_2 - distance);
        let all = checks(&assur_kinematics::Linkage::compile(mechanism).unwrap());
        assert!(hold(&all), "{distance:e}\n{}", show(&all));
    }
}

#[test]
fn a_group_of_very_different_accelerations_keeps_the_digits_of_the_small_ones() {
    // The cylinder has almost its greatest length: an arm turns with 3.5e4 rad/m² while the pin L has an acceleration of 0.025 1/m.
    let path = format!("{}/../../fixtures/scissor-lift.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.replacen("M = \"600 mm\"", "M = \"-1 mm\"", 1).replace("\"500 mm\"", "\"400 mm\"");
    let all = checks(&scene(&text.replace("positions = 12", "positions = 7")));
    assert!(hold(&all), "{}", show(&all));
}

#[test]
fn loads_over_a_stroke_through_a_change_point_pass() {
    let scene = scene(
        "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0, A = 0.06 }\nmass = 2\ncenter = 0.02\n\
         [link.rod]\npoints = { A = 0, B = 0.08 }\nmass = 1.5\ncenter = 0.04\n[link.piston]\npoints = { B = 0 }\n\
         [[slide]]\nlink = \"piston\"\non = \"ground\"\nthrough = [0, 0.02]\n\
         [input]\nlink = \"crank\"\npositions = 12\n[motion]\nspeed = 30\n\
         [[force]]\nname = \"gas\"\nlink = \"piston\"\nat = \"B\"\nangle = \"180 deg\"\n\
         value = { over = \"stroke\", axis = 0, forward = [[0, 200], [0.5, 800], [1, 2000]], back = 0 }\n\
         [assembly]\nB = [0.13, 0.02]\n",
    );
    // At 270 deg the rod stands across the guide, and the piston goes on to the other side: the turn does not end where it began.
    let all = checks(&scene);
    assert!(all.iter().any(|check| check.name.to_string() == "loads"), "{}", show(&all));
    assert!(!all.iter().any(|check| check.finding.failed()), "{}", show(&all));
}
