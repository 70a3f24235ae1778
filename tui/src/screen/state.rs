//! Everything a frame depends on. Commands change it, views read it.

mod kinds;

pub(crate) use kinds::{Arrows, Chosen, Help, Look, Pane, PlanKind, Traces, View};

use super::accuracy::Accuracy;
use super::command::Command;
use super::compare::Compared;
use super::draw::scale::Zoom;
use super::key::Key;
use super::keymap::Keymap;
use super::menu::Menu;
use super::prompt::Prompt;
use super::running::Running;
use super::study::Study;
use super::text::{ENGLISH, Texts, fill};
use super::theme::Role;
use super::whatif::{self, WhatIf};
use super::work::{Job, Report};
use super::writing::OutputFile;

/// What a command wants that it can't do itself.
#[derive(Debug)]
pub(crate) enum Wish {
    Quit,
    Redraw,
    Retake,
    Suspend,
    Work(Job),
    Write(OutputFile),
}

/// The whole state.
#[derive(Debug)]
pub(crate) struct State {
    pub(crate) texts: &'static Texts,
    pub(crate) keys: Keymap,
    pub(crate) study: Option<Study>,
    pub(crate) what_if: WhatIf,
    pub(crate) accuracy: Accuracy,
    pub(crate) menu: Menu,
    pub(crate) view: View,
    pub(crate) position: usize,
    pub(crate) chosen: Chosen,
    pub(crate) look: Look,
    pub(crate) zoom: Zoom,
    pub(crate) arrows: Arrows,
    pub(crate) traces: Traces,
    pub(crate) pane: Pane,
    pub(crate) plan: PlanKind,
    /// Force analyzer and integrator that are asked for; `None`: the scene's.
    pub(crate) analyzer: Option<String>,
    pub(crate) integrator: Option<String>,
    /// A second scene beside the open one.
    pub(crate) compared: Option<Compared>,
    /// The analyses that run beside.
    pub(crate) running: Vec<Running>,
    /// Number of the last analysis that was asked for.
    pub(crate) asked: usize,
    /// How many scenes were opened: an answer to an older one is dropped.
    pub(crate) generation: usize,
    /// Column and sense by which the table is sorted.
    pub(crate) sorted: Option<(usize, bool)>,
    pub(crate) playing: bool,
    pub(crate) focused: bool,
    pub(crate) help: Option<Help>,
    pub(crate) prompt: Option<Prompt>,
    /// A file that exists and may be overwritten if the user says so.
    pub(crate) question: Option<OutputFile>,
    /// One line until the next key.
    pub(crate) message: Option<(Role, String)>,
    /// Faults of a file that was not taken, under a title, until the next key.
    pub(crate) fault: Option<(&'static str, String)>,
    pub(crate) size: (u16, u16),
    pub(crate) wishes: Vec<Wish>,
    pub(crate) leaving: bool,
}

impl State {
    /// The state at the start: the menu, or a scene.
    pub(crate) fn new(study: Option<Study>, look: Look) -> Self {
        let position = study.as_ref().map_or(0, Study::first_position);
        let view = if study.is_some() { View::Mechanism } else { View::Menu };
        Self {
            texts: &ENGLISH,
            keys: Keymap::default(),
            what_if: WhatIf::of(study.as_ref()),
            study,
            accuracy: Accuracy::default(),
            menu: Menu::default(),
            view,
            position,
            chosen: Chosen::default(),
            look,
            zoom: Zoom::WHOLE,
            arrows: Arrows::Velocity,
            traces: Traces::All,
            pane: Pane::Table,
            plan: PlanKind::Forces,
            analyzer: None,
            integrator: None,
            compared: None,
            running: Vec::new(),
            asked: 0,
            generation: 0,
            sorted: None,
            playing: false,
            focused: true,
            help: None,
            prompt: None,
            question: None,
            message: None,
            fault: None,
            size: (80, 24),
            wishes: Vec::new(),
            leaving: false,
        }
    }

