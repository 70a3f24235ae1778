//! Names of the scene as texts.

use assur_mechanism::{LinkId, Mechanism};
use assur_words::{Text, joined, list, name, text};

/// The name of the fixed link in every scene.
const GROUND: &str = "ground";

/// A name of a link, or of a pair that the program made of names of links (`ram/ground`): as it is in the scene, but for the
/// ground.
pub fn named(letters: &str) -> Text {
    let part = |part: &str| if part == GROUND { text!("mechanism-ground") } else { name(part.to_owned()) };
    joined("/", letters.split('/').map(part))
}

/// The name of a link.
pub fn link_name(mechanism: &Mechanism, link: LinkId) -> Text {
    mechanism.links.get(link).map_or_else(Text::default, |link| Text::from(&link.name))
}

/// Names with commas between them.
pub fn listed<'n>(names: impl IntoIterator<Item = &'n str>) -> Text {
    list(names.into_iter().map(named))
}
