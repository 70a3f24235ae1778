//! Names that a scene can have.

use std::collections::BTreeSet;

use crate::Drawing;

/// Names that mean something else in a scene.
const TAKEN: [&str; 2] = ["ground", "moment"];
/// Longest name, in letters; a scene allows more, a reader does not.
const LONGEST: usize = 60;

/// Makes every name of a drawing one that a scene can have, and no name twice.
pub(crate) fn make_unique(drawing: &mut Drawing) {
    let mut seen: BTreeSet<String> = TAKEN.map(str::to_owned).into();
    let joints = drawing.joints.iter_mut().map(|joint| &mut joint.name);
    let links = drawing.links.iter_mut().map(|link| &mut link.name);
    let slides = drawing.slides.iter_mut().map(|slide| &mut slide.name);
    for name in joints.chain(links).chain(slides) {
        let plain = |letter: char| if letter.is_control() || letter == '.' { '_' } else { letter };
        let clean: String = name.trim().chars().map(plain).take(LONGEST).collect();
        let clean = if clean.is_empty() { "unnamed".to_owned() } else { clean };
        let numbered = (2..).map(|number| format!("{clean}-{number}"));
        let free = std::iter::once(clean.clone()).chain(numbered).find(|name| !seen.contains(name));
        *name = free.unwrap_or(clean);
        seen.insert(name.clone());
    }
}
