//! Moments of inertia, brakes and contacts by formula, where the formula or its derivative is zero or the motion rests: right numbers
//! pass, and slips do not.

use std::convert::Infallible;
use std::f64::consts::PI;
use std::ops::ControlFlow;

use assur_force::{LoadState, Loads, Side};
use assur_kinematics::Linkage;
use assur_testkit::specimen::Rng;

use super::{scene, show};
use crate::{Check, Chosen, Subject, checks, methods};

/// Every check in some states, with loads that may be those of another scene.
fn checked(linkage: &Linkage, loads: &Loads, states: &[LoadState]) -> Vec<Check> {
    let subject = Subject {
        linkage,
        loads: Some(loads),
        positions: Chosen::all(1),
        states: Chosen::all(states.len()),
        state: &|index| states.get(index).copied(),
        drive: None,
        methods: methods(linkage, None),
    };
    let ControlFlow::Continue((all, _)) = subject.checks(&mut |_, _| ControlFlow::<Infallible>::Continue(()));
    all
}

fn fail(all: &[Check]) -> bool {
    all.iter().any(|check| check.finding.failed())
}

/// A crank with a moment of inertia by formula.
fn crank(law: &str, from: f64) -> Linkage {
    scene(&format!(
        "[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.1 }}\nmass = 1\ncenter = \"O\"\n\
         inertia = {{ formula = \"{law}\" }}\n[input]\nlink = \"crank\"\nfrom = {from}\npositions = 48\n[motion]\nspeed = 10\n"
    ))
}

/// A wave of random size and frequency, half of which are whole numbers, with its mean, its part, and the wave.
fn law(rng: &mut Rng) -> (f64, f64, String) {
    let mean = rng.range(0.01, 0.5);
    let part = mean * rng.range(0.01, 0.99);
    let k = if rng.chance(0.5) { (1 + rng.below(400)) as f64 } else { rng.range(0.05, 60.0) };
    (mean, part, format!("{}({k}*q)", rng.pick(&["sin", "cos"])))
}

#[test]
fn inertia_by_formula_passes_at_the_zeros_of_its_derivative() {
    let mut rng = Rng::new(32);
    for number in 0..400 {
        let (mean, part, wave) = law(&mut rng);
        let from = 0.25 * PI * rng.below(5) as f64;
        let all = checks(&crank(&format!("{mean} + {part}*{wave}"), from));
        assert!(!fail(&all), "{number}: {mean} + {part}*{wave} from {from}:\n{}", show(&all));
    }
}

#[test]
fn slips_in_inertia_by_formula_are_caught() {
    let mut rng = Rng::new(33);
    for _ in 0..40 {
        let (mean, part, wave) = law(&mut rng);
        let sound = crank(&format!("{mean} + {part}*{wave}"), 0.3);
        let states: Vec<_> = (0..12)
            .map(|i| LoadState::prescribed(&sound.mechanism, sound.mechanism.input.coordinate(i)))
            .collect();
        let slips = [
            format!("{mean} - {part}*{wave}"),
            format!("{mean} + {part}*{}", wave.replace("*q", "*(1+1e-6)*q")),
            format!("{mean} + (1 + 1e-6)*{part}*{wave}"),
            format!("(1 + 1e-6)*({mean} + {part}*{wave})"),
        ];
        for slip in slips {
            let loads = Loads::compile(&crank(&slip, 0.3)).unwrap();
            assert!(fail(&checked(&sound, &loads, &states)), "{slip}");
        }
    }
}

/// A crank with a rod on a slide, under a load in a motion that is to be found.
fn compressor(load: &str) -> Linkage {
    scene(&format!(
        "gravity = 9.81\n[ground]\npoints = {{ O = 0 }}\n[link.crank]\npoints = {{ O = 0, A = 0.06 }}\nmass = 3\ncenter = [0.015, 0]\n\
         inertia = 0.008\n[link.rod]\npoints = {{ A = 0, B = 0.24, S = 0.08 }}\nmass = 1.8\ncenter = \"S\"\ninertia = 0.014\n\
         [link.piston]\npoints = {{ B = 0 }}\nmass = 1.1\n[[slide]]\nlink = \"piston\"\non = \"ground\"\nangle = \"90 deg\"\n\
         [input]\nlink = \"crank\"\n[motion]\nkind = \"transient\"\nspeed = 3\nuntil = \"turn\"\n[assembly]\nB = [0, 0.23]\n{load}\n"
    ))
}

/// States at rest that go on, end or stay, and one that moves, among them places at which the rod turns back.
fn states() -> Vec<LoadState> {
    let sides = [Side::After, Side::Before, Side::Held { upper: 0.3 }];
    let mut all = Vec::new();
    for coordinate in [0.0, 0.5, PI, 4.0] {
        for (speed, acceleration) in [(0.0, 20.0), (0.0, -20.0), (0.0, 0.0), (5.0, -3.0), (-5.0, 3.0)] {
            for side in sides.into_iter().filter(|side| speed == 0.0 || !matches!(side, Side::Held { .. })) {
                all.push(LoadState { coordinate, speed, acceleration, side, ..LoadState::default() });
            }
        }
    }
    all
}

/// A load, and slips of it: what stands in the place of a part.
const LOADS: [(&str, [(&str, &str); 3]); 4] = [
    (
        "[[brake]]\nlink = \"rod\"\nradius = 0.1\nforce = { formula = \"20+5*sin(3*q)\" }\nfriction = 0.3",
        [("0.1\n", "0.1000001\n"), ("20+5", "20-5"), ("sin", "cos")],
    ),
    // A force that pulls the shoe off drives.
    (
        "[[brake]]\nlink = \"rod\"\nradius = 0.1\nforce = { formula = \"-20+5*sin(3*q)\" }\nfriction = 0.3",
        [("0.1\n", "0.1000001\n"), ("20+5", "20-5"), ("sin", "cos")],
    ),
    // Whether the link rests doesn't depend on the size of the disc.
    (
        "[[brake]]\nlink = \"rod\"\nradius = 1e-30\nforce = { formula = \"20+5*sin(3*q)\" }\nfriction = 0.3",
        [("1e-30\n", "1.000001e-30\n"), ("20+5", "20-5"), ("sin", "cos")],
    ),
    (
        "[[contact]]\nlink = \"rod\"\ncenter = \"S\"\nradius = 0.3\nangle = { formula = \"0.2*sin(3*q)+0.1\" }\nforce = 20\n\
         friction = { against_sliding = 0.5 }",
        [("force = 20", "force = 20.00002"), ("+0.1", "+0.1000001"), ("0.5", "0.5000005")],
    ),
];

#[test]
fn brakes_and_contacts_by_formula_pass_at_rest() {
    for (load, slips) in LOADS {
        let linkage = compressor(load);
        let loads = Loads::compile(&linkage).unwrap();
        let all = checked(&linkage, &loads, &states());
        assert!(!fail(&all), "{load}:\n{}", show(&all));
        for (part, slip) in slips {
            let wrong = Loads::compile(&compressor(&load.replace(part, slip))).unwrap();
            assert!(fail(&checked(&linkage, &wrong, &states())), "{slip}");
        }
    }
}
