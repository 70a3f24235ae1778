//! The measures by their names, and their columns: what each is of, what it is called, its unit, and what finds its number.

use assur_analysis::results::Quantity;
use assur_book::{Unit, catalogue::KEYS};
use assur_words::{Describe, Text, list, name as words, text};

use crate::{SweepError, measured::Measured};

/// A family of columns.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// Its name on the command line; of columns of the positions their key in the JSON.
    pub name: &'static str,
    /// The identity of what its columns hold.
    summary: &'static str,
    /// Whether it is written where no measures are named.
    pub by_default: bool,
    /// Whether it is requested by name: all its columns are written then, even those that no parameter can change.
    pub(crate) whole: bool,
    /// Whether it has all columns of the positions under its key as they are.
    pub(crate) is_plain: bool,
}

/// A column of a measure.
#[derive(Debug)]
pub(crate) struct MeasureColumn {
    /// The name of the measure.
    pub(crate) measure: &'static str,
    pub(crate) of: Of,
    /// The end of its name before the unit.
    pub(crate) word: &'static str,
    pub(crate) unit: In,
    pub(crate) find: Find,
}

/// The kind of thing that owns a column. Successive columns of one kind are written owner by owner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    /// A periodic regime.
    Regime,
    /// A periodic regime whose flywheel is sought.
    Flywheel,
    /// A periodic regime with a motor.
    Motor,
    /// A periodic regime with a driving torque that is constant or balances the loads.
    Torque,
    /// The end of a transient motion.
    End,
    /// Dry friction over the cycle.
    Friction,
    /// The shaking force between positions.
    Shaking,
    /// Distances from the places that are given, between positions.
    Targets,
    /// The least of all groups.
    Health,
    Transmission,
    /// The balancing load, and its magnitude.
    Balancing,
    BalancingSize,
    /// Forces of pins and slides, and moments of slides.
    Reactions,
    /// Coordinates of points, displacements of slides, angles of links.
    Points,
    Slides,
    Links,
    /// The motion between positions: of slides and links; of points too.
    Moving,
    Parts,
}

/// The unit of a column.
#[derive(Debug, Clone, Copy)]
pub(crate) enum In {
    /// This one.
    Unit(Unit),
    /// That of the coordinate of the input.
    Coordinate,
    /// That of what is gathered or moves.
    Own,
    /// That of a quantity of its owner.
    Quantity(Quantity),
}

/// How a number of a point is found, by the number of what it belongs to: a statistic, a part, a place.
pub(crate) type Find = fn(&Measured, usize) -> Option<f64>;

const LEAST: Find = |found, number| Some(found.least(number)?[0]);
const LEAST_AT: Find = |found, number| Some(found.least(number)?[1]);
const GREATEST: Find = |found, number| Some(found.greatest(number)?[0]);
const GREATEST_AT: Find = |found, number| Some(found.greatest(number)?[1]);
const MEAN: Find = |found, number| found.means(number)[0];
const RMS: Find = |found, number| found.means(number)[1];
/// The greatest magnitudes of both derivatives of a point, slide or link with respect to the coordinate.
const FIRST: Find = |found, nth| Some(found.courses.get(nth)?.pf1.size());
const SECOND: Find = |found, nth| Some(found.courses.get(nth)?.pf2.size());

/// The statistics of a column of the positions as it is, by the word before the unit.
pub(crate) const PLAIN: [(&str, Find); 4] = [("min", LEAST), ("max", GREATEST), ("mean", MEAN), ("rms", RMS)];

/// The length of all parts of the cycle together.
fn total(parts: &[[f64; 2]]) -> f64 {
    parts.iter().fold(0.0, |sum, [from, to]| sum + (to - from))
}

/// Makes the list of columns: measure, what the column is of, the end of its name, unit, number.
macro_rules! columns {
    ($($measure:literal $of:ident $word:literal $unit:expr, $find:expr;)+) => {
        /// The columns of all measures, in their order.
        pub(crate) const COLUMNS: &[MeasureColumn] =
            &[$(MeasureColumn { measure: $measure, of: Of::$of, word: $word, unit: $unit, find: $find }),+];
    };
}

const NONE: In = In::Unit(Unit::NONE);
const FORCE: In = In::Unit(Unit::FORCE);
const SPEED: In = In::Quantity(Quantity::Velocity);

