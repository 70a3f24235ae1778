//! The families of columns, from what was found at a point.

use assur_analysis::results::FrictionCycle;
use assur_dynamics::{Instant, Steady};
use assur_geometry::{Extremes, PartCourses};
use assur_mechanism::{Input, PairId};
use assur_number::{Extreme, Statistic};
use assur_shaking::Size;
use assur_words::{Describe, Text, list, name as words, text};

use crate::SweepError;
use crate::between::{acceleration, shaking, speed, stroke, time_ratio, transfer};
use crate::layout::{Layout, Sought};

/// What is found only where a measure needs it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Need {
    /// The angles of the links.
    Angles,
    /// The transmission angles of the groups.
    Transmission,
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
    /// Its name on the command line.
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
}

/// All measures, in the order of their columns.
pub const MEASURES: &[Measure] = &[
    Measure::new("health", "sweep-measure-health", health),
    Measure::new("transmission", "sweep-measure-transmission", transmission).asked(Some(Need::Transmission)),
    Measure::new("balancing", "sweep-measure-balancing", balancing),
    Measure::new("balancing-rms", "sweep-measure-balancing-rms", balancing_rms).asked(None),
    Measure::new("reactions", "sweep-measure-reactions", reactions),
    Measure::new("reaction-rms", "sweep-measure-reaction-rms", reaction_rms).asked(None),
    Measure { need: Some(Need::Angles), ..Measure::new("extremes", "sweep-measure-extremes", extremes) },
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
#[derive(Debug)]
pub(crate) struct Measured {
    /// Least determinant of all groups.
    pub(crate) health: Statistic,
    /// Least transmission angle of all groups.
    pub(crate) transmission: Statistic,
    pub(crate) balancing: Statistic,
    /// Modulus of the balancing load.
    pub(crate) load: Statistic,
    /// Of each joint: square of the greatest force on one of its links.
    pub(crate) forces: Vec<Statistic>,
    /// Of each joint: modulus of its moment.
    pub(crate) moments: Vec<Statistic>,
    pub(crate) points: Vec<[Statistic; 2]>,
    /// The distances of points from places between positions; empty where the cycle has a part without a solution.
    pub(crate) distances: Vec<Extremes>,
    pub(crate) slides: Vec<Statistic>,
    /// Angles of links.
    pub(crate) links: Vec<Statistic>,
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

impl Measured {
    /// Coordinate of an extreme, rad or m.
    fn coordinate(&self, extreme: Option<Extreme>) -> Option<f64> {
        Some(self.input.as_ref()?.coordinate(extreme?.number))
    }

    /// Memory for what is measured.
    pub(crate) fn new(layout: &Layout) -> Self {
        let many = |count: usize| vec![Statistic::default(); count];
        Self {
            health: Statistic::default(),
            transmission: Statistic::default(),
            balancing: Statistic::default(),
            load: Statistic::default(),
            forces: many(layout.joints.len()),
            moments: many(layout.joints.len()),
            points: vec![[Statistic::default(); 2]; layout.points.len()],
            distances: Vec::new(),
            slides: many(layout.slides.len()),
            links: many(layout.links.len()),
            input: None,
            last: None,
            steady: None,
            friction: None,
            courses: None,
            speed: None,
            shaking: None,
        }
    }

    /// Forgets what belongs to the positions whatever the loads.
    pub(crate) fn clear_positions(&mut self) {
        let Self { health, transmission, points, distances, slides, links, input, courses, .. } = self;
        (*health, *transmission, *input, *courses) = (Statistic::default(), Statistic::default(), None, None);
        points.fill([Statistic::default(); 2]);
        distances.clear();
        slides.fill(Statistic::default());
        links.fill(Statistic::default());
    }

    /// Forgets what belongs to loads and motion.
    pub(crate) fn clear_forces(&mut self) {
        let Self { balancing, load, forces, moments, last, steady, shaking, friction, .. } = self;
        (*balancing, *load) = (Statistic::default(), Statistic::default());
        forces.fill(Statistic::default());
        moments.fill(Statistic::default());
        (*last, *steady, *shaking, *friction) = (None, None, None, None);
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
        Self { name, summary, by_default: true, whole: false, need: None, put }
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
    ///
    /// # Errors
    ///
    /// [`SweepError::Request`] for an unknown name.
    pub fn named(names: &[impl AsRef<str>]) -> Result<Vec<Self>, SweepError> {
        let known =
            |name: &str| name == "all" || name == "default" || MEASURES.iter().any(|m| m.name == name);
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
        Ok(each.map(|measure| Self { whole: is_asked(measure), ..*measure }).collect())
    }

    /// Puts its columns into a sink.
    pub(crate) fn put(&self, layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
        (self.put)(layout, found, sink);
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

fn value(extreme: Option<Extreme>) -> Option<f64> {
    extreme.map(|extreme| extreme.value)
}

fn health(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.groups {
        sink.put(value(found.health.least()), || "smallest_health".to_owned());
        let name = || format!("smallest_health_at_{}", layout.units.coordinate);
        sink.put(found.coordinate(found.health.least()), name);
    }
}

fn transmission(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.groups {
        let name = || "least_transmission_angle_rad".to_owned();
        sink.put(value(found.transmission.least()), name);
        let name = || format!("least_transmission_angle_at_{}", layout.units.coordinate);
        sink.put(found.coordinate(found.transmission.least()), name);
    }
}

fn balancing(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.balancing {
        let unit = layout.units.balancing;
        sink.put(value(found.load.greatest()), || format!("balancing_greatest_{unit}"));
        let name = || format!("balancing_greatest_at_{}", layout.units.coordinate);
        sink.put(found.coordinate(found.load.greatest()), name);
        sink.put(found.balancing.mean(), || format!("balancing_mean_{unit}"));
        sink.put(found.load.mean(), || format!("balancing_mean_modulus_{unit}"));
    }
}

fn balancing_rms(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    if layout.balancing {
        sink.put(found.balancing.rms(), || format!("balancing_rms_{}", layout.units.balancing));
    }
}

fn reactions(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let each = layout.joints.iter().zip(&found.forces).zip(&found.moments);
    for ((joint, force), moment) in each.filter(|((joint, _), _)| joint.reached) {
        let name = &joint.name;
        sink.put(value(force.greatest()).map(f64::sqrt), || format!("reaction_{name}_greatest_N"));
        if matches!(joint.id.id, PairId::Slide(_)) {
            sink.put(value(moment.greatest()), || format!("reaction_{name}_moment_greatest_Nm"));
        }
    }
}

fn reaction_rms(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    let each = layout.joints.iter().zip(&found.forces).zip(&found.moments);
    for ((joint, force), moment) in each {
        let name = &joint.name;
        sink.put(force.mean().map(f64::sqrt), || format!("reaction_{name}_rms_N"));
        if matches!(joint.id.id, PairId::Slide(_)) {
            sink.put(moment.rms(), || format!("reaction_{name}_moment_rms_Nm"));
        }
    }
}

fn extremes(layout: &Layout, found: &Measured, sink: &mut Sink<'_>) {
    for (point, place) in layout.points.iter().zip(&found.points).filter(|(point, _)| point.reached) {
        for (axis, of) in ["x", "y"].into_iter().zip(place) {
            sink.put(value(of.least()), || format!("{}_{axis}_min_m", point.name));
            sink.put(value(of.greatest()), || format!("{}_{axis}_max_m", point.name));
        }
    }
    for (slide, displacement) in layout.slides.iter().zip(&found.slides).filter(|(slide, _)| slide.reached) {
        sink.put(value(displacement.least()), || format!("{}_min_m", slide.name));
        sink.put(value(displacement.greatest()), || format!("{}_max_m", slide.name));
        let range =
            displacement.greatest().zip(displacement.least()).map(|(most, least)| most.value - least.value);
        sink.put(range, || format!("{}_travel_m", slide.name));
    }
    for (link, angle) in layout.links.iter().zip(&found.links).filter(|(link, _)| link.reached) {
        sink.put(value(angle.least()), || format!("{}_angle_min_rad", link.name));
        sink.put(value(angle.greatest()), || format!("{}_angle_max_rad", link.name));
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
