//! What a file of Linkage holds, as it is written there.

use std::borrow::Cow;
use std::collections::BTreeMap;

use assur_words::{Text, name, number, text};
use roxmltree::{Document, Node, ParsingOptions};

/// Bits of `layer`: the layer on which one only draws, those of the mechanism.
const DRAWING: u64 = 0x1;
const MECHANISM: u64 = 0xFFFF_FFF0;
/// Cycles a minute of an actuator whose file does not say it.
const CPM: f64 = 15.0;
/// Most nodes of a file.
const MOST_NODES: u32 = 100_000;

/// A connector: a joint, a point that is drawn, or an end of a slot.
#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "they are attributes of the file")]
pub(crate) struct Connector {
    pub(crate) id: String,
    given: String,
    /// In units of the file.
    pub(crate) at: [f64; 2],
    pub(crate) is_anchor: bool,
    pub(crate) is_input: bool,
    pub(crate) is_manual: bool,
    pub(crate) is_decoration: bool,
    /// Turns a minute, clockwise.
    pub(crate) rpm: f64,
    /// Degrees to which an input swings, 0 where it turns, and how many of them it has done.
    pub(crate) limit: f64,
    pub(crate) offset: f64,
    /// The connectors between which it slides.
    pub(crate) slot: Option<[String; 2]>,
    /// Of a curved slot.
    pub(crate) radius: f64,
    /// The link to which it is fastened.
    pub(crate) fastened: Option<String>,
    pub(crate) is_turned_by_another: bool,
}

impl Connector {
    /// Its name, or the letters that the program shows: A to Z, AA, AB.
    pub(crate) fn name(&self) -> String {
        const LETTERS: u32 = 26;
        let (true, Ok(id)) = (self.given.is_empty(), self.id.parse::<u32>()) else {
            return if self.given.is_empty() { format!("c{}", self.id) } else { self.given.clone() };
        };
        let (mut letters, mut rest) = (String::new(), Some(id));
        while let Some(number) = rest {
            letters
                .insert(0, char::from_digit(number % LETTERS + 10, 36).unwrap_or('?').to_ascii_uppercase());
            rest = (number / LETTERS).checked_sub(1);
        }
        letters
    }
}

/// A link, which the program calls an element too.
#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "they are attributes of the file")]
pub(crate) struct Element {
    pub(crate) id: String,
    given: String,
    pub(crate) connectors: Vec<String>,
    is_drawn: bool,
    is_measurement: bool,
    pub(crate) is_actuator: bool,
    pub(crate) is_manual: bool,
    /// Stroke of an actuator, and how much of it is done; cycles a minute.
    pub(crate) throw: f64,
    pub(crate) offset: f64,
    pub(crate) cpm: f64,
    /// The link to which it is fastened.
    pub(crate) fastened: Option<String>,
    pub(crate) is_turned_by_another: bool,
}

impl Element {
    /// Its name, or the number that the program shows.
    pub(crate) fn name(&self) -> String {
        let number = self.id.parse::<u32>().ok().and_then(|id| id.checked_add(1));
        let numbered = number.map_or_else(|| self.id.clone(), |number| number.to_string());
        if self.given.is_empty() { format!("L{numbered}") } else { self.given.clone() }
    }

    pub(crate) fn is_decoration(&self) -> bool {
        self.is_drawn || self.is_measurement
    }
}

/// Two links with a ratio.
#[derive(Debug)]
pub(crate) struct Ratio {
    pub(crate) is_chain: bool,
    pub(crate) links: Vec<String>,
    pub(crate) sizes: String,
}

#[derive(Debug, Default)]
pub(crate) struct File {
    /// In which the program shows lengths.
    pub(crate) units: String,
    pub(crate) connectors: Vec<Connector>,
    pub(crate) elements: Vec<Element>,
    /// Connectors that a link says to be fastened to it.
    pub(crate) fastened: Vec<(String, String)>,
    pub(crate) ratios: Vec<Ratio>,
    /// The first connector and the first element of an id.
    numbers: [BTreeMap<String, usize>; 2],
}

/// The letters of a file, and whether they are not UTF-8: the program writes those of the Windows code page.
pub(crate) fn letters(bytes: &[u8]) -> (Cow<'_, str>, bool) {
    match std::str::from_utf8(bytes) {
        Ok(letters) => (letters.trim_start_matches('\u{feff}').into(), false),
        Err(_) => (bytes.iter().map(|byte| char::from(*byte)).collect::<String>().into(), true),
    }
}

