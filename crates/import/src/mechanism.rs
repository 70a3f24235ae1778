//! What of a drawing is one mechanism: links that can't move are ground, links that nothing holds and other mechanisms beside it
//! are left out.

use assur_words::{Text, joined, list, name, text};

use crate::{Drawing, Driven, Input, are_apart, names};

/// Reduces a drawing to one mechanism.
pub(crate) fn reduce(drawing: &mut Drawing) -> Result<(), Text> {
    names::make_unique(drawing);
    while ground(drawing) {}
    let held = |drawing: &Drawing, link: usize| {
        let slides =
            drawing.slides.iter().filter(|slide| slide.link == link || slide.on == Some(link)).count();
        drawing.links[link].joints.len() + slides > 1
    };
    let is_loose = |link: &usize| !drawing.links[*link].joints.is_empty() && !held(drawing, *link);
    let loose = told(drawing, &(0..drawing.links.len()).filter(is_loose).collect::<Vec<_>>());
    if let Some(links) = loose {
        drawing.tell(text!("import-loose", links));
    }
    let keep: Vec<bool> = (0..drawing.links.len()).map(|link| held(drawing, link)).collect();
    keep_links(drawing, &keep);
    alone(drawing);
    if drawing.links.is_empty() {
        let lost = drawing.remarks.iter().filter(|remark| remark.is_lost).map(|remark| remark.text.clone());
        return Err(joined(" ", std::iter::once(text!("import-nothing-moves")).chain(lost)));
    }
    if drawing.inputs.is_empty() {
        drive(drawing);
    }
    Ok(())
}

/// The names of links, or nothing of none.
fn told(drawing: &Drawing, links: &[usize]) -> Option<Text> {
    let names = links.iter().map(|link| name(drawing.links[*link].name.clone()));
    (!links.is_empty()).then(|| list(names))
}

/// Makes a link with two fixed joints a part of the ground; whether there was one.
fn ground(drawing: &mut Drawing) -> bool {
    let is_fixed = |link: &usize| {
        let joints = drawing.links[*link].joints.iter().map(|joint| &drawing.joints[*joint]);
        let mut fixed = joints.filter(|joint| joint.is_grounded).map(|joint| joint.at);
        let first = fixed.next();
        first.is_some_and(|first| fixed.any(|at| are_apart(at, first)))
    };
    let Some(link) = (0..drawing.links.len()).find(is_fixed) else { return false };
    for joint in drawing.links[link].joints.clone() {
        drawing.joints[joint].is_grounded = true;
    }
    for slide in &mut drawing.slides {
        if slide.on == Some(link) {
            slide.on = None;
        }
        if let (true, Some(guide)) = (slide.link == link, slide.on) {
            // The guide slides along the fixed link in the same direction.
            let joint = drawing.links[guide].joints.first().copied();
            (slide.link, slide.on) = (guide, None);
            slide.joint = joint.unwrap_or(slide.joint);
            slide.through = drawing.joints[slide.joint].at;
        }
    }
    for input in &mut drawing.inputs {
        if let Driven::Pin { of, on, .. } = &mut input.pair {
            match *on {
                Some(other) if *of == link => (*of, *on, input.rate) = (other, None, -input.rate),
                Some(other) if other == link => *on = None,
                _ => {}
            }
        }
    }
    let links = told(drawing, &[link]).unwrap_or_default();
    drawing.tell(text!("import-fixed-link", links));
    let keep: Vec<bool> = (0..drawing.links.len()).map(|other| other != link).collect();
    keep_links(drawing, &keep);
    true
}

/// Keeps some of the links, and what belongs to these alone; inputs and forces that are lost with the others are remarked.
fn keep_links(drawing: &mut Drawing, keep: &[bool]) {
    let before = [drawing.inputs.len(), drawing.forces.len()];
    retain(drawing, keep);
    let gone = [before[0] - drawing.inputs.len(), before[1] - drawing.forces.len()];
    if gone[0] > 0 {
        drawing.lose(text!("import-inputs-gone", count = gone[0]));
    }
    if gone[1] > 0 {
        drawing.lose(text!("import-forces-gone", count = gone[1]));
    }
}

