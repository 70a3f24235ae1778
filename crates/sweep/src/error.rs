//! Why a sweep can't begin.

use assur_scene::SceneErrors;

use crate::MEASURES;

/// Why a sweep can't begin, or has no row to write. What is wrong at one point is part of the table.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The scene itself is faulty.
    #[error(transparent)]
    Scene(#[from] SceneErrors),
    /// A parameter is not written as it should be, or names nothing.
    #[error("`{vary}`: {problem}")]
    Vary {
        /// The parameter as it was given, or its key.
        vary: String,
        /// What is wrong, and what to write.
        problem: String,
    },
    /// No parameter.
    #[error("nothing is varied: name a parameter, such as \"link.crank.mass=1 kg..5 kg:9\"")]
    Nothing,
    /// Two parameters are the same value of the scene.
    #[error("`{first}` and `{second}` are the same value of the scene: vary it once")]
    Twice {
        /// One key.
        first: String,
        /// The other.
        second: String,
    },
    /// Too many points.
    #[error("the sweep has {points} points, at most {most} are calculated: fewer values of each parameter")]
    TooMany {
        /// How many; `too many` where they can't be counted.
        points: String,
        /// How many there may be.
        most: usize,
    },
    /// Too many parameters of a sample.
    #[error("the sample has {count} parameters, at most {most}: keep those that matter")]
    TooManyParameters {
        /// How many.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// There is no such measure (the name).
    #[error("there is no measure `{0}`: name some of {measures}, or `default` or `all`", measures = measures())]
    Measure(String),
    /// No point makes a scene that can be calculated.
    #[error("no point of the sweep can be calculated; the first, {point}:\n{problem}")]
    AllRefused {
        /// Keys and values of the first point.
        point: String,
        /// What is wrong with it.
        problem: String,
    },
    /// The threads could not be started.
    #[error("can't start {threads} threads: {problem}")]
    Threads {
        /// How many.
        threads: usize,
        /// The message of the system.
        problem: String,
    },
}

impl SweepError {
    pub(crate) fn vary(vary: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Vary { vary: vary.into(), problem: problem.into() }
    }
}

fn measures() -> String {
    MEASURES.iter().map(|measure| measure.name).collect::<Vec<_>>().join(", ")
}