impl File {
    pub(crate) fn parse(letters: &str) -> Result<Self, Text> {
        let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
        let document = Document::parse_with_options(letters.trim(), options)
            .map_err(|problem| text!("import-linkage-xml", problem = name(problem.to_string())))?;
        let root = document.root_element();
        if root.tag_name().name() != "linkage2" {
            return Err(text!("import-linkage-root", found = name(root.tag_name().name().to_owned())));
        }
        let mut file = Self { units: "Millimeters".to_owned(), ..Self::default() };
        for node in root.children().filter(Node::is_element) {
            match node.tag_name().name() {
                "program" => file.units = node.attribute("units").unwrap_or(&file.units).to_owned(),
                "connector" => file.connectors.push(connector(node)?),
                "Link" | "element" => {
                    file.elements.push(element(node)?);
                    let held = children(node, "fastenconnector");
                    let id = node.attribute("id").unwrap_or_default();
                    file.fastened.extend(held.into_iter().map(|connector| (connector, id.to_owned())));
                }
                "ratios" => {
                    file.ratios.extend(node.children().filter(|one| one.has_tag_name("ratio")).map(ratio));
                }
                _ => {}
            }
        }
        let connectors = file.connectors.iter().map(|one| one.id.clone()).collect();
        let elements = file.elements.iter().map(|one| one.id.clone()).collect();
        file.numbers = [connectors, elements].map(|ids: Vec<String>| {
            // Of two with one id the first counts.
            ids.into_iter().enumerate().rev().map(|(at, id)| (id, at)).collect()
        });
        Ok(file)
    }

    pub(crate) fn connector(&self, id: &str) -> Option<usize> {
        let found = self.numbers[0].get(id).copied();
        found.filter(|at| !self.connectors[*at].is_decoration)
    }

    pub(crate) fn element(&self, id: &str) -> Option<usize> {
        self.numbers[1].get(id).copied()
    }
}

/// Identities of the children of this kind.
fn children(node: Node<'_, '_>, tag: &str) -> Vec<String> {
    let of_tag = node.children().filter(|child| child.has_tag_name(tag));
    of_tag.filter_map(|child| child.attribute("id")).map(str::to_owned).collect()
}

fn flag(node: Node<'_, '_>, key: &str) -> bool {
    node.attribute(key) == Some("true")
}

/// A number; 0 where it is not written.
fn value(node: Node<'_, '_>, key: &'static str) -> Result<f64, Text> {
    let Some(written) = node.attribute(key).map(str::trim).filter(|written| !written.is_empty()) else {
        return Ok(0.0);
    };
    written.parse::<f64>().ok().filter(|found| found.is_finite()).ok_or_else(|| {
        let line = node.document().text_pos_at(node.range().start).row;
        text!("import-linkage-number", key = name(key), found = name(written.to_owned()), line = number(line))
    })
}

fn is_drawn(node: Node<'_, '_>) -> bool {
    let layer = node.attribute("layer").and_then(|layer| layer.parse::<u64>().ok()).unwrap_or_default();
    layer & DRAWING != 0 && layer & MECHANISM == 0
}

fn text_of(node: Node<'_, '_>, key: &str) -> String {
    node.attribute(key).unwrap_or_default().to_owned()
}

fn connector(node: Node<'_, '_>) -> Result<Connector, Text> {
    let slot =
        <[String; 2]>::try_from(children(node, "slidelimit").into_iter().take(2).collect::<Vec<_>>()).ok();
    Ok(Connector {
        id: text_of(node, "id"),
        given: text_of(node, "name"),
        at: [value(node, "x")?, value(node, "y")?],
        is_anchor: flag(node, "anchor"),
        is_input: flag(node, "input"),
        is_manual: flag(node, "alwaysmanual"),
        is_decoration: is_drawn(node),
        rpm: value(node, "rpm")?,
        limit: value(node, "limitangle")?,
        offset: value(node, "startoffset")?,
        slot: slot.filter(|_| flag(node, "slider")),
        radius: value(node, "slideradius")?,
        fastened: node
            .attribute("fasten")
            .or(node.attribute("fastenlink"))
            .filter(|id| !id.is_empty())
            .map(str::to_owned),
        is_turned_by_another: node.has_attribute("fastenconnector"),
    })
}

fn element(node: Node<'_, '_>) -> Result<Element, Text> {
    Ok(Element {
        id: text_of(node, "id"),
        given: text_of(node, "name"),
        connectors: children(node, "connector"),
        is_drawn: is_drawn(node),
        is_measurement: flag(node, "measurementelement"),
        is_actuator: flag(node, "actuator"),
        is_manual: flag(node, "alwaysmanual"),
        throw: value(node, "throw")?,
        offset: value(node, "startoffset")?,
        cpm: if node.has_attribute("cpm") { value(node, "cpm")? } else { CPM },
        fastened: node.attribute("fastenlink").filter(|id| !id.is_empty()).map(str::to_owned),
        is_turned_by_another: node.has_attribute("fastenconnector"),
    })
}

fn ratio(node: Node<'_, '_>) -> Ratio {
    let sizes = node.children().filter_map(|child| child.attribute("size"));
    Ratio {
        is_chain: node.attribute("type") != Some("gears"),
        links: children(node, "link"),
        sizes: sizes.collect::<Vec<_>>().join(" : "),
    }
}
