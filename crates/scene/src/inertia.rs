//! `inertia` of a link: a number, or a formula over the input coordinate.

use assur_formula::Used;
use assur_mechanism::{GROUND, Inertia, Input, Key, LinkId, Mechanism, Motion, Until, VaryingInertia};
use assur_words::{Text, name, text};

use crate::text::{brief, shown, such_as};
use crate::value::{formula_with_unit, within_text};
use crate::walk::{Section, quoted};
use crate::{context::Context, edit::within, linkage::SceneLinks, units::Dimension};

/// Reads the moment of inertia of a link, whose points are known.
pub(crate) fn read(linkage: &SceneLinks, id: LinkId, section: &Section<'_>) -> Inertia {
    let Some(entry) = section.get("inertia") else { return Inertia::NONE };
    if !entry.value.is_table() {
        return section.number("inertia").unwrap_or_default().into();
    }
    formula(linkage, id, section).unwrap_or_default()
}

fn formula(linkage: &SceneLinks, id: LinkId, link: &Section<'_>) -> Option<Inertia> {
    let section = link.inner("inertia")?;
    if section.get("formula").is_none() {
        section.missing("formula", Text::default());
    }
    let (entry, formula, factor) = formula_with_unit(&section, Dimension::Inertia)?;
    let Used { speed, time, place, .. } = formula.used();
    let others = [(speed, "w"), (time, "t"), (place, "x")];
    let others: Vec<_> = others.into_iter().filter_map(|(used, name)| used.then_some(name)).collect();
    if !others.is_empty() {
        let message = text!("scene-inertia-of-others", variables = name(others.join(", ")));
        entry.fault(message, text!("scene-inertia-of-q"));
    }
    if let Some(switch) = formula.switches().first() {
        let function = shown(&formula.text()[switch.span.clone()]);
        let message = text!("scene-inertia-not-smooth", function);
        let span = within_text(&entry, formula.text(), &switch.span);
        entry.faults.add(span, message, text!("scene-inertia-smooth"));
    }
    if !linkage.points.iter().any(|point| point.on(GROUND).and(point.on(id)).is_some()) {
        let message = text!("scene-inertia-not-pinned", link = shown(&linkage.links[id].name));
        entry.fault(message, text!("scene-inertia-of-a-number"));
    }
    Some(Inertia::Varying(VaryingInertia { formula, factor }))
}

/// Notes moments of inertia over the input coordinate, if the coordinate is the time.
pub(crate) fn refuse_over_coordinate(root: &Section<'_>, context: &Context<'_>) {
    for link in context.linkage.links.iter().filter(|link| link.inertia.varying().is_some()) {
        let key = Key::of("link").at(&link.name).at("inertia");
        if let Ok(inertia) = within(root.table(), key.steps()) {
            let (at, key) = (inertia.span(), quoted("inertia = { formula }"));
            context.timing.refuse_coordinate((root.faults, &at), key, such_as("\"0.04 kg*m^2\""));
        }
    }
}

/// Refuses moments of inertia that are not positive, or beyond the range of a number, somewhere on the way of the input.
pub(crate) fn refuse_impossible(root: &Section<'_>, mechanism: &Mechanism) {
    let way = way(&mechanism.input, mechanism.motion.as_ref());
    let most = Dimension::Inertia.most();
    for link in &mechanism.links {
        let Some(law) = link.inertia.varying() else { continue };
        let Some((at, value)) = law.formula.not_positive_to(most / law.factor, way) else { continue };
        let rounded = |number: f64| brief((number * 1e6).round() / 1e6);
        let value = brief(value * law.factor);
        let message = text!("scene-inertia-not-positive", value, at = rounded(at));
        let key = Key::of("link").at(&link.name).at("inertia");
        if let Ok(inertia) = within(root.table(), key.steps()) {
            let label = text!("scene-inertia-positive", most = name(format!("{most:e} kg*m^2")));
            root.faults.add(inertia.span(), message, label);
        }
    }
}

/// The coordinates that the input passes, as far as the scene says.
fn way(input: &Input, motion: Option<&Motion>) -> [f64; 2] {
    let [from, end] = input.ends();
    let last = match motion {
        Some(Motion::Transient { until: Until::Way(way), .. }) => [from - way, from + way],
        _ => [end; 2],
    };
    let all = [from, end, last[0], last[1]];
    [all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max)]
}