columns! {
    "health" Health "smallest_health" NONE, LEAST;
    "health" Health "smallest_health_at" In::Coordinate, LEAST_AT;
    "transmission" Transmission "least_transmission_angle" In::Unit(Unit::ANGLE), LEAST;
    "transmission" Transmission "least_transmission_angle_at" In::Coordinate, LEAST_AT;
    "balancing" BalancingSize "balancing_greatest" In::Own, GREATEST;
    "balancing" BalancingSize "balancing_greatest_at" In::Coordinate, GREATEST_AT;
    "balancing" Balancing "balancing_mean" In::Own, MEAN;
    "balancing" BalancingSize "balancing_mean_modulus" In::Own, MEAN;
    "balancing-rms" Balancing "balancing_rms" In::Own, RMS;
    "reactions" Reactions "greatest" In::Own, GREATEST;
    "reaction-rms" Reactions "rms" In::Own, RMS;
    "extremes" Points "min" In::Own, LEAST;
    "extremes" Points "max" In::Own, GREATEST;
    "extremes" Slides "min" In::Own, LEAST;
    "extremes" Slides "max" In::Own, GREATEST;
    "extremes" Slides "travel" In::Own, |found, number| Some(GREATEST(found, number)? - LEAST(found, number)?);
    "extremes" Links "min" In::Own, LEAST;
    "extremes" Links "max" In::Own, GREATEST;
    "distance" Targets "least" In::Unit(Unit::LENGTH), |found, nth| Some(found.distances.get(nth)?.min);
    "distance" Targets "least_at" In::Coordinate, |found, nth| Some(found.distances.get(nth)?.at_min);
    "distance" Targets "greatest" In::Unit(Unit::LENGTH), |found, nth| Some(found.distances.get(nth)?.max);
    "distance" Targets "greatest_at" In::Coordinate, |found, nth| Some(found.distances.get(nth)?.at_max);
    "stroke" Moving "stroke" In::Own, |found, nth| Some(found.courses.get(nth)?.pf0?.range());
    "time-ratio" Moving "time_ratio" NONE, |found, nth| found.courses.get(nth)?.stroke.as_ref()?.time_ratio;
    "pf" Parts "pf1_greatest" In::Quantity(Quantity::Transfer(1)), FIRST;
    "pf" Parts "pf2_greatest" In::Quantity(Quantity::Transfer(2)), SECOND;
    "speed" Parts "speed_greatest" SPEED, |found, nth| Some(found.speed?.abs() * FIRST(found, nth)?);
    "acceleration" Parts "acceleration_greatest" In::Quantity(Quantity::Acceleration),
        |found, nth| Some(found.speed? * found.speed? * SECOND(found, nth)?);
    "shaking" Shaking "shaking_force_greatest" FORCE, |found, _| Some(found.shaking.as_ref()?.greatest_force);
    "shaking" Shaking "shaking_force_rms" FORCE, |found, _| Some(found.shaking.as_ref()?.rms_force);
    "shaking" Shaking "shaking_moment_greatest" In::Unit(Unit::MOMENT),
        |found, _| Some(found.shaking.as_ref()?.greatest_moment);
    "regime" Flywheel "flywheel" In::Unit(Unit::INERTIA), |found, _| Some(found.regime()?.flywheel);
    "regime" Motor "ratio" NONE, |found, _| found.regime()?.figures.ratio;
    "regime" Torque "torque" In::Quantity(Quantity::ReducedMoment), |found, _| found.regime()?.figures.torque;
    "regime" Regime "mean_speed" SPEED, |found, _| Some(found.regime()?.figures.mean_speed);
    "regime" Regime "unevenness" NONE, |found, _| Some(found.regime()?.figures.unevenness);
    "regime" Regime "speed_min" SPEED, |found, _| Some(found.regime()?.figures.speed_min);
    "regime" Regime "speed_max" SPEED, |found, _| Some(found.regime()?.figures.speed_max);
    "regime" Regime "excess_work" In::Unit(Unit::JOULE), |found, _| Some(found.regime()?.figures.excess_work);
    "regime" Regime "required_power" In::Unit(Unit::POWER), |found, _| Some(found.regime()?.figures.required_power);
    "end" End "end_time" In::Unit(Unit::SECOND), |found, _| Some(found.last?.state.time);
    "end" End "end_coordinate" In::Coordinate, |found, _| Some(found.last?.state.coordinate);
    "end" End "end_speed" SPEED, |found, _| Some(found.last?.state.speed);
    "friction" Friction "efficiency" NONE, |found, _| found.friction.as_ref()?.efficiency;
    "friction" Friction "friction_work" In::Unit(Unit::JOULE),
        |found, _| found.friction.as_ref()?.friction_work.values().copied().sum();
    "friction" Friction "friction_margin" NONE, |found, _| Some(1.0 - found.friction.as_ref()?.certificate);
    "friction" Friction "self_braking" In::Coordinate, |found, _| Some(total(&found.friction.as_ref()?.self_braking));
    "friction" Friction "dead_angles" In::Coordinate, |found, _| Some(total(&found.friction.as_ref()?.dead_angles));
}

