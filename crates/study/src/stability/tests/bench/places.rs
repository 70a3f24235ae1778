//! Mechanisms of the bench, one of each type, that come to singular positions and to dead centers.

use std::f64::consts::{FRAC_PI_2, PI};

use assur_group::Wrench;
use assur_kinematics::Linkage;
use assur_words::name;

use crate::stability::row::{Comparison, DISTANCES};
use crate::stability::target::Target;
use crate::stability::tests::{CYCLE, Law, Section, differences, named, scales, turns};
use crate::stability::walk::{Walk, test_loads};

static DISPARATE: Law = Law {
    section: "Scales",
    along: "greatest length, or mass, over the least",
    expected: "16 eps (1 + |q|) / determinant^k of the largest number of its kind, however different the links \
               are",
};

/// A scene and where it is walked to: coordinate, sides, what is there.
pub(crate) struct Approach {
    pub(crate) name: &'static str,
    scene: String,
    targets: Vec<(f64, &'static [f64], &'static str)>,
}

const BOTH: &[f64] = &[-1.0, 1.0];
const ABOVE: &[f64] = &[1.0];
const BELOW: &[f64] = &[-1.0];

/// Far enough to walk all distances, rad or m.
const FAR: f64 = 0.5;

/// All rows of these mechanisms.
pub(crate) fn sections() -> Vec<Section> {
    let mut sections = vec![Section { law: &CYCLE, rows: approaching() }];
    sections.push(Section { law: &PARALLEL, rows: parallel_guides() });
    sections.extend(ordinary());
    sections.push(Section { law: &DISPARATE, rows: disparate() });
    sections
}

/// Along the cycle to singular positions and dead centers.
fn approaching() -> Vec<Comparison> {
    let mut rows = Vec::new();
    for approach in approaches() {
        let Some(linkage) = compiled(&approach.scene) else { continue };
        let Some(walk) = Walk::new(&linkage) else { continue };
        for &(coordinate, sides, words) in &approach.targets {
            let target =
                Target { coordinate, sides: sides.to_vec(), reach: FAR, groups: vec![0], words: name(words) };
            let mut found = Vec::new();
            walk.to(&target, &mut found);
            rows.extend(named(found, approach.name, words));
        }
    }
    rows
}

/// The scenes are the program's own; a test holds that each compiles.
pub(crate) fn compiled(scene: &str) -> Option<Linkage> {
    Linkage::compile(assur_scene::read("bench.toml", scene).ok()?).ok()
}

/// A crank of 1 with rod and slider.
fn slider_crank(crank: f64, rod: f64, offset: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\nmass = 1\ncenter = \"O\"\n\
         [link.rod]\npoints = {{ A = 0, B = {rod} }}\nmass = 2\ncenter = {0}\ninertia = {1}\n\
         [link.slider]\npoints = {{ B = 0 }}\nmass = 3\n\
         [[slide]]\nlink = \"slider\"\non = \"ground\"\nthrough = [0, {offset}]\n\
         [input]\nlink = \"crank\"\n[assembly]\nB = [{rod}, {offset}]\n",
        0.5 * rod,
        0.1 * rod * rod,
    )
}

/// The same driven by the slider, the group being crank and rod.
fn driven(crank: f64, rod: f64, from: f64, to: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
         [link.rod]\npoints = {{ B = 0, A = {rod} }}\n[link.slider]\npoints = {{ B = 0 }}\n\
         [[slide]]\nlink = \"slider\"\non = \"ground\"\n\
         [input]\nlink = \"slider\"\nfrom = {from}\nto = {to}\n[assembly]\nA = [0, 1]\n"
    )
}

/// Crank, coupler, rocker, ground.
fn four_bar([crank, coupler, rocker, ground]: [f64; 4], input: &str) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0], C = [{ground}, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
         [link.coupler]\npoints = {{ A = 0, B = {coupler} }}\n[link.rocker]\npoints = {{ C = 0, B = {rocker} }}\n\
         [input]\nlink = \"crank\"\n{input}"
    )
}

/// Type 3: a stone on the crank's pin slides in a rocker that is pinned to the ground, past its pin at a distance.
fn inverted(crank: f64, offset: f64) -> String {
    format!(
        "[ground]\npoints = {{ O = [0, 0], C = [1, 0] }}\n[link.crank]\npoints = {{ O = 0, A = {crank} }}\n\
         [link.stone]\npoints = {{ A = 0 }}\n[link.rocker]\npoints = {{ C = 0 }}\n\
         [[slide]]\nlink = \"stone\"\non = \"rocker\"\nthrough = [0, {offset}]\n\
         [input]\nlink = \"crank\"\nfrom = 1.5\nto = 4.5\n"
    )
}

