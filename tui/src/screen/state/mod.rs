//! Everything on which a frame depends. Commands change it, views read it; nothing here draws or knows a command by
//! name.

mod compare;
mod found;
mod job;
mod key;
mod keymap;
mod kinds;
mod look;
mod plans;
mod scene;
mod series;
mod theme;
mod transfer;
mod whatif;

use std::collections::BTreeMap;

pub(crate) use assur_figure::cells::Marker;
pub(crate) use assur_figure::{Bounds, Zoom};
pub(crate) use compare::Compared;
pub(crate) use found::{Found, Reaction};
pub(crate) use job::{Cancel, Job, Measured, OutputFile, Purpose, Report, Request, Running, Wish};
pub(crate) use key::Key;
pub(crate) use keymap::{Command, Group, Keymap};
pub(crate) use kinds::{
    Arrows, Chosen, Help, Pane, PlanKind, Prompt, PromptKind, Traces, View, following, round,
};
pub(crate) use look::Look;
pub(crate) use plans::{Planner, Plans};
pub(crate) use scene::{Scene, Source};
pub(crate) use series::{Owner, Series, greatest, zeros};
pub(crate) use theme::{Role, Theme};
pub(crate) use transfer::coordinate_unit;
pub(crate) use whatif::{Change, Reading, STEPS, WhatIf};

/// The whole state.
#[derive(Debug)]
pub(crate) struct State {
    /// All commands, in the order of the help screen.
    pub(crate) commands: &'static [Command],
    pub(crate) keys: Keymap,
    pub(crate) scene: Option<Scene>,
    pub(crate) what_if: WhatIf,
    /// Speed, accuracy and stability of the methods on the open scene.
    pub(crate) measured: Option<Box<Measured>>,
    /// Number of the shipped scene that is chosen in the menu.
    pub(crate) shipped: usize,
    /// The shipped scenes that were read for their pictures, by number.
    pub(crate) previews: BTreeMap<usize, Result<Box<Scene>, String>>,
    pub(crate) view: View,
    pub(crate) position: usize,
    pub(crate) chosen: Chosen,
    pub(crate) look: Look,
    pub(crate) zoom: Zoom,
    pub(crate) arrows: Arrows,
    pub(crate) traces: Traces,
    pub(crate) pane: Pane,
    pub(crate) plan: PlanKind,
    /// Requested force analyzer and integrator; `None`: the scene's.
    pub(crate) analyzer: Option<String>,
    pub(crate) integrator: Option<String>,
    /// A second scene for comparison.
    pub(crate) compared: Option<Compared>,
    /// The calculations in progress.
    pub(crate) running: Vec<Running>,
    /// Number of the last requested calculation.
    pub(crate) asked: usize,
    /// Column by which the table is sorted, and whether ascending.
    pub(crate) sorted: Option<(usize, bool)>,
    pub(crate) playing: bool,
    pub(crate) focused: bool,
    pub(crate) help: Option<Help>,
    pub(crate) prompt: Option<Prompt>,
    /// A file that exists and is replaced only after confirmation.
    pub(crate) question: Option<OutputFile>,
    /// A message, shown until the next key.
    pub(crate) message: Option<(Role, String)>,
    /// Errors of a file that could not be used, under a title, shown until the next key.
    pub(crate) fault: Option<(&'static str, String)>,
    /// Columns and rows of the terminal.
    pub(crate) size: (u16, u16),
    pub(crate) wishes: Vec<Wish>,
    pub(crate) leaving: bool,
}

impl State {
    /// The state at the start: the menu, or a scene.
    pub(crate) fn new(scene: Option<Scene>, look: Look, commands: &'static [Command], keys: Keymap) -> Self {
        Self {
            commands,
            keys,
            what_if: WhatIf::of(scene.as_ref()),
            measured: None,
            shipped: 0,
            previews: BTreeMap::new(),
            view: if scene.is_some() { View::Mechanism } else { View::Menu },
            position: scene.as_ref().map_or(0, Scene::first_position),
            scene,
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

    /// The results of the analysis of the open scene, if there are any.
    pub(crate) fn found(&self) -> Option<&Found> {
        self.scene.as_ref()?.found.as_deref()
    }

    /// The measurement in progress.
    pub(crate) fn measuring(&self) -> Option<&Running> {
        self.running.iter().find(|running| running.purpose == Purpose::Measurement)
    }

    /// The analysis in progress.
    pub(crate) fn analyzing(&self) -> Option<&Running> {
        self.running.iter().find(|running| running.purpose != Purpose::Measurement)
    }

    /// Whether the list of the scene's numbers is shown.
    pub(crate) fn values_open(&self) -> bool {
        self.what_if.open && self.scene.is_some() && self.view != View::Menu
    }

    /// The command of a name.
    pub(crate) fn named(&self, name: &str) -> Option<&'static Command> {
        self.commands.iter().find(|command| command.name == name)
    }

    /// Whether a command is available now.
    pub(crate) fn takes(&self, command: &Command) -> bool {
        command.fits(self.view) || (self.values_open() && command.fits(View::Values))
    }

    /// The command of a key now: of the list of values if it is shown, or else of the view.
    pub(crate) fn command(&self, key: Key) -> Option<&'static Command> {
        let meant = |view: View| {
            let fits = |command: &&Command| command.fits(view) && self.keys.keys(command.name).contains(&key);
            self.commands.iter().find(fits)
        };
        let list = Some(View::Values).filter(|_| self.values_open());
        list.and_then(meant).or_else(|| meant(self.view))
    }

