//! Names of loads: each is a name in reports, so that no two may be the same.

use std::collections::BTreeSet;

use crate::error::Fault;
use crate::text::shown;
use crate::walk::Section;

/// The names given so far.
#[derive(Debug, Default)]
pub(crate) struct LoadNames(BTreeSet<String>);

impl LoadNames {
    /// The `name` of a load, or the one made for it.
    pub(crate) fn read(&mut self, section: &Section<'_>, default: impl FnOnce() -> String) -> String {
        let entry = section.get("name");
        let given = entry.as_ref().and_then(|entry| entry.text("a name"));
        let name = given.map_or_else(default, str::to_owned);
        if !self.0.insert(name.clone()) {
            let span = entry.map_or(section.span.clone(), |entry| entry.span);
            let fault = Fault::new(span, format!("two loads have the name `{}`", shown(&name)));
            section.faults.push(fault.label("give this one a `name` of its own"));
        }
        name
    }
}
