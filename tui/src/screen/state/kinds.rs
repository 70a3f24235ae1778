//! What can be shown and chosen.

/// A view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum View {
    Menu,
    Mechanism,
    Curves,
    Forces,
    Plans,
    Motion,
    Drive,
    Checks,
    Accuracy,
    Structure,
    Table,
    /// The list of the scene's numbers below any of the others but the menu.
    Values,
}

use View::{
    Accuracy, Checks, Curves, Drive, Forces, Mechanism, Menu, Motion, Plans, Structure, Table, Values,
};

impl View {
    /// Every view of a scene, in the order of the tabs.
    pub(crate) const OF_SCENE: [Self; 10] =
        [Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Accuracy, Structure, Table];
    /// The views of a scene in which Home, End and the page keys change the position.
    pub(crate) const WITHOUT_PAGES: [Self; 9] =
        [Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Structure, Table];

    /// All views.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        [Menu, Values].into_iter().chain(Self::OF_SCENE)
    }

    /// The name on its tab, and the command that goes to it.
    fn names(self) -> [&'static str; 2] {
        match self {
            Menu => ["Scenes", "menu"],
            Mechanism => ["Mechanism", "mechanism"],
            Curves => ["Curves", "curves"],
            Forces => ["Forces", "forces"],
            Plans => ["Plans", "plans"],
            Motion => ["Motion", "motion"],
            Drive => ["Drive", "drive"],
            Checks => ["Checks", "checks"],
            Accuracy => ["Methods", "accuracy"],
            Structure => ["Groups", "structure"],
            Table => ["Table", "table"],
            Values => ["What if", "what-if"],
        }
    }

    /// The name on its tab.
    pub(crate) fn name(self) -> &'static str {
        self.names()[0]
    }

    /// The command that goes to it.
    pub(crate) fn command(self) -> &'static str {
        self.names()[1]
    }
}

/// Which plan is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PlanKind {
    Forces,
    Velocity,
    Acceleration,
    Construction,
}

/// The parts of a view that has several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pane {
    Table,
    /// Only in the view of the forces.
    Causes,
    Curves,
    Hodograph,
}

/// Which arrows the drawing has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Arrows {
    None,
    Velocity,
    Acceleration,
    Both,
}

/// Which paths of points the drawing has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Traces {
    All,
    Chosen,
    None,
}

/// The element of a list after the given one; the first one after the last.
pub(crate) fn following<T: Copy + PartialEq>(all: &[T], now: T) -> T {
    let index = all.iter().position(|one| *one == now).map_or(0, |index| (index + 1) % all.len());
    all.get(index).copied().unwrap_or(now)
}

/// The index shifted by `by` in a list of this length, cyclically.
pub(crate) fn round(now: usize, by: isize, count: usize) -> usize {
    let count = isize::try_from(count.max(1)).unwrap_or(isize::MAX);
    usize::try_from((isize::try_from(now).unwrap_or(0) + by).rem_euclid(count)).unwrap_or(0)
}

/// The help screen.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Help {
    pub(crate) scroll: usize,
    pub(crate) filter: String,
}

/// What the one-line input is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PromptKind {
    Command,
    Search,
}

/// The one-line input for `:` and `/` while it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Prompt {
    pub(crate) kind: PromptKind,
    pub(crate) text: String,
    /// Number of the completion inserted by Tab, and the text that was typed before.
    pub(crate) completing: Option<(usize, String)>,
}

/// What is chosen in each view.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Chosen {
    /// Index in the scene's transfer functions.
    pub(crate) transfer: usize,
    pub(crate) group: usize,
    /// Index in the reactions found.
    pub(crate) reaction: usize,
    pub(crate) check: usize,
    /// Group whose force polygon is drawn; the last is the input link.
    pub(crate) polygon: usize,
    /// First vector in the list of a plan of velocities or accelerations.
    pub(crate) vector: usize,
    /// Last step of the construction that is drawn.
    pub(crate) step: usize,
    /// First quantity of the motion view.
    pub(crate) motion: usize,
    /// First line of the report on the methods.
    pub(crate) line: usize,
    /// Column of the table.
    pub(crate) column: usize,
}
