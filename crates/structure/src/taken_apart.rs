//! A mechanism decomposed into its pairs and groups.

use assur_group::{GroupFrame, GroupPlugin, Pair, SeenPair};
use assur_mechanism::{LinkId, Mechanism, Name, PairId, PointId};
use assur_words::{Text, joined, list, name, text};

/// A mechanism decomposed into its pairs and groups.
#[derive(Debug, Clone)]
pub struct Structure {
    /// Mobility by Chebyshev's formula.
    pub mobility: Mobility,
    /// All kinematic pairs (a joint of k links gives k - 1), first those that are driven, in the order of the scene.
    pub pairs: Vec<NamedPair>,
    /// The groups in solving order.
    pub groups: Vec<Group>,
    /// What repeats constraints of others and is left out of the groups, in the order in which its links are placed.
    pub passive: Vec<Passive>,
    /// Where the passive parts need points in the first position, m: those of groups that `[assembly]` leaves free. Empty where the
    /// first mode of each group is theirs.
    pub placed: Vec<(PointId, [f64; 2])>,
    /// The modes of groups, by index, that the passive parts need where the modes meet in the first position, so that no place of a point
    /// tells them apart.
    pub ways: Vec<(usize, u8)>,
    /// Number of links, the ground included.
    pub links: usize,
    /// A typical length of the mechanism, m.
    pub scale: f64,
    /// Structural formula: `I(ground,crank) -> II3(stone2,rocker)`.
    pub formula: Name,
}

/// Mobility by Chebyshev's formula, W = 3 n - 2 p.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mobility {
    /// n, moving links.
    pub moving_links: usize,
    /// p, pairs of one degree of freedom.
    pub pairs: usize,
    /// W.
    pub value: i64,
}

impl Mobility {
    /// The calculation of W: `3*5 - 2*7`.
    pub fn formula(&self) -> String {
        format!("3*{} - 2*{}", self.moving_links, self.pairs)
    }
}

/// A kinematic pair and the pin or slide of the scene that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NamedPair {
    /// Bodies and geometry; `pair.id` is the index of this pair.
    pub pair: Pair,
    /// The pin or slide of the scene.
    pub source: PairId,
}

/// One group of a mechanism.
#[derive(Debug, Clone)]
pub struct Group {
    /// Links and pairs.
    pub frame: GroupFrame,
    /// The registered kind.
    pub plugin: &'static GroupPlugin,
    /// Class (2 for a dyad).
    pub class: u8,
    /// Order: number of outer pairs.
    pub order: u8,
}

/// A link, or a pair of a link, that may be left out of a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PassivePart {
    /// A link with all its pairs.
    Link(LinkId),
    /// The pair that holds this link: of a slide the sliding link.
    Pair(PairId, LinkId),
}

impl PassivePart {
    /// The part in words: `link rod3`.
    pub fn words(self, mechanism: &Mechanism) -> Text {
        match self {
            Self::Link(link) => text!("structure-passive-link", link = &mechanism.named_link(link)),
            Self::Pair(pair, link) => text!(
                "structure-passive-pair",
                pair = &mechanism.named_pair(pair),
                link = &mechanism.named_link(link)
            ),
        }
    }
}

/// A part that is left out of the groups.
#[derive(Debug, Clone)]
pub struct Passive {
    /// The part.
    pub part: PassivePart,
    /// Its pairs (and the link, where it is one) in the compiled chain; all are outer ones.
    pub frame: GroupFrame,
}

impl Structure {
    /// Whether a link is passive: no group has it, and it is placed after all groups.
    pub fn is_passive(&self, link: LinkId) -> bool {
        self.passive.iter().any(|passive| passive.part == PassivePart::Link(link))
    }

    /// Class of the mechanism: the highest among its groups; 1 without groups.
    pub fn class(&self) -> u8 {
        self.groups.iter().map(|group| group.class).max().unwrap_or(1)
    }

    /// Name of the pin or slide that a pair belongs to.
    pub fn pair_name<'a>(&self, mechanism: &'a Mechanism, pair: usize) -> &'a Name {
        mechanism.pair_name(self.pairs[pair].source)
    }

    /// Whether a pair belongs to a joint of more than two links; its reaction is then only a part of the force that
    /// the joint exerts on a link.
    pub fn is_share(&self, pair: usize) -> bool {
        let source = self.pairs[pair].source;
        self.pairs.iter().filter(|other| other.source == source).count() > 1
    }

    /// `group 1 (RRR rod, rocker)`, for messages.
    pub fn group_name(&self, mechanism: &Mechanism, group: usize) -> Text {
        let found = &self.groups[group];
        let links = found.named_links(mechanism);
        text!("structure-group", number = group + 1, kind = name(found.plugin.kind), links = list(links))
    }
}

impl Group {
    /// Its class with the number of its kind, `II3`, or with its order, `III/3`, as formulas of structure have it.
    pub fn sort(&self) -> String {
        let (class, number) = (roman(self.class), self.plugin.number);
        if number > 0 { format!("{class}{number}") } else { format!("{class}/{}", self.order) }
    }

    /// Names of the links: `boom`, `barrel+rod`.
    pub fn named_links<'a>(&'a self, mechanism: &'a Mechanism) -> impl Iterator<Item = Text> + 'a {
        let named = |link: LinkId| Text::from(&mechanism.links[link].name);
        self.merged_links().map(move |links| joined("+", links.into_iter().map(named)))
    }

    /// The links in the order of the scene, those that driven pairs make one link together: first the one against which the others are
    /// driven.
    pub fn merged_links(&self) -> impl Iterator<Item = Vec<LinkId>> {
        let held = self.frame.held();
        let is_held = |link: &LinkId| held.iter().any(|(_, [held, _])| held == link);
        let mut all: Vec<Vec<LinkId>> =
            self.frame.links.iter().filter(|link| !is_held(link)).map(|link| vec![*link]).collect();
        for (_, [held, carrier]) in held {
            match all.iter_mut().find(|links| links.contains(&carrier)) {
                Some(links) => links.push(held),
                None => all.push(vec![held]),
            }
        }
        all.into_iter()
    }

    /// Outer pairs in the order of the kind's pattern, with their bodies in the order of the scene.
    pub fn outer(&self) -> Vec<Pair> {
        let merged = self.frame.merged_pattern();
        let reading = self.plugin.pattern.and_then(|pattern| pattern.find(&merged));
        let Some(reading) = reading else { return self.frame.outer.clone() };
        let original =
            |seen: &SeenPair| self.frame.outer.iter().find(|pair| pair.id == seen.pair.id).copied();
        reading.outer.iter().filter_map(original).collect()
    }
}

/// Roman numeral of a class.
pub fn roman(class: u8) -> &'static str {
    ["0", "I", "II", "III", "IV", "V", "VI", "VII", "VIII"].get(usize::from(class)).copied().unwrap_or("IX+")
}
