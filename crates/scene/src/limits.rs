//! What a scene has at most of anything that takes memory.

use std::ops::Range;

use crate::error::{Fault, Faults};
use crate::walk::{Entry, Section};

/// A part of the scene that has a place.
pub(crate) trait Placed {
    /// Its place, and where faults are noted.
    fn place(&self) -> (Range<usize>, &Faults);
}

impl Placed for Entry<'_> {
    fn place(&self) -> (Range<usize>, &Faults) {
        (self.key.clone(), self.faults)
    }
}

impl Placed for Section<'_> {
    fn place(&self) -> (Range<usize>, &Faults) {
        (self.span.clone(), self.faults)
    }
}

/// Keeps the first parts of the scene, and notes at the first of the others that there are too many.
pub(crate) fn keep<T: Placed>(all: &mut Vec<T>, most: usize, what: &str) {
    keep_rest(all, 0, most, what);
}

/// As [`keep`], where some were read before.
pub(crate) fn keep_rest<T: Placed>(all: &mut Vec<T>, before: usize, most: usize, what: &str) {
    let room = most.saturating_sub(before);
    if let Some(first) = all.get(room) {
        let (span, faults) = first.place();
        faults
            .push(Fault::new(span, format!("a scene has at most {most} {what}")).label("leave out the rest"));
    }
    all.truncate(room);
}
