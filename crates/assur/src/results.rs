//! What was found of a scene.

use std::convert::Infallible;

use assur_analysis::{Calculation, Watch};
use assur_report::csv;
use assur_words::{Describe, Told};

use crate::{Columns, Error};

/// The results of a scene.
#[derive(Debug, Clone)]
pub struct Results {
    /// One row for each position that has a solution.
    pub positions: Columns,
    /// One row for each sample of the motion over time, where the scene has one.
    pub motion: Columns,
    /// The positions without a solution: number, and what is missing, where and by how much.
    pub failures: Vec<(usize, String)>,
    /// What in the scene is probably not meant, and what had to be left out.
    pub warnings: Vec<String>,
}

/// The force of a pair.
#[derive(Debug, Clone, Copy)]
pub struct Reaction<'a> {
    /// The link on which the force acts.
    pub on: &'a str,
    /// Its projection on the x axis of the ground, N, row by row.
    pub x: &'a [f64],
    /// Its projection on the y axis, N.
    pub y: &'a [f64],
    /// The moment of a slide, N m, about its point, positive counter-clockwise on the link that slides; `None` of a pin.
    pub moment: Option<&'a [f64]>,
}

impl Results {
    pub(crate) fn of(study: &Calculation, watch: &mut Watch<'_>) -> Result<Self, Error> {
        let stopped = |stopped: assur_analysis::Stopped| Error::told(stopped.describe());
        let analysis = study.analyze(watch).map_err(stopped)?;
        let mut positions = Columns::of(analysis.positions.schema(), csv::columns_of_positions(&analysis));
        let empty = positions.clone();
        if !analysis.is_complete() {
            positions.reserve(study.linkage.mechanism.input.positions);
        }
        let done = study.each_block(
            &analysis,
            watch,
            |table| empty.block(table),
            |block| {
                positions.append(block);
                Ok::<(), Infallible>(())
            },
        );
        let Ok(()) = done.map_err(stopped)?;
        let named = csv::of_trajectory(&analysis, false).map(|sheet| sheet.columns()).unwrap_or_default();
        let mut motion = Columns::of(analysis.trajectory.schema(), named);
        motion.append(motion.block(&analysis.trajectory));
        let failures = analysis.failures.iter();
        Ok(Self {
            positions,
            motion,
            failures: failures
                .map(|failure| (failure.index, Told(failure.message.clone()).to_string()))
                .collect(),
            warnings: analysis
                .warnings
                .iter()
                .map(|warning| Told(warning.text.clone()).to_string())
                .collect(),
        })
    }

    /// The numbers of a column of the positions by its name in CSV, such as `B_x_m`.
    ///
    /// # Errors
    ///
    /// No column has the name; the error names the most similar.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        self.positions.column(name)
    }

    /// The force of a pair by its name in the positions, under the loads and the motion of the scene; where the motion is found over time,
    /// in its samples. It acts on the link on which tables show it: of two links the first that moves.
    ///
    /// # Errors
    ///
    /// No pair has the name, or nothing is known of its force.
    pub fn reaction(&self, pair: &str) -> Result<Reaction<'_>, Error> {
        self.positions.reaction(pair).or_else(|error| self.motion.reaction(pair).map_err(|_| error))
    }
}
