//! The families of columns, from what was found at a point.

use std::cell::Cell;

use assur_analysis::results::{FrictionCycle, Turn};
use assur_book::Range;
use assur_book::catalogue::KEYS;
use assur_dynamics::{Instant, Steady};
use assur_geometry::{Extremes, PartCourses};
use assur_mechanism::Input;
use assur_number::{Extreme, Statistic};
use assur_shaking::Size;
use assur_words::{Describe, Text, list, name as words, text};

use crate::SweepError;
use crate::between::{acceleration, shaking, speed, stroke, time_ratio, transfer};
use crate::layout::{Gathered, Layout, Sought};

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
    put: fn(&Layout, &Measured, &mut Sink<'_>),
    /// Whether it has all columns of the positions under this key of the JSON as they are.
    pub(crate) is_plain: bool,
}

/// What stands before a key of the JSON in the name of the measure of its columns.
const PLAIN: &str = "positions.";

/// All measures but those of the columns of the positions, in the order of their columns.
pub const MEASURES: &[Measure] = &[
    Measure::new("health", "sweep-measure-health", health),
    Measure::new("transmission", "sweep-measure-transmission", transmission).asked(None),
    Measure::new("balancing", "sweep-measure-balancing", balancing),
    Measure::new("balancing-rms", "sweep-measure-balancing-rms", balancing_rms).asked(None),
    Measure::new("reactions", "sweep-measure-reactions", reactions),
    Measure::new("reaction-rms", "sweep-measure-reaction-rms", reaction_rms).asked(None),
    Measure::new("extremes", "sweep-measure-extremes", extremes),
    Measure { need: Some(Need::Distances), ..Measure::new("distance", "sweep-measure-distance", distance) },
    Measure::new("stroke", "sweep-measure-stroke", stroke).asked(Some(Need::Courses)),
    Measure::new("time-ratio", "sweep-measure-time-ratio", time_ratio).asked(Some(Need::Courses)),
    Measure::new("pf", "sweep-measure-pf", transfer).asked(Some(Need::Courses)),
    Measure::new("speed", "sweep-measure-speed", speed).asked(Some(Need::Courses)),
    Measure::new("acceleration", "sweep-measure-acceleration", acceleration).asked(Some(Need::Courses)),
    Measure::new("shaking", "sweep-measure-shaking", shaking).asked(Some(Need::Shaking)),
    Measure::new("regime", "sweep-measure-regime", regime),
    Measure::new("end", "sweep-measure-end", end),
    Measure::new("friction", "sweep-measure-friction", friction).asked(Some(Need::Friction)),
];

/// What was found at a point of a sweep.
#[derive(Debug, Default)]
pub(crate) struct Measured {
    /// Of what the layout gathers, over the positions.
    pub(crate) statistics: Vec<Statistic>,
    /// The same between the positions too; none where it was not asked for.
    pub(crate) ranges: Vec<Option<Range>>,
    /// Which of them a measure has asked for.
    pub(crate) asked: Vec<Cell<bool>>,
    /// The distances of points from places between positions; empty where the cycle has a part without a solution.
    pub(crate) distances: Vec<Extremes>,
    /// The input, which gives the coordinates of the positions.
    pub(crate) input: Option<Input>,
    /// The last state of a transient motion.
    pub(crate) last: Option<Instant>,
    pub(crate) steady: Option<Box<Steady>>,
    /// Dry friction over the cycle.
    pub(crate) friction: Option<FrictionCycle>,
    /// The motion between positions; `None` where it was not asked for, or the cycle has a part without a solution.
    pub(crate) courses: Option<PartCourses>,
    /// The speed of an input whose speed is prescribed and constant, rad/s or m/s.
    pub(crate) speed: Option<f64>,
    /// The shaking force; `None` where it was not asked for, or there is none.
    pub(crate) shaking: Option<Size>,
}

/// The number of the statistic of the least determinant, and of that of the least transmission angle.
pub(crate) const HEALTH: usize = 0;
pub(crate) const TRANSMISSION: usize = 1;

