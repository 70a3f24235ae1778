//! From the counted system to groups with pairs, kinds and a formula.

use assur_group::{GroupFrame, Pair, PairGeometry, SeenPair, plugin_for};
use assur_mechanism::{GROUND, InputPair, LinkId, Mechanism, PairId, PointId, SlideId};

use crate::graph::{Block, Graph, Node};
use crate::{
    Counted, Group, Mobility, NamedPair, Structure, StructureError, class_and_order, name_of, roman,
};

pub(crate) fn compose(mechanism: &Mechanism) -> Result<Structure, StructureError> {
    let mobility = count(mechanism);
    let graph = counted_system(mechanism);
    refuse_other_mobility(mechanism, &mobility, &graph)?;
    let incidence = Incidence::of(mechanism);
    let scale = typical_length(mechanism, &incidence);
    let mut pairs = vec![input_pair(mechanism)];
    let mut rank = vec![usize::MAX; mechanism.links.len()];
    (rank[GROUND], rank[mechanism.input.link]) = (0, 1);
    let mut groups = Vec::new();
    for part in graph.parts() {
        let links = links_of(&graph, &part);
        let frame = frame_of(mechanism, &incidence, links, &rank, scale, &mut pairs);
        if frame.links.is_empty() {
            continue;
        }
        for &link in &frame.links {
            rank[link] = groups.len() + 2;
        }
        groups.push(group_of(mechanism, frame, &pairs)?);
    }
    let formula = formula(mechanism, &groups);
    Ok(Structure { mobility, pairs, groups, links: mechanism.links.len(), scale, formula })
}

/// Points and slides of each link, in the order of the scene.
struct Incidence {
    points: Vec<Vec<PointId>>,
    slides: Vec<Vec<SlideId>>,
}

impl Incidence {
    fn of(mechanism: &Mechanism) -> Self {
        let none = vec![Vec::new(); mechanism.links.len()];
        let (mut points, mut slides) = (none.clone(), none);
        for (id, point) in mechanism.points.iter().enumerate() {
            point.places.iter().for_each(|place| points[place.link].push(id));
        }
        for (id, slide) in mechanism.slides.iter().enumerate() {
            slides[slide.link].push(id);
            slides[slide.on].push(id);
        }
        Self { points, slides }
    }
}

/// What some links have together, once each and in the order of the scene.
fn common(of: &[Vec<usize>], links: &[LinkId]) -> Vec<usize> {
    let mut all: Vec<usize> = links.iter().flat_map(|&link| of[link].iter().copied()).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Chebyshev's formula.
fn count(mechanism: &Mechanism) -> Mobility {
    let moving_links = mechanism.links.len() - 1;
    let pins: usize = mechanism.points.iter().map(|point| point.places.len() - 1).sum();
    let pairs = pins + mechanism.slides.len();
    let whole = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    Mobility { moving_links, pairs, value: 3 * whole(moving_links) - 2 * whole(pairs) }
}

/// Unknown links and pins, and the equations between them; ground and input link are known.
fn counted_system(mechanism: &Mechanism) -> Graph {
    let known = |link: LinkId| link == GROUND || link == mechanism.input.link;
    let mut nodes: Vec<Node> =
        (1..mechanism.links.len()).filter(|&link| !known(link)).map(Node::Link).collect();
    let pins = mechanism.points.iter().enumerate().filter(|(_, point)| point.is_pin());
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
        for place in &point.places {
            // The input's own pair with the ground is used up by the input.
            if place.link == mechanism.input.link && mechanism.input.pair == InputPair::Pin(id) {
                continue;
            }
            let ends = [points[id], links[place.link]];
            blocks.push(Block { nodes: ends.into_iter().flatten().collect(), source: PairId::Pin(id) });
        }
    }
    for (id, slide) in mechanism.slides.iter().enumerate() {
        if mechanism.input.pair == InputPair::Slide(id) {
            continue;
        }
        let ends = [links[slide.link], links[slide.on]];
        blocks.push(Block { nodes: ends.into_iter().flatten().collect(), source: PairId::Slide(id) });
    }
    Graph::matched(nodes, blocks)
}

