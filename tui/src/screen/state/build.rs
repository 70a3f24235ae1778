//! Building a mechanism: what of the text can be read, what is chosen in the picture, and the task in hand.

use std::sync::Arc;

use assur_draft::Part;
use assur_group::PairSort;
use assur_mechanism::{GROUND, Key, Step};
use assur_sketch::{Addition, Closing, Sketch, Target};
use assur_words::{Text, name, text};

use super::State;
use super::kinds::View;
use super::picker::Entry;

/// Steps by which a key moves a point, m.
pub(crate) const MOVES: [f64; 3] = [1e-4, 1e-3, 1e-2];
/// The step at the start: 1 mm.
const FIRST_MOVE: usize = 1;

#[derive(Debug)]
pub(crate) struct Build {
    /// What was found in the text; `None` before the text is looked at.
    pub(crate) read: Option<Read>,
    pub(crate) chosen: Option<Part>,
    pub(crate) task: Task,
    /// Index in [`MOVES`].
    pub(crate) step: usize,
    /// Number of the fault that was visited last.
    pub(crate) fault: usize,
    /// First line of the file that is shown, while the user scrolls it.
    pub(crate) line: Option<usize>,
    /// Whether the mouse moves the chosen point since its button is down.
    pub(crate) dragged: bool,
}

impl Default for Build {
    fn default() -> Self {
        let (read, chosen, task) = (None, None, Task::default());
        Self { read, chosen, task, step: FIRST_MOVE, fault: 0, line: None, dragged: false }
    }
}

/// What is done now.
#[derive(Debug, Default)]
pub(crate) enum Task {
    /// Things are chosen in the picture.
    #[default]
    Choose,
    /// The chosen thing is moved by the arrow keys.
    Move,
    /// The outer pairs of a group are joined, one after the other.
    Join(Box<Join>),
    /// Parts go after a confirmation.
    Delete(Vec<Part>),
    Form(Box<FormTask>),
}

/// A group that is added.
#[derive(Debug)]
pub(crate) struct Join {
    pub(crate) addition: Addition,
    /// Where its outer pairs are joined, as far as that is known.
    pub(crate) targets: Vec<Target>,
    /// A name, or a place, that is typed.
    pub(crate) entry: Entry,
    /// The thing that is chosen, among those that can be.
    pub(crate) chosen: Option<Part>,
}

impl Join {
    pub(crate) fn of(addition: Addition) -> Self {
        Self { addition, targets: Vec::new(), entry: Entry::default(), chosen: None }
    }

    /// What the pair in hand can be joined to: points, of a slide links first.
    pub(crate) fn candidates(&self, sketch: &Sketch) -> Vec<Part> {
        let of = &sketch.mechanism;
        let points = || of.points.iter().map(|point| Part::Point(point.name.to_string()));
        let links = || of.links.iter().map(|link| Part::Link(link.name.to_string()));
        match self.pair() {
            Some(PairSort::Slide) => links().chain(points()).collect(),
            Some(_) => points().chain(links()).collect(),
            None => Vec::new(),
        }
    }

    /// The sort of the pair in hand; `None`: all are joined.
    pub(crate) fn pair(&self) -> Option<PairSort> {
        self.addition.outer().get(self.targets.len()).copied()
    }
}

/// What was read of a text.
#[derive(Debug)]
pub(crate) struct Read {
    pub(crate) text: Arc<str>,
    /// What of it makes a mechanism; `None`: nothing does.
    pub(crate) readable: Option<Arc<str>>,
    pub(crate) sketch: Sketch,
    pub(crate) faults: Vec<Faulty>,
    /// Changes of one number with which the mechanism could be assembled, where it can't; `None`: they were not looked for.
    pub(crate) closings: Option<Vec<Closing>>,
}

/// A fault, and the key where it stands.
#[derive(Debug, Clone)]
pub(crate) struct Faulty {
    pub(crate) text: Text,
    pub(crate) key: Option<Key>,
}

/// A form that is filled in.
#[derive(Debug, Default)]
pub(crate) struct FormTask {
    pub(crate) source: FormSource,
    pub(crate) heading: Text,
    pub(crate) rows: Vec<Row>,
    pub(crate) chosen: usize,
    /// What is typed into the chosen field.
    pub(crate) entry: Option<Entry>,
    /// Why what is typed is not taken.
    pub(crate) fault: Option<Text>,
    /// Whether the field has a step of its own already, which typing on amends.
    pub(crate) begun: bool,
    /// The forms from which it was opened, with the chosen field of each.
    pub(crate) above: Vec<(FormSource, usize)>,
}

/// What a form is about.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) enum FormSource {
    /// A table of the scene.
    Table(Key),
    /// The masses of all links.
    #[default]
    Masses,
    /// The rows of two numbers at a key.
    Rows(Key),
    /// The parts that a step has made, by name, and their numbers.
    Made(Vec<Part>, Vec<Key>),
}