impl Measured {
    /// Memory for what is measured.
    pub(crate) fn new(layout: &Layout) -> Self {
        let count = layout.gathered.len();
        let (statistics, asked) = (vec![Statistic::default(); count], vec![Cell::new(false); count]);
        Self { statistics, asked, ..Self::default() }
    }

    /// Forgets what belongs to the positions whatever the loads.
    pub(crate) fn clear_positions(&mut self, layout: &Layout) {
        self.statistics[..layout.places].fill(Statistic::default());
        self.distances.clear();
        (self.input, self.courses) = (None, None);
    }

    /// Forgets what belongs to loads and motion.
    pub(crate) fn clear_forces(&mut self, layout: &Layout) {
        self.statistics[layout.places..].fill(Statistic::default());
        self.ranges.clear();
        (self.last, self.steady, self.shaking, self.friction) = (None, None, None, None);
    }

    /// An extreme with its coordinate, rad or m; none where it grows without limit.
    fn extreme(
        &self,
        (layout, number): (&Layout, usize),
        at_positions: fn(&Statistic) -> Option<Extreme>,
        between: fn(&Range) -> Turn,
    ) -> Option<[f64; 2]> {
        self.asked[number].set(true);
        if let Some(range) = self.ranges.get(number) {
            let Turn { value, at, .. } = between(range.as_ref()?);
            return value.is_finite().then_some([value, at]);
        }
        let found = at_positions(&self.statistics[number])?;
        let is_square = matches!(layout.gathered[number], Gathered::Force(_));
        let value = if is_square { found.value.sqrt() } else { found.value };
        Some([value, self.input.as_ref()?.coordinate(found.number)])
    }

    fn greatest(&self, layout: &Layout, number: usize) -> Option<[f64; 2]> {
        self.extreme((layout, number), Statistic::greatest, |range| range.greatest)
    }

    fn least(&self, layout: &Layout, number: usize) -> Option<[f64; 2]> {
        self.extreme((layout, number), Statistic::least, |range| range.least)
    }

    /// Mean and root of the mean square.
    fn means(&self, layout: &Layout, number: usize) -> [Option<f64>; 2] {
        self.asked[number].set(true);
        if let Some(range) = self.ranges.get(number) {
            let means = range.as_ref().and_then(|range| range.means);
            return [means.map(|means| means.mean), means.map(|means| means.rms)];
        }
        let found = &self.statistics[number];
        match layout.gathered[number] {
            Gathered::Force(_) => [None, found.mean().map(f64::sqrt)],
            _ => [found.mean(), found.rms()],
        }
    }
}

impl Describe for Measure {
    /// What its columns hold.
    fn describe(&self) -> Text {
        text!(self.summary)
    }
}