    /// Whether a command has a meaning now.
    pub(crate) fn takes(&self, command: &Command) -> bool {
        command.fits(self.view) || (self.values_open() && command.fits(View::Values))
    }

    /// What a key means now: to the list of values where it is shown, or else to the view.
    pub(crate) fn command(&self, key: Key) -> Option<&'static Command> {
        let list = Some(View::Values).filter(|_| self.values_open());
        list.and_then(|list| self.keys.command(key, list)).or_else(|| self.keys.command(key, self.view))
    }

    /// Whether the clock moves the mechanism.
    pub(crate) fn animates(&self) -> bool {
        self.playing && self.focused && self.study.is_some()
    }

    /// One step of the animation.
    pub(crate) fn tick(&mut self) {
        self.step(1);
    }

    /// Number of positions; 1 without a scene.
    pub(crate) fn positions(&self) -> usize {
        self.study.as_ref().map_or(1, Study::positions).max(1)
    }

    /// Moves by so many positions, round the cycle.
    pub(crate) fn step(&mut self, by: isize) {
        let count = isize::try_from(self.positions()).unwrap_or(isize::MAX);
        let now = isize::try_from(self.position).unwrap_or(0);
        self.position = usize::try_from((now + by).rem_euclid(count)).unwrap_or(0);
    }

    /// Goes to a position, and says so where there is none of that number.
    pub(crate) fn go_to(&mut self, position: usize) {
        if position < self.positions() {
            self.position = position;
        } else {
            let last = self.positions() - 1;
            self.say(Role::Bad, fill(self.texts.no_position, &[&position, &last]));
        }
    }

    /// Shows one line until the next key.
    pub(crate) fn say(&mut self, role: Role, text: impl Into<String>) {
        self.message = Some((role, text.into()));
    }

    /// Takes what the worker found; tells whether the frame may differ.
    pub(crate) fn take_report(&mut self, report: Report) -> bool {
        match report {
            Report::Opened(Ok(study)) => self.open(*study),
            Report::Opened(Err(text)) => self.fault = Some((self.texts.fault_title, text)),
            Report::Changed(change, study) => return whatif::take(self, &change, study),
            Report::Preview(index, preview) => self.menu.keep(index, preview),
            Report::Progress { generation, count } => return self.take_progress(generation, count),
            Report::Measured { generation, measured } => return self.take_measured(generation, measured),
            Report::Compared(other) => self.take_compared(other),
            Report::Checked { number, checks } => return self.take_checks(number, checks),
            Report::Counted { number, count } => return self.take_count(number, count),
            Report::Analyzed { number, found } => return self.take_found(number, found),
        }
        true
    }

    /// Shows a scene: a new one from its start, the same one again where it was.
    fn open(&mut self, study: Study) {
        let again = self.study.as_ref().is_some_and(|old| old.source == study.source);
        if !again {
            self.position = study.first_position();
            self.chosen = Chosen::default();
            self.zoom = Zoom::WHOLE;
        }
        if !again || self.view == View::Menu {
            self.view = View::Mechanism;
        }
        if self.study.as_ref().is_none_or(|old| !again || old.positions() != study.positions()) {
            self.compared = None;
        }
        self.position = self.position.min(study.positions().saturating_sub(1));
        self.chosen.transfer = self.chosen.transfer.min(study.transfers.len().saturating_sub(1));
        self.chosen.group = self.chosen.group.min(study.linkage.structure.groups.len().saturating_sub(1));
        self.chosen.column = self.chosen.column.min(study.series.len().saturating_sub(1));
        let Chosen { transfer, group, column, .. } = self.chosen;
        self.chosen = Chosen { transfer, group, column, ..Chosen::default() };
        self.fault = None;
        whatif::reloaded(self, &study, again);
        self.study = Some(study);
        super::accuracy::stop(self);
        self.accuracy = Accuracy::default();
        self.generation += 1;
        self.analyze(false);
    }
}
