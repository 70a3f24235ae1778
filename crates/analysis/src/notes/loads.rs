//! Loads that never act, and times that a prescribed motion does not have.

use assur_group::Order;
use assur_mechanism::{Motion, Over, Spring, Value, passage};
use assur_words::{Text, quantity, text};

use super::Listed;
use crate::Calculation;
use crate::results::{Column, Owner, Quantity, Table};

/// A transfer function below this, 1/rad or 1/m, is rounding: the link does not turn.
const STILL: f64 = 1e-12;

impl Calculation {
    /// Loads whose value is zero in every position, and moments on links that do not turn.
    pub(crate) fn idle_loads(&self, positions: &Table) -> Vec<Text> {
        let (schema, mechanism) = (positions.schema(), &self.linkage.mechanism);
        let all = |column: Column, test: fn(f64) -> bool| {
            let found = schema.find(column).filter(|column| positions.has(*column));
            found.is_some_and(|column| positions.each(column).flatten().all(test))
        };
        let mut notes = Vec::new();
        for owner in schema.owners(Quantity::Load) {
            if all(Column::of(Quantity::Load, owner), |value| value == 0.0) {
                notes.extend(schema.named(owner).map(|load| text!("analysis-load-idle", load = load)));
            }
        }
        for moment in mechanism.moments.iter().filter(|moment| moment.brake.is_none()) {
            let turns = Column::of(Quantity::Transfer(1), Owner::Link(moment.link));
            if all(turns, |pf1| pf1.abs() <= STILL) {
                let link = &mechanism.links[moment.link].name;
                notes.push(text!("analysis-moment-idle", load = &moment.name, link = link));
            }
        }
        notes
    }

    /// Positions that lie before time zero of a prescribed motion, or that it never reaches, where a load depends on time.
    pub(super) fn positions_out_of_time(&self) -> Vec<Text> {
        let mechanism = &self.linkage.mechanism;
        let Some(Motion::Prescribed { speed, acceleration }) = mechanism.motion else { return Vec::new() };
        let forces = mechanism.forces.iter().map(|force| &force.value);
        let moments = mechanism.moments.iter().map(|moment| &moment.value);
        let contacts = mechanism.contacts.iter().flat_map(|contact| [&contact.force, &contact.angle]);
        if !forces.chain(moments).chain(contacts).any(depends_on_time) {
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
        let pushing = mechanism.springs.iter().filter(|spring| spring.stiffness > 0.0 && spring.length > 0.0);
        let words = pushing.filter_map(|spring| {
            let found: Listed =
                (0..mechanism.input.positions).filter(|index| meets(spring, *index)).collect();
            (!found.is_empty()).then(|| {
                text!(
                    "analysis-spring-without-direction",
                    spring = &spring.name,
                    positions = found.words(),
                    length = quantity(spring.length, "m")
                )
            })
        });
        words.collect()
    }
}
