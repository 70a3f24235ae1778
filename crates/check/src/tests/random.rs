use assur_group::Order;
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, InputPair, LinkId, Mechanism, PointId, Range};
use assur_testkit::specimen::{Recipe, Rng};

use super::{checks, hold, show};

/// Random mechanisms of one to five groups; every tenth one of a single kind.
fn specimen(seed: u64) -> Mechanism {
    let number = usize::try_from(seed).unwrap();
    let only = (number % 10 == 9).then(|| ["rrr", "rrp", "rpr", "prp", "rpp"][(number / 10) % 5]);
    let recipe = Recipe { only, ..Recipe::of(1 + number % 5) };
    recipe.specimen(seed).unwrap_or_else(|| panic!("no specimen for seed {seed}")).mechanism
}

#[test]
fn every_check_holds_on_random_mechanisms() {
    let mut compared = 0;
    for seed in 0..200 {
        let mechanism = specimen(seed);
        let all = checks(&Linkage::compile(mechanism.clone()).unwrap());
        assert!(
            hold(&all),
            "seed {seed}\n{}\n{}",
            show(&all),
            assur_testkit::specimen::scene_text(&mechanism)
        );
        compared += usize::from(all.iter().any(|check| check.name.to_string() == "agreement of the methods"));
    }
    assert!(compared > 150, "only {compared} of the specimens had forces");
}

/// A mechanism with one point moved by up to half of its size; many no longer turn fully.
fn changed(seed: u64) -> Option<Linkage> {
    let mut mechanism = specimen(seed);
    let mut rng = Rng::new(seed);
    let point = rng.below(mechanism.points.len());
    let shift = [rng.signed(0.0, 0.5), rng.signed(0.0, 0.5)];
    let place = mechanism.points[point].places.last_mut()?;
    place.at = [place.at[0] + shift[0], place.at[1] + shift[1]];
    Linkage::compile(mechanism).ok()
}

#[test]
fn no_check_fails_on_random_mechanisms_next_to_the_ends_of_their_assembly() {
    let mut checked = 0;
    for seed in 0..80 {
        let Some(linkage) = changed(seed) else { continue };
        let Some(range) = linkage.range.filter(|range| !range.full) else { continue };
        let unit = linkage.coordinate_unit();
        for (end, side) in [(range.low, 1.0), (range.high, -1.0)] {
            for power in [2, 4, 6, 8, 10, 12] {
                let mut mechanism = linkage.mechanism.clone();
                let to = end + side * 0.1_f64.powi(power) * unit;
                // The assembly is that of the first position: the positions run from there to the end.
                (mechanism.input.range, mechanism.input.positions) = (Range::To(to), 2);
                let Ok(near) = Linkage::compile(mechanism) else { continue };
                let all = checks(&near);
                assert!(
                    all.iter()
                        .all(|check| check.finding.holds == Some(true) || check.finding.holds.is_none()),
                    "seed {seed}, 1e-{power} from {end}\n{}\n{}",
                    show(&all),
                    assur_testkit::specimen::scene_text(&near.mechanism)
                );
                checked += 1;
            }
        }
    }
    assert!(checked > 200, "only {checked} were checked");
}

/// A link that is joined to the ground by one pin alone.
fn other_inputs(mechanism: &Mechanism) -> Vec<(LinkId, PointId)> {
    let slides = |link| {
        mechanism.slides.iter().any(|s| [s.link, s.on] == [link, GROUND] || [s.on, s.link] == [link, GROUND])
    };
    let pins = |link| {
        let on = |point: &PointId| {
            mechanism.place_in(*point, link).is_some() && mechanism.place_in(*point, GROUND).is_some()
        };
        (0..mechanism.points.len()).filter(on).collect::<Vec<_>>()
    };
    let single = |link: LinkId| match pins(link)[..] {
        [pin] if !slides(link) && !mechanism.input.places(link) => Some((link, pin)),
        _ => None,
    };
    (1..mechanism.links.len()).filter_map(single).collect()
}

#[test]
fn driven_from_another_link_the_relative_motion_is_the_same() {
    let mut compared = 0;
    for seed in 0..150 {
        let mechanism = specimen(seed);
        let linkage = Linkage::compile(mechanism.clone()).unwrap();
        let mut old = linkage.position();
        linkage.solve_index(0, Order::Second, &mut old).unwrap();
        for (link, pin) in other_inputs(&mechanism) {
            let driver = old.bodies[link];
            if driver.w1.abs()
                < 0.1 * if linkage.kind().is_angle() { 1.0 } else { 1.0 / linkage.structure.scale }
            {
                continue;
            }
            let mut moved = mechanism.clone();
            let driver_of = &mut moved.input.drivers[0];
            (driver_of.link, driver_of.pair) = (link, InputPair::Pin(pin));
            moved.input.from = driver.s.atan2(driver.c);
            (moved.input.range, moved.input.positions) = (Range::To(moved.input.from), 1);
            // The groups may be of a class that no plugin solves.
            let Ok(moved) = Linkage::compile(moved) else { continue };
            let mut new = moved.position();
            moved.solve_index(0, Order::Second, &mut new).unwrap();
            let condition: f64 = new.health.iter().chain(&old.health).map(|h| 1.0 / h.abs()).product();
            compared += 1;
            for (id, (a, b)) in old.bodies.iter().zip(&new.bodies).enumerate() {
                // d/dp = (d/dq) / p', and d²/dp² = (d²/dq² - (d/dp) p'') / p'², p the angle of the new input.
                let first = a.w1 / driver.w1;
                let second = (a.w2 - first * driver.w2) / (driver.w1 * driver.w1);
                let size = 1.0 + a.w1.abs() + a.w2.abs() + second.abs() + driver.w2.abs();
                let limit = 1e-13 * condition * condition * size * size;
                let off =
                    (a.c - b.c).abs() + (a.s - b.s).abs() + (b.w1 - first).abs() + (b.w2 - second).abs();
                assert!(
                    off < limit,
                    "seed {seed}, driven by link {link}: link {id} off by {off:e} of {limit:e}"
                );
            }
        }
    }
    assert!(compared > 30, "only {compared} mechanisms could be driven from elsewhere");
}
