//! `[[slide]]`: prismatic pairs.

use assur_mechanism::{GROUND, Slide};

use crate::error::Fault;
use crate::linkage::Linkage;
use crate::numbers::Bound;
use crate::text::shown;
use crate::units::Dimension;
use crate::walk::Section;

const KEYS: &[&str] = &["link", "on", "through", "angle", "point", "tilt", "name"];

/// Reads the slides into the linkage.
pub(crate) fn read(root: &Section<'_>, linkage: &mut Linkage, firsts: &[[f64; 2]]) {
    for section in root.get("slide").iter().flat_map(|entry| entry.sections("a slide", KEYS)) {
        if let Some(slide) = one(&section, linkage, firsts) {
            linkage.slides.push(slide);
        }
    }
}

fn one(section: &Section<'_>, linkage: &Linkage, firsts: &[[f64; 2]]) -> Option<Slide> {
    let angle = section.quantity_or("angle", Dimension::Angle, Bound::Direction, 0.0);
    let tilt = section.quantity_or("tilt", Dimension::Angle, Bound::Direction, 0.0);
    let (link, on) = (section.need("link"), section.need("on"));
    let swap = "let the moving link slide on \"ground\"";
    let link_id = link.as_ref().and_then(|entry| linkage.moving(entry, swap));
    let on_id = on.as_ref().and_then(|entry| linkage.link(entry));
    let through =
        section.get("through").and_then(|entry| linkage.location(&entry, on_id?)).unwrap_or_default();
    let (link, on) = (link_id?, on_id?);
    let point = section.get("point").map_or(Some(firsts[link]), |entry| linkage.location(&entry, link));
    if link == on {
        let entry = section.get("on")?;
        entry.fault(
            format!("link `{}` can't slide on itself", shown(&linkage.links[link].name)),
            "another link or \"ground\"",
        );
    }
    let name = name(section, linkage, &format!("{}/{}", linkage.links[link].name, linkage.links[on].name));
    Some(Slide { name, link, on, point: point.unwrap_or_default(), through, angle, tilt })
}

fn name(section: &Section<'_>, linkage: &Linkage, default: &str) -> String {
    let given = section.get("name").and_then(|entry| Some((entry.text("a name")?, entry)));
    let name = given.as_ref().map_or(default, |given| given.0);
    let is_pin = linkage.points.iter().any(|point| point.name == name && point.is_pin());
    if is_pin || linkage.slides.iter().any(|slide| slide.name == name) {
        let what = if is_pin { "a pin and a slide" } else { "two slides" };
        let span = given.map_or(section.span.clone(), |(_, entry)| entry.span);
        let fault = Fault::new(span, format!("{what} have the name `{}`", shown(name)));
        section.faults.push(fault.label("give this one a `name` of its own"));
    }
    name.to_owned()
}

/// Slides between a link and the ground, in either order.
pub(crate) fn on_ground(linkage: &Linkage, link: usize) -> Vec<usize> {
    let joins = |slide: &Slide| slide.link == link && slide.on == GROUND;
    (0..linkage.slides.len()).filter(|&index| joins(&linkage.slides[index])).collect()
}