/// A field of a form.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) label: String,
    /// What is in the field, or else what holds without it.
    pub(crate) value: String,
    /// Whether the value stands in the file.
    pub(crate) stands: bool,
    pub(crate) kind: RowKind,
}

#[derive(Debug, Clone)]
pub(crate) enum RowKind {
    Value(Box<assur_form::Field>),
    Name(Part),
}

impl FormTask {
    pub(crate) fn row(&self) -> Option<&Row> {
        self.rows.get(self.chosen)
    }

    pub(crate) fn field(&self) -> Option<&assur_form::Field> {
        match &self.row()?.kind {
            RowKind::Value(field) => Some(field),
            RowKind::Name(_) => None,
        }
    }
}

impl Build {
    /// The form that is open.
    pub(crate) fn form(&self) -> Option<&FormTask> {
        if let Task::Form(form) = &self.task { Some(form) } else { None }
    }

    pub(crate) fn form_mut(&mut self) -> Option<&mut FormTask> {
        if let Task::Form(form) = &mut self.task { Some(form) } else { None }
    }

    pub(crate) fn sketch(&self) -> Option<&Sketch> {
        self.read.as_ref().map(|read| &read.sketch)
    }

    /// The part that is lit: the chosen one, or the one that the field changes.
    pub(crate) fn lit(&self) -> Option<Part> {
        let of_field = |form: &FormTask| match &form.row()?.kind {
            RowKind::Name(part) => Some(part.clone()),
            RowKind::Value(field) => part_of(&field.key),
        };
        match &self.task {
            Task::Form(form) => of_field(form),
            Task::Join(_) => None,
            _ => self.chosen.clone(),
        }
    }

    /// Everything that can be chosen, in the order of the file.
    pub(crate) fn things(&self) -> Vec<Part> {
        let Some(sketch) = self.sketch() else { return Vec::new() };
        let of = &sketch.mechanism;
        let points = of.points.iter().map(|point| Part::Point(point.name.to_string()));
        let links = of.links.iter().skip(GROUND + 1).map(|link| Part::Link(link.name.to_string()));
        let slides = of.slides.iter().map(|slide| Part::Slide(slide.name.to_string()));
        points.chain(links).chain(slides).collect()
    }
}

/// Where a part is in the plane, m: a point, the middle of the points of a link, a point of a guide.
pub(crate) fn place(sketch: &Sketch, part: &Part) -> Option<[f64; 2]> {
    match part {
        Part::Point(point) => sketch.place(point),
        Part::Slide(slide) => {
            let of = sketch.mechanism.slides.iter().find(|of| of.name.as_str() == slide)?;
            Some(sketch.bodies[of.link]?.point(of.point))
        }
        Part::Link(link) => {
            let (id, pose) = (sketch.mechanism.link(link)?, sketch.pose(link)?);
            let places: Vec<_> = sketch.mechanism.points.iter().filter_map(|point| point.on(id)).collect();
            let count = places.len().max(1) as f64;
            let middle = [0, 1].map(|axis| places.iter().map(|at| at[axis]).sum::<f64>() / count);
            Some(pose.point(middle))
        }
        Part::Load(..) => None,
    }
}

/// What a part is, in words: `link rod`.
pub(crate) fn words_of(part: &Part) -> Text {
    let id = match part {
        Part::Link(_) => "build-link",
        Part::Point(_) => "build-point",
        Part::Slide(_) => "build-slide",
        Part::Load(..) => "build-table",
    };
    let own = match part {
        Part::Link(own) | Part::Point(own) | Part::Slide(own) => own.clone(),
        Part::Load(table, index) => format!("{table}[{index}]"),
    };
    text!(id, name = name(own))
}

/// The part whose number stands at a key.
fn part_of(key: &Key) -> Option<Part> {
    let named = |step: &Step| if let Step::Name(name) = step { Some(name.clone()) } else { None };
    match key.steps() {
        [Step::Name(table), link, points, point, ..] if table == "link" && *points == "points".into() => {
            Some(Part::Point(named(point)?)).or_else(|| named(link).map(Part::Link))
        }
        [Step::Name(table), points, point, ..] if table == "ground" && *points == "points".into() => {
            Some(Part::Point(named(point)?))
        }
        [Step::Name(table), link, ..] if table == "link" => Some(Part::Link(named(link)?)),
        [Step::Name(table), slide, ..] if table == "slide" => Some(Part::Slide(named(slide)?)),
        [Step::Name(table), point, ..] if table == "assembly" => Some(Part::Point(named(point)?)),
        _ => None,
    }
}

impl State {
    /// The group of the chosen link is that of the view of the structure as well.
    pub(crate) fn follow(&mut self) {
        if self.view != View::Build {
            return;
        }
        let (Some(Part::Link(link)), Some(scene)) = (&self.build.chosen, &self.scene) else { return };
        let found = scene.linkage.mechanism.link(link);
        let groups = &scene.linkage.structure.groups;
        let group = found.and_then(|link| groups.iter().position(|group| group.frame.links.contains(&link)));
        self.chosen.group = group.unwrap_or(self.chosen.group);
    }
}
