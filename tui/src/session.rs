//! A scene that is open, and what is compiled of it.

use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use assur_analysis::{AnalysisError, Calculation, Coverage, Options, Watch, plan};
use assur_fixtures::SCENES;
use assur_kinematics::{CompileError, Linkage, decompose};
use assur_mechanism::{Key, MOST_PARTS_DRAWN, Mechanism, Motion, Warning};
use assur_picture::{Found, Results};
use assur_scene::Note;
use assur_structure::Structure;
use assur_words::{Describe, Text, joined, name, number, text};

use crate::files::{self, FileError};

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) enum Source {
    File(PathBuf),
    /// One of the shipped scenes, by its name without the ending.
    Shipped(&'static str),
    /// One that is built and has no file yet.
    #[default]
    New,
}

impl Source {
    pub(crate) fn name(&self) -> String {
        match self {
            Self::File(path) => files::shown(path),
            Self::Shipped(name) => format!("{name}.toml"),
            Self::New => "new.toml".to_owned(),
        }
    }

    pub(crate) fn text(&self) -> Result<String, Text> {
        match self {
            Self::File(path) => files::read(path).map_err(|error| error.describe()),
            Self::New => Ok(String::new()),
            Self::Shipped(name) => {
                let scene = SCENES.iter().find(|(known, _)| known == name);
                Ok(scene.map(|(_, text)| (*text).to_owned()).unwrap_or_default())
            }
        }
    }

    /// The name without its folder.
    pub(crate) fn short_name(&self) -> String {
        Path::new(&self.name()).file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// The name without its folder and its ending.
    pub(crate) fn stem(&self) -> String {
        Path::new(&self.name()).file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }
}

/// An open scene: its text, the mechanism that the text describes, and the linkage, which is compiled when it is first needed.
/// All commands, the terminal UI and the note calculate with it; a changed number makes another one of it. Its faults are in words,
/// complete with file and line.
#[derive(Debug)]
pub(crate) struct Session {
    pub(crate) source: Source,
    pub(crate) text: String,
    /// What the scene says about its note.
    pub(crate) note: Note,
    pub(crate) mechanism: Mechanism,
    pub(crate) structure: Structure,
    /// With all groups.
    linkage: OnceLock<Arc<Linkage>>,
}

impl Session {
    /// Reads a scene from its source.
    pub(crate) fn open(source: Source) -> Result<Self, Text> {
        let text = source.text()?;
        Self::read(source, text)
    }

    /// Reads a scene from its text.
    pub(crate) fn read(source: Source, text: String) -> Result<Self, Text> {
        let (mechanism, note) = read(&source, &text)?;
        let structure = decompose(&mechanism).map_err(|error| {
            // What is probably not meant may be why the links don't form a mechanism.
            let warnings = mechanism.warnings.iter().map(|one| placed(&source, &text, one));
            joined("\n", warnings.chain([uncompiled(&source, &text, &error.into())]))
        })?;
        Ok(Self { source, text, note, mechanism, structure, linkage: OnceLock::new() })
    }

    /// The scene with another text. Where that differs in numbers only, no group is looked for again, and where the positions
    /// stay the same, nothing is compiled again.
    pub(crate) fn changed(&self, text: String) -> Result<Self, Text> {
        let source = self.source.clone();
        let (mechanism, note) = read(&source, &text)?;
        let Some(linkage) = self.linkage.get().filter(|_| {
            mechanism.has_structure_of(&self.mechanism) && has_names_of(&mechanism, &self.mechanism)
        }) else {
            return Self::read(source, text);
        };
        let varied = Linkage::clone(linkage).varied(mechanism.clone(), &self.all_groups());
        let (linkage, ..) = varied.map_err(|error| uncompiled(&source, &text, &error))?;
        let structure = linkage.structure.clone();
        Ok(Self { source, text, note, mechanism, structure, linkage: Arc::new(linkage).into() })
    }

    pub(crate) fn linkage(&self) -> Result<Arc<Linkage>, CompileError> {
        if let Some(linkage) = self.linkage.get() {
            return Ok(Arc::clone(linkage));
        }
        let linkage = Arc::new(self.compiled(&self.all_groups())?);
        Ok(Arc::clone(self.linkage.get_or_init(|| linkage)))
    }

    fn all_groups(&self) -> Vec<bool> {
        vec![true; self.structure.groups.len()]
    }

    fn compiled(&self, needed: &[bool]) -> Result<Linkage, CompileError> {
        Linkage::compile_for(self.mechanism.clone(), self.structure.clone(), needed)
    }

    /// The calculation of what the scene requests, or of all results. The linkage is compiled for it alone only where groups
    /// are left out.
    pub(crate) fn calculation(
        &self,
        options: &Options,
        watch: &mut Watch<'_>,
    ) -> Result<Calculation, AnalysisError> {
        let plan = plan(&self.mechanism, &self.structure, options);
        let linkage =
            if plan.is_partial() { Arc::new(self.compiled(&plan.groups_needed)?) } else { self.linkage()? };
        Calculation::planned(linkage, plan, None, options, watch)
    }

    pub(crate) fn found(&self, options: &Options, watch: &mut Watch<'_>) -> Result<Found, AnalysisError> {
        let calculation = self.calculation(options, watch)?;
        Found::of(calculation, self.linkage()?, options, watch)
    }

    /// The positions of the scene, if it is not too large to be drawn.
    pub(crate) fn positions(&self) -> Result<Results, Text> {
        self.refuse_large()?;
        let linkage = self.linkage().map_err(|error| self.fault(&error.into()))?;
        Results::of(linkage).map_err(|error| self.fault(&error))
    }

    /// The positions with the results of what the scene requests, and with their checks where they are wanted.
    pub(crate) fn analyzed(
        &self,
        options: &Options,
        checks: bool,
        watch: &mut Watch<'_>,
    ) -> Result<Results, Text> {
        let mut results = self.positions()?;
        let mut found = self.found(options, watch).map_err(|error| self.fault(&error))?;
        if checks {
            let all = found.plans.calculation().checks(Coverage::Sample, watch);
            found.take_checks(all.map_err(|stopped| stopped.describe())?);
        }
        results.take(Box::new(found));
        Ok(results)
    }

    fn refuse_large(&self) -> Result<(), Text> {
        let (parts, count) = (self.mechanism.parts(), self.mechanism.input.positions);
        let (id, too_many, most) = if parts > MOST_PARTS_DRAWN {
            ("say-too-many-parts", ("parts", number(parts)), MOST_PARTS_DRAWN)
        } else if count > self.mechanism.most_kept() {
            ("say-too-many-positions", ("positions", number(count)), self.mechanism.most_kept())
        } else {
            return Ok(());
        };
        let scene = name(self.source.name());
        Err(Text::message(id, vec![too_many, ("most", number(most)), ("scene", scene)]))
    }

    /// An error of a calculation, at the line of the scene that it concerns if there is one.
    pub(crate) fn fault(&self, error: &AnalysisError) -> Text {
        self.fault_at(error.key(&self.mechanism), error.describe())
    }

    /// A fault that is found while calculating, at a key of the scene, or in its file.
    pub(crate) fn fault_at(&self, key: Option<Key>, message: Text) -> Text {
        let located = key.and_then(|key| self.at_key(&key, message.clone()));
        located.unwrap_or_else(|| self.in_file(message))
    }

    /// A fault at a key of the scene; `None` if the scene has no such key.
    pub(crate) fn at_key(&self, key: &Key, message: Text) -> Option<Text> {
        at_key(&self.source, &self.text, key, message)
    }

    /// What is probably not meant in the scene, with its place.
    pub(crate) fn placed(&self, warning: &Warning) -> Text {
        placed(&self.source, &self.text, warning)
    }

    pub(crate) fn in_file(&self, message: Text) -> Text {
        in_file(&self.source, message)
    }
}

/// Whether the parts of two mechanisms of one structure have the same names.
fn has_names_of(one: &Mechanism, other: &Mechanism) -> bool {
    let links = one.links.iter().zip(&other.links).all(|(one, other)| one.name == other.name);
    let points = one.points.iter().zip(&other.points).all(|(one, other)| one.name == other.name);
    links && points && one.slides.iter().zip(&other.slides).all(|(one, other)| one.name == other.name)
}

/// The mechanism of a scene, which need not be one that moves.
pub(crate) fn mechanism_of(source: &Source) -> Result<Mechanism, Text> {
    Ok(read(source, &source.text()?)?.0)
}

/// Reads the mechanism of a scene, and what it says about its note.
fn read(source: &Source, text: &str) -> Result<(Mechanism, Note), Text> {
    let (mechanism, note) =
        assur_scene::read_with_note(&source.name(), text).map_err(|errors| errors.describe())?;
    let unknown = match &mechanism.motion {
        Some(Motion::Transient { integrator, .. }) if integrator != "auto" => {
            assur_integrator::find(integrator).err()
        }
        _ => None,
    };
    let key = Key::of("motion").at("integrator");
    let fault = unknown.and_then(|error| at_key(source, text, &key, error.describe()));
    fault.map_or(Ok((mechanism, note)), Err)
}

/// What is probably not meant in a scene, with file, line and column where it has a key.
fn placed(source: &Source, text: &str, warning: &Warning) -> Text {
    let fault = |key| assur_scene::fault_at(&source.name(), text, key, Text::default());
    let errors = warning.key.as_ref().and_then(fault);
    let place = errors.iter().flat_map(|found| &found.errors).map(|at| format!(":{}:{}", at.line, at.column));
    let place = name(source.name() + &place.collect::<String>());
    text!("cli-mistake", place, text = &warning.text)
}

fn at_key(source: &Source, text: &str, key: &Key, message: Text) -> Option<Text> {
    assur_scene::fault_at(&source.name(), text, key, message).map(|errors| errors.describe())
}

fn in_file(source: &Source, message: Text) -> Text {
    FileError::read(Path::new(&source.name()), message).describe()
}

/// An error of compiling at its line of the scene, if it concerns a link.
fn uncompiled(source: &Source, text: &str, error: &CompileError) -> Text {
    let located = error.key().and_then(|key| at_key(source, text, &key, error.describe()));
    located.unwrap_or_else(|| in_file(source, error.describe()))
}
