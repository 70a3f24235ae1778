//! Why a sweep can't begin.

use assur_scene::SceneErrors;
use assur_words::{Describe, Text, list, name, number, text};

use crate::MEASURES;

/// Why a sweep can't begin, or has no row to write. What is wrong at one point is part of the table.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SweepError {
    /// The scene itself is faulty.
    Scene(SceneErrors),
    /// A parameter is not written as it should be, or names nothing.
    Vary {
        /// The parameter as it was given, or its key.
        vary: String,
        /// What is wrong, and what to write.
        problem: Text,
    },
    /// No parameter.
    Nothing,
    /// Two parameters are the same value of the scene.
    Twice {
        /// One key.
        first: String,
        /// The other.
        second: String,
    },
    /// Too many points.
    TooMany {
        /// How many; `None` where they can't be counted.
        points: Option<usize>,
        /// How many there may be.
        most: usize,
    },
    /// Too many parameters of a sample.
    TooManyParameters {
        /// How many.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// There is no such measure (the name).
    Measure(String),
    /// No point makes a scene that can be calculated.
    AllRefused {
        /// Keys and values of the first point.
        point: Box<Text>,
        /// What is wrong with it.
        problem: Refusal,
    },
    /// The threads could not be started.
    Threads {
        /// How many.
        threads: usize,
        /// The message of the system.
        problem: String,
    },
}

/// Why the first point of a sweep can't be calculated.
#[derive(Debug, Clone, PartialEq)]
pub enum Refusal {
    /// Its scene is faulty.
    Scene(SceneErrors),
    /// Why it has no values.
    Row(Text),
}

assur_words::errors!(SweepError; Scene(SceneErrors));

impl Describe for SweepError {
    fn describe(&self) -> Text {
        match self {
            Self::Scene(errors) => errors.describe(),
            Self::Vary { vary, problem } => {
                text!("sweep-vary", vary = name(vary.clone()), problem = problem)
            }
            Self::Nothing => text!("sweep-nothing-varied"),
            Self::Twice { first, second } => {
                text!("sweep-twice", first = name(first.clone()), second = name(second.clone()))
            }
            Self::TooMany { points: Some(points), most } => {
                text!("sweep-many-points", points = number(points), most = number(most))
            }
            Self::TooMany { points: None, most } => text!("sweep-uncounted-points", most = number(most)),
            Self::TooManyParameters { count, most } => {
                text!("sweep-many-parameters", count = *count, most = *most)
            }
            Self::Measure(unknown) => {
                let measures = list(MEASURES.iter().map(|measure| name(measure.name)));
                text!("sweep-no-measure", name = name(unknown.clone()), measures = measures)
            }
            Self::AllRefused { point, problem } => {
                let problem = match problem {
                    Refusal::Scene(errors) => errors.describe(),
                    Refusal::Row(message) => message.clone(),
                };
                text!("sweep-all-refused", point = point.as_ref(), problem = problem)
            }
            Self::Threads { threads, problem } => {
                text!("sweep-no-threads", threads = *threads, problem = name(problem.clone()))
            }
        }
    }
}

impl SweepError {
    pub(crate) fn vary(vary: impl Into<String>, problem: Text) -> Self {
        Self::Vary { vary: vary.into(), problem }
    }
}
