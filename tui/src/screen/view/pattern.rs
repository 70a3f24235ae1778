//! A kind of group as a drawing of its pattern.

use assur_figure::{Bounds, Figure, Ink, Item, Panel, Scale, Sign, Stroke};
use assur_group::PairSort;
use assur_sketch::Addition;
use assur_words::{Text, list, text};

use super::build::MARGIN;

/// A kind of group in characters: its links between their pairs.
pub(super) fn figure(addition: &Addition) -> Figure {
    let pattern = &addition.pattern;
    let spread = |index: usize, count: usize| if count < 2 { 0.5 } else { index as f64 / (count - 1) as f64 };
    let outer = |index: usize| [2.0 * spread(index, pattern.outer.len()), 0.0];
    let inner =
        |index: usize| [0.5 + spread(index, pattern.inner.len()), 1.0 + 0.2 * f64::from(index % 2 == 1)];
    let mut joints = vec![Vec::new(); pattern.links];
    let mut items = Vec::new();
    let mut sign = |at: [f64; 2], is_slide: bool, is_outer: bool| {
        let sign = match (is_slide, is_outer) {
            (true, _) => Sign::Block,
            (_, true) => Sign::Ring,
            _ => Sign::Pin,
        };
        items.push(Item::sign(at, sign, Ink::Title));
    };
    for (index, (link, sort)) in pattern.outer.iter().enumerate() {
        joints[*link].push(outer(index));
        sign(outer(index), *sort == assur_group::PairSort::Slide, true);
    }
    for (index, (links, sort)) in pattern.inner.iter().enumerate() {
        for link in links {
            joints[*link].push(inner(index));
        }
        sign(inner(index), *sort == assur_group::PairSort::Slide, false);
    }
    for (link, mut corners) in joints.into_iter().enumerate() {
        if corners.len() > 2 {
            corners.extend(corners.first().copied());
        }
        items.insert(0, Item::line(corners, Stroke::Thick, Ink::Link(link + 1)));
    }
    let bounds = Bounds::around([[0.0, 0.0], [2.0, 1.4]].into_iter()).widened(MARGIN);
    Figure::of(Panel::plane(bounds, Scale::of("", ""), items))
}

/// The sorts of the inner and of the outer pairs of what is added.
pub(super) fn pairs_of(addition: &Addition) -> [Text; 2] {
    let (inner, outer) = addition.sorts.split_at(addition.pattern.inner.len());
    let sort =
        |sort: &PairSort| text!(if *sort == PairSort::Slide { "build-a-slide" } else { "build-a-pin" });
    let sorts = |sorts: &[PairSort]| list(sorts.iter().map(sort));
    [text!("structure-inner", pairs = sorts(inner)), text!("structure-outer", pairs = sorts(outer))]
}
