//! A force analyzer whose name stands first in the alphabet changes no result: methods are chosen by what they declare.

use assur_all as _;
use assur_analysis::results::Column;
use assur_analysis::{Calculation, Options, unwatched};
use assur_force::{AnalyzerPlugin, ForceAnalyzer, ForceError, Reactions, inventory};
use assur_group::Wrench;
use assur_kinematics::{Linkage, Position};
use assur_words::Text;

/// Gives numbers that nobody can take for a result.
#[derive(Debug)]
struct Wrong;

/// The balancing load that it gives.
const WRONG: f64 = 12_345.0;

impl ForceAnalyzer for Wrong {
    fn solve(
        &self,
        _linkage: &Linkage,
        _position: &Position,
        _loads: &mut [Wrench<f64>],
        out: &mut Reactions,
    ) -> Result<(), ForceError> {
        out.pairs.fill(Wrench { fx: WRONG, fy: WRONG, m: WRONG });
        out.balancing = WRONG;
        Ok(())
    }
}

const fn plugin(name: &'static str, gives_reactions: bool) -> AnalyzerPlugin {
    AnalyzerPlugin {
        name,
        crate_name: env!("CARGO_PKG_NAME"),
        summary: TEST,
        wording: TEST,
        source: TEST,
        instance: &Wrong,
        further: &[],
        gives_reactions,
        treats_friction: false,
        by_groups: gives_reactions,
        rank: u8::MAX,
    }
}

/// The words of an entry of a test.
const TEST: Text = Text::message("a test", Vec::new());

inventory::submit! { plugin("aaa", false) }
inventory::submit! { plugin("aab", true) }

/// A parallelogram, which is flat at 180 and 360 degrees: change points, where the balancing moment follows from the powers alone.
const SCENE: &str = r#"
gravity = 10
[ground]
points = { A = [0, 0], D = [0.5, 0] }
[link.crank]
points = { A = 0, B = 0.2 }
[link.coupler]
points = { B = 0, C = 0.5 }
mass = 4
center = "C"
[link.rocker]
points = { C = 0, D = 0.2 }
[assembly]
C = [0.5, 0.2]
[input]
link = "crank"
from = "90 deg"
positions = 4
"#;

#[test]
fn the_first_name_is_not_chosen() {
    let mechanism = assur_scene::read("scene.toml", SCENE).unwrap();
    let found = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
    assert_ne!(found.analyzer.unwrap().name, "aab");
    let positions = found.analyze(&mut unwatched).unwrap().positions;
    // The coupler goes round the circle of the crank: 4 kg * 10 m/s^2 * 0.2 m * cos q.
    for (row, wanted) in [0.0, -8.0, 0.0, 8.0].into_iter().enumerate() {
        let balancing = positions.get(row, Column::BALANCING).unwrap();
        assert!((balancing - wanted).abs() < 1e-9, "{row}: {balancing}");
    }
}
