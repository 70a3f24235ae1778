//! Everything on which a frame depends. Commands change it, views read it; nothing here draws or knows a command by
//! name.

mod build;
mod draft;
mod job;
mod keymap;
mod kinds;
mod look;
mod picker;
mod scene;
mod sheet;
mod shown;
mod subsequence;

use std::cell::RefCell;
use std::collections::BTreeMap;

use assur_analysis::Options;
use assur_analysis::results::Column;
use assur_figure::Figure;
use assur_words::{Language, Text, number, text};
use ratatui::layout::Rect;

pub(crate) use crate::session::Source;
pub(crate) use assur_figure::Zoom;
pub(crate) use assur_figure::cells::Marker;
pub(crate) use assur_picture::{
    Arrows, Compared, Found, Probe, Reaction, Series, Traces, ViewPart, coordinate_unit,
};
pub(crate) use build::{
    Build, Faulty, FormSource, FormTask, Join, MOVES, Read, Row, RowKind, Task, place, words_of,
};
pub(crate) use draft::{Assembled, Change, Draft, Reading, Recovered, STEPS};
pub(crate) use job::{
    CalculationRequest, Cancel, Effect, Job, Measured, Outcome, OutputFile, Purpose, Question, Report,
    Running, Wanted,
};
pub(crate) use keymap::{Command, Group, Key, Keymap};
pub(crate) use kinds::{Chosen, View, following, next_kind, round};
pub(crate) use look::{Kind, Look, Panels, Pictures, Role, SETTINGS, Theme};
pub(crate) use picker::{Choice, Entry, Help, LONGEST, Picker, PickerKind, Prompt, PromptKind};
pub(crate) use scene::Scene;
pub(crate) use shown::Stop;

/// Greatest number of frames from a position to the next one.
pub(crate) const FRAMES: u8 = 16;
/// Parts of the way to the next position, in [`FRAMES`], by which a frame of the motion goes on.
pub(crate) const PACES: [u8; 7] = [1, 2, 4, 8, 16, 32, 64];
/// The pace at the start: every position once.
const EVERY: usize = 4;

#[derive(Debug, Default)]
pub(crate) struct State {
    pub(crate) commands: &'static [Command],
    pub(crate) keys: Keymap,
    pub(crate) scene: Option<Scene>,
    pub(crate) draft: Draft,
    pub(crate) build: Build,
    /// Step of the tour, from 0, and what it says.
    pub(crate) tour: Option<(usize, Text)>,
    pub(crate) measured: Option<Box<Measured>>,
    pub(crate) picker: Option<Picker>,
    /// The shipped scenes that were read for their pictures, by name.
    pub(crate) previews: BTreeMap<&'static str, Result<Box<Scene>, Text>>,
    pub(crate) view: View,
    /// The other views that are shown beside it where there is room.
    pub(crate) panels: Panels,
    pub(crate) position: usize,
    /// How many [`FRAMES`] the motion has gone from this position towards the next one; 0 unless it plays.
    pub(crate) phase: u8,
    /// Index in [`PACES`].
    pub(crate) pace: usize,
    pub(crate) chosen: Chosen,
    /// Short names of the quantities on the chart; none: PF0, PF1, PF2 of the chosen point, link or slide.
    pub(crate) picked: Vec<String>,
    /// How many groups are joined to the input link in the drawing of the structure; `None`: all.
    pub(crate) joined: Option<usize>,
    /// The position whose plan stays beside that of the present one.
    pub(crate) held: Option<usize>,
    pub(crate) probe: Option<Probe>,
    /// Power (W) and greatest speed (rad/s) for which motors are listed; `None`: those of the scene.
    pub(crate) motor_limits: Option<[f64; 2]>,
    pub(crate) look: Look,
    pub(crate) zoom: Zoom,
    pub(crate) pictures: Pictures,
    /// The figures of the last frame that are shown as pictures, with their places.
    pub(crate) shown: RefCell<Vec<(Figure, Rect)>>,
    pub(crate) sheets: RefCell<sheet::Kept>,
    pub(crate) arrows: Arrows,
    pub(crate) traces: Traces,
    /// The part of each view that is shown; the first one where there is none.
    pub(crate) parts: BTreeMap<View, ViewPart>,
    /// Where the user was before, the last place at the end.
    pub(crate) trail: Vec<Stop>,
    /// The place in another scene to which the user goes back as soon as that scene is read.
    pub(crate) going_back: Option<Stop>,
    pub(crate) searched: String,
    /// The extreme that was shown last: its quantity, the position that is near, and its place on the curve.
    pub(crate) extreme: Option<(Column, usize, f64)>,
    pub(crate) options: Options,
    pub(crate) compared: Option<Compared>,
    pub(crate) running: Vec<Running>,
    pub(crate) asked: usize,
    /// Column by which the table is sorted, and whether ascending.
    pub(crate) sorted: Option<(usize, bool)>,
    pub(crate) playing: bool,
    pub(crate) focused: bool,
    pub(crate) help: Option<Help>,
    pub(crate) prompt: Option<Prompt>,
    /// What is done only after confirmation.
    pub(crate) question: Option<Question>,
    /// Unsaved changes of programs that have died, which were not offered yet.
    pub(crate) recovered: Vec<Recovered>,
    /// A message, shown until the next key.
    pub(crate) message: Option<(Role, Text)>,
    /// Errors of a file that could not be used, under a title, shown until the next key.
    pub(crate) fault: Option<(Text, Text)>,
    pub(crate) size: (u16, u16),
    pub(crate) effects: Vec<Effect>,
    pub(crate) leaving: bool,
}

