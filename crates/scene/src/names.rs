//! Names of loads, which must be unique because reports refer to them.

use std::collections::BTreeSet;

use crate::error::Fault;
use crate::text::shown;
use crate::walk::Section;

/// The names used by loads that are already read.
#[derive(Debug, Default)]
pub(crate) struct LoadNames(BTreeSet<String>);

impl LoadNames {
    /// The `name` of a load, or its default name.
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
