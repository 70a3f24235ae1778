//! Where the links of scenes are, also of those that are no mechanism.

use assur_group::Order;
use assur_kinematics::Linkage;

use super::{drawn, read};

#[test]
fn shipped_scenes_are_drawn_in_their_first_position() {
    for (name, text) in assur_fixtures::SCENES {
        let sketch = drawn(text);
        assert!(sketch.is_assembled(), "{name}: {:?} at {}", sketch.solved, sketch.coordinate);
        let linkage = Linkage::compile(read(text)).unwrap();
        let mut position = linkage.position();
        linkage.solve_index(0, Order::Place, &mut position).unwrap();
        let size = sketch.size();
        for (point, at) in sketch.mechanism.points.iter().zip(sketch.points()) {
            for of in &point.places {
                let [x, y] = position.bodies[of.link].point(of.at);
                assert!((x - at.1[0]).hypot(y - at.1[1]) < 1e-9 * size, "{name}: {}", point.name);
            }
        }
    }
}

#[test]
fn what_is_loose_is_placed_by_its_points_and_guides() {
    let shaper = assur_fixtures::scene("shaper");
    let whole = drawn(shaper);
    // Without the guide of the ram its stone and the ram are loose, and the rest stands as before.
    let start = shaper.find("[[slide]]                     # the ram moves").unwrap();
    let end = shaper.find("[input]").unwrap();
    let without = format!("{}{}", &shaper[..start], &shaper[end..]);
    let loose = drawn(&without);
    assert_eq!(loose.solved, [true, true, true, true, false, false]);
    assert!(loose.bodies.iter().all(Option::is_some));
    assert_eq!(loose.bodies[..4], whole.bodies[..4]);
    let [x, y] = loose.place("D").unwrap();
    let before = whole.place("D").unwrap();
    assert!((x - before[0]).hypot(y - before[1]) < 1e-9);
    // The stone is at its pin, the ram where its slot goes through the stone.
    let (through, angle) = loose.guide("stone4/ram").unwrap();
    assert!(crate::pose::off((through, angle), [x, y]).abs() < 1e-9);
}

#[test]
fn what_has_no_assembly_is_drawn_where_it_has_one_or_by_its_points() {
    let four_bar = assur_fixtures::scene("four-bar");
    // Too short for the first position, at which the crank points away: drawn at a later one.
    let later = drawn(
        &four_bar
            .replace("B = \"210 mm\"", "B = \"120 mm\"")
            .replace("positions = 36", "from = \"180 deg\"\npositions = 36"),
    );
    assert!(later.solved.iter().all(|solved| *solved) && !later.is_assembled(), "{}", later.coordinate);
    let nowhere = drawn(
        &four_bar.replace("B = \"210 mm\"", "B = \"20 mm\"").replace("B = \"280 mm\"", "B = \"20 mm\""),
    );
    assert_eq!(nowhere.solved, [true, true, false, false]);
    assert!(nowhere.bodies.iter().all(Option::is_some));
    // The coupler begins at the crank, the rocker at its pivot; both point to where B is wanted.
    let coupler = nowhere.pose("coupler").unwrap();
    assert_eq!(coupler.at.map(f64::to_bits), nowhere.place("A").unwrap().map(f64::to_bits));
    assert!((coupler.angle - 0.18_f64.atan2(0.3 - 0.09)).abs() < 1e-9, "{coupler:?}");
}