/// Type 4: stones on the crank's guide and on the ground's share a pin.
const CROSSED: &str = "[ground]\npoints = { O = [0, 0] }\n[link.crank]\npoints = { O = 0 }\n\
    [link.stone1]\npoints = { P = 0 }\n[link.stone2]\npoints = { P = 0 }\n\
    [[slide]]\nlink = \"stone1\"\non = \"crank\"\nthrough = [0, 0.3]\n\
    [[slide]]\nlink = \"stone2\"\non = \"ground\"\nthrough = [0, 0.5]\n\
    [input]\nlink = \"crank\"\nfrom = 1\nto = 2\n";

pub(crate) fn approaches() -> Vec<Approach> {
    // Stretched where |AC| = 2.7, folded where |AC| = 1.5, by the law of cosines.
    let reach = |crank: f64, ground: f64, apart: f64| {
        ((crank * crank + ground * ground - apart * apart) / (2.0 * crank * ground)).acos()
    };
    let offset_reach = |reach: f64| (0.3_f64 / reach).asin();
    vec![
        Approach {
            name: "type 1, four-bar 2 : 1.5 : 1.2 : 2",
            scene: four_bar([2.0, 1.5, 1.2, 2.0], "from = 0.8\nto = 0.9\n"),
            targets: vec![(reach(2.0, 2.0, 2.7), BELOW, "stretched")],
        },
        Approach {
            name: "type 1, four-bar 1.8 : 3 : 1.5 : 2",
            scene: four_bar([1.8, 3.0, 1.5, 2.0], "from = 1.5\nto = 1.6\n"),
            targets: vec![(reach(1.8, 2.0, 1.5), ABOVE, "folded")],
        },
        Approach {
            name: "type 2, slider-crank 1 : 0.6",
            scene: slider_crank(1.0, 0.6, 0.0),
            targets: vec![
                (0.6_f64.asin(), BELOW, "rod perpendicular to the guide"),
                (-(0.6_f64.asin()), ABOVE, "rod perpendicular to the guide, below"),
            ],
        },
        Approach {
            name: "type 3, stone in a rocker, offset 0.5",
            scene: inverted(1.0, 0.5),
            targets: vec![(2.0 * 0.25_f64.asin(), ABOVE, "pins as close as the offset")],
        },
        Approach {
            name: "type 3, stone in a rocker, central",
            scene: inverted(0.999_999_999, 0.0),
            targets: vec![(0.0, BOTH, "pins meeting to 1e-9")],
        },
        Approach {
            name: "type 4, stones on crank and ground",
            scene: CROSSED.to_owned(),
            targets: vec![(0.0, ABOVE, "guides turning parallel"), (PI, BELOW, "guides turning parallel")],
        },
        Approach {
            name: "slider-crank 1 : 4 in line",
            scene: slider_crank(1.0, 4.0, 0.0),
            targets: vec![
                (0.0, BOTH, "outer dead center"),
                (PI, BOTH, "inner dead center"),
                (FRAC_PI_2, BOTH, "crank perpendicular to the guide, pole at infinity"),
            ],
        },
        Approach {
            name: "slider-crank 1 : 4 offset 0.3",
            scene: slider_crank(1.0, 4.0, 0.3),
            targets: vec![
                (offset_reach(5.0), BOTH, "outer dead center"),
                (PI + offset_reach(3.0), BOTH, "inner dead center"),
                (FRAC_PI_2, BOTH, "crank perpendicular to the guide, pole at infinity"),
            ],
        },
        Approach {
            name: "slider-crank 1 : 1 in line",
            scene: slider_crank(1.0, 1.0, 0.0).replace("[assembly]", "from = 0.3\n[assembly]"),
            targets: vec![(0.0, BOTH, "outer dead center"), (PI, BOTH, "inner dead center")],
        },
        Approach {
            name: "slider-crank 1 : 4 driven by the slider",
            scene: driven(1.0, 4.0, 3.5, 4.5),
            targets: vec![(5.0, BELOW, "outer dead center"), (3.0, ABOVE, "inner dead center")],
        },
        Approach {
            name: "slider-crank 1 : 1 driven by the slider",
            scene: driven(1.0, 1.0, 0.5, 1.5),
            targets: vec![(2.0, BELOW, "outer dead center"), (0.0, BOTH, "inner dead center, pins meeting")],
        },
        Approach {
            name: "four-bar with the crank parallel to the rocker at 90 deg",
            scene: four_bar([1.0, 4.25_f64.sqrt(), 1.5, 2.0], "from = 1.5\n[assembly]\nB = [2, 1.5]\n"),
            targets: vec![(FRAC_PI_2, BOTH, "pole at infinity")],
        },
    ]
}

