//! Names of new links and points.

use std::collections::HashSet;

use assur_mechanism::Mechanism;
use assur_words::{Text, text};

use crate::Names;
use crate::shape::{Shape, quoted};

/// Names that are taken.
pub(crate) struct Taken {
    links: HashSet<String>,
    points: HashSet<String>,
    /// Number of the next link in the file.
    next: usize,
}

impl Taken {
    pub(crate) fn of(mechanism: &Mechanism) -> Self {
        let slides = mechanism.slides.iter().map(|slide| slide.name.to_string());
        Self {
            links: mechanism
                .links
                .iter()
                .map(|link| link.name.to_string())
                .chain(["moment".to_owned()])
                .collect(),
            points: mechanism.points.iter().map(|point| point.name.to_string()).chain(slides).collect(),
            next: mechanism.links.len(),
        }
    }

    /// The names of the new links: `rod3`, `stone4`, `block5`, with the number of the link in the file.
    pub(crate) fn links(&mut self, shape: &Shape, names: &Names) -> Result<Vec<String>, Text> {
        let first = self.next;
        let name = |link: usize| {
            if let Some(given) = given(&names.links, link) {
                return take(&mut self.links, given)
                    .ok_or_else(|| text!("sketch-link-taken", name = quoted(given)));
            }
            let sort = match (shape.pins(link).count(), shape.is_slider(link)) {
                (1, true) => "stone",
                (0, _) if !shape.bonds.is_empty() => "block",
                _ => "rod",
            };
            let free = (first + link..).find_map(|number| take(&mut self.links, &format!("{sort}{number}")));
            free.ok_or_else(Text::default)
        };
        (0..shape.links).map(name).collect()
    }

    /// The name of a new point: the next free letter, then A1 and so on.
    pub(crate) fn point(&mut self, names: &Names, index: usize) -> Result<String, Text> {
        if let Some(given) = given(&names.points, index) {
            return take(&mut self.points, given)
                .ok_or_else(|| text!("sketch-point-taken", name = quoted(given)));
        }
        let letters = || ('A'..='Z').map(String::from);
        let numbered = (1..).flat_map(|number| letters().map(move |letter| format!("{letter}{number}")));
        letters().chain(numbered).find_map(|name| take(&mut self.points, &name)).ok_or_else(Text::default)
    }
}

/// The name that the caller gives, if any.
fn given(names: &[String], index: usize) -> Option<&str> {
    names.get(index).map(|name| name.trim()).filter(|name| !name.is_empty())
}

/// Takes a name that is free.
fn take(taken: &mut HashSet<String>, name: &str) -> Option<String> {
    taken.insert(name.to_owned()).then(|| name.to_owned())
}
