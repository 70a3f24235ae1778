//! The columns of the results as series with names: rates, reduction, reactions, loads, residuals.

use assur_analysis::results::{Column, Owner, Part, Quantity, Schema, Table};
use assur_book::Course;
use assur_mechanism::{GROUND, LinkId, PairId};
use assur_words::{Text, joined, name, number, text};

use super::series::Series;

/// A force this small compared with the greatest one of the mechanism counts as zero.
const ROUNDING: f64 = 1e-13;

/// First and second derivative by time.
pub(super) const RATES: [Quantity; 2] = [Quantity::Velocity, Quantity::Acceleration];

/// The force that a pair exerts on one link, as indices of series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Reaction {
    /// The pin or slide; empty for the balancing load.
    pub(crate) pair: String,
    /// The link on which it acts.
    pub(crate) link: String,
    /// `A on crank`, `balancing load`.
    pub(crate) name: Text,
    /// Fx, Fy, modulus; for the balancing load its one series.
    pub(crate) series: Vec<usize>,
    /// Moment of a slide.
    pub(crate) moment: Option<usize>,
}

impl Reaction {
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
    pub(super) fn add(&mut self, [of, head]: [Text; 2], kind: Text, column: Column) -> Option<usize> {
        let course = Course::of(self.table, Some(self.ending), Column::COORDINATE, column);
        if course.is_empty() {
            return None;
        }
        let (short, unit) = (head.to_string(), self.table.schema().unit(column));
        self.series.push(Series { column, of, head, short, kind, unit, factor: 1.0, course, floor: 0.0 });
        Some(self.series.len() - 1)
    }

    /// Adds both projections of a vector and its modulus; a letter follows the names.
    fn add_vector(&mut self, names: [Text; 2], kind: &Text, vector: Column) -> Vec<usize> {
        let names = |letter| names.each_ref().map(|text| joined("", [text.clone(), name(letter)]));
        let x = self.add(names("x"), kind.clone(), vector.part(Part::X));
        let y = self.add(names("y"), kind.clone(), vector.part(Part::Y));
        let modulus = self.add(names(""), kind.clone(), vector.part(Part::Modulus));
        [x, y, modulus].into_iter().flatten().collect()
    }

    /// Speed and acceleration of the input, reduced inertia and moment.
    pub(super) fn motion(&mut self) -> Vec<usize> {
        let all = [
            ("series-input-speed", "w", Quantity::Velocity),
            ("series-input-acceleration", "e", Quantity::Acceleration),
            ("series-reduced-inertia", "J", Quantity::ReducedInertia),
            ("series-reduced-inertia-derivative", "J'", Quantity::ReducedInertiaDerivative),
            ("series-reduced-moment", "Q", Quantity::ReducedMoment),
        ];
        let add = |(of, letter, quantity): (&'static str, &'static str, Quantity)| {
            self.add([text!(of), name(letter)], Text::default(), Column::of(quantity, Owner::Input))
        };
        all.into_iter().filter_map(add).collect()
    }

    /// Velocities and accelerations of points, links and slides.
    pub(super) fn rates(&mut self) {
        let schema = self.table.schema();
        for (order, quantity) in RATES.into_iter().enumerate() {
            let ([linear, angular], kind) =
                ([["v", "w"], ["a", "e"]][order], ["series-velocity", "series-acceleration"][order]);
            for owner in schema.owners(quantity) {
                let (own, column) = (name(schema.name(owner).into_owned()), Column::of(quantity, owner));
                let named = |of: Text, letter| {
                    [joined(" ", [of, name(letter)]), joined(".", [own.clone(), name(letter)])]
                };
                match owner {
                    Owner::Point(_) => {
                        let names = named(text!("series-point", point = &own), linear);
                        drop(self.add_vector(names, &text!(kind), column));
                    }
                    Owner::Link(_) => {
                        drop(self.add(
                            named(text!("series-link", link = &own), angular),
                            text!(kind),
                            column,
                        ));
                    }
                    Owner::Slide(_) => {
                        drop(self.add(
                            named(text!("series-slide", slide = &own), linear),
                            text!(kind),
                            column,
                        ));
                    }
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
            let told = text!("series-reaction", pair = name(pair.clone()), link = name(link.clone()));
            let named =
                |what| [joined(" ", [told.clone(), name(what)]), name(format!("{pair}>{link}.{what}"))];
            let force = Column::of(Quantity::Force, Owner::PairOn(id, on));
            let series = self.add_vector(named("F"), &text!("series-force"), force);
            let moment = Column::of(Quantity::Moment, Owner::Pair(id));
            let moment = self.add(named("M"), text!("series-moment"), moment);
            if series.len() == 3 {
                found.push(Reaction { pair, link, name: told, series, moment });
            }
        }
        self.mark_rounding(&found);
        let names = [text!("series-balancing"), text!("series-balancing-short")];
        if let Some(index) = self.add(names, Text::default(), Column::BALANCING) {
            let (pair, link) = (String::new(), String::new());
            found.push(Reaction {
                pair,
                link,
                name: text!("series-balancing"),
                series: vec![index],
                moment: None,
            });
        }
        found
    }

    /// Loads, inertia loads, what shakes the ground, and how well each group is conditioned.
    pub(super) fn others(&mut self) {
        let schema = self.table.schema();
        for (quantity, letter) in [
            (Quantity::Load, ""),
            (Quantity::InertiaForce, "F"),
            (Quantity::InertiaMoment, "M"),
            (Quantity::ShakingForce, "F"),
            (Quantity::ShakingMoment, "M"),
            (Quantity::Condition, ""),
        ] {
            for owner in schema.owners(quantity) {
                let own = name(schema.name(owner).into_owned());
                let of = match (quantity, owner) {
                    (Quantity::Load, _) => text!("series-load", load = own),
                    (Quantity::InertiaForce | Quantity::InertiaMoment, _) => {
                        text!("series-inertia", link = own)
                    }
                    // Results count groups from 0, readers from 1.
                    (_, Owner::Group(group)) => text!("series-condition", group = number(group + 1)),
                    _ => text!("series-shaking"),
                };
                let of = joined(
                    " ",
                    std::iter::once(of).chain([name(letter)].into_iter().filter(|_| !letter.is_empty())),
                );
                let (names, column) = ([of.clone(), of], Column::of(quantity, owner));
                match quantity {
                    Quantity::InertiaForce | Quantity::ShakingForce => {
                        drop(self.add_vector(names, &Text::default(), column));
                    }
                    _ => drop(self.add(names, Text::default(), column)),
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
