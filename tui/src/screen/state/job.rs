//! The jobs of the worker, their reports, and the flag that stops them.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use assur_analysis::Options;
use assur_analysis::results::Checks;
use assur_book::Document;
use assur_study::chart::ChartData;
use assur_study::stability::Stability;
use assur_words::Text;

use super::Found;
use super::draft::{Change, Recovered};
use super::scene::Scene;
use crate::session::{Session, Source};

/// Actions that a command requests because the state can't do them.
#[derive(Debug)]
pub(crate) enum Effect {
    Quit,
    Redraw,
    /// Take the terminal again after the process was suspended.
    Retake,
    Suspend,
    Work(Job),
    Write(OutputFile),
    /// Write how the screen looks into the configuration.
    Keep,
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct OutputFile {
    /// Where; the numbers behind a picture have the same name with the ending `csv`.
    pub(crate) path: PathBuf,
    pub(crate) content: Vec<u8>,
    /// The numbers behind a picture, as CSV beside it; `None`: the content is all.
    pub(crate) numbers: Option<Vec<u8>>,
    pub(crate) overwrite: bool,
    /// Whether it is the open scene with its changes.
    pub(crate) scene: bool,
}

/// What is done only after confirmation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Question {
    /// A file that exists is replaced.
    Overwrite(OutputFile),
    /// Unsaved changes are opened, or thrown away.
    Recover(Recovered),
}

#[derive(Debug)]
pub(crate) enum Job {
    Read(Wanted),
    Note {
        session: Arc<Session>,
        options: Options,
        path: PathBuf,
    },
    /// Calculate all results of the open scene, or measure the methods on it.
    Calculate(CalculationRequest),
}

#[derive(Debug, Clone)]
pub(crate) enum Wanted {
    /// To be opened, perhaps again.
    Open(Source),
    /// For comparison with the open one.
    /// A second scene, at so many positions.
    Compare(Source, usize),
    /// A shipped scene, for its picture.
    Preview(&'static str),
    /// The open one with changed numbers.
    Change(Change),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Purpose {
    /// The results that are shown, with their checks.
    Main,
    /// Results by another force analyzer, for the difference.
    Difference,
    /// Speed and accuracy of the methods.
    Measurement,
}

#[derive(Debug, Clone)]
pub(crate) struct CalculationRequest {
    /// Number of the request; a report to a request that is no longer in progress is dropped.
    pub(crate) number: usize,
    pub(crate) purpose: Purpose,
    pub(crate) session: Arc<Session>,
    pub(crate) options: Options,
    pub(crate) cancel: Cancel,
}

#[derive(Debug, Clone)]
pub(crate) struct Running {
    pub(crate) number: usize,
    pub(crate) purpose: Purpose,
    pub(crate) count: Text,
    pub(crate) cancel: Cancel,
}

#[derive(Debug, Clone, Default)]
pub(crate) struct Cancel(Arc<AtomicBool>);

impl Cancel {
    pub(crate) fn stop(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// The return value for a calculation that asks whether to continue.
    pub(crate) fn flow(&self) -> ControlFlow<()> {
        if self.0.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// A report of the worker. A failure is a text to show.
#[derive(Debug)]
pub(crate) enum Report {
    Read(Wanted, Result<Box<Scene>, Text>),
    Noted(PathBuf, Result<String, Text>),
    /// Of the calculation of the request of this number.
    Calculated(usize, Outcome),
}

#[derive(Debug)]
pub(crate) enum Outcome {
    Count(Text),
    Found(Box<Found>),
    Checks(Checks),
    Measured(Box<Measured>),
    Failed(Text),
}

#[derive(Debug, Clone)]
pub(crate) struct Measured {
    /// Speed versus accuracy, or why there is none.
    pub(crate) chart: Result<ChartData, Text>,
    /// `None` if the measurement was stopped before.
    pub(crate) stability: Option<Result<Stability, Text>>,
}

impl Measured {
    /// Conclusions, speed versus accuracy, stability.
    pub(crate) fn tell(&self, page: &mut Document) {
        if let Some(Ok(found)) = &self.stability {
            found.conclude(page);
        }
        match &self.chart {
            Ok(data) => data.tell(page),
            Err(error) => page.paragraph(error.clone()),
        }
        match &self.stability {
            Some(Ok(found)) => found.tell(page),
            Some(Err(error)) => page.paragraph(error.clone()),
            None => {}
        }
    }
}
