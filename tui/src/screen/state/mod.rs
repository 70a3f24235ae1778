//! Everything on which a frame depends. Commands change it, views read it; nothing here draws or knows a command by
//! name.

mod compare;
mod found;
mod job;
mod key;
mod keymap;
mod kinds;
mod look;
mod picker;
mod plans;
mod probe;
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
pub use job::NoteWriter;
pub(crate) use job::{Cancel, Job, Measured, OutputFile, Purpose, Report, Request, Running, Wish};
pub(crate) use key::Key;
pub(crate) use keymap::{Command, Group, Keymap};
pub(crate) use kinds::{Arrows, Chosen, Help, Part, Prompt, PromptKind, Traces, View, following, round};
pub(crate) use look::{Look, Panels};
pub(crate) use picker::{Choice, Picker, PickerKind};
pub(crate) use plans::{Planner, Plans};
pub(crate) use probe::Probe;
pub(crate) use scene::{Scene, Source};
pub(crate) use series::{Owner, Series, greatest, zeros};
pub(crate) use theme::{Role, Theme};
pub(crate) use transfer::coordinate_unit;
pub(crate) use whatif::{Change, Reading, STEPS, WhatIf};

/// Positions by which a frame of the motion goes on.
pub(crate) const PACES: [f64; 7] = [0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0];
/// The pace at the start: every position once.
const EVERY: usize = 4;

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
    /// The list that is open to choose from.
    pub(crate) picker: Option<Picker>,
    /// The shipped scenes that were read for their pictures, by number.
    pub(crate) previews: BTreeMap<usize, Result<Box<Scene>, String>>,
    pub(crate) view: View,
    /// The other views that are shown beside it where there is room.
    pub(crate) panels: Panels,
    pub(crate) position: usize,
    /// How far the motion has gone from this position to the next one, from 0 to 1; 0 unless it plays.
    pub(crate) phase: f64,
    /// Index in [`PACES`].
    pub(crate) pace: usize,
    pub(crate) chosen: Chosen,
    /// Short names of the quantities on the chart; none: PF0, PF1, PF2 of the chosen point, link or slide.
    pub(crate) picked: Vec<String>,
    /// How many groups are joined to the input link in the drawing of the structure; `None`: all.
    pub(crate) joined: Option<usize>,
    /// The point that is moved over the drawing.
    pub(crate) probe: Option<Probe>,
    /// Power (W) and greatest speed (rad/s) for which motors are listed; `None`: those of the scene.
    pub(crate) motor_limits: Option<[f64; 2]>,
    pub(crate) look: Look,
    pub(crate) zoom: Zoom,
    pub(crate) arrows: Arrows,
    pub(crate) traces: Traces,
    /// The part of each view that is shown; the first one where there is none.
    pub(crate) parts: BTreeMap<View, Part>,
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
    /// Writes the note of a scene.
    pub(crate) note: Option<NoteWriter>,
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
            picker: None,
            previews: BTreeMap::new(),
            view: View::Mechanism,
            panels: Panels::default(),
            position: scene.as_ref().map_or(0, Scene::first_position),
            scene,
            phase: 0.0,
            pace: EVERY,
            chosen: Chosen::default(),
            picked: Vec::new(),
            joined: None,
            probe: None,
            motor_limits: None,
            look,
            zoom: Zoom::WHOLE,
            arrows: Arrows::Velocity,
            traces: Traces::All,
            parts: BTreeMap::new(),
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
            note: None,
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
        self.what_if.open && self.scene.is_some()
    }

    /// What is open within the view and takes keys before it.
    fn inset(&self) -> Option<View> {
        let probe = self.probe.as_ref().filter(|_| self.view == View::Mechanism).map(|_| View::Probe);
        Some(View::Values).filter(|_| self.values_open()).or(probe)
    }

    /// The part of a view that is shown: the chosen one if there is something to show in it.
    pub(crate) fn part(&self, view: View) -> Part {
        let parts = self.available_parts(view);
        let chosen = self.parts.get(&view).filter(|part| parts.contains(part));
        chosen.or(parts.first()).copied().unwrap_or(Part::Overview)
    }

    /// The parts of a view in which there is something to show.
    pub(crate) fn available_parts(&self, view: View) -> Vec<Part> {
        let found = self.found();
        let reaction = found.and_then(|found| found.reactions.get(self.chosen.reaction));
        let regime = found.is_some_and(|found| found.analysis.dynamics.is_some());
        let has = |part: &Part| match (view, part) {
            // The balancing load has one number, no direction.
            (View::Forces, Part::Hodograph) => reaction.is_some_and(|reaction| reaction.series.len() == 3),
            (View::Motion, Part::Course) => {
                regime || found.is_some_and(|found| !found.analysis.trajectory.is_empty())
            }
            (View::Motion, Part::Iteration) => regime,
            _ => true,
        };
        view.parts().iter().copied().filter(has).collect()
    }

    /// The quantity that the view is about: what the keys to the greatest and least value mean.
    pub(crate) fn main_series(&self) -> Option<&Series> {
        let scene = self.scene.as_ref()?;
        let of_found = |index: usize| scene.found.as_ref()?.series.get(index);
        let transfer = || scene.series.get(scene.transfers.get(self.chosen.transfer)?.orders[0]);
        match self.view {
            View::Table => scene.column(self.chosen.column),
            View::Forces => {
                let reaction = self.found()?.reactions.get(self.chosen.reaction)?;
                of_found(*reaction.series.last()?)
            }
            View::Motion => {
                let motion = &self.found()?.motion;
                of_found(*motion.get(self.chosen.motion % motion.len().max(1))?)
            }
            View::Curves => self.picked.last().and_then(|short| scene.named(short)).or_else(transfer),
            _ => transfer(),
        }
    }

    /// The command of a name.
    pub(crate) fn named(&self, name: &str) -> Option<&'static Command> {
        self.commands.iter().find(|command| command.name == name)
    }

    /// Whether a command is available now.
    pub(crate) fn takes(&self, command: &Command) -> bool {
        command.fits(self.view) || self.inset().is_some_and(|inset| command.fits(inset))
    }

    /// The command of a key now: of what is open within the view, or else of the view.
    pub(crate) fn command(&self, key: Key) -> Option<&'static Command> {
        let meant = |view: View| {
            let fits = |command: &&Command| command.fits(view) && self.keys.keys(command.name).contains(&key);
            self.commands.iter().find(fits)
        };
        self.inset().and_then(meant).or_else(|| meant(self.view))
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
        self.phase = 0.0;
    }

    /// The next frame of the motion that plays.
    pub(crate) fn advance(&mut self) {
        let ahead = self.phase + PACES[self.pace % PACES.len()];
        // Between the last position and the first one there is a way only where they close a cycle.
        let closed = self.scene.as_ref().is_some_and(Scene::closed);
        let whole =
            if ahead >= 1.0 || !closed && self.position + 1 == self.positions() { ahead.ceil() } else { 0.0 };
        if whole > 0.0 {
            self.step(PACES[self.pace % PACES.len()].max(1.0) as isize);
        } else {
            self.phase = ahead;
        }
    }

    /// The place in the motion as a number of a position, with a fraction between two of them.
    pub(crate) fn at(&self) -> f64 {
        self.position as f64 + self.phase
    }

    /// Goes to a position; a message if there is none of that number.
    pub(crate) fn go_to(&mut self, position: usize) {
        let last = self.positions() - 1;
        if position <= last {
            (self.position, self.phase) = (position, 0.0);
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

    /// The first line that is shown of the text of the view.
    pub(crate) fn line(&mut self) -> &mut usize {
        if self.view == View::Working { &mut self.chosen.equation } else { &mut self.chosen.line }
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
}