fn retain(drawing: &mut Drawing, keep: &[bool]) {
    let mut count = 0;
    let new: Vec<Option<usize>> = keep
        .iter()
        .map(|kept| {
            count += usize::from(*kept);
            kept.then(|| count - 1)
        })
        .collect();
    let of = |link: usize| new.get(link).copied().flatten();
    let both =
        |link: usize, on: Option<usize>| Some((of(link)?, on.map_or(Some(None), |on| of(on).map(Some))?));
    let mut slides = Vec::new();
    let mut kept = Vec::new();
    for mut slide in std::mem::take(&mut drawing.slides) {
        let found = both(slide.link, slide.on);
        kept.push(found.map(|_| slides.len()));
        if let Some((link, on)) = found {
            (slide.link, slide.on) = (link, on);
            slides.push(slide);
        }
    }
    drawing.slides = slides;
    drawing.inputs.retain_mut(|input| match &mut input.pair {
        Driven::Slide(slide) => kept.get(*slide).copied().flatten().map(|new| *slide = new).is_some(),
        Driven::Pin { of, on, .. } => both(*of, *on).map(|found| (*of, *on) = found).is_some(),
    });
    drawing.forces.retain_mut(|force| of(force.link).map(|link| force.link = link).is_some());
    let mut kept = keep.iter();
    drawing.links.retain(|_| *kept.next().unwrap_or(&true));
}

/// Keeps the mechanism with most inputs and then most links, of those that have no moving joint in common.
fn alone(drawing: &mut Drawing) {
    let parts = parts(drawing);
    let inputs = |part: usize| {
        let of = |input: &&Input| match input.pair {
            Driven::Pin { of, .. } => parts[of] == part,
            Driven::Slide(slide) => parts[drawing.slides[slide].link] == part,
        };
        drawing.inputs.iter().filter(of).count()
    };
    let links = |part: usize| parts.iter().filter(|other| **other == part).count();
    let mut all = parts.clone();
    all.sort_unstable();
    all.dedup();
    // The first of equals.
    let Some(best) =
        all.iter().rev().copied().max_by_key(|part| (links(*part).min(2), inputs(*part), links(*part)))
    else {
        return;
    };
    let keep: Vec<bool> = parts.iter().map(|part| *part == best).collect();
    let others: Vec<usize> = (0..keep.len()).filter(|link| !keep[*link]).collect();
    if let Some(links) = told(drawing, &others) {
        drawing.lose(text!("import-other-mechanism", links));
        keep_links(drawing, &keep);
    }
}

/// For each link the first link of its mechanism.
fn parts(drawing: &Drawing) -> Vec<usize> {
    let mut parts: Vec<usize> = (0..drawing.links.len()).collect();
    let mut join = |one: usize, other: usize| {
        let (one, other) = (parts[one], parts[other]);
        for part in &mut parts {
            if *part == one.max(other) {
                *part = one.min(other);
            }
        }
    };
    let mut holder: Vec<Option<usize>> = vec![None; drawing.joints.len()];
    for (link, own) in drawing.links.iter().enumerate() {
        for joint in own.joints.iter().filter(|joint| !drawing.joints[**joint].is_grounded) {
            match holder[*joint] {
                Some(first) => join(first, link),
                None => holder[*joint] = Some(link),
            }
        }
    }
    for slide in &drawing.slides {
        slide.on.into_iter().for_each(|on| join(slide.link, on));
    }
    parts
}

/// Drives the first link that is pinned to the ground, where nothing else drives.
fn drive(drawing: &mut Drawing) {
    let pinned = |of: usize| {
        let joint = drawing.links[of].joints.iter().find(|joint| drawing.joints[**joint].is_grounded)?;
        Some(Driven::Pin { joint: *joint, of, on: None })
    };
    let crank = (0..drawing.links.len()).find_map(|of| pinned(of).map(|pair| (of, pair)));
    match crank {
        Some((of, pair)) => {
            drawing.lose(text!("import-no-input", link = name(drawing.links[of].name.clone())));
            drawing.inputs.push(Input { pair, rate: 0.0, travel: None });
        }
        None => drawing.lose(text!("import-no-crank")),
    }
}
