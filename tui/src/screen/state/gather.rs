//! The columns of the results as series with names: rates, reduction, reactions, loads, residuals.

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema, Table};
use assur_book::Course;
use assur_mechanism::{GROUND, LinkId, PairId};

use super::series::Series;

/// A force this small compared with the greatest one of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// First and second derivative by time.
pub(super) const RATES: [Quantity; 2] = [Quantity::Velocity, Quantity::Acceleration];

/// Name of the load on the input that keeps the motion.
const BALANCING: &str = "balancing load";

/// The force that a pair exerts on one link, as indices of series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Reaction {
    /// The pin or slide; empty for the balancing load.
    pub(crate) pair: String,
    /// The link on which it acts.
    pub(crate) link: String,
    /// Fx, Fy, modulus; for the balancing load its one series.
    pub(crate) series: Vec<usize>,
    /// Moment of a slide.
    pub(crate) moment: Option<usize>,
}

impl Reaction {
    /// `A on crank`, `balancing load`.
    pub(crate) fn name(&self) -> String {
        if self.pair.is_empty() { BALANCING.to_owned() } else { format!("{} on {}", self.pair, self.link) }
    }

    /// Whether it is the force of the same pair on the same link.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.pair == other.pair && self.link == other.link
    }
}

/// Series that are being collected from the positions of an analysis.
pub(super) struct Gather<'a> {
    pub(super) table: &'a Table,
    /// The end of the cycle.
    pub(super) ending: &'a Table,
    pub(super) series: Vec<Series>,
}

