//! The drawing sheet of the scene that is shown.

use std::sync::Arc;

use assur_scene::{SHEET_FIELDS, SheetField};
use assur_sheet::Page;
use assur_words::Text;

use super::State;

/// The sheets of a scene, or why there are none.
pub(crate) type Sheets = Arc<Result<Vec<Page>, Text>>;

/// The sheets that were made last, with the text and the language that they are of, and whether the analysis was done.
pub(crate) type Kept = Option<((Arc<str>, &'static str, bool), Sheets)>;

impl State {
    /// All fields in the order of the sheet, then those that it leaves out, each with whether it is taken; `None` without a scene.
    pub(crate) fn sheet_fields(&self) -> Option<Vec<(SheetField, bool)>> {
        let scene = self.scene.as_ref()?;
        // A change that is not read yet counts: the next key may come before.
        let newer = (**self.draft.text() != *scene.session.text)
            .then(|| assur_scene::read_with_note("", self.draft.text()).ok())
            .flatten();
        let taken = assur_sheet::wanted(newer.as_ref().map_or(&scene.session.note, |(_, note)| note));
        let others = SHEET_FIELDS.iter().map(|(_, field)| *field).filter(|field| !taken.contains(field));
        let others: Vec<_> = others.map(|field| (field, false)).collect();
        Some(taken.into_iter().map(|field| (field, true)).chain(others).collect())
    }

    /// The sheets of the scene, which are made once; `None` without a scene.
    pub(crate) fn sheets(&self) -> Option<Sheets> {
        let scene = self.scene.as_ref()?;
        let key = (Arc::clone(&self.draft.shown), self.language().code, scene.found.is_some());
        let mut kept = self.sheets.borrow_mut();
        if let Some((known, sheets)) = &*kept
            && *known == key
        {
            return Some(Arc::clone(sheets));
        }
        let made = Arc::new(assur_sheet::sheet(scene, &scene.session.note, self.language()));
        *kept = Some((key, Arc::clone(&made)));
        Some(made)
    }
}
