//! The kind passes the conformance suite, and a mechanism that needs it is solved.

use assur_all as _;
use assur_group::Order;
use assur_kinematics::Linkage;
use own_program as _;

#[test]
fn it_passes_the_conformance_suite() {
    assur_testkit::conformance("two-plates");
}

#[test]
fn a_mechanism_that_needs_it_closes_its_loops() {
    let text = include_str!("../eight-bar.toml");
    let linkage = Linkage::compile(assur_scene::read("eight-bar.toml", text).unwrap()).unwrap();
    assert_eq!(linkage.structure.formula, "I(ground,crank) -> III/4(left,right,rod,first,second,third)");
    let mut position = linkage.position();
    for index in 0..linkage.mechanism.input.positions {
        linkage.solve_index(index, Order::Place, &mut position).unwrap();
        for point in linkage.mechanism.points.iter().filter(|point| point.is_pin()) {
            let places: Vec<_> = point.places.iter().map(|p| position.bodies[p.link].point(p.at)).collect();
            for place in &places[1..] {
                let gap = (place[0] - places[0][0]).hypot(place[1] - places[0][1]);
                assert!(gap < 1e-14, "{} is open by {gap:e} m at position {index}", point.name);
            }
        }
    }
}
