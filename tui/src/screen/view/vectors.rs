//! Vectors in a plane of their own, with names, arrowheads and a scale.

use assur_figure::{Bounds, Frame, Ink, Item, Panel, Point, Sign, Stroke};

/// A vector from one point to another.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Vector {
    pub(crate) from: Point,
    pub(crate) to: Point,
    /// May be empty: then it is a thin line.
    pub(crate) name: String,
    pub(crate) ink: Ink,
}

/// Vectors that are drawn together, in a unit, with the index of its scale factor. With a pole, it is marked and names
/// are at the tips, as in textbooks.
pub(crate) fn panel(
    title: String,
    vectors: &[Vector],
    (unit, symbol): (&str, &'static str),
    pole: Option<&str>,
) -> Panel {
    let mut items: Vec<Item> = vectors.iter().map(arrow).collect();
    let part = if pole.is_some() { 1.0 } else { 0.6 };
    items.extend(vectors.iter().filter(|vector| !vector.name.is_empty()).map(|vector| {
        let at = [0, 1].map(|axis| (1.0 - part) * vector.from[axis] + part * vector.to[axis]);
        Item::name(at, &vector.name, Ink::Title)
    }));
    if let Some(pole) = pole {
        items.push(Item::sign([0.0; 2], Sign::Ring, Ink::Title));
        items.push(Item::name([0.0; 2], pole, Ink::Title));
    }
    let bounds = Bounds::around(items.iter().flat_map(Item::points));
    let frame = Frame::Plane { bounds, unit: unit.into(), factor: 1.0, scale: (symbol, unit.into()) };
    Panel { title, frame, items }
}

fn arrow(vector: &Vector) -> Item {
    let Vector { from, to, ink, .. } = *vector;
    if vector.name.is_empty() {
        Item::line([from, to], Stroke::Dotted, ink)
    } else {
        Item::Arrow { from, to, stroke: Stroke::Solid, ink }
    }
}
