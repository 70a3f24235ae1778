//! Turns the matched system of equations into groups with their pairs, kinds and structural formula.

use std::collections::{HashMap, HashSet, VecDeque};

use assur_group::{GroupFrame, Pair, plugin_for};
use assur_mechanism::{
    Driver, GROUND, Input, InputPair, LinkId, Mechanism, Name, PairId, Place, Point, Slide, SlideId, likeness,
};
use assur_words::{Text, joined, name, text};

use crate::frame::{Incidence, LeftOut, driven_pairs, frame_of, pair_alone, typical_length};
use crate::graph::{Block, Graph, Node};
use crate::{Group, MissingBlock, Mobility, NamedPair, Passive, PassivePart, Structure, StructureError};

impl Structure {
    /// Decomposes a mechanism into Assur groups.
    pub fn of(mechanism: &Mechanism) -> Result<Self, StructureError> {
        Self::without(mechanism, &[])
    }

    /// Decomposes a mechanism without some parts, which are passive: its groups don't depend on them. The mobility is that of
    /// the whole mechanism as counted.
    pub fn without(mechanism: &Mechanism, parts: &[PassivePart]) -> Result<Self, StructureError> {
        let mobility = count(mechanism);
        let left_out = LeftOut::of(mechanism, parts);
        let graph = counted_system(mechanism, &left_out);
        refuse_other_mobility(mechanism, mobility, &graph)?;
        let incidence = Incidence::of(mechanism);
        let scale = typical_length(mechanism);
        let mut pairs = driven_pairs(mechanism);
        let mut rank = vec![usize::MAX; mechanism.links.len()];
        rank[GROUND] = 0;
        for link in mechanism.input.placed() {
            rank[link] = 1;
        }
        let mut groups = Vec::new();
        for part in graph.parts() {
            let links = links_of(&graph, &part);
            let frame = frame_of((mechanism, &incidence, &left_out), links, &rank, scale, &mut pairs);
            if frame.links.is_empty() {
                continue;
            }
            for &link in &frame.links {
                rank[link] = groups.len() + 2;
            }
            groups.push(group_of(mechanism, frame, &pairs)?);
        }
        let mut passive = Vec::with_capacity(parts.len());
        for (index, &part) in parts.iter().rev().enumerate() {
            let frame = match part {
                PassivePart::Link(link) => {
                    let from = (mechanism, &incidence, &left_out);
                    let frame = frame_of(from, vec![link], &rank, scale, &mut pairs);
                    rank[link] = groups.len() + 2 + index;
                    frame
                }
                PassivePart::Pair(pair, link) => {
                    pair_alone(mechanism, (pair, link), &rank, scale, &mut pairs)
                }
            };
            passive.push(Passive { part, frame });
        }
        let formula = formula(mechanism, &groups);
        let (placed, ways, links) = (Vec::new(), Vec::new(), mechanism.links.len());
        Ok(Self { mobility, pairs, groups, passive, placed, ways, links, scale, formula })
    }
}

/// Chebyshev's formula.
fn count(mechanism: &Mechanism) -> Mobility {
    let moving_links = mechanism.links.len() - 1;
    let pins: usize = mechanism.points.iter().map(|point| point.places.len() - 1).sum();
    let pairs = pins + mechanism.slides.len();
    let whole = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    Mobility { moving_links, pairs, value: 3 * whole(moving_links) - 2 * whole(pairs) }
}

