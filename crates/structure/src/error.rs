//! Errors in decomposing a mechanism.

use assur_group::RegistryError;
use assur_mechanism::Name;
use assur_words::{Describe, Text, list, name, number, quantity, text};

use crate::Mobility;

/// A slide of two links in which a slide block may be missing: their pin moves along a slot, and the links turn on each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MissingBlock {
    /// The link that slides, to which the block would be pinned.
    pub link: Name,
    /// The link with the slot.
    pub on: Name,
    /// The point of the pin, where the slide names one.
    pub point: Option<Name>,
}

impl MissingBlock {
    /// What is said of it, as the rest of a sentence.
    fn text(&self) -> Text {
        let at = self.point.as_ref().map(|point| text!("structure-at-point", point = Text::from(point)));
        let [link, on] = [&self.link, &self.on].map(Text::from);
        text!("structure-missing-block", link, on, at = at.unwrap_or_default())
    }
}

/// Why a mechanism can't be decomposed into groups.
#[derive(Clone, PartialEq)]
pub enum StructureError {
    /// Some links can move while the input is fixed.
    Loose {
        /// The count.
        counted: Mobility,
        /// Number of inputs.
        inputs: usize,
        /// The links that are loose.
        links: Vec<String>,
        /// Pairs elsewhere of which one is surplus.
        surplus: Vec<String>,
        /// Two points of different links that stand in one link each, but have nearly the same name.
        alike: Option<Box<[String; 2]>>,
        /// Points of these links, and of the ground, that stand in no other link, by link.
        alone: Vec<String>,
    },
    /// The inputs before it already determine what an input drives.
    DependentInput {
        /// The count.
        counted: Mobility,
        /// Number of inputs.
        inputs: usize,
        /// The first such input.
        input: Box<Name>,
    },
    /// Some pairs constrain what is already fixed.
    Surplus {
        /// The count.
        counted: Mobility,
        /// Number of inputs.
        inputs: usize,
        /// Pairs of which one is surplus.
        pairs: Vec<String>,
        /// Links that they lock.
        links: Vec<String>,
        /// The slide in which a block may be missing.
        block: Option<Box<MissingBlock>>,
        /// Why no part of it is passive, as the rest of a sentence; may be empty.
        why: Box<Text>,
    },
    /// Slides alone hold a link at two different angles.
    SlideAngles {
        /// The last of these slides.
        slide: Box<Name>,
        /// What its angle misses, rad.
        off: f64,
        /// The `tilt` with which it would miss nothing, rad.
        tilt: f64,
        /// Links that they lock.
        links: Vec<String>,
    },
    /// A pin and a slide of a group join the same two links, which so can't move on each other, while others of the group are not held.
    Held {
        /// The pin.
        pin: Box<Name>,
        /// The slide.
        slide: Box<Name>,
    },
    /// No plugin solves a group.
    NoPlugin {
        /// Its links.
        links: Vec<String>,
        /// Its class.
        class: u8,
        /// Its order.
        order: u8,
        /// Its pairs by letter and name.
        pattern: Text,
    },
    /// The registry of groups is faulty.
    Registry(RegistryError),
}

impl StructureError {
    /// The first link concerned, if the error is about links.
    pub fn link(&self) -> Option<&str> {
        match self {
            Self::Loose { links, .. }
            | Self::Surplus { links, .. }
            | Self::SlideAngles { links, .. }
            | Self::NoPlugin { links, .. } => links.first().map(String::as_str),
            Self::DependentInput { .. } | Self::Held { .. } | Self::Registry(_) => None,
        }
    }
}

/// Most names that a message lists.
const MOST_NAMES: usize = 24;

/// The first of some names in their quotes, and how many there are.
fn some(names: &[String], quote: &str) -> Text {
    let first = names.iter().take(MOST_NAMES).map(|found| name(format!("{quote}{found}{quote}")));
    let first = list(first);
    if names.len() <= MOST_NAMES {
        return first;
    }
    text!("structure-some", names = first, shown = MOST_NAMES, total = names.len())
}

fn links_named(links: &[String]) -> Text {
    text!("structure-links-named", count = links.len(), links = some(links, "`"))
}

/// Surplus pairs beside loose links; empty without any.
fn also_surplus(pairs: &[String]) -> Text {
    if pairs.is_empty() { Text::default() } else { text!("structure-loose-also", pairs = some(pairs, "")) }
}

/// How loose links could be held: two points of names that look alike, or points that stand alone.
fn hint(alike: Option<&[String; 2]>, alone: &[String]) -> Text {
    match alike {
        None if alone.is_empty() => text!("structure-what-joins"),
        None => text!("structure-alone", points = some(alone, "")),
        Some(both) => {
            let [one, other] = both.clone().map(name);
            text!("structure-alike", one, other)
        }
    }
}

assur_words::errors!(StructureError; Registry(RegistryError));

impl Describe for StructureError {
    fn describe(&self) -> Text {
        match self {
            // A link alone is attached by one pair; several with all their points joined are held as in a chain of five links.
            Self::Loose { counted, inputs, links, surplus, alike: None, alone }
                if counted.value > i64::try_from(*inputs).unwrap_or(i64::MAX)
                    && (links.len() > 1 || *inputs > 1)
                    && surplus.is_empty()
                    && (alone.is_empty() || *inputs > 1) =>
            {
                text!(
                    "structure-more-inputs",
                    mobility = number(counted.value),
                    inputs = number(inputs),
                    formula = name(counted.formula()),
                    links = links_named(links)
                )
            }
            Self::Loose { counted, links, surplus, alike, alone, .. } => text!(
                "structure-loose",
                mobility = number(counted.value),
                formula = name(counted.formula()),
                links = links_named(links),
                count = links.len(),
                also = also_surplus(surplus),
                hint = hint(alike.as_deref(), alone)
            ),
            Self::DependentInput { counted, inputs, input } => text!(
                "structure-dependent-input",
                mobility = number(counted.value),
                formula = name(counted.formula()),
                inputs = number(inputs),
                input = Text::from(&**input)
            ),
            Self::Surplus { counted, inputs, pairs, links, block, why } => text!(
                "structure-surplus",
                inputs = number(inputs),
                mobility = number(counted.value),
                formula = name(counted.formula()),
                pairs = text!("structure-pairs", count = pairs.len(), pairs = some(pairs, "`")),
                count = pairs.len(),
                links = links_named(links),
                block = block.as_deref().map_or_else(Text::default, MissingBlock::text),
                cause = &**why
            ),
            Self::SlideAngles { slide, off, tilt, .. } => {
                let shown = |angle: &f64| quantity((angle.to_degrees() * 1e6).round() / 1e6, "deg");
                let slide = Text::from(&**slide);
                text!("structure-slide-angles", slide, off = shown(off), tilt = shown(tilt))
            }
            Self::Held { pin, slide } => {
                text!("structure-slide-on-pinned", slide = Text::from(&**slide), pin = Text::from(&**pin))
            }
            Self::NoPlugin { links, class, order, pattern } => text!(
                "structure-no-plugin",
                links = links_named(links),
                class = name(crate::roman(*class)),
                order = number(order),
                pattern
            ),
            Self::Registry(error) => error.describe(),
        }
    }
}