impl Measure {
    const fn new(
        name: &'static str,
        summary: &'static str,
        put: fn(&Layout, &Measured, &mut Sink<'_>),
    ) -> Self {
        Self { name, summary, by_default: true, whole: false, need: None, put, is_plain: false }
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
        let wanted = |measure: &&Self| {
            let mut names = names.iter().map(AsRef::as_ref);
            names.any(|name| name == "all" || name == measure.name || name == "default" && measure.by_default)
        };
        let is_asked = |measure: &Self| {
            names.iter().map(AsRef::as_ref).any(|name| name == "all" || name == measure.name)
        };
        let each = MEASURES.iter().filter(wanted);
        let own = each.map(|measure| Self { whole: is_asked(measure), ..*measure });
        let columns = |key| {
            let nothing = |_: &Layout, _: &Measured, _: &mut Sink<'_>| {};
            Self { whole: true, is_plain: true, ..Self::new(key, "sweep-measure-plain", nothing) }
        };
        let mut keys: Vec<&'static str> = names.iter().filter_map(|name| plain(name.as_ref())).collect();
        keys.sort_unstable();
        keys.dedup();
        Ok(own.chain(keys.into_iter().map(columns)).collect())
    }

    /// Its name on the command line.
    pub(crate) fn full_name(&self) -> String {
        format!("{}{}", if self.is_plain { PLAIN } else { "" }, self.name)
    }

    /// Puts its columns into a sink.
    pub(crate) fn put(&self, layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
        (self.put)(layout, found, sink);
        let plain = layout.plain.iter().filter(|column| self.is_plain && column.key == self.name);
        for column in plain {
            let [mean, rms] = found.means(layout, column.first);
            let ends = [found.least(layout, column.first), found.greatest(layout, column.first)].map(value);
            for (name, value) in column.names.iter().zip(ends.into_iter().chain([mean, rms])) {
                sink.put(value, || name.clone());
            }
        }
    }
}

/// The columns of measures: their names, or their values at one point.
pub(crate) enum Sink<'a> {
    /// Receives the names.
    Names(&'a mut Vec<String>),
    /// Receives the values, NaN for a cell without one, and the column of the first one that is not finite.
    Values(&'a mut Vec<f64>, &'a mut Option<usize>),
}

impl Sink<'_> {
    pub(crate) fn put(&mut self, value: Option<f64>, name: impl FnOnce() -> String) {
        match self {
            Self::Names(names) => names.push(name()),
            Self::Values(values, wrong) => {
                if wrong.is_none() && value.is_some_and(|value| !value.is_finite()) {
                    **wrong = Some(values.len());
                }
                values.push(value.unwrap_or(f64::NAN));
            }
        }
    }
}

fn value(extreme: Option<[f64; 2]>) -> Option<f64> {
    extreme.map(|[value, _]| value)
}

/// Puts an extreme and its coordinate.
fn put_at(extreme: Option<[f64; 2]>, layout: &Layout, [name, unit]: [&str; 2], sink: &mut Sink<'_>) {
    sink.put(value(extreme), || format!("{name}{unit}"));
    sink.put(extreme.map(|[_, at]| at), || format!("{name}_at_{}", layout.units.coordinate));
}

fn health(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.groups {
        put_at(found.least(layout, HEALTH), layout, ["smallest_health", ""], sink);
    }
}

fn transmission(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.groups {
        put_at(found.least(layout, TRANSMISSION), layout, ["least_transmission_angle", "_rad"], sink);
    }
}

fn balancing(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.balancing {
        let (unit, load, size) = (layout.units.balancing, layout.places, layout.places + 1);
        put_at(found.greatest(layout, size), layout, ["balancing_greatest", &format!("_{unit}")], sink);
        sink.put(found.means(layout, load)[0], || format!("balancing_mean_{unit}"));
        sink.put(found.means(layout, size)[0], || format!("balancing_mean_modulus_{unit}"));
    }
}

fn balancing_rms(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.balancing {
        let rms = found.means(layout, layout.places)[1];
        sink.put(rms, || format!("balancing_rms_{}", layout.units.balancing));
    }
}

fn reactions(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    for joint in layout.joints.iter().filter(|joint| joint.reached) {
        let name = &joint.name;
        sink.put(value(found.greatest(layout, joint.first)), || format!("reaction_{name}_greatest_N"));
        if joint.is_slide() {
            let moment = value(found.greatest(layout, joint.first + 1));
            sink.put(moment, || format!("reaction_{name}_moment_greatest_Nm"));
        }
    }
}

fn reaction_rms(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    for joint in &layout.joints {
        let name = &joint.name;
        sink.put(found.means(layout, joint.first)[1], || format!("reaction_{name}_rms_N"));
        if joint.is_slide() {
            let moment = found.means(layout, joint.first + 1)[1];
            sink.put(moment, || format!("reaction_{name}_moment_rms_Nm"));
        }
    }
}

