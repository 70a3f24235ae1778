//! What can be added to a mechanism: the registered kinds of groups, and three things that are no groups.

use assur_group::PairSort::{Any, Pin, Slide};
use assur_group::{GroupPlugin, PairSort, Pattern, RegistryError, groups};
use assur_mechanism::Key;
use assur_words::{Text, name, text};

/// A link that nothing holds.
const FREE_LINK: Pattern = Pattern { links: 1, inner: &[], outer: &[] };
/// A link with two pins.
const ROD: Pattern = Pattern { links: 1, inner: &[], outer: &[(0, Pin), (0, Pin)] };
/// A link that slides.
const BLOCK: Pattern = Pattern { links: 1, inner: &[], outer: &[(0, Slide)] };

/// Something that can be added to a mechanism.
#[derive(Debug, Clone)]
pub struct Addition {
    /// Stable identifier: `rrr`, `free-link`, `rod`, `block`.
    pub name: &'static str,
    /// What people read: `RRR`.
    pub title: Text,
    /// Description in one line.
    pub about: Text,
    /// Its links and pairs.
    pub pattern: Pattern,
    /// The registered kind; `None` of what is no group.
    pub plugin: Option<&'static GroupPlugin>,
    /// The sort of each pair, first of the inner, then of the outer ones, as in the pattern. Where that allows either sort it is chosen
    /// here, and a pin at first.
    pub sorts: Vec<PairSort>,
}

/// All that can be added: the registered kinds that have a pattern, those of few links first, then a free link, a rod between two points,
/// a block in a slot.
///
/// # Errors
///
/// [`RegistryError`] if two kinds have one name.
pub fn additions() -> Result<Vec<Addition>, RegistryError> {
    let of_kind = |plugin: &'static GroupPlugin| {
        let pattern = plugin.pattern.filter(|pattern| pattern.links > 0)?;
        let (title, about) = (name(plugin.kind), plugin.summary.clone());
        Some(Addition::new(plugin.name, [title, about], pattern, Some(plugin)))
    };
    let mut all: Vec<_> = groups()?.into_iter().filter_map(of_kind).collect();
    // Types of one class in their order, kinds without a number after them.
    all.sort_by_key(|one| (one.pattern.links, one.plugin.map_or(0, |plugin| plugin.number).wrapping_sub(1)));
    all.push(Addition::new(
        "free-link",
        [text!("sketch-free-link"), text!("sketch-free-link.about")],
        FREE_LINK,
        None,
    ));
    all.push(Addition::new("rod", [text!("sketch-rod"), text!("sketch-rod.about")], ROD, None));
    all.push(Addition::new("block", [text!("sketch-block"), text!("sketch-block.about")], BLOCK, None));
    Ok(all)
}

impl Addition {
    fn new(
        name: &'static str,
        [title, about]: [Text; 2],
        pattern: Pattern,
        plugin: Option<&'static GroupPlugin>,
    ) -> Self {
        let sorts =
            pattern.inner.iter().map(|(_, sort)| *sort).chain(pattern.outer.iter().map(|(_, sort)| *sort));
        let sorts = sorts.map(|sort| if sort == Any { Pin } else { sort }).collect();
        Self { name, title, about, pattern, plugin, sorts }
    }

    /// The sorts of its outer pairs, for each of which [`add`](crate::add) wants a target.
    pub fn outer(&self) -> &[PairSort] {
        self.sorts.get(self.pattern.inner.len()..).unwrap_or_default()
    }
}

/// What an outer pair joins.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// A named point, which becomes a pin, or one of more links.
    Point(String),
    /// A new point of a link, which becomes a pin.
    New {
        /// The link, or `ground`.
        link: String,
        /// Its place in the plane in the position that is drawn, m.
        at: [f64; 2],
    },
    /// The guide line of a slide.
    Guide {
        /// The link that carries it, or `ground`.
        link: String,
        /// A point of it in the plane in the position that is drawn, m.
        through: [f64; 2],
        /// Its direction in the plane there, rad.
        angle: f64,
        /// A named point of the link on the line, in the place of `through`.
        point: Option<String>,
    },
}

/// Names of new links and points in the order in which they are made; what is empty or left out is named by rule.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Names {
    /// Of the links, in the order of the pattern.
    pub links: Vec<String>,
    /// Of the points: inner pins, new points at outer pairs, points of links without a pin.
    pub points: Vec<String>,
}

/// A scene to which something was added.
#[derive(Debug, Clone)]
pub struct Added {
    /// The text of the scene.
    pub text: String,
    /// The new links, in the order of the pattern.
    pub links: Vec<String>,
    /// The new points: inner pins, new points at outer pairs, points of links without a pin.
    pub points: Vec<String>,
    /// The new slides.
    pub slides: Vec<String>,
    /// The numbers that were written: lengths, then other coordinates of links, new points of links that stood, slides.
    pub fields: Vec<Key>,
    /// How it moves.
    pub fit: Fit,
    /// The link that carries all of several outer pairs, so that what was added is rigid with it; `ground` is one too.
    pub rigid_with: Option<String>,
}

/// How far a mechanism can be assembled with what was added.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fit {
    /// Not in the position that is drawn.
    Nowhere,
    /// In the position that is drawn.
    Here,
    /// In all positions.
    Everywhere,
}
