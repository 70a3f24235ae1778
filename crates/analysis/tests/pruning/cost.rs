//! What is solved, counted.

use assur_analysis::results::{Column, Quantity, Table};
use assur_analysis::{Calculation, unwatched};
use assur_group::Order;
use assur_mechanism::Mechanism;

use crate::probe::{Solved, probe};
use crate::{mechanism, study, text};

/// By group: what an analysis solves.
fn counted(mut study: Calculation) -> Vec<Solved> {
    let calls = probe(&mut study);
    let found = study.analyze(&mut unwatched).unwrap();
    assert!(found.failures.is_empty(), "{:?}", found.failures);
    calls.iter().map(|calls| calls.solved()).collect()
}

fn of(text: &str) -> (Calculation, Vec<Solved>) {
    (study(mechanism(text)), counted(study(mechanism(text))))
}

/// The shaper with ram and stone of the second group free of mass and load.
fn light_ram() -> String {
    let text = text("shaper");
    let (before, after) = text.split_once("[link.stone4]").unwrap();
    let (links, rest) = after.split_once("[[slide]]").unwrap();
    let bare = |line: &&str| !["mass", "center", "inertia"].iter().any(|key| line.starts_with(key));
    let links = links.lines().filter(bare).collect::<Vec<_>>().join("\n");
    let text = format!("{before}[link.stone4]{links}\n[[slide]]{rest}");
    let force = text.find("[[force]]").unwrap();
    let end = text[force + 2..].find("\n[").map_or(text.len(), |at| force + 2 + at);
    format!("{}{}", &text[..force], &text[end..])
}

/// The balancing loads, which every position has.
fn balancing(positions: &Table) -> Vec<f64> {
    let column = positions.schema().find(Column::BALANCING).unwrap();
    positions.each(column).map(Option::unwrap).collect()
}

/// Every position has forces and moments of a pin or slide, and all are exactly zero.
fn assert_no_reaction(positions: &Table, joint: &str) {
    let schema = positions.schema();
    let of_joint = |column: &Column| {
        matches!(column.quantity, Quantity::Force | Quantity::Moment) && schema.name(column.owner) == joint
    };
    let columns = schema.select(of_joint);
    assert!(columns.len() >= 4, "{joint}");
    let values = columns.into_iter().flat_map(|column| positions.each(column));
    values.for_each(|value| assert_eq!(value.map(f64::to_bits), Some(0.0_f64.to_bits()), "{joint}"));
}

const NOTHING: Solved = Solved { places: 0, first: 0, second: 0, forces: 0 };

#[test]
fn a_group_without_load_is_left_alone_and_its_reactions_are_exactly_zero() {
    let (whole, solved) = of(&light_ram());
    assert_eq!(whole.plan.groups_carrying, [true, false]);
    // Beside the positions, the sides of the guide are looked at over the cycle.
    assert!(solved[0].forces >= 48, "{solved:?}");
    assert_eq!(solved[1].forces, 0);
    let found = whole.analyze(&mut unwatched).unwrap();
    for joint in ["D", "stone4/ram", "ram/ground"] {
        assert_no_reaction(&found.positions, joint);
    }
    assert!(balancing(&found.positions).iter().all(|moment| *moment != 0.0));
}

#[test]
fn a_group_whose_reactions_are_zero_is_not_even_placed_for_them() {
    let (part, solved) = of(&(light_ram() + "\n[output]\nreactions = [\"A\", \"ram/ground\"]\n"));
    assert_eq!(part.plan.groups_needed, [true, false]);
    assert_eq!(solved[1], NOTHING);
    let found = part.analyze(&mut unwatched).unwrap();
    assert_no_reaction(&found.positions, "ram/ground");
}

#[test]
fn places_cost_no_forces_and_groups_behind_cost_nothing() {
    let whole = of(&text("shaper")).1;
    assert!(whole.iter().all(|group| group.places >= 48 && group.second >= 48 && group.forces >= 48));
    let (part, solved) = of(&(text("shaper") + "\n[output]\npoints = [\"S3\"]\n"));
    assert_eq!(part.plan.order, Order::Second);
    // The first position is placed once more to compare it with `[assembly]`, and three times for its modes: as it is taken, and in
    // each of the two ways.
    assert_eq!(solved, [Solved { places: 52, first: 48, second: 48, forces: 0 }, NOTHING]);
}

#[test]
fn statics_of_massless_links_stop_at_the_first_derivatives() {
    let still = |text: String| text.replace("[motion]\nspeed = \"10 rpm\"\n", "");
    let (part, solved) = of(&(still(text("press")) + "\n[output]\nreactions = [\"A\"]\n"));
    assert_eq!(part.plan.order, Order::First);
    assert!(solved[0].first > 0 && solved[0].second == 0, "{solved:?}");
}

#[test]
fn what_depends_on_nothing_is_not_solved() {
    // A motion without mass and load: every reaction is zero, wherever the links are.
    let bare = text("n-four-bar-2").replace("mass = 1\n", "").replace("gravity = \"9.81 m/s^2\"", "");
    let bare = bare.lines().filter(|line| !line.starts_with("center") && !line.starts_with("inertia"));
    let bare = bare.collect::<Vec<_>>().join("\n");
    let motion = bare.find("[motion]").unwrap();
    let end = bare[motion + 2..].find("\n[").map_or(bare.len(), |at| motion + 2 + at);
    let bare = format!("{}[motion]\nspeed = 1\n{}", &bare[..motion], &bare[end..]);
    let (part, solved) = of(&(bare + "\n[output]\nreactions = [\"B1\"]\n"));
    assert_eq!((part.plan.order, solved), (Order::Place, vec![NOTHING, NOTHING]));
    let positions = part.analyze(&mut unwatched).unwrap().positions;
    assert!(balancing(&positions).iter().all(|moment| *moment == 0.0));
}

#[test]
fn another_method_solves_all_groups() {
    let mechanism: Mechanism = mechanism(&(light_ram() + "\n[output]\nreactions = [\"A\"]\n"));
    let analyzer = Some("newton-euler".to_owned());
    let options = assur_analysis::Options { analyzer, ..Default::default() };
    let study = Calculation::of(mechanism, &options, &mut unwatched).unwrap();
    assert_eq!(study.plan.groups_needed, [true, true]);
    assert!(study.analyze(&mut unwatched).unwrap().failures.is_empty());
}
