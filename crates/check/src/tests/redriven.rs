//! Random mechanisms, driven in a pair between two moving links instead: the relative motion of all links is the same, and the drive does
//! the same work.

use assur_group::{Body, Order};
use assur_kinematics::{Linkage, Position};
use assur_mechanism::{Driver, GROUND, Input, InputPair, LinkId, Mechanism, Range};
use assur_testkit::specimen::{Recipe, scene_text};

use super::{checks, hold, show};

/// Every pair between two moving links: what is driven, against what.
fn moving_pairs(mechanism: &Mechanism) -> Vec<(LinkId, LinkId, InputPair)> {
    let mut found = Vec::new();
    for (id, point) in mechanism.points.iter().enumerate() {
        for (k, of) in point.places.iter().enumerate() {
            let others = point.places[..k].iter().map(|on| (of.link, on.link, InputPair::Pin(id)));
            found.extend(others);
        }
    }
    let slides = mechanism.slides.iter().enumerate();
    found.extend(slides.map(|(id, slide)| (slide.link, slide.on, InputPair::Slide(id))));
    found.retain(|(of, on, _)| ![*of, *on].contains(&GROUND));
    found
}

/// The coordinate of a pair with its derivatives by that of the mechanism.
fn coordinate(linkage: &Linkage, pose: &Position, (of, on, pair): (LinkId, LinkId, InputPair)) -> [f64; 3] {
    let (a, b): (&Body<f64>, &Body<f64>) = (&pose.bodies[of], &pose.bodies[on]);
    match pair {
        InputPair::Pin(_) => [(a.s * b.c - a.c * b.s).atan2(a.c * b.c + a.s * b.s), a.w1 - b.w1, a.w2 - b.w2],
        InputPair::Slide(slide) => {
            let motion = linkage.slide_motion(slide, pose);
            [motion.pf0, motion.pf1, motion.pf2]
        }
    }
}

/// The mechanism driven in this pair from its first position on, with all points where they are.
fn redriven(linkage: &Linkage, pose: &Position, pair: (LinkId, LinkId, InputPair), from: f64) -> Mechanism {
    let mut mechanism = linkage.mechanism.clone();
    let (link, on, pair) = pair;
    let label = mechanism.links[link].name.clone();
    let drivers = vec![Driver { link, on, pair, label, law: None }];
    mechanism.input = Input { drivers, from, range: Range::To(from), positions: 1, ..mechanism.input };
    let points = 0..mechanism.points.len();
    mechanism.assembly = points.map(|point| (point, linkage.point_motion(point, pose).pf0)).collect();
    // Formulas over the coordinate would mean another one.
    (mechanism.motion, mechanism.balance) = (None, None);
    mechanism.loads.clear();
    mechanism.frictions.clear();
    mechanism
}

#[test]
fn driven_between_two_moving_links_the_relative_motion_is_the_same() {
    let (mut compared, mut kinds) = (0, std::collections::BTreeSet::new());
    for seed in 0..120 {
        let number = usize::try_from(seed).unwrap();
        let mechanism = Recipe::of(1 + number % 4).specimen(seed).unwrap().mechanism;
        let linkage = Linkage::compile(mechanism.clone()).unwrap();
        let mut old = linkage.position();
        linkage.solve_index(0, Order::Second, &mut old).unwrap();
        for pair in moving_pairs(&mechanism) {
            let [from, first, second] = coordinate(&linkage, &old, pair);
            let unit = if matches!(pair.2, InputPair::Pin(_)) { 1.0 } else { linkage.structure.scale };
            if first.abs() * linkage.coordinate_unit() < 0.2 * unit {
                continue;
            }
            let moved = redriven(&linkage, &old, pair, from);
            let text = scene_text(&moved);
            let Ok(moved) = Linkage::compile(moved) else { continue };
            let mut new = moved.position();
            if moved.solve_index(0, Order::Second, &mut new).is_err() {
                continue;
            }
            let condition: f64 = new.health.iter().chain(&old.health).map(|h| 1.0 / h.abs()).product();
            for (id, (a, b)) in old.bodies.iter().zip(&new.bodies).enumerate().take(linkage.structure.links) {
                // d/dp = (d/dq) / p', and d²/dp² = (d²/dq² - (d/dp) p'') / p'², p the coordinate of the pair.
                let rates = [(a.x1, a.x2), (a.y1, a.y2), (a.w1, a.w2)]
                    .map(|(one, two)| [one / first, (two - one / first * second) / (first * first)]);
                let found = [[b.x1, b.x2], [b.y1, b.y2], [b.w1, b.w2]];
                let sizes = rates.iter().flatten().fold(1.0_f64, |most, rate| most.max(rate.abs()));
                let limit = 1e-12 * condition * condition * sizes * sizes * (1.0 + second.abs());
                let places = (a.x - b.x).abs() + (a.y - b.y).abs() + (a.c - b.c).abs() + (a.s - b.s).abs();
                let off = rates.iter().flatten().zip(found.iter().flatten());
                let off = off.fold(places, |most, (rate, found)| most.max((rate - found).abs()));
                assert!(off < limit, "seed {seed}, {pair:?}: link {id} off by {off:e} of {limit:e}\n{text}");
            }
            compared += 1;
            kinds.extend(
                moved
                    .structure
                    .groups
                    .iter()
                    .filter(|group| !group.frame.driven.is_empty())
                    .map(|group| group.plugin.name),
            );
        }
    }
    assert!(compared > 200, "only {compared} pairs could be driven");
    assert!(["rrr", "any"].iter().all(|kind| kinds.contains(kind)), "{kinds:?}");
}

#[test]
fn every_check_holds_where_two_moving_links_are_driven() {
    let mut checked = 0;
    for seed in 0..40 {
        let number = usize::try_from(seed).unwrap();
        let mechanism = Recipe::of(1 + number % 3).specimen(seed).unwrap().mechanism;
        let linkage = Linkage::compile(mechanism.clone()).unwrap();
        let mut pose = linkage.position();
        linkage.solve_index(0, Order::Second, &mut pose).unwrap();
        let pairs = moving_pairs(&mechanism);
        let Some(&pair) = pairs.get(number % pairs.len().max(1)) else { continue };
        let [from, first, _] = coordinate(&linkage, &pose, pair);
        let unit = if matches!(pair.2, InputPair::Pin(_)) { 1.0 } else { linkage.structure.scale };
        if first.abs() * linkage.coordinate_unit() < 0.2 * unit {
            continue;
        }
        let mut moved = redriven(&linkage, &pose, pair, from);
        (moved.input.range, moved.input.positions) = (Range::To(from + 0.02 * unit), 3);
        moved.gravity = Some([0.0, -9.81]);
        let text = scene_text(&moved);
        let Ok(moved) = Linkage::compile(moved) else { continue };
        if (0..3).any(|index| moved.solve_index(index, Order::Second, &mut moved.position()).is_err()) {
            continue;
        }
        let all = checks(&moved);
        assert!(hold(&all), "seed {seed}, {pair:?}\n{}\n{text}", show(&all));
        checked += 1;
    }
    assert!(checked > 15, "only {checked} were checked");
}