/// A mechanism that one input does not determine is an error that names what is loose or surplus.
fn refuse_other_mobility(
    mechanism: &Mechanism,
    mobility: &Mobility,
    graph: &Graph,
) -> Result<(), StructureError> {
    let counted = Counted {
        mobility: mobility.value,
        formula: format!("3*{} - 2*{}", mobility.moving_links, mobility.pairs),
    };
    let link_names = |nodes: &[usize]| -> Vec<String> {
        links_of(graph, nodes).into_iter().map(|link| mechanism.links[link].name.clone()).collect()
    };
    let surplus = graph.surplus().map(|(blocks, nodes)| {
        let mut pairs: Vec<String> = Vec::new();
        for block in blocks {
            let name = name_of(mechanism, graph.blocks[block].source).to_owned();
            if !pairs.contains(&name) {
                pairs.push(name);
            }
        }
        (pairs, link_names(&nodes))
    });
    let loose = link_names(&graph.loose());
    match (surplus, loose.is_empty()) {
        (None, true) => Ok(()),
        (Some((pairs, mut links)), true) => {
            if links.is_empty() {
                // Both ends of the surplus pair are known: ground and input link.
                links.push(mechanism.links[mechanism.input.link].name.clone());
            }
            Err(StructureError::Surplus { counted, pairs, links })
        }
        (surplus, false) => {
            let also = surplus.map_or(String::new(), |(pairs, _)| {
                format!(" (while the pairs {} have one constraint too many)", pairs.join(", "))
            });
            Err(StructureError::Loose { counted, links: loose, also })
        }
    }
}

/// The greatest distance between two points of one link, or of the ground; 1 m where there is none.
fn typical_length(mechanism: &Mechanism, incidence: &Incidence) -> f64 {
    let mut longest = 0.0_f64;
    for (link, points) in incidence.points.iter().enumerate() {
        let places: Vec<_> = points.iter().filter_map(|&id| mechanism.place_in(id, link)).collect();
        for (i, a) in places.iter().enumerate() {
            for b in &places[..i] {
                longest = longest.max((a[0] - b[0]).hypot(a[1] - b[1]));
            }
        }
    }
    if longest > 0.0 { longest } else { 1.0 }
}

fn input_pair(mechanism: &Mechanism) -> NamedPair {
    match mechanism.input.pair {
        InputPair::Pin(point) => {
            let at = |link| mechanism.place_in(point, link).unwrap_or_default();
            let geometry = PairGeometry::Pin { at_a: at(mechanism.input.link), at_b: at(GROUND) };
            let pair = Pair { id: 0, a: mechanism.input.link, b: GROUND, geometry };
            NamedPair { pair, source: PairId::Pin(point) }
        }
        InputPair::Slide(slide) => slide_pair(mechanism, slide, 0),
    }
}

fn slide_pair(mechanism: &Mechanism, id: usize, index: usize) -> NamedPair {
    let slide = &mechanism.slides[id];
    let geometry = PairGeometry::Slide {
        point: slide.point,
        through: slide.through,
        angle: slide.angle,
        tilt: slide.tilt,
    };
    let pair = Pair { id: index, a: slide.link, b: slide.on, geometry };
    NamedPair { pair, source: PairId::Slide(id) }
}

/// The links of one part in the order of the scene; a part of a pin alone has none.
fn links_of(graph: &Graph, part: &[usize]) -> Vec<LinkId> {
    let links = part.iter().filter_map(|&node| match graph.nodes[node] {
        Node::Link(link) => Some(link),
        Node::Pin(_) => None,
    });
    let mut links: Vec<LinkId> = links.collect();
    links.sort_unstable();
    links
}