/// Builds the unknowns (links and pins) and the equations between them; ground and input link are known.
pub(crate) fn counted_system(mechanism: &Mechanism, left_out: &LeftOut) -> Graph {
    let input = &mechanism.input;
    let known = |link: LinkId| link == GROUND || input.places(link);
    let links = (1..mechanism.links.len()).filter(|&link| !known(link) && !left_out.link(link));
    let mut nodes: Vec<Node> = links.map(Node::Link).collect();
    // A pin of which every link is left out has no place.
    let is_held = |(id, point): &(usize, &Point)| {
        point.is_pin() && point.places.iter().any(|place| !left_out.pair(PairId::Pin(*id), place.link))
    };
    let pins = mechanism.points.iter().enumerate().filter(is_held);
    nodes.extend(pins.map(|(id, _)| Node::Pin(id)));
    let (mut links, mut points) = (vec![None; mechanism.links.len()], vec![None; mechanism.points.len()]);
    for (index, node) in nodes.iter().enumerate() {
        match *node {
            Node::Link(link) => links[link] = Some(index),
            Node::Pin(point) => points[point] = Some(index),
        }
    }
    let mut blocks = Vec::new();
    for (id, point) in mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin()) {
        for place in point.places.iter().filter(|place| !left_out.pair(PairId::Pin(id), place.link)) {
            // The input coordinate replaces the input's own pair with the ground.
            if input.placing(place.link).is_some_and(|driver| driver.pair == InputPair::Pin(id)) {
                continue;
            }
            let ends = [points[id], links[place.link]];
            blocks.push(Block::of(2, ends, PairId::Pin(id)));
        }
    }
    for (id, slide) in mechanism.slides.iter().enumerate() {
        let placing = [slide.link, slide.on].into_iter().find_map(|link| input.placing(link));
        if placing.is_some_and(|driver| driver.pair == InputPair::Slide(id))
            || left_out.pair(PairId::Slide(id), slide.link)
            || left_out.link(slide.on)
        {
            continue;
        }
        let ends = [links[slide.link], links[slide.on]];
        blocks.push(Block::of(2, ends, PairId::Slide(id)));
    }
    for driver in input.drivers.iter().filter(|driver| !is_placing(input, driver)) {
        let ends = [driver.link, driver.on].map(|link| links[link]);
        blocks.push(Block::of(1, ends, driver.pair_id()));
    }
    Graph::matched(nodes, blocks)
}

/// Whether it places its link: of several drives of one link against the ground the first one does.
fn is_placing(input: &Input, driver: &Driver) -> bool {
    input.placing(driver.link).is_some_and(|placing| std::ptr::eq(placing, driver))
}

/// Returns an error that names the loose links or surplus pairs of a mechanism that one input does not determine.
fn refuse_other_mobility(
    mechanism: &Mechanism,
    counted: Mobility,
    graph: &Graph,
) -> Result<(), StructureError> {
    let inputs = mechanism.input.drivers.len();
    if let Some(input) = first_dependent(mechanism) {
        return Err(StructureError::DependentInput { counted, inputs, input: Box::new(input) });
    }
    let names = |links: &[LinkId]| -> Vec<String> {
        links.iter().map(|link| mechanism.links[*link].name.to_string()).collect()
    };
    let surplus = graph.surplus().map(|(blocks, nodes)| {
        let mut seen = HashSet::new();
        let pairs = blocks.into_iter().map(|block| mechanism.pair_name(graph.blocks[block].source));
        let pairs = pairs.filter(|name| seen.insert(*name)).map(ToString::to_string);
        (pairs.collect::<Vec<_>>(), links_of(graph, &nodes))
    });
    let loose = links_of(graph, &graph.loose());
    if !loose.is_empty() {
        return Err(StructureError::Loose {
            counted,
            inputs,
            links: names(&loose),
            surplus: surplus.map_or(Vec::new(), |(pairs, _)| pairs),
            alike: alike(mechanism),
            alone: alone(mechanism, &loose),
        });
    }
    let Some((pairs, mut links)) = surplus else { return Ok(()) };
    if links.is_empty() {
        // Both ends of the surplus pair are known (ground and input link).
        links.push(mechanism.input.first().link);
    }
    let block = missing_block(mechanism, &pairs);
    Err(StructureError::Surplus { counted, inputs, pairs, links: names(&links), block, why: Box::default() })
}

/// The first of some slides in which a link turns against its guide as a pin in a slot would, if a slide block of its own carried the
/// pin: with it the input determines the mechanism, and the sliding link is held by another pair.
fn missing_block(mechanism: &Mechanism, pairs: &[String]) -> Option<Box<MissingBlock>> {
    let is_among = |slide: &Slide| pairs.iter().any(|pair| *pair == slide.name.to_string());
    let mut all = mechanism.slides.iter().enumerate().filter(|(_, slide)| is_among(slide));
    let (_, slide) = all.find(|(index, _)| {
        let excess = Excess::of(&with_block(mechanism, *index), &[]);
        excess.surplus == 0 && !excess.loose
    })?;
    let bits = |at: [f64; 2]| at.map(f64::to_bits);
    let is_at = |place: &Place| place.link == slide.link && bits(place.at) == bits(slide.point);
    let point = mechanism.points.iter().find(|point| point.places.iter().any(is_at));
    Some(Box::new(MissingBlock {
        link: mechanism.links[slide.link].name.clone(),
        on: mechanism.links[slide.on].name.clone(),
        point: point.map(|point| point.name.clone()),
    }))
}

