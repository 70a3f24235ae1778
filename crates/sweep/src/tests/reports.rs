//! Every measure against a report of the same scene: over all shipped scenes, each number in two ways.

use std::collections::{BTreeMap, BTreeSet};

use assur_analysis::results::{Analysis, Column, Edges, Owner, Part, Quantity, Table};
use assur_analysis::{Calculation, Options, unwatched};
use assur_book::catalogue::unit;
use assur_book::{Course, Range, Unit, range, range_of};
use assur_geometry::{geometry, overview};
use assur_mechanism::{GROUND, Motion, PairId};
use assur_report::csv::CsvCell;

use super::between::scenes;
use super::{requested, rows};
use crate::measure::COLUMNS;
use crate::{MEASURES, Measure, SweepRequest, Target};

/// A report of a scene, with what it says of each column of a sweep, by the name of the column.
struct Report {
    calculation: Calculation,
    analysis: Analysis,
    edges: Edges,
    known: BTreeMap<String, f64>,
}

impl Report {
    /// `dense`: also of what is searched by itself for each of very many columns.
    fn of(scene: &str, dense: bool) -> Self {
        let mechanism = assur_scene::read("a.toml", scene).unwrap();
        let calculation = Calculation::of(mechanism, &Options::default(), &mut unwatched).unwrap();
        let analysis = calculation.analyze(&mut unwatched).unwrap();
        let edges = calculation.edges(&analysis.positions);
        let mut report = Self { calculation, analysis, edges, known: BTreeMap::new() };
        if dense {
            report.places();
            report.forces();
        }
        report.distances();
        report.motions();
        report.strokes();
        report.groups();
        report.shaking();
        report.regime();
        report.end();
        report.friction();
        report
    }

    fn table(&self) -> &Table {
        &self.analysis.positions
    }

    /// The unit of a column; of the coordinate without one.
    fn unit(&self, column: Column) -> Unit {
        unit(self.table().schema(), column)
    }

    fn put(&mut self, name: String, unit: Unit, value: Option<f64>) {
        self.known.extend(value.filter(|value| value.is_finite()).map(|value| (unit.column(name), value)));
    }

    /// What a column reaches over the positions and between them.
    fn range(&self, column: Column) -> Option<Range> {
        let course = Course::of(self.table(), Some(&self.edges), Column::COORDINATE, column);
        range(&self.calculation, &course, column)
    }

    fn range_of(&self, read: &dyn Fn(&Table, usize) -> Option<f64>) -> Option<Range> {
        let course = Course::read(self.table(), Some(&self.edges), Column::COORDINATE, read);
        range_of(&self.calculation, &course, read)
    }

    /// Points, slides and links with their names.
    fn parts(&self) -> Vec<(Owner, String)> {
        let schema = self.table().schema();
        let owners = schema.owners(Quantity::Transfer(0)).into_iter();
        let owners = owners.filter(|owner| *owner != Owner::Input);
        owners.map(|owner| (owner, schema.name(owner).into_owned())).collect()
    }

    fn places(&mut self) {
        for (owner, name) in self.parts() {
            let place = Column::of(Quantity::Transfer(0), owner);
            let columns = match owner {
                Owner::Point(_) => {
                    let [x, y] = Column::vector(Quantity::Transfer(0), owner);
                    vec![("x_", x), ("y_", y)]
                }
                Owner::Link(_) => vec![("angle_", place)],
                _ => vec![("", place)],
            };
            for (word, column) in columns {
                let (unit, Some(found)) = (self.unit(column), self.range(column)) else { continue };
                let [least, greatest] = [found.least.value, found.greatest.value];
                self.put(format!("{name}_{word}min"), unit, Some(least));
                self.put(format!("{name}_{word}max"), unit, Some(greatest));
                if matches!(owner, Owner::Slide(_)) {
                    self.put(format!("{name}_travel"), unit, Some(greatest - least));
                }
            }
        }
    }

