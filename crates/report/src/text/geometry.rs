//! The section on dimensions and masses.

use assur_mechanism::Link;

use super::Source;
use super::layout::Page;
use super::number::short;

pub(super) fn write(source: &Source<'_>, page: &mut Page) {
    page.section("Geometry and masses");
    points(source, page);
    slides(source, page);
    masses(source, page);
}

fn mm(value: f64) -> String {
    short(value * 1e3)
}

fn points(source: &Source<'_>, page: &mut Page) {
    let mut rows = Vec::new();
    for (id, link) in source.mechanism.links.iter().enumerate() {
        for (point_id, point) in source.mechanism.points.iter().enumerate() {
            if let Some([x, y]) = source.mechanism.place_in(point_id, id) {
                rows.push(vec![link.name.to_string(), point.name.to_string(), mm(x), mm(y)]);
            }
        }
    }
    page.caption("Points in the frames of their links");
    page.rows(&["link", "point", "x, mm", "y, mm"], &rows);
}

fn slides(source: &Source<'_>, page: &mut Page) {
    if source.mechanism.slides.is_empty() {
        return;
    }
    let header = ["slide", "point x, mm", "y, mm", "on", "through x, mm", "y, mm", "angle, deg", "tilt, deg"];
    let mut rows = Vec::new();
    for slide in &source.mechanism.slides {
        rows.push(vec![
            slide.name.to_string(),
            mm(slide.point[0]),
            mm(slide.point[1]),
            source.mechanism.links.get(slide.on).map_or_else(String::new, |link| link.name.to_string()),
            mm(slide.through[0]),
            mm(slide.through[1]),
            short(slide.angle.to_degrees()),
            short(slide.tilt.to_degrees()),
        ]);
    }
    page.caption(
        "Slides: the point of the sliding link, and the guide line in the frame of the link that carries it",
    );
    page.rows(&header, &rows);
}

fn masses(source: &Source<'_>, page: &mut Page) {
    let heavy = |link: &&Link| link.mass > 0.0 || link.inertia > 0.0;
    let row = |link: &Link| {
        let [x, y] = link.center.map(mm);
        vec![link.name.to_string(), short(link.mass), x, y, short(link.inertia)]
    };
    let rows: Vec<_> = source.mechanism.links.iter().skip(1).filter(heavy).map(row).collect();
    if rows.is_empty() {
        page.caption("All links are massless.");
        return;
    }
    page.caption("Masses, centers of mass in the frames of the links, moments of inertia about them");
    page.rows(&["link", "mass, kg", "center x, mm", "y, mm", "inertia, kg·m²"], &rows);
}