impl State {
    /// Asks the worker to read a scene.
    pub(crate) fn read(&mut self, wanted: Wanted) {
        self.effects.push(Effect::Work(Job::Read(wanted)));
    }

    /// The state at the start: the menu, or a scene.
    pub(crate) fn new(scene: Option<Scene>, look: Look, commands: &'static [Command], keys: Keymap) -> Self {
        Self {
            commands,
            keys,
            draft: Draft::of(scene.as_ref()),
            position: scene.as_ref().map_or(0, |scene| scene.first_position()),
            scene,
            look,
            pace: EVERY,
            focused: true,
            size: (80, 24),
            ..Self::default()
        }
    }

    pub(crate) fn found(&self) -> Option<&Found> {
        self.scene.as_ref()?.found.as_deref()
    }

    /// The language that is asked for, or else that of the scene's note; on a screen of ASCII, English.
    pub(crate) fn language(&self) -> &'static Language {
        let of_scene = || Language::find(self.scene.as_ref()?.session.note.language?);
        let asked = Language::find(self.look.language).or_else(of_scene);
        asked.filter(|_| !self.look.ascii).unwrap_or_else(Language::english)
    }

    pub(crate) fn told(&self, text: impl Into<Text>) -> String {
        let told = text.into().render(self.language());
        if self.look.ascii { assur_words::latin(&told).into_owned() } else { told }
    }

    /// Whether figures are shown as pictures now: not below a list or a text that is open.
    pub(crate) fn shows_pictures(&self) -> bool {
        let covered = self.help.is_some() || self.picker.is_some() || self.fault.is_some();
        self.look.pixels && !covered && matches!(self.pictures, Pictures::Kitty | Pictures::Iterm)
    }

    /// A second scene; not the open one before its numbers were changed.
    pub(crate) fn second(&self) -> Option<&Compared> {
        self.compared.as_ref().filter(|compared| !compared.before)
    }

    /// Whether keys belong to building: nothing lies over it.
    pub(crate) fn builds(&self) -> bool {
        self.view == View::Build && self.picker.is_none() && self.help.is_none() && self.prompt.is_none()
    }

    pub(crate) fn measuring(&self) -> Option<&Running> {
        self.running.iter().find(|running| running.purpose == Purpose::Measurement)
    }

    pub(crate) fn analyzing(&self) -> Option<&Running> {
        self.running.iter().find(|running| running.purpose != Purpose::Measurement)
    }

    pub(crate) fn values_open(&self) -> bool {
        self.draft.open && self.scene.is_some()
    }

    /// What is open within the view and takes keys before it.
    pub(crate) fn inset(&self) -> Option<View> {
        let probe = self.probe.as_ref().filter(|_| self.view == View::Mechanism).map(|_| View::Probe);
        Some(View::Values).filter(|_| self.values_open()).or(probe)
    }

    pub(crate) fn named(&self, name: &str) -> Option<&'static Command> {
        self.commands.iter().find(|command| command.name == name)
    }

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

    pub(crate) fn animates(&self) -> bool {
        self.playing && self.focused && self.scene.is_some()
    }

    /// Number of positions; 1 without a scene.
    pub(crate) fn positions(&self) -> usize {
        self.scene.as_ref().map_or(1, |scene| scene.positions()).max(1)
    }

    pub(crate) fn step(&mut self, by: isize) {
        self.position = round(self.position, by, self.positions());
        self.phase = 0;
    }

    pub(crate) fn advance(&mut self) {
        // Between the last position and the first one there is a way only where they close a cycle.
        let closed = self.scene.as_ref().is_some_and(|scene| scene.is_cycle());
        let end = !closed && self.position + 1 == self.positions();
        let ahead = if end { FRAMES } else { self.phase + PACES[self.pace % PACES.len()] };
        if ahead >= FRAMES {
            self.step(isize::from(ahead / FRAMES));
        }
        self.phase = ahead % FRAMES;
    }

    /// How far the motion has gone from the present position to the next one, from 0 to 1.
    pub(crate) fn part_way(&self) -> f64 {
        f64::from(self.phase) / f64::from(FRAMES)
    }

    pub(crate) fn pictured(&self) -> assur_picture::Look<'_> {
        let Chosen { transfer, group, reaction, polygon, step, motion, event, column, .. } = self.chosen;
        assur_picture::Look {
            position: self.position,
            part: self.part_way(),
            transfer,
            group,
            mode: self.mode_of(group),
            reaction,
            polygon,
            step,
            motion,
            event,
            column,
            picked: &self.picked,
            arrows: self.arrows,
            alone: false,
            traces: self.traces,
            // While the structure is put together.
            joined: self.joined.filter(|_| self.view == View::Structure),
            held: self.held,
            probe: self.probe.as_ref(),
            compared: self.compared.as_ref(),
            calculating: self.running.iter().any(|running| running.purpose == Purpose::Difference),
        }
    }

    /// The place in the motion as a number of a position, with a fraction between two of them.
    pub(crate) fn at(&self) -> f64 {
        self.position as f64 + self.part_way()
    }

    /// Goes to a position; a message if there is none of that number.
    pub(crate) fn go_to(&mut self, position: usize) {
        let last = self.positions() - 1;
        if position <= last {
            (self.position, self.phase) = (position, 0);
        } else {
            self.say(Role::Bad, text!("say-no-position", position = number(position), last = number(last)));
        }
    }

    /// The mode of a group that is looked at, by its index; only in the first position.
    pub(crate) fn mode_of(&self, group: usize) -> Option<usize> {
        let of_group = self.chosen.mode.filter(|[of, _]| *of == group && self.at() == 0.0);
        of_group.map(|[_, index]| index)
    }

    pub(crate) fn line(&mut self) -> &mut usize {
        if self.view == View::Working { &mut self.chosen.equation } else { &mut self.chosen.line }
    }

    pub(crate) fn open_prompt(&mut self, kind: PromptKind, text: impl AsRef<str>) {
        self.prompt = Some(Prompt { kind, text: text.as_ref().into(), completing: None });
    }

    pub(crate) fn entry(&self) -> Option<&Entry> {
        let line = self.prompt.as_ref().map(|prompt| &prompt.text);
        let help = self.help.as_ref().map(|help| &help.filter.text);
        line.or(help).or(self.picker.as_ref().map(|picker| &picker.filter.text))
    }

    pub(crate) fn say(&mut self, role: Role, text: Text) {
        self.message = Some((role, text));
    }
}
