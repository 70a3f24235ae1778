//! `gravity`, `[[force]]`, `[[moment]]`, `[[brake]]`: loads on single links.

use std::collections::BTreeSet;

use assur_mechanism::{Brake, Direction, Force, Load, LoadId, LoadKind, Moment, Value};
use assur_words::{name, text};

use crate::context::{Context, Sort};
use crate::joints::{contact, spring};
use crate::text::{exclude, shown};
use crate::walk::{Section, quoted};
use crate::{linkage::pair, units::Dimension, value};

/// Reads `gravity`: a magnitude, straight down, or [gx, gy].
pub(crate) fn gravity(root: &Section<'_>) -> Option<[f64; 2]> {
    let entry = root.get("gravity")?;
    if entry.value.is_array() {
        entry.faults.tell(|told| told.place([entry.span.clone()], |scene| scene.gravity.as_mut()));
        return pair(&entry, &name("[gx, gy]"), Dimension::Acceleration);
    }
    let size = entry.quantity(Dimension::Acceleration)?;
    root.sets(-1.0, |scene, key| scene.gravity.as_mut().filter(|_| key == "gravity").map(|[_, y]| y));
    if !entry.is_within(size, 0.0..) {
        entry.fault(text!("scene-gravity-upward"), text!("scene-or-both-components"));
    }
    Some([0.0, -size])
}

/// Reads all loads: forces, moments, brakes, springs, contacts.
pub(crate) fn read(root: &Section<'_>, context: &Context<'_>) -> Vec<Load> {
    let (mut loads, mut names) = (Vec::new(), BTreeSet::new());
    for sort in &SORTS {
        if sort.list != "contact" || !refuse_contacts(root, context) {
            sort.read(root, context, (&mut loads, &mut names));
        }
    }
    loads
}

/// Notes contacts, if the coordinate is the time: there is contact in an interval of that of the input. Says whether it is.
fn refuse_contacts(root: &Section<'_>, context: &Context<'_>) -> bool {
    for section in root.inners("contact").iter().filter(|_| context.timing.is_time()) {
        let during = section.get("during").map(|entry| (entry.key, "during"));
        for (span, key) in [(section.span.clone(), "[[contact]]")].into_iter().chain(during) {
            context.timing.refuse_coordinate((root.faults, &span), quoted(key), text!("scene-leave-it-out"));
        }
    }
    context.timing.is_time()
}

/// The sorts of loads, in the order of the mechanism.
pub(crate) const SORTS: [Sort; 5] = [
    Sort { list: "force", unnamed: "scene-unnamed-force", one: force },
    Sort { list: "moment", unnamed: "scene-unnamed-moment", one: moment },
    Sort { list: "brake", unnamed: "scene-unnamed-brake", one: brake },
    Sort { list: "spring", unnamed: "scene-unnamed-spring", one: spring },
    Sort { list: "contact", unnamed: "scene-unnamed-contact", one: contact },
];

fn force(section: &Section<'_>, context: &Context<'_>, id: LoadId) -> Option<LoadKind> {
    let direction = direction(section, context);
    let value = value::sized(section, "value", Dimension::Force, true, context, id);
    if matches!(direction, Some(Direction::AgainstMotion)) {
        warn_of_negative(section, value.as_ref());
    }
    let link = context.linkage.link_of(section, text!("scene-ground-carries"));
    let at = section.need("at").and_then(|entry| {
        context.linkage.place(&entry, link?, move |scene| Some(&mut scene.loads[id].kind.force_mut()?.at))
    });
    Some(Force { at: at?, direction: direction?, value: value? }.into())
}

/// Tells of a load against the motion that drives, since its value is negative.
fn warn_of_negative(section: &Section<'_>, value: Option<&Value>) {
    if let (Some(Value::Constant(size)), Some(entry)) = (value, section.get("value"))
        && *size < 0.0
    {
        entry.faults.mistake(entry.span.clone(), text!("scene-negative-against"));
    }
}

fn direction(section: &Section<'_>, context: &Context<'_>) -> Option<Direction> {
    let against = section.get("against_motion");
    let (angle, frame) = (section.get("angle"), section.get("frame"));
    if let Some(against) = against.filter(|entry| entry.flag() != Some(false)) {
        for entry in [&angle, &frame].into_iter().flatten() {
            let keys = [shown(&entry.name), name("against_motion")];
            entry.fault(exclude(keys), text!("scene-leave-one-out"));
        }
        context.need_motion(&against, quoted("against_motion"));
        return Some(Direction::AgainstMotion);
    }
    let in_link = frame.and_then(|entry| entry.choice(&[("ground", false), ("link", true)])).unwrap_or(false);
    if angle.is_none() {
        section.missing("angle", text!("scene-why-an-angle"));
    }
    let angle = section.number("angle")?;
    Some(if in_link { Direction::Link(angle) } else { Direction::Ground(angle) })
}

fn moment(section: &Section<'_>, context: &Context<'_>, id: LoadId) -> Option<LoadKind> {
    let against = section.get("against_motion").filter(|entry| entry.flag() != Some(false));
    let value = value::sized(section, "value", Dimension::Moment, false, context, id);
    if let Some(entry) = &against {
        context.need_motion(entry, quoted("against_motion"));
        warn_of_negative(section, value.as_ref());
    }
    let link = context.linkage.link_of(section, text!("scene-ground-carries"));
    Some(Moment { link: link?, value: value?, against_motion: against.is_some() }.into())
}

fn brake(section: &Section<'_>, context: &Context<'_>, id: LoadId) -> Option<LoadKind> {
    let [radius, friction, lever] = ["radius", "friction", "lever"].map(|key| section.number(key));
    if let Some(entry) = section.get("force") {
        context.need_motion(&entry, text!("scene-a-brake"));
    }
    let force = value::sized(section, "force", Dimension::Force, false, context, id);
    let link = context.linkage.link_of(section, text!("scene-ground-does-not-turn"));
    Some(Brake { link: link?, force: force?, radius: radius?, friction: friction?, lever: lever? }.into())
}