/// Type 5: the angle between its guides is that of the links, so each distance is a mechanism of its own.
fn parallel_guides() -> Vec<Comparison> {
    let mut rows = Vec::new();
    for distance in DISTANCES {
        let scene = format!(
            "[ground]\npoints = {{ O = [0, 0], C = [0.3, 0.2] }}\n[link.crank]\npoints = {{ O = 0 }}\n\
             [link.arm]\npoints = {{ C = 0 }}\n[link.stone]\npoints = {{ S = 0 }}\n\
             [[slide]]\nlink = \"stone\"\non = \"crank\"\nthrough = [0, 0.4]\n\
             [[slide]]\nlink = \"arm\"\non = \"stone\"\nangle = {distance}\n[input]\nlink = \"crank\"\nto = 1\n"
        );
        let Some(linkage) = compiled(&scene) else { continue };
        let Some(walk) = Walk::new(&linkage) else { continue };
        walk.stop(&beside("guides nearly parallel"), (0.7, 0.7), distance, &mut rows);
    }
    named(rows, "type 5, stone on the crank, arm on the stone", "guides nearly parallel")
}

static PARALLEL: Law = Law {
    section: "Along the cycle",
    along: "angle between the guides, rad",
    expected: "stability-expected",
};

/// Mechanisms far from any singular position: differences, turns, scales; turns of a parallelogram also beside its change
/// point, where the motion is interpolated.
fn ordinary() -> [Section; 3] {
    let crank_rocker = "from = 0.3\n[assembly]\nB = [4, 3]\n";
    let scenes = [
        ("slider-crank 1 : 4 in line", slider_crank(1.0, 4.0, 0.0)),
        ("crank-rocker 1 : 3.5 : 3 : 4", four_bar([1.0, 3.5, 3.0, 4.0], crank_rocker)),
    ];
    let (mut differentiated, mut turned, mut scaled) = (Vec::new(), Vec::new(), Vec::new());
    for (name, scene) in scenes {
        let Some(linkage) = compiled(&scene) else { continue };
        differentiated.extend(differences::rows(&linkage, 1.0, name));
        scaled.extend(scales::rows(&linkage, 1.0, name));
        if let Some(walk) = Walk::new(&linkage) {
            turned.extend(named(turns::rows(&linkage, &walk, 1.0), name, "turns away"));
        }
    }
    let parallelogram = four_bar([0.5, 1.0, 0.5, 1.0], "from = 1\n[assembly]\nB = [1.3, 0.4]\n");
    let linkage = compiled(&parallelogram);
    if let Some((linkage, walk)) = linkage.as_ref().and_then(|linkage| Some((linkage, Walk::new(linkage)?))) {
        let rows = turns::rows(linkage, &walk, 1e-3);
        turned.extend(named(rows, "parallelogram, 1e-3 rad from its change point", "turns away"));
    }
    [
        Section { law: &differences::LAW, rows: differentiated },
        Section { law: &turns::LAW, rows: turned },
        Section { law: &scales::LAW, rows: scaled },
    ]
}

/// A crank of a micrometer on a rod of a kilometer, and masses of 1e-9 and 1e9 kg in one mechanism.
fn disparate() -> Vec<Comparison> {
    let mut rows = Vec::new();
    for ratio in [1e3, 1e6, 1e9] {
        let scene = slider_crank(1e3 / ratio, 1e3, 0.0);
        if let Some(walk) = compiled(&scene).as_ref().and_then(Walk::new) {
            walk.stop(&beside("a short crank on a rod of 1 km"), (1.0, 1.0), ratio, &mut rows);
        }
        let Some(linkage) = compiled(&slider_crank(1.0, 4.0, 0.0)) else { continue };
        let loads = test_loads(&linkage).into_iter().enumerate();
        let heavy =
            loads.map(|(link, load)| times(load, [1.0, 1.0, 1.0 / ratio, ratio][link.min(3)])).collect();
        if let Some(mut walk) = Walk::new(&linkage) {
            let words = "light rod, heavy slider";
            walk.loads = heavy;
            walk.stop(&beside(words), (1.0, 1.0), ratio * ratio, &mut rows);
        }
    }
    rows
}

/// A place that is not walked to: the only group is compared at one coordinate.
fn beside(words: &'static str) -> Target {
    Target { coordinate: 0.0, sides: Vec::new(), reach: 0.0, groups: vec![0], words: name(words) }
}

fn times(load: Wrench<f64>, factor: f64) -> Wrench<f64> {
    Wrench { fx: load.fx * factor, fy: load.fy * factor, m: load.m * factor }
}