    /// From the origin.
    fn distances(&mut self) {
        let points = self.parts().into_iter();
        let Some((owner, name)) = points.into_iter().find(|(owner, _)| matches!(owner, Owner::Point(_)))
        else {
            return;
        };
        let [x, y] = Column::vector(Quantity::Transfer(0), owner);
        let away = self.range_of(&|table, row| Some(table.get(row, x)?.hypot(table.get(row, y)?)));
        let of = |turn: fn(Range) -> f64| away.map(turn);
        self.put(format!("{name}_distance_1_least"), Unit::LENGTH, of(|range| range.least.value));
        self.put(format!("{name}_distance_1_greatest"), Unit::LENGTH, of(|range| range.greatest.value));
    }

    fn motions(&mut self) {
        let steady =
            |motion: &Option<Motion>| matches!(motion, Some(Motion::Prescribed { acceleration: 0.0, .. }));
        let of_time = steady(&self.calculation.linkage.mechanism.motion);
        let all = [
            (Quantity::Transfer(1), "pf1", true),
            (Quantity::Transfer(2), "pf2", true),
            (Quantity::Velocity, "speed", of_time),
            (Quantity::Acceleration, "acceleration", of_time),
        ];
        // Two parts of each kind tell.
        let parts = self.parts();
        let kind = |of: &Owner| std::mem::discriminant(of);
        let before =
            |index: usize| parts[..index].iter().filter(|(of, _)| kind(of) == kind(&parts[index].0)).count();
        let few: Vec<_> =
            (0..parts.len()).filter(|index| before(*index) < 2).map(|index| parts[index].clone()).collect();
        for ((owner, name), (quantity, word, _)) in few
            .into_iter()
            .flat_map(|part| all.into_iter().map(move |of| (part.clone(), of)))
            .filter(|(_, (.., is_there))| *is_there)
        {
            let whole = Column::of(quantity, owner);
            let column = if matches!(owner, Owner::Point(_)) { whole.part(Part::Modulus) } else { whole };
            let found = self.range(column).map(|of| of.greatest.value.abs().max(of.least.value.abs()));
            self.put(format!("{name}_{word}_greatest"), self.unit(whole), found);
        }
    }

    fn strokes(&mut self) {
        let Ok(found) = geometry(&self.calculation.linkage, GROUND) else { return };
        let slides = found.slides.iter().map(|(of, course)| (of.name.to_string(), Unit::LENGTH, course));
        let links = found.links.iter().map(|(of, course)| (of.name.to_string(), Unit::ANGLE, course));
        for (name, unit, course) in slides.chain(links) {
            let ratio = course.stroke.as_ref().and_then(|stroke| stroke.time_ratio);
            self.put(format!("{name}_stroke"), unit, course.pf0.map(|pf0| pf0.max - pf0.min));
            self.put(format!("{name}_time_ratio"), Unit::NONE, ratio);
        }
    }

    fn groups(&mut self) {
        let owners = self.table().schema().owners(Quantity::Condition);
        let conditions: Vec<_> =
            owners.into_iter().map(|group| Column::of(Quantity::Condition, group)).collect();
        let least = self.range_of(&|table, row| {
            conditions.iter().map(|of| table.get(row, *of).map_or(0.0, |of| 1.0 / of)).reduce(f64::min)
        });
        self.put("smallest_health".to_owned(), Unit::NONE, least.map(|range| range.least.value));
        let angle = overview(&self.calculation.linkage).ok().and_then(|found| found.transmission);
        self.put("least_transmission_angle".to_owned(), Unit::ANGLE, angle.map(|(_, angle, _)| angle));
    }