/// The pairs of these links with each other and with what is solved; they are appended to `pairs`.
fn frame_of(
    mechanism: &Mechanism,
    incidence: &Incidence,
    links: Vec<LinkId>,
    rank: &[usize],
    scale: f64,
    pairs: &mut Vec<NamedPair>,
) -> GroupFrame {
    let mut frame = GroupFrame { links, inner: Vec::new(), outer: Vec::new(), scale };
    let mut found =
        pins_of(mechanism, &common(&incidence.points, &frame.links), &frame.links, rank, pairs.len());
    for id in common(&incidence.slides, &frame.links) {
        let slide = &mechanism.slides[id];
        let within = |link: LinkId| frame.links.contains(&link);
        let solved = |link: LinkId| rank[link] != usize::MAX;
        if within(slide.link) && (within(slide.on) || solved(slide.on))
            || within(slide.on) && solved(slide.link)
        {
            found.push(slide_pair(mechanism, id, pairs.len() + found.len()));
        }
    }
    for named in &found {
        let inner = frame.links.contains(&named.pair.a) && frame.links.contains(&named.pair.b);
        if inner { &mut frame.inner } else { &mut frame.outer }.push(named.pair);
    }
    pairs.extend(found);
    frame
}

/// Pairs that the pins make between links of a group, and of the group with what is solved.
fn pins_of(
    mechanism: &Mechanism,
    points: &[PointId],
    links: &[LinkId],
    rank: &[usize],
    first: usize,
) -> Vec<NamedPair> {
    let mut found = Vec::new();
    let points = points.iter().map(|&id| (id, &mechanism.points[id]));
    for (id, point) in points.filter(|(_, point)| point.is_pin()) {
        let members: Vec<_> = point.places.iter().filter(|place| links.contains(&place.link)).collect();
        let solved = point.places.iter().filter(|place| rank[place.link] != usize::MAX);
        // All hang on one body: on the first that is solved, or else on the first link of the group.
        let anchor = solved.min_by_key(|place| rank[place.link]);
        let (anchor, hung) = match (anchor, &members[..]) {
            (Some(anchor), hung) => (anchor, hung),
            (None, [anchor, hung @ ..]) => (*anchor, hung),
            (None, []) => continue,
        };
        for place in hung {
            let geometry = PairGeometry::Pin { at_a: place.at, at_b: anchor.at };
            let pair = Pair { id: first + found.len(), a: place.link, b: anchor.link, geometry };
            found.push(NamedPair { pair, source: PairId::Pin(id) });
        }
    }
    found
}

fn group_of(mechanism: &Mechanism, frame: GroupFrame, pairs: &[NamedPair]) -> Result<Group, StructureError> {
    let (class, order) = class_and_order(&frame);
    match plugin_for(&frame)? {
        Some(plugin) => Ok(Group { frame, plugin, class, order }),
        None => Err(StructureError::NoPlugin {
            links: frame.links.iter().map(|&link| mechanism.links[link].name.clone()).collect(),
            class,
            order,
            pattern: pattern(mechanism, &frame, pairs),
        }),
    }
}

/// `inner R B, outer R A, P ram/ground`.
fn pattern(mechanism: &Mechanism, frame: &GroupFrame, pairs: &[NamedPair]) -> String {
    let named = |list: &[Pair]| {
        let names = list.iter().map(|pair| {
            let letter = if pair.is_slide() { "P" } else { "R" };
            format!("{letter} {}", name_of(mechanism, pairs[pair.id].source))
        });
        names.collect::<Vec<_>>().join(", ")
    };
    format!("inner {}; outer {}", named(&frame.inner), named(&frame.outer))
}

fn formula(mechanism: &Mechanism, groups: &[Group]) -> String {
    let name = |link: LinkId| mechanism.links[link].name.as_str();
    let mut text = format!("I({},{})", name(GROUND), name(mechanism.input.link));
    for group in groups {
        let links: Vec<_> = group.frame.links.iter().map(|&link| name(link)).collect();
        let sort = if group.plugin.number > 0 {
            format!("{}{}", roman(group.class), group.plugin.number)
        } else {
            format!("{}/{}", roman(group.class), group.order)
        };
        text.extend([" -> ", &sort, "(", &links.join(","), ")"]);
    }
    text
}

impl Group {
    /// Outer pairs in the order of the kind's pattern, with the bodies as the scene names them.
    pub fn outer(&self) -> Vec<Pair> {
        let Some(reading) = self.plugin.pattern.find(&self.frame) else { return self.frame.outer.clone() };
        let original =
            |seen: &SeenPair| self.frame.outer.iter().find(|pair| pair.id == seen.pair.id).copied();
        reading.outer.iter().filter_map(original).collect()
    }
}