    /// Whether the animation runs.
    pub(crate) fn animates(&self) -> bool {
        self.playing && self.focused && self.scene.is_some()
    }

    /// Number of positions; 1 without a scene.
    pub(crate) fn positions(&self) -> usize {
        self.scene.as_ref().map_or(1, Scene::positions).max(1)
    }

    /// Moves by this many positions, cyclically.
    pub(crate) fn step(&mut self, by: isize) {
        self.position = round(self.position, by, self.positions());
    }

    /// Goes to a position; a message if there is none of that number.
    pub(crate) fn go_to(&mut self, position: usize) {
        let last = self.positions() - 1;
        if position <= last {
            self.position = position;
        } else {
            self.say(Role::Bad, format!("there is no position {position}: the last one is {last}"));
        }
    }

    /// The positions in the order of the table's rows.
    pub(crate) fn order(&self) -> Vec<usize> {
        let Some(scene) = &self.scene else { return Vec::new() };
        let mut order: Vec<usize> = (0..scene.positions()).collect();
        if let Some((column, up)) = self.sorted
            && let Some(series) = scene.column(column)
        {
            order.sort_by(|a, b| series.at(*a).total_cmp(&series.at(*b)));
            if !up {
                order.reverse();
            }
        }
        order
    }

    /// Opens the one-line input with a text that can be edited.
    pub(crate) fn open_prompt(&mut self, kind: PromptKind, text: impl Into<String>) {
        self.prompt = Some(Prompt { kind, text: text.into(), completing: None });
    }

    /// Shows a message until the next key.
    pub(crate) fn say(&mut self, role: Role, text: impl Into<String>) {
        self.message = Some((role, text.into()));
    }

    /// Whether a view has something to show.
    pub(crate) fn has(&self, view: View) -> bool {
        let found = self.found();
        match view {
            View::Menu => true,
            View::Forces => found.is_some_and(|found| !found.reactions.is_empty()),
            View::Plans => found.is_some(),
            View::Motion => {
                found.is_some_and(|found| !found.motion.is_empty() || !found.analysis.trajectory.is_empty())
            }
            View::Drive => found.is_some_and(|found| found.analysis.dynamics.is_some()),
            View::Checks => found.is_some_and(|found| !found.analysis.checks.is_empty()),
            _ => self.scene.is_some(),
        }
    }

    /// Goes to a view.
    pub(crate) fn show(&mut self, view: View) {
        self.view = view;
        if view != View::Forces && self.pane == Pane::Causes {
            self.pane = Pane::Table;
        }
    }
}