impl Gather<'_> {
    /// Adds a column as a series if any position has it, and returns its index.
    pub(super) fn add(&mut self, names: [String; 2], kind: &'static str, column: Column) -> Option<usize> {
        let course = Course::of(self.table, Some(self.ending), Column::COORDINATE, column);
        if course.is_empty() {
            return None;
        }
        let ([of, short], unit) = (names, self.table.schema().unit(column));
        self.series.push(Series { column, of, short, kind, unit, factor: 1.0, course, floor: 0.0 });
        Some(self.series.len() - 1)
    }

    /// Adds both projections of a vector and its modulus; a letter follows the names.
    fn add_vector(&mut self, [of, short]: [String; 2], kind: &'static str, vector: Column) -> Vec<usize> {
        let names = |letter: &str| [&of, &short].map(|name| format!("{name}{letter}"));
        let x = self.add(names("x"), kind, vector.part(Part::X));
        let y = self.add(names("y"), kind, vector.part(Part::Y));
        let modulus = self.add(names(""), kind, vector.part(Part::Modulus));
        [x, y, modulus].into_iter().flatten().collect()
    }

    /// Speed and acceleration of the input, reduced inertia and moment.
    pub(super) fn motion(&mut self) -> Vec<usize> {
        let all = [
            ("input speed", "w", Quantity::Velocity),
            ("input acceleration", "e", Quantity::Acceleration),
            ("reduced inertia J", "J", Quantity::ReducedInertia),
            ("derivative J'", "J'", Quantity::ReducedInertiaDerivative),
            ("reduced moment Q", "Q", Quantity::ReducedMoment),
        ];
        let add = |(of, short, quantity): (&str, &str, Quantity)| {
            self.add([of, short].map(str::to_owned), "", Column::of(quantity, Owner::Input))
        };
        all.into_iter().filter_map(add).collect()
    }

    /// Velocities and accelerations of points, links and slides.
    pub(super) fn rates(&mut self) {
        let schema = self.table.schema();
        for (order, quantity) in RATES.into_iter().enumerate() {
            let ([linear, angular], kind) =
                ([["v", "w"], ["a", "e"]][order], ["velocity", "acceleration"][order]);
            for owner in schema.owners(quantity) {
                let (name, column) = (schema.name(owner), Column::of(quantity, owner));
                let names =
                    |of: &str, letter: &str| [format!("{of} {name} {letter}"), format!("{name}.{letter}")];
                match owner {
                    Owner::Point(_) => drop(self.add_vector(names("point", linear), kind, column)),
                    Owner::Link(_) => drop(self.add(names("link", angular), kind, column)),
                    Owner::Slide(_) => drop(self.add(names("slide", linear), kind, column)),
                    _ => {}
                }
            }
        }
    }

    /// Force and moment of every pair, then the balancing load.
    pub(super) fn reactions(&mut self) -> Vec<Reaction> {
        let schema = self.table.schema();
        let mut found = Vec::new();
        for (id, on) in pairs(schema) {
            let (pair, link) = (schema.name(Owner::Pair(id)).into_owned(), schema.link(on).to_owned());
            let names = |what: &str| [format!("{pair} on {link} {what}"), format!("{pair}>{link}.{what}")];
            let force = Column::of(Quantity::Force, Owner::PairOn(id, on));
            let series = self.add_vector(names("F"), "force", force);
            let moment = self.add(names("M"), "moment", Column::of(Quantity::Moment, Owner::Pair(id)));
            if series.len() == 3 {
                found.push(Reaction { pair, link, series, moment });
            }
        }
        self.mark_rounding(&found);
        let names = [BALANCING, "balancing"].map(str::to_owned);
        if let Some(index) = self.add(names, "", Column::BALANCING) {
            let (pair, link) = (String::new(), String::new());
            found.push(Reaction { pair, link, series: vec![index], moment: None });
        }
        found
    }

    /// Loads, inertia loads, what shakes the ground, and how well each group is conditioned.
    pub(super) fn others(&mut self) {
        let schema = self.table.schema();
        for (quantity, before, after) in [
            (Quantity::Load, "load ", ""),
            (Quantity::InertiaForce, "", " inertia F"),
            (Quantity::InertiaMoment, "", " inertia M"),
            (Quantity::ShakingForce, "", "shaking F"),
            (Quantity::ShakingMoment, "", "shaking M"),
            (Quantity::Condition, "condition of group ", ""),
        ] {
            for owner in schema.owners(quantity) {
                // Results count groups from 0, readers from 1.
                let name = match owner {
                    Owner::Group(group) => (group + 1).to_string(),
                    _ => schema.name(owner).into_owned(),
                };
                let of = format!("{before}{name}{after}");
                let names = [of.clone(), of];
                let column = Column::of(quantity, owner);
                match quantity {
                    Quantity::InertiaForce | Quantity::ShakingForce => {
                        drop(self.add_vector(names, "", column));
                    }
                    _ => drop(self.add(names, "", column)),
                }
            }
        }
    }

    /// Sets the limit below which forces of the pairs count as zero.
    fn mark_rounding(&mut self, reactions: &[Reaction]) {
        let forces = || reactions.iter().flat_map(|reaction| &reaction.series).copied();
        let floor = ROUNDING * forces().map(|index| self.series[index].course.size()).fold(0.0, f64::max);
        forces().for_each(|index| self.series[index].floor = floor);
    }
}

/// Pairs and links: of a pair of two links one, because the other force is opposite; of a multiple joint all.
fn pairs(schema: &Schema) -> Vec<(PairId, LinkId)> {
    let all: Vec<(PairId, LinkId)> = schema
        .owners(Quantity::Force)
        .into_iter()
        .filter_map(|owner| if let Owner::PairOn(pair, link) = owner { Some((pair, link)) } else { None })
        .collect();
    let of_pair = |ends: &[(PairId, LinkId)]| {
        let count = if ends.len() > 2 { usize::MAX } else { 1 };
        // The force on a moving link is more informative than the one on the ground.
        ends.iter().filter(|(_, link)| *link != GROUND).take(count).copied().collect::<Vec<_>>()
    };
    all.chunk_by(|a, b| a.0 == b.0).flat_map(of_pair).collect()
}
