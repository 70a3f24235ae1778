//! A scene that is read.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use assur_analysis::{Calculation, Options};
use assur_group::Order;
use assur_kinematics::Linkage;
use assur_scene::edit::quoted;
use assur_words::Describe;

use crate::{Error, Position, Results, SweepOptions, SweepRows, swept};

/// A scene that is read, with its mechanism compiled.
#[derive(Debug, Clone)]
pub struct Scene {
    pub(crate) file: String,
    pub(crate) text: String,
    pub(crate) linkage: Arc<Linkage>,
}

impl Scene {
    /// Reads a scene from a file.
    ///
    /// # Errors
    ///
    /// A file that can't be read; a scene with faults, with file, line, column and key of the first; links that form no mechanism.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let file = path.as_ref().display().to_string();
        match std::fs::read_to_string(&path) {
            Ok(text) => Self::parse(&file, &text),
            Err(problem) => {
                Err(Error { message: format!("{file}: {problem}"), file: Some(file), ..Error::default() })
            }
        }
    }

    /// Reads a scene from its text; `file` is only repeated in errors.
    ///
    /// # Errors
    ///
    /// As those of [`read`](Self::read).
    pub fn parse(file: &str, text: &str) -> Result<Self, Error> {
        let mechanism = assur_scene::read(file, text).map_err(|errors| Error::of_scene(&errors, text))?;
        let linkage = Linkage::compile(mechanism)
            .map_err(|error| Error::at(file, text, error.key(), error.describe()))?;
        Ok(Self { file: file.to_owned(), text: text.to_owned(), linkage: Arc::new(linkage) })
    }

    /// The text of the scene.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The formula of its structure, such as `I(ground,crank) -> II1(rod,rocker)`.
    pub fn structure(&self) -> String {
        self.linkage.structure.formula.as_str().to_owned()
    }

    /// The names of its points.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &str> {
        self.linkage.mechanism.points.iter().map(|point| point.name.as_str())
    }

    /// The names of its links, the ground among them.
    pub fn links(&self) -> impl ExactSizeIterator<Item = &str> {
        self.linkage.mechanism.links.iter().map(|link| link.name.as_str())
    }

    /// The coordinates of the positions that the scene asks for, rad, m or s.
    pub fn coordinates(&self) -> impl ExactSizeIterator<Item = f64> + '_ {
        let input = &self.linkage.mechanism.input;
        (0..input.positions).map(|index| input.coordinate(index))
    }

    /// The position at a coordinate (rad, m or s) of the input, with its first and second derivatives.
    ///
    /// # Errors
    ///
    /// The mechanism can't be assembled there: the group, the gap, and where it can.
    pub fn at(&self, coordinate: f64) -> Result<Position<'_>, Error> {
        let mut solved = self.linkage.position();
        self.linkage
            .solve(coordinate, Order::Second, &mut solved)
            .map_err(|error| Error::at(&self.file, &self.text, None, error.describe()))?;
        Ok(Position { linkage: &self.linkage, solved })
    }

    /// All results of the positions and of the motion, as `assur analyze` has them, without its checks.
    ///
    /// # Errors
    ///
    /// What lets nothing be calculated; a position without a solution is one of the [failures](Results::failures).
    pub fn analyze(&self) -> Result<Results, Error> {
        self.analyze_while(&mut || true)
    }

    /// As [`analyze`](Self::analyze), for a calculation that may take long: `goes_on` is asked now and then whether to go on.
    ///
    /// # Errors
    ///
    /// As those of [`analyze`](Self::analyze); that it was stopped.
    pub fn analyze_while(&self, goes_on: &mut dyn FnMut() -> bool) -> Result<Results, Error> {
        let options = Options::default();
        let failed = |error: assur_analysis::AnalysisError| {
            Error::at(&self.file, &self.text, error.key(&self.linkage.mechanism), error.describe())
        };
        let mut watch = |_| if goes_on() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
        let study = Calculation::of(self.linkage.mechanism.clone(), &options, &mut watch).map_err(failed)?;
        Results::of(&study, &mut watch)
    }

    /// The scene with another value, written as in a scene: `scene.with("link.crank.mass", "5 kg")`. Comments and order stay.
    ///
    /// # Errors
    ///
    /// A key that the scene does not have, or a value that it does not allow.
    pub fn with(&self, key: &str, value: &str) -> Result<Self, Error> {
        let at = assur_mechanism::Key::parse(key).map_err(Error::told)?;
        let is_number = value.parse::<f64>().is_ok_and(f64::is_finite);
        let value = if is_number { value.to_owned() } else { quoted(value) };
        let text = assur_draft::set(&self.text, &at, &value).map_err(Error::told)?;
        Self::parse(&self.file, &text)
    }

    /// The scene with many values of its own numbers, in all combinations: each of `vary` is `KEY=FROM..TO:N` or `KEY=A,B,C`, as in
    /// `assur sweep`;
    /// `measures` are its measures, the usual ones where none is named.
    ///
    /// # Errors
    ///
    /// A parameter that the scene does not have, an unknown measure, too many points; values of which none makes a scene. A point that
    /// fails is a row.
    pub fn sweep(&self, vary: &[&str], measures: &[&str]) -> Result<SweepRows, Error> {
        let measures = measures.iter().map(|&measure| measure.to_owned()).collect();
        self.sweep_with(vary, &SweepOptions { measures, ..SweepOptions::default() }, &mut || true)
    }

    /// As [`sweep`](Self::sweep), with all that `assur sweep` has: keys that follow others, distances, samples, parts. `goes_on` is asked
    /// now and then whether to go on.
    ///
    /// # Errors
    ///
    /// As those of [`sweep`](Self::sweep); that it was stopped.
    pub fn sweep_with(
        &self,
        vary: &[&str],
        options: &SweepOptions,
        goes_on: &mut dyn FnMut() -> bool,
    ) -> Result<SweepRows, Error> {
        swept::of(self, vary, options, goes_on)
    }
}
