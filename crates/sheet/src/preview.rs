//! A sheet as a figure: for a screen, which has no room for its letters.

use assur_figure::{Bounds, Figure, Form, Ink, Item, Panel, Point, Scale, Stroke};
use assur_scene::SheetField;
use assur_words::{Text, text};

use crate::{Page, Part};

/// What a field is called.
pub fn name(field: SheetField) -> Text {
    text!(match field {
        SheetField::Mechanism => "sheet-field-mechanism",
        SheetField::Diagrams => "sheet-field-diagrams",
        SheetField::Velocities => "sheet-field-velocities",
        SheetField::Accelerations => "sheet-field-accelerations",
        SheetField::Forces => "sheet-field-forces",
        SheetField::Lever => "sheet-field-lever",
        SheetField::Dynamics => "sheet-field-dynamics",
        SheetField::Results => "sheet-field-results",
    })
}

/// The sheet with its lines, and its fields as boxes; those of one field stand out.
pub fn figure(page: &Page, chosen: Option<SheetField>) -> Figure {
    let mut items: Vec<Item> = page.parts.iter().flat_map(lines).collect();
    items.extend(page.parts.iter().filter_map(|part| frame(part, chosen)));
    let [width, height] = page.size;
    let bounds = Bounds { low: [0.0, -height], high: [width, 0.0] };
    Figure::of(Panel::plane(bounds, Scale::of("", "mm"), items))
}

fn lines(part: &Part) -> Vec<Item> {
    let up = |points: &[Point]| points.iter().map(|[x, y]| [*x, -y]).collect::<Vec<_>>();
    let line = |element: &assur_figure::Element| match &element.form {
        Form::Line { points, .. } => Some(Item::line(up(points), Stroke::Fine, element.ink)),
        Form::Polygon { corners, .. } => {
            let closed: Vec<Point> = corners.iter().chain(corners.first()).copied().collect();
            Some(Item::line(up(&closed), Stroke::Fine, element.ink))
        }
        Form::Circle { .. } | Form::Text { .. } => None,
    };
    part.elements.iter().filter_map(line).collect()
}

fn frame(part: &Part, chosen: Option<SheetField>) -> Option<Item> {
    let [left, top, right, bottom] = part.area().filter(|_| part.field.is_some())?;
    let (stroke, ink) =
        if part.field == chosen { (Stroke::Solid, Ink::Marked) } else { (Stroke::Dotted, Ink::Dim) };
    let corners = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
    Some(Item::line(corners.map(|[x, y]| [x, -y]), stroke, ink))
}
