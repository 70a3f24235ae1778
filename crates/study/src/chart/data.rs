//! The data of a chart.

use std::collections::BTreeMap;

use assur_mechanism::Name;
use assur_report::csv::{CsvError, finished};
use assur_words::{Describe, Text, joined, list, name, number, text};
use serde::{Serialize, Serializer};

/// Speed versus accuracy of one scene.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct ChartData {
    /// Title of the scene.
    pub title: Name,
    /// One for each method and setting, in the order of the stages.
    pub rows: Vec<Measurement>,
    /// By stage: how its reference was obtained.
    pub reference: BTreeMap<Stage, Text>,
    /// By stage: the reference's own relative error, as estimated.
    pub reference_error: BTreeMap<Stage, f64>,
    /// Whether the measurement is complete.
    pub complete: bool,
}

/// A stage of the calculation.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Transfer functions: PF0, PF1, PF2 of all links.
    #[default]
    Kinematics,
    /// Reactions and the balancing load.
    Forces,
    /// Dry friction in pairs, with the reactions on which it depends.
    Friction,
    /// Motion from an initial state, or over one cycle of the steady regime.
    Motion,
    /// The flywheel for a wanted unevenness.
    Flywheel,
    /// The steady regime.
    Steady,
}

impl Stage {
    /// All, in order.
    pub const ALL: [Self; 6] =
        [Self::Kinematics, Self::Forces, Self::Friction, Self::Motion, Self::Flywheel, Self::Steady];

    fn texts(self) -> (&'static str, Text, Text) {
        let position = text!("chart-one-position");
        match self {
            Self::Kinematics => ("kinematics", text!("chart-kinematics"), position),
            Self::Forces => ("forces", text!("chart-forces"), position),
            Self::Friction => ("friction", text!("chart-friction"), position),
            Self::Motion => ("motion", text!("chart-motion"), text!("chart-one-run")),
            Self::Flywheel => ("flywheel", text!("chart-flywheel"), text!("chart-one-flywheel")),
            Self::Steady => ("steady", text!("chart-steady"), text!("chart-one-regime")),
        }
    }

    /// The name in JSON and CSV.
    pub fn name(self) -> &'static str {
        self.texts().0
    }

    /// A heading.
    pub fn heading(self) -> Text {
        self.texts().1
    }

    /// What the times are of: one position, one run.
    pub fn work(self) -> Text {
        self.texts().2
    }

    /// What one unit of work is: one position of the mechanism, or one whole run.
    pub fn unit(self) -> Text {
        match self {
            Self::Kinematics | Self::Forces | Self::Friction => text!("chart-per-position"),
            Self::Motion | Self::Flywheel | Self::Steady => text!("chart-per-run"),
        }
    }
}

/// A value of a setting.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum SettingValue {
    /// A number: a tolerance, a step.
    Number(f64),
    /// A word: the type of number.
    Word(&'static str),
}

/// The settings of a method, by name.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Setting(pub Vec<(&'static str, SettingValue)>);

impl Setting {
    /// One number.
    pub fn number(name: &'static str, value: f64) -> Self {
        Self(vec![(name, SettingValue::Number(value))])
    }

    /// One word.
    pub fn word(name: &'static str, value: &'static str) -> Self {
        Self(vec![(name, SettingValue::Word(value))])
    }

    /// Its values alone, for a point of a chart.
    pub(crate) fn values(&self) -> Text {
        joined(
            " ",
            self.0.iter().filter(|(name, _)| *name != GIVES).map(|(_, value)| match *value {
                SettingValue::Number(value) => short(value),
                SettingValue::Word(word) => name(word),
            }),
        )
    }

    /// The value of this name.
    pub fn get(&self, name: &str) -> Option<SettingValue> {
        self.0.iter().find(|(found, _)| *found == name).map(|(_, value)| *value)
    }
}

