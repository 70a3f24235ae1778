//! Names of the scene as texts.

use assur_mechanism::{LinkId, Mechanism};
use assur_words::Text;

/// The name of a link.
pub fn link_name(mechanism: &Mechanism, link: LinkId) -> Text {
    mechanism.links.get(link).map_or_else(Text::default, |link| Text::from(&link.name))
}
