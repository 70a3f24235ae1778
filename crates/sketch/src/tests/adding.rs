//! Every kind is added to scenes at random places.

use std::f64::consts::PI;

use assur_group::PairSort;
use assur_kinematics::decompose;

use super::{Random, drawn, read};
use crate::{Addition, Fit, Names, Sketch, Start, Target, add, additions, start};

/// Random targets of the outer pairs.
fn targets(random: &mut Random, sketch: &Sketch, addition: &Addition) -> Vec<Target> {
    let size = sketch.size();
    let links: Vec<String> = sketch.mechanism.links.iter().map(|link| link.name.to_string()).collect();
    let points: Vec<(String, [f64; 2])> = sketch.points().map(|(name, at)| (name.to_owned(), at)).collect();
    let mut used: Vec<String> = Vec::new();
    let mut all = Vec::new();
    for sort in addition.outer() {
        let near = random.pick(&points).1;
        let at = [near[0] + random.range(-size, size), near[1] + random.range(-size, size)];
        let link = random.pick(&links).clone();
        all.push(match sort {
            PairSort::Slide => Target::Guide { link, through: at, angle: random.range(-PI, PI), point: None },
            _ => {
                let free: Vec<_> = points.iter().filter(|(name, _)| !used.contains(name)).collect();
                if random.unit() < 0.5 && !free.is_empty() {
                    let name = random.pick(&free).0.clone();
                    used.push(name.clone());
                    Target::Point(name)
                } else {
                    Target::New { link, at }
                }
            }
        });
    }
    all
}

#[test]
fn every_kind_is_added_as_one_group_that_can_be_assembled_as_drawn() {
    let scenes = [
        assur_fixtures::scene("four-bar").to_owned(),
        assur_fixtures::scene("shaper").to_owned(),
        start(Start::CRANK),
        start(Start::SLIDE),
    ];
    let mut random = Random(7);
    let (mut here, mut everywhere, mut count) = (0, 0, 0);
    for addition in additions().unwrap().iter().filter(|addition| addition.plugin.is_some()) {
        for (index, scene) in scenes.iter().enumerate() {
            let before = drawn(scene);
            for round in 0..4 {
                let targets = targets(&mut random, &before, addition);
                let what = format!("{} at scene {index}, round {round}: {targets:?}", addition.name);
                let added = add(scene, &before, addition, &targets, &Names::default()).unwrap();
                let mechanism = read(&added.text);
                let structure = decompose(&mechanism).unwrap_or_else(|error| panic!("{what}: {error:?}\n{}", added.text));
                let mut links: Vec<usize> = added.links.iter().map(|link| mechanism.link(link).unwrap()).collect();
                links.sort_unstable();
                let group = structure.groups.iter().find(|group| group.frame.links == links);
                let found = group.map(|group| group.plugin.name);
                count += 1;
                if found != Some(addition.name) || added.fit == Fit::Nowhere {
                    println!("{what}\n  {found:?} {:?}\n{}", added.fit, added.text.replace(scene.as_str(), ""));
                }
                here += usize::from(added.fit >= Fit::Here);
                everywhere += usize::from(added.fit == Fit::Everywhere);
            }
        }
    }
    println!("{count} added, {here} as drawn, {everywhere} everywhere");
}
