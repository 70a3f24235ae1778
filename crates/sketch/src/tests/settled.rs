//! `[assembly]` after lengths were typed.

use crate::{settled, sketch};

/// A four-bar linkage: crank 100 mm, coupler 400 mm, a rocker, 500 mm between the pivots.
fn four_bar(rocker: &str, assembly: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = 0, C = 0.5 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\n[link.rod]\npoints = {{ A = 0, B = 0.4 }}\n\
         [link.rocker]\npoints = {{ C = 0, B = {rocker} }}\n[input]\nlink = \"crank\"\n[assembly]\nB = {assembly}\n"
    )
}

#[test]
fn a_place_far_from_its_point_follows_and_a_near_one_stays() {
    let of = |text: &str| settled(text, &sketch(&assur_scene::read("a.toml", text).unwrap())).unwrap();
    let far = of(&four_bar("0.3", "[0.1, 0.4]"));
    let mechanism = assur_scene::read("a.toml", &far).unwrap();
    let [x, y] = mechanism.assembly[0].1;
    // The triangle of A (0.1, 0), C (0.5, 0) with the sides 0.4 and 0.3: the law of cosines.
    let along = (0.16 - 0.09 + 0.16) / 0.8;
    let height = (0.16_f64 - along * along).sqrt();
    assert!((x - 0.1 - along).abs() < 1e-5 && (y - height).abs() < 1e-5, "{far}");
    let near = four_bar("0.3", "[0.388, 0.278]");
    assert_eq!(of(&near), near);
    let unassembled = four_bar("0.9", "[0.1, 0.4]");
    assert_eq!(of(&unassembled), unassembled, "nothing is known of its places");
}