    fn forces(&mut self) {
        let unit = self.unit(Column::BALANCING);
        let balancing = self.range(Column::BALANCING);
        let size = self.range_of(&|table, row| table.get(row, Column::BALANCING).map(f64::abs));
        self.put("balancing_greatest".to_owned(), unit, size.map(|range| range.greatest.value));
        self.put("balancing_mean".to_owned(), unit, balancing.and_then(|range| Some(range.means?.mean)));
        self.put("balancing_mean_modulus".to_owned(), unit, size.and_then(|range| Some(range.means?.mean)));
        self.put("balancing_rms".to_owned(), unit, balancing.and_then(|range| Some(range.means?.rms)));
        let mut pairs: BTreeMap<String, (PairId, Vec<Column>)> = BTreeMap::new();
        for owner in self.table().schema().owners(Quantity::Force) {
            let Owner::PairOn(pair, _) = owner else { continue };
            let name = self.table().schema().name(Owner::Pair(pair)).into_owned();
            let force = Column::of(Quantity::Force, owner).part(Part::Modulus);
            pairs.entry(name).or_insert((pair, Vec::new())).1.push(force);
        }
        for (name, (pair, forces)) in pairs {
            let found = self
                .range_of(&|table, row| forces.iter().filter_map(|of| table.get(row, *of)).reduce(f64::max));
            self.put(
                format!("reaction_{name}_greatest"),
                Unit::FORCE,
                found.map(|range| range.greatest.value),
            );
            self.put(
                format!("reaction_{name}_rms"),
                Unit::FORCE,
                found.and_then(|range| Some(range.means?.rms)),
            );
            let moment = Column::of(Quantity::Moment, Owner::Pair(pair));
            let found = self.range_of(&|table, row| table.get(row, moment).map(f64::abs));
            self.put(
                format!("reaction_{name}_moment_greatest"),
                Unit::MOMENT,
                found.map(|range| range.greatest.value),
            );
            self.put(
                format!("reaction_{name}_moment_rms"),
                Unit::MOMENT,
                found.and_then(|range| Some(range.means?.rms)),
            );
        }
    }

    fn shaking(&mut self) {
        let force = Column::of(Quantity::ShakingForce, Owner::Input).part(Part::Modulus);
        let moment = Column::of(Quantity::ShakingMoment, Owner::Input);
        let (force, moment) = (self.range(force), self.range(moment));
        self.put("shaking_force_greatest".to_owned(), Unit::FORCE, force.map(|range| range.greatest.value));
        self.put("shaking_force_rms".to_owned(), Unit::FORCE, force.and_then(|range| Some(range.means?.rms)));
        let greatest = moment.map(|range| range.greatest.value.abs().max(range.least.value.abs()));
        self.put("shaking_moment_greatest".to_owned(), Unit::MOMENT, greatest);
    }

    fn regime(&mut self) {
        let Some(found) = self.analysis.dynamics.clone() else { return };
        let [speed, moment] =
            [Quantity::Velocity, Quantity::Balancing].map(|of| self.unit(Column::of(of, Owner::Input)));
        let figures = &found.figures;
        for (name, unit, value) in [
            ("flywheel", Unit::INERTIA, found.flywheel),
            ("ratio", Unit::NONE, figures.ratio),
            ("torque", moment, figures.torque),
            ("mean_speed", speed, Some(figures.mean_speed)),
            ("unevenness", Unit::NONE, Some(figures.unevenness)),
            ("speed_min", speed, Some(figures.speed_min)),
            ("speed_max", speed, Some(figures.speed_max)),
            ("excess_work", Unit::JOULE, Some(figures.excess_work)),
            ("required_power", Unit::POWER, Some(figures.required_power)),
        ] {
            self.put(name.to_owned(), unit, value);
        }
    }

    fn end(&mut self) {
        if !matches!(self.calculation.linkage.mechanism.motion, Some(Motion::Transient { .. })) {
            return;
        }
        let trajectory = self.analysis.trajectory.clone();
        let Some(last) = trajectory.len().checked_sub(1) else { return };
        let [time, speed] = [Quantity::Time, Quantity::Velocity].map(|of| Column::of(of, Owner::Input));
        for (name, column) in
            [("end_time", time), ("end_coordinate", Column::COORDINATE), ("end_speed", speed)]
        {
            let unit = unit(trajectory.schema(), column);
            self.put(name.to_owned(), unit, trajectory.get(last, column));
        }
    }