/// A mechanism with a massless block in a slide: the sliding link is pinned to it at its point, and the block slides.
fn with_block(mechanism: &Mechanism, slide: SlideId) -> Mechanism {
    let mut changed = mechanism.clone();
    let block = changed.links.len();
    let Slide { link, point, .. } = changed.slides[slide];
    let places = vec![Place { link, at: point }, Place { link: block, at: [0.0; 2] }];
    changed.links.push(changed.links[link].clone());
    changed.points.push(Point { name: Name::default(), places });
    changed.slides[slide].link = block;
    changed
}

/// Of several inputs the first that those before it determine.
fn first_dependent(mechanism: &Mechanism) -> Option<Name> {
    let drivers = &mechanism.input.drivers;
    if drivers.len() < 2 {
        return None;
    }
    let mut some = mechanism.clone();
    let mut surplus = |inputs: usize| {
        some.input.drivers = drivers[..inputs].to_vec();
        Excess::of(&some, &[]).surplus
    };
    let before: Vec<usize> = (1..=drivers.len()).map(&mut surplus).collect();
    let grown = before.windows(2).position(|two| two[1] > two[0])?;
    Some(drivers[grown + 1].label.clone())
}

/// Two points of different links that stand in one link each, but have nearly the same name.
fn alike(mechanism: &Mechanism) -> Option<Box<[String; 2]>> {
    let mut seen: HashMap<String, &Point> = HashMap::new();
    for point in mechanism.points.iter().filter(|point| point.places.len() == 1) {
        let like = *seen.entry(likeness(&point.name)).or_insert(point);
        if like.places[0].link != point.places[0].link {
            return Some(Box::new([like, point].map(|point| point.name.to_string())));
        }
    }
    None
}

/// The points of some links that stand in one link only, each with it: pins that were meant may be among them.
fn alone(mechanism: &Mechanism, links: &[LinkId]) -> Vec<String> {
    let of_link = |link: &LinkId| {
        let alone = |point: &&Point| point.places.len() == 1 && point.places[0].link == *link;
        let points = mechanism.points.iter().filter(alone).map(|point| point.name.to_string());
        let points = points.collect::<Vec<_>>().join(", ");
        (!points.is_empty()).then(|| format!("{}: {points}", mechanism.links[*link].name))
    };
    links.iter().chain([&GROUND]).filter_map(of_link).collect()
}

/// The links of one part in the order of the scene; a part that is a single pin has none.
fn links_of(graph: &Graph, part: &[usize]) -> Vec<LinkId> {
    let links = part.iter().filter_map(|&node| match graph.nodes[node] {
        Node::Link(link) => Some(link),
        Node::Pin(_) => None,
    });
    let mut links: Vec<LinkId> = links.collect();
    links.sort_unstable();
    links
}

fn group_of(mechanism: &Mechanism, frame: GroupFrame, pairs: &[NamedPair]) -> Result<Group, StructureError> {
    let joins = |pin: &Pair, slide: &Pair| {
        [pin.a, pin.b] == [slide.a, slide.b] || [pin.b, pin.a] == [slide.a, slide.b]
    };
    let held = frame.pairs().filter(|pair| pair.is_slide()).find_map(|slide| {
        let pin = frame.pairs().find(|pair| !pair.is_slide() && joins(pair, slide))?;
        Some([pin, slide].map(|pair| Box::new(mechanism.pair_name(pairs[pair.id].source).clone())))
    });
    if let Some([pin, slide]) = held {
        return Err(StructureError::Held { pin, slide });
    }
    let merged = frame.merged_pattern();
    let (class, order) = class_and_order(&merged);
    match plugin_for(&merged)? {
        Some(plugin) => Ok(Group { frame, plugin, class, order }),
        None => Err(StructureError::NoPlugin {
            links: frame.links.iter().map(|&link| mechanism.links[link].name.to_string()).collect(),
            class,
            order,
            pattern: pattern(mechanism, &merged, pairs),
        }),
    }
}

