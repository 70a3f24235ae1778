//! What can be shown and chosen.

use assur_picture::{Picture, ViewPart};
use assur_words::{Language, Text, text};
use strum::{EnumString, IntoStaticStr, VariantArray};

#[derive(
    Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, IntoStaticStr, EnumString, VariantArray,
)]
#[strum(serialize_all = "kebab-case")]
pub(crate) enum View {
    #[default]
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
    Working,
    /// The drawing sheet with its fields.
    Sheet,
    /// The results that are asked for first.
    Results,
    /// The list of the scene's numbers below any other view.
    #[strum(serialize = "what-if")]
    Values,
    /// The point that is moved over the drawing of the mechanism.
    Probe,
    /// The mechanism while it is built; it has no tab.
    Build,
}

use View::{
    Accuracy, Checks, Curves, Drive, Forces, Mechanism, Motion, Plans, Results, Sheet, Structure, Table,
    Working,
};

impl View {
    /// Every view that has a tab, in the order of the tabs.
    pub(crate) const TABS: [Self; 13] = [
        Results, Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Accuracy, Structure, Table,
        Working, Sheet,
    ];
    /// Every view of a scene that is shown or built.
    pub(crate) const OPEN: [Self; 14] = [
        Results,
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
        Working,
        Sheet,
        Self::Build,
    ];
    /// The views in which Home, End and the page keys change the position.
    pub(crate) const WITHOUT_PAGES: [Self; 10] =
        [Results, Mechanism, Curves, Forces, Plans, Motion, Drive, Checks, Structure, Table];

    pub(crate) fn command(self) -> &'static str {
        self.into()
    }

    pub(crate) fn name(self) -> Text {
        text!(match self {
            Mechanism => "view-mechanism",
            Curves => "view-curves",
            Forces => "view-forces",
            Plans => "view-plans",
            Motion => "view-motion",
            Drive => "view-drive",
            Checks => "view-checks",
            Accuracy => "view-accuracy",
            Structure => "view-structure",
            Table => "view-table",
            Working => "view-working",
            Sheet => "view-sheet",
            Results => "view-results",
            Self::Values => "view-what-if",
            Self::Probe => "view-probe",
            Self::Build => "view-build",
        })
    }

    pub(crate) fn short_name(self, language: &Language) -> String {
        let short = language.own(&format!("view-{}.short", self.command()));
        short.unwrap_or_else(|| self.name().render(language))
    }

    /// Its picture, of a view that has one of the results.
    pub(crate) fn picture(self) -> Option<Picture> {
        self.command().parse().ok()
    }

    /// Its parts, the one that is shown first in front; none if it is one whole.
    pub(crate) fn parts(self) -> &'static [ViewPart] {
        self.picture().map_or(&[], Picture::parts)
    }
}

/// The element of a list after the given one; the first one after the last.
pub(crate) fn following<T: Copy + PartialEq>(all: &[T], now: T) -> T {
    let index = all.iter().position(|one| *one == now).map_or(0, |index| (index + 1) % all.len());
    all.get(index).copied().unwrap_or(now)
}

pub(crate) fn next_kind<T: Copy + PartialEq + VariantArray>(now: T) -> T {
    following(T::VARIANTS, now)
}

/// The index shifted by `by` in a list of this length, cyclically.
pub(crate) fn round(now: usize, by: isize, count: usize) -> usize {
    let count = isize::try_from(count.max(1)).unwrap_or(isize::MAX);
    usize::try_from((isize::try_from(now).unwrap_or(0) + by).rem_euclid(count)).unwrap_or(0)
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Chosen {
    /// Index in the scene's transfer functions.
    pub(crate) transfer: usize,
    pub(crate) group: usize,
    /// A mode of a group in the first position that is looked at: group and index.
    pub(crate) mode: Option<[usize; 2]>,
    pub(crate) reaction: usize,
    pub(crate) check: usize,
    pub(crate) result: usize,
    /// Group whose force polygon is drawn; the last is the input link.
    pub(crate) polygon: usize,
    /// First vector that is shown of a plan, or first line of the chosen group, where not all have room.
    pub(crate) row: usize,
    /// Last step of the construction that is drawn.
    pub(crate) step: usize,
    pub(crate) motion: usize,
    /// Index in the events of the cycle.
    pub(crate) event: usize,
    pub(crate) line: usize,
    pub(crate) equation: usize,
    pub(crate) column: usize,
    /// Row of the list of fields of the sheet.
    pub(crate) field: usize,
    /// Number of the sheet, of several.
    pub(crate) sheet: usize,
}