    fn friction(&mut self) {
        let Some(found) = self.analysis.friction.clone() else { return };
        let unit = self.unit(Column::COORDINATE);
        let length = |parts: &[[f64; 2]]| parts.iter().map(|[from, to]| to - from).sum();
        let work = found.friction_work.values().copied().sum();
        self.put("efficiency".to_owned(), Unit::NONE, found.efficiency);
        self.put("friction_work".to_owned(), Unit::JOULE, work);
        self.put("friction_margin".to_owned(), Unit::NONE, Some(1.0 - found.certificate));
        self.put("self_braking".to_owned(), unit, Some(length(&found.self_braking)));
        self.put("dead_angles".to_owned(), unit, Some(length(&found.dead_angles)));
    }
}

/// The measure that has a column of this name.
fn measure_of(head: &str) -> Option<&'static str> {
    let ends = |word: &str| {
        let at = head.rfind(word)?;
        let after = &head[at + word.len()..];
        (after.is_empty() || after.starts_with('_')).then_some(word.len())
    };
    let of_pair = |measure: &str| measure.starts_with("reaction") == head.starts_with("reaction_");
    let fits = COLUMNS.iter().filter(|column| of_pair(column.measure));
    let fits = fits.filter_map(|column| Some((ends(column.word)?, column.measure)));
    fits.max_by_key(|(length, _)| *length).map(|(_, measure)| measure)
}

/// Measures of which a mechanism has very many columns between positions, each of which is searched by itself: in small ones they tell.
const DENSE: [&str; 5] = ["balancing", "balancing-rms", "reactions", "reaction-rms", "extremes"];
/// Below this part of the greatest number of its measure a number may be zero but for rounding, which grows near change points.
const NEAR_ZERO: f64 = 0.1;
/// Most links of a small mechanism, with the ground.
const SMALL: usize = 4;

#[test]
fn every_measure_is_that_of_a_report() {
    let mut compared: BTreeMap<&str, usize> = BTreeMap::new();
    let mut wrong = Vec::new();
    // Forty four-bars have a thousand columns, each of which is searched by itself; two of them have the same kinds.
    for (name, scene, positions) in scenes().filter(|(name, ..)| *name != "n-four-bar-40") {
        let dense = assur_scene::read(name, scene).unwrap().links.len() <= SMALL;
        let report = Report::of(scene, dense);
        let point = report.parts().into_iter().find(|(owner, _)| matches!(owner, Owner::Point(_)));
        let targets =
            point.iter().filter_map(|(_, name)| Target::parse(&format!("{name}=0,0")).ok()).collect();
        let names = MEASURES.iter().map(|measure| measure.name).filter(|name| dense || !DENSE.contains(name));
        let measures = Measure::named(&names.collect::<Vec<_>>()).unwrap();
        let request = SweepRequest { measures, targets, between: true, ..SweepRequest::default() };
        let vary = format!("input.positions={positions}..{positions}:1");
        let table = rows(&requested(scene, &[&vary], request).unwrap(), 1);
        let size = |measure: &str| {
            let of = report.known.iter().filter(|(head, _)| measure_of(head) == Some(measure));
            of.fold(0.0_f64, |most, (_, value)| most.max(value.abs()))
        };
        let sizes: BTreeMap<_, _> = MEASURES.iter().map(|of| (of.name, size(of.name))).collect();
        for (column, head) in table.columns.names.iter().enumerate() {
            let (CsvCell::Number(found), Some(known)) = (table.cell(0, column), report.known.get(head))
            else {
                continue;
            };
            let measure = measure_of(head).unwrap_or_else(|| panic!("no measure has {head}"));
            // The mean square of the shaking force is a sum over places: a regime jumps between them.
            let part = if measure == "shaking" { 1e-6 } else { 1e-9 };
            if (found - known).abs() > part * known.abs().max(NEAR_ZERO * sizes[measure]) {
                wrong.push(format!("{name}: {head} is {found}, {known} in a report"));
            }
            *compared.entry(measure).or_default() += 1;
        }
    }
    assert!(wrong.is_empty(), "{} of {compared:?}:\n{}", wrong.len(), wrong.join("\n"));
    let all: BTreeSet<_> = MEASURES.iter().map(|measure| measure.name).collect();
    assert_eq!(compared.keys().copied().collect::<BTreeSet<_>>(), all, "{compared:?}");
}
