//! The equation of motion of a position against the program's reduction, and its forces against the drive.

use assur_force::{LoadState, Loads};
use assur_group::Order;
use assur_kinematics::Linkage;

use assur_words::Language;

use super::evaluate::{equations, printed, recomputes};
use super::fixtures::scene;
use crate::{PositionOrSample, Task, Working};

#[test]
fn the_acceleration_follows_from_the_reduction() {
    for (name, speed) in [
        ("shaper-drive", 6.2),
        ("run-up", 40.0),
        ("flywheel", 3.0),
        ("slider-crank", -30.0),
        ("stephenson3", 5.0),
    ] {
        let linkage = Linkage::compile(scene(name)).unwrap();
        let loads = Loads::compile(&linkage).unwrap();
        let [driving, own] = [75.0, 2.5];
        for index in [1, 3, 7] {
            let mut position = linkage.position();
            linkage.solve_index(index, Order::Second, &mut position).unwrap();
            let state = LoadState { coordinate: position.coordinate, speed, ..LoadState::default() };
            let reduced = loads.reduced(&state, &position.bodies);
            let net = reduced.moment + driving - 0.5 * reduced.inertia_derivative * speed * speed;
            let acceleration = net / (reduced.inertia + own);
            let state = LoadState { acceleration, ..state };
            let place = PositionOrSample::Position(index);
            let task = Task {
                linkage: &linkage,
                loads: Some(&loads),
                state,
                place,
                drive: Some([driving, own]),
                analyzer: None,
            };
            let text = Working::of(&task).unwrap().text(Language::english());
            recomputes(&format!("{name} {index}"), &text);
            let all = equations(&text);
            let value = |symbol: &str| {
                let row = all.iter().find(|parts| parts[0] == symbol);
                printed(row.unwrap_or_else(|| panic!("{name}: no {symbol} in\n{text}")).last().unwrap()).0
            };
            for (symbol, wanted) in [
                ("J", reduced.inertia),
                ("J′", reduced.inertia_derivative),
                ("Q", reduced.moment),
                ("ε", acceleration),
                ("M_bal", driving - own * acceleration),
                ("M_bal_drive", driving - own * acceleration),
            ] {
                let size = wanted.abs().max(1e-3);
                assert!(
                    (value(symbol) - wanted).abs() <= 1e-5 * size,
                    "{name} {index}: {symbol} {wanted}\n{text}"
                );
            }
        }
    }
}