impl Serialize for Setting {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

/// A number in few characters: `1e-6`, `3.2e-5`, `0.02`, `24`.
fn short(value: f64) -> Text {
    if value == 0.0 || (1e-2..1e4).contains(&value.abs()) {
        return number((1e3 * value).round() / 1e3);
    }
    number(format!("{value:.1e}").replace(".0e", "e"))
}

impl Describe for Setting {
    fn describe(&self) -> Text {
        list(self.0.iter().map(|setting| match *setting {
            (STEP, SettingValue::Number(step)) => text!("chart-step", value = short(step)),
            (TOLERANCE, SettingValue::Number(tolerance)) => {
                text!("chart-tolerance", value = short(tolerance))
            }
            (other, SettingValue::Number(value)) => joined(" ", [name(other), short(value)]),
            (GIVES, SettingValue::Word(_)) => text!("chart-balancing-only"),
            (_, SettingValue::Word(word)) => name(word),
        }))
    }
}

/// The name of a setting: the tolerance of a method.
pub(crate) const TOLERANCE: &str = "tolerance";

/// The name of a setting: the step of a method, s, rad or parts of the size.
pub(crate) const STEP: &str = "step";

/// The name of a setting that says that a method gives only the balancing load.
pub(crate) const GIVES: &str = "gives";

/// One method at one setting.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[expect(clippy::struct_excessive_bools, reason = "each says something of its own about the row")]
pub struct Measurement {
    /// The stage.
    pub stage: Stage,
    /// Name of the method: a registered one, or one of this crate.
    pub method: String,
    /// Its setting.
    pub setting: Setting,
    /// Median time of one unit of work, s; `None` where it was not measured.
    pub seconds: Option<f64>,
    /// Median deviation of its timings from the median, and at least what the place in memory makes of it, s.
    pub noise: Option<f64>,
    /// What one unit is: see [`Stage::unit`].
    pub unit: Text,
    /// Evaluations in one unit: group solutions in a position, evaluations of the equation of motion in a run.
    pub evaluations: Option<u64>,
    /// Largest relative deviation from the reference.
    pub error: Option<f64>,
    /// `error` is the reference's own error estimate: the true one is at most about that.
    pub at_most: bool,
    /// Whether the method did all of the work.
    pub ok: bool,
    /// Why not, or why something is missing.
    pub reason: Option<Text>,
    /// Whether it is on the Pareto front of its stage: no other row that does the whole work is both faster, beyond the noise
    /// of the times, and more exact.
    pub front: bool,
    /// Whether it is the program's own choice for the motion with this tolerance.
    pub auto: bool,
}

impl Measurement {
    /// A row without measurements yet.
    pub(crate) fn new(stage: Stage, method: &str, setting: Setting) -> Self {
        Self { stage, method: method.to_owned(), setting, unit: stage.unit(), ..Self::default() }
    }

    /// Whether the method gives all results of its stage, so that it may be compared with the others.
    pub fn whole(&self) -> bool {
        self.setting.get(GIVES).is_none()
    }

    /// Time and error, if the method did all of its work and both are known.
    pub fn point(&self) -> Option<(f64, f64)> {
        self.ok.then_some(())?;
        self.seconds.zip(self.error)
    }
}

/// The reference of a stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// How it was obtained.
    pub how: Text,
    /// Its own relative error, as estimated.
    pub error: f64,
}

impl ChartData {
    /// The rows of a stage.
    pub fn of(&self, stage: Stage) -> impl Iterator<Item = &Measurement> {
        self.rows.iter().filter(move |row| row.stage == stage)
    }
}

const HEADER: &str =
    "stage method setting value seconds_s noise_s unit evaluations error at_most ok front auto reason";

/// All rows, comma separated, full precision; an empty field where nothing is known.
pub fn csv(data: &ChartData) -> Result<String, CsvError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER.split(' '))?;
    for row in &data.rows {
        writer.write_record(fields(row))?;
    }
    finished(writer)
}

fn fields(row: &Measurement) -> [String; 14] {
    let (names, values): (Vec<&str>, Vec<String>) = row
        .setting
        .0
        .iter()
        .map(|(name, value)| match value {
            SettingValue::Number(number) => (*name, format!("{number:e}")),
            SettingValue::Word(word) => (*name, (*word).to_owned()),
        })
        .unzip();
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:e}"));
    [
        row.stage.name().to_owned(),
        row.method.clone(),
        names.join(" "),
        values.join(" "),
        number(row.seconds),
        number(row.noise),
        row.unit.to_string(),
        row.evaluations.map_or_else(String::new, |count| count.to_string()),
        number(row.error),
        row.at_most.to_string(),
        row.ok.to_string(),
        row.front.to_string(),
        row.auto.to_string(),
        row.reason.as_ref().map_or_else(String::new, Text::to_string),
    ]
}