fn extremes(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let ends = |number| [value(found.least(layout, number)), value(found.greatest(layout, number))];
    for point in layout.points.iter().filter(|point| point.reached) {
        for (nth, axis) in ["x", "y"].into_iter().enumerate() {
            let [least, greatest] = ends(point.first + nth);
            sink.put(least, || format!("{}_{axis}_min_m", point.name));
            sink.put(greatest, || format!("{}_{axis}_max_m", point.name));
        }
    }
    for slide in layout.slides.iter().filter(|slide| slide.reached) {
        let [least, greatest] = ends(slide.first);
        sink.put(least, || format!("{}_min_m", slide.name));
        sink.put(greatest, || format!("{}_max_m", slide.name));
        let travel = greatest.zip(least).map(|(most, least)| most - least);
        sink.put(travel, || format!("{}_travel_m", slide.name));
    }
    for link in layout.links.iter().filter(|link| link.reached) {
        let [least, greatest] = ends(link.first);
        sink.put(least, || format!("{}_angle_min_rad", link.name));
        sink.put(greatest, || format!("{}_angle_max_rad", link.name));
    }
}

fn distance(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    for (number, (point, _)) in layout.targets.iter().enumerate() {
        let column = |what: &str| format!("{}_distance_{}_{what}", layout.points[*point].name, number + 1);
        let (at, of) = (layout.units.coordinate, found.distances.get(number));
        sink.put(of.map(|of| of.min), || column("least_m"));
        sink.put(of.map(|of| of.at_min), || column(&format!("least_at_{at}")));
        sink.put(of.map(|of| of.max), || column("greatest_m"));
        sink.put(of.map(|of| of.at_max), || column(&format!("greatest_at_{at}")));
    }
}

fn regime(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let Some(Sought::Steady { flywheel, motor, torque }) = layout.motion else { return };
    let steady = found.steady.as_deref();
    let mut put = |shown: bool, name: &str, value: fn(&Steady) -> Option<f64>| {
        if shown {
            sink.put(steady.and_then(value), || name.to_owned());
        }
    };
    put(flywheel, "flywheel_kgm2", |found| Some(found.regime.flywheel));
    put(motor, "ratio", |found| found.regime.figures.ratio);
    put(torque, "torque_Nm", |found| found.regime.figures.torque);
    let speed = layout.units.speed;
    put(true, &format!("mean_speed_{speed}"), |found| Some(found.regime.figures.mean_speed));
    put(true, "unevenness", |found| Some(found.regime.figures.unevenness));
    put(true, &format!("speed_min_{speed}"), |found| Some(found.regime.figures.speed_min));
    put(true, &format!("speed_max_{speed}"), |found| Some(found.regime.figures.speed_max));
    put(true, "excess_work_J", |found| Some(found.regime.figures.excess_work));
    put(true, "required_power_W", |found| Some(found.regime.figures.required_power));
}

fn friction(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if !layout.friction {
        return;
    }
    let cycle = found.friction.as_ref();
    let total = |all: &[[f64; 2]]| all.iter().fold(0.0, |sum, [from, to]| sum + (to - from));
    sink.put(cycle.and_then(|cycle| cycle.efficiency), || "efficiency".to_owned());
    let loss = |cycle: &FrictionCycle| cycle.friction_work.values().copied().sum::<Option<f64>>();
    sink.put(cycle.and_then(loss), || "friction_work_J".to_owned());
    sink.put(cycle.map(|cycle| 1.0 - cycle.certificate), || "friction_margin".to_owned());
    let unit = layout.units.coordinate;
    sink.put(cycle.map(|cycle| total(&cycle.self_braking)), || format!("self_braking_{unit}"));
    sink.put(cycle.map(|cycle| total(&cycle.dead_angles)), || format!("dead_angles_{unit}"));
}

fn end(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.motion == Some(Sought::Transient) {
        let last = found.last.map(|instant| instant.state);
        sink.put(last.map(|state| state.time), || "end_time_s".to_owned());
        let name = || format!("end_coordinate_{}", layout.units.coordinate);
        sink.put(last.map(|state| state.coordinate), name);
        sink.put(last.map(|state| state.speed), || format!("end_speed_{}", layout.units.speed));
    }
}
