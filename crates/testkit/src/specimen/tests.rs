use assur_all as _;
use assur_group::Order;
use assur_kinematics::Linkage;

use super::{Recipe, Specimen, scene_text};

/// Specimens of one to five groups, a few for each kind alone and more of all kinds.
fn specimens() -> Vec<(u64, Specimen)> {
    let alone = ["rrr", "rrp", "rpr", "prp", "rpp"].map(|kind| Recipe { only: Some(kind), ..Recipe::of(1) });
    let mixed = [1, 2, 3, 4, 5].map(Recipe::of);
    let recipes: Vec<_> = alone.into_iter().chain(mixed).collect();
    let find = |seed: u64| recipes[usize::try_from(seed).unwrap() % recipes.len()].specimen(seed);
    (0..60).map(|seed| (seed, find(seed).unwrap_or_else(|| panic!("no specimen for seed {seed}")))).collect()
}

#[test]
fn the_text_of_a_specimen_reads_as_the_same_mechanism() {
    for (seed, specimen) in specimens() {
        let text = scene_text(&specimen.mechanism);
        let mut read =
            assur_scene::read("specimen.toml", &text).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
        // Random numbers may look like mistakes: a resistance that drives, a link much heavier than the others.
        read.warnings.clear();
        assert_eq!(read, specimen.mechanism, "seed {seed}\n{text}");
    }
}

#[test]
fn the_constructed_pose_is_the_first_position() {
    for (seed, specimen) in specimens() {
        let linkage = Linkage::compile(specimen.mechanism).unwrap();
        let mut position = linkage.position();
        linkage.solve_index(0, Order::Place, &mut position).unwrap();
        let scale = linkage.structure.scale;
        // Each group may multiply rounding by the inverse of its determinant.
        let condition: f64 = position.health.iter().map(|health| 1.0 / health.abs()).product();
        for (body, [x, y, angle]) in position.bodies.iter().zip(&specimen.poses) {
            let off =
                (body.x - x).hypot(body.y - y) / scale + (body.c - angle.cos()).hypot(body.s - angle.sin());
            assert!(off < 1e-14 * condition.max(10.0), "seed {seed}: off by {off:e}, condition {condition}");
        }
    }
}

#[test]
fn groups_are_found_as_they_were_made() {
    for (seed, specimen) in specimens() {
        let linkage = Linkage::compile(specimen.mechanism).unwrap();
        let mut found: Vec<_> = linkage.structure.groups.iter().map(|group| group.plugin.name).collect();
        let mut made = specimen.kinds.clone();
        found.sort_unstable();
        made.sort_unstable();
        assert_eq!(found, made, "seed {seed}");
    }
}

#[test]
fn one_hundred_seeds_show_every_arrangement() {
    let all: Vec<_> = specimens().into_iter().map(|(_, specimen)| specimen.mechanism).collect();
    let any = |what: fn(&assur_mechanism::Mechanism) -> bool| all.iter().any(what);
    assert!(any(|m| !m.input.is_angle()));
    assert!(any(|m| matches!(m.input.range, assur_mechanism::Range::Cycle(_))));
    assert!(any(|m| m.input.direction == assur_mechanism::Sense::Cw));
    assert!(any(|m| m.points.iter().any(|point| point.places.len() > 2)));
    assert!(any(|m| m.slides.iter().any(|slide| slide.on > slide.link && slide.on != 0)));
    assert!(any(|m| m.slides.iter().any(|slide| slide.link > slide.on && slide.on > 1)));
    assert!(any(|m| m.balance.is_some()));
    assert!(any(|m| m.loads.iter().any(|load| load.kind.contact().is_some())));
    assert!(any(|m| m.loads.iter().any(|load| load.kind.spring().is_some())));
}

#[test]
fn the_text_of_a_specimen_with_several_drives_reads_as_the_same_mechanism() {
    for seed in 0..30 {
        let number = usize::try_from(seed).unwrap();
        let mut mechanism = Recipe::of(1 + number % 3).several(seed, 2 + number % 2).unwrap();
        let text = scene_text(&mechanism);
        let mut read =
            assur_scene::read("specimen.toml", &text).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
        read.warnings.clear();
        // Where two are driven in one pin, a scene tells them apart.
        for (own, read) in mechanism.input.drivers.iter_mut().zip(&read.input.drivers) {
            own.label = read.label.clone();
        }
        assert_eq!(read, mechanism, "seed {seed}\n{text}");
    }
}
