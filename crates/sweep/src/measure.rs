//! The families of columns by their names.

use assur_analysis::results::Quantity;
use assur_book::Unit;
use assur_book::catalogue::KEYS;
use assur_words::{Describe, Text, list, name as words, text};

use crate::SweepError;
use crate::columns as of;
use crate::layout::{Builder, Find, Gathered};
use crate::measured::{GREATEST, RMS};

/// What is found only where a measure needs it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    /// The motion between positions.
    Courses,
    /// The distances of points from places between positions.
    Distances,
    /// The shaking force.
    Shaking,
    /// The dry friction over the cycle.
    Friction,
}

/// A family of columns.
#[derive(Debug, Clone, Copy)]
pub struct Measure {
    /// Its name on the command line; of columns of the positions their key in the JSON.
    pub name: &'static str,
    /// The identity of what its columns hold.
    summary: &'static str,
    /// Whether it is written where no measures are named.
    pub by_default: bool,
    /// Whether it is named, and written whole then: else without the columns that no parameter can change.
    pub(crate) whole: bool,
    /// What must be found for it beside the positions, their loads and their motion.
    pub(crate) need: Option<Need>,
    /// Adds its columns; `None`: it has all columns of the positions under this key of the JSON as they are.
    pub(crate) put: Option<fn(&mut Builder<'_>)>,
}

/// What stands before a key of the JSON in the name of the measure of its columns.
const PLAIN: &str = "positions.";

/// All measures but those of the columns of the positions, in the order of their columns.
pub const MEASURES: &[Measure] = &[
    Measure::new("health", "sweep-measure-health", |to| {
        of::groups(to, "smallest_health", Unit::NONE, Gathered::Health);
    }),
    Measure::new("transmission", "sweep-measure-transmission", |to| {
        of::groups(to, "least_transmission_angle", Unit::ANGLE, Gathered::Transmission);
    })
    .asked(None),
    Measure::new("balancing", "sweep-measure-balancing", of::balancing),
    Measure::new("balancing-rms", "sweep-measure-balancing-rms", of::balancing_rms).asked(None),
    Measure::new("reactions", "sweep-measure-reactions", |to| of::joints(to, "greatest", GREATEST)),
    Measure::new("reaction-rms", "sweep-measure-reaction-rms", |to| of::joints(to, "rms", RMS)).asked(None),
    Measure::new("extremes", "sweep-measure-extremes", of::extremes),
    Measure {
        need: Some(Need::Distances),
        ..Measure::new("distance", "sweep-measure-distance", of::distance)
    },
    Measure::new("stroke", "sweep-measure-stroke", of::stroke).asked(Some(Need::Courses)),
    Measure::new("time-ratio", "sweep-measure-time-ratio", of::time_ratio).asked(Some(Need::Courses)),
    Measure::new("pf", "sweep-measure-pf", |to| {
        of::parts(to, "pf1_greatest", Quantity::Transfer(1), of::FIRST);
        of::parts(to, "pf2_greatest", Quantity::Transfer(2), of::SECOND);
    })
    .asked(Some(Need::Courses)),
    Measure::new("speed", "sweep-measure-speed", |to| {
        let find: Find = |found, nth| Some(found.speed?.abs() * of::FIRST(found, nth)?);
        of::parts(to, "speed_greatest", Quantity::Velocity, find);
    })
    .asked(Some(Need::Courses)),
    Measure::new("acceleration", "sweep-measure-acceleration", |to| {
        let find: Find = |found, nth| Some(found.speed? * found.speed? * of::SECOND(found, nth)?);
        of::parts(to, "acceleration_greatest", Quantity::Acceleration, find);
    })
    .asked(Some(Need::Courses)),
    Measure::new("shaking", "sweep-measure-shaking", of::shaking).asked(Some(Need::Shaking)),
    Measure::new("regime", "sweep-measure-regime", of::regime),
    Measure::new("end", "sweep-measure-end", of::end),
    Measure::new("friction", "sweep-measure-friction", of::friction).asked(Some(Need::Friction)),
];

impl Describe for Measure {
    /// What its columns hold.
    fn describe(&self) -> Text {
        text!(self.summary)
    }
}

impl Measure {
    const fn new(name: &'static str, summary: &'static str, put: fn(&mut Builder<'_>)) -> Self {
        Self { name, summary, by_default: true, whole: false, need: None, put: Some(put) }
    }

    /// Written only where it is named, with what must be found for it.
    const fn asked(self, need: Option<Need>) -> Self {
        Self { by_default: false, need, ..self }
    }

    /// The measures that are written where none are named.
    pub fn defaults() -> Vec<Self> {
        MEASURES.iter().filter(|measure| measure.by_default).copied().collect()
    }

    /// The measures of these names, in the order of their columns; `default` and `all` name several.
    pub fn named(names: &[impl AsRef<str>]) -> Result<Vec<Self>, SweepError> {
        let plain = |name: &str| KEYS.split(' ').find(|key| name.strip_prefix(PLAIN) == Some(*key));
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
        let columns = |key| {
            let summary = "sweep-measure-plain";
            Self { name: key, summary, by_default: false, whole: true, need: None, put: None }
        };
        let mut keys: Vec<&'static str> = names.iter().filter_map(|name| plain(name.as_ref())).collect();
        keys.sort_unstable();
        keys.dedup();
        Ok(own.chain(keys.into_iter().map(columns)).collect())
    }

    /// Its name on the command line.
    pub(crate) fn full_name(&self) -> String {
        format!("{}{}", if self.put.is_none() { PLAIN } else { "" }, self.name)
    }

    /// Adds its columns.
    pub(crate) fn columns(&self, to: &mut Builder<'_>) {
        match self.put {
            Some(put) => put(to),
            None => of::plain(to, self.name),
        }
    }
}