/// Measures that need one coordinate of the mechanism.
pub(crate) const BY_COORDINATE: [&str; 3] = ["time-ratio", "pf", "shaking"];

/// Written where no measures are named.
const BY_DEFAULT: bool = true;
const ASKED: bool = false;

/// All measures but those of the columns of the positions, in the order of their columns.
pub const MEASURES: &[Measure] = &[
    Measure::new("health", "sweep-measure-health", BY_DEFAULT),
    Measure::new("transmission", "sweep-measure-transmission", ASKED),
    Measure::new("balancing", "sweep-measure-balancing", BY_DEFAULT),
    Measure::new("balancing-rms", "sweep-measure-balancing-rms", ASKED),
    Measure::new("reactions", "sweep-measure-reactions", BY_DEFAULT),
    Measure::new("reaction-rms", "sweep-measure-reaction-rms", ASKED),
    Measure::new("extremes", "sweep-measure-extremes", BY_DEFAULT),
    Measure::new("distance", "sweep-measure-distance", BY_DEFAULT),
    Measure::new("stroke", "sweep-measure-stroke", ASKED),
    Measure::new("time-ratio", "sweep-measure-time-ratio", ASKED),
    Measure::new("pf", "sweep-measure-pf", ASKED),
    Measure::new("speed", "sweep-measure-speed", ASKED),
    Measure::new("acceleration", "sweep-measure-acceleration", ASKED),
    Measure::new("shaking", "sweep-measure-shaking", ASKED),
    Measure::new("regime", "sweep-measure-regime", BY_DEFAULT),
    Measure::new("end", "sweep-measure-end", BY_DEFAULT),
    Measure::new("friction", "sweep-measure-friction", ASKED),
];

/// What stands before a key of the JSON in the name of the measure of its columns.
const POSITIONS: &str = "positions.";

impl Describe for Measure {
    /// What its columns hold.
    fn describe(&self) -> Text {
        text!(self.summary)
    }
}

impl Measure {
    const fn new(name: &'static str, summary: &'static str, by_default: bool) -> Self {
        Self { name, summary, by_default, whole: false, is_plain: false }
    }

    /// The measures that are written where none are named.
    pub fn defaults() -> Vec<Self> {
        MEASURES.iter().filter(|measure| measure.by_default).copied().collect()
    }

    /// The measures of these names, in the order of their columns; `default` and `all` name several.
    pub fn named(names: &[impl AsRef<str>]) -> Result<Vec<Self>, SweepError> {
        let plain = |name: &str| KEYS.split(' ').find(|key| name.strip_prefix(POSITIONS) == Some(*key));
        let is_known = |name: &str| MEASURES.iter().any(|measure| measure.name == name);
        let known =
            |name: &str| name == "all" || name == "default" || is_known(name) || plain(name).is_some();
        if let Some(name) = names.iter().map(AsRef::as_ref).find(|name| !known(name)) {
            let measures = list(MEASURES.iter().map(|measure| words(measure.name)));
            let unknown = text!("sweep-no-measure", name = words(name.to_owned()), measures);
            return Err(SweepError::Request(unknown));
        }
        let is_named = |wanted: &str| names.iter().any(|name| name.as_ref() == wanted);
        let own = MEASURES.iter().filter_map(|measure| {
            let whole = is_named("all") || is_named(measure.name);
            (whole || measure.by_default && is_named("default")).then_some(Self { whole, ..*measure })
        });
        let columns =
            |key| Self { whole: true, is_plain: true, ..Self::new(key, "sweep-measure-plain", ASKED) };
        let mut keys: Vec<&'static str> = names.iter().filter_map(|name| plain(name.as_ref())).collect();
        keys.sort_unstable();
        keys.dedup();
        Ok(own.chain(keys.into_iter().map(columns)).collect())
    }

    /// The measure with all its columns.
    pub(crate) fn in_full(self) -> Self {
        Self { whole: true, ..self }
    }

    /// Its name on the command line.
    pub(crate) fn full_name(&self) -> String {
        format!("{}{}", if self.is_plain { POSITIONS } else { "" }, self.name)
    }
}
