//! Springs without a direction, and times that a prescribed motion does not have.

use assur_group::Order;
use assur_mechanism::{Motion, Over, Spring, Value, passage};
use assur_words::{Text, quantity, text};

use super::Listed;
use crate::Calculation;

impl Calculation {
    /// Positions that lie before time zero of a prescribed motion, or that it never reaches, where a load depends on time.
    pub(super) fn positions_out_of_time(&self) -> Vec<Text> {
        let mechanism = &self.linkage.mechanism;
        let Some(Motion::Prescribed { speed, acceleration }) = mechanism.motion else { return Vec::new() };
        if !mechanism.loads.iter().flat_map(|load| load.kind.laws()).any(depends_on_time) {
            return Vec::new();
        }
        let input = &mechanism.input;
        let (mut before, mut never) = (0, 0);
        for index in 0..input.positions {
            match passage(input.coordinate(index) - input.from, speed, acceleration) {
                Some(time) => before += usize::from(time < 0.0),
                None => never += 1,
            }
        }
        let mut notes = Vec::new();
        if before > 0 {
            notes.push(text!("analysis-before-time-zero", count = before));
        }
        if never > 0 {
            notes.push(text!("analysis-never-reached", count = never));
        }
        notes
    }
}

fn depends_on_time(value: &Value) -> bool {
    match value {
        Value::Table { over: Over::Time, .. } => true,
        Value::Formula { formula, .. } => formula.used().time,
        _ => false,
    }
}

impl Calculation {
    /// Springs whose ends meet in positions of the scene: there they have no direction and give no force, even with a
    /// free length.
    pub(super) fn springs_without_direction(&self) -> Vec<Text> {
        /// Ends nearer to each other than this part of the scale of the mechanism meet.
        const NEAR: f64 = 1e-12;
        let (linkage, mechanism) = (&self.linkage, &self.linkage.mechanism);
        let mut position = linkage.position();
        let mut meets = |spring: &Spring, index: usize| {
            if linkage.solve_index(index, Order::Place, &mut position).is_err() {
                return false;
            }
            let [a, b] = spring.ends.map(|end| position.bodies[end.link].point(end.at));
            (b[0] - a[0]).hypot(b[1] - a[1]) <= NEAR * linkage.structure.scale
        };
        let words = mechanism.loads.iter().filter_map(|load| {
            let spring = load.kind.spring().filter(|spring| spring.stiffness > 0.0 && spring.length > 0.0)?;
            let found: Listed =
                (0..mechanism.input.positions).filter(|index| meets(spring, *index)).collect();
            (!found.is_empty()).then(|| {
                text!(
                    "analysis-spring-without-direction",
                    spring = &load.name,
                    positions = found.words(),
                    length = quantity(spring.length, "m")
                )
            })
        });
        words.collect()
    }
}