/// The pairs of a group in letters and names: `inner R B, outer R A, P ram/ground`.
fn pattern(mechanism: &Mechanism, frame: &GroupFrame, pairs: &[NamedPair]) -> Text {
    let named = |list: &[Pair]| {
        let names = list.iter().map(|pair| {
            let letter = if pair.is_slide() { "P" } else { "R" };
            joined(" ", [name(letter), Text::from(mechanism.pair_name(pairs[pair.id].source))])
        });
        assur_words::list(names)
    };
    text!("structure-pattern", inner = named(&frame.inner), outer = named(&frame.outer))
}

fn formula(mechanism: &Mechanism, groups: &[Group]) -> Name {
    let named = |link: LinkId| Text::from(&mechanism.links[link].name);
    let links =
        |sort: String, links: Vec<Text>| joined("", [name(sort + "("), joined(",", links), name(")")]);
    let input = |driver: &Driver| links("I".to_owned(), [driver.on, driver.link].map(named).to_vec());
    let input = joined(" + ", mechanism.input.drivers.iter().map(input));
    // A link that is driven against a solved one stands among the inputs already.
    let groups = groups
        .iter()
        .filter(|group| group.class > 1)
        .map(|group| links(group.sort(), group.named_links(mechanism).collect()));
    joined(" -> ", std::iter::once(input).chain(groups)).into()
}

/// Class and order of a group according to Assur and Artobolevsky.
///
/// A group of two links has class II. Otherwise the class is the greatest number of pairs in one contour: a link with
/// k pairs is a contour of k, and so is a closed chain of k links in the group. The order is the number of outer
/// pairs.
fn class_and_order(frame: &GroupFrame) -> (u8, u8) {
    let order = u8::try_from(frame.outer.len()).unwrap_or(u8::MAX);
    if frame.links.is_empty() {
        // A driven link with the moving one that is its ground.
        return (1, 1);
    }
    if frame.links.len() <= 2 {
        return (2, order);
    }
    let elements = |link: usize| frame.pairs().filter(|pair| pair.joins(link)).count();
    let widest = frame.links.iter().map(|&link| elements(link)).max().unwrap_or(0);
    let class = widest.max(longest_contour(frame));
    (u8::try_from(class).unwrap_or(u8::MAX), order)
}

/// Number of links in the longest contour, where each inner pair counts with its shortest closed chain; 0 if there is
/// none.
fn longest_contour(frame: &GroupFrame) -> usize {
    let mut joined: HashMap<LinkId, Vec<usize>> = HashMap::new();
    for (index, pair) in frame.inner.iter().enumerate() {
        for link in [pair.a, pair.b] {
            joined.entry(link).or_default().push(index);
        }
    }
    let contours = (0..frame.inner.len()).filter_map(|skipped| path_without(frame, &joined, skipped));
    contours.max().unwrap_or(0)
}

/// Number of links on the shortest path between the two links of an inner pair, without this pair; `joined`: the inner
/// pairs of each link.
fn path_without(frame: &GroupFrame, joined: &HashMap<LinkId, Vec<usize>>, skipped: usize) -> Option<usize> {
    let Pair { a: from, b: to, .. } = frame.inner[skipped];
    let mut seen = HashSet::from([from]);
    let mut next = VecDeque::from([(from, 1)]);
    while let Some((link, steps)) = next.pop_front() {
        if link == to {
            return Some(steps);
        }
        for &index in joined.get(&link).into_iter().flatten().filter(|index| **index != skipped) {
            let other = frame.inner[index].other(link);
            if seen.insert(other) {
                next.push_back((other, steps + 1));
            }
        }
    }
    None
}

/// What the count of equations says of a mechanism without some parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Excess {
    /// Number of surplus constraints.
    pub surplus: usize,
    /// Whether a link can move while the input is fixed.
    pub loose: bool,
}

impl Excess {
    /// Counts; nothing is solved, and lengths don't matter.
    pub fn of(mechanism: &Mechanism, without: &[PassivePart]) -> Self {
        let graph = counted_system(mechanism, &LeftOut::of(mechanism, without));
        Self { surplus: graph.unmatched(), loose: graph.is_loose() }
    }
}
